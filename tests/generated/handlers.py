"""Random programs with TIMER handlers alongside moves and tasks.

Each runs with identical iterations skipped and with none skipped. The reports and all records of the log must be equal.

`python -m tests.generated.handlers 3000 --seed 1` compares that many programs and prints the seeds of those
that differ.
"""

from __future__ import annotations

import sys
from random import Random

from motionlang import run
from motionlang.kernel import Source, report
from tests.generated.compared import compare, is_equal_without_skipping

UNTIL = 1.2
COSTS = (1e-5, 0.7310585e-5)

_HEAD = """\
Dim n As Integer, m As Integer, k As Integer, x As Float, state As Integer
SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500
"""
_CONDITIONS = (
    "INX(0)", "INX(1) = 0", "VEL(0) > 0", "POS(0) > 6", "IDLE(0)", "n > 40", "m < 9", "n = 25", "OUTX(2)",
    "TIME > 333", "x > 3", "k = 0", "NETFLOAT(1) = 0",
)  # fmt: skip
_STEPS = (
    "n = n + 1", "n = n + 1", "m = m + 2", "n = n - 3", "x = x + 1", "OUTX(1) = 1", "OUTX(2) = Not OUTX(2)",
    "k = 1 - k",
    "OUTX(3) = INX(1)", "OUT(0) = 5", "x = POS(0)", "x = x * 0.9 + VEL(0) * 0.1", "local = local + 1", "Bump",
    "OUTX(4) = n > 30", "OUTX(2) = 1 : OUTX(2) = 0", "COMMS(1) = 4", "k = INX(0)",
)  # fmt: skip
_ACTS = (
    "STOP(0)", "state = 1", 'PRINT "tick ", TIME, n', "TIMEREVENT = 7", "TIMEREVENT = 0", "WAIT(3)", "n = 0", "m = 0",
    "JOG(1) = 5", "Bump", "TIME = 0",
)  # fmt: skip
_MAIN = (
    "MOVER(0) = 7 : GO(0) : PAUSE IDLE(0)", "MOVER(0) = -7 : GO(0) : PAUSE IDLE(0)", "WAIT(170)", "WAIT(45)",
    "PAUSE INX(0)", "PAUSE INX(1) = 0", "PAUSE n > 30 Or TIME > 400", "PAUSE POS(0) > 3 Or IDLE(0)",
    "MOVER(0) = 5 : GO(0)\nWhile Not IDLE(0)\nEnd While", "PRINT n, m, k, x", "OUTX(5) = Not OUTX(5)",
    "MOVER(0) = 4 : GO(0)\nWhile Not IDLE(0)\n  x = POS(0)\n  WAIT(1)\nEnd While", "PAUSE OUTX(2) Or TIME > 300",
    "TIME = 0", "PAUSE state Or TIME > 200", "MOVER(0, 1) = 3, 2 : GO(0, 1) : PAUSE IDLE(0) And IDLE(1)",
)  # fmt: skip
_TASKS = (
    "  WAIT(70)\n  OUTX(6) = Not OUTX(6)\n",
    "  PAUSE INX(1)\n  WAIT(5)\n  PAUSE Not INX(1)\n",
    "  If INX(0) Then OUTX(7) = 1 Else OUTX(7) = 0\n  WAIT(9)\n",
    "  If VEL(0) > 0 Then OUTX(7) = 1 Else OUTX(7) = 0\n",
    "  PAUSE IDLE(1)\n  MOVER(1) = 2 : GO(1)\n  WAIT(30)\n",
)
# What a program is made of.
PARTS = (*_CONDITIONS, *_STEPS, *_ACTS, *_MAIN, *_TASKS)


def program(seed: int) -> tuple[str, dict[str, object]]:
    """Return a program and its machine."""
    random = Random(seed)
    period = random.choice((1, 1, 2, 5, 10, 33))
    lines = [_HEAD]
    tasks = [random.choice(_TASKS) for _ in range(random.choice((0, 0, 1, 1, 2, 3)))]
    lines += [f"Run T{number}" for number in range(len(tasks))]
    lines += [f"TIMEREVENT = {period}", "Loop"]
    lines += [random.choice(_MAIN) for _ in range(random.randint(1, 4))]
    lines += ["WAIT(1)", "If TIME > 900 Then Exit Loop", "End Loop", 'PRINT "end ", TIME, n, m, k, x', "End"]
    lines += ["Event TIMER", *_handler(random), "End Event"]
    if random.random() < 0.3:
        body = random.choice((*_STEPS, *_ACTS[:4]))
        lines += ["Event IN0", f"  {body}", "End Event"]
    for number, task in enumerate(tasks):
        lines += [f"Task T{number}\nLoop\n{task}End Loop\nEnd Task"]
    lines += ["Sub Bump\n  m = m + 1\n  If m > 11 Then m = 0\nEnd Sub"]
    inputs: list[dict[str, object]] = [
        {
            "channel": random.randint(0, 1),
            "at": round(random.uniform(0, 1.0), random.choice((1, 3, 4))),
            "for": round(random.uniform(0.01, 0.4), random.choice((2, 4))),
        }
        for _ in range(random.randint(0, 3))
    ]
    if random.random() < 0.1:
        inputs.append({"channel": 1, "output": 2, "delay": 0.004})
    return "\n".join(lines), {"controller.instruction_time": random.choice(COSTS), "input": inputs}


def _handler(random: Random) -> list[str]:
    lines = []
    for _ in range(random.randint(0, 3)):
        step = random.choice(_STEPS)
        kind = random.randrange(5)
        if kind < 3:
            lines.append(f"  {step}")
        elif kind == 3:
            lines.append(f"  If {random.choice(_CONDITIONS)} Then {random.choice(_STEPS)}")
        else:
            lines.append(f"  If {random.choice(_CONDITIONS)} Then {random.choice(_ACTS)}")
    return lines


def document(text: str, machine: dict[str, object]) -> str:
    """Return the report of a run and the records of its log."""
    made = run(Source("a.mnt", text), machine=machine, until=UNTIL)
    log = made.machine.log
    streams = (log.inputs, log.outputs, log.prints, log.events, log.settings)
    return "\n".join([report.text(made), *(repr(list(map(tuple, stream))) for stream in streams)])


def is_equal(seed: int) -> bool:
    """True if a program has the same result with its loops skipped and without."""
    given = program(seed)
    return is_equal_without_skipping(lambda: document(*given))


if __name__ == "__main__":
    sys.exit(compare("handlers", is_equal))
