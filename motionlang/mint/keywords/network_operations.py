"""What nodes hold beyond inputs and outputs, the state of the buses and their events.

The machine file's `[[remote]]` and `[[bus]]` say what happens; the numbers of events are those of MN1274 p. 113.
"""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.keywords.io_inputs import checked
from motionlang.mint.keywords.remote_operations import LAST_CHANNEL, Nodes
from motionlang.mint.runtime.changes import repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment

LAST_OBJECT, LAST_SUB = 0xFFFF, 255
ERROR_REGISTER, STATUS_REGISTER = 0x1001, 0x1002
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


def read_event(environment: Environment, row: Row) -> Operation:
    """BUSEVENT: takes the event off."""
    nodes = environment.part(Nodes)

    def read(bus: int) -> int:
        code = nodes.bus(bus).take()
        if code:
            environment.acts += 1
        return code

    return read


def read_event_info(environment: Environment, row: Row) -> Operation:
    nodes = environment.part(Nodes)
    return lambda bus: nodes.bus(bus).taken[1]


def read_bus_state(environment: Environment, row: Row) -> Operation:
    nodes = environment.part(Nodes)
    return lambda bus: nodes.bus(bus).state


def do_bus_reset(environment: Environment, row: Row) -> Operation:
    nodes = environment.part(Nodes)
    return lambda bus: nodes.bus(bus).reset()


def do_scan(environment: Environment, row: Row) -> Operation:
    return environment.part(Nodes).scan


def do_reset(environment: Environment, row: Row) -> Operation:
    return environment.part(Nodes).reset


# -------------------------------------------------------------------------------------------- the comms arrays


def comms_element(environment: Environment) -> tuple[Operation, Operation]:
    """What reads and what writes an element of a node's memory as a number with a fraction."""
    nodes = environment.part(Nodes)

    def read(bus: int, node: int, element: int) -> float:
        return nodes.node(bus, node).memory.real("comms", element)

    def write(bus: int, node: int, element: int, value: float) -> None:
        found = nodes.node(bus, node)
        found.memory.set_real("comms", element, value)
        found.written["element", element] = value

    return read, write


def read_comms_real(environment: Environment, row: Row) -> Operation:
    return comms_element(environment)[0]


@repeatable
def write_comms_real(environment: Environment, row: Row) -> Operation:
    return comms_element(environment)[1]


def read_first_bus_comms(environment: Environment, row: Row) -> Operation:
    """COMMSREMOTE, which names no bus."""
    read = comms_element(environment)[0]
    return lambda node, element: read(1, node, element)


@repeatable
def write_first_bus_comms(environment: Environment, row: Row) -> Operation:
    write = comms_element(environment)[1]
    return lambda node, element, value: write(1, node, element, value)


def read_comms_whole(environment: Environment, row: Row) -> Operation:
    nodes = environment.part(Nodes)
    return lambda bus, node, element: nodes.node(bus, node).memory.integer("comms", element)


@repeatable
def write_comms_whole(environment: Environment, row: Row) -> Operation:
    """REMOTECOMMSINTEGER: an element of a node's memory."""
    nodes = environment.part(Nodes)

    def write(bus: int, node: int, element: int, value: int) -> None:
        found = nodes.node(bus, node)
        found.memory.set_integer("comms", element, value)
        found.written["element", element] = value

    return write


# ------------------------------------------------------------------------------------------- encoders, objects


def read_encoder(environment: Environment, row: Row) -> Operation:
    """REMOTEENCODER, counts."""
    nodes = environment.part(Nodes)

    def read(bus: int, node: int, channel: int) -> int:
        return nodes.node(bus, node).encoders.get(checked(channel, LAST_CHANNEL, "encoder"), 0)

    return read


def write_encoder(environment: Environment, row: Row) -> Operation:
    """REMOTEENCODER, counts."""
    nodes = environment.part(Nodes)

    def write(bus: int, node: int, channel: int, value: int) -> None:
        nodes.node(bus, node).encoders[checked(channel, LAST_CHANNEL, "encoder")] = value

    return write


def _object(index: int, sub: int) -> tuple[int, int]:
    if not (0 <= index <= LAST_OBJECT and 0 <= sub <= LAST_SUB):
        raise Refusal(
            "channel", f"there is no object {index}, {sub}", "objects are 0 to 0xFFFF, their parts 0 to 255"
        )
    return index, sub


def read_object_value(environment: Environment, row: Row) -> Operation:
    """REMOTEOBJECTFLOAT: an object of a node; 0 where it is a text or was never given a value."""
    nodes = environment.part(Nodes)

    def read(bus: int, node: int, index: int, sub: int) -> float:
        value = nodes.node(bus, node).objects.get(_object(index, sub), 0.0)
        return float(value) if not isinstance(value, str) else 0.0

    return read


def write_object_value(environment: Environment, row: Row) -> Operation:
    nodes = environment.part(Nodes)
    return lambda bus, node, index, sub, value: nodes.node(bus, node).write_object(_object(index, sub), value)


def read_object_text(environment: Environment, row: Row) -> Operation:
    """REMOTEOBJECTSTRING: an object of a node as text."""
    nodes = environment.part(Nodes)

    def read(bus: int, node: int, index: int, sub: int) -> str:
        value = nodes.node(bus, node).objects.get(_object(index, sub), "")
        return value if isinstance(value, str) else f"{value:g}"

    return read


def write_object_text(environment: Environment, row: Row) -> Operation:
    return write_object_value(environment, row)


def _of_type(value: int, type: int) -> int:
    """A value in as many bits as a type of CANopen has."""
    if type not in _TYPES:
        raise Refusal(
            "range", f"{type} is no type of an object", "1 Boolean, 2 to 4 integers, 5 to 7 without a sign"
        )
    bits, signed = _TYPES[type]
    value &= (1 << bits) - 1
    return value - (1 << bits) if signed and value >> bits - 1 else value


