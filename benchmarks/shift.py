"""A shift of 20 000 moves on four axes in eight hours, from source to JSON report.

Prints `name value unit`, the best of several rounds in CPU time: the whole shift; only the run of the compiled
program; the shift with travel limits in the machine file; the shift with one task per axis; and the cost of a
wait, and of a move with its wait, in a loop.
"""

from __future__ import annotations

import time

from timing import seconds

from motionlang.execution import accelerators, run
from motionlang.lang.machine.machine import Machine
from motionlang.lang.scheduler import Scheduler
from motionlang.mint import DIALECT
from motionlang.report import text
from motionlang.result import Run
from motionlang.source import Source

# Rounds of a complete run, and of its tasks alone, which take milliseconds and so need more rounds.
ROUNDS, SHORT_ROUNDS = 5, 25
SETTINGS = "SPEED(0, 1, 2, 3) = 100;\nACCEL(0, 1, 2, 3) = 500;\nDECEL(0, 1, 2, 3) = 500;\n"
# 2 500 cycles of two moves on each of four axes, in 11.5 s each.
PROGRAM = f"""
Dim n As Integer
{SETTINGS}
For n = 1 To 2500
  MOVER(0, 1, 2, 3) = 20, 30, 40, 35
  GO(0, 1, 2, 3)
  PAUSE IDLE(0) And IDLE(1) And IDLE(2) And IDLE(3)
  WAIT(5150)
  MOVEA(0, 1, 2, 3) = 0;
  GO(0, 1, 2, 3)
  PAUSE IDLE(0) And IDLE(1) And IDLE(2) And IDLE(3)
  WAIT(5160)
Next
"""
TRAVEL: dict[str, object] = {f"axis.{axis}.travel": [-10.0, 100.0] for axis in range(4)}
# The same moves, each axis in a task of its own.
TASK = """
Task axis{axis}
  Dim n As Integer
  For n = 1 To 2500
    MOVER({axis}) = {distance}
    GO({axis})
    PAUSE IDLE({axis})
    WAIT(5150)
    MOVEA({axis}) = 0
    GO({axis})
    PAUSE IDLE({axis})
    WAIT(5160)
  Next
End Task
"""
FOUR_TASKS = (
    SETTINGS
    + "".join(f"Run axis{axis}\n" for axis in range(4))
    + "WAIT(28750000)\nEnd\n"
    + "".join(TASK.format(axis=axis, distance=(20, 30, 40, 35)[axis]) for axis in range(4))
)
ITERATIONS = 5000
LOOP = f"Dim n As Integer\nSPEED(0) = 100 : ACCEL(0) = 500 : DECEL(0) = 500\nFor n = 1 To {ITERATIONS}\n  {{}}\nNext\n"


def core(program: str) -> float:
    """Return the shortest time to run a compiled program's tasks, s, collector off."""
    fast = accelerators()
    compiled, best = DIALECT.compile(Source("core.mnt", program), {}, fast.ranges), float("inf")
    for _ in range(SHORT_ROUNDS):
        machine = Machine({}, accelerators=fast)
        scheduler = machine.scheduler = (fast.scheduler or Scheduler)(machine, compiled.start(machine))
        best = min(best, seconds(scheduler.run_program))
    return best


def whole(program: str, machine: dict[str, object] | None = None, report: bool = False) -> tuple[float, Run]:
    """Return the shortest time from source text to the end of the run, s, and the run.

    With `report` the time includes the report.
    """
    source, best = Source("shift.mnt", program), float("inf")
    result: Run | None = None
    for _ in range(ROUNDS):
        result = None  # frees the result of the round before
        begin = time.process_time()
        result = run(source, machine=machine or {}, cache=False)
        if report:
            text(result)
        best = min(best, time.process_time() - begin)
    assert result is not None
    assert result.status == "ended", result.status
    return best, result


def main() -> None:
    """Measure and print."""
    best, result = whole(PROGRAM, report=True)
    moves = len(result.controller.log.moves)
    print(f"shift_moves {moves} moves")
    print(f"shift_machine_time {result.time:.0f} s")
    print(f"shift_report {len(text(result)) / 1e6:.1f} MB")
    print(f"shift_cost {best / moves * 1e6:.2f} us/move")
    print(f"shift_speed {result.time / best:.0f} x_real_time")
    alone = core(PROGRAM)
    print(f"shift_core {alone / moves * 1e6:.2f} us/move")
    print(f"shift_core_speed {result.time / alone:.0f} x_real_time")
    print(f"shift_travel {whole(PROGRAM, TRAVEL)[0] / moves * 1e6:.2f} us/move")
    print(f"shift_four_tasks {whole(FOUR_TASKS)[0] / moves * 1e6:.2f} us/move")
    iteration = core(LOOP.format("n = n"))
    print(f"shift_wait {(core(LOOP.format('WAIT(5150)')) - iteration) / ITERATIONS * 1e6:.2f} us")
    one = core(LOOP.format("MOVER(0) = 20 : GO(0)\n  PAUSE IDLE(0)")) - iteration
    print(f"shift_move_and_pause {one / ITERATIONS * 1e6:.2f} us")


if __name__ == "__main__":
    main()
