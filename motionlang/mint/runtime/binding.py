"""Keyword rows bound to the controller's verbs: the only place where user units of Mint become counts.

A row's `verb` is a setting of the controller, converted by its unit, or one of the operations written out below. A
new keyword needs a row and, if its verb is new, one function here: `_read_…`, `_write_…`, `_load_…` or `_do_…` and
the verb. A verb with a dot names its module: "io.inputs.bit" is `read_bit` and the like of
`motionlang.mint.keywords.io_inputs`, "homing.home" stands in `homing_operations`; only programs that use a module
import it. What an operation's maker returns is called with the indices, then the value, then (moves, commands of axes,
the whole group "motion") the line of the statement.
`_load_…` answers true while there is no room and the statement must wait.
"""

from __future__ import annotations

from motionlang.controller.controller import SETTINGS
from motionlang.controller.faults import Refusal
from motionlang.mint.runtime.changes import Changes, comparable, note, repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.scale import Scale
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]


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
    place, _, verb = row.verb.rpartition(".")
    if place:
        made: Operation = getattr(module_of(place), f"{how}_{verb}")(environment, row)
        return made
    special = globals().get(f"_{how}_{row.verb}")
    if special is None and row.verb not in SETTINGS:
        from motionlang.mint.runtime import binding_program

        special = getattr(binding_program, f"_{how}_{row.verb}", None)
    if special is not None:
        operation: Operation = special(environment, row)
        return operation
    if row.verb in SETTINGS:
        return (_read_setting if how == "read" else _write_setting)(environment, row)
    assert how == "read", (how, row.verb)
    return _reading(environment, row)


def held(environment: Environment, row: Row) -> Operation:
    """What a keyword holds where a writing puts its value, called with all that the writing is.

    That is what its reading finds by the indices, unless its module has a `held_…` of its own.
    """
    place, _, verb = row.verb.rpartition(".")
    special = getattr(module_of(place), f"held_{verb}", None) if place else None
    if special is not None:
        operation: Operation = special(environment, row)
        return operation
    read = bind(environment, "read", row)
    count = 0 if row.index == "none" else row.index.count(",") + 1
    return lambda *given: read(*given[:count])


def module_of(place: str) -> object:
    name = place.replace(".", "_") if "." in place else f"{place}_operations"
    return __import__(f"motionlang.mint.keywords.{name}", fromlist=[""])


def scale_of(environment: Environment, axis: int) -> Scale:
    """The scale of an axis, or the refusal of an axis that does not exist."""
    try:
        return environment.controller.axes[axis].scale
    except KeyError:
        raise no_axis(environment, axis) from None


def no_axis(environment: Environment, axis: int) -> Refusal:
    axes = list(environment.controller.axes)
    return Refusal("axis", f"there is no axis {axis}", f"this controller has axes {axes[0]} to {axes[-1]}")


# ------------------------------------------------------------------------------------------------- settings


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


def _write_buffer_size(environment: Environment, row: Row) -> Operation:
    def write(axis: int, value: int) -> None:
        row.check(value)
        scale_of(environment, axis)
        a = environment.controller.axes[axis]
        if a.move is not None or a.buffer:
            words = f"the move buffer of axis {axis} is in use"
            raise Refusal("buffer-in-use", words, f"PAUSE IDLE({axis}) waits until it is empty")
        environment.controller.configure(axis, "buffer_size", value)

    return write


def _time_setting(environment: Environment, row: Row, rate: str) -> Operation:
    """Reads a ramp's time in ms, also when a rate was written."""
    setting = environment.controller.setting

    def read(axis: int) -> int:
        scale_of(environment, axis)
        seconds = setting(axis, row.verb)
        if seconds is None:
            seconds = float(setting(axis, "speed")) / float(setting(axis, rate))  # type: ignore[arg-type]
        return round(float(seconds) * 1000.0)

    return read


def _read_accel_time(environment: Environment, row: Row) -> Operation:
    return _time_setting(environment, row, "accel")


def _read_decel_time(environment: Environment, row: Row) -> Operation:
    return _time_setting(environment, row, "decel")


def _rate_setting(environment: Environment, row: Row, time: str) -> Operation:
    """Reads a rate, also when a time was written."""
    setting = environment.controller.setting

    def read(axis: int) -> float:
        scale = scale_of(environment, axis)
        seconds = setting(axis, time)
        rate = setting(axis, row.verb) if seconds is None else float(setting(axis, "speed")) / float(seconds)  # type: ignore[arg-type]
        return scale.to_user(float(rate), row.unit)  # type: ignore[arg-type]

    return read


def _read_accel(environment: Environment, row: Row) -> Operation:
    return _rate_setting(environment, row, "accel_time")


def _read_decel(environment: Environment, row: Row) -> Operation:
    return _rate_setting(environment, row, "decel_time")


def _write_scale(environment: Environment, row: Row) -> Operation:
    """Settings keep their values in counts, as the controller does: set the scale first."""

    def write(axis: int, value: float) -> None:
        row.check(value)
        scale_of(environment, axis)
        environment.controller.set_scale(axis, value)

    return write


def _read_scale(environment: Environment, row: Row) -> Operation:
    return lambda axis: float(scale_of(environment, axis).counts)


@repeatable
def _write_profile_mode(environment: Environment, row: Row) -> Operation:
    configure = environment.controller.configure

    def write(axis: int, value: int) -> None:
        row.check(value)
        scale_of(environment, axis)
        configure(axis, "shape", "scurve" if value == 1 else "trapezoid")

    return write


def _read_profile_mode(environment: Environment, row: Row) -> Operation:
    def read(axis: int) -> int:
        scale_of(environment, axis)
        return int(environment.controller.setting(axis, "shape") == "scurve")

    return read


