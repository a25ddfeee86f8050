"""The log of a run: packing makes it small and does not change its contents."""

from __future__ import annotations

import gc
import subprocess
import sys
from itertools import pairwise
from math import fsum
from pathlib import Path
from typing import Any

import pytest

from motionlang.kernel import Controller, Rejected, Run, Source, WholeTrack, report, run
from motionlang.kernel.controller.joined import Followed
from motionlang.kernel.log import Log, LoggedMove, Store, stream
from motionlang.kernel.log import log as log_module
from tests import proof
from tests.kernel.log.small import shrink

SCRIPTS = Path(__file__).parents[3] / "scripts"
SHUTTLE = """
Dim n As Integer
SPEED(0) = 100 : ACCEL(0) = 500 : DECEL(0) = 500
For n = 1 To 500
  MOVER(0) = 20
  GO(0)
  PAUSE IDLE(0)
  OUT(0) = 1 - OUT(0)
  MOVEA(0) = 0
  GO(0)
  PAUSE IDLE(0)
  WAIT(100)
Next
Print "done"
"""


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Make a log pack at once, with almost all of its data on disk."""
    shrink(monkeypatch)


STREAMS = [
    "moves",
    "dropped",
    "waits",
    "slices",
    "outputs",
    "inputs",
    "analogue_outputs",
    "analogue_inputs",
    "settings",
    "events",
    "prints",
]
STILL = """
import motionlang
from motionlang.kernel.source import Source
for source in (Source("a.mnt", "Dim n As Integer"), Source("a.mcl", "CN0\\n")):
    log = motionlang.run(source).machine.log
    streams = (log.moves, log.dropped, log.waits, log.slices, log.events, log.outputs)
    print([(len(each), list(each), each[:], list(reversed(each)), bool(each)) for each in streams])
"""


def test_every_stream_of_a_run_without_motion_reads_as_a_list() -> None:
    """The run has its own process: a proved run, as in this suite, has a controller."""
    ran = subprocess.run([sys.executable, "-c", STILL], capture_output=True, text=True, check=False)
    assert ran.stdout == f"{[(0, [], [], [], False)] * 6}\n" * 2, ran.stderr


def gallery() -> list[str]:
    """Return every tenth program of the gallery."""
    return [str(path) for path in sorted(SCRIPTS.rglob("*")) if path.suffix in (".mcl", ".mnt")][::10]


def figures(result: Run) -> tuple[str, object]:
    rows = result.trace.sample(100.0).data if result.time < 600.0 else ()
    return report.text(result), [column.tolist() for column in rows]


def test_packed_or_not_a_run_reads_the_same(request: pytest.FixtureRequest) -> None:
    whole = {name: figures(run(name)) for name in gallery()}
    request.getfixturevalue("small")
    packed = 0
    for name, expected in whole.items():
        result = run(name)
        assert figures(result) == expected, name
        packed += result.controller.log.store.size > 0
    assert packed > len(whole) // 2


def living_moves() -> list[LoggedMove]:
    """Return every Move object that exists in the process."""
    gc.collect()
    return [each for each in gc.get_objects() if type(each) is LoggedMove]


@pytest.mark.slow
def test_a_move_takes_at_most_450_bytes_and_none_stays_an_object(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(log_module, "MAX_PROFILES", 500)
    monkeypatch.setattr(log_module, "LEFT_PROFILES", 10)
    monkeypatch.setattr(stream, "CHUNK", 200)
    before = living_moves()  # of runs that earlier tests keep
    result = run(Source("shuttle.mnt", SHUTTLE))
    log = result.controller.log
    assert len(log.moves) == 1000
    assert log.moves.packed > 700
    assert log.store.size / log.moves.packed <= 450
    assert log.room + sum(len(a.starts) for a in result.controller.axes.values()) == 500
    assert len(living_moves()) - len(before) < 300
    assert {move.line for move in log.moves} == {5, 9}
    assert log.moves[700].profile is not None
    assert log.moves[700].profile.distance == 20.0


FOLLOWED = """
Dim n As Integer
SPEED(0) = 10000 : ACCEL(0) = 500000 : DECEL(0) = 500000
For n = 1 To 30
  MOVER(0) = 300 : GO(0) : PAUSE IDLE(0)
  If n = 7 Then TORQUE(0) = 5 : WAIT(9) : CANCEL(0)
  MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)
  If n % 5 = 0 Then POS(0) = 40
  PRINT TIME, " ", POS(0), " ", FOLERROR(0)
