"""Expressions over the state at a stop: conditions, log points, watches (`commands/expressions.py`).

Registers of MCCL are R10 or @10. `position(0)`, `velocity(0)`, `target(0)`, `idle(0)`, `input(5)`, `output(5)` and
`time` read the machine at the time of the stop; POS, VEL, IDLE, IN, INX, OUT and OUTX are synonyms. Other keywords are
rejected, because reading some of them has an effect.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial
from typing import Protocol

from motionlang.commands import expressions
from motionlang.commands.expressions import Value, WrongExpression
from motionlang.kernel.tools import nearest

__all__ = ["READINGS", "Expression", "ExpressionState", "WrongExpression", "assignment", "parse"]


class ExpressionState(Protocol):
    """The state that an expression reads."""

    def variable(self, name: str, subscripts: list[float]) -> Value | None:
        """Return the value of a variable or an element; None if there is no such variable."""

    def reading(self, what: str, number: int) -> float:
        """Return a reading of an axis or a channel; ValueError if that does not exist."""


Expression = Callable[[ExpressionState], Value]

READINGS = {
    "position": "position", "pos": "position", "velocity": "velocity", "vel": "velocity", "target": "target",
    "idle": "idle", "input": "input", "in": "input", "inx": "input", "output": "output", "out": "output",
    "outx": "output",
}  # fmt: skip
# A variable, a register or an element, and its new value; == compares.
_ASSIGNMENT = re.compile(r"\s*(@?\w+(?:\([\d, ]+\))?)\s*=(?!=)\s*(.+)")


def assignment(text: str) -> tuple[str, str] | None:
    """Return the name and the expression of a typed assignment, None if it is none."""
    match = _ASSIGNMENT.fullmatch(text)
    return None if match is None else (match[1], match[2])


def parse(text: str) -> Expression:
    """Parse an expression; raise WrongExpression if it is invalid."""
    found = expressions.Expression(text, "position(0) > 120")
    return lambda state: found.value(partial(_named, state))


def _named(state: ExpressionState, name: str, arguments: list[Value]) -> Value:
    name, dot, axis = (f"R{name[1:]}" if name[0] == "@" else name).partition(".")  # POS.1
    if dot:
        arguments = [float(axis) if axis.isdecimal() else _named(state, axis, [])]
    if any(isinstance(each, str) for each in arguments):
        raise WrongExpression(f"{name} needs numbers in brackets")
    found = state.variable(name, arguments)  # type: ignore[arg-type]
    if found is not None:
        return found
    reading = READINGS.get(name.lower())
    if reading is not None and len(arguments) == 1:
        return state.reading(reading, int(arguments[0]))
    if name.lower() == "time" and not arguments:
        return state.reading("time", 0)
    if reading is not None:
        raise WrongExpression(f"{name} needs one number in brackets")
    near = nearest(name, READINGS)
    hint = f"; did you mean {near}?" if near else ""
    raise WrongExpression(f"{name} is neither a variable here nor a reading that a condition may use{hint}")
