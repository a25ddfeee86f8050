"""Skipping polling loops does not change the result."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.lang.machine.machine import Machine
from motionlang.mint.compile import polling
from motionlang.mint.runtime.environment import Environment
from motionlang.mint.runtime.loop_skipping import Site
from motionlang.mint.runtime.task import MintTask
from motionlang.result import Run
from motionlang.source import Source
from tests.cases import examples, one_in
from tests.counted_calls import count_calls
from tests.generated.tasks import every_iteration
from tests.mint.polling_programs import COST, keeping, program

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

# The world of the programs that are run both ways.
WORLD: dict[str, object] = {
    "controller.instruction_time": COST,
    "input": [{"channel": 0, "at": 0.35 + 1.3 * k, "for": 0.71} for k in range(8)],
    "encoder": [{"aux": 0, "velocity": 90.0, "accel": 50.0, "at": 0.2}, {"aux": 1, "velocity": -700.0}],
}
PROGRAMS |= {
    "until it stands": "SPEED = 50 : MOVER = 5 : GO\nRepeat : Until VEL = 0\nPRINT TIME, POS\n"
    "JERK = 40000 : MOVER = 5 : GO\nWhile VEL < 49.5 : End While\nPRINT TIME\nPROFILEMODE = 1 : MOVER = 9 : GO\n"
    "Repeat : Until VELDEMAND > 3.25\nPRINT TIME\nWhile VEL >= 50 Or POS < 15 : End While\nPRINT TIME, POS",
    "a long array among gotos": "Dim v(200) As Float, k As Integer\nMOVER = 30 : GO\nagain:\n"
    "If POS > 3 And k = 0 Then k = 1 : v(k) = TIME\nIf POS > 7 And k < 150 Then k = k + 1 : v(k) = POS\n"
    "If v(150) > 0 And OUTX(1) = 0 Then OUTX(1) = 1 : v(150) = TIME\nIf Not IDLE Then Goto again\n"
    "PRINT v(1), v(2), v(150), k, TIME",
    "an error that does not come": "JOG = 30\nLoop\n  If ABS(FOLERROR) > 5 Then STOP\n"
    "  If TIME > 300 Then Exit Loop\nEnd Loop\nSTOP",
    "a jog panel": "Loop\n  If INX(0) Then JOG(0) = 30 Else STOP(0)\n"
    "  If POS(0) > 60 Then Exit Loop\nEnd Loop\nPRINT TIME : STOP",
    "a stop of what is loaded": "MOVER = 5 : MOVER = 7 : GO\nLoop\n  If POS > 2 Then STOP\n  If IDLE Then Exit Loop\n"
    "End Loop\nPRINT TIME, POS, MOVEBUFFERFREE",
    "extremes, counters and a copy": "SPEED = 50 : JERK = 9000 : MOVER = 5 : MOVER = -8 : GO\n"
    "high = 1 : low = 1 : fast = 0 : slow = 0\nDim n As Integer, k As Integer, x As Float\nRepeat\n"
    "  If POS > high Then high = POS\n  If low >= POS Then low = POS\n  If VEL > fast Then fast = VEL\n"
    "  If VEL <= slow Then slow = VEL\n  n = n + 3\n  If POS > 2 Then k = k - 1 Else x = POS\nUntil IDLE\n"
    'PRINT high, " ", low, " ", fast, " ", slow, " ", n, " ", k, " ", x, " ", TIME',
    "a counter that is looked at": "Dim n As Integer, k As Integer\nMOVER = 30 : GO\nRepeat\n  n = n + 1\n"
    "  k = k + 2\nUntil n > 30000 Or IDLE\nPRINT n, k, TIME",
    "an extremum that is counted down": "Dim n As Float\nn = 50\nRepeat\n  If POS > n Then n = POS\n  n = n - 1\n"
    "Until TIME > 100\nPRINT n, TIME",
    "an extremum and a copy": "Dim n As Float\nSPEED(1) = 50 : MOVER(0, 1) = 5, 30 : GO(0, 1)\nn = 80\nRepeat\n"
    "  If POS(0) > n Then n = POS(0)\n  n = VEL(1)\nUntil IDLE(1)\nPRINT n, TIME",
    "an extremum that comes to rest": "Dim m As Float, k As Integer\nSPEED = 20 : MOVER = 8 : GO\nRepeat\n"
    "  If POS > m Then m = POS\n  k = k + 1\nUntil TIME > 900\nPRINT k, m, TIME",
    "the greatest time": "Dim m As Float, k As Integer\nRepeat\n  If TIME > m Then m = TIME\n  k = k + 1\n"
    "Until INX(0)\nPRINT k, m, TIME",
    "a counter that a Define looks at": "Dim n As Integer\nDefine enough = n > 500\nMOVER = 30 : GO\nRepeat\n"
    "  n = n + 1\nUntil enough Or IDLE\nPRINT n, TIME",
    "memory for a host": "Dim k As Integer\nMOVER = 30 : GO\nWhile Not IDLE\n"
    "  COMMS(1) = POS : COMMS(2) = VEL * 2 + k\nEnd While\nPRINT COMMS(1), COMMS(2)\nMOVER = 30 : GO\n"
    "Repeat\n  NETFLOAT(1) = POS\nUntil POS > 41 Or NETFLOAT(1) > 50\nPRINT NETFLOAT(1), TIME\n"
    "Repeat\n  NETFLOAT(1) = POS\nUntil HOLDINGREGISTER(2) > 900\nPRINT NETFLOAT(1), TIME",
    "memory that another task reads": "Run Show\nMOVER = 30 : GO\nPAUSE COMMS(1) > 9\nPRINT TIME\n"
    "While COMMS(1) < 22\n  WAIT = 3\nEnd While\nPRINT COMMS(1), TIME\nPAUSE IDLE\nPRINT COMMS(1)\nEnd\n"
    "Task Show\n  Loop\n    COMMS(1) = POS\n  End Loop\nEnd Task",
    "memory that an event reads": "TIMEREVENT = 70\nMOVER = 30 : GO\nWhile Not IDLE\n  COMMS(1) = POS\n"
    "End While\nEnd\nEvent TIMER\n  PRINT COMMS(1)\nEnd Event",
    "the distance from a target": "SPEED = 50 : MOVER = 5 : GO\nWhile ABS(POS - POSTARGET) > 1 : End While\n"
    "PRINT TIME, POS\nMOVER = 5 : GO\nRepeat : Until POSTARGETLAST - POS < 2\nPRINT TIME, POS\nt = TIME\n"
    "While 3 + TIME - t < 40 : End While\nWhile 5 > t - (60 - TIME) : End While\nPRINT TIME - t",
    "the target of a jog": "JOG = 30\nWhile POSTARGET < 4 : End While\nPRINT TIME, POS\nSTOP",
    "a counter that counts out": "Dim n As Integer, k As Integer\nMOVER = 30 : GO\nRepeat\n  n = n + 3\n"
    "  If n > 900 Then OUTX(1) = 1\n  If 30000 <= n Then k = TIME\n  If n = 60000 Then STOP\nUntil IDLE\n"
    "PRINT n, k, TIME",
    "a counter that goes to and fro": "Dim n As Integer, k As Integer\nMOVER = 30 : GO\nRepeat\n  n = n + 3\n"
    "  If n > 900 Then k = 1\n  n = n - 2\nUntil k Or IDLE\nPRINT n, k, TIME",
    "a counter that counts down to a level": "Dim n As Integer\nn = 5000\nMOVER = 30 : GO\nWhile n > 0 And Not IDLE\n"
    "  n = n - 1\nEnd While\nPRINT n, TIME",
    "a display": 'Run Show\nMOVER = 30 : GO\nWhile Not IDLE\n  LINE 1, "moving" : LINE 2, "to ", POSTARGET\n'
    '  If POS > 12 Then LINE 1, "far" Else LINE 3, INX(0)\nEnd While\nLINE 1, "there"\nPRINT TIME\nEnd\n'
    "Task Show\n  Loop\n    LINE 4, INX(1) USING 3;\n    If INX(0) Then PRINT TIME : WAIT = 90\n  End Loop\n"
    "End Task",
    "displays in subs": "Dim k As Integer\nTERMINAL = 3\nMOVER = 30 : GO\nWhile Not IDLE\n  Show\nEnd While\n"
    "Repeat\n  LINE 5, k\n  k = k + 1\nUntil k = 40\nPRINT TIME\nEnd\n"
    'Sub Show\n  LINE 1, "moving"\n  LINE 2, INX(0)\nEnd Sub',
    "encoders": "Dim s As Integer\nLoop\n  If s = 0 And AUXENCODER(0) > 30 Then s = 1 : PRINT TIME\n"
    "  If s = 1 And AUXENCODER(1) <= -1000 Then s = 2 : PRINT TIME : AUXENCODERWRAP(0) = 40\n"
    "  If s = 2 And AUXENCODER(0) < 10 Then Exit Loop\nEnd Loop\nPRINT TIME, AUXENCODER(0)",
}


# Loops that wait for ever, in all styles of programs.
TASKS = """\
Run First
Run Second
Loop
  If INX(1) Then OUTX(1) = 1
