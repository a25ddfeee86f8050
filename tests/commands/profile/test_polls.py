"""Equivalent waits: a polling loop is charged like a PAUSE, a computing one not."""

from __future__ import annotations

from math import fsum
from typing import Any

import pytest

from motionlang import profile, run
from motionlang.kernel import Run, Source
from tests.generated.compared import every_iteration

# 200 at 100 with 1000 either way takes 200 / 100 + 100 / 1000 = 2.1 s.
MOVE = "SPEED(0) = 100\nACCEL(0) = 1000\nDECEL(0) = 1000\nMOVER(0) = 200 : GO(0)\n"
TRAVEL = 2.1
# The lines from line 5 on, the line of the wait, and the longest time that the loop itself may add, s.
WAITS = {
    "PAUSE": ("PAUSE IDLE(0)", 5, 1e-4),
    "While": ("While Not IDLE(0)\n  n = n + 1\nEnd While", 5, 1e-4),
    "empty": ("While Not IDLE(0)\nEnd While", 5, 1e-4),
    "fraction": ("While Not IDLE(0)\n  x = x + 0.1\nEnd While", 5, 1e-4),
    "with a WAIT": ("While Not IDLE(0)\n  WAIT 5\nEnd While", 5, 6e-3),
    "with outputs": ("While Not IDLE(0)\n  n = n + 1\n  OUTX(1) = n Mod 2\nEnd While", 5, 1e-3),
    "Repeat": ("Repeat\n  n = n + 1\nUntil IDLE(0)", 5, 1e-4),
    "Loop": ("Loop\n  If IDLE(0) Then Exit\nEnd Loop", 5, 1e-4),
    "Goto": ("again:\n  n = n + 1\nIf Not IDLE(0) Then Goto again", 5, 1e-4),
    "Goto out": ("again:\nIf IDLE(0) Then Goto there\nGoto again\nthere:\nn = 1", 5, 1e-4),
    "For": ("For n = 1 To 1000000\n  If IDLE(0) Then Exit For\nNext", 5, 1e-4),
    "position": ("Repeat\nUntil POS(0) >= 200", 5, 1e-4),
    "speed": ("WAIT 1\nRepeat\nUntil VEL(0) = 0", 6, 2e-3),
    "variable": ("done = 0\nWhile done = 0\n  done = IDLE(0)\nEnd While", 6, 1e-4),
    "by an If": ("done = 0\nWhile done = 0\n  If IDLE(0) Then done = 1\nEnd While", 6, 1e-4),
    "function": (
        "While Ready() = 0\nEnd While\nEnd\n"
        "Function Ready() As Integer\n  Ready = IDLE(0)\nEnd Function",
        5,
        1e-4,
    ),
    "sub": ("Rest\nEnd\nSub Rest()\n  While Not IDLE(0)\n  End While\nEnd Sub", 8, 1e-4),
    "Return": ("Rest\nEnd\nSub Rest()\n  Loop\n    If IDLE(0) Then Return\n  End Loop\nEnd Sub", 8, 1e-4),
    "two conditions": ("While Not IDLE(0) And INX(2) = 0\nEnd While", 5, 1e-4),
    "a time beyond": ("While Not IDLE(0) And TIME < 9000\nEnd While", 5, 1e-4),
    "nested": ("While Not IDLE(0)\n  For n = 1 To 500\n  Next\nEnd While", 5, 2e-2),
}  # fmt: skip

# The time of a statement, s, where it is not the usual one: a loop that switches an output runs every iteration.
INSTRUCTION_TIMES = {"with outputs": 1e-4}


def machine_of(form: str) -> dict[str, object]:
    return {"controller.instruction_time": INSTRUCTION_TIMES.get(form, 1e-5)}


def ran(text: str, name: str = "poll.mnt", **options: object) -> Run:
    return run(Source(name, text), **options)  # type: ignore[arg-type]


def by_name(shares: Any) -> dict[str, float]:
    return {share.name: share.seconds for share in shares}


