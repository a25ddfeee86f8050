"""The state at a stop as variables: calls, program data, axes, channels.

Nothing here changes the run: positions are computed from the profiles at the time of the stop, and a motor shows only
samples that the run itself has computed.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.ide.debug.expressions import WrongExpression
from motionlang.kernel import INFINITY, Axis, Controller, Hook, Machine, Task, Variable
from motionlang.kernel.controller import Channels, fault_names
from motionlang.kernel.lang import Frame
from motionlang.kernel.log import LoggedMove

if TYPE_CHECKING:
    from motionlang.ide.debug.replay import StopPoint

# The first word of the path of a variable: of the program, or of the innermost call, the next one and so on. MACHINE is
# that of an axis or a channel.
MODULE, LOCAL, MACHINE = "module", "local", "machine"
_OF_MACHINE = re.compile(r"\s*(axis|(?:analogue )?(?:input|output))\s+(\d{1,4})\s*", re.IGNORECASE)


@dataclass(eq=False, slots=True)
class Waiting:
    """A task or an event handler, and the condition it waits for ("" if it can run)."""

    name: str
    task: Task
    why: str
    is_handler: bool


def tasks(machine: Machine, running: Task | None) -> list[Waiting]:
    """Return the tasks and handlers of a program, including the running one."""
    scheduler = machine.scheduler
    if scheduler is None:
        return []
    found = []
    for task in [*scheduler.interrupts, *scheduler.tasks]:
        if task.done:
            continue
        wait = task.wait
        why = "" if wait is None or task is running else f"waits {wait.why}"
        found.append(Waiting(task.name, task, why, task in scheduler.interrupts))
    return found


def frames(hook: Hook, task: Task, point: StopPoint | None) -> Sequence[Frame]:
    """Return the calls of a task, the innermost first; `point` is the stop of the run."""
    assert hook.inspection is not None
    offset = point.offset if point is not None and point.task is task else None
    return hook.inspection.frames(task, offset)


def module(hook: Hook) -> list[Variable]:
    """Return the global variables of the program, or the shared registers."""
    assert hook.inspection is not None
    return hook.inspection.module()


def find(hook: Hook, point: StopPoint | None, path: Sequence[str]) -> Variable | None:
    """Return the variable at a path, which is its scope and the names that lead to it.

    `point` is None at the end of the run, where there are no calls.
    """
    if hook.inspection is None:
        return None
    scope, *rest = path
    if scope == MODULE:
        found: Iterable[Variable] = module(hook)
    elif point is None:
        return None
    else:
        calls = frames(hook, point.task, point)
        number = int(scope.removeprefix(LOCAL))
        found = calls[number].variables if number < len(calls) else []
    variable = None
    for name in rest:
        variable = next((each for each in found if each.name.lower() == name.lower()), None)
        if variable is None and len(rest) == 1:
            variable = hook.inspection.unlisted(None if point is None else point.task, name)
        if variable is None:
            return None
        found = variable.value if isinstance(variable.value, list) else []
    return variable


def named(hook: Hook, point: StopPoint | None, name: str) -> tuple[tuple[str, ...], Variable] | None:
    """Return path and variable of a name, resolved as in the program."""
    for scope in (f"{LOCAL}0", MODULE):
        variable = find(hook, point, (scope, name))
        if variable is not None:
            return (scope, variable.name), variable
    return None


# ------------------------------------------------------------------------------------------------------ machine


def axes(machine: Machine, time: float, moment: float | None = None) -> list[Variable]:
    """Return the state of each axis at a time, and its motion at an earlier moment.

    The time is not before the clock's. There are no axes before the program uses the controller.
    """
    controller = machine.controller
    return [
        Variable(f"axis {number}", "axis", _axis(controller, axis, time) + _earlier(axis, moment))
        for number, axis in controller.axes.items()
    ]


def _axis(controller: Controller, axis: Axis, time: float) -> list[Variable]:
    scale = axis.scale
    target = axis.target
    found = [
        Variable("position", "uu", scale.position_to_user(axis.position(time))),
        Variable("velocity", "uu/s", scale.to_user(axis.velocity(time), "uu/s")),
        Variable("target", "uu", None if abs(target) == INFINITY else scale.position_to_user(target)),
        Variable("state", "", _state(controller, axis)),
        Variable("faults", "", fault_names(axis.faults) or "none"),
        Variable("buffer", "", [_move(number, each) for number, each in enumerate(axis.buffer)]),
    ]
    motor = None if axis.feedback is None else axis.feedback.known_position(time)
    if motor is not None:
        found.insert(1, Variable("measured position", "uu", scale.position_to_user(motor)))
    return found


def _earlier(axis: Axis, moment: float | None) -> list[Variable]:
    """Return position and velocity of an axis at a moment before the stop."""
    if moment is None:
        return []
    if axis.index_at(moment) < 0:
        return []
    when = f"at {moment:.9g} s"
    return [
        Variable(f"position {when}", "uu", axis.place_at(moment)),
        Variable(
            f"velocity {when}", "uu/s", axis.scale.rate * axis.velocity(moment) / axis.scale_at(moment)[0]
        ),
    ]


def _state(controller: Controller, axis: Axis) -> str:
    if not axis.enabled:
        return "off"
    return "idle" if controller.is_idle(axis.index) else "moving"


def _move(number: int, move: LoggedMove) -> Variable:
    released = "" if move.released else ", not released"
    return Variable(f"move {number}", "", f"{move.command}, line {move.line}{released}")


def reading(machine: Machine, time: float, what: str, number: int) -> float:
    """Return a reading for an expression; raise WrongExpression for an unknown axis."""
    controller = machine.controller
    if what in ("input", "output"):
        return float((controller.inputs if what == "input" else controller.outputs).present(number))
    axis = controller.axes.get(number)
    if axis is None:
        raise WrongExpression(f"there is no axis {number}")
    if what == "position":
        return axis.scale.position_to_user(axis.position(time))
    if what == "velocity":
        return axis.scale.to_user(axis.velocity(time), "uu/s")
    if what == "target":
        return axis.scale.position_to_user(axis.target)
    return float(axis.velocity(time) == 0.0 and controller.is_idle(number))


def of_machine(name: str) -> str | None:
    """Return the full name of an axis or a channel, such as "output 2", or None."""
    match = _OF_MACHINE.fullmatch(name)
    return None if match is None else f"{match[1].lower()} {int(match[2])}"


def present(machine: Machine, name: str) -> object:
    """Return a value that changes whenever the axis or channel with a name does.

    The result is None before the program uses the controller. An axis changes when a move enters or leaves its buffer,
    and with its target, its faults and whether it is on.
    """
    controller = machine.controller
    what, _, text = name.rpartition(" ")
    number = int(text)
    if what == "axis":
        axis = controller.axes.get(number)
        if axis is None:
            raise WrongExpression(f"there is no axis {number}")
        return axis.target, axis.enabled, axis.faults, len(axis.buffer)
    channels: dict[str, Channels] = {
        "input": controller.inputs, "analogue input": controller.analogue_inputs,
        "output": controller.outputs, "analogue output": controller.analogue_outputs,
    }  # fmt: skip
    with controller.reads.replaced():
        return channels[what][number]


def inputs(machine: Machine) -> list[Variable]:
    """Return the digital and analogue inputs that have had a value other than 0."""
    controller = machine.controller
    with controller.reads.replaced():
        digital = _channels("input", controller.inputs)
        return digital + _channels("analogue input", controller.analogue_inputs)


def outputs(machine: Machine) -> list[Variable]:
    """Return the digital and analogue outputs that have had a value other than 0."""
    controller = machine.controller
    digital = _channels("output", controller.outputs)
    return digital + _channels("analogue output", controller.analogue_outputs)


def _channels(what: str, values: Channels) -> list[Variable]:
    return [Variable(f"{what} {channel}", "", values[channel]) for channel in values.touched]
