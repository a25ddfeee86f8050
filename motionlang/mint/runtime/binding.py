"""Keyword rows bound to what they do: the mechanism, and what a setting or a reading of the controller does.

A row's `verb` is a setting of the controller or one of its readings, converted by the row's unit, or it stands in the
dictionary `OPERATIONS` of a module beside the rows, which names what makes the operation: of a value that is read,
written or put into the move buffer ("load"), and of a command ("do"). `operations_index` says which module that is;
only programs that use it import it. What the maker returns is called with the indices, then the value, then (moves,
commands of axes, the whole group "motion") the line of the statement. One for "load" answers true while there is no
room and the statement must wait.
"""

from __future__ import annotations

from motionlang.controller.controller import SETTINGS
from motionlang.controller.faults import Refusal
from motionlang.mint.keywords.operations_index import VERBS
from motionlang.mint.runtime.changes import Changes, repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from motionlang.controller.scale import Scale
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]
    Maker = Callable[["Environment", "Row"], Operation]

_MODULES = {verb: name for name, verbs in VERBS.items() for verb in verbs.split()}


class Row:
    """What is left of a keyword's row in a compiled program."""

    __slots__ = ("high", "index", "low", "name", "unit", "verb")

    def __init__(
        self, verb: str, name: str, unit: str, index: str, low: float | None, high: float | None
    ) -> None:
        self.verb, self.name, self.unit, self.index, self.low, self.high = verb, name, unit, index, low, high

    def check(self, value: float) -> None:
        """Refuse a value outside the row's range; NaN is outside every range."""
        low, high = self.low, self.high
        if (low is not None and not value >= low) or (high is not None and not value <= high):
            limits = f"it takes {low:.10g} to {high:.10g}" if low is not None and high is not None else ""
            raise Refusal("range", f"{self.name} cannot be {value:g}", limits)


def bind(environment: Environment, how: str, row: Row) -> Operation:
    """The operation of a keyword: `how` is "read", "write", "load" or "do"."""
    maker = makers(row.verb).get(how)
    if maker is None:
        if row.verb in SETTINGS:
            maker = _read_setting if how == "read" else _write_setting
        else:
            assert how == "read", (how, row.verb)
            maker = _reading
    return maker(environment, row)


def held(environment: Environment, row: Row) -> Operation:
    """What a keyword holds where a writing puts its value, called with all that the writing is.

    That is what its reading finds by the indices, unless its verb has an operation "held".
    """
    maker = makers(row.verb).get("held")
    if maker is not None:
        return maker(environment, row)
    read = bind(environment, "read", row)
    count = 0 if row.index == "none" else row.index.count(",") + 1
    return lambda *given: read(*given[:count])


def makers(verb: str) -> Mapping[str, Maker]:
    """What makes the operations of a verb; nothing where the controller's setting or reading is all there is."""
    name = _MODULES.get(verb)
    if name is None:
        return {}
    found: Mapping[str, Maker] = operations_module(name).OPERATIONS[verb]  # type: ignore[attr-defined]
    return found


def operations_module(name: str) -> object:
    """A module of operations, imported at its first use."""
    return __import__(f"motionlang.mint.keywords.{name}", fromlist=["OPERATIONS"])


def scale_of(environment: Environment, axis: int) -> Scale:
    """The scale of an axis, or the refusal of an axis that does not exist."""
    try:
        return environment.controller.axes[axis].scale
    except KeyError:
        raise no_axis(environment, axis) from None


def axis_of(environment: Environment, axis: int) -> int:
    """The axis, or the refusal of one that does not exist."""
    scale_of(environment, axis)
    return axis


def no_axis(environment: Environment, axis: int) -> Refusal:
    axes = list(environment.controller.axes)
    return Refusal("axis", f"there is no axis {axis}", f"this controller has axes {axes[0]} to {axes[-1]}")


@repeatable
def _write_setting(environment: Environment, row: Row) -> Operation:
    configure, name, unit = environment.controller.configure, row.verb, row.unit

    def write(axis: int, value: float) -> None:
        row.check(value)
        scale = scale_of(environment, axis)
        configure(axis, name, value / 1000.0 if unit == "ms" else scale.to_counts(value, unit))

    return write


def _read_setting(environment: Environment, row: Row) -> Operation:
    setting, name, unit = environment.controller.setting, row.verb, row.unit

    def read(axis: int) -> float:
        scale = scale_of(environment, axis)
        value: float = setting(axis, name)  # type: ignore[assignment]
        if unit in ("integer", "bool"):
            return int(value)
        return scale.to_user(float(value), unit)

    return read


def _reading(environment: Environment, row: Row) -> Operation:
    """A verb of the controller that takes an axis and answers in counts."""
    verb, unit = getattr(environment.controller, row.verb), row.unit
    if unit in ("integer", "bool", "bits"):

        def whole(axis: int) -> int:
            scale_of(environment, axis)
            return int(verb(axis))

        return whole
    attention, moving = environment.attention, environment.part(Changes).moving

    def read(axis: int) -> float:
        if attention.notes is not None:
            attention.note(moving)
        scale = scale_of(environment, axis)
        return scale.to_user(float(verb(axis)), unit)

    return read
