"""MCCL commands for calls, built without text."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import accumulate

from motionlang.kernel import Keyword
from motionlang.kernel.mccl import NONE, NUMBER, Action, Command, Fault, Line, Model, checked, codes, table


def command(name: str, axis: int = 0, value: float | int | None = None) -> Command:
    """Return a command that is ready to run; raise Fault if it rejects the value."""
    row = _row(name)
    action = row.actions.do
    assert action is not None
    head = f"{axis}{name}" if axis else name
    pure = hasattr(action, "pure")
    if value is None:
        return Command(head, name, row, axis, NONE, 0, action, pure)
    return Command(head + number(value), name, row, axis, NUMBER, checked(value, row), action, pure)


def _row(name: str) -> Keyword:
    row = table().get(name)
    assert row is not None, name
    return row


def own(name: str, action: Action) -> Command:
    """Return a step of a call that no command of MCCL performs, or not in this manner."""
    return Command(name, name, table().get(name), 0, NONE, 0, action, True)


def line(commands: Iterable[Command]) -> Line:
    """Return commands as a line, with their joined text."""
    found = tuple(commands)
    text = ",".join(each.text for each in found)
    return Line(
        found,
        0,
        text,
        tuple(accumulate((len(each.text) + 1 for each in found[:-1]), initial=0)) if found else (),
    )


def number(value: float | int) -> str:
    """Return a number as text that MCCL reads back exactly."""
    whole = isinstance(value, int) or (value == int(value) and abs(value) < 1e15)
    return str(int(value)) if whole else repr(value)


def lacks(model: Model, name: str) -> bool:
    """True if a model does not have a command."""
    return _row(name).family in model.lacks


def takes_all_axes(name: str) -> bool:
    """True if a command without an axis means all of them."""
    return _row(name).index == "axes"


def out_of_range(what: str) -> Fault:
    """Return the fault of an argument that is out of range."""
    return Fault(codes.PARAMETER, what, kind="range")
