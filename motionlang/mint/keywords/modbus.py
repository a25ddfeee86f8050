"""Modbus: servers that the program reaches as a client, and the controller's own registers and coils."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_CLIENT = (
    ("MODBUSTCP16", "integer", "modbus.word", -32768, 65535, "1234",
     "One register of a Modbus server, 0 to 65535; a negative value is written as its two's complement."),
    ("MODBUSTCP32", "integer", "modbus.whole", None, None, "123456",
     "Two registers of a Modbus server as an Integer, the lower half in the first."),
    ("MODBUSTCPFLOAT", "number", "modbus.real", None, None, "2.5",
     "Two registers of a Modbus server as a 32-bit float, the lower half in the first."),
)  # fmt: skip

ROWS = (
    *(
        Keyword(name, "", "setting", "RW", "server, register", unit, verb, help,
                f"{name}(4, 6) = {value}\nPRINT {name}(4, 6)", default=0.0, low=low, high=high, group="comms")
        for name, unit, verb, low, high, value, help in _CLIENT
    ),
    Keyword("HOLDINGREGISTER", "", "setting", "RW", "register", "integer", "modbus.own_register",
            "A register of the controller's own Modbus server, 0 to 65535: one half of an element of what clients see.",
            "NETINTEGER(3) = 0x10002\nPRINT HOLDINGREGISTER(6), \" \", HOLDINGREGISTER(7)",
            default=0.0, low=-32768, high=65535, group="comms"),
    Keyword("COIL", "", "setting", "RW", "coil", "bool", "modbus.coil",
            "A coil of the controller's own Modbus server; a client, which is the machine file, writes it too.",
            "COIL(3) = _TRUE\nPRINT COIL(3)", default=0.0, group="comms"),
)  # fmt: skip