def checked(made: Any) -> Any:
    """Return a profile after checking that each of its sums is the time of its run."""
    for shares in (made.lines(), made.kinds(), made.subs()):
        assert fsum(share.seconds for share in shares) == pytest.approx(made.run.time, abs=1e-9)
    return made


def summed(made: Any) -> list[dict[str, Any]]:
    """Return the sums of a profile by line, cause, sub and line of waits, and the times of its tasks."""
    tasks = {each.name: (each.computing, each.ready, *each.waiting.values()) for each in made.tasks}
    return [by_name(each()) for each in (made.lines, made.kinds, made.subs, made.waited_lines)] + [tasks]


@pytest.mark.parametrize("form", WAITS)
def test_motion_is_charged_to_its_line_and_the_wait_to_that_of_the_loop(form: str) -> None:
    text, line, slack = WAITS[form]
    made = checked(profile(ran(MOVE + text + "\n", machine=machine_of(form))))
    kinds, lines = by_name(made.kinds()), by_name(made.lines())
    assert kinds["travel of axis 0"] == pytest.approx(TRAVEL, abs=1e-4 if form != "speed" else 2e-3)
    assert lines["4"] == pytest.approx(TRAVEL, abs=slack)
    assert by_name(made.waited_lines())[str(line)] == pytest.approx(TRAVEL, abs=slack)
    assert made.run.time == pytest.approx(TRAVEL, abs=slack)


@pytest.mark.parametrize("form", [each for each in WAITS if each != "PAUSE"])
def test_loops_that_are_skipped_are_charged_as_those_that_are_not(
    form: str,
) -> None:
    text = MOVE + WAITS[form][0] + "\n"
    skipped = profile(ran(text, machine=machine_of(form)))
    with every_iteration():
        plain = profile(ran(text, machine=machine_of(form)))
    assert summed(plain) == summed(skipped)


# Loops that never end, whose waits the run skips: the texts, and the time of each wait in an iteration, s.
ENDLESS = {
    "one wait": ("Loop\n  WAIT = 100\n  If INX(1) Then n = n + 1\nEnd Loop\n", "poll.mnt", {"2": 0.1}),
    "two waits": (
        "Loop\n  WAIT = 40\n  WAIT = 60\n  If INX(1) Then n = n + 1\nEnd Loop\n",
        "poll.mnt",
        {"2": 0.04, "3": 0.06},
    ),
    "MCCL": ("WA0.1,IS1,1MR10,NO,NO,RP\n", "poll.mcl", {"1": 0.1}),
    "MCCL, two waits": ("WA0.04,WA0.06,IS1,1MR10,NO,NO,RP\n", "poll.mcl", {"1": 0.1}),
}


@pytest.mark.parametrize(
    ("form", "until"),
    [*((form, 3.0) for form in ENDLESS), pytest.param("two waits", 12_000.0, marks=pytest.mark.slow)],
)
def test_the_waits_of_skipped_iterations_are_charged_to_their_lines(form: str, until: float) -> None:
    """An iteration takes 0.1 s and a few statements of 1e-9 s.

    12 000 s are 120 000 iterations, more than are listed one by one. The input could come on at 30 001 s.
    """
    text, name, lines = ENDLESS[form]
    machine = {"controller.instruction_time": 1e-9, "input": [{"channel": 1, "at": 30_001.0}]}
    made = checked(profile(ran(text, name, machine=machine, until=until)))
    assert by_name(made.kinds())["dwell"] == pytest.approx(until, rel=1e-6)
    waited = by_name(made.waited_lines())
    assert waited == pytest.approx({line: until * part / 0.1 for line, part in lines.items()}, rel=1e-6)


def test_the_waits_of_few_skipped_iterations_are_all_listed() -> None:
    """3 s of iterations of 0.1 s are 30 waits, skipped or not."""
    text, name, _ = ENDLESS["one wait"]
    machine = {"controller.instruction_time": 1e-9, "input": [{"channel": 1, "at": 30_001.0}]}
    waits = profile(ran(text, name, machine=machine, until=3.0)).waits()["ParentTask"]
    lengths = [wait.until - wait.since for wait in waits]
    assert lengths[:29] == pytest.approx([0.1] * 29, rel=1e-6)
    assert len(lengths) == 30


