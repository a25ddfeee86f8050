"""Polling loops over hours of machine time, and loops that are never skipped.

Prints `name value unit` for each benchmark. A speed is processor time from source text to result, the best of
several runs; every run compiles the program. A ratio compares two programs by their best times, or one program
with and without the checks for skipping, run side by side.
"""

from __future__ import annotations

import gc
import sys
from time import process_time

from timing import seconds

from motionlang.execution import accelerators, run
from motionlang.lang.machine.machine import Machine
from motionlang.lang.scheduler import Scheduler
from motionlang.mccl import DIALECT as MCCL
from motionlang.mccl.runtime.task import CommandTask
from motionlang.mint import DIALECT as MINT
from motionlang.mint.compile import polling
from motionlang.source import Source

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.dialect import Dialect

ROUNDS = 3
# Of loops that are never skipped: how many stretches of their move are measured, and the duration of each, s.
STRETCHES, STRETCH = 32, 0.1
SHIFT = 8 * 3600.0
_AXIS = "SPEED(0) = 100 : ACCEL(0) = 500 : DECEL(0) = 500\n"
_THERE = "Loop\n  MOVER(0) = 500 : GO(0)\n  {}\n  MOVER(0) = -500 : GO(0)\n  {}\nEnd Loop\n"
_UNTIL_IDLE = _AXIS + _THERE.format("Repeat\n    {0}\n  Until IDLE(0)", "PAUSE IDLE(0)")
# Moves of 5.2 s; an input that is on for 4 s of every 10; a web that a wheel measures.
SKIPPED = {
    "stands": _AXIS + _THERE.format("Repeat : Until VEL(0) = 0", "Repeat : Until VEL(0) = 0"),
    "error": f"{_AXIS}Loop\n  If ABS(FOLERROR(0)) > 5 Then STOP(0)\n"
    "  If IDLE(0) Then\n    MOVER(0) = 500 - 2 * POS(0) : GO(0)\n  End If\nEnd Loop\n",
    "jog_panel": f"{_AXIS}Loop\n  If INX(0) Then JOG(0) = 100 Else STOP(0)\nEnd Loop\n",
    "maximum": "Dim m As Float\n" + _UNTIL_IDLE.format("If POS(0) > m Then m = POS(0)"),
    "top_speed": "Dim m As Float\n" + _UNTIL_IDLE.format("If VEL(0) > m Then m = VEL(0)"),
    "counter": "Dim n As Integer\n" + _UNTIL_IDLE.format("n = n + 1"),
    "copy": "Dim x As Float\n" + _UNTIL_IDLE.format("x = POS(0)"),
}
CUT_TO_LENGTH = """\
MD1,LU"AUXPOSITION",AR20,1RL@20,IB3000,JR-2,NO,MC2,RP
MD2,AS3000,1WL@20,CN33,WA0.05,CF33
1AH0,MC1
"""
# Repeated readings of a moving axis, which are never skipped.
RECKONED = 'LU"POSITION",AR20\n1MN,1SV1000,1MR30000\n1RL@20,AA5,IB30000,JR-3,NO\n'
_MOVING = "SPEED(0) = 10 : MOVER(0) = 30 : GO(0)\nWhile Not IDLE(0)\n  {}\nEnd While\n"
LEFT_ALONE = {
    "display": "Dim x As Float\n" + _MOVING.format("x = POS(0)\n  COMMS(1) = x"),
    "mean": "Dim x As Float\n" + _MOVING.format("x = x * 0.9 + POS(0) * 0.1"),
    "cam_switch": "Dim x As Float\n"
    + _MOVING.format("x = POS(0)\n  If x > 5 And x < 10 Then OUTX(1) = 1 Else OUTX(1) = 0"),
    "clock": "Dim r As Integer, k As Integer\n"
    + _MOVING.format("r = TIME Mod 100\n  If r > 50 Then k = 1 Else k = 0"),
    "sum": "Dim x As Float\n" + _MOVING.format("x = x + POS(0)"),
}


def tasks(count: int, body: str) -> str:
    """Return a move of an hour and `count` polling tasks; `#` is a task's number."""
    loops = [f"Dim x{k} As Float\nLoop\n  {body.replace('#', str(k))}\nEnd Loop\n" for k in range(count)]
    starts = "".join(f"Run T{k}\n" for k in range(1, count))
    others = "".join(f"Task T{k}\n{loops[k]}End Task\n" for k in range(1, count))
    return f"SPEED(0) = 1 : MOVER(0) = 3600 : GO(0)\n{starts}{loops[0]}End\n{others}"


