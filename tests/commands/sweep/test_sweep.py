"""Sweeps from Python: each variant runs once, with equal results on any executor."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, Executor, Future, ThreadPoolExecutor
from math import sqrt
from pathlib import Path
from typing import Any

import pytest

import motionlang
from motionlang.commands.processes.cores import cores
from motionlang.commands.quantities import quantity
from motionlang.commands.sweep import Sweep
from motionlang.commands.sweep import pool as pools
from motionlang.kernel import ProgramError, Source

STROKE = Source(
    "stroke.mnt",
    """
Const rate = 1000
Const length = 100
Dim room(4) As Integer
SPEED(0) = 200 : ACCEL(0) = rate : DECEL(0) = rate
MOVER(0) = length : GO(0) : PAUSE IDLE(0)
room(1 + rate / 1000) = 1
PRINT "there after ", TIME
""",
)
KEEP = (
    "time",
    "peak.0",
    "position.0",
    "accel.0",
    "jerk.0",
    "highest.0",
    "number.1",
    "prints.1",
    "moves",
    "status",
    "torque.0",
)


def stroke(length: float, rate: float) -> float:
    """Return the time of a move from rest to rest at 200 uu/s at most."""
    return length / 200 + 200 / rate if length >= 200**2 / rate else 2 * sqrt(length / rate)


def test_every_variant_is_a_run_and_its_figures_are_those_of_the_move() -> None:
    rows = list(motionlang.sweep(STROKE, {"rate": "500:2500:5", "length": [20, 100]}, keep=KEEP, jobs=1))
    assert [row.index for row in rows] == list(range(10))
    for row in rows:
        length, rate = row["length"], row["rate"]
        assert isinstance(length, int)
        assert isinstance(rate, int)
        assert row.ok
        assert row["time"] == pytest.approx(stroke(length, rate), abs=2e-4)
        assert row["peak.0"] == pytest.approx(min(200, sqrt(length * rate)))
        assert (row["accel.0"], row["jerk.0"]) == (pytest.approx(rate), float("inf"))
        assert (row["position.0"], row["highest.0"], row["moves"]) == (length, length, 1)
        assert row["prints.1"] == f"there after {row['number.1']:.0f}"
        assert (row["status"], row["torque.0"]) == ("ended", None)


def test_a_bad_variant_is_reported_as_by_a_run_and_the_others_go_on() -> None:
    rows = list(motionlang.sweep(STROKE, {"rate": [1000, 0, 4000, 2000]}, keep=["time", "status"], jobs=1))
    assert [row.ok for row in rows] == [True, False, False, True]
    for row, rate in ((rows[1], 0.0), (rows[2], 4000.0)):
        alone = motionlang.run(STROKE, overrides={"rate": rate}).diagnostics[0]
        assert row.problem is not None
        assert (row.problem["message"], row.problem["line"]) == (alone.message, alone.line)


@pytest.mark.parametrize(
    ("error", "code", "message"),
    [
        (RuntimeError("no such state"), "crash", "internal error: RuntimeError: no such state"),
        (ImportError("no numpy", name="numpy"), "extra", "this run needs numpy"),
    ],
)
def test_a_variant_that_brings_motionlang_down_is_reported_with_its_reason(
    error: Exception, code: str, message: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(*_: object) -> None:
        raise error

    monkeypatch.setattr("motionlang.kernel.lang.scheduler.Scheduler.run", fails)
    (row,) = motionlang.sweep(STROKE, {"rate": [1000]}, keep=["time"], jobs=1)
    assert row.problem is not None
    assert (row.problem["code"], row.problem["message"]) == (code, message)


def test_a_motor_that_had_no_time_has_turned_with_no_torque() -> None:
    plant = {
        "kind": "brushless",
        "resistance": 1.2,
        "inductance": 2e-3,
        "torque_constant": 0.06,
        "inertia": 3e-5,
    }
    machine = {f"axis.0.plant.{name}": value for name, value in plant.items()}
    source = Source("still.mnt", "Const length = 100\n")
    (row,) = motionlang.sweep(source, {"length": [1]}, machine=machine, keep=["rms_torque.0", "time"], jobs=1)
    assert (row["rms_torque.0"], row["time"]) == (0.0, 0.0)


def test_keys_of_the_machine_file_are_varied_too() -> None:
    rows = list(
        motionlang.sweep(
            STROKE,
            {
                "controller.instruction_time": [1e-5, 1e-3],
                "axis.0.travel": [[-5.0, 500.0], [-5.0, 50.0]],
                "controller.axes": [1],
            },
            keep=["time", "position.0"],
            jobs=1,
        )
    )
    assert rows[2]["time"] > rows[0]["time"]  # type: ignore[operator]
    assert [row["position.0"] == 100 for row in rows] == [True, False, True, False]


def test_what_is_wrong_with_all_variants_is_raised_before_any_runs() -> None:
    for grid, keep, message in (
        ({"ratte": [1]}, "time", "no constant or variable ratte; did you mean rate"),
        ({"axis.0.trawel": [1]}, "time", "there is no key axis.0.trawel; did you mean axis.N.travel"),
        ({"controller.axes": [-1]}, "time", "controller.axes must be 1 to 64"),
        ({"rate": [1]}, "tme", "a run has no tme; did you mean time"),
        ({"rate": [1]}, "peak", "a run has no peak; did you mean peak.N"),
    ):
        with pytest.raises(ValueError, match=message):
            motionlang.sweep(STROKE, grid, keep=[keep])
    with pytest.raises(ProgramError, match="unknown"):
        motionlang.sweep(Source("x.mnt", "Const a = 1\nPRINT b"), {"a": [1]})


def results(executor: Executor | None, count: int = 60) -> list[Any]:
    sweep = Sweep(STROKE, {"rate": f"400:3000:{count // 3}", "length": [20, 50, 100]}, keep=KEEP)
    return sorted(sweep.results(executor, 1), key=lambda row: row[0])


def test_threads_give_what_one_after_the_other_gives() -> None:
    with ThreadPoolExecutor(3) as threads:
        assert results(threads) == results(None)


class Unreliable(Executor):
    """An executor that loses work, like a cluster with killed workers.

    `loses` selects the chunks that are lost.
    """

    def __init__(self, loses: Callable[[int, list[int]], bool]) -> None:
        self.loses, self.count = loses, 0

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        self.count += 1
        if self.loses(self.count, [index for index, _ in args[1]]):
            future.set_exception(BrokenExecutor("a worker was killed"))
        else:
            future.set_result(fn(*args, **kwargs))
        return future


def test_chunks_that_are_lost_are_run_again() -> None:
    tried: list[list[int]] = []

    def loses(count: int, indices: list[int]) -> bool:
        tried.append(indices)
        return count % 3 == 2 and tried.count(indices) == 1

    assert results(Unreliable(loses)) == results(None)
    assert any(tried.count(each) == 2 for each in tried)


def test_only_the_chunk_that_ends_its_worker_twice_is_reported_as_lost() -> None:
    """The first chunks have four variants."""
    found, expected = results(Unreliable(lambda _, indices: 5 in indices)), results(None)
    assert [row[0] for row in found if row != expected[row[0]]] == [4, 5, 6, 7]
    assert "the worker was lost twice" in found[5][2]["message"]
    assert found[5][2]["code"] == "crash"


def test_an_executor_that_can_do_nothing_is_an_error_of_the_caller() -> None:
    with pytest.raises(BrokenExecutor):
        results(Unreliable(lambda *_: True))


def test_processes_give_what_one_after_the_other_gives(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pools, "ALONE", 0.0)
    monkeypatch.setattr(pools, "WORTH", 0.0)
    sweep = Sweep(STROKE, {"rate": "400:3000:40"}, keep=KEEP)
    rows = sweep.results(jobs=2)
    assert sorted(rows, key=lambda row: row[0]) == list(sweep.results(jobs=1))


@pytest.mark.long
def test_a_cluster_whose_workers_are_killed_gives_the_same_rows(tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    script = tmp_path / "cluster.py"
    script.write_text(CLUSTER)
    assert distributed
    root = Path(motionlang.__file__).parent.parent
    ran = subprocess.run(
        [sys.executable, str(script), str(root)], capture_output=True, text=True, check=False, timeout=300
    )
    assert ran.stdout == "as the local pool; 2 workers killed\n", ran.stderr[-2000:]


CLUSTER = """
import logging, os, pickle, signal, sys
sys.path.insert(0, sys.argv[1])
os.environ["PYTHONPATH"] = sys.argv[1]