def test_a_task_that_waits_while_another_one_does_computes_nothing_meanwhile() -> None:
    """Iterations of the feeder, 0.1 s each, are skipped while the other task waits."""
    feeder = "Task Feeder\n  Loop\n    WAIT = 100\n    If INX(1) Then n = n + 1\n  End Loop\nEnd Task\n"
    text = f"Run Feeder\nWAIT = 900\nn = n + 1\nWAIT = 300\nEnd\n{feeder}"
    made = checked(profile(ran(text, machine={"controller.instruction_time": 1e-9})))
    times = {each.name: each for each in made.tasks}
    assert times["feeder"].computing == pytest.approx(0.0, abs=1e-6)
    assert times["feeder"].waiting == pytest.approx({"time": 1.2}, abs=1e-6)


# ------------------------------------------------------------------------------------------ what a loop waits for

# Channel 3 comes on at 3 s, channel 4 at 5 s.
WORLD = {"input": [{"channel": 3, "at": 3.0}, {"channel": 4, "at": 5.0}]}
# Line 1, its wait, and the end of that, s.
CAUSES = {
    "input": ("While INX(3) = 0\nEnd While", "waiting for an input", 3.0),
    "bank": ("Repeat\nUntil IN(0) And 8", "waiting for an input", 3.0),
    "both inputs": ("While INX(3) = 0 Or INX(4) = 0\nEnd While", "waiting for an input", 5.0),
    "either input": ("Repeat\n  WAIT 5\nUntil INX(3) Or INX(4)", "waiting for an input", 3.0),
    "time": ("While TIME < 4000\nEnd While", "dwell", 4.0),
    "time in steps": ("Repeat\n  WAIT 10\nUntil TIME >= 4000", "dwell", 4.0),
    "PAUSE for a time": ("PAUSE TIME >= 4000", "dwell", 4.0),
    "input or time": ("While INX(3) = 0 And TIME < 2000\nEnd While", "dwell", 2.0),
    "input before time": ("While INX(3) = 0 And TIME < 9000\nEnd While", "waiting for an input", 3.0),
    "PAUSE for either": ("PAUSE INX(3) Or TIME >= 9000", "waiting for an input", 3.0),
    "steps": ("For n = 1 To 1000\n  If INX(3) Then Exit For\n  WAIT 5\nNext", "waiting for an input", 3.0),
}  # fmt: skip


@pytest.mark.parametrize("form", CAUSES)
def test_a_loop_waits_for_what_ended_it(form: str) -> None:
    text, cause, time = CAUSES[form]
    made = checked(profile(ran(text + "\nEnd\n", machine=WORLD)))
    assert by_name(made.kinds())[cause] == pytest.approx(time, abs=11e-3 if "WAIT 10" in text else 2e-4)
    assert made.lines()[0].line == 1
    assert by_name(made.waited_lines())["1"] == pytest.approx(time, abs=11e-3)


def test_what_a_loop_needs_to_notice_is_its_own() -> None:
    """The motion ends at 2.1 s; the loop checks every 0.5 s, so it ends at 2.5 s.

    The remaining 0.4 s are charged to its WAIT.
    """
    made = checked(profile(ran(MOVE + "While Not IDLE(0)\n  WAIT 500\nEnd While\n")))
    assert by_name(made.kinds())["travel of axis 0"] == pytest.approx(2.1, abs=1e-4)
    assert by_name(made.lines())["6"] == pytest.approx(0.4, abs=1e-3)


def test_a_position_that_is_passed_is_waited_for_under_way() -> None:
    """At 100 uu/s and 1000 uu/s² the axis is at 55 after 0.6 s: 5 in 0.1 s, then 50.

    The move continues to its end.
    """
    made = checked(profile(ran(MOVE + "While POS(0) < 55\nEnd While\nWAIT 100\nCANCEL(0)\n")))
    lines = by_name(made.lines())
    assert lines["4"] == pytest.approx(0.6, abs=1e-3)
    assert lines["7"] == pytest.approx(0.1, abs=1e-3)