@repeatable
def _write_enabled(environment: Environment, row: Row) -> Operation:
    controller = environment.controller

    def write(axis: int, value: int) -> None:
        scale_of(environment, axis)
        (controller.enable if value else controller.disable)(axis)

    return write


def _read_enabled(environment: Environment, row: Row) -> Operation:
    def read(axis: int) -> int:
        scale_of(environment, axis)
        return int(environment.controller.is_enabled(axis))

    return read


# ------------------------------------------------------------------------------------------------- readings


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


def _read_remaining(environment: Environment, row: Row) -> Operation:
    remaining = environment.controller.remaining

    def read(axis: int) -> float:
        return scale_of(environment, axis).to_user(float(remaining(axis)), row.unit)

    return comparable(environment, read, environment.part(Changes).remaining)


def _read_is_idle(environment: Environment, row: Row) -> Operation:
    is_idle = environment.controller.is_idle

    def read(axis: int) -> int:
        scale_of(environment, axis)
        return int(is_idle(axis) and (environment.settled is None or environment.settled(axis)))

    return read


def _read_position(environment: Environment, row: Row) -> Operation:
    return _wrapped(environment, environment.controller.position, environment.part(Changes).position)


def _read_demand(environment: Environment, row: Row) -> Operation:
    return _wrapped(environment, environment.controller.demand, environment.part(Changes).demand)


def _wrapped(
    environment: Environment, position: Callable[[int], float], until: Callable[[int, float], float]
) -> Operation:
    """Reads a position in user units, within the turn where the axis has one; may be told what it is compared with."""
    wraps, attention, moving = environment.wraps, environment.attention, environment.part(Changes).moving

    def read(axis: int, level: float | None = None) -> float:
        if attention.notes is not None:
            note(attention, moving, until, axis, level)
        found = scale_of(environment, axis).position_to_user(position(axis))
        wrap = wraps.get(axis)
        return found % wrap if wrap else found

    return read


def _write_position(environment: Environment, row: Row) -> Operation:
    def write(axis: int, value: float) -> None:
        counts = scale_of(environment, axis).position_to_counts(value)
        if not -1e300 < counts < 1e300:
            raise Refusal("range", f"{row.name} cannot be {value:g}", "a position is finite, in counts too")
        environment.controller.define_position(axis, counts)

    return write


# ---------------------------------------------------------------------------------------------------- moves


def _load_load_by(environment: Environment, row: Row) -> Operation:
    """Answers true while the buffer is full."""
    room, load = environment.controller.room, environment.controller.load_by

    def by(axis: int, value: float, line: int) -> bool:
        scale = scale_of(environment, axis)
        finite(row, value)
        refuse_stopping(environment, axis)
        if room(axis) <= 0:
            return True
        load(axis, value * scale.counts, row.name, line)
        if environment.loaded is not None:
            environment.loaded(axis)
        return False

    return by


def _load_load_to(environment: Environment, row: Row) -> Operation:
    """Answers true while the buffer is full."""
    room, load = environment.controller.room, environment.controller.load_to

    def to(axis: int, value: float, line: int) -> bool:
        scale = scale_of(environment, axis)
        finite(row, value)
        refuse_stopping(environment, axis)
        if room(axis) <= 0:
            return True
        load(axis, scale.position_to_counts(value + environment.turn(axis)), row.name, line)
        if environment.loaded is not None:
            environment.loaded(axis)
        return False

    return to


def refuse_stopping(environment: Environment, axis: int) -> None:
    """An axis that is coming to rest takes no move: Mint's error 236."""
    move = environment.controller.axes[axis].move
    if move is not None and move.ended in ("stop", "fault"):
        raise Refusal("stopping", f"axis {axis} is stopping", f"PAUSE IDLE({axis}) waits until it stands")


def finite(row: Row, value: float) -> None:
    """Refuse a distance without an end."""
    if not -1e300 < value < 1e300:
        raise Refusal("range", f"{row.name} cannot be {value:g}", "a move needs a finite distance")


def _do_go(environment: Environment, row: Row) -> Operation:
    def go(axes: tuple[int, ...], line: int) -> None:
        for axis in axes:
            scale_of(environment, axis)
        environment.controller.go(axes)

    return go


def _each_axis(environment: Environment, act: Callable[[int], None]) -> Operation:
    def do(axes: tuple[int, ...], line: int) -> None:
        for axis in axes:
            scale_of(environment, axis)
        for axis in axes:
            act(axis)

    return do


def _cancel(environment: Environment) -> Callable[[int], None]:
    def cancel(axis: int) -> None:
        environment.controller.abort(axis)
        environment.controller.clear_faults(axis)

    return cancel


def _do_cancel(environment: Environment, row: Row) -> Operation:
    return _each_axis(environment, _cancel(environment))


def _do_cancel_all(environment: Environment, row: Row) -> Operation:
    cancel = _cancel(environment)

    def do(line: int) -> None:
        for axis in environment.controller.axes:
            cancel(axis)

    return do


# ----------------------------------------------------------------------------------------------------- time


def _read_time(environment: Environment, row: Row) -> Operation:
    return lambda level=None: environment.elapsed(environment.task.timer[0], level)


def _write_time(environment: Environment, row: Row) -> Operation:
    def write(value: int) -> None:
        environment.task.timer[0] = environment.since(value)

    return write


def _do_default_axes(environment: Environment, row: Row) -> Operation:
    def do(axes: tuple[int, ...], line: int) -> None:
        for axis in axes:
            scale_of(environment, axis)
        environment.task.axes = axes

    return do