End Loop
Task First
  Loop
    If INX(2) Then
      OUTX(2) = 1
      seen = 1
    End If
  End Loop
End Task
Task Second
  While INX(3) = 0
  End While
End Task
"""
FOR_EVER = {
    "while": "While 1\nEnd While",
    "loop": "Loop\nEnd Loop",
    "repeat": "Dim x = 0\nRepeat\nUntil x = 1",
    "goto": "again:\nIF INX(0) = 0 THEN GOTO again",
    "a machine of gotos": "again:\nIF s = 0 AND INX(1) THEN GOTO first\nIF s = 1 THEN GOTO second\nGOTO again\n"
    "first:\ns = 1\nGOTO again\nsecond:\nOUTX(1) = 1\nGOTO again",
    "a goto beside a long array": "Dim v(200) As Float\nv(3) = 2\nagain:\nIf INX(1) Then v(4) = 1\nGoto again",
    "an output follows an input": "Loop\n  OUTX(1) = INX(3)\nEnd Loop",
    "the same value": "While 1\n  x = 5\nEnd While",
    "memory for a host": "Loop\n  COMMS(1) = POS(0)\n  COMMS(2) = INX(1)\nEnd Loop",
    "a jog panel": "Loop\n  If INX(1) Then JOG(0) = 10 Else JOG(0) = 0\nEnd Loop",
    "a timer of its own": "Dim since As Time, state As Integer\nLoop\n  Select Case state\n  Case 0\n"
    "    If INX(1) Then since = 0 : state = 1\n  Case 1\n    If since > 500 Then state = 0\n  End Select\nEnd Loop",
    "what other states look at": "Loop\n  If INX(1) Then\n    COMMS(1) = TIME\n    COMMS(2) = POS(0)\n"
    "  End If\nEnd Loop",
    "a jog that goes on": "Loop\n  JOG(0) = 10\n  SPEED(1) = 20\nEnd Loop",
    "a display": 'Loop\n  If INX(1) Then LINE 1, "door" Else LINE 1, "closed"\n  LINE 2, POS(0);\nEnd Loop',
    "a display now and then": 'Loop\n  LINE 1, "ready"\n  WAIT = 10\nEnd Loop',
    "a speed": "Loop\n  SPEED(0) = 50 + 10 * INX(1)\nEnd Loop",
    "subs": "Dim seen As Integer\nLoop\n  Look\n  OUTX(1) = seen\nEnd Loop\n"
    "Sub Look()\n  If INX(1) Then seen = 1\nEnd Sub",
    "gosubs": "Loop\n  GOSUB look\n  GOSUB set\nEnd Loop\n"
    "#look\n  seen = INX(1)\nRETURN\n#set\n  OUTX(1) = seen\nRETURN",
    "an array": "Dim v(8) As Integer\nLoop\n  For i = 1 To 8\n    v(i) = INX(i - 1)\n  Next\nEnd Loop",
    "a wait": "Loop\n  WAIT = 10\n  If INX(1) Then OUTX(2) = 1\nEnd Loop",
    "a parent beside a task that waits": "Run Work\nLoop\nEnd Loop\nTask Work\n  PAUSE INX(1)\nEnd Task",
    "tasks that wait": "Run Ten\nRun Hundred\nLoop\n  WAIT = 10\n  If INX(1) Then OUTX(1) = 1\nEnd Loop\n"
    "Task Ten\n  Loop\n    WAIT = 10\n    If INX(2) Then OUTX(2) = 1\n  End Loop\nEnd Task\n"
    "Task Hundred\n  Loop\n    WAIT = 100\n    If INX(3) Then OUTX(3) = 1\n  End Loop\nEnd Task",
    "a task that waits beside one that does not": "Run Ten\nLoop\n  If INX(1) Then OUTX(1) = 1\nEnd Loop\n"
    "Task Ten\n  Loop\n    WAIT = 10\n    If INX(2) Then OUTX(2) = 1\n  End Loop\nEnd Task",
    "tasks side by side": "seen = 0\n" + TASKS,
}


def outcome(text: str, machine: dict[str, object] | None = None, until: float = 100.0) -> list[object]:
    """Return a program's output, diagnostics, end time and moves."""
    machine = machine or {"controller.instruction_time": COST}
    result = run(Source("a.mnt", text), machine=machine, cache=False, until=until)
    starts = [move.start_time for move in result.controller.log.moves]
    wrong = [each.message for each in result.diagnostics]
    return [result.output, wrong, result.status, result.time, *starts]