def read_object_whole(environment: Environment, row: Row) -> Operation:
    """REMOTEOBJECT: an object of a node in the width of its type; a text reads 0."""
    nodes = environment.part(Nodes)

    def read(bus: int, node: int, index: int, sub: int, type: int) -> int:
        value = nodes.node(bus, node).objects.get(_object(index, sub), 0)
        return _of_type(0 if isinstance(value, str) else int(value), type)

    return read


def write_object_whole(environment: Environment, row: Row) -> Operation:
    """REMOTEOBJECT: an object of a node, in the width of its type."""
    nodes = environment.part(Nodes)

    def write(bus: int, node: int, index: int, sub: int, type: int, value: int) -> None:
        nodes.node(bus, node).write_object(_object(index, sub), _of_type(value, type))

    return write


def _register(environment: Environment, index: int) -> Callable[[int, int], int]:
    nodes = environment.part(Nodes)

    def read(bus: int, node: int) -> int:
        value = nodes.node(bus, node).objects.get((index, 0), 0)
        return 0 if isinstance(value, str) else int(value)

    return read


def read_error_register(environment: Environment, row: Row) -> Operation:
    return _register(environment, ERROR_REGISTER)


def read_status_register(environment: Environment, row: Row) -> Operation:
    return _register(environment, STATUS_REGISTER)


def write_status_register(environment: Environment, row: Row) -> Operation:
    nodes = environment.part(Nodes)
    return lambda bus, node, value: nodes.node(bus, node).write_object((STATUS_REGISTER, 0), value)


def read_emergency(environment: Environment, row: Row) -> Operation:
    nodes = environment.part(Nodes)
    return lambda bus, node: nodes.node(bus, node, silent=True).emergency


def read_emergency_stop(environment: Environment, row: Row) -> Operation:
    nodes = environment.part(Nodes)
    return lambda bus, node: int(nodes.node(bus, node).written.get(("estop",), 0))


def write_emergency_stop(environment: Environment, row: Row) -> Operation:
    """REMOTEESTOP: what the program asks of the node is in the report."""
    nodes = environment.part(Nodes)

    def write(bus: int, node: int, value: int) -> None:
        nodes.node(bus, node).written["estop",] = int(value != 0)

    return write


# ----------------------------------------------------------------------------------------------- active levels


def _read_level(environment: Environment, kind: str) -> Operation:
    nodes = environment.part(Nodes)

    def read(bus: int, node: int) -> int:
        low = nodes.channels(bus, node, kind).active_low
        return ~sum(1 << channel for channel in low if channel < 31) ^ (-1 << 31 if 31 in low else 0)

    return read


def _write_level(environment: Environment, kind: str) -> Operation:
    nodes = environment.part(Nodes)

    def write(bus: int, node: int, bits: int) -> None:
        nodes.channels(bus, node, kind).set_active_low(k for k in range(32) if not bits >> k & 1)

    return write


def read_input_level(environment: Environment, row: Row) -> Operation:
    return _read_level(environment, "inputs")


def write_input_level(environment: Environment, row: Row) -> Operation:
    return _write_level(environment, "inputs")


def read_output_level(environment: Environment, row: Row) -> Operation:
    return _read_level(environment, "outputs")


def write_output_level(environment: Environment, row: Row) -> Operation:
    return _write_level(environment, "outputs")


# ------------------------------------------------------------------------------------------------ process data


def read_process_data(environment: Environment, row: Row) -> Operation:
    nodes = environment.part(Nodes)
    return lambda bus, cobid, bank: nodes.bus(bus).process_data.get((cobid, checked(bank, 1, "bank")), 0)


def do_send_process_data(environment: Environment, row: Row) -> Operation:
    """REMOTEPDOOUT: what is sent is in the report."""
    nodes = environment.part(Nodes)

    def send(bus: int, node: int, data: int) -> None:
        nodes.node(bus, node).written["pdo",] = data

    return send


def read_process_data_valid(environment: Environment, row: Row) -> Operation:
    nodes = environment.part(Nodes)
    return lambda bus, node: int(nodes.answers(bus, node))


OPERATIONS = {
    "network.event": {"read": read_event},
    "network.event_info": {"read": read_event_info},
    "network.bus_state": {"read": read_bus_state},
    "network.bus_reset": {"do": do_bus_reset},
    "network.scan": {"do": do_scan},
    "network.comms_real": {"read": read_comms_real, "write": write_comms_real},
    "network.comms_whole": {"read": read_comms_whole, "write": write_comms_whole},
    "network.first_bus_comms": {"read": read_first_bus_comms, "write": write_first_bus_comms},
    "network.encoder": {"read": read_encoder, "write": write_encoder},
    "network.object_whole": {"read": read_object_whole, "write": write_object_whole},
    "network.object_value": {"read": read_object_value, "write": write_object_value},
    "network.object_text": {"read": read_object_text, "write": write_object_text},
    "network.error_register": {"read": read_error_register},
    "network.status_register": {"read": read_status_register, "write": write_status_register},
    "network.emergency": {"read": read_emergency},
    "network.emergency_stop": {"read": read_emergency_stop, "write": write_emergency_stop},
    "network.reset": {"do": do_reset},
    "network.input_level": {"read": read_input_level, "write": write_input_level},
    "network.output_level": {"read": read_output_level, "write": write_output_level},
    "network.process_data": {"read": read_process_data},
    "network.send_process_data": {"do": do_send_process_data},
    "network.process_data_valid": {"read": read_process_data_valid},
}
