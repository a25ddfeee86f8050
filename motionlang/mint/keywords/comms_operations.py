"""The comms array and NetData, read and written by the program, and the events of what the host writes there."""

from __future__ import annotations

from motionlang.controller.io.host_memory import AREAS, product
from motionlang.mint.runtime.binding import of, with_first
from motionlang.mint.runtime.changes import repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Maker, Operation, Row
    from motionlang.mint.runtime.environment import Environment

# Which elements raise an event, by product (ABB AN00198 p. 19): first, last, only where the value has changed.
Span = tuple[int, int, bool]
EVENTS: dict[str, dict[str, Span]] = {
    "es": {"comms": (1, 5, False)},
    "e150": {"netdata": (0, 31, True)},
    "e180": {"netdata": (0, 31, True)},
    "e190": {"netdata": (0, 31, True)},
    "e100": {"comms": (1, 10, True), "netdata": (0, 31, True)},
}


class HostEvents:
    """Raises COMMS1, NETDATA0 and so on for what the host writes."""

    def __init__(self, environment: Environment) -> None:
        self._raise = environment.events.raise_
        self._spans = EVENTS[product(environment.machine.model)]
        environment.machine.host.listeners.append(self._written)

    def _written(self, area: str, element: int, changed: bool) -> None:
        first, last, only_changes = self._spans.get(area, (0, -1, True))
        if first <= element <= last and (changed or not only_changes):
            self._raise(area, element)


# MODBUSPARAMETER: the area that clients see, and its values.
ENABLE, MAPPING = 0, 3
MAPPINGS = ("comms", "netdata")


class ModbusParameters:
    """The set-up of Modbus servers, by bus and parameter. A served program's clients see what the mapping says."""

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
    """A method of the host's memory, of the area that the verb ends in."""

    def made(environment: Environment, row: Row) -> Operation:
        return with_first(getattr(environment.machine.host, name), row.attribute)

    return made


_REAL = {"read": element("real"), "write": repeatable(element("set_real"))}
_WHOLE = {"read": element("integer"), "write": repeatable(element("set_integer"))}
OPERATIONS = {
    "comms.modbus_parameter": {
        "read": of(ModbusParameters, ModbusParameters.read),
        "write": of(ModbusParameters, ModbusParameters.write),
    },
    **{f"comms.real.{area}": _REAL for area in AREAS},
    **{f"comms.whole.{area}": _WHOLE for area in AREAS},
}
# What raises the events of a kind, made for programs that handle them.
SOURCES = {"comms": HostEvents, "netdata": HostEvents}
