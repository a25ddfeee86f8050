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
from motionlang.commands.sweep import Sweep
from motionlang.kernel import Source, dialect

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


def results(executor: Executor | None, count: int = 60) -> list[Any]:
    sweep = Sweep(STROKE, {"rate": f"400:3000:{count // 3}", "length": [20, 50, 100]}, keep=KEEP)
    return sorted(sweep.results(executor, 1), key=lambda row: row[0])


def test_threads_give_what_one_after_the_other_gives() -> None:
    with ThreadPoolExecutor(3) as threads:
        assert results(threads) == results(None)


class Unreliable(Executor):
    """An executor that loses work, like a cluster with killed workers."""

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


@pytest.mark.slow
def test_processes_give_what_one_after_the_other_gives() -> None:
    """So many that the rest is worth other processes."""
    sweep = Sweep(STROKE, {"rate": "400:3000:800"}, keep=KEEP)
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

result = job.SweepWorker.result

def fatal(self, variant):
    if variant[0] == 30 and multiprocessing.parent_process() is not None:
        os.kill(os.getpid(), signal.SIGKILL)
    return result(self, variant)

job.SweepWorker.result = fatal
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


# A move of 40 at 100 uu/s², of 20 uu/s if the speed is not varied, and a wait of 2 * 50 ms.
NUMBERS = Source(
    "numbers.mnt",
    "SPEED(0) = 20\nACCEL(0) = 100 : DECEL(0) = 100\nMOVER(0) = 40 : GO(0) : PAUSE IDLE(0)\nWAIT = 2 * 50\n",
)


@pytest.mark.parametrize(
    ("address", "values", "times"),
    [
        ("SPEED[0]@1", [20.0, 10.0], [2.3, 4.2]),  # 0.2 s of ramps in addition to 40 / 20, 0.1 s to 40 / 10
        ("WAIT@4:1", [1.0, 3.0], [2.25, 2.35]),  # a part of a value
        ("WAIT@4:2", [10.0, 100.0], [2.22, 2.4]),
    ],
)
def test_a_number_of_the_program_is_varied(address: str, values: list[float], times: list[float]) -> None:
    rows = list(Sweep(NUMBERS, {address: values}, keep=["time"]).results(jobs=1))
    assert [kept[0] for _, kept, _ in rows] == pytest.approx(times, abs=1e-3)
    assert [problem for *_, problem in rows] == [None, None]


@pytest.mark.parametrize(
    ("text", "address", "values"),
    [
        ("For i = 1 To 3\nPRINT i : Next", "i@1:2", [2.0, 0.0, 4.5]),
        ("For i = 1 To 5 Step 1\nPRINT i : Next", "i@1:3", [2.0, -1.0]),
        ("Define n = 4\nPRINT n, 2 * n", "n@1", [5.0, 2.5]),
        ('n = 3\nIf n > 5 Then PRINT "more" Else PRINT "less"', "n@2", [2.0, 3.0]),
        ("SPEED(0) = 10 : JOG(0) = 10 : PAUSE POS(0) > 20 : PRINT TIME", "POS[0]@1", [10.0, 30.0]),
        ("n = -5 + 2 : PRINT n", "n@1:1", [-3.0, 7.0]),
        ("n = -5 : PRINT n", "n@1", [-3.0, 7.0]),
        ("n = 0xFFFFFFFF\nPRINT n", "n@1", [4294967290.0, 5.0]),
        ("Dim n As Integer\nn = 3 \\ 2 : PRINT n, 3 / 2", "n@2:1", [7.0, 7.9]),
    ],
)
def test_a_number_acts_as_if_it_were_in_the_text(text: str, address: str, values: list[float]) -> None:
    """The program is compiled once if the number can be bound at the start, and anew otherwise."""
    source = Source("a.mnt", text)
    (literal,) = (each for each in dialect("mint").program(source).literals if each.address == address)
    begin, end = literal.offset, literal.offset + len(literal.text)
    rows = list(motionlang.sweep(source, {address: values}, keep=["status", "time", "prints"], jobs=1))
    for row, value in zip(rows, values, strict=True):
        number = f"{value:.10g}"
        edited = motionlang.run(Source("a.mnt", text[:begin] + number + text[end:]))
        assert list(row.kept.values()) == [edited.status, edited.time, "\n".join(edited.output)]


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("Const k = 1\nFor i = 1 To 3 Step k\nNext", "k"),
        ("For i = 1 To 3 Step 1\nNext", "i@1:3"),
        ("Define k = 1\nFor i = 1 To 3 Step k * 2\nNext", "k@1"),
    ],
)
def test_a_loop_that_never_ends_is_an_error_of_its_variant(text: str, name: str) -> None:
    rows = motionlang.sweep(Source("a.mnt", text), {name: [1.0, 0.0]}, until=1.0, jobs=1)
    assert [row.problem and row.problem["message"] for row in rows] == [
        None,
        "a For that counts by 0 never ends",
    ]


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


