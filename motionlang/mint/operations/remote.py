"""Inputs and outputs of remote nodes on a bus: those that the machine file drives, and those that the program sets."""

from __future__ import annotations

from functools import partial

from motionlang.controller.faults import Refusal
from motionlang.controller.inputs import Channels
from motionlang.mint.operations.inputs import BANK, bits_of, checked

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from motionlang.mint.binding import Row
    from motionlang.mint.environment import Environment

    Operation = Callable[..., object]

LAST_BUS, LAST_NODE, LAST_CHANNEL = 2, 127, 255
KINDS = ("inputs", "outputs", "analogue_inputs", "analogue_outputs")


class Nodes:
    """The channels of every node, from the first use on; `named` are the nodes that the machine file speaks of."""

    def __init__(self, environment: Environment) -> None:
        self._clock = environment.clock
        self._channels: dict[tuple[int, int, str], Channels] = {}
        self.named: set[tuple[int, int]] = set()
        entries: Sequence[Mapping[str, int]] = environment.machine.settings.get("remote", ())  # type: ignore[assignment]
        for entry in entries:
            self._wire(entry)

    def channels(self, bus: int, node: int, kind: str) -> Channels:
        """The channels of one kind of a node."""
        if not 1 <= bus <= LAST_BUS:
            raise Refusal("channel", f"there is no bus {bus}", f"they are numbered 1 to {LAST_BUS}")
        key = bus, checked(node, LAST_NODE, "node"), kind
        if key not in self._channels:
            self._channels[key] = Channels(self._clock)
        return self._channels[key]

    def _wire(self, entry: Mapping[str, int]) -> None:
        bus, node, clock = entry.get("bus", 1), entry["node"], self._clock
        self.named.add((bus, node))
        kind = "analogue_inputs" if "analogue" in entry else "inputs"
        channel = entry.get("analogue", entry.get("channel", 0))
        put = self.channels(bus, node, kind).__setitem__
        at = max(float(entry.get("at", 0.0)), clock.now)
        clock.at(at, partial(put, channel, entry.get("value", 1)))
        if "for" in entry:
            clock.at(at + entry["for"], partial(put, channel, 0))


def _kind(row: Row) -> str:
    name = row.name.removeprefix("REMOTE")
    if name in ("ADC", "DAC"):
        return "analogue_inputs" if name == "ADC" else "analogue_outputs"
    return "inputs" if name.startswith("IN") else "outputs"


# ----------------------------------------------------------------------------------------------- operations


def read_bits(environment: Environment, row: Row) -> Operation:
    """REMOTEIN, REMOTEOUT and, with the number of a bank, REMOTEINBANK, REMOTEOUTBANK."""
    nodes, kind = environment.part(Nodes), _kind(row)
    return lambda bus, node, bank=0: bits_of(bank, nodes.channels(bus, node, kind).__getitem__)


def write_bits(environment: Environment, row: Row) -> Operation:
    nodes, kind = environment.part(Nodes), _kind(row)

    def write(bus: int, node: int, *rest: int) -> None:
        bank = rest[0] if len(rest) > 1 else 0
        checked(bank, LAST_CHANNEL // BANK, "bank")
        nodes.channels(bus, node, kind).set_bank(bank * BANK, BANK, rest[-1])

    return write


def read_bit(environment: Environment, row: Row) -> Operation:
    nodes, kind = environment.part(Nodes), _kind(row)

    def read(bus: int, node: int, channel: int) -> int:
        return int(nodes.channels(bus, node, kind)[checked(channel, LAST_CHANNEL, "channel")] != 0)

    return read


def write_bit(environment: Environment, row: Row) -> Operation:
    nodes, kind = environment.part(Nodes), _kind(row)

    def write(bus: int, node: int, channel: int, value: int) -> None:
        nodes.channels(bus, node, kind)[checked(channel, LAST_CHANNEL, "channel")] = int(value != 0)

    return write


def read_percent(environment: Environment, row: Row) -> Operation:
    nodes, kind = environment.part(Nodes), _kind(row)

    def read(bus: int, node: int, channel: int) -> float:
        return float(nodes.channels(bus, node, kind)[checked(channel, LAST_CHANNEL, "channel")])

    return read


def write_percent(environment: Environment, row: Row) -> Operation:
    nodes, kind = environment.part(Nodes), _kind(row)

    def write(bus: int, node: int, channel: int, value: float) -> None:
        row.check(value)
        nodes.channels(bus, node, kind)[checked(channel, LAST_CHANNEL, "channel")] = value

    return write


def read_live(environment: Environment, row: Row) -> Operation:
    """NODELIVE."""
    nodes = environment.part(Nodes)
    return lambda bus, node: int((bus, node) in nodes.named)
