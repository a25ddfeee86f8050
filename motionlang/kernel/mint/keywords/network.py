"""Memory and objects of network nodes, the state of buses, and bus events.

The machine file's `[[remote]]` and `[[bus]]` schedule events. The event numbers are those of MN1274 p. 113.
"""

from __future__ import annotations

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword, constant, kind_of
from motionlang.kernel.mint.keywords.io_inputs import checked
from motionlang.kernel.mint.keywords.remote import LAST_CHANNEL, Nodes
from motionlang.kernel.mint.runtime.binding import of
from motionlang.kernel.mint.runtime.changes import repeatable

LAST_OBJECT, LAST_SUB = 0xFFFF, 255
# CANopen data types: the number of bits, and True if the type is signed.
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
    """BUSEVENT: return the next event and remove it."""
    code = nodes.bus(bus).take()
    if code:
        nodes.environment.acts += 1
    return code


# -------------------------------------------------------------------------------------------- the comms arrays


def read_real(nodes: Nodes, bus: int, node: int, element: int) -> float:
    """Return an element of a node's memory as a float."""
    return nodes.node(bus, node).memory.real("comms", element)


def write_real(nodes: Nodes, bus: int, node: int, element: int, value: float) -> None:
    """Write an element of a node's memory as a float."""
    found = nodes.node(bus, node)
    found.memory.set_real("comms", element, value)
    found.written["element", element] = value


def write_whole(nodes: Nodes, bus: int, node: int, element: int, value: int) -> None:
    """REMOTECOMMSINTEGER: write an element of a node's memory."""
    found = nodes.node(bus, node)
    found.memory.set_integer("comms", element, value)
    found.written["element", element] = value


# ------------------------------------------------------------------------------------------- encoders, objects


def read_encoder(nodes: Nodes, bus: int, node: int, channel: int) -> int:
    """REMOTEENCODER: return the counts."""
    return nodes.node(bus, node).encoders.get(checked(channel, LAST_CHANNEL, "encoder"), 0)


def write_encoder(nodes: Nodes, bus: int, node: int, channel: int, value: int) -> None:
    """REMOTEENCODER: set the counts."""
    nodes.node(bus, node).encoders[checked(channel, LAST_CHANNEL, "encoder")] = value


def _object(index: int, sub: int) -> tuple[int, int]:
    if not (0 <= index <= LAST_OBJECT and 0 <= sub <= LAST_SUB):
        raise Rejected(
            "channel", f"there is no object {index}, {sub}", "objects are 0 to 0xFFFF, sub-indexes 0 to 255"
        )
    return index, sub


def read_value(nodes: Nodes, bus: int, node: int, index: int, sub: int) -> float:
    """REMOTEOBJECTFLOAT: return an object of a node, 0 if it is a string or not set."""
    value = nodes.node(bus, node).objects.get(_object(index, sub), 0.0)
    return float(value) if not isinstance(value, str) else 0.0


def write_value(nodes: Nodes, bus: int, node: int, index: int, sub: int, value: float | str) -> None:
    nodes.node(bus, node).write_object(_object(index, sub), value)


def read_text(nodes: Nodes, bus: int, node: int, index: int, sub: int) -> str:
    """REMOTEOBJECTSTRING: return an object of a node as a string."""
    value = nodes.node(bus, node).objects.get(_object(index, sub), "")
    return value if isinstance(value, str) else f"{value:.10g}"


def _of_type(value: int, type: int) -> int:
    """Reduce a value to the width of a CANopen type."""
    if type not in _TYPES:
        raise Rejected(
            "range", f"{type} is not an object type", "1 Boolean, 2 to 4 integers, 5 to 7 without a sign"
        )
    bits, signed = _TYPES[type]
    value &= (1 << bits) - 1
    return value - (1 << bits) if signed and value >> bits - 1 else value


def read_object(nodes: Nodes, bus: int, node: int, index: int, sub: int, type: int) -> int:
    """REMOTEOBJECT: return an object in the width of its type, 0 for a string."""
    value = nodes.node(bus, node).objects.get(_object(index, sub), 0)
    return _of_type(0 if isinstance(value, str) else int(value), type)


def write_object(nodes: Nodes, bus: int, node: int, index: int, sub: int, type: int, value: int) -> None:
    """REMOTEOBJECT: write an object of a node in the width of its type."""
    nodes.node(bus, node).write_object(_object(index, sub), _of_type(value, type))


def read_emergency_stop(nodes: Nodes, bus: int, node: int) -> int:
    return int(nodes.node(bus, node).written.get(("estop",), 0))


def write_emergency_stop(nodes: Nodes, bus: int, node: int, value: int) -> None:
    """REMOTEESTOP: set the emergency stop request to a node, which the report shows."""
    nodes.node(bus, node).written["estop",] = int(value != 0)


# ----------------------------------------------------------------------------------------------- active levels


