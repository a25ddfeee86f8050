"""Buses and their nodes: machine file events, and values written by the program."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

from motionlang.kernel.controller.io.channels import Channels
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import BANK, Actions, Keyword, kind_of
from motionlang.kernel.mint.keywords.event_kinds import NUMBERS
from motionlang.kernel.mint.keywords.io_inputs import bits_of, checked
from motionlang.kernel.mint.runtime.binding import of, of_word
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment

Entry = Mapping[str, Any]


# Powerlink numbers its nodes beyond CAN's 127: its manager is 240.
LAST_BUS, LAST_NODE, LAST_CHANNEL = NUMBERS["bus"][-1], 255, 255
# The names in the report of the channels that the program sets.
_WRITTEN = {"outputs": "output", "analogue_outputs": "analogue-output"}
# Maximum number of unread events of a bus. The oldest is dropped first.
MAX_QUEUE = 64
# Event codes (MN1274 p. 113). The first three are also states of a bus.
OPERATIONAL, PASSIVE, OFF = 1, 2, 3
BUS_CODES = {
    "operational": OPERATIONAL,
    "passive": PASSIVE,
    "off": OFF,
    "receive-overrun": 4,
    "transmit-overrun": 13,
}
NODE_CODES = {"dead": 5, "live": 6, "emergency": 11}


class RemoteBus:
    """One bus: its `state` and its unread events.

    `taken` is the last event read: its code and its info.
    """

    def __init__(self, number: int, happened: Callable[[str, int], None]) -> None:
        self._number, self._happened = number, happened
        self.state = OPERATIONAL
        self.queue: list[tuple[int, int]] = []
        self.taken = 0, 0

    def add_event(self, code: int, info: int = 0) -> None:
        """Add an event, which BUSEVENT will return."""
        if code in (OPERATIONAL, PASSIVE, OFF):
            self.state = code
        self.queue = [*self.queue[1 - MAX_QUEUE :], (code, info)]
        self._happened("bus", self._number)

    def take(self) -> int:
        """Remove the next event and return its code, 0 if there is none."""
        self.taken = self.queue.pop(0) if self.queue else (0, 0)
        return self.taken[0]


class BusNode:
    """The data of one node except its channels."""

    def __init__(self) -> None:
        self.live = True
        self.mode = 0


class Nodes:
    """All buses and nodes, created on first use.

    `named` is the set of nodes that the machine file mentions.
    """

    def __init__(self, environment: Environment) -> None:
        self.environment, self._clock = environment, environment.clock
        self._happened = environment.events.raise_
        self._channels: dict[tuple[int, int, str], Channels] = {}
        self._nodes: dict[tuple[int, int], BusNode] = {}
        self._buses: dict[int, RemoteBus] = {}
        self.named: set[tuple[int, int]] = set()
        settings = environment.machine.settings
        entries: Sequence[Entry] = settings.get("remote", ())  # type: ignore[assignment]
        self._begin(entries)
        for entry in entries:
            self._wire(entry)
        for entry in settings.get("bus", ()):  # type: ignore[attr-defined]
            self._at(entry, partial(self.bus(entry.get("bus", 1)).add_event, BUS_CODES[entry["event"]]))
        environment.machine.written.append(self.written)

    def bus(self, bus: int) -> RemoteBus:
        """Return a bus; raise Rejected if it does not exist."""
        found = self._buses.get(bus)
        if found is None:
            found = self._buses[bus] = RemoteBus(checked_bus(bus), self._happened)
        return found

    def node(self, bus: int, node: int) -> BusNode:
        """Return a node; raise Rejected if it does not answer."""
        if not self.answers(bus, node):
            raise Rejected(
                "no-connection",
                f"node {node} of bus {bus} does not answer",
                f"check it with NODELIVE({bus}, {node})",
            )
        key = checked_bus(bus), checked(node, LAST_NODE, "node")
        found = self._nodes.get(key)
        if found is None:
            found = self._nodes[key] = BusNode()
        return found

    def answers(self, bus: int, node: int) -> bool:
        """True if a node is alive and its bus is not off."""
        return self.bus(bus).state != OFF and ((bus, node) not in self._nodes or self._nodes[bus, node].live)

    def channels(self, bus: int, node: int, kind: str) -> Channels:
        """Return the channels of one kind of a node that answers."""
        self.node(bus, node)
        return self._put_into(bus, node, kind)

    def _put_into(self, bus: int, node: int, kind: str) -> Channels:
        key = checked_bus(bus), node, kind
        if key not in self._channels:
            made = self._channels[key] = Channels(self._clock)
            if kind in _WRITTEN:
                made.listen(partial(self._log_write, bus, node, _WRITTEN[kind]))
        return self._channels[key]

    def _log_write(self, bus: int, node: int, what: str, channel: int, value: float) -> None:
        target = f"{what.replace('-', ' ')} {channel} of node {node} of bus {bus}"
        self.environment.machine.log.write(self._clock.now, target, value, is_output=True)

    def written(self) -> list[dict[str, object]]:
        """Return the values that the program has written to nodes, as report rows."""
        rows: list[dict[str, object]] = []
        for (bus, node, kind), channels in sorted(self._channels.items()):
            what = _WRITTEN.get(kind)
            touched = channels.touched if what else ()
            rows += [
                {"bus": bus, "node": node, "kind": what, "number": each, "value": channels[each]}
                for each in touched
            ]
        return rows

    # ---------------------------------------------------------------------------------------- the machine file

    def _begin(self, entries: Sequence[Entry]) -> None:
        """Set the initial state of nodes: dead if their first event makes them alive."""
        first: dict[tuple[int, int], Entry] = {}
        for entry in sorted(entries, key=lambda each: each.get("at", 0.0)):
            key = entry.get("bus", 1), entry["node"]
            self.named.add(key)
            self._nodes[key] = self._nodes.get(key) or BusNode()
            if entry.get("event") in ("live", "dead"):
                first.setdefault(key, entry)
        for key, entry in first.items():
            self._nodes[key].live = entry["event"] == "dead"

    def _at(self, entry: Entry, call: Callable[[], None]) -> None:
        self._clock.at(max(float(entry.get("at", 0.0)), self._clock.now), call)

    def _wire(self, entry: Entry) -> None:
        bus, node, value = entry.get("bus", 1), entry["node"], entry.get("value", 1)
        if "event" in entry:
            self._at(entry, partial(self._become, bus, node, entry["event"]))
        else:
            self._wire_input(entry, bus, node, value)

    def _wire_input(self, entry: Entry, bus: int, node: int, value: float) -> None:
        kind = "analogue_inputs" if "analogue" in entry else "inputs"
        put = partial(
            self._put_into(bus, node, kind).__setitem__, entry.get("analogue", entry.get("channel", 0))
        )
        self._at(entry, partial(put, value))
        if "for" in entry:
            at = max(float(entry.get("at", 0.0)), self._clock.now)
            self._clock.at(at + entry["for"], partial(put, 0))

    def _become(self, bus: int, node: int, event: str) -> None:
        """Apply an event from the machine file to a node."""
        if event != "emergency":
            self._nodes[bus, node].live = event == "live"
        self.bus(bus).add_event(NODE_CODES[event], node)


def checked_bus(bus: int) -> int:
    """Return the number of a bus; raise Rejected if no such bus exists."""
    if not 1 <= bus <= LAST_BUS:
        raise Rejected("channel", f"there is no bus {bus}", f"they are numbered 1 to {LAST_BUS}")
    return bus


# ----------------------------------------------------------------------------------------------- operations


def read_bits(nodes: Nodes, row: Keyword, bus: int, node: int, bank: int = 0) -> int:
    """REMOTEIN, REMOTEOUT, REMOTEINBANK and REMOTEOUTBANK: return a bank as bits."""
    kind = row.attribute
    channels = nodes.channels(bus, node, kind)
    return bits_of(bank, channels.inverted if kind == "inputs" else channels.__getitem__)


def write_bits(nodes: Nodes, row: Keyword, bus: int, node: int, *rest: int) -> None:
    """REMOTEOUT and REMOTEOUTBANK: set a bank."""
    bank = rest[0] if len(rest) > 1 else 0
    checked(bank, LAST_CHANNEL // BANK, "bank")
    nodes.channels(bus, node, row.attribute).set_bank(bank * BANK, BANK, rest[-1])


def read_bit(nodes: Nodes, row: Keyword, bus: int, node: int, channel: int) -> int:
    """REMOTEINX and REMOTEOUTX: return a channel; only inputs have active levels."""
    kind = row.attribute
    channels = nodes.channels(bus, node, kind)
    checked(channel, LAST_CHANNEL, "channel")
    return int(channels.inverted(channel) if kind == "inputs" else channels[channel] != 0)


def write_bit(nodes: Nodes, row: Keyword, bus: int, node: int, channel: int, value: int) -> None:
    """REMOTEOUTX: set an output."""
    write_percent(nodes, row, bus, node, channel, int(value != 0))


def read_percent(nodes: Nodes, row: Keyword, bus: int, node: int, channel: int) -> float:
    """REMOTEADC and REMOTEDAC: return a channel in percent."""
    return float(nodes.channels(bus, node, row.attribute)[checked(channel, LAST_CHANNEL, "channel")])


def write_percent(nodes: Nodes, row: Keyword, bus: int, node: int, channel: int, value: float) -> None:
    """REMOTEDAC: set an output in percent."""
    nodes.channels(bus, node, row.attribute)[checked(channel, LAST_CHANNEL, "channel")] = value


def read_live(nodes: Nodes, bus: int, node: int) -> int:
    """NODELIVE: return 1 if the node is alive."""
    key = checked_bus(bus), checked(node, LAST_NODE, "node")
    return int(key in nodes.named and nodes.answers(*key))


# ------------------------------------------------------------------------------------------------- keywords


def _percent(kind: str) -> Actions:
    return Actions(
        read=of_word(Nodes, read_percent), write=repeatable(of_word(Nodes, write_percent)), attribute=kind
    )


def _bit(kind: str) -> Actions:
    return Actions(read=of_word(Nodes, read_bit), write=repeatable(of_word(Nodes, write_bit)), attribute=kind)


def _bits(kind: str) -> Actions:
    return Actions(
        read=of_word(Nodes, read_bits), write=repeatable(of_word(Nodes, write_bits)), attribute=kind
    )


def _word(name: str, access: str, index: str, unit: str, actions: Actions, help: str, example: str,
          driven: str = "") -> Keyword:  # fmt: skip
    low, high = (-100.0, 100.0) if unit == "%" and "W" in access else (None, None)
    return Keyword(name, "", kind_of(access), access, index, unit, actions, help, example, default=0.0, low=low,
                   high=high, group="remote", driven=driven)  # fmt: skip


def _set_mode(nodes: Nodes, bus: int, node: int, mode: int) -> None:
    nodes.node(bus, node).mode = mode


_MODE = Actions(
    read=of(Nodes, lambda nodes, bus, node: nodes.node(bus, node).mode), write=of(Nodes, _set_mode)
)

ROWS = (
    _word("REMOTEIN", "R", "bus, node", "bits", _bits("inputs"), "The inputs of a remote node as bits.",
          "PRINT REMOTEIN(1, 2)", "remote"),
    _word("REMOTEINX", "R", "bus, node, input", "bool", _bit("inputs"), "One input of a remote node.",
          "PRINT REMOTEINX(1, 2, 0)", "remote"),
    _word("REMOTEINBANK", "R", "bus, node, bank", "bits", _bits("inputs"), "A bank of inputs of a remote node.",
          "PRINT REMOTEINBANK(1, 2, 0)", "remote"),
    _word("REMOTEOUT", "RW", "bus, node", "bits", _bits("outputs"), "The outputs of a remote node as bits.",
          "REMOTEOUT(1, 2) = 255\nPRINT REMOTEOUT(1, 2)"),
    _word("REMOTEOUTX", "RW", "bus, node, output", "bool", _bit("outputs"), "One output of a remote node.",
          "REMOTEOUTX(1, 2, 3) = 1\nPRINT REMOTEOUTX(1, 2, 3)"),
    _word("REMOTEOUTBANK", "RW", "bus, node, bank", "bits", _bits("outputs"),
          "A bank of outputs of a remote node.", "REMOTEOUTBANK(1, 2, 0) = 7\nPRINT REMOTEOUTBANK(1, 2, 0)"),
    _word("REMOTEADC", "R", "bus, node, channel", "%", _percent("analogue_inputs"),
          "An analogue input of a remote node in percent.", "PRINT REMOTEADC(1, 2, 0)", "remote"),
    _word("REMOTEDAC", "RW", "bus, node, channel", "%", _percent("analogue_outputs"),
          "An analogue output of a remote node in percent.", "REMOTEDAC(1, 2, 3) = 100\nPRINT REMOTEDAC(1, 2, 3)"),
    Keyword("REMOTEMODE", "", "setting", "RW", "bus, node", "integer", _MODE,
            "Sending of the analogue node's values: 0 as events, 1 cyclically, with each SYNC of the network. Here "
            "both modes read the same.",
            "REMOTEMODE(1, 2) = 1\nPRINT REMOTEMODE(1, 2)", default=0.0, low=0, high=1, group="remote"),
    _word("NODELIVE", "R", "bus, node", "bool", Actions(read=of(Nodes, read_live)),
          "1 for a node that the machine file speaks of, while it lives.", "PRINT NODELIVE(1, 2)"),
)  # fmt: skip
# The event sources of each kind, created for programs that handle these events.
SOURCES = {"bus": Nodes}
