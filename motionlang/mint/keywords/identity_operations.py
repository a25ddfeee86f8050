"""What the virtual controller answers about itself, unless the machine file says it."""

from __future__ import annotations

from motionlang.mint.keywords.identity import AXES
from motionlang.mint.keywords.no_effect_operations import Kept
from motionlang.mint.runtime.binding import axis_of
from motionlang.mint.runtime.changes import always

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment

# What the library of WorkBench calls its own simulated controller.
VIRTUAL = "Virtual Controller"
_POWER_UP = "2000-01-01 00:00:00"
_DATE = "%Y-%m-%d %H:%M:%S"


def _answer(environment: Environment, row: Row, known: Operation) -> Operation:
    """What the machine file says, or what this program knows; the axis, where there is one, must exist."""
    kept, of_axis = environment.part(Kept), row.index == "axis"

    def read(*where: int) -> object:
        if of_axis:
            axis_of(environment, where[0])
        told = kept.told.find(row.name, row.unit, where)
        return known(*where) if told is None else told

    return read


def read_platform(environment: Environment, row: Row) -> Operation:
    return _answer(environment, row, lambda: environment.machine.model or VIRTUAL)


def read_version(environment: Environment, row: Row) -> Operation:
    from motionlang import __version__

    return _answer(environment, row, lambda: f"motionlang {__version__}")


def read_count(environment: Environment, row: Row) -> Operation:
    """NUMBEROF: the axes; of other items what the machine file says, else the run ends."""
    axes = environment.controller.axes

    def count(item: int) -> int:
        if item == AXES:
            return len(axes)
        from motionlang.lang.run_errors import NotSimulated

        words = f"how many there are of item {item} is not known here"
        raise NotSimulated(
            words, f'the machine file can say it: [mint.readings] NUMBEROF = {{ "{item}" = 8 }}'
        )

    return _answer(environment, row, count)


def read_local(environment: Environment, row: Row) -> Operation:
    return _answer(environment, row, lambda *where: 0)


read_nothing_wrong = read_local


def write_nothing_wrong(environment: Environment, row: Row) -> Operation:
    """What is not there needs no clearing."""
    return lambda *given: None


def read_fit(environment: Environment, row: Row) -> Operation:
    return _answer(environment, row, lambda *where: 1)


read_fit_axis = read_fit


def read_takes_moves(environment: Environment, row: Row) -> Operation:
    """OKTOLOADMOVE: 1 where every axis of the array could take a move into its buffer now."""
    controller = environment.controller

    def takes(axis: int) -> bool:
        a = controller.axes[axis_of(environment, axis)]
        stopping = a.move is not None and a.move.ended in ("stop", "fault")
        return controller.is_enabled(axis) and not a.faults and not stopping and controller.room(axis) > 0

    def read(count: int, axes: Sequence[int]) -> int:
        return int(all(takes(int(axis)) for axis in (axes or [])[1 : count + 1]))

    return read


# --------------------------------------------------------------------------------------------- date and time


class Calendar:
    """Date and time at a moment of machine time; both from the machine file or the program."""

    def __init__(self, environment: Environment) -> None:
        told = environment.part(Kept).told.find("REALTIMECLOCK", "text", ())
        self.clock = environment.clock
        self.set(str(told) if told is not None else _POWER_UP, 0.0)

    def set(self, text: str, now: float) -> None:
        """Refuses what is no date."""
        from datetime import datetime

        from motionlang.controller.faults import Refusal

        try:
            self.date = datetime.strptime(text, _DATE)
        except ValueError:
            raise Refusal(
                "range", f"REALTIMECLOCK cannot be {text!r}", f'it takes a text like "{_POWER_UP}"'
            ) from None
        self.since = now

    def text(self) -> str:
        """Whole seconds."""
        from datetime import timedelta

        try:
            return (self.date + timedelta(seconds=int(self.clock.now - self.since + 1e-9))).strftime(_DATE)
        except OverflowError:
            return self.date.strftime(_DATE)


@always
def read_date(environment: Environment, row: Row) -> Operation:
    return environment.part(Calendar).text


def write_date(environment: Environment, row: Row) -> Operation:
    calendar = environment.part(Calendar)
    return lambda text: calendar.set(text, environment.clock.now)


# -------------------------------------------------------------------------------------------------- nothing


def do_nothing(environment: Environment, row: Row) -> Operation:
    return lambda *given: None


OPERATIONS = {
    "identity.platform": {"read": read_platform},
    "identity.version": {"read": read_version},
    "identity.count": {"read": read_count},
    "identity.local": {"read": read_local},
    "identity.fit": {"read": read_fit},
    "identity.fit_axis": {"read": read_fit_axis},
    "identity.nothing_wrong": {"read": read_nothing_wrong, "write": write_nothing_wrong},
    "identity.takes_moves": {"read": read_takes_moves},
    "identity.date": {"read": read_date, "write": write_date},
    "identity.nothing": {"do": do_nothing},
}