def levels(kind: str) -> Actions:
    """Make operations on the active levels of a node's channels, as bits."""

    def read(nodes: Nodes, bus: int, node: int) -> int:
        low = nodes.channels(bus, node, kind).active_low
        return ~sum(1 << channel for channel in low if channel < 31) ^ (-1 << 31 if 31 in low else 0)

    def write(nodes: Nodes, bus: int, node: int, bits: int) -> None:
        nodes.channels(bus, node, kind).set_active_low(k for k in range(32) if not bits >> k & 1)

    return Actions(read=of(Nodes, read), write=of(Nodes, write))


# ------------------------------------------------------------------------------------------------ process data


def read_data(nodes: Nodes, bus: int, cobid: int, bank: int) -> int:
    return nodes.bus(bus).process_data.get((cobid, checked(bank, 1, "bank")), 0)


def do_send(nodes: Nodes, bus: int, node: int, data: int) -> None:
    """REMOTEPDOOUT: send data to a node; the report shows them."""
    nodes.node(bus, node).written["pdo",] = data


# ------------------------------------------------------------------------------------------------- keywords

_EVENT = Actions(read=of(Nodes, read_event))
_EVENT_INFO = Actions(read=of(Nodes, lambda nodes, bus: nodes.bus(bus).taken[1]))
_BUS_STATE = Actions(read=of(Nodes, lambda nodes, bus: nodes.bus(bus).state))
_BUS_RESET = Actions(do=of(Nodes, lambda nodes, bus: nodes.bus(bus).reset()))
_COMMS_WHOLE = Actions(
    read=of(Nodes, lambda nodes, bus, node, element: nodes.node(bus, node).memory.integer("comms", element)),
    write=repeatable(of(Nodes, write_whole)),
)
# COMMSREMOTE, which names no bus.
_FIRST_BUS_COMMS = Actions(
    read=of(Nodes, lambda nodes, node, element: read_real(nodes, 1, node, element)),
    write=repeatable(
        of(Nodes, lambda nodes, node, element, value: write_real(nodes, 1, node, element, value))
    ),
)

_CODES = (
    ("NONE", 0, "nothing has happened"),
    ("OPERATIONAL", 1, "the bus works"),
    ("PASSIVE", 2, "the bus has many errors"),
    ("OFF", 3, "the bus is off"),
    ("RECEIVE_OVERRUN", 4, "messages were lost"),
    ("DIED", 5, "a node died"),
    ("LIVE", 6, "a node lives"),
    ("EMERGENCY", 11, "a node has sent an emergency message"),
    ("TRANSMIT_OVERRUN", 13, "messages were not sent"),
)


def network_row(
    name: str,
    access: str,
    index: str,
    unit: str,
    actions: Actions,
    help: str,
    example: str,
    default: float = 0.0,
) -> Keyword:
    """Return the row of a bus keyword."""
    first = None if access == "C" else "" if unit == "text" else default
    return Keyword(name, "", kind_of(access), access, index, unit, actions, help, example, default=first,
                   group="remote")  # fmt: skip


def _bus(name: str, actions: Actions, help: str, default: float = 0.0) -> tuple[Keyword, Keyword]:
    """Return the rows of a bus keyword and of its older name, which begins with CAN."""
    words = (f"BUS{name}", "CANBUSSTATE" if name == "STATE" else f"CAN{name}")
    rest = ("", " The older word for CAN buses.")
    new, old = (
        network_row(word, "R", "bus", "integer", actions, help + more, f"PRINT {word}(1)", default=default)
        for word, more in zip(words, rest, strict=True)
    )
    return new, old


def _reset(name: str) -> Keyword:
    return network_row(name, "C", "bus", "", _BUS_RESET, "Restart a bus; its pending messages are dropped.",
                 f"{name}(1)\nPRINT BUSEVENT(1)")  # fmt: skip