Next
"""


def test_what_a_motor_follows_is_packed_and_followed_all_the_same(request: pytest.FixtureRequest) -> None:
    """Readings, report and trace of a motor are equal with packing and without.

    The program redefines positions and opens loops.
    """
    machine = {"axis.0.plant.load_inertia": 4e-5, "axis.0.plant.load_torque": 0.002}
    source = Source("followed.mnt", FOLLOWED)
    expected = figures(run(source, machine=machine))
    request.getfixturevalue("small")
    result = run(source, machine=machine)
    a = result.controller.axes[0]
    assert a.older is not None
    assert a.older.count > 80
    assert len(a.starts) < 30
    assert figures(result) == expected


def test_what_a_program_waited_for_is_in_the_log() -> None:
    log = run(Source("shuttle.mnt", SHUTTLE)).controller.log
    waits = list(log.waits)
    assert len(waits) == 1500
    assert [each.cause for each in waits[:3]] == ["condition", "condition", "time"]
    assert waits[2].until - waits[2].since == pytest.approx(0.1, abs=1e-9)
    moving = log.moves[0]
    assert moving.profile is not None
    assert waits[0].until == pytest.approx(moving.start_time + moving.profile.duration)
    assert [each.text for each in log.prints] == ["done"]
    assert [change.value for change in log.outputs][:3] == [1, 0, 1]


def test_the_slices_of_tasks_add_up() -> None:
    program = """Dim n As Integer
Run Counting
For n = 1 To 5000 : Next
Wait(100)
End
Task Counting
  Dim k As Integer
  For k = 1 To 5000 : Next
End Task
"""
    slices = list(run(Source("two.mnt", program)).controller.log.slices)
    assert [each.tasks for each in slices] == [(), ("ParentTask", "counting"), ("counting",)]
    for each in slices[1:]:
        assert fsum(each.seconds) == pytest.approx(each.until - each.time)


@pytest.mark.slow
@pytest.mark.usefixtures("small")
def test_a_track_is_read_as_one_list() -> None:
    axis = run(Source("shuttle.mnt", SHUTTLE)).controller.axes[0]
    track = WholeTrack(axis)
    starts, profiles = list(track.starts), list(track.profiles)
    assert len(starts) == len(track.starts) == 2001
    assert starts == sorted(starts)
    for i in (0, 1, 500, 1999, 2000):
        assert (track.starts[i], track.profiles[i].end) == (starts[i], profiles[i].end)
        assert track.index_at(starts[i]) == i
    assert axis.position(0.5 * (starts[1] + starts[2])) == pytest.approx(
        profiles[1].position(0.5 * (starts[2] - starts[1]))
    )


def test_play_is_taken_up_by_motion_that_is_packed_too(request: pytest.FixtureRequest) -> None:
    """600 moves of 0.01 at 1000/s² are 3.79 s of motion.

    A backlash of 2 that takes 20 s of motion is taken up by 0.379 in that time.
    """
    program = """Dim n As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
BACKLASH(0) = 2 : BACKLASHINTERVAL(0) = 20000 : BACKLASHMODE(0) = 1
For n = 1 To 600
  MOVER(0) = 0.01 : GO(0)
  PAUSE IDLE(0)
Next
PRINT ENCODER(0) - POS(0)
"""
    whole = run(Source("play.mnt", program))
    request.getfixturevalue("small")
    packed = run(Source("play.mnt", program))
    assert (whole.controller.axes[0].older is None, packed.controller.axes[0].older is None) == (True, False)
    assert packed.output == whole.output
    assert float(packed.output[0]) == pytest.approx(2.0 * 600 * 2.0 * (0.01 / 1000.0) ** 0.5 / 20.0, rel=1e-4)


def test_a_log_that_is_full_ends_the_run_and_keeps_what_is_there(small: None) -> None:
    controller = Controller(log=Log(disk=2000))

    def toggle() -> None:
        for k in range(10_000):
            controller.set_output(0, k % 2 + 1)

    with pytest.raises(Rejected, match="the log of the run has reached"):
        toggle()
    assert 40 < len(controller.log.outputs) < 10_000
    assert [change.value for change in controller.log.outputs][:2] == [1, 2]


def test_a_move_that_is_changed_without_end_is_many_entries_and_one_motion() -> None:
    program = """Dim n As Integer
FEEDRATEMODE(0) = 2 : SPEED(0) = 100 : ACCEL(0) = 1000
MOVER(0) = 1000
GO(0)
For n = 1 To 1200
  FEEDRATE(0) = 50 + (n Mod 7)
  WAIT(2)