MOVES = """
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
MOVER(0) = length : GO(0) : PAUSE IDLE(0)
PRINT "at ", POS(0), " of ", length
"""
# The source of a name's value, the name and its values.
CASES: dict[str, tuple[str, str, tuple[float | str, ...]]] = {
    "a constant": ("Const length = 30" + MOVES, "length", (12.0, 7.25)),
    "one with a type": ("Const length As Float = 30" + MOVES, "length", (12.0, 7.25)),
    "a whole one, cut off": ("Const length As Integer = 30" + MOVES, "LENGTH", (12.75, -7.25)),
    "constants made of it": (
        "Const pitch = 5\nConst turns As Integer = pitch * 2\nConst length = turns + pitch / 2" + MOVES,
        "pitch",
        (4.0, 2.5)),
    "a variable": ("Dim length As Float = 30" + MOVES, "length", (12.0, 7.25)),
    "a whole variable": ("Dim length As Integer\nlength = 3" + MOVES, "length", (12.0, 8.9)),
    "a name that nobody declares": ("length = 30" + MOVES, "length", (12.0, 7.25)),
    "a text": ('Const word = "one"\nPRINT word, Len(word)', "word", ("three", "")),
    "a loop": ("Const n As Integer = 3\nDim i\nFor i = 1 To n : PRINT i : Next", "n", (0.0, 5.0)),
    "an axis": ("Const x = 0\nMOVER(x) = 20 : GO(x) : PAUSE IDLE(x) : PRINT POS(x)", "x", (1.0, 3.0)),
    "a choice": ('Const n = 1\nSelect Case n\nCase 1 : PRINT "one"\nCase 2 To 4 : PRINT "some"\nEnd Select', "n",
                 (1.0, 3.0)),
    "a condition": ('Const n = 1\nIf n > 2 Then PRINT "many" Else PRINT "few"', "n", (1.0, 3.0)),
    "a name that a sub has too": (
        'Const n = 1\nConst m = n + 1\nSay()\nSub Say()\n Dim n = 9\n PRINT m, " ", n\nEnd Sub',
        "n",
        (4.0, 5.0)),
    "the size of an array": ("Const n = 4\nDim a(n) As Integer\na(n) = 7 : PRINT a(n)", "n", (2.0, 3.0)),
    "a number that is given as a text": ("Const n = 4\nPRINT n", "n", ("four", 5.0)),
    "what no float can hold": ("Const n = 4\nPRINT n", "n", (float("inf"), 5.0)),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_a_value_acts_as_if_it_were_in_the_text(case: str) -> None:
    """The program is compiled once if its name can be bound at the start, and anew otherwise."""
    program, name, values = CASES[case]
    source = Source("given.mnt", program)
    keep = ["status", "time", *(f"prints.{k}" for k in range(1, 6))]
    rows = list(motionlang.sweep(source, {name: [*values, *values]}, keep=keep, jobs=1))
    for row, value in zip(rows, (*values, *values), strict=True):
        alone = motionlang.run(source, overrides={name: value})
        assert alone.status == "ended", alone.diagnostics
        lines = [*alone.output[:5], *([None] * (5 - len(alone.output)))]
        assert list(row.kept.values()) == [alone.status, alone.time, *lines]


def test_two_names_of_which_one_decides_how_the_program_is_made() -> None:
    source = Source("two.mnt", "Const n = 4\nConst step = 2\nDim a(n)\na(n) = step : PRINT n, a(n)")
    points = [{"n": 2.0, "step": 1.0}, {"n": 3.0, "step": 5.5}, {"n": 2.0, "step": 7.0}]
    rows = motionlang.sweep(source, points, keep=["prints.1"], jobs=1)
    assert [row["prints.1"] for row in rows] == [
        motionlang.run(source, overrides=point).output[0] for point in points
    ]


def test_a_register_of_commands_is_varied() -> None:
    source = Source("r.mcl", "1MN\n1SV10,1SA100,1SD100\n1MR@5,1WS0\n1TP\n")
    rows = motionlang.sweep(source, {"R5": [3.0, 40.0, 3.0]}, keep=["prints.1"], jobs=1)
    assert [row["prints.1"] for row in rows] == ["01 3", "01 40", "01 3"]


def test_a_key_of_the_entries_of_a_channel_is_varied() -> None:
    """The moves take as long whatever the operator does; the run takes longer."""
    text = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nPAUSE INX(1)\nMOVER(0) = 100 : GO(0) : PAUSE IDLE(0)\n"
    machine = {
        "input": [{"channel": 1, "asked": 0.5}, {"channel": 1, "at": 9.0}, {"channel": 2, "asked": 0.1}]
    }
    source = Source("waits.mnt", text)
    found = list(motionlang.sweep(source, {"input.1.asked": [0.2, 0.7]}, machine=machine, jobs=1))
    assert [each["input.1.asked"] for each in found] == [0.2, 0.7]
    assert [each["time"] for each in found] == pytest.approx([1.3, 1.8], abs=1e-3)


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("input.1.for", r"no \[\[input\]\] of channel 1 in the machine file has for"),
        ("netdata.3.asked", r"no \[\[netdata\]\] of element 3 in the machine file has asked"),
        ("input.1.0.asked", "there is no key input.1.0.asked"),
    ],
)
def test_a_key_that_no_entry_has_is_rejected(name: str, why: str) -> None:
    machine = {"input": [{"channel": 1, "asked": 0.5}]}
    with pytest.raises(ValueError, match=why):
        motionlang.sweep(STROKE, {name: [0.2]}, machine=machine)


def test_points_without_the_names_of_the_first_are_rejected() -> None:
    with pytest.raises(ValueError, match=r"^point 1 differs in names from the first: n$"):
        motionlang.sweep(STROKE, [{"n": 1.0}, {"m": 1.0}])


def test_a_run_into_a_limit_is_not_good_in_python() -> None:
    """`run`, a row and `allow` go by the same function."""
    text = "Const v = 50\nSOFTLIMITFORWARD(0) = 80\nSPEED(0) = 100 : MOVER(0) = v : GO(0) : Pause IDLE(0)\n"
    far = [motionlang.run(Source("a.mnt", text), overrides={"v": v}).ok for v in (50, 90)]
    near = [
        [row.ok for row in motionlang.sweep(Source("a.mnt", text), {"v": [50, 90]}, jobs=1, allow=allow)]
        for allow in ((), ("soft-limit",))
    ]
    assert [far, *near] == [[True, False], [True, False], [True, True]]
    with pytest.raises(ValueError, match="choose from limit, soft-limit, following-error, fault or all"):
        motionlang.sweep(Source("a.mnt", text), {"v": [50]}, allow=("soft",))
