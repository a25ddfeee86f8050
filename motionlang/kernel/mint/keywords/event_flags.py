"""Events that the program itself raises or cancels, and keyboard events.

The type of an event is the index of its kind in the order of urgency, and also its bit in EVENTPENDING. The
arguments after the type select events of that kind: a bank and a bit pattern of inputs, the number of a latch,
or a bit pattern of elements, locations or buses.
"""

from __future__ import annotations

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import BANK, Actions, Keyword
from motionlang.kernel.lang.machine.machine import CONSOLE
from motionlang.kernel.mint.keywords.event_kinds import KINDS, SINGLE
from motionlang.kernel.mint.runtime.binding import of_word
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.events import Events

# Kinds whose first argument is a bank, and kinds whose first argument is a number. The others take a bit
# pattern.
_BANKED, _NUMBERED = ("in", "fastin"), ("latch",)


class Keys:
    """Raises the terminal event when keys are pressed."""

    def __init__(self, environment: Environment) -> None:
        events = environment.events
        machine = environment.machine
        terminals = {entry.get("terminal", CONSOLE) for entry in machine.settings.get("key", ())}  # type: ignore[attr-defined]
        for number in sorted({CONSOLE, *terminals}):
            machine.operator_at(number).listeners.append(lambda: events.raise_("terminalreceive"))


def _kind(row: Keyword, type_: int) -> str:
    if not 0 <= type_ < len(KINDS):
        raise Rejected(
            "event", f"{row.name}: there is no event of type {type_}", f"they are 0 to {len(KINDS) - 1}"
        )
    return KINDS[type_]


def _numbers(kind: str, first: int, second: int) -> list[int]:
    """Return the numbers of the events of a kind that two arguments select."""
    if kind in SINGLE:
        return [0]
    if kind in _NUMBERED:
        return [first]
    start, pattern = (first * BANK, second) if kind in _BANKED else (0, first)
    return [start + k for k in range(BANK) if pattern >> k & 1]


def do_pend(events: Events, row: Keyword, type_: int, first: int, second: int) -> None:
    """EVENTPEND: raise events."""
    kind = _kind(row, type_)
    numbers = [number for number in _numbers(kind, first, second) if events.handles(kind, number)]
    if not numbers:
        words = f"the program has no handler of {kind.upper()} for {first}, {second}"
        raise Rejected("event", words if kind not in SINGLE else f"the program has no handler of {kind.upper()}",
                      f"write Event {kind.upper()}{'' if kind in SINGLE else '0'} … End Event")  # fmt: skip
    for number in numbers:
        events.raise_(kind, number)


def do_unpend(events: Events, row: Keyword, type_: int, first: int, second: int) -> None:
    """EVENTUNPEND: cancel pending events of a kind.

    If the kind has numbers and the arguments select none, all its pending events are cancelled.
    """
    numbers = _numbers(_kind(row, type_), first, second)
    events.pending[:] = [
        (rank, number)
        for rank, number in events.pending
        if rank != type_ or (numbers and number not in numbers)
    ]


# ------------------------------------------------------------------------------------------------- keywords

_TYPES = (
    "0 ONERROR, 1 BUS, 2 STOP, 3 FASTIN, 4 LATCH, 5 TIMER, 6 IN, 7 NETDATA, 8 COMMS, 9 DPR, 10 AXISIDLE, 11 MBLOW, "
    "12 TERMINALRECEIVE, 13 SERIALRECEIVE, 14 BUSMESSAGE, 15 MODBUS, 16 KNIFE, 17 RESET"
)
_TIMER = '{0}WAIT = 5\nEnd\nEvent TIMER\n  PRINT "tick"\nEnd Event'


ROWS = (
    Keyword("EVENTPEND", "", "command", "C", "type, data, data", "", Actions(do=of_word(Events, do_pend)),
            f"Raise an event; the types are {_TYPES}. The data are a bank and a bit pattern (IN, FASTIN), a number "
            "(LATCH), or a bit pattern (COMMS, NETDATA, BUS).",
            _TIMER.format("EVENTPEND(5, 0, 0)\n"), group="events"),
    Keyword("EVENTUNPEND", "", "command", "C", "type, data, data", "", Actions(do=of_word(Events, do_unpend)),
            "Drop an event that waits to be handled; the same types and data as EVENTPEND.",
            _TIMER.format("EVENTDISABLE = 0x20\nEVENTPEND(5, 0, 0)\nEVENTUNPEND(5, 0, 0)\nEVENTDISABLE = 0\n"
                          "PRINT EVENTPENDING\n"), group="events"),
)  # fmt: skip
# The event sources of each kind, created for programs that handle these events.
SOURCES = {"terminalreceive": Keys}
