"""Events that a program raises or drops."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_TYPES = (
    "0 ONERROR, 1 BUS, 2 STOP, 3 FASTIN, 4 LATCH, 5 TIMER, 6 IN, 7 NETDATA, 8 COMMS, 9 DPR, 10 AXISIDLE, 11 MBLOW, "
    "12 TERMINALRECEIVE, 13 SERIALRECEIVE, 14 BUSMESSAGE, 15 MODBUS, 16 KNIFE, 17 RESET"
)
_TIMER = '{0}WAIT = 5\nEnd\nEvent TIMER\n  PRINT "tick"\nEnd Event'

ROWS = (
    Keyword("EVENTPEND", "", "command", "C", "type, data, data", "", "event_flags.pend",
            f"Raise an event; the types are {_TYPES}. The data are a bank and a bit pattern (IN, FASTIN), a number "
            "(LATCH), or a bit pattern (COMMS, NETDATA, BUS).",
            _TIMER.format("EVENTPEND(5, 0, 0)\n"), group="events"),
    Keyword("EVENTUNPEND", "", "command", "C", "type, data, data", "", "event_flags.unpend",
            "Drop an event that waits to be handled; the same types and data as EVENTPEND.",
            _TIMER.format("EVENTDISABLE = 0x20\nEVENTPEND(5, 0, 0)\nEVENTUNPEND(5, 0, 0)\nEVENTDISABLE = 0\n"
                          "PRINT EVENTPENDING\n"), group="events"),
)  # fmt: skip
