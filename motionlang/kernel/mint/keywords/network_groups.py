"""Groups of nodes, connections of nodes, and the controller's own node number."""

from __future__ import annotations

from motionlang.kernel.controller.io.bits import signed
from motionlang.kernel.lang.keyword import Actions
from motionlang.kernel.mint.keywords.io_inputs import checked
from motionlang.kernel.mint.keywords.network import network_row, write_real
from motionlang.kernel.mint.keywords.remote import LAST_NODE, Nodes, checked_bus
from motionlang.kernel.mint.runtime.binding import of
from motionlang.kernel.mint.runtime.environment import Environment

LAST_GROUP = 31


class Groups:
    """Groups of nodes with their masters, connections, and own node numbers, by bus."""

    def __init__(self, environment: Environment) -> None:
        self.nodes = environment.component(Nodes)
        self.members: set[tuple[int, int, int]] = set()
        self.masters: dict[tuple[int, int], int] = {}
        self.connected: set[tuple[int, int, int]] = set()
        self.own: dict[int, int] = {}


# ----------------------------------------------------------------------------------------------- operations


def write_comms(groups: Groups, bus: int, group: int, element: int, value: float) -> None:
    """GROUPCOMMS: write an element of every node of a group."""
    checked_bus(bus)
    checked(group, LAST_GROUP, "group")
    for where, number, node in sorted(groups.members):
        if (where, number) == (bus, group):
            write_real(groups.nodes, bus, node, element, value)


def read_connection(groups: Groups, bus: int, start: int, end: int) -> int:
    return int((checked_bus(bus), start, end) in groups.connected)


def write_connection(groups: Groups, bus: int, start: int, end: int, value: int) -> None:
    """CONNECT: connect or disconnect two nodes; both must answer."""
    groups.nodes.node(bus, start)
    groups.nodes.node(bus, end)
    (groups.connected.add if value else groups.connected.discard)((bus, start, end))


def read_connections(groups: Groups, bus: int, start: int) -> int:
    return sum(1 for each in groups.connected if each[:2] == (checked_bus(bus), start))


def write_member(groups: Groups, bus: int, group: int, node: int, value: int) -> None:
    """GROUP: add a node to a group or remove it."""
    (groups.members.add if value else groups.members.discard)(_checked_key(bus, group, node))


def _checked_key(bus: int, group: int, node: int) -> tuple[int, int, int]:
    return checked_bus(bus), checked(group, LAST_GROUP, "group"), checked(node, LAST_NODE, "node")


def read_info(groups: Groups, bus: int, node: int) -> int:
    """GROUPINFO: return the groups that a node belongs to, as signed 32-bit bits."""
    members = groups.members
    return signed(
        sum(1 << group for where, group, each in members if (where, each) == (checked_bus(bus), node))
    )


def read_master(groups: Groups, bus: int, group: int) -> int:
    return groups.masters.get(_checked_key(bus, group, 0)[:2], 0)


def write_master(groups: Groups, bus: int, group: int, node: int) -> None:
    groups.masters[_checked_key(bus, group, node)[:2]] = node


def write_own_node(groups: Groups, bus: int, node: int) -> None:
    """BUSNODE: set the number of this controller on a bus."""
    groups.own[checked_bus(bus)] = node


def read_is_master(groups: Groups, bus: int, group: int) -> int:
    """GROUPMASTERSTATUS: return 1 if this controller is the group's master."""
    own = groups.own.get(bus, 0)
    return int(own != 0 and groups.masters.get(_checked_key(bus, group, 0)[:2]) == own)


def read_is_member(groups: Groups, bus: int, group: int) -> int:
    return int(_checked_key(bus, group, groups.own.get(bus, 0)) in groups.members)


# ------------------------------------------------------------------------------------------------- keywords

_OWN_NODE = Actions(
    read=of(Groups, lambda groups, bus: groups.own.get(checked_bus(bus), 0)), write=of(Groups, write_own_node)
)
_MEMBER = Actions(
    read=of(Groups, lambda groups, bus, group, node: int(_checked_key(bus, group, node) in groups.members)),
    write=of(Groups, write_member),
)


ROWS = (
    network_row("BUSNODE", "RW", "bus", "integer", _OWN_NODE, "The controller's own node number on a bus.",
          "BUSNODE(1) = 5\nPRINT BUSNODE(1)", low=0, high=255),
    network_row("CONNECT", "RW", "bus, from, to", "bool",
          Actions(read=of(Groups, read_connection), write=of(Groups, write_connection)),
          "The connection of two nodes: 1 makes it, 0 breaks it; both must answer.",
          "CONNECT(1, 2, 7) = 1\nPRINT CONNECT(1, 2, 7)"),
    network_row("CONNECTSTATUS", "R", "bus, from", "integer", Actions(read=of(Groups, read_connections)),
          "Number of nodes that a node is connected to.",
          "CONNECT(1, 2, 7) = 1\nPRINT CONNECTSTATUS(1, 2)"),
    network_row("GROUP", "RW", "bus, group, node", "bool", _MEMBER,
          "Membership of a node in a group, 0 to 31.",
          "GROUP(1, 3, 7) = 1\nPRINT GROUP(1, 3, 7)"),
    network_row("GROUPCOMMS", "W", "bus, group, element", "number", Actions(write=of(Groups, write_comms)),
          "Write an element of the comms array of every node of a group.",
          "GROUP(1, 3, 7) = 1\nGROUPCOMMS(1, 3, 5) = 2.5\nPRINT REMOTECOMMS(1, 7, 5)"),
    network_row("GROUPINFO", "R", "bus, node", "bits", Actions(read=of(Groups, read_info)),
          "The groups that a node belongs to, as bits.",
          "GROUP(1, 3, 7) = 1\nPRINT GROUPINFO(1, 7)"),
    network_row("GROUPMASTER", "RW", "bus, group", "integer",
          Actions(read=of(Groups, read_master), write=of(Groups, write_master)),
          "The node that is the master of a group.",
          "GROUPMASTER(1, 3) = 7\nPRINT GROUPMASTER(1, 3)"),
    network_row("GROUPMASTERSTATUS", "R", "bus, group", "bool", Actions(read=of(Groups, read_is_master)),
          "1 while the controller itself is the master of a group.",
          "BUSNODE(1) = 7\nGROUPMASTER(1, 3) = 7\nPRINT GROUPMASTERSTATUS(1, 3)"),
    network_row("GROUPSTATUS", "R", "bus, group", "bool", Actions(read=of(Groups, read_is_member)),
          "1 while the controller itself belongs to a group.",
          "BUSNODE(1) = 7\nGROUP(1, 3, 7) = 1\nPRINT GROUPSTATUS(1, 3)"),
)  # fmt: skip
