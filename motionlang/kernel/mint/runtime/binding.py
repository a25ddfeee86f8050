"""Operations: the rows of keywords bound to the functions that carry them out.

Problem. `MOVER(0) = n` is a row of a table (name, unit, range, functions) and a step of a program. Between the two
lie the axis, the unit, the range, the line and the time. Nearly all of this is known when the program starts, and a
statement may run millions of times.

Idea. Everything that is known at the start is bound at the start. A maker takes the environment of the program and the
row. It returns the operation: a function whose arguments are only known when the statement runs.

    at the start     row of MOVER ─▶ its maker for "load" ─▶ operation, bound to axis 0
    in a step        operation(n, 3)                with the value of n and the line

A keyword has four uses: "read", "write", "load" (a move into the buffer) and "do" (a command). A row has a maker for
each of its uses in `actions`. If it has none, its `function` names a setting or a reading of the controller, which is
converted by the row's unit. The arguments of an operation are the indices, then the value, then the line (for moves and
commands of axes). A "load" returns true while the buffer has no space. The steps (`steps/keywords.py`) add the time.

    of, of_word               make a function of a component of the environment; `of_word` also passes the row
    by_axis, to_each_axis     make an operation bound to one axis, once for each (`ByNumber`)
    on_axes, on_every_axis    make an operation that acts on each of several axes
    unchecked                 marks a write that takes any number, or checks the range itself
    repeatable                marks a write that is a no-op if the value is there already, as `replaced` reads it
    reported                  marks a repeatable write that itself returns true if it has changed anything

Invariants.
- An operation on an axis is bound to one that exists (`axis_of`). A written value lies in the range of its row. At run
  time that is checked here and nowhere else; NaN is outside every range.
- If the text gives the number of an axis, the operation is bound at the start; for a computed axis, at its first use.
- A polling loop that writes a repeatable keyword has done nothing if that changed no value and scheduled no event.

Cost. Binding happens once for each keyword, axis and use. A call costs one Python function, and a write with a range
one comparison more.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TypeVar

from motionlang.kernel.controller.scale import Scale
from motionlang.kernel.controller.settings import SETTINGS
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment

Made = TypeVar("Made")

Operation = Callable[..., object]
Maker = Callable[["Environment", "Keyword"], Operation]
# Binds an operation to an axis.
Bound = Callable[["Environment", "Keyword"], Callable[[int], Operation]]

# Factors from the controller's seconds and fractions to the unit of a setting.
_TIMES = {"ms": 1000.0, "%": 100.0}


def row_of(name: str) -> Keyword:
    row = table().get(name)
    assert row is not None, name
    return row


def check(row: Keyword, value: float) -> None:
    """Raise Rejected if a value is outside the row's range."""
    refusal = row.refusal(value)
    if refusal is not None:
        raise Rejected("range", *refusal)


class ByNumber(dict[int, "Made"]):
    """Objects by axis or channel number, created on first use."""

    def __init__(self, make: Callable[[int], Made]) -> None:
        self._make = make

    def __missing__(self, number: int) -> Made:
        made = self[number] = self._make(number)
        return made


def by_axis(make: Callable[[Environment, Keyword, int], Operation]) -> Maker:
    """Return a maker of operations bound to an axis, each cached for its axis."""
    return to_each_axis(
        lambda environment, row: lambda axis: make(environment, row, axis_of(environment, axis))
    )


def of(kind: type, function: Operation) -> Maker:
    """Return a maker that binds a function to the environment or a component of it.

    The function receives this as its first argument. If the first index is an axis, the axis exists.
    """
    return _made(lambda environment, row: partial(function, environment.component(kind)))


def of_word(kind: type, function: Operation) -> Maker:
    """Return a maker like `of`, for a function that also receives the row.

    The row comes after the component.
    """
    return _made(lambda environment, row: partial(function, environment.component(kind), row))


def _made(make: Maker) -> Maker:
    def bound(environment: Environment, row: Keyword) -> Callable[[int], Operation]:
        operation = make(environment, row)
        return lambda axis: partial(operation, axis_of(environment, axis))

    to_each = to_each_axis(bound)

    def made(environment: Environment, row: Keyword) -> Operation:
        return (to_each if row.index.startswith("axis") else make)(environment, row)

    made.by_axis = bound  # type: ignore[attr-defined]
    return made


def to_each_axis(bound: Bound) -> Maker:
    """Return a maker of an operation per axis.

    `bound` returns the function that makes the operation of one axis.
    """

    def made(environment: Environment, row: Keyword) -> Operation:
        each = ByNumber(bound(environment, row))
        return lambda axis, *more: each[axis](*more)

    made.by_axis = bound  # type: ignore[attr-defined]
    return made


def on_axes(act: Callable[[Environment, int], None]) -> Maker:
    """Return a maker of an operation that acts on each given axis; all must exist."""

    def made(environment: Environment, row: Keyword) -> Operation:
        def do(axes: tuple[int, ...], line: int) -> None:
            for axis in [axis_of(environment, axis) for axis in axes]:
                act(environment, axis)

        return do

    return made


def on_every_axis(act: Callable[[Environment, int], None]) -> Maker:
    """Return a maker of an operation that acts on every axis."""

    def made(environment: Environment, row: Keyword) -> Operation:
        def do(*line: int) -> None:
            for axis in environment.controller.axes:
                act(environment, axis)

        return do

    return made


