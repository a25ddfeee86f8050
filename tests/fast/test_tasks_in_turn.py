"""Waiting tasks resume one after the other, as if every task were checked."""

from __future__ import annotations

from random import Random

import pytest

from motionlang import execution
from motionlang.lang.scheduler import Scheduler
from motionlang.report import text
from motionlang.result import Run
from motionlang.source import Source
from tests.cases import one_in

# The actions of a task on its own axis; {n} is its number, {m} that of another one, {d} a number.
STEPS = (
    "MOVER({n}) = {d} : GO({n})\n  PAUSE IDLE({n})",
    "MOVER({n}) = -{d} : GO({n})\n  PAUSE IDLE({n})",
    "MOVEA({n}) = {d} : GO({n})\n  WAIT({d}0)\n  PAUSE IDLE({n})",
    "MOVER({n}) = {d} : GO({n})\n  PAUSE IDLE({n}) And IDLE({m})",
    "WAIT({d}00)",
    "WAIT({d})",
    "WAIT(2.5)",
    "WAIT(0)",
    "Rest({n})",
    "x = POS({n}) + {d}",
    "PAUSE POS({m}) > {d} Or TIME > 400",
    "PAUSE IDLE({m})",
    "OUTX({n}) = {d} Mod 2",
    "PAUSE INX(1) = {d} Mod 2",
    "If IDLE({m}) Then x = x + 1",
    "For k = 1 To {d}0\n    x = x + k\n  Next",
)
# Its occasional actions on others.
ON_OTHERS = (
    "STOP({m})",
    "CANCEL({m})",
    "SPEED({m}) = {d}0",
    "TASKSUSPEND(axis{m})\n  WAIT({d}0)\n  TASKRESUME(axis{m})",
    "TASKPRIORITY(axis{m}) = {d}",
    "TASKQUANTUM(axis{m}) = {d}",
    "If TASKSTATUS(axis{m}) = 0 Then Run axis{m}",
    "End axis{m}\n  Run axis{m}",
    "TIMEREVENT = {d}5",
    "TIMEREVENT = 0",
)
HANDLER = "Event TIMER\n  Dim y As Integer\n  y = y + 1\n  WAIT(1)\nEnd Event\n"
SUB = "Sub Rest(n As Integer)\n  WAIT(3)\n  MOVER(n) = 1 : GO(n)\n  PAUSE IDLE(n)\nEnd Sub\n"
SETTINGS = "SPEED(0, 1, 2) = 100; : ACCEL(0, 1, 2) = 500; : DECEL(0, 1, 2) = 500;\n"
INPUTS: dict[str, object] = {"input": [{"channel": 1, "at": 0.2, "for": 0.7, "every": 1.9, "times": 4}]}


def program(random: Random) -> str:
    """Return a program of three tasks, each a loop of some steps."""
    found = SETTINGS + "".join(f"Run axis{n}\n" for n in range(3)) + "WAIT(6000)\nEnd\n"
    for n in range(3):
        steps = [random.choice(STEPS) for _ in range(random.randint(2, 6))]
        steps += [random.choice(ON_OTHERS) for _ in range(random.choice((0, 0, 0, 1, 2)))]
        random.shuffle(steps)
        body = "".join(
            f"  {each.format(n=n, m=(n + random.randint(1, 2)) % 3, d=random.randint(1, 9))}\n"
            for each in steps
        )
        found += f"Task axis{n}\n  Dim k, x As Integer\n  While 1\n{body}  Wend\nEnd Task\n"
    return found + SUB + HANDLER


def left(result: Run) -> tuple[object, ...]:
    """Return the complete result of a run."""
    log = result.machine.log
    return text(result), list(log.waits), list(log.slices), list(log.events), list(log.outputs)


@pytest.mark.parametrize("seed", one_in(3, range(42)))
def test_it_is_the_same_as_asking_everybody(seed: int) -> None:
    source = Source("tasks.mnt", program(Random(seed)))
    in_turn = execution.run(source, machine=INPUTS, cache=False, until=8.0)
    paced = execution.run(source, machine=INPUTS, cache=False, until=8.0, pace=lambda now: None)
    assert left(in_turn) == left(paced)


def test_moving_and_waiting_tasks_are_found_in_one_check(monkeypatch: pytest.MonkeyPatch) -> None:
    checks = 0
    runnable = Scheduler._runnable

    def counted(scheduler: Scheduler) -> object:
        nonlocal checks
        checks += 1
        return runnable(scheduler)

    monkeypatch.setattr(Scheduler, "_runnable", counted)
    body = "".join(
        f"Task axis{n}\n  Dim k As Integer\n  For k = 1 To 50\n    MOVER({n}) = {n + 3} : GO({n})\n"
        f"    PAUSE IDLE({n})\n    WAIT({n}57)\n  Next\nEnd Task\n"
        for n in range(3)
    )
    starts = "".join(f"Run axis{n}\n" for n in range(3))
    result = execution.run(Source("tasks.mnt", f"{SETTINGS}{starts}WAIT(60000)\nEnd\n{body}"), cache=False)
    assert len(result.machine.log.waits) > 300
    assert checks == 12
