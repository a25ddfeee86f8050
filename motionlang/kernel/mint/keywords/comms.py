"""The comms array and NetData, and the events raised when the host writes to them."""

from __future__ import annotations

from functools import partial

from motionlang.kernel.controller.io.host_memory import product
from motionlang.kernel.lang.keyword import Actions, Keyword, constant
from motionlang.kernel.mint.runtime.binding import Maker, Operation, of
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment

# The elements that raise an event, by product (ABB AN00198 p. 19): first, last, and True if only a change of
# value does.
Span = tuple[int, int, bool]
EVENTS: dict[str, dict[str, Span]] = {
    "es": {"comms": (1, 5, False)},
    "e150": {"netdata": (0, 31, True)},
    "e180": {"netdata": (0, 31, True)},
    "e190": {"netdata": (0, 31, True)},
    "e100": {"comms": (1, 10, True), "netdata": (0, 31, True)},
}


class HostEvents:
    """Raises COMMS1, NETDATA0 and so on when the host writes an element."""

    def __init__(self, environment: Environment) -> None:
        self._raise = environment.events.raise_
        self._spans = EVENTS[product(environment.machine.model)]
        environment.machine.host.listeners.append(self._written)

    def _written(self, area: str, element: int, changed: bool) -> None:
        first, last, only_changes = self._spans.get(area, (0, -1, True))
        if first <= element <= last and (changed or not only_changes):
            self._raise(area, element)


# MODBUSPARAMETER: the memory area that clients see, and its values.
ENABLE, MAPPING = 0, 3
MAPPINGS = ("comms", "netdata")


class ModbusParameters:
    """The configuration of the Modbus servers, by bus and parameter.

    MAPPING selects the area that clients of a served program see.
    """

    def __init__(self, environment: Environment) -> None:
        self._host = environment.machine.host
        self._values: dict[tuple[int, int], int] = {}

    def read(self, bus: int, parameter: int) -> int:
        if parameter == MAPPING:
            return MAPPINGS.index(self._host.mapping)
        return self._values.get((bus, parameter), int(parameter == ENABLE))

    def write(self, bus: int, parameter: int, value: int) -> None:
        self._values[bus, parameter] = value
        if parameter == MAPPING:
            self._host.mapping = MAPPINGS[min(value, 1)]


def element(name: str) -> Maker:
    """Make an operation on one area of the host memory from a method of that memory.

    The row of the keyword names the area.
    """

    def made(environment: Environment, row: Keyword) -> Operation:
        area: Operation = getattr(environment.machine.host, name)
        return partial(area, row.attribute)

    return made


# ------------------------------------------------------------------------------------------------- keywords


def _whole(area: str) -> Actions:
    return Actions(read=element("integer"), write=repeatable(element("set_integer")), attribute=area)


def _real(area: str) -> Actions:
    return Actions(read=element("real"), write=repeatable(element("set_real")), attribute=area)


_MODBUS_PARAMETER = Actions(
    read=of(ModbusParameters, ModbusParameters.read), write=of(ModbusParameters, ModbusParameters.write)
)

_PARAMETERS = (
    ("_mpENABLE", 0, "MODBUSPARAMETER: 1 while the server answers."),
    ("_mpDEBUG", 1, "MODBUSPARAMETER: the terminal that receives its messages."),
    ("_mpDROPPED_FRAMES", 2, "MODBUSPARAMETER: packets that were rejected."),
    ("_mpREGISTER_MAPPING", 3, "MODBUSPARAMETER: the area that clients see."),
    ("_rmCOMMS_ARRAY", 0, "MODBUSPARAMETER: clients see the comms array."),
    ("_rmNET_DATA", 1, "MODBUSPARAMETER: clients see NetData."),
    ("_busSERIAL1", 1, "The first serial port as a bus."),
    ("_busETHERNET", 2, "The Ethernet port as a bus."),
)


ROWS = (
    Keyword("MODBUSPARAMETER", "", "setting", "RW", "bus, parameter", "integer", _MODBUS_PARAMETER,
            "Set-up of a bus's Modbus server, one of the _mp parameters; _mpREGISTER_MAPPING says what clients see.",
            "MODBUSPARAMETER(_busETHERNET, _mpREGISTER_MAPPING) = _rmCOMMS_ARRAY\n"
            "PRINT MODBUSPARAMETER(_busETHERNET, _mpREGISTER_MAPPING)", low=0, high=32767, group="comms"),
    *(constant(*each) for each in _PARAMETERS),
    Keyword("COMMS", "", "setting", "RW", "element", "number", _real("comms"),
            "An element of the comms array, 1 to 99, as a float; it shares its 32 bits with COMMSINTEGER.",
            "COMMS(1) = 2.5\nPRINT COMMS(1)", default=0.0, group="comms", driven="comms"),
    Keyword("COMMSINTEGER", "", "setting", "RW", "element", "integer", _whole("comms"),
            "An element of the comms array as an integer; it shares its 32 bits with COMMS.",
            "COMMSINTEGER(1) = 0x41424344\nPRINT COMMSINTEGER(1)", default=0.0, group="comms", driven="comms"),
    Keyword("NETFLOAT", "", "setting", "RW", "element", "number", _real("netdata"),
            "A location of NetData, 0 to 999, as a float; it shares its 32 bits with NETINTEGER.",
            "NETINTEGER(999) = 0x40490FDB\nPRINT NETFLOAT(999)", default=0.0, group="comms", driven="netdata"),
    Keyword("NETINTEGER", "", "setting", "RW", "element", "integer", _whole("netdata"),
            "A location of NetData as an integer; it shares its 32 bits with NETFLOAT.",
            "NETFLOAT(3) = 1\nPRINT NETINTEGER(3)", default=0.0, group="comms", driven="netdata"),
)  # fmt: skip
# The event sources of each kind, created for programs that handle these events.
SOURCES = {"comms": HostEvents, "netdata": HostEvents}
