"""Groups of nodes, who is connected with whom, and the controller's own number on a bus."""

from __future__ import annotations

from motionlang.mint.keywords.io_inputs import checked
from motionlang.mint.keywords.network_operations import write_real
from motionlang.mint.keywords.remote_operations import LAST_NODE, Nodes, checked_bus
from motionlang.mint.runtime.binding import of
from motionlang.mint.runtime.environment import Environment

LAST_GROUP = 31


class Groups:
    """Who belongs to which group, their masters, who is connected, and the controller's own number, by bus."""

    def __init__(self, environment: Environment) -> None:
        self.nodes = environment.part(Nodes)
        self.members: set[tuple[int, int, int]] = set()
        self.masters: dict[tuple[int, int], int] = {}
        self.connected: set[tuple[int, int, int]] = set()
        self.own: dict[int, int] = {}


# ----------------------------------------------------------------------------------------------- operations


def write_comms(groups: Groups, bus: int, group: int, element: int, value: float) -> None:
    """GROUPCOMMS: an element of every node of a group."""
    checked_bus(bus)
    checked(group, LAST_GROUP, "group")
    for where, number, node in sorted(groups.members):
        if (where, number) == (bus, group):
            write_real(groups.nodes, bus, node, element, value)


def read_connection(groups: Groups, bus: int, start: int, end: int) -> int:
    return int((checked_bus(bus), start, end) in groups.connected)


def write_connection(groups: Groups, bus: int, start: int, end: int, value: int) -> None:
    """CONNECT: two nodes that both answer are connected or not."""
    groups.nodes.node(bus, start)
    groups.nodes.node(bus, end)
    (groups.connected.add if value else groups.connected.discard)((bus, start, end))


def read_connections(groups: Groups, bus: int, start: int) -> int:
    return sum(1 for each in groups.connected if each[:2] == (checked_bus(bus), start))


def write_member(groups: Groups, bus: int, group: int, node: int, value: int) -> None:
    """GROUP: a node joins a group or leaves it."""
    (groups.members.add if value else groups.members.discard)(_place(bus, group, node))


def _place(bus: int, group: int, node: int) -> tuple[int, int, int]:
    return checked_bus(bus), checked(group, LAST_GROUP, "group"), checked(node, LAST_NODE, "node")


def read_info(groups: Groups, bus: int, node: int) -> int:
    """GROUPINFO: the groups of a node, a bit each, as a signed number of 32 bits."""
    members = groups.members
    bits = sum(1 << group for where, group, each in members if (where, each) == (checked_bus(bus), node))
    return bits - (1 << 32) if bits >> 31 else bits


def read_master(groups: Groups, bus: int, group: int) -> int:
    return groups.masters.get(_place(bus, group, 0)[:2], 0)


def write_master(groups: Groups, bus: int, group: int, node: int) -> None:
    groups.masters[_place(bus, group, node)[:2]] = node


def write_own_node(groups: Groups, bus: int, node: int) -> None:
    """BUSNODE: the number that this controller has on a bus."""
    groups.own[checked_bus(bus)] = node


def read_is_master(groups: Groups, bus: int, group: int) -> int:
    """GROUPMASTERSTATUS: whether this controller is the group's master."""
    own = groups.own.get(bus, 0)
    return int(own != 0 and groups.masters.get(_place(bus, group, 0)[:2]) == own)


def read_is_member(groups: Groups, bus: int, group: int) -> int:
    return int(_place(bus, group, groups.own.get(bus, 0)) in groups.members)


OPERATIONS = {
    "network.groups.own_node": {
        "read": of(Groups, lambda groups, bus: groups.own.get(checked_bus(bus), 0)),
        "write": of(Groups, write_own_node),
    },
    "network.groups.connection": {
        "read": of(Groups, read_connection),
        "write": of(Groups, write_connection),
    },
    "network.groups.connections": {"read": of(Groups, read_connections)},
    "network.groups.member": {
        "read": of(Groups, lambda groups, bus, group, node: int(_place(bus, group, node) in groups.members)),
        "write": of(Groups, write_member),
    },
    "network.groups.comms": {"write": of(Groups, write_comms)},
    "network.groups.info": {"read": of(Groups, read_info)},
    "network.groups.master": {"read": of(Groups, read_master), "write": of(Groups, write_master)},
    "network.groups.is_master": {"read": of(Groups, read_is_master)},
    "network.groups.is_member": {"read": of(Groups, read_is_member)},
}
