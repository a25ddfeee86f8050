"""The operator's input for INPUT."""

from __future__ import annotations

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.lang.machine.machine import CONSOLE
from motionlang.kernel.lang.machine.operator import Operator
from motionlang.kernel.lang.waits import Wait
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.functions import leading_number
from motionlang.kernel.tools import clipped

FOR_ANSWER = "for the operator to answer INPUT"


def wait_for_answer(environment: Environment, t: float, terminal: int = CONSOLE) -> Wait:
    """Return the wait for the next line.

    It never ends if no `[[answer]]` is left and there is no operator at the terminal.
    """
    machine = environment.machine
    operator = machine.operator_at(terminal)
    if terminal == CONSOLE and machine.ask is not None and not operator.has_answer():
        line = machine.ask()
        operator.lines += [] if line is None else [(line, "")]
    operator.asking = not operator.has_answer()
    if operator.asking and machine.stop is not None:
        machine.stop.asks()
    return Wait(t, lambda: _answered(operator), lambda: INFINITY, FOR_ANSWER, "operator")


def _answered(operator: Operator) -> bool:
    answered = operator.has_answer()
    if answered:
        operator.asking = False
    return answered


def take(environment: Environment, as_text: bool, terminal: int = CONSOLE, at: int = 0) -> float | str:
    """Take the next answer and echo it as on the operator's terminal.

    If a number is expected, return the number at the beginning of the answer, and warn, for the INPUT at the source
    offset `at`, of an answer that is none.
    """
    text = environment.machine.operator_at(terminal).take_answer()
    environment.machine.terminal_at(terminal).write(f"{text}\n")
    if as_text:
        return text
    number, rest = leading_number(text)
    if rest or not text.strip():
        line = 0 if environment.line_of is None else environment.line_of(at)
        message = f'the answer "{clipped(text)}" is not a number: INPUT takes {number:.10g}'
        hint = "type a number alone; a controller may ask again (mint.input)"
        environment.machine.complain(Diagnostic("not-a-number", message, line, hint=hint, severity="warning"))
    return number
