"""The state of a task is plain data: it can be stored, and another task goes on from it."""

from __future__ import annotations

import pickle
from typing import Any

import pytest

from motionlang.kernel import Machine, Scheduler, Source, Steps
from motionlang.kernel.lang.step_task import Caller
from motionlang.kernel.mccl import FileTask, LineSteps, MacroFile

# A macro that calls another one in a loop that counts, and a line that repeats.
PROGRAM = """\
MD1,RA10,AA1,AR10,WA0.001
MD2,MC1,WA0.0005,RA10,IB20,RP,NO,AL5,AR11
MC2,TR10
RA11,AA1,AR11,RP4
TR11
"""


def started() -> tuple[FileTask, Scheduler, Machine]:
    machine = Machine(first_axis=1)
    task = MacroFile(Source("a.mcl", PROGRAM)).start(machine)
    machine.scheduler = Scheduler(machine.controller, task)
    return task, machine.scheduler, machine


def name_of(task: FileTask, steps: Steps) -> Any:
    """Return a name for a list of steps: the number of its line, and of the macro if it is one."""
    if not isinstance(steps, LineSteps):
        return "main"
    macro = next((number for number, each in task.board.macros.items() if each is steps), None)
    return steps.line.number, macro


def stored(task: FileTask) -> bytes:
    calls = [(name_of(task, call.steps), call.pc, call.values[1]) for call in task.calls]
    place = name_of(task, task.steps), task.pc, task.is_paid, task.values[1]
    return pickle.dumps((place, calls, task.registers, task.board.registers))


def restore(task: FileTask, state: bytes) -> None:
    """Let a task that has not begun go on from a state of another one."""
    (name, task.pc, task.is_paid, repeats), calls, registers, shared = pickle.loads(state)
    board, main = task.board, task.steps
    lines = {
        line.number: line for line in MacroFile(Source("a.mcl", PROGRAM)).lines if not isinstance(line, tuple)
    }
    board.macros = {1: board.written(lines[1].rest(1)), 2: board.written(lines[2].rest(1))}
    board.registers[:], task.registers[:] = shared, registers
    written: dict[Any, Steps] = {"main": main}

    def steps_of(name: Any) -> Steps:
        if name not in written:
            number, macro = name
            written[name] = board.written(lines[number]) if macro is None else board.macros[macro]
        return written[name]

    task.steps, task.values = steps_of(name), [task.registers, repeats]
    task.calls[:] = [Caller(steps_of(each), pc, [task.registers, left]) for each, pc, left in calls]


@pytest.mark.parametrize("until", [0.0, 0.0103, 0.02, 0.02995, 0.0305, 0.0309, 0.04])
def test_a_task_goes_on_from_its_state(until: float) -> None:
    """Also while it waits: the wait is then over, and the next step follows."""
    task, scheduler, machine = started()
    scheduler.run_program(until)
    other, later, copy = started()
    restore(other, stored(task))
    said = machine.terminal.lines
    scheduler.run()
    later.run()
    assert said + copy.terminal.lines == machine.terminal.lines == ["20", "10"]