def stepwise(monkeypatch: pytest.MonkeyPatch) -> None:
    """Disable skipping from now on."""
    monkeypatch.setattr(polling, "left_behind", lambda *_: None)


@pytest.mark.parametrize("text", PROGRAMS.values(), ids=PROGRAMS.keys())
def test_skipping_makes_no_difference(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    text = "n = 0 : turns = 0\n" + text if "Task" in text or "Event" in text else text
    skipped = outcome(text, WORLD)
    stepwise(monkeypatch)
    assert skipped == outcome(text, WORLD)
    assert skipped[2] == "ended"


MOTOR: dict[str, object] = {
    "controller.instruction_time": COST,
    "axis.0.plant.inertia": 2e-5,
    "axis.0.plant.coulomb": 0.01,
}
_STARTS = (
    "n = 0\nSPEED = 20000 : ACCEL = 100000 : DECEL = 100000 : KPROP = 1 : KDERIV = 5 : MOVER = 4000 : GO\n"
)
WITH_A_MOTOR = {
    "errors that come": "Loop\n  If ABS(FOLERROR) > 133 And n = 0 Then n = 1 : PRINT TIME, FOLERROR\n"
    "  If FOLERROR < -2 And n < 2 Then n = 2 : PRINT TIME, POS\n  If TIME > 400 Then Exit Loop\nEnd Loop",
    "an error of nothing": "While FOLERROR <= 0 : End While\nPRINT TIME, FOLERROR",
    "the greatest error": "Dim e As Float, k As Integer\nRepeat\n  If FOLERROR > e Then e = FOLERROR\n"
    "  k = k + 1\nUntil IDLE\nPRINT e, k, TIME",
    "sizes": "Repeat : Until ABS(POS) > 2000\nPRINT POS, TIME\nPAUSE IDLE\nMOVER = -9000 : GO\nPAUSE POS < 0\n"
    "While ABS(POS) < 2000 : End While\nPRINT POS, TIME\nRepeat : Until ABS(VELDEMAND) < 4000.5\nPRINT POS, TIME",
}


@pytest.mark.parametrize("quantised", [False, True])
@pytest.mark.parametrize("name", WITH_A_MOTOR)
def test_skipping_makes_no_difference_to_a_motor(
    name: str, quantised: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    machine = MOTOR | {"axis.0.plant.quantised": quantised}
    skipped = outcome(_STARTS + WITH_A_MOTOR[name], machine, until=3.0)
    assert skipped[0]
    stepwise(monkeypatch)
    assert skipped == outcome(_STARTS + WITH_A_MOTOR[name], machine, until=3.0)


def test_an_error_of_a_motor_is_solved_with_or_without_its_sign(monkeypatch: pytest.MonkeyPatch) -> None:
    text = _STARTS + "Repeat\nUntil ABS(FOLERROR) > 5000 Or FOLERROR > 6000 Or IDLE"
    checked = count_calls(monkeypatch, (Site, "check"))
    result = run(Source("a.mnt", text), machine=MOTOR, cache=False)
    assert result.time > 0.2
    assert checked.calls <= 6


@pytest.mark.parametrize("seed", one_in(4, range(24)))
def test_skipping_makes_no_difference_to_random_programs(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    text, machine = program(seed)
    skipped = outcome(text, machine, until=3.0)
    stepwise(monkeypatch)
    assert skipped == outcome(text, machine, until=3.0)


@pytest.mark.long
@pytest.mark.parametrize("first", range(24, 1024, 50))
def test_skipping_makes_no_difference_at_length(first: int, monkeypatch: pytest.MonkeyPatch) -> None:
    programs = [program(seed) for seed in range(first, first + 50)]
    skipped = [outcome(text, machine, until=3.0) for text, machine in programs]
    stepwise(monkeypatch)
    assert skipped == [outcome(text, machine, until=3.0) for text, machine in programs]


@pytest.mark.parametrize("seed", one_in(3, range(24)))
def test_skipping_preserves_the_variables_of_a_loop(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    skipped = outcome(keeping(seed), WORLD, until=2.0)
    stepwise(monkeypatch)
    assert skipped == outcome(keeping(seed), WORLD, until=2.0)


@pytest.mark.long
@pytest.mark.parametrize("first", range(24, 824, 100))
def test_skipping_preserves_the_variables_of_loops(first: int, monkeypatch: pytest.MonkeyPatch) -> None:
    programs = [keeping(seed) for seed in range(first, first + 100)]
    skipped = [outcome(text, WORLD, until=2.0) for text in programs]
    stepwise(monkeypatch)
    assert skipped == [outcome(text, WORLD, until=2.0) for text in programs]


def test_an_input_that_nobody_reads_changes_nothing() -> None:
    """An input that no loop reads changes nothing, with one task or with several."""
    cost: dict[str, object] = {"controller.instruction_time": COST}
    programs = [(PROGRAMS[name], cost) for name in ("states", "two steps", "both ends")]
    for text, machine in programs + [program(seed) for seed in range(100, 100 + examples(30))]:
        inputs = [{"channel": 7, "at": 0.00123 * count, "for": 0.0004} for count in range(1, 200)]
        driven = machine | {"input": [*machine.get("input", ()), *inputs]}  # type: ignore[misc]
        assert outcome(text, driven, until=1.0) == outcome(text, machine, until=1.0), text


def test_a_time_is_that_of_the_number_of_statements() -> None:
    """The time is the number of statements times the duration of one.

    A running sum of the durations of 300 000 statements would have another last digit.
    """
    text = "n = 0\nWhile n < 100000\n  n = n + 1\n  If n < 0 Then Exit While\nEnd While"
    result = run(Source("a.mnt", text), machine={"controller.instruction_time": COST}, cache=False)
    assert result.time == round(result.time / COST) * COST
    assert result.time > 300_000 * COST


def effort(text: str, monkeypatch: pytest.MonkeyPatch) -> tuple[Run, int]:
    """Return a run of eight hours, and how often it resumed or checked a task."""
    efforts = count_calls(monkeypatch, (MintTask, "resume"), (Site, "skip"))
    result = run(Source("a.mnt", text), cache=False)
    return result, efforts.calls


def test_a_state_machine_polls_for_eight_hours_at_the_price_of_its_moves(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    text = STATES.replace("WANTED", "-1").replace(' : PRINT "arrived ", POS(0)', "")
    result, count = effort(text, monkeypatch)
    assert result.time > 28_000.0
    moves = len(result.controller.log.moves)
    assert moves > 1900
    assert count < 5 * moves


# Each waits for 400 s: an iteration of the counter takes 20 µs, and a ramp of 0.1 s delays the move by half of it.
SHIFTED = {
    "a time-out": "t = TIME\nWhile TIME - t < 400000 : End While",
    "a time-out among others": "t = TIME\nRepeat : Until INX(5) Or 400000 <= TIME + 3 - (t + 3)",
    "a distance": "SPEED = 1 : ACCEL = 10 : DECEL = 10 : MOVER = 500 : GO\n"
    "While ABS(POS - POSTARGET) > 100.05 : End While",
    "memory for a host": "SPEED = 1 : ACCEL = 10 : DECEL = 10 : MOVER = 500 : GO\n"
    "While POS < 399.95 : COMMS(1) = POS + 1 : End While",
    "a counter": "Dim n As Integer\nWhile n < 20000000 : n = n + 1 : End While",
    "a copy of a reading": "Dim x As Float\nSPEED = 1 : ACCEL = 10 : DECEL = 10 : MOVER = 500 : GO\n"
    "While POS < 399.95 : x = POS : End While",
    "the highest reading": "Dim x As Float\nSPEED = 1 : ACCEL = 10 : DECEL = 10 : MOVER = 500 : GO\n"
    "While POS < 399.95\nIf POS > x Then x = POS\nEnd While",
}


@pytest.mark.parametrize("name", SHIFTED)
@pytest.mark.slow
def test_sums_counters_copies_and_host_memory_cost_no_more_than_a_reading(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    result, count = effort(f"{SHIFTED[name]}\nPRINT TIME\nCANCEL(0)", monkeypatch)
    assert float(result.output[0]) == pytest.approx(400_000, abs=1)
    assert count <= 4


@pytest.mark.parametrize(
    "loop", ["If INX(5) Then STOP(0)", "If VEL(0) > 0 Then OUTX(1) = 1 Else OUTX(1) = 0"]
)
def test_a_task_beside_one_that_waits_polls_up_to_the_next_event_at_once(
    loop: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """For each move both run once, and the task once more, for a part of an iteration."""
    text = "Dim n As Integer\nRun Watch\nSPEED(0) = 100 : ACCEL(0) = 500 : DECEL(0) = 500\nFor n = 1 To 100\n"
    text += "  MOVER(0) = 100 : GO(0) : PAUSE IDLE(0)\nNext\nEnd\n"
    result, count = effort(f"{text}Task Watch\n  Loop\n    {loop}\n  End Loop\nEnd Task", monkeypatch)
    assert result.time == pytest.approx(120.0, abs=0.01)
    assert count <= 4 * 100 + 2


# What a task does before its loop and in it, and what the parent waits for.
AWAITED = {
    "an output": ("", "OUTX(3) = 1", "OUTX(3)"),
    "an output wired to an input": ("", "OUTX(3) = 1", "INX(9)"),
    "a variable": ("", "flag = 1", "flag = 1"),
    "a variable before the loop": ("flag = 1", "If INX(5) Then STOP(0)", "flag = 1"),
    "an output before the loop": ("OUTX(3) = 1", "If INX(5) Then STOP(0)", "OUTX(3)"),
    "memory": ("", "COMMS(1) = 5", "COMMS(1) = 5"),
    "a setting": ("", "SPEED(0) = 7", "SPEED(0) = 7"),
    "motion": ("", "If INX(9) = 0 Then JOG(0) = 5 : OUTX(3) = 1", "VEL(0) > 0"),
}


@pytest.mark.parametrize("name", AWAITED)
def test_what_a_task_does_before_it_only_polls_ends_the_wait_of_another_in_time(name: str) -> None:
    """The task begins at 350 ms; the parent goes on after its time slice of 1 ms."""
    before, act, awaited = AWAITED[name]
    text = "Dim flag As Integer\nSPEED(0) = 5 : ACCEL(0) = 5000 : DECEL(0) = 5000\nRun Act\n"
    text += f"PAUSE {awaited}\nPRINT TIME\nEnd\n"
    text += f"Task Act\n  PAUSE INX(0)\n  {before}\n  Loop\n    {act}\n  End Loop\nEnd Task"
    inputs = [{"channel": 0, "at": 0.35}, {"channel": 1, "at": 5.0}, {"channel": 9, "output": 3}]
    result = run(Source("a.mnt", text), machine={"input": inputs}, cache=False, until=9.0)
    assert result.output == ["351"]


# How often a task is resumed or checked, if that is more than three times.
MOST = {
    "a parent beside a task that waits": 13,
    "a task that waits beside one that does not": 37,
    "tasks side by side": 21,
    "tasks that wait": 1360,
}


@pytest.mark.parametrize("name", FOR_EVER)
def test_eight_hours_of_nothing_are_over_at_once(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    result, count = effort(FOR_EVER[name], monkeypatch)
    assert not result.diagnostics
    assert result.time == pytest.approx(28_800.0, abs=0.05)
    assert count <= MOST.get(name, 3)


@pytest.mark.parametrize(
    "text",
    [
        "Loop\n  If POS > 5 Then Exit Loop\nEnd Loop",
        "Run Work\nWhile INX(1) = 0\nEnd While\nTask Work\n  While INX(2) = 0\n    WAIT = 10\n  End While\nEnd Task",
    ],
)
def test_loop_that_polls_for_the_impossible_is_reported(text: str) -> None:
    result = run(Source("a.mnt", text), cache=False, until=float("inf"))
    (diagnostic,) = result.diagnostics
    assert diagnostic.code == "never"


IN_VAIN = "which could no longer change"


def test_what_a_task_still_polled_for_at_the_end_is_no_figure_of_the_run() -> None:
    result = run(
        Source(
            "a.mnt",
            "ACCEL = 9 : DECEL = 9 : SPEED = 100 : MOVER = 5 : GO\nPAUSE IDLE\nWhile INX(3) = 0\nEnd While",
        ),
        cache=False,
    )
    assert result.notes == [f"line 3: ParentTask still polled INX(3), {IN_VAIN}"]
    result = run(Source("a.mnt", "seen = 0\n" + TASKS), cache=False)
    assert [each.partition(", which")[0] for each in result.notes] == [
        "line 4: ParentTask still polled INX(1)",
        "line 8: first still polled INX(2)",
        "line 16: second still polled INX(3)",
    ]


LAMPS = """
SPEED(0) = 100 : ACCEL(0) = 500 : DECEL(0) = 500
Run A
Run B
MOVEA(0) = 100 : GO(0)
While INX(5) = 0
End While
End
Task A
Loop
  OUTX(9) = INX(3)
  WAIT({})
End Loop
End Task
Task B
Loop
  If ABS(VEL(0)) > 10 Then OUTX(8) = 1 Else OUTX(8) = 0
  WAIT({})
End Loop
End Task
"""
FOLLOWER = """
MASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0 : FOLLOW(1) = 0.5
SPEED(0) = 100
Run Lamp
MOVEA(0) = 100 : GO(0)
While Not IDLE(1)
End While
MOVEA(0) = 0 : GO(0)
End
Task Lamp
  PAUSE POS(0) > 17
  PAUSE POS(0) < 13
End Task
"""


@pytest.mark.parametrize(
    ("text", "notes"),
    [
        (
            FOLLOWER,
            [
                f"line 6: ParentTask still polled IDLE(1), {IN_VAIN}",
                "line 12: lamp still waited until POS(0) < 13, since 0.171 s",
            ],
        ),
        # Each iteration is interrupted by the other task.
        (
            "Run T\nWhile INX(5) = 0\nWAIT(5)\nEnd While\nEnd\nTask T\nWhile INX(6) = 0\nWAIT(7)\nEnd While\nEnd Task",
            [
                f"line 3: ParentTask still polled INX(5), {IN_VAIN}",
                f"line 8: t still polled INX(6), {IN_VAIN}",
            ],
        ),
        # Writes that change nothing, also in iterations that are not checked or that others are skipped in.
        *[
            (
                LAMPS.format(*waits),
                [
                    f"line 6: ParentTask still polled INX(5), {IN_VAIN}",
                    f"line 12: a still polled INX(3), {IN_VAIN}",
                    f"line 18: b still polled VEL(0), {IN_VAIN}",
                ],
            )
            for waits in [(5, 4), (3, 0), (3, 4)]
        ],
        # A task that counts may end by itself, and what takes more than 30 ms is a display.
        ("Run Other\nWhile INX(5) = 0\nEnd While\nEnd\nTask Other\nLoop\nn = n + 1\nEnd Loop\nEnd Task", []),
        ("Loop\nIf INX(5) Then OUTX(1) = 1\nWAIT(31)\nEnd Loop", []),
    ],
)
@pytest.mark.parametrize("fast", [True, False])
def test_what_is_polled_in_vain_does_not_depend_on_accelerators(
    text: str, notes: list[str], fast: bool
) -> None:
    found = run(Source("a.mnt", text), cache=False, until=2.345, fast=fast).notes
    assert [each for each in found if each.startswith("line ")] == notes


def test_parent_that_leaves_the_work_to_its_tasks_polls_nothing() -> None:
    text = "Run Work\nLoop\nEnd Loop\nTask Work\n  Loop\n    WAIT = 5000\n  End Loop\nEnd Task"
    assert run(Source("a.mnt", text), cache=False).notes == []


READS_MOVING_VALUES = {
    "a display": "x = POS(0)\n  COMMS(1) = x",
    "a peak": "v = VEL(0)\n  If v > peak Then peak = v",
    "a cam switch": "x = POS(0)\n  If x > 5 And x < 10 Then OUTX(1) = 1 Else OUTX(1) = 0",
    "a clock": "r = TIME Mod 100\n  If r > 50 Then k = 1 Else k = 0",
}


@pytest.mark.parametrize("body", READS_MOVING_VALUES.values(), ids=READS_MOVING_VALUES.keys())
def test_loop_that_reads_moving_values_runs_unchecked(body: str, monkeypatch: pytest.MonkeyPatch) -> None:
    text = "Dim x As Float, v As Float, peak As Float, r As Integer, k As Integer\n"
    text += "SPEED(0) = 10 : MOVER(0) = 30 : GO(0)\n"
    text += f"While Not IDLE(0)\n  {body}\nEnd While"
    checks, check = 0, Site.check

    def counted(*arguments: object) -> object:
        nonlocal checks
        checks += 1
        return check(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(Site, "check", counted)
    result = run(Source("a.mnt", text), cache=False)
    turns = result.time / 50e-6
    assert turns > 50_000
    assert checks < turns / 50


def test_loop_is_checked_at_once_if_statements_count_from_another_time() -> None:
    """The back-off is up to a statement's number, which is invalid after a wait."""
    environment = Environment(Machine())
    site = Site(environment, True, False, False)
    looked_at = site.check_at(7.0, 1e9, None, (), ())
    assert looked_at[3] == site.due == 7.0
    environment.statements.start(3.6)
    assert site.due == 0.0


def test_a_loop_that_was_interrupted_by_a_handler_that_waits_is_skipped_on() -> None:
    text = "Loop\n  If INX(1) Then OUTX(1) = 1\nEnd Loop\nEvent IN2\n  WAIT(5)\nEnd Event\n"
    hours = [{"channel": 2, "at": 3600.0 * hour, "for": 1.0} for hour in (1, 3, 6)]
    result = run(Source("a.mnt", text), machine={"input": hours}, cache=False)
    assert [round(wait.until, 3) for wait in result.machine.log.waits] == [3600.005, 10800.005, 21600.005]
    assert round(result.time, 3) == 8 * 3600.0


def test_a_loop_within_one_that_is_left_alone_is_not_skipped_too_far() -> None:
    """In its back-off, the inner loop records no dependencies.

    What it reads meanwhile must prevent the outer loop from being skipped.
    """
    text = """\
Dim k As Integer, n As Integer
SPEED(0) = 10 : MOVER(0) = 30 : GO(0)
Repeat
  For k = 1 To 3
    If POS(0) * 1 > 20 Then n = 1
  Next
  k = 0
  Repeat
    k = k + 1
    If POS(0) * 1 > 20 Then n = 1
  Until k = 5
Until n
PRINT POS(0)
"""
    result = run(Source("a.mnt", text), cache=False)
    assert float(result.output[0]) == pytest.approx(20.0, abs=0.01)


def test_level_is_evaluated_once_before_or_after_the_reading() -> None:
    text = """\
Dim calls As Integer
SPEED(0) = 10 : MOVER(0) = 5 : GO(0)
Repeat
Until Level(2) < POS(0)
PRINT POS(0) > 1.5 + 0.4, " ", 1.5 + 0.4 > POS(0)
Function Level(ByVal x As Float) As Float
  calls = calls + 1
  Level = x
End Function
"""
    result = run(Source("a.mnt", text), cache=False)
    assert result.output == ["1 0"]


def test_a_task_that_only_counts_costs_nothing_while_it_is_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """An iteration takes 20 µs, so a second has 50 000 of them."""
    calls = 0
    check = Site.check

    def counted(self: Site, *given: object) -> object:
        nonlocal calls
        calls += 1
        return check(self, *given)  # type: ignore[arg-type]

    monkeypatch.setattr(Site, "check", counted)
    text = "Run T1\nWAIT(1000)\nPRINT TIME\nEnd\nTask T1\nLoop\n  n = n + 1\nEnd Loop\nEnd Task\n"
    assert run(Source("a.mnt", text), cache=False, fast=True).machine.terminal.lines == ["1000"]
    assert calls <= 5


READY_AS_A_WAIT_ENDS = """\
Dim k As Integer, done As Integer, i As Integer
Run Other
TASKPRIORITY(ParentTask) = 2
While done = 0
  WAIT(0.5)
End While
PRINT TIME
End
Task Other
  For i = 1 To 4
    WAIT(2.3)
    k = 0
    While k < 20
      k = k + 1
    End While
  Next
  done = 1
End Task
"""


def test_a_task_that_is_ready_as_a_wait_ends_runs_in_the_next_one() -> None:
    """Both WAITs end at once, and the task of higher priority polls."""
    machine: dict[str, object] = {"controller.instruction_time": 1e-4}
    found = [
        run(Source("a.mnt", READY_AS_A_WAIT_ENDS), machine=machine, cache=False, fast=fast)
        for fast in (False, True)
    ]
    with every_iteration():
        executed = run(Source("a.mnt", READY_AS_A_WAIT_ENDS), machine=machine, cache=False, fast=False)
    assert [each.output for each in found] == [executed.output] * 2
