"""The memory that the program shares with its host."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_MODBUS = "ABB AN00198"

ROWS = (
    Keyword("COMMS", "", "setting", "RW", "element", "number", "comms.real",
            "An element of the comms array, 1 to 99, as a float; it shares its 32 bits with COMMSINTEGER.",
            "COMMS(1) = 2.5\nPRINT COMMS(1)",
            default=0.0, source=_MODBUS, trust="manual", group="comms"),
    Keyword("COMMSINTEGER", "", "setting", "RW", "element", "integer", "comms.whole",
            "An element of the comms array as an integer; it shares its 32 bits with COMMS.",
            "COMMSINTEGER(1) = 0x41424344\nPRINT COMMSINTEGER(1)",
            default=0.0, source=_MODBUS, trust="manual", group="comms"),
    Keyword("NETFLOAT", "", "setting", "RW", "element", "number", "comms.real",
            "A location of NetData, 0 to 999, as a float; it shares its 32 bits with NETINTEGER.",
            "NETINTEGER(999) = 0x40490FDB\nPRINT NETFLOAT(999)",
            default=0.0, source=_MODBUS, trust="manual", group="comms"),
    Keyword("NETINTEGER", "", "setting", "RW", "element", "integer", "comms.whole",
            "A location of NetData as an integer; it shares its 32 bits with NETFLOAT.",
            "NETFLOAT(3) = 1\nPRINT NETINTEGER(3)",
            default=0.0, source=_MODBUS, trust="manual", group="comms"),
)  # fmt: skip