def test_a_loop_that_works_is_charged_by_what_it_does() -> None:
    """Three strokes of 0.2 s in a loop, each with a dwell of 50 ms and a poll.

    An input would end the loop.
    """
    text = (
        "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
        "While INX(7) = 0 And n < 3\n"
        "  MOVER(0) = 10 : GO(0)\n"
        "  While Not IDLE(0)\n  End While\n"
        "  OUTX(1) = 1\n  WAIT 50\n  OUTX(1) = 0\n"
        "  n = n + 1\n"
        "End While\n"
    )
    made = checked(profile(ran(text, machine=WORLD)))
    lines = by_name(made.lines())
    assert lines["3"] == pytest.approx(0.6, abs=1e-3)
    assert lines["7"] == pytest.approx(0.15, abs=1e-3)
    assert by_name(made.waited_lines()) == {
        "4": pytest.approx(0.6, abs=1e-3),
        "7": pytest.approx(0.15, abs=1e-3),
    }


def test_a_state_machine_waits_between_its_steps() -> None:
    """It waits for the input up to 3 s, then for a stroke of 1.1 s.

    Then it computes 2000 statements in a sub.
    """
    text = (
        "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
        "Loop\n"
        "  If state = 0 And INX(3) Then\n    MOVER(0) = 100 : GO(0) : state = 1\n  End If\n"
        "  If state = 1 And IDLE(0) Then\n    state = 2\n  End If\n"
        "  If state = 2 Then Finish\n"
        "End Loop\n"
        "Sub Finish()\n  For i = 1 To 1000\n  Next\n  End\nEnd Sub\n"
    )
    made = checked(profile(ran(text, machine=WORLD)))
    kinds = by_name(made.kinds())
    assert kinds["waiting for an input"] == pytest.approx(3.0, abs=1e-3)
    assert kinds["travel of axis 0"] == pytest.approx(1.1, abs=1e-3)
    assert by_name(made.waited_lines())["2"] == pytest.approx(4.1, abs=1e-3)
    # A For costs a statement to begin, and each Next one.
    assert by_name(made.subs())["Finish"] == pytest.approx(1000e-5, abs=5e-5)


def test_a_loop_does_not_wait_while_an_inner_one_does() -> None:
    """A move takes 3 / 50 + 50 / 500 = 0.16 s and is buffered every 0.15 s.

    So the last of five starts at 0.15 + 4 × 0.16 = 0.79 s, while the inner loop waits from 0.75 s to 0.9 s.
    """
    made = checked(
        profile(
            ran(
                "SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500\nLoop\n  t = TIME\n  While TIME - t < 150\n"
                "  End While\n  MOVER(0) = 3 : GO(0)\n  n = n + 1\n  If n > 5 Then Exit Loop\nEnd Loop\n"
            )
        )
    )
    (waits,) = made.waits().values()
    assert [wait.until for wait in waits] == pytest.approx([0.15 * n for n in range(1, 7)], abs=1e-3)


def test_a_run_that_is_cut_short_in_a_loop_waits_as_in_a_pause() -> None:
    for wait in ("PAUSE INX(7)", "While INX(7) = 0\nEnd While"):
        made = checked(profile(ran(f"WAIT(100)\n{wait}\n", until=2.0, machine=WORLD)))
        assert by_name(made.kinds())["waiting for a condition"] == pytest.approx(1.9, abs=1e-3)
        assert by_name(made.lines())["2"] == pytest.approx(1.9, abs=1e-3)


def test_tasks_that_poll_wait() -> None:
    """The parent waits for a variable that another task sets at 2.1 s, after a move.

    The times of each task add up to its duration.
    """
    text = (
        "Dim ready As Integer\nRun Feed\nWhile ready = 0\nEnd While\nEnd\n"
        "Task Feed\nSPEED(0) = 100\nACCEL(0) = 1000\nDECEL(0) = 1000\nMOVER(0) = 200 : GO(0)\n"
        "While Not IDLE(0)\nEnd While\nready = 1\nEnd Task\n"
    )
    made = checked(profile(ran(text)))
    assert by_name(made.kinds())["waiting for a task"] == pytest.approx(2.1, abs=2e-3)
    assert by_name(made.lines())["3"] == pytest.approx(2.1, abs=2e-3)
    parent, feed = made.tasks
    assert parent.waiting["task"] == pytest.approx(2.1, abs=5e-3)
    assert feed.waiting["axis 0"] == pytest.approx(2.1, abs=5e-3)
    for task in made.tasks:
        assert fsum((*task.waiting.values(), task.computing, task.ready)) == pytest.approx(
            task.life, abs=1e-9
        )
        assert min(task.computing, task.ready) > -1e-9


