"""The log of a run."""

from __future__ import annotations

import subprocess
import sys
from itertools import pairwise
from math import fsum
from typing import Any

import pytest

from motionlang.kernel import Controller, Source, report, run
from motionlang.kernel.log import log as log_module
from motionlang.kernel.log import stream
from tests import proof

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


MEMORY = """import gc, tracemalloc
from motionlang.kernel import Source, run
text = '''Dim n As Integer
For n = 1 To {}
  MOVER(0) = 20 + n / 1000 : GO(0) : PAUSE IDLE(0)
  MOVEA(0) = n / 777 : GO(0) : PAUSE IDLE(0)
Next
'''
for count in (500, 500, 2000):
    gc.collect()
    tracemalloc.start()
    result = run(Source("shuttle.mnt", text.format(count)))
    gc.collect()
    print(len(result.controller.log.moves), tracemalloc.get_traced_memory()[0])
    tracemalloc.stop()
"""


@pytest.mark.slow
def test_a_move_takes_less_than_800_bytes() -> None:
    """With its wait and its profile, if no two are equal: of 4000 moves, 3000 more than of 1000.

    The run has its own process, since a proof takes memory, too.
    """
    ran = subprocess.run([sys.executable, "-c", MEMORY], capture_output=True, text=True, check=True)
    moves, used = zip(*(map(int, each.split()) for each in ran.stdout.splitlines()), strict=True)
    assert moves == (1000, 1000, 4000)
    assert used[2] - used[1] < 800 * 3000


@pytest.mark.parametrize(
    ("text", "rows"),
    [
        ("MOVER(0) = 20 : GO(0) : PAUSE IDLE(0)", {"moves": 109, "waits": 108}),
        ("OUT(0) = n Mod 2", {"outputs": 447}),
        ("JOG(0) = TIME + 1 : WAIT(20)", {"moves": 43, "waits": 42}),
    ],
)
def test_a_log_that_is_full_ends_the_run_and_keeps_what_is_there(
    text: str, rows: dict[str, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(stream, "MAX_MEMORY", 1e5)
    result = run(Source("shuttle.mnt", f"Dim n As Integer\nFor n = 1 To 10000\n  {text}\nNext\n"))
    assert result.status == "fault"
    assert [each.message for each in result.diagnostics] == ["the log of the run has reached 0.0001 GB"]
    assert {name: len(getattr(result.controller.log, name)) for name in rows} == rows
    assert report.text(result)


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
        log.check_hurry()
        controller.clock.advance(k * interval)
        controller.stop(0)
        controller.move_to(0, float(k), line=1 + k % lines)
    log.check_hurry()
    assert [each[:2] for each in reported] == found
    assert [span for *_, span in reported] == pytest.approx([7.0 * interval] * len(found))


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


def test_changes_for_the_host_and_in_other_devices_are_logged() -> None:
    text = """\
COMMS(3) = 2.5 : COMMS(3) = 2.5 : COMMSINTEGER(3) = 4
NETINTEGER(7) = 5
MODBUSTCP32(4, 6) = 70000 : MODBUSTCP16(4, 6) = 4464
REMOTEOUTX(1, 2, 3) = 1 : REMOTEDAC(1, 2, 5) = 2.5
"""
    log = run(Source("host.mnt", text), machine={"netdata": [{"element": 9, "value": 1}]}).machine.log
    assert [(each.target, each.value) for each in log.writes] == [
        ("comms element 3", 2.5),
        ("comms element 3", 4),
        ("network data 7", 5),
        ("Modbus register 6 of server 4", 70000),
        ("output 3 of node 2 of bus 1", 1),
        ("analogue output 5 of node 2 of bus 1", 2.5),
    ]
