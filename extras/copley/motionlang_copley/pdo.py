"""Process data objects of the simulated drive: mappings, defaults, transmission.

PDO 1 carries the control word and the status word from power-up on. The others have the mappings of DS402 and are
disabled, because two PDOs with the control word would overwrite each other's value. A transmit PDO is sent after each
change of its data (types 254 and 255), no sooner than its inhibit time and at the latest after its event timer. Types
1 to 240 are sent on every n-th SYNC, and type 0 on the SYNC after a change. A receive PDO of these types acts at the
next SYNC. Types 241 to 251 are reserved, and those of remote frames, 252 and 253, are not served.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import inf

PDOS = 4
EVENT_DRIVEN = (254, 255)
SYNCHRONOUS = range(241)
PDO_INVALID = 1 << 31
MAX_BITS = 64
# The objects that PDOs 1 to 4 carry by default, with their bits: those that are received, and those that are sent.
RECEIVED = (
    ((0x6040, 16),),
    ((0x6040, 16), (0x6060, 8)),
    ((0x6040, 16), (0x607A, 32)),
    ((0x6040, 16), (0x60FF, 32)),
)
SENT = (
    ((0x6041, 16),),
    ((0x6041, 16), (0x6061, 8)),
    ((0x6041, 16), (0x6064, 32)),
    ((0x6041, 16), (0x606C, 32)),
)
# The event timer of the first transmit PDO, ms: a master that begins to listen late learns of the state.
STATUS_PERIOD = 100
# Identifiers of PDO 1, of each direction, without the node; the next ones are 0x100 apart.
RECEIVE_ID, SEND_ID, ID_STEP = 0x200, 0x180, 0x100
NEVER = -inf

Address = tuple[int, int]


def entry(index: int, bits: int) -> int:
    """Return the mapping entry of an object without sub-indices."""
    return index << 16 | bits


@dataclass(slots=True)
class SentPdo:
    """A transmit PDO: identifier, type, times in seconds, and its last transmission."""

    can_id: int
    kind: int
    inhibit: float
    timer: float
    addresses: list[Address]
    data: bytes = b""
    at: float = NEVER
    syncs: int = 0

    def is_due(self, data: bytes, now: float) -> bool:
        """True if an event-driven PDO must be sent now."""
        if self.kind not in EVENT_DRIVEN or now < self.at + self.inhibit:
            return False
        return data != self.data or bool(self.timer and now >= self.at + self.timer)

    def next_time(self) -> float:
        """Return the time of the next check if its data do not change, s."""
        if self.kind not in EVENT_DRIVEN or self.at == NEVER:
            return inf
        return self.at + max(self.timer, self.inhibit) if self.timer else inf

    def on_sync(self, data: bytes) -> bool:
        """True if it is sent on this SYNC."""
        if self.kind == 0:
            return data != self.data
        if self.kind not in SYNCHRONOUS:
            return False
        self.syncs += 1
        if self.syncs < self.kind:
            return False
        self.syncs = 0
        return True


def sent_pdo(read: Callable[[int], int], can_id: int, addresses: list[Address]) -> SentPdo:
    """Return a transmit PDO; `read` returns a sub-index of its communication record."""
    return SentPdo(can_id, read(2), read(3) * 1e-4, read(5) * 1e-3, addresses)
