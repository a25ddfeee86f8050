"""Random scan loops that step by inputs, clocks and positions, which a run must not give up too early.

A run that ends by `never` is compared with one that gives up nothing and skips nothing: it must print, move and
switch nothing more in the time in which the last clock could turn. Clocks, delays and inputs are on the same whole
milliseconds, so readings equal the level that they are compared with.

`python -m tests.generated.never 2000 --seed 1` compares that many programs and prints the seeds of those that differ.
"""

from __future__ import annotations

import sys
from random import Random

from motionlang.kernel.execution import run
from motionlang.kernel.result import Run
from motionlang.kernel.source import Source
from tests.generated.compared import compare, every_iteration

COSTS = (1e-5, 2.5e-5, 1e-4, 1e-4, 2e-4)
DELAYS = (5, 10, 20, 50, 100, 200, 400)
# No clock is compared with more than the longest delay, so a run that gives up is followed for this long, s.
LAST = 1.0
UNTIL = 2.0

_CLOCKS = (
    "TIME - t0 > @", "TIME - t0 >= @", "TIME > t0 + @", "Not (TIME < t0 + @)", "TIME - t0 = @", "TIME - t0 <> @",
    "since > @", "since >= @", "@ < TIME - t0", "TIME - t0 > @", "TIME - t0 > @", "TIME - t0 >= @",
    "Abs(TIME - t0) > @",
)  # fmt: skip
_STATES = (
    "INX(0)", "Not INX(0)", "INX(1)", "Not INX(1)", "INX(2)", "IDLE(0)", "POS(0) > 2", "POS(0) >= 3", "POS(0) < 1",
)  # fmt: skip
_ACTS = (
    "OUTX(1) = 1", "OUTX(1) = 0", "OUTX(2) = Not OUTX(2)", "MOVEA(0) = 4 : GO(0)", "MOVEA(0) = 0 : GO(0)",
    'PRINT s; " "; TIME', "n = n + 1", "since = 0",
)  # fmt: skip


def program(seed: int) -> tuple[str, dict[str, object]]:
    """Return a program and its machine."""
    random = Random(seed)
    scan = [_step(random, step, steps) for steps in (random.randint(3, 6),) for step in range(steps)]
    random.shuffle(scan)
    lines = [
        "Dim s As Integer, t0 As Integer, n As Integer, old As Integer",
        "Dim since As Time",
        "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000",
    ]
    tail = ["End Loop"]
    if random.random() < 0.3:
        lines += ["Run Guard"]
        tail += ["Task Guard", "  Loop", "    If INX(3) Then OUTX(5) = 1", "  End Loop", "End Task"]
    if random.random() < 0.7:  # variables that a Sub reads are shared
        lines += ["Show"]
        tail += ["Sub Show", '  PRINT s; " "; t0; " "; n; " "; old', "End Sub"]
    remembered = ["  old = INX(1)"] if random.random() < 0.4 else []
    inputs: list[dict[str, object]] = [
        {"channel": 0, "output": 1, "delay": random.choice(DELAYS) / 1000.0},
        {"channel": 1, "output": 2, "delay": random.choice(DELAYS) / 1000.0, "value": random.choice((0, 1))},
        {"channel": 2, "at": random.choice(DELAYS) / 1000.0},
    ]
    machine = {"controller.instruction_time": random.choice(COSTS), "run.until": UNTIL, "input": inputs}
    return "\n".join([*lines, "Loop", *scan, *remembered, *tail]), machine


def _step(random: Random, step: int, steps: int) -> str:
    tests = [f"s = {step}"]
    if random.random() < 0.7:
        tests.append(random.choice(_CLOCKS).replace("@", str(random.choice(DELAYS))))
    if random.random() < 0.7:
        tests.append(random.choice(_STATES))
    if random.random() < 0.3:
        random.shuffle(tests)
    following = random.choice((step + 1, step + 1, (step + 1) % steps))
    # Half of the steps change nothing but variables, and some of these read no clock.
    acts = random.choices(_ACTS, k=random.choice((0, 0, 1, 2)))
    restarts = ["t0 = TIME"] if random.random() < 0.5 else []
    done = " : ".join([*acts, *restarts, f"s = {following}"])
    return f"  If {' And '.join(tests)} Then\n    {done}\n  End If"


def _said(made: Run, until: float) -> list[object]:
    """Return what a run has done before a time, and its mistakes except that it gave up."""
    log = made.machine.log
    done: list[tuple[float, object]] = [
        (each.time, each) for s in (log.outputs, log.prints, log.inputs) for each in s
    ]
    moves = [(each.start_time, (each.line, each.command)) for each in log.moves]
    errors = [each.message for each in made.diagnostics if each.severity == "error" and each.code != "never"]
    return [*(each for each in done + moves if each[0] < until), *errors]


def is_equal(seed: int) -> bool:
    """True if a program that gives up, or ends, does no more when it is run on with every iteration."""
    return does_no_more(*program(seed))


def does_no_more(text: str, machine: dict[str, object]) -> bool:
    """True if a program on a machine does the same, and no more, when it is run on with every iteration."""
    made = run(Source("a.mnt", text), machine=machine)
    gave_up = any(each.code == "never" for each in made.diagnostics)
    end = made.time + LAST if gave_up else made.time
    with every_iteration():
        whole = run(Source("a.mnt", text), machine=machine, until=end)
    return _said(made, end) == _said(whole, end)


if __name__ == "__main__":
    sys.exit(compare("never", is_equal))