@pytest.mark.slow
def test_a_shift_of_polling_is_a_few_records() -> None:
    """Seven hours of polling an input are one loop in the log, and one wait."""
    world = {"input": [{"channel": 3, "at": 25_200.0}]}
    made = profile(ran("While INX(3) = 0\n  n = n + 1\n  WAIT 5\nEnd While\n", machine=world))
    assert len(made.run.machine.log.loops) == 1
    assert by_name(made.kinds())["waiting for an input"] == pytest.approx(25_200.0)


# ------------------------------------------------------------------------------------------------- loops that compute


def test_computing_before_a_wait_is_charged_to_its_own_line_and_sub() -> None:
    """A For of n iterations of k statements takes n (k + 1) + 1 statements of 10 us.

    This includes the For statement itself.
    """
    text = (
        "For i = 1 To 1000\n  x = x + i\nNext\n"
        "WAIT(50)\n"
        "Count 2000\n"
        "PAUSE INX(3)\nEnd\n"
        "Sub Count(ByVal most As Integer)\n  For j = 1 To most\n    y = y + j\n    z = y\n  Next\nEnd Sub\n"
    )
    made = checked(profile(ran(text, machine=WORLD)))
    lines, subs = made.lines(), by_name(made.subs())
    computing = {share.line: share.causes.get("computing", 0.0) for share in lines}
    assert computing[1] == pytest.approx(1000 * 2 * 1e-5, abs=5e-5)
    assert computing[9] == pytest.approx(2000 * 3 * 1e-5, abs=5e-5)
    assert computing.get(4, 0.0) + computing.get(6, 0.0) < 1e-4
    assert subs["Count"] == pytest.approx(2000 * 3 * 1e-5, abs=5e-5)
    (loop,) = [link for link in made.links if link.position.line == 9]
    assert (loop.cause, loop.position.sub, loop.position.callers) == ("computing", "Count", (5,))


def test_loops_in_loops_have_their_own_time() -> None:
    """The inner loop takes 200 x 2 statements or 4 ms per iteration, the rest 200 x 1."""
    text = (
        "For i = 1 To 10\n  For j = 1 To 200\n    x = x + j\n  Next\n"
        "  While k < 100 * i\n    k = k + 1\n  End While\nNext\n"
    )
    made = checked(profile(ran(text + "PAUSE INX(3)\n", machine=WORLD)))
    lines = {share.line: share.causes.get("computing", 0.0) for share in made.lines()}
    assert lines[2] == pytest.approx(10 * 200 * 2 * 1e-5, abs=1e-4)
    assert lines[5] == pytest.approx(10 * 100 * 2 * 1e-5, abs=1e-4)
    assert lines[1] < 1e-3


def test_a_sub_without_loops_has_what_it_computes() -> None:
    """Fib(12) is 465 calls of two statements each, an If and an assignment.

    The first line is charged the time before it.
    """
    text = (
        "x = 1\ny = Fib(12)\nPAUSE INX(3)\nEnd\nFunction Fib(ByVal n As Integer) As Integer\n"
        "  If n < 2 Then\n    Fib = n\n  Else\n    Fib = Fib(n - 1) + Fib(n - 2)\n  End If\nEnd Function\n"
    )
    made = checked(profile(ran(text, machine=WORLD)))
    assert by_name(made.subs())["Fib"] == pytest.approx(930e-5, abs=2e-5)
    computing = {share.line: share.causes.get("computing", 0.0) for share in made.lines()}
    assert computing[5] == pytest.approx(930e-5, abs=2e-5)
    assert computing.get(3, 0.0) < 2e-5