def panel(count: int) -> str:
    """Return a program in which one task polls for moves and the others for inputs.

    There are `count` tasks in all. All loops can be skipped.
    """
    starts = "".join(f"Run T{k}\n" for k in range(1, count))
    until_idle = "Repeat : Until IDLE(0)"
    others = (
        f"Task T{k}\nLoop\n  If INX({k}) Then OUTX({k}) = 1\nEnd Loop\nEnd Task\n" for k in range(1, count)
    )
    return f"{_AXIS}{starts}{_THERE.format(until_idle, until_idle)}End\n{''.join(others)}"


def speed(source: Source, machine: dict[str, object]) -> float:
    """Return machine time over processor time, from the text to the result."""
    return SHIFT / min(
        seconds(lambda: run(source, machine=machine, cache=False, until=SHIFT)) for _ in range(ROUNDS)
    )


def started(text: str, dialect: Dialect = MINT) -> Scheduler:
    """Return the scheduler of a compiled program that is ready to run."""
    machine = Machine(accelerators=accelerators())
    task = dialect.compile(Source("poll", text), {}, machine.accelerators.ranges).start(machine)
    machine.scheduler = (machine.accelerators.scheduler or Scheduler)(machine, task)
    return machine.scheduler


def plain(text: str, dialect: Dialect) -> Scheduler:
    """Return the scheduler of a program whose loops are never checked for skipping."""
    watched = polling.watched
    polling.watched = lambda *_: None
    scheduler = started(text, dialect)
    polling.watched = watched
    if isinstance(scheduler.parent, CommandTask):
        scheduler.parent.unchecked = sys.maxsize
    return scheduler


def cost(text: str, until: float) -> float:
    """Return the processor time, s, of a compiled program up to a machine time."""
    scheduler = started(text)
    return seconds(lambda: scheduler.run(until))


def of_plain_simulation(text: str, dialect: Dialect = MINT) -> float:
    """Return the ratio of a program's cost without checks to that with them.

    Both run side by side and alternate every tenth of a second. For each such stretch the fastest of several runs
    counts, because the load of the computer changes a complete run by more than the measured difference.
    """
    quickest = [[float("inf")] * STRETCHES for _ in range(2)]
    for _ in range(2 * ROUNDS):
        sides = started(text, dialect), plain(text, dialect)
        gc.collect()
        gc.disable()
        for stretch in range(STRETCHES):
            for side in (0, 1) if stretch % 2 else (1, 0):
                began = process_time()
                sides[side].run((stretch + 1) * STRETCH)
                taken = process_time() - began
                quickest[side][stretch] = min(quickest[side][stretch], taken)
        gc.enable()
    return sum(quickest[1]) / sum(quickest[0])


def main() -> None:
    """Print `name value unit` lines."""
    inputs = [{"channel": 0, "at": 10.0 * k, "for": 4.0} for k in range(int(SHIFT / 10))]
    for name, text in SKIPPED.items():
        machine: dict[str, object] = {"input": inputs} if name == "jog_panel" else {}
        print(f"poll_{name} {speed(Source('poll.mnt', text), machine):.0f} x_real_time")
    web: dict[str, object] = {"encoder": [{"aux": 1, "velocity": 250.0}]}
    print(f"poll_cut_to_length {speed(Source('poll.mcl', CUT_TO_LENGTH), web):.0f} x_real_time")
    for name, text in LEFT_ALONE.items():
        print(f"poll_left_alone_{name} {of_plain_simulation(text):.3f} of_plain_simulation")
    print(f"poll_left_alone_line {of_plain_simulation(RECKONED, MCCL):.3f} of_plain_simulation")
    for name, body, until in (
        ("reading", "x# = POS(0) : If x# > 3000 Then OUTX(#) = 1", 2.0),
        ("writing", "COMMS(# + 1) = POS(0)", 1.0),
    ):
        one, many = (min(cost(tasks(count, body), until) for _ in range(ROUNDS)) for count in (1, 32))
        print(f"poll_32_tasks_{name} {many / one:.2f} x one_task")
    one, many = (min(cost(panel(count), 300.0) for _ in range(ROUNDS)) for count in (1, 32))
    print(f"poll_32_tasks_beside_moves {many / one:.2f} x one_task")


if __name__ == "__main__":
    main()
