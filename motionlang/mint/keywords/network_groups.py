"""Groups of nodes, who is connected with whom, and the controller's own number on a bus."""

from __future__ import annotations

from motionlang.mint.keywords.io_inputs import checked
from motionlang.mint.keywords.network_operations import comms_element
from motionlang.mint.keywords.remote_operations import LAST_NODE, Nodes, checked_bus

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment

LAST_GROUP = 31


class Groups:
    """Who belongs to which group, their masters, who is connected, and the controller's own number, by bus."""

    def __init__(self, environment: Environment) -> None:
        self.members: set[tuple[int, int, int]] = set()
        self.masters: dict[tuple[int, int], int] = {}
        self.connected: set[tuple[int, int, int]] = set()
        self.own: dict[int, int] = {}


# ----------------------------------------------------------------------------------------------- operations


def write_comms(environment: Environment, row: Row) -> Operation:
    """GROUPCOMMS: an element of every node of a group."""
    write, groups = comms_element(environment)[1], environment.part(Groups)

    def each(bus: int, group: int, element: int, value: float) -> None:
        checked_bus(bus)
        checked(group, LAST_GROUP, "group")
        for where, number, node in sorted(groups.members):
            if (where, number) == (bus, group):
                write(bus, node, element, value)

    return each


def read_connection(environment: Environment, row: Row) -> Operation:
    connected = environment.part(Groups).connected
    return lambda bus, start, end: int((checked_bus(bus), start, end) in connected)


def write_connection(environment: Environment, row: Row) -> Operation:
    """CONNECT: two nodes that both answer are connected or not."""
    nodes, connected = environment.part(Nodes), environment.part(Groups).connected

    def write(bus: int, start: int, end: int, value: int) -> None:
        nodes.node(bus, start)
        nodes.node(bus, end)
        (connected.add if value else connected.discard)((bus, start, end))

    return write


def read_connections(environment: Environment, row: Row) -> Operation:
    connected = environment.part(Groups).connected
    return lambda bus, start: sum(1 for each in connected if each[:2] == (checked_bus(bus), start))


def read_member(environment: Environment, row: Row) -> Operation:
    members = environment.part(Groups).members
    return lambda bus, group, node: int(_place(bus, group, node) in members)


def write_member(environment: Environment, row: Row) -> Operation:
    """GROUP: a node joins a group or leaves it."""
    members = environment.part(Groups).members

    def write(bus: int, group: int, node: int, value: int) -> None:
        (members.add if value else members.discard)(_place(bus, group, node))

    return write


def _place(bus: int, group: int, node: int) -> tuple[int, int, int]:
    return checked_bus(bus), checked(group, LAST_GROUP, "group"), checked(node, LAST_NODE, "node")


def read_info(environment: Environment, row: Row) -> Operation:
    """GROUPINFO: the groups of a node, a bit each, as a signed number of 32 bits."""
    members = environment.part(Groups).members

    def read(bus: int, node: int) -> int:
        bits = sum(1 << group for where, group, each in members if (where, each) == (checked_bus(bus), node))
        return bits - (1 << 32) if bits >> 31 else bits

    return read


def read_master(environment: Environment, row: Row) -> Operation:
    masters = environment.part(Groups).masters
    return lambda bus, group: masters.get(_place(bus, group, 0)[:2], 0)


def write_master(environment: Environment, row: Row) -> Operation:
    """GROUPMASTER."""
    masters = environment.part(Groups).masters

    def write(bus: int, group: int, node: int) -> None:
        masters[_place(bus, group, node)[:2]] = node

    return write


def read_own_node(environment: Environment, row: Row) -> Operation:
    own = environment.part(Groups).own
    return lambda bus: own.get(checked_bus(bus), 0)


def write_own_node(environment: Environment, row: Row) -> Operation:
    """BUSNODE: the number that this controller has on a bus."""
    own = environment.part(Groups).own

    def write(bus: int, node: int) -> None:
        own[checked_bus(bus)] = node

    return write


def read_is_master(environment: Environment, row: Row) -> Operation:
    """GROUPMASTERSTATUS: whether this controller is the group's master."""
    groups = environment.part(Groups)

    def read(bus: int, group: int) -> int:
        own = groups.own.get(bus, 0)
        return int(own != 0 and groups.masters.get(_place(bus, group, 0)[:2]) == own)

    return read


def read_is_member(environment: Environment, row: Row) -> Operation:
    groups = environment.part(Groups)
    return lambda bus, group: int(_place(bus, group, groups.own.get(bus, 0)) in groups.members)


OPERATIONS = {
    "network.groups.own_node": {"read": read_own_node, "write": write_own_node},
    "network.groups.connection": {"read": read_connection, "write": write_connection},
    "network.groups.connections": {"read": read_connections},
    "network.groups.member": {"read": read_member, "write": write_member},
    "network.groups.comms": {"write": write_comms},
    "network.groups.info": {"read": read_info},
    "network.groups.master": {"read": read_master, "write": write_master},
    "network.groups.is_master": {"read": read_is_master},
    "network.groups.is_member": {"read": read_is_member},
}
