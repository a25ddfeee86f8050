"""Random loops that take the time, and compare the time that has passed since.

Each runs with identical iterations skipped and with none skipped: prints, outputs, moves and the end must be equal.

`python -m tests.generated.clocks 2000 --seed 1` compares that many programs and prints the seeds of those that differ.
"""

from __future__ import annotations

import sys
from random import Random

from tests.generated.compared import compare
from tests.generated.never import does_no_more

COSTS = (1e-5, 2.5e-5, 1e-4, 1e-4, 3.3e-4, 1e-3)
UNTIL = 1.0

_LEVELS = (-5, -1, 0, 1, 2, 3, 5, 8, 20, 50, 100, 100, 250, 250, 250)
_STATES = ("INX(0)", "Not INX(0)", "INX(1)", "Not INX(1)", "IDLE(0)", "Not IDLE(0)", "POS(0) > 2", "n > 3")
_TAKES = (
    "t1 = TIME", "t1 = TIME", "t2 = TIME", "t2 = TIME", "If # Then t1 = TIME", "If # Then t1 = TIME",
    "If # Then t2 = TIME", "If # And # Then t1 = TIME Else t2 = TIME", "t1 = TIME - 30", "t1 = t2", "t2 = t1 + 1",
    "t1 = POS(0)", "If # Then t1 = POS(0)", "t1 = n", "f = TIME", "If # Then f = TIME", "x = TIME - t1", "x = t1",
    "If TIME > t1 + @ Then !", "lim = TIME", "If # Then lim = TIME", "TIME = 0", "If # Then TIME = 0",
)  # fmt: skip
_TESTS = (
    "TIME - t1 ? @", "TIME - t1 ? @", "TIME - t1 ? @", "TIME - t2 ? @", "@ ? TIME - t1", "TIME - f ? @",
    "TIME - t1 + 3 ? @", "Abs(TIME - t1) ? @", "TIME - t1 ? lim", "TIME - t1 ? n", "t1 - TIME ? @", "TIME - t1 ? t2",
    "t1 ? @", "x ? @", "POS(0) - t1 ? @",
)  # fmt: skip
_ACTS = (
    "n = n + 1", "OUTX(1) = Not OUTX(1)", "OUTX(2) = 1", "OUTX(2) = 0", "MOVEA(0) = 4 : GO(0)",
    "MOVEA(0) = 0 : GO(0)", 'PRINT TIME; " "; t1; " "; t2; " "; n; " "; x', "OUTX(1) = 1", "OUTX(1) = 0", "Exit Loop",
)  # fmt: skip
_TASKS = (
    "Loop\n    PAUSE t1 > 300\n    OUTX(3) = Not OUTX(3)\n    WAIT(50)\n  End Loop",
    "Loop\n    If INX(1) Then OUTX(3) = 1 Else OUTX(3) = 0\n  End Loop",
    "Loop\n    WAIT(30)\n    OUTX(3) = Not OUTX(3)\n  End Loop",
    "Loop\n    PAUSE INX(2)\n    t2 = 5\n    PAUSE Not INX(2)\n  End Loop",
    "Loop\n    t2 = TIME\n    If TIME - t2 > 40 Then OUTX(3) = 1\n  End Loop",
)


def program(seed: int) -> tuple[str, dict[str, object]]:
    """Return a program and its machine."""
    random = Random(seed)
    lines = ["Dim n As Integer, x As Integer, lim As Integer, f As Float"]
    lines += ["Dim t1 As Integer, t2 As Integer"]
    lines += ["SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000", "lim = 60"]
    tail: list[str] = []
    if random.random() < 0.3:
        lines += ["Run Other"]
        tail += ["Task Other", f"  {random.choice(_TASKS)}", "End Task"]
    if random.random() < 0.2:
        lines += [f"TIMEREVENT = {random.choice((5, 20, 100))}"]
        tail += [
            "Event TIMER",
            f"  {_filled(random, random.choice(('n = n + 1', 't1 = 7', '!')))}",
            "End Event",
        ]
    body = [_filled(random, random.choice(_TAKES)) for _ in range(random.randint(1, 3))]
    for _ in range(random.randint(1, 3)):
        test = random.choice(_TESTS) + random.choice(("", "", " And #", " Or #"))
        body.append(_filled(random, f"If {test} Then !"))
    if random.random() < 0.2:
        body.append(f"WAIT({random.choice((1, 2, 5))})")
    random.shuffle(body)
    apart = Random(f"sub of {seed}")
    if apart.random() < 0.4:
        body, subs = _in_subs(apart, body)
        tail += subs
    loop = [
        "Loop",
        *(f"  {each}" for each in body),
        "End Loop",
        'PRINT "end "; TIME; " "; t1; " "; t2; " "; n; x',
    ]
    inputs = [
        {"channel": 0, "at": random.choice((0.1, 0.2503, 0.5))},
        {
            "channel": 1,
            "output": 1,
            "delay": random.choice((0.02, 0.05, 0.2)),
            "value": random.choice((0, 1)),
        },
        {"channel": 2, "at": 0.3, "for": 0.2},
    ]
    made = "\n".join([*lines, *loop, *loop, "End", *tail]).replace("Exit Loop\n  End", "Exit Loop\n  End")
    return made, {"controller.instruction_time": random.choice(COSTS), "run.until": UNTIL, "input": inputs}


def _in_subs(random: Random, body: list[str]) -> tuple[list[str], list[str]]:
    """Return some statements with calls of subs in place of others, maybe with a loop inside, and these subs."""
    subs: list[str] = []
    for k, each in enumerate(body):
        if "Exit" in each or random.random() < 0.4:
            continue
        if random.random() < 0.3:
            each = _filled(
                random, f"If # And TIME - t1 ? @ Then\n    While #\n      {each}\n    End While\n  End If"
            )
        body[k] = f"Sub{k}(n)" if random.random() < 0.2 else f"Sub{k}"
        parameter = "v As Integer" if body[k].endswith(")") else ""
        subs += [f"Sub {body[k].split('(')[0]}({parameter})", f"  {each}", "End Sub"]
    return body, subs


def _filled(random: Random, text: str) -> str:
    """Return a statement with its states, levels, comparisons and acts filled in."""
    choices = (
        ("!", _ACTS),
        ("#", _STATES),
        ("?", ("<", "<=", ">", ">", ">", ">=", "=", "<>")),
        ("@", _LEVELS),
    )
    for mark, some in choices:
        while mark in text:
            text = text.replace(mark, str(random.choice(some)), 1)
    return text


def is_equal(seed: int) -> bool:
    """True if a program does the same with identical iterations skipped and with none skipped."""
    return does_no_more(*program(seed))


if __name__ == "__main__":
    sys.exit(compare("clocks", is_equal))
