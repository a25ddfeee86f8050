"""What the operator types at INPUT."""

from __future__ import annotations

from motionlang.lang.machine.machine import CONSOLE
from motionlang.lang.task import Wait
from motionlang.mint.runtime.environment import INFINITY
from motionlang.mint.runtime.functions import value

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.machine.operator import Operator
    from motionlang.mint.runtime.environment import Environment


def wait_for_answer(environment: Environment, t: float, terminal: int = CONSOLE) -> Wait:
    """Wait for the next line; where no `[[answer]]` is left and nobody sits at the terminal, for ever."""
    machine = environment.machine
    operator = machine.operator_at(terminal)
    if not operator.lines and terminal == CONSOLE and machine.ask is not None:
        line = machine.ask()
        operator.lines += [] if line is None else [line]
    operator.asking = not operator.lines
    return Wait(
        t, lambda: _answered(operator), lambda: INFINITY, "for the operator to answer INPUT", "operator"
    )


def _answered(operator: Operator) -> bool:
    if operator.lines:
        operator.asking = False
    return bool(operator.lines)


def take(environment: Environment, as_text: bool, terminal: int = CONSOLE) -> float | str:
    """The next answer, shown as the operator would have seen it; as a number, what it begins with."""
    text = environment.machine.operator_at(terminal).lines.pop(0)
    environment.machine.terminal_at(terminal).write(f"{text}\n")
    if as_text:
        return text

    return value(text)