def main():
    from dask.distributed import Client, LocalCluster
    from motionlang.kernel.source import Source
    from motionlang.commands.sweep import Sweep
    logging.disable(logging.CRITICAL)
    lines = ["Const rate = 1000", "SPEED(0) = 200 : ACCEL(0) = rate : DECEL(0) = rate", "Dim n"]
    lines += ["For n = 1 To 40 : MOVER(0) = 20 : GO(0) : PAUSE IDLE(0) : Next", "PRINT TIME"]
    source = Source("cluster.mnt", chr(10).join(lines))
    sweep = Sweep(source, {"rate": "400:3000:1500"}, keep=["time", "peak.0", "prints"])
    expected = sorted(sweep.results(jobs=2))
    with LocalCluster(n_workers=3, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        with Client(cluster) as client:
            pids = list(client.run(os.getpid).values())
            found = []
            for row in sweep.results(client.get_executor()):
                found.append(row)
                if len(found) in (100, 600):
                    os.kill(pids.pop(), signal.SIGKILL)
    assert pickle.dumps(sorted(found)) == pickle.dumps(expected), (len(found), len(expected))
    print("as the local pool; 2 workers killed")

if __name__ == "__main__":
    main()
"""


ENDS_ITS_PROCESS = """
import multiprocessing, os, signal
from motionlang.commands.sweep import Sweep, job, pool
from motionlang.kernel.source import Source

result = job.Worker.result

def fatal(self, variant):
    if variant[0] == 30 and multiprocessing.parent_process() is not None:
        os.kill(os.getpid(), signal.SIGKILL)
    return result(self, variant)

job.Worker.result = fatal
pool.ALONE = pool.WORTH = 0.0
if __name__ == "__main__":
    source = Source("a.mnt", "Const rate = 1000 : ACCEL(0) = rate : MOVER(0) = 20 : GO(0)")
    rows = sorted(Sweep(source, {"rate": "400:3000:80"}).results(jobs=2))
    lost = [row[0] for row in rows if row[2] is not None]
    print(len(rows), 30 in lost, lost == [*range(lost[0], lost[-1] + 1)], rows[30][2]["message"])
"""


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="a signal kills the process")
def test_a_killed_process_of_this_machine_costs_its_chunk(tmp_path: Path) -> None:
    script = tmp_path / "killed.py"
    script.write_text(ENDS_ITS_PROCESS)
    ran = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, check=False)
    assert ran.stdout.startswith("80 True True the worker was lost twice: BrokenProcessPool:"), ran.stderr


@pytest.mark.parametrize(
    ("affinity", "count", "expected"), [({0, 3, 5}, 8, 3), (None, 8, 8), (None, None, 1)]
)
def test_the_processors_of_this_process(
    affinity: set[int] | None, count: int | None, expected: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Some systems do not know which ones it may use, or how many there are."""
    monkeypatch.setattr(os, "sched_getaffinity", affinity and (lambda pid: affinity), raising=False)
    monkeypatch.setattr(os, "cpu_count", lambda: count)
    assert cores() == expected


@pytest.mark.parametrize(
    ("name", "number"), [("peak.0", 0), ("peak.7", 7), ("time", 0), ("peak.999999999", 999_999_999)]
)
def test_the_number_of_a_quantity(name: str, number: int) -> None:
    row, found = quantity(name)
    assert (row.name.partition(".")[0], found) == (name.partition(".")[0], number)


@pytest.mark.parametrize("name", ["peak", "time.1", "peak.", "peak.-1", "peak.1000000000", "peak.²", "pak.0"])
def test_what_is_no_quantity(name: str) -> None:
    with pytest.raises(ValueError, match=name.partition(".")[0]):
        quantity(name)


# A move of 40 at 100 uu/s², of 20 uu/s if the speed is not varied, and a wait of 2 * 50 ms.
NUMBERS = Source(
    "numbers.mnt",
    "SPEED(0) = 20\nACCEL(0) = 100 : DECEL(0) = 100\nMOVER(0) = 40 : GO(0) : PAUSE IDLE(0)\nWAIT = 2 * 50\n",
)


@pytest.mark.parametrize(
    ("address", "values", "times"),
    [
        ("SPEED[0]@1", [20.0, 10.0], [2.3, 4.2]),  # 0.2 s of ramps in addition to 40 / 20, 0.1 s to 40 / 10
        ("WAIT@4:1", [1.0, 3.0], [2.25, 2.35]),  # only a part of a value, which no constant can replace
        ("WAIT@4:2", [10.0, 100.0], [2.22, 2.4]),
    ],
)
def test_a_number_of_the_program_is_varied(address: str, values: list[float], times: list[float]) -> None:
    rows = list(Sweep(NUMBERS, {address: values}, keep=["time"]).results(jobs=1))
    assert [kept[0] for _, kept, _ in rows] == pytest.approx(times, abs=1e-3)
    assert [problem for *_, problem in rows] == [None, None]


def test_a_number_that_stops_the_program_is_reported_at_its_line() -> None:
    """A text is no number, and at a speed of 0 the wait of line 3 never ends."""
    rows = list(Sweep(NUMBERS, {"SPEED[0]@1": [20.0, 0.0, "fast"]}, keep=["status"]).results(jobs=1))
    assert [kept for _, kept, _ in rows] == [("ended",), ("fault",), (None,)]
    (_, _, none), (_, _, fault), (_, _, text) = rows
    assert none is None
    assert fault is not None
    assert (fault["code"], fault["line"]) == ("never", 3)
    assert text is not None
    assert text["message"] == "SPEED[0]@1 is a number, not 'fast'"
