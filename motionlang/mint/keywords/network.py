"""The buses and their nodes: events, states, groups, connections, and what nodes hold beyond inputs and outputs."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

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


def _word(
    name: str,
    access: str,
    index: str,
    unit: str,
    verb: str,
    help: str,
    example: str,
    low: float | None = None,
    high: float | None = None,
    default: float = 0.0,
) -> Keyword:
    kind = "command" if access == "C" else "setting" if "W" in access else "reading"
    first = None if access == "C" else "" if unit == "text" else default
    where = verb if "." in verb else f"network.{verb}"
    return Keyword(name, "", kind, access, index, unit, where, help, example, default=first, low=low, high=high,
                   group="remote")  # fmt: skip


def _bus(name: str, verb: str, help: str, default: float = 0.0) -> tuple[Keyword, Keyword]:
    """A word of the bus, and the older word that says CAN."""
    words = (f"BUS{name}", "CANBUSSTATE" if name == "STATE" else f"CAN{name}")
    rest = ("", " The older word for CAN buses.")
    new, old = (
        _word(word, "R", "bus", "integer", verb, help + more, f"PRINT {word}(1)", default=default)
        for word, more in zip(words, rest, strict=True)
    )
    return new, old


def _reset(name: str) -> Keyword:
    return _word(name, "C", "bus", "", "bus_reset", "Start a bus anew: what it had to tell is forgotten.",
                 f"{name}(1)\nPRINT BUSEVENT(1)")  # fmt: skip


ROWS = (
    *(
        Keyword(f"_cet{name}", "", "constant", "R", "none", "integer", str(value), f"BUSEVENT: {help}.",
                f"PRINT _cet{name}", group="constants")
        for name, value, help in _CODES
    ),
    *_bus("EVENT", "event",
          "Code of the next event of a bus, which is taken off its queue; 0 when there is none."),
    *_bus("EVENTINFO", "event_info",
          "What the event that was taken last is about: the number of the node."),
    *_bus("STATE", "bus_state", "State of a bus: 1 operational, 2 passive, 3 off.", default=1.0),
    _reset("BUSRESET"),
    _reset("CANBUSRESET"),
    _word("BUSNODE", "RW", "bus", "integer", "network.groups.own_node", "The controller's own node number on a bus.",
          "BUSNODE(1) = 5\nPRINT BUSNODE(1)", low=0, high=255),
    _word("NODESCAN", "C", "bus, node", "", "scan",
          "Look for a node: the event _cetLIVE or _cetDIED is the answer.",
          "NODESCAN(1, 2)\nPRINT BUSEVENT(1), \" \", BUSEVENTINFO(1)"),
    _word("REMOTECOMMS", "RW", "bus, node, element", "number", "comms_real",
          "An element of the comms array of another node, 1 to 99, as a float.",
          "REMOTECOMMS(1, 2, 5) = 2.5\nPRINT REMOTECOMMS(1, 2, 5)"),
    _word("REMOTECOMMSINTEGER", "RW", "bus, node, element", "integer", "comms_whole",
          "An element of the comms array of another node as an Integer, of the same 32 bits.",
          "REMOTECOMMSINTEGER(1, 2, 5) = 7\nPRINT REMOTECOMMSINTEGER(1, 2, 5)"),
    _word("COMMSREMOTE", "RW", "node, element", "number", "first_bus_comms",
          "An element of the comms array of another node of bus 1, as a float.",
          "COMMSREMOTE(2, 5) = 2.5\nPRINT COMMSREMOTE(2, 5), REMOTECOMMS(1, 2, 5)"),
    _word("REMOTEENCODER", "RW", "bus, node, channel", "integer", "encoder",
          "Counts of an encoder of a remote node.",
          "REMOTEENCODER(1, 2, 0) = 1000\nPRINT REMOTEENCODER(1, 2, 0)"),
    _word("REMOTEOBJECT", "RW", "bus, node, index, subindex, type", "integer", "object_whole",
          "An object of a node's dictionary. The type is CANopen's: 1 Boolean, 2 to 4 an integer of 8, 16, 32 bits, "
          "5 to 7 one without a sign.",
          "REMOTEOBJECT(1, 2, 0x6060, 0, 2) = -1\nPRINT REMOTEOBJECT(1, 2, 0x6060, 0, 2), REMOTEOBJECT(1, 2, 0x6060, "
          "0, 5)"),
    _word("REMOTEOBJECTFLOAT", "RW", "bus, node, index, subindex", "number", "object_value",
          "An object of a node's dictionary that is a float.",
          "REMOTEOBJECTFLOAT(1, 2, 0x2000, 1) = 2.5\nPRINT REMOTEOBJECTFLOAT(1, 2, 0x2000, 1)"),
    _word("REMOTEOBJECTSTRING", "RW", "bus, node, index, subindex", "text", "object_text",
          "An object of a node's dictionary that is a text.",
          'REMOTEOBJECTSTRING(1, 2, 0x1008, 0) = "IO8"\nPRINT REMOTEOBJECTSTRING(1, 2, 0x1008, 0)'),
    _word("REMOTEERROR", "R", "bus, node", "bits", "error_register",
          "The error register of a node, which is object 0x1001; 1 after an emergency message until it is reset.",
          "PRINT REMOTEERROR(1, 2)"),
    _word("REMOTESTATUS", "RW", "bus, node", "bits", "status_register",
          "The status register of a node, which is object 0x1002.",
          "REMOTESTATUS(1, 2) = 0\nPRINT REMOTESTATUS(1, 2)"),
    _word("REMOTEEMERGENCYMESSAGE", "R", "bus, node", "integer", "emergency",
          "Code of the last emergency message of a node, 0 when there was none.",
          "PRINT REMOTEEMERGENCYMESSAGE(1, 2)"),
    _word("REMOTEESTOP", "RW", "bus, node", "bool", "emergency_stop",
          "The emergency stop that the program asks of a node; what the node then does is not simulated.",
          "REMOTEESTOP(1, 2) = 1\nPRINT REMOTEESTOP(1, 2)"),
    _word("REMOTERESET", "C", "bus, node", "", "reset",
          "Reset a node: its outputs are off, its errors cleared, and it tells that it lives.",
          "REMOTEOUT(1, 2) = 3\nREMOTERESET(1, 2)\nPRINT REMOTEOUT(1, 2), BUSEVENT(1)"),
    _word("REMOTEINPUTACTIVELEVEL", "RW", "bus, node", "bits", "input_level",
          "Which of a node's inputs 0 to 31 are active high; all of them until it is set.",
          "REMOTEINPUTACTIVELEVEL(1, 2) = ~1\nPRINT REMOTEINX(1, 2, 0)", default=-1),
    _word("REMOTEOUTPUTACTIVELEVEL", "RW", "bus, node", "bits", "output_level",
          "Which of a node's outputs 0 to 31 are active high; all of them until it is set.",
          "REMOTEOUTPUTACTIVELEVEL(1, 2) = ~1\nPRINT REMOTEOUTPUTACTIVELEVEL(1, 2)", default=-1),
    _word("REMOTEPDOIN", "R", "bus, cobid, bank", "integer", "process_data",
          "The lower, bank 0, or upper 32 bits, bank 1, of process data that came last under an identifier.",
          "PRINT REMOTEPDOIN(1, 0x182, 0)"),
    _word("REMOTEPDOOUT", "C", "bus, node, data", "", "send_process_data",
          "Send process data to a node; the report tells what was sent last.",
          "REMOTEPDOOUT(1, 2, 0x0F)"),
    _word("REMOTEPDOVALID", "R", "bus, node", "bool", "process_data_valid",
          "1 while the process data of a node is of now, which is while the node lives.",
          "PRINT REMOTEPDOVALID(1, 2)", default=1.0),
    _word("CONNECT", "RW", "bus, from, to", "bool", "network.groups.connection",
          "The connection of two nodes: 1 makes it, 0 breaks it; both must answer.",
          "CONNECT(1, 2, 7) = 1\nPRINT CONNECT(1, 2, 7)"),
    _word("CONNECTSTATUS", "R", "bus, from", "integer", "network.groups.connections",
          "How many nodes a node is connected to.",
          "CONNECT(1, 2, 7) = 1\nPRINT CONNECTSTATUS(1, 2)"),
    _word("GROUP", "RW", "bus, group, node", "bool", "network.groups.member",
          "Whether a node belongs to a group, 0 to 31.",
          "GROUP(1, 3, 7) = 1\nPRINT GROUP(1, 3, 7)"),
    _word("GROUPCOMMS", "W", "bus, group, element", "number", "network.groups.comms",
          "Write an element of the comms array of every node of a group.",
          "GROUP(1, 3, 7) = 1\nGROUPCOMMS(1, 3, 5) = 2.5\nPRINT REMOTECOMMS(1, 7, 5)"),
    _word("GROUPINFO", "R", "bus, node", "bits", "network.groups.info", "The groups that a node belongs to, as bits.",
          "GROUP(1, 3, 7) = 1\nPRINT GROUPINFO(1, 7)"),
    _word("GROUPMASTER", "RW", "bus, group", "integer", "network.groups.master",
          "The node that is the master of a group.",
          "GROUPMASTER(1, 3) = 7\nPRINT GROUPMASTER(1, 3)"),
    _word("GROUPMASTERSTATUS", "R", "bus, group", "bool", "network.groups.is_master",
          "1 while the controller itself is the master of a group.",
          "BUSNODE(1) = 7\nGROUPMASTER(1, 3) = 7\nPRINT GROUPMASTERSTATUS(1, 3)"),
    _word("GROUPSTATUS", "R", "bus, group", "bool", "network.groups.is_member",
          "1 while the controller itself belongs to a group.",
          "BUSNODE(1) = 7\nGROUP(1, 3, 7) = 1\nPRINT GROUPSTATUS(1, 3)"),
)  # fmt: skip
