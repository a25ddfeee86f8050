"""What nodes hold beyond inputs and outputs, the state of the buses and their events.

The machine file's `[[remote]]` and `[[bus]]` say what happens; the numbers of events are those of MN1274 p. 113.
"""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.keywords.io_inputs import checked
from motionlang.mint.keywords.remote_operations import ERROR_REGISTER, LAST_CHANNEL, Nodes
from motionlang.mint.runtime.binding import of
from motionlang.mint.runtime.changes import repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Maker

LAST_OBJECT, LAST_SUB = 0xFFFF, 255
STATUS_REGISTER = 0x1002
# CANopen's types of data: bits, and whether there is a sign.
_TYPES = {
    1: (1, False),
    2: (8, True),
    3: (16, True),
    4: (32, True),
    5: (8, False),
    6: (16, False),
    7: (32, True),
}


# -------------------------------------------------------------------------------------------- buses and events


def read_event(nodes: Nodes, bus: int) -> int:
    """BUSEVENT: takes the event off."""
    code = nodes.bus(bus).take()
    if code:
        nodes.environment.acts += 1
    return code


# -------------------------------------------------------------------------------------------- the comms arrays


def read_real(nodes: Nodes, bus: int, node: int, element: int) -> float:
    """An element of a node's memory as a number with a fraction."""
    return nodes.node(bus, node).memory.real("comms", element)


def write_real(nodes: Nodes, bus: int, node: int, element: int, value: float) -> None:
    """An element of a node's memory as a number with a fraction."""
    found = nodes.node(bus, node)
    found.memory.set_real("comms", element, value)
    found.written["element", element] = value


def write_whole(nodes: Nodes, bus: int, node: int, element: int, value: int) -> None:
    """REMOTECOMMSINTEGER: an element of a node's memory."""
    found = nodes.node(bus, node)
    found.memory.set_integer("comms", element, value)
    found.written["element", element] = value


# ------------------------------------------------------------------------------------------- encoders, objects


def read_encoder(nodes: Nodes, bus: int, node: int, channel: int) -> int:
    """REMOTEENCODER, counts."""
    return nodes.node(bus, node).encoders.get(checked(channel, LAST_CHANNEL, "encoder"), 0)


def write_encoder(nodes: Nodes, bus: int, node: int, channel: int, value: int) -> None:
    """REMOTEENCODER, counts."""
    nodes.node(bus, node).encoders[checked(channel, LAST_CHANNEL, "encoder")] = value


def _object(index: int, sub: int) -> tuple[int, int]:
    if not (0 <= index <= LAST_OBJECT and 0 <= sub <= LAST_SUB):
        raise Refusal(
            "channel", f"there is no object {index}, {sub}", "objects are 0 to 0xFFFF, their parts 0 to 255"
        )
    return index, sub


def read_value(nodes: Nodes, bus: int, node: int, index: int, sub: int) -> float:
    """REMOTEOBJECTFLOAT: an object of a node; 0 where it is a text or was never given a value."""
    value = nodes.node(bus, node).objects.get(_object(index, sub), 0.0)
    return float(value) if not isinstance(value, str) else 0.0


def write_value(nodes: Nodes, bus: int, node: int, index: int, sub: int, value: float | str) -> None:
    nodes.node(bus, node).write_object(_object(index, sub), value)


def read_text(nodes: Nodes, bus: int, node: int, index: int, sub: int) -> str:
    """REMOTEOBJECTSTRING: an object of a node as text."""
    value = nodes.node(bus, node).objects.get(_object(index, sub), "")
    return value if isinstance(value, str) else f"{value:g}"


def _of_type(value: int, type: int) -> int:
    """A value in as many bits as a type of CANopen has."""
    if type not in _TYPES:
        raise Refusal(
            "range", f"{type} is no type of an object", "1 Boolean, 2 to 4 integers, 5 to 7 without a sign"
        )
    bits, signed = _TYPES[type]
    value &= (1 << bits) - 1
    return value - (1 << bits) if signed and value >> bits - 1 else value


def read_object(nodes: Nodes, bus: int, node: int, index: int, sub: int, type: int) -> int:
    """REMOTEOBJECT: an object of a node in the width of its type; a text reads 0."""
    value = nodes.node(bus, node).objects.get(_object(index, sub), 0)
    return _of_type(0 if isinstance(value, str) else int(value), type)


def write_object(nodes: Nodes, bus: int, node: int, index: int, sub: int, type: int, value: int) -> None:
    """REMOTEOBJECT: an object of a node, in the width of its type."""
    nodes.node(bus, node).write_object(_object(index, sub), _of_type(value, type))


