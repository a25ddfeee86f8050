"""Position compare: an output that switches exactly as an axis passes a position."""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel.controller.triggers.position_zones import Cells
from motionlang.kernel.controller.watch import Watch
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.io_inputs import LAST_CHANNEL, checked
from motionlang.kernel.mint.runtime.binding import ByNumber, of, of_word, scale_of, unchecked
from motionlang.kernel.mint.runtime.environment import Environment

# COMPAREMODE, from memory. AT: the output turns on at position 0 and remains on. BETWEEN: it is on between
# positions 0 and 1.
AT, BETWEEN = 0, 1


class PositionCompare:
    """The position compare of one axis.

    `positions` are in counts. `output` is the output that it drives, -1 for none.
    """

    def __init__(self, environment: Environment, axis: int) -> None:
        self._environment, self._controller = environment, environment.controller
        self._axis = axis
        self.mode, self.output = AT, -1
        self.positions = [0.0, 0.0]
        self.enabled = self.passed = False
        self._cells: Cells | None = None
        self._watch: Watch | None = None

    def enable(self, enabled: bool) -> None:
        """Start comparing with the present positions, or stop."""
        self._forget()
        self.enabled = enabled
        if not enabled:
            return
        self.passed = False
        wrap_counts = self._wrap_counts()
        if self.mode == BETWEEN:
            self._cells = self._watched(self.positions, wrap_counts, self._moved)
            if self._cells.index % 2:
                self._inside(True)
        elif wrap_counts:
            self._cells = self._watched(self.positions[:1], wrap_counts, lambda _: self._inside(True))
        else:
            self._watch = self._controller.watch(self._axis, self.positions[0], lambda _: self._inside(True))

    def _wrap_counts(self) -> float:
        """Return the length of a wrap in counts, 0 if the axis does not wrap."""
        scale = self._controller.axes[self._axis].scale
        return abs(scale.to_counts(scale.wrap))

    def _watched(self, positions: list[float], wrap_counts: float, change: Callable[[int], None]) -> Cells:
        """Watch positions; on an axis that wraps, each of them recurs in every wrap."""
        track = self._controller.axes[self._axis]
        edges = [position % wrap_counts for position in positions] if wrap_counts else positions
        return Cells(track, sorted(edges), change, wrap_counts)

    def set(self, name: str, value: int) -> None:
        setattr(self, name, value)
        if self.enabled:
            self.enable(True)

    def set_position(self, register: int, position: float) -> None:
        """Set a position; an active compare uses it at once."""
        self.positions[register] = position
        if self.enabled:
            self.enable(True)

    def _moved(self, index: int) -> None:
        """Switch the output on between the positions, and off outside them.

        `index` is 0 below both positions, 1 between them and 2 above both. A new zero may skip a value.
        """
        self._inside(bool(index % 2))

    def _inside(self, inside: bool) -> None:
        self.passed = self.passed or inside
        if self.output >= 0:
            self._controller.set_output(self.output, int(inside))

    def _forget(self) -> None:
        if self._cells is not None:
            self._cells.remove()
        if self._watch is not None:
            self._controller.unwatch(self._axis, self._watch)
        self._cells = self._watch = None


class Compares:
    """The position compare of every axis, created on first use."""

    def __init__(self, environment: Environment) -> None:
        self.environment = environment
        self._compares = ByNumber(lambda axis: PositionCompare(environment, axis))

    def compare(self, axis: int) -> PositionCompare:
        return self._compares[axis]

    def of_output(self, output: int) -> list[PositionCompare]:
        """Return the position compares that drive an output."""
        checked(output, LAST_CHANNEL, "output")
        return [each for each in self._compares.values() if each.output == output]

    def default(self, axis: int) -> None:
        """Reset the axis to its defaults (DEFAULT)."""
        if axis in self._compares:
            self._compares.pop(axis).enable(False)


# ----------------------------------------------------------------------------------------------- operations


def read_setting(compares: Compares, row: Keyword, axis: int) -> int:
    value: int = getattr(compares.compare(axis), row.attribute)
    return value


def write_setting(compares: Compares, row: Keyword, axis: int, value: int) -> None:
    """COMPAREMODE and COMPAREOUTPUT: write a setting; restart an active compare."""
    compares.compare(axis).set(row.attribute, value)


def read_position(compares: Compares, axis: int, register: int) -> float:
    """COMPAREPOS: return a position in user units."""
    position = compares.compare(axis).positions[checked(register, 1, "compare register")]
    return scale_of(compares.environment, axis).position_to_user(position)


def write_position(compares: Compares, axis: int, register: int, value: float) -> None:
    """COMPAREPOS: set a position in user units; an active compare uses it at once."""
    checked(register, 1, "compare register")
    position = scale_of(compares.environment, axis).position_to_counts(value)
    compares.compare(axis).set_position(register, position)


def read_enable(compares: Compares, output: int) -> int:
    return int(any(each.enabled for each in compares.of_output(output)))


def write_enable(compares: Compares, output: int, enabled: int) -> None:
    """COMPAREENABLE: start or stop every compare that drives the output."""
    found = compares.of_output(output)
    if enabled and not found:
        what = f"output {output} is that of no position compare"
        raise Rejected("output", what, f"COMPAREOUTPUT(0) = {output} gives it to axis 0")
    for each in found:
        each.enable(bool(enabled))


# ------------------------------------------------------------------------------------------------- keywords


def _setting_of(attribute: str) -> Actions:
    return Actions(
        read=of_word(Compares, read_setting), write=of_word(Compares, write_setting), attribute=attribute
    )


def _set_passed(compares: Compares, axis: int, passed: int) -> None:
    compares.compare(axis).passed = bool(passed)


_PASSED = Actions(
    read=of(Compares, lambda compares, axis: int(compares.compare(axis).passed)),
    write=of(Compares, _set_passed),
)


def _compare(
    name: str, sets: str, help: str, low: float, high: float, default: float, selects: str = ""
) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", "integer", _setting_of(sets), help,
                   f"{name}(0) = 1\nPRINT {name}(0)", default=default, low=low, high=high, group="latches",
                   selects=selects)  # fmt: skip


ROWS = (
    _compare("COMPAREMODE", "mode",
             "0: the output comes on at position 0 and stays on; 1: it is on between positions 0 and 1.", 0, 1, 0.0),
    _compare("COMPAREOUTPUT", "output",
             "The output that the position compare of the axis switches; -1 for none.", -1, 999, -1.0,
             selects="output"),
    Keyword("COMPAREPOS", "", "setting", "RW", "axis, register", "uu",
            Actions(read=of(Compares, read_position), write=of(Compares, write_position)),
            "The positions with which the axis is compared: registers 0 and 1.",
            "COMPAREPOS(0, 1) = 25\nPRINT COMPAREPOS(0, 1)",
            default=0.0, low=-8388607.0, high=8388607.0, group="latches"),
    Keyword("COMPAREENABLE", "", "setting", "RW", "output", "bool",
            Actions(read=of(Compares, read_enable), write=unchecked(of(Compares, write_enable))),
            "State of position compare: 1 switches an output.",
            "COMPAREOUTPUT(0) = 2\nCOMPAREENABLE(2) = 1\nPRINT COMPAREENABLE(2)",
            default=0.0, low=0, high=1, group="latches"),
    Keyword("COMPARELATCH", "", "setting", "RW", "axis", "bool", _PASSED,
            "1 when the axis has been at a compare position since the compare was enabled, or since 0 was written.",
            "COMPARELATCH(0) = 0\nPRINT COMPARELATCH(0)", default=0.0, low=0, high=1, group="latches"),
)  # fmt: skip
