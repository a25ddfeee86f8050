"""What the virtual controller answers about itself, unless the machine file says it."""

from __future__ import annotations

from motionlang.mint.keywords.identity import AXES
from motionlang.mint.keywords.no_effect_operations import Kept
from motionlang.mint.runtime.binding import axis_of, of
from motionlang.mint.runtime.changes import always
from motionlang.mint.runtime.environment import Environment

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from motionlang.mint.runtime.binding import Maker, Operation, Row

# What the library of WorkBench calls its own simulated controller.
VIRTUAL = "Virtual Controller"
_POWER_UP = "2000-01-01 00:00:00"
_DATE = "%Y-%m-%d %H:%M:%S"


def answers(known: Callable[..., object]) -> Maker:
    """What the machine file says, or what this program knows: of the environment and what stands in the brackets."""

    def made(environment: Environment, row: Row) -> Operation:
        find, of_axis = environment.part(Kept).told.find, row.index == "axis"

        def read(*where: int) -> object:
            if of_axis:
                axis_of(environment, where[0])
            told = find(row.name, row.unit, where)
            return known(environment, *where) if told is None else told

        return read

    return made


def version(environment: Environment) -> str:
    from motionlang import __version__

    return f"motionlang {__version__}"


def count(environment: Environment, item: int) -> int:
    """NUMBEROF: the axes; of other items what the machine file says, else the run ends."""
    if item == AXES:
        return len(environment.controller.axes)
    from motionlang.lang.run_errors import NotSimulated

    words = f"how many there are of item {item} is not known here"
    raise NotSimulated(words, f'the machine file can say it: [mint.readings] NUMBEROF = {{ "{item}" = 8 }}')


def takes_moves(environment: Environment, count: int, axes: Sequence[int]) -> int:
    """OKTOLOADMOVE: 1 where every axis of the array could take a move into its buffer now."""
    controller = environment.controller

    def takes(axis: int) -> bool:
        a = controller.axes[axis_of(environment, axis)]
        stopping = a.move is not None and a.move.ended in ("stop", "fault")
        return controller.is_enabled(axis) and not a.faults and not stopping and controller.room(axis) > 0

    return int(all(takes(int(axis)) for axis in (axes or [])[1 : count + 1]))


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


_LOCAL, _FIT = answers(lambda environment, *where: 0), answers(lambda environment, *where: 1)
OPERATIONS = {
    "identity.platform": {"read": answers(lambda environment: environment.machine.model or VIRTUAL)},
    "identity.version": {"read": answers(version)},
    "identity.count": {"read": answers(count)},
    "identity.local": {"read": _LOCAL},
    "identity.fit": {"read": _FIT},
    "identity.fit_axis": {"read": _FIT},
    # What is not there needs no clearing.
    "identity.nothing_wrong": {"read": _LOCAL, "write": lambda environment, row: lambda *given: None},
    "identity.takes_moves": {"read": of(Environment, takes_moves)},
    "identity.date": {
        "read": always(of(Calendar, Calendar.text)),
        "write": of(Calendar, lambda calendar, text: calendar.set(text, calendar.clock.now)),
    },
    "identity.nothing": {"do": lambda environment, row: lambda *given: None},
}