def unchecked(make: Maker) -> Maker:
    """Mark the maker of a write that accepts any number, or checks the range itself."""
    make.unchecked = True  # type: ignore[attr-defined]
    return make


def bind(environment: Environment, how: str, row: Keyword) -> Operation:
    """Return the operation of a keyword; `how` is "read", "write", "load" or "do"."""
    maker = maker_of(how, row)
    operation = maker(environment, row)
    return _in_range(row, operation, _brackets(row)) if _is_checked(how, row, maker) else operation


def bind_to_axis(environment: Environment, how: str, row: Keyword) -> Callable[[int], Operation]:
    """Return a function that makes the operation of a keyword on an axis.

    The operation is called without the axis number.
    """
    maker = maker_of(how, row)
    bound = _to_axis(environment, row, maker)
    return (lambda axis: _in_range(row, bound(axis), 0)) if _is_checked(how, row, maker) else bound


def _is_checked(how: str, row: Keyword, maker: Maker) -> bool:
    return how == "write" and not (row.low is row.high is None or hasattr(maker, "unchecked"))


def _in_range(row: Keyword, write: Operation, index: int) -> Operation:
    """Return a write that raises Rejected for a value outside the row's range.

    `index` is the position of the value among the arguments.
    """
    low, high = row.limits

    def checked(*given: float) -> None:
        if not low <= given[index] <= high:
            check(row, given[index])
        write(*given)

    return checked


def _brackets(row: Keyword) -> int:
    """Return the number of indices of a keyword."""
    return 0 if row.index == "none" else row.index.count(",") + 1


def replaced(environment: Environment, row: Keyword) -> Operation:
    """Return an operation that reads the present value of a keyword before a write.

    It receives the same arguments as the write. It reads the keyword with the same indices, unless the row has an
    action of its own for this (`replaced`).
    """
    maker: Maker | None = row.actions.replaced
    if maker is not None:
        return maker(environment, row)
    read = bind(environment, "read", row)
    count = _brackets(row)
    return lambda *given: read(*given[:count])


def replaced_by_axis(environment: Environment, row: Keyword) -> Callable[[int], Operation]:
    """Return a function that makes the operation `replaced` of a keyword on an axis."""
    maker = row.actions.replaced
    if maker is not None:
        return _to_axis(environment, row, maker)
    to_axis = bind_to_axis(environment, "read", row)

    def bound(axis: int) -> Operation:
        read = to_axis(axis)
        return lambda *given: read()

    return bound


def _to_axis(environment: Environment, row: Keyword, maker: Maker) -> Callable[[int], Operation]:
    bound: Bound | None = getattr(maker, "by_axis", None)
    if bound is not None:
        return bound(environment, row)
    operation = maker(environment, row)
    return lambda axis: partial(operation, axis)


def maker_of(how: str, row: Keyword) -> Maker:
    """Return the maker of a keyword's operation.

    It is an action of its row, or the maker for a setting or reading of the controller.
    """
    maker: Maker | None = getattr(row.actions, how)
    if maker is not None:
        return maker
    if row.function in SETTINGS:
        return _read_setting if how == "read" else _write_setting
    assert how == "read", (how, row.function)
    return _reading


def is_repeatable(how: str, row: Keyword) -> bool:
    """True if writing or executing a keyword may change nothing."""
    return hasattr(maker_of(how, row), "repeatable")


def is_reported(how: str, row: Keyword) -> bool:
    """True if writing a keyword returns whether it has changed anything."""
    return hasattr(maker_of(how, row), "reported")


def scale_of(environment: Environment, axis: int) -> Scale:
    """Return the scale of an axis; raise Rejected if the axis does not exist."""
    try:
        return environment.controller.axes[axis].scale
    except KeyError:
        raise no_axis(environment, axis) from None


def axis_of(environment: Environment, axis: int) -> int:
    """Return the axis; raise Rejected if it does not exist."""
    scale_of(environment, axis)
    return axis


def no_axis(environment: Environment, axis: int) -> Rejected:
    last = list(environment.controller.axes)[-1]
    hint = f"this controller has axes 0 to {last}; controller.axes sets their number"
    return Rejected("axis", f"there is no axis {axis}", hint)


@unchecked
@repeatable
@by_axis
def _write_setting(environment: Environment, row: Keyword, axis: int) -> Operation:
    write = environment.controller.writer(row.function, axis, row.unit)
    low, high = row.limits
    times = _TIMES.get(row.unit)

    def checked(value: float) -> None:
        if not low <= value <= high:
            check(row, value)
        write(value / times if times else value)

    return checked


@by_axis
def _read_setting(environment: Environment, row: Keyword, axis: int) -> Operation:
    times = _TIMES.get(row.unit)
    if times is None and row.is_whole:
        setting = environment.controller.reader(row.function, axis)
        return lambda: int(setting())
    read = environment.controller.reader(row.function, axis, row.unit)
    if times is None:
        return read
    return (lambda: round(read() * times)) if row.unit == "ms" else lambda: times * read()


@by_axis
def _reading(environment: Environment, row: Keyword, axis: int) -> Operation:
    """Return the operation that reads a quantity of an axis from the controller."""
    if row.is_whole:
        function = environment.controller.reader(row.function, axis)
        return lambda: int(function())
    return environment.controller.reader(row.function, axis, row.unit, environment)
