"""Loops that only poll are skipped, with the same result as without skipping."""

from __future__ import annotations

from time import process_time

import pytest

from motionlang import run
from motionlang.mint import polling
from motionlang.source import Source

# A cost of which no period is a multiple: at a tie, rounding decides which statement still comes first.
COST = 0.7310585e-5

STATES = """\
Dim state As Integer, moves As Integer
SPEED(0) = 10 : ACCEL(0) = 100 : DECEL(0) = 100
TIME = 0
Loop
  Select Case state
  Case 0
    MOVER(0) = 100
    GO(0)
    state = 1
  Case 1
    If IDLE(0) Then state = 2 : TIME = 0 : PRINT "arrived ", POS(0)
  Case 2
    If TIME > 5000 Then
      state = 0
      moves = moves + 1
    End If
  End Select
  If moves = WANTED Then Exit Loop
End Loop
PRINT moves
"""
PROGRAMS = {
    "states": STATES.replace("WANTED", "2"),
    "while not idle": 'SPEED = 100 : MOVER = 5 : GO\nWhile Not IDLE\nEnd While\nPRINT TIME, " ", POS',
    "until there": 'SPEED = 100 : MOVER = 5 : GO\nRepeat\nUntil POS > 2\nPRINT TIME, " ", POS',
    "a timer's flag": "TIMEREVENT = 70\nWhile n < 3\nEnd While\nPRINT TIME, n\nEnd\n"
    "Event TIMER\n  n = n + 1\nEnd Event",
    "a counter that counts": "TIME = 0\nWhile TIME < 50\n  n = n + 1\nEnd While\nPRINT n",
    "two steps": "SPEED = 100 : MOVER = 5 : GO\nLoop\n  a = 1 - a\n  If IDLE Then Exit Loop\nEnd Loop\nPRINT a, TIME",
    "a level that moves": "SPEED = 100 : MOVER(0, 1) = 5, 9 : GO(0, 1)\nWhile POS(0) < POS(1) + 0.5\n"
    "  If IDLE(1) Then Exit While\nEnd While\nPRINT TIME",
    "a reading kept": 'SPEED = 100 : MOVER = 3 : GO\nRepeat\n  x = POS\nUntil IDLE\nPRINT x, " ", TIME',
    "both ends": "SPEED = 100 : MOVER = 5 : GO\nLoop\n  If POS > 1 And TIME > 20 Then Exit Loop\nEnd Loop\n"
    "PRINT TIME, POS",
    "another task": "Run Work\nWhile turns < 5\nEnd While\nPRINT TIME\nEnd\n"
    "Task Work\n  Loop\n    WAIT = 7\n    turns = turns + 1\n  End Loop\nEnd Task",
    "an empty loop under a timer": "TIMEREVENT = 70\nLoop\nEnd Loop\n"
    'Event TIMER\n  n = n + 1 : PRINT n, " ", TIME\n  If n = 9 Then End\nEnd Event',
    "a task that works": "Run Work\nWhile turns < 500\nEnd While\nPRINT TIME\nEnd\n"
    "Task Work\n  Loop\n    turns = turns + 1\n  End Loop\nEnd Task",
}


def outcome(text: str) -> tuple[list[str], float, list[float]]:
    machine = {"controller.instruction_time": COST}
    result = run(Source("a.mnt", text), machine=machine, cache=False, until=100.0)
    assert not result.diagnostics
    return result.output, result.time, [move.start_time for move in result.controller.moves]


@pytest.mark.parametrize("text", PROGRAMS.values(), ids=PROGRAMS.keys())
def test_skipping_makes_no_difference(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    text = "n = 0 : turns = 0\n" + text if "Task" in text or "Event" in text else text
    skipped = outcome(text)
    monkeypatch.setattr(polling, "watched", lambda *_: None)
    turn_by_turn = outcome(text)
    assert skipped[0] == turn_by_turn[0]
    assert skipped[1] == pytest.approx(turn_by_turn[1], abs=1e-7)
    assert skipped[2] == pytest.approx(turn_by_turn[2], abs=1e-7)


def test_eight_hours_of_polling_take_less_than_a_second() -> None:
    start = process_time()
    result = run(
        Source("a.mnt", STATES.replace("WANTED", "-1").replace(' : PRINT "arrived ", POS(0)', "")),
        cache=False,
    )
    assert process_time() - start < 1.0
    assert result.time > 28_000.0
    assert len(result.controller.moves) > 1900


def test_a_loop_that_looks_for_what_cannot_happen_is_told() -> None:
    result = run(
        Source("a.mnt", "Loop\n  If POS > 5 Then Exit Loop\nEnd Loop"), cache=False, until=float("inf")
    )
    (diagnostic,) = result.diagnostics
    assert diagnostic.code == "never"


@pytest.mark.parametrize("text", ["While 1\nEnd While", "Loop\nEnd Loop", "Dim x = 0\nRepeat\nUntil x = 1"])
def test_a_shift_of_nothing_is_over_at_once(text: str) -> None:
    start = process_time()
    result = run(Source("a.mnt", text), cache=False)
    assert process_time() - start < 1.0
    assert result.time == pytest.approx(28_800.0, abs=1e-3)