def test_a_loop_behind_a_sub_that_waits_has_its_own_time() -> None:
    """1 000 iterations of two statements take 20 ms; the sub's WAIT comes before them."""
    text = "Inner()\nFor i = 1 To 1000\n  x = x + i\nNext\nEnd\nSub Inner()\n  WAIT(5)\nEnd Sub\n"
    made = checked(profile(ran(text, machine=WORLD)))
    computing = {share.line: share.causes.get("computing", 0.0) for share in made.lines()}
    assert computing[2] == pytest.approx(20e-3, abs=3e-5)
    assert computing.get(7, 0.0) < 3e-5


# ------------------------------------------------------------------------------------------------------
# callers


def test_a_budget_and_the_waits_agree() -> None:
    text = "Wait = 50\n" + MOVE + "While Not IDLE(0)\n  n = n + 1\nEnd While\n"
    machine = {"budget.motion": 1.0, "budget.computing": 0.01, "budget.dwell": 0.06}
    result = ran(text, machine=machine)
    (over,) = result.diagnostics
    assert over.message.startswith("motion took 2.1 s, 1.1 s over the budget of 1 s")
    assert over.line == 5
    (wait,) = [wait for wait in profile(result).waits()["ParentTask"] if wait.cause != "time"]
    assert (wait.cause, wait.what, wait.why) == ("axis", (0,), "while Not IDLE(0)")


# ------------------------------------------------------------------------------------------------------------ MCCL

# 40000 counts at 10000 with 100000 either way take 40000 / 10000 + 10000 / 100000 = 4.1 s; channel 3 comes on at 6 s.
MCCL_MOVE = "1MN,1SV10000,1SA100000,1DS100000\n1MR40000\n"
MCCL_WORLD = {"input": [{"channel": 3, "at": 6.0}, {"channel": 4, "at": 7.0}]}
# The lines from line 3 on, the cause by kind, its line of the wait, and its duration, s.
MCCL_WAITS = {
    "WS": ("1WS", "travel of axis 1", 3, 4.1),
    "JR": ('LU"POSITION"\nAR10\n1RV@10,IB39999.9,JR-2,NO', "travel of axis 1", 5, 4.1),
    "WN": ("WN3", "waiting for an input", 3, 6.0),
    "IF RP": ("IF3,RP,NO", "waiting for an input", 3, 6.0),
    "WA IF RP": ("WA0.005,IF3,RP,NO", "waiting for an input", 3, 6.0),
    "JP": ("NO,IF3,JP1,NO", "waiting for an input", 3, 6.0),
    "macro": ("MD15,IF3,RP,NO\nMC15", "waiting for an input", 3, 6.0),
    "jump to itself": ("MD15,IF3,MJ15,NO\nMJ15", "waiting for an input", 3, 6.0),
}


@pytest.mark.parametrize("form", MCCL_WAITS)
def test_a_line_of_mccl_that_polls_waits(form: str) -> None:
    text, cause, line, time = MCCL_WAITS[form]
    made = checked(profile(ran(MCCL_MOVE + text + "\n", "poll.mcl", machine=MCCL_WORLD)))
    assert by_name(made.kinds())[cause] == pytest.approx(time, abs=2e-3)
    assert by_name(made.waited_lines())[str(line)] == pytest.approx(time, abs=6e-3)


def test_what_follows_a_loop_of_mccl_in_its_line_is_not_of_it() -> None:
    """IN3 is true at 6 s, then the same line dwells for half a second.

    The next line counts to 2000.
    """
    text = "IF3,JP0,NO,WA0.5\nAL0\nAA1,RP2000\n"
    made = checked(profile(ran(text, "poll.mcl", machine=MCCL_WORLD)))
    kinds = by_name(made.kinds())
    assert kinds["waiting for an input"] == pytest.approx(6.0, abs=1e-3)
    assert kinds["dwell"] == pytest.approx(0.5, abs=1e-6)
    # 2001 times AA1 and RP, each command of 10 us.
    assert by_name(made.lines())["3"] == pytest.approx(4002e-5, abs=1e-4)