Next
STOP(0)
"""
    result = proof.run(Source("live.mnt", program))
    rows: list[dict[str, Any]] = list(report.moves(result))
    first, last = rows[0], rows[-1]
    assert [row.get("ended") for row in rows] == ["continued"] * (len(rows) - 1) + ["stop"]
    assert 2 <= len(rows) <= 5
    assert {(row["line"], row["command"]) for row in rows} == {(first["line"], first["command"])}
    for before, after in pairwise(rows):
        assert after["start"] == before["end"]
        assert after["start_time"] == pytest.approx(before["start_time"] + before["duration"])
    assert last["end"] == pytest.approx(result.controller.axes[0].position(result.time))
    assert proof.prove(result).holds


def test_a_setting_is_in_the_log_where_it_changes() -> None:
    program = "SPEED(0) = 50\nSPEED(0) = 50\nJOG(0) = 20\nWAIT(100)\nACCEL(0) = 900\nSPEED(1) = 60\n"
    log = run(Source("set.mnt", program), until=1.0).controller.log
    found = [(each.axis, each.name, each.value) for each in log.settings if each.time > 0.0]
    assert found == [(0, "accel", 900.0), (1, "speed", 60.0)]
    assert [each.value for each in log.settings if each.name == "speed" and not each.axis] == [50.0]


def test_a_wait_says_what_kind_of_thing_ended_it() -> None:
    mccl = "1MN,1MR1000,1WS0.1,WN3,WA0.5,1MA0,1WP500,1WT\n"
    world = {"input": [{"channel": 3, "at": 2.0}]}
    log = run(Source("waits.mcl", mccl), machine=world).controller.log
    assert [(each.cause, each.what) for each in log.waits] == [
        ("axis", (1,)),
        ("time", ()),
        ("input", (3,)),
        ("time", ()),
        ("axis", (1,)),
        ("axis", (1,)),
    ]


@pytest.mark.usefixtures("small")
def test_a_slice_of_a_packed_track_is_its_profiles_one_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """The result does not depend on packing, on the number of chunks, or on caching."""
    plant = {"axis.0.plant.load_inertia": 4e-5}
    a = run(Source("followed.mnt", FOLLOWED), machine=plant).controller.axes[0]
    assert a.older is not None
    assert a.older.count > 80
    count = len(Followed(a).starts)
    one_by_one = [(start, repr(Followed(a).profiles[k])) for k, start in enumerate(Followed(a).starts)]
    for most in 1024, 7, 3:
        monkeypatch.setattr("motionlang.kernel.controller.joined._MAX_CACHED", most)
        track = Followed(a)
        for first in range(0, count + 1, 7):
            for past in (first, first + 1, first + 5, a.older.count, a.older.count + 1, count):
                starts, profiles = track.starts[first:past], track.profiles[first:past]
                found = [(start, repr(each)) for start, each in zip(starts, profiles, strict=True)]
                assert found == one_by_one[first:past]
        assert track.starts[count:0:-3] == [start for start, _ in one_by_one[count:0:-3]]


@pytest.mark.parametrize(
    ("interval", "lines", "found"),
    [
        (4.9e-4, 4, [(7, 8)]),
        (5.8e-4, 4, []),  # 7 intervals of it are 4.06 ms, more than 8 of 0.5 ms
        (5.7e-4, 4, [(7, 8)]),
        (4.9e-4, 5, []),
    ],
)
def test_a_loop_that_starts_motion_after_motion_is_reported_by_its_last_move(
    interval: float, lines: int, found: list[tuple[int, int]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """It starts more than one in half a millisecond, from up to four lines.

    The number of moves is at least half of 16.
    """
    monkeypatch.setattr(log_module, "FIRST_CHECK", 16)
    controller = Controller(1)
    log, reported = controller.log, list[tuple[int, int, float]]()
    log.hurried = lambda move, count, span: reported.append((round(move.target), count, span))
    for k in range(8):
        log._check_hurry()
        controller.clock.advance(k * interval)
        controller.stop(0)
        controller.move_to(0, float(k), line=1 + k % lines)
    log._check_hurry()
    assert [each[:2] for each in reported] == found
    assert [span for *_, span in reported] == pytest.approx([7.0 * interval] * len(found))


def test_a_log_has_the_bytes_that_fit_into_its_file() -> None:
    """Of 100 bytes, 60 and 40 fit; one more ends the run."""
    store = Store(memory=0, disk=100)
    first, second = store.put(60 * b"a"), store.put(40 * b"b")
    assert (store.get(first), store.get(second), store.size) == (60 * b"a", 40 * b"b", 100)
    with pytest.raises(Rejected, match="the log of the run has reached 1e-07 GB"):
        store.put(b"c")


def test_the_calls_that_lead_to_an_act_are_stored_once() -> None:
    text = (
        "Dim n As Integer\nFor n = 1 To 50\n  goX(10)\n  goX(0)\nNext\nEnd\n"
        "Sub goX(ByVal x As Float)\n  MOVEA(0) = x : GO(0) : PAUSE IDLE(0)\n"
        '  OUTX(1) = 1 : OUTX(1) = 0\n  Print "there"\nEnd Sub\n'
    )
    made = run(Source("calls.mnt", text))
    log, line = made.machine.log, made.program.structure.line  # type: ignore[union-attr]
    assert [[line(at) for at in calls] for calls in log.callers] == [[], [3], [4]]
    for acts in (log.moves, log.prints):
        assert [each.chain for each in acts] == [1, 2] * 50
    assert [each.chain for each in log.outputs] == [1, 1, 2, 2] * 50