def register(index: int) -> Maker:
    """What reads an object of a node that is a whole number."""

    def read(nodes: Nodes, bus: int, node: int) -> int:
        value = nodes.node(bus, node).objects.get((index, 0), 0)
        return 0 if isinstance(value, str) else int(value)

    return of(Nodes, read)


def write_status(nodes: Nodes, bus: int, node: int, value: int) -> None:
    nodes.node(bus, node).write_object((STATUS_REGISTER, 0), value)


def read_emergency_stop(nodes: Nodes, bus: int, node: int) -> int:
    return int(nodes.node(bus, node).written.get(("estop",), 0))


def write_emergency_stop(nodes: Nodes, bus: int, node: int, value: int) -> None:
    """REMOTEESTOP: what the program asks of the node is in the report."""
    nodes.node(bus, node).written["estop",] = int(value != 0)


# ----------------------------------------------------------------------------------------------- active levels


def levels(kind: str) -> dict[str, Maker]:
    """What reads and writes the active levels of the channels of a node, a bit each."""

    def read(nodes: Nodes, bus: int, node: int) -> int:
        low = nodes.channels(bus, node, kind).active_low
        return ~sum(1 << channel for channel in low if channel < 31) ^ (-1 << 31 if 31 in low else 0)

    def write(nodes: Nodes, bus: int, node: int, bits: int) -> None:
        nodes.channels(bus, node, kind).set_active_low(k for k in range(32) if not bits >> k & 1)

    return {"read": of(Nodes, read), "write": of(Nodes, write)}


# ------------------------------------------------------------------------------------------------ process data


def read_data(nodes: Nodes, bus: int, cobid: int, bank: int) -> int:
    return nodes.bus(bus).process_data.get((cobid, checked(bank, 1, "bank")), 0)


def do_send(nodes: Nodes, bus: int, node: int, data: int) -> None:
    """REMOTEPDOOUT: what is sent is in the report."""
    nodes.node(bus, node).written["pdo",] = data


OPERATIONS = {
    "network.event": {"read": of(Nodes, read_event)},
    "network.event_info": {"read": of(Nodes, lambda nodes, bus: nodes.bus(bus).taken[1])},
    "network.bus_state": {"read": of(Nodes, lambda nodes, bus: nodes.bus(bus).state)},
    "network.bus_reset": {"do": of(Nodes, lambda nodes, bus: nodes.bus(bus).reset())},
    "network.scan": {"do": of(Nodes, Nodes.scan)},
    "network.comms_real": {"read": of(Nodes, read_real), "write": repeatable(of(Nodes, write_real))},
    "network.comms_whole": {
        "read": of(
            Nodes, lambda nodes, bus, node, element: nodes.node(bus, node).memory.integer("comms", element)
        ),
        "write": repeatable(of(Nodes, write_whole)),
    },
    # COMMSREMOTE, which names no bus.
    "network.first_bus_comms": {
        "read": of(Nodes, lambda nodes, node, element: read_real(nodes, 1, node, element)),
        "write": repeatable(
            of(Nodes, lambda nodes, node, element, value: write_real(nodes, 1, node, element, value))
        ),
    },
    "network.encoder": {"read": of(Nodes, read_encoder), "write": of(Nodes, write_encoder)},
    "network.object_whole": {"read": of(Nodes, read_object), "write": of(Nodes, write_object)},
    "network.object_value": {"read": of(Nodes, read_value), "write": of(Nodes, write_value)},
    "network.object_text": {"read": of(Nodes, read_text), "write": of(Nodes, write_value)},
    "network.error_register": {"read": register(ERROR_REGISTER)},
    "network.status_register": {"read": register(STATUS_REGISTER), "write": of(Nodes, write_status)},
    "network.emergency": {
        "read": of(Nodes, lambda nodes, bus, node: nodes.node(bus, node, silent=True).emergency)
    },
    "network.emergency_stop": {
        "read": of(Nodes, read_emergency_stop),
        "write": of(Nodes, write_emergency_stop),
    },
    "network.reset": {"do": of(Nodes, Nodes.reset)},
    "network.input_level": levels("inputs"),
    "network.output_level": levels("outputs"),
    "network.process_data": {"read": of(Nodes, read_data)},
    "network.send_process_data": {"do": of(Nodes, do_send)},
    "network.process_data_valid": {"read": of(Nodes, lambda nodes, bus, node: int(nodes.answers(bus, node)))},
}