ROWS = (
    *(constant(f"_cet{name}", value, f"BUSEVENT: {help}.") for name, value, help in _CODES),
    *_bus("EVENT", _EVENT,
          "Code of the next event of a bus, which is taken off its queue; 0 when there is none."),
    *_bus("EVENTINFO", _EVENT_INFO,
          "Node number of the event that was read last."),
    *_bus("STATE", _BUS_STATE, "State of a bus: 1 operational, 2 passive, 3 off.", default=1.0),
    _reset("BUSRESET"),
    _reset("CANBUSRESET"),
    network_row("NODESCAN", "C", "bus, node", "", Actions(do=of(Nodes, Nodes.scan)),
          "Look for a node: the event _cetLIVE or _cetDIED is the answer.",
          "NODESCAN(1, 2)\nPRINT BUSEVENT(1), \" \", BUSEVENTINFO(1)"),
    network_row("REMOTECOMMS", "RW", "bus, node, element", "number",
          Actions(read=of(Nodes, read_real), write=repeatable(of(Nodes, write_real))),
          "An element of the comms array of another node, 1 to 99, as a float.",
          "REMOTECOMMS(1, 2, 5) = 2.5\nPRINT REMOTECOMMS(1, 2, 5)"),
    network_row("REMOTECOMMSINTEGER", "RW", "bus, node, element", "integer", _COMMS_WHOLE,
          "An element of the comms array of another node as an Integer, of the same 32 bits.",
          "REMOTECOMMSINTEGER(1, 2, 5) = 7\nPRINT REMOTECOMMSINTEGER(1, 2, 5)"),
    network_row("COMMSREMOTE", "RW", "node, element", "number", _FIRST_BUS_COMMS,
          "An element of the comms array of another node of bus 1, as a float.",
          "COMMSREMOTE(2, 5) = 2.5\nPRINT COMMSREMOTE(2, 5), REMOTECOMMS(1, 2, 5)"),
    network_row("REMOTEENCODER", "RW", "bus, node, channel", "integer",
          Actions(read=of(Nodes, read_encoder), write=of(Nodes, write_encoder)),
          "Counts of an encoder of a remote node.",
          "REMOTEENCODER(1, 2, 0) = 1000\nPRINT REMOTEENCODER(1, 2, 0)"),
    network_row("REMOTEOBJECT", "RW", "bus, node, index, subindex, type", "integer",
          Actions(read=of(Nodes, read_object), write=of(Nodes, write_object)),
          "An object of a node's dictionary. The type is CANopen's: 1 Boolean, 2 to 4 an integer of 8, 16, 32 bits, "
          "5 to 7 one without a sign.",
          "REMOTEOBJECT(1, 2, 0x6060, 0, 2) = -1\nPRINT REMOTEOBJECT(1, 2, 0x6060, 0, 2), REMOTEOBJECT(1, 2, 0x6060, "
          "0, 5)"),
    network_row("REMOTEOBJECTFLOAT", "RW", "bus, node, index, subindex", "number",
          Actions(read=of(Nodes, read_value), write=of(Nodes, write_value)),
          "An object of a node's dictionary that is a float.",
          "REMOTEOBJECTFLOAT(1, 2, 0x2000, 1) = 2.5\nPRINT REMOTEOBJECTFLOAT(1, 2, 0x2000, 1)"),
    network_row("REMOTEOBJECTSTRING", "RW", "bus, node, index, subindex", "text",
          Actions(read=of(Nodes, read_text), write=of(Nodes, write_value)),
          "An object of a node's dictionary that is a text.",
          'REMOTEOBJECTSTRING(1, 2, 0x1008, 0) = "IO8"\nPRINT REMOTEOBJECTSTRING(1, 2, 0x1008, 0)'),
    network_row("REMOTEESTOP", "RW", "bus, node", "bool",
          Actions(read=of(Nodes, read_emergency_stop), write=of(Nodes, write_emergency_stop)),
          "The emergency stop that the program asks of a node; what the node then does is not simulated.",
          "REMOTEESTOP(1, 2) = 1\nPRINT REMOTEESTOP(1, 2)"),
    network_row("REMOTERESET", "C", "bus, node", "", Actions(do=of(Nodes, Nodes.reset)),
          "Reset a node: its outputs are off, its errors cleared, and it reports that it is live.",
          "REMOTEOUT(1, 2) = 3\nREMOTERESET(1, 2)\nPRINT REMOTEOUT(1, 2), BUSEVENT(1)"),
    network_row("REMOTEINPUTACTIVELEVEL", "RW", "bus, node", "bits", levels("inputs"),
          "Which of a node's inputs 0 to 31 are active high; all of them until it is set.",
          "REMOTEINPUTACTIVELEVEL(1, 2) = ~1\nPRINT REMOTEINX(1, 2, 0)", default=-1),
    network_row("REMOTEOUTPUTACTIVELEVEL", "RW", "bus, node", "bits", levels("outputs"),
          "Which of a node's outputs 0 to 31 are active high; all of them until it is set.",
          "REMOTEOUTPUTACTIVELEVEL(1, 2) = ~1\nPRINT REMOTEOUTPUTACTIVELEVEL(1, 2)", default=-1),
    network_row("REMOTEPDOIN", "R", "bus, cobid, bank", "integer", Actions(read=of(Nodes, read_data)),
          "The lower, bank 0, or upper 32 bits, bank 1, of process data that came last under an identifier.",
          "PRINT REMOTEPDOIN(1, 0x182, 0)"),
    network_row("REMOTEPDOOUT", "C", "bus, node, data", "", Actions(do=of(Nodes, do_send)),
          "Send process data to a node; the report has the data sent last.",
          "REMOTEPDOOUT(1, 2, 0x0F)"),
    network_row("REMOTEPDOVALID", "R", "bus, node", "bool",
          Actions(read=of(Nodes, lambda nodes, bus, node: int(nodes.answers(bus, node)))),
          "1 while the process data of a node is of now, which is while the node lives.",
          "PRINT REMOTEPDOVALID(1, 2)", default=1.0),
)  # fmt: skip
