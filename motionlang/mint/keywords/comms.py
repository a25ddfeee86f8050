"""The memory that the program shares with its host."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_PARAMETERS = (
    ("_mpENABLE", 0, "MODBUSPARAMETER: 1 while the server answers."),
    ("_mpDEBUG", 1, "MODBUSPARAMETER: the terminal that is told of what goes on."),
    ("_mpDROPPED_FRAMES", 2, "MODBUSPARAMETER: packets that were rejected."),
    ("_mpREGISTER_MAPPING", 3, "MODBUSPARAMETER: the area that clients see."),
    ("_rmCOMMS_ARRAY", 0, "MODBUSPARAMETER: clients see the comms array."),
    ("_rmNET_DATA", 1, "MODBUSPARAMETER: clients see NetData."),
    ("_busSERIAL1", 1, "The first serial port as a bus."),
    ("_busETHERNET", 2, "The Ethernet port as a bus."),
)

ROWS = (
    Keyword("MODBUSPARAMETER", "", "setting", "RW", "bus, parameter", "integer", "comms.modbus_parameter",
            "Set-up of a bus's Modbus server, one of the _mp parameters; _mpREGISTER_MAPPING says what clients see.",
            "MODBUSPARAMETER(_busETHERNET, _mpREGISTER_MAPPING) = _rmCOMMS_ARRAY\n"
            "PRINT MODBUSPARAMETER(_busETHERNET, _mpREGISTER_MAPPING)", low=0, high=32767, group="comms"),
    *(
        Keyword(name, "", "constant", "R", "none", "integer", str(value), help, f"PRINT {name}", group="constants")
        for name, value, help in _PARAMETERS
    ),
    Keyword("COMMS", "", "setting", "RW", "element", "number", "comms.real.comms",
            "An element of the comms array, 1 to 99, as a float; it shares its 32 bits with COMMSINTEGER.",
            "COMMS(1) = 2.5\nPRINT COMMS(1)", default=0.0, group="comms", driven="comms"),
    Keyword("COMMSINTEGER", "", "setting", "RW", "element", "integer", "comms.whole.comms",
            "An element of the comms array as an integer; it shares its 32 bits with COMMS.",
            "COMMSINTEGER(1) = 0x41424344\nPRINT COMMSINTEGER(1)", default=0.0, group="comms", driven="comms"),
    Keyword("NETFLOAT", "", "setting", "RW", "element", "number", "comms.real.netdata",
            "A location of NetData, 0 to 999, as a float; it shares its 32 bits with NETINTEGER.",
            "NETINTEGER(999) = 0x40490FDB\nPRINT NETFLOAT(999)", default=0.0, group="comms", driven="netdata"),
    Keyword("NETINTEGER", "", "setting", "RW", "element", "integer", "comms.whole.netdata",
            "A location of NetData as an integer; it shares its 32 bits with NETFLOAT.",
            "NETFLOAT(3) = 1\nPRINT NETINTEGER(3)", default=0.0, group="comms", driven="netdata"),
    Keyword("DPRFLOAT", "", "setting", "RW", "address", "number", "comms.real.dpr",
            "A word of the dual-port RAM, 0 to 4095, as a float; it shares its 32 bits with DPRLONG. What the "
            "controller itself publishes there is not simulated.",
            "DPRFLOAT(100) = 2.5\nPRINT DPRFLOAT(100)", default=0.0, group="comms", driven="dpr"),
    Keyword("DPRLONG", "", "setting", "RW", "address", "integer", "comms.whole.dpr",
            "A word of the dual-port RAM as an Integer; it shares its 32 bits with DPRFLOAT.",
            "DPRLONG(100) = 7\nPRINT DPRLONG(100)", default=0.0, group="comms", driven="dpr"),
)  # fmt: skip
