"""Random programs whose tasks poll while a TIMER interrupts them.

Each runs with identical iterations skipped and with none skipped. The reports and the records of the log must be
equal, except records of waits and time slices. Half of the programs come from `tasks.py`, with a timer added.

`python -m tests.generated.polls 3000 --seed 1` compares that many programs and prints the seeds of those that
differ.
"""

from __future__ import annotations

import sys
from random import Random

from tests.generated import handlers, tasks
from tests.generated.compared import compare, is_equal_without_skipping

COSTS = (1e-5, 1e-5, 0.7310585e-5, 4e-5)
PERIODS = (1, 1, 1, 2, 5, 7, 10, 33)

_HEAD = """\
Dim a As Integer, b As Integer, c As Integer, x As Float
Dim ticks As Integer, other As Integer, turns As Integer
SPEED(0, 1) = 50; : ACCEL(0, 1) = 500; : DECEL(0, 1) = 500;
"""
_STEPS = (
    "ticks = ticks + 1", "ticks = ticks + 1", "ticks = ticks + 1", "other = other - 3", "OUTX(3) = Not OUTX(3)",
    "OUTX(4) = 1", "OUTX(4) = 1 : OUTX(4) = 0", "a = 1 - a", "If INX(1) Then b = b + 1",
    "If ticks >= 40 Then ticks = 0", "If ticks > 90 Then STOP(0)", "If ticks = 25 Then c = 1",
    "If POS(0) > 6 Then OUTX(5) = 1 Else OUTX(5) = 0", "x = POS(0)", "If VEL(0) = 0 Then other = 0",
    "local = local + 1",
    "If ticks Mod 50 = 0 Then OUTX(6) = Not OUTX(6)", "If TIME > 500 Then b = 2",
)  # fmt: skip
_POLLS = (
    "", "", "If INX(2) Then STOP(0)", "k@ = k@ + 1", "OUTX(1) = VEL(0) > 0",
    "If POS(0) > 5 Then OUTX(2) = 1 Else OUTX(2) = 0",
    "x = POS(0)", "OUTX(1) = INX(0)", "If a Then OUTX(1) = 1 Else OUTX(1) = 0", "If ticks > 30 Then c = 2",
    "k@ = 1 - k@", "c = 0", "If INX(0) Then b = 1\n    If INX(1) Then b = 0", "WAIT(1)", "WAIT(3)", "Nothing",
    "k@ = k@ + 1 : If k@ > 200 Then k@ = 0", "COMMS(1) = 4", "c = other",
    "k@ = k@ + 1 : If k@ > 70 Then OUTX(6) = 1", "k@ = k@ + 2\n    WAIT(5)", "WAIT(10)", "WAIT(5)", "WAIT(0.3)",
    "WAIT(wait@)", "If IDLE(0, 1) Then c = 3", "If AXISMODE(0) = 0 Then b = 3", "STOP(1)",
    "If VEL(0) > 20 Then OUTX(7) = 1 Else OUTX(7) = 0", "If OUT(0) And 8 Then c = 4",
)  # fmt: skip
_MAIN = (
    "MOVER(0) = 9 : GO(0)\n  While Not IDLE(0)\n    @@\n  End While",
    "MOVER(0) = -9 : GO(0)\n  Repeat\n    @@\n  Until IDLE(0)",
    "t = TIME\n  While TIME - t < 150\n    @@\n  End While",
    "WAIT(60)",
    "MOVER(0) = 5 : GO(0) : PAUSE IDLE(0)",
    "PAUSE INX(1) Or TIME > 400",
    'PRINT ticks, " ", a, b, c, " ", other',
    "ticks = 0",
    "MOVER(1) = 3 : GO(1)",
    "MOVER(0) = 30 : GO(0)\n  While Not IDLE(0)\n    @@\n  End While",
    "MOVER(0) = -25 : GO(0)\n  While Not IDLE(0)\n    n = n + 1\n    WAIT(5)\n  End While\n  PRINT n",
)
# Bodies of the loops of tasks, in addition to those of `_POLLS`.
_BEATS = (
    "OUTX(7) = 1 : WAIT(20) : OUTX(7) = 0 : WAIT(20)", "WAIT(30) : OUTX(7) = Not OUTX(7)",
    "If VEL(0) > 0 Then OUTX(2) = 1 Else OUTX(2) = 0\n    WAIT(10)", "If INX(2) Then STOP(0)\n    WAIT(7)",
)  # fmt: skip


def program(seed: int) -> tuple[str, dict[str, object]]:
    """Return a program and its machine."""
    random = Random(seed)
    if random.random() < 0.5:
        return _with_timer(random, seed)
    count = random.choice((0, 1, 1, 2, 3))
    lines = [_HEAD, *(f"Run T{k}" for k in range(1, count + 1))]
    lines += [f"TIMEREVENT = {random.choice(PERIODS)}", "Loop"]
    lines += [
        f"  {random.choice(_MAIN)}".replace("@@", _poll(random, 0)) for _ in range(random.randint(1, 3))
    ]
    # What is known can be used again after an event if the time does not decide.
    end = random.choice(("If TIME > 900 Then Exit Loop", "turns = turns + 1\n  If turns > 5 Then Exit Loop"))
    lines += [f"  {end}", "End Loop", 'PRINT "end ", TIME, ticks, a, b, c, x', "End"]
    for k in range(1, count + 1):
        body = random.choice(_BEATS) if random.random() < 0.3 else _poll(random, k)
        lines += [
            f"Task T{k}\n  wait{k} = {random.choice((1, 2, 5))}\n  Loop\n    {body}\n  End Loop\nEnd Task"
        ]
    lines += ["Event TIMER", *_handler(random), "End Event", "Sub Nothing\n  If INX(3) Then c = 3\nEnd Sub"]
    inputs: list[dict[str, object]] = [
        {
            "channel": random.randint(0, 3),
            "at": round(random.uniform(0, 1.2), random.choice((1, 3, 4))),
            "for": round(random.uniform(0.001, 0.4), 3),
            **({"every": round(random.uniform(0.41, 0.9), 3)} if random.random() < 0.3 else {}),
        }
        for _ in range(random.randint(0, 3))
    ]
    return "\n".join(lines), {"controller.instruction_time": random.choice(COSTS), "input": inputs}


def _poll(random: Random, k: int) -> str:
    chosen = random.choices(_POLLS, k=random.randint(1, 2))
    return "\n    ".join(chosen).replace("@", str(k))


def _handler(random: Random) -> list[str]:
    return [f"  {step}" for step in random.choices(_STEPS, k=random.randint(0, 3))]


def _with_timer(random: Random, seed: int) -> tuple[str, dict[str, object]]:
    """Return a program of `tasks.py` with a timer added, and its machine."""
    text, machine = tasks.program(seed)
    head, rest = text.split("TIME = 0\n", 1)
    period = random.choice(PERIODS)
    lines = [head, "Dim ticks As Integer, other As Integer", f"TIMEREVENT = {period}\nTIME = 0", rest]
    return "\n".join([*lines, "Event TIMER", *_handler(random), "End Event"]), machine


def is_equal(seed: int) -> bool:
    """True if a program has the same result with its loops skipped and without."""
    given = program(seed)
    return is_equal_without_skipping(lambda: handlers.document(*given))


if __name__ == "__main__":
    sys.exit(compare("polls", is_equal))
