"""The drive's trajectory buffer: 32 points, first in first out, with the errors that it latches."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

from motionlang.copley.packet import OVERFLOW, BufferStatus
from motionlang.copley.point import WirePoint

SIZE = 32
"""Points that the buffer holds; the note promises no more."""


@dataclass(frozen=True, slots=True)
class Entry:
    """One place of the buffer: position (counts), velocity (0.1 counts/s; None: linear), time (microseconds).

    Microseconds, because object 0x60C2 can set fixed times finer than the milliseconds of a point. An
    `initial` entry only says where the move begins, and takes no time.
    """

    position: int
    velocity: int | None
    microseconds: int
    relative: bool = False
    initial: bool = False


class Buffer:
    """What the drive still has to do, the number of the next segment, and the errors latched so far."""

    def __init__(self, size: int = SIZE) -> None:
        self.size = size
        self.entries: deque[Entry] = deque()
        self.next_number = 0
        self.errors = 0

    @property
    def free(self) -> int:
        """The free positions."""
        return self.size - len(self.entries)

    @property
    def status(self) -> BufferStatus:
        """What object 0x2012 shows."""
        return BufferStatus(self.next_number, self.free, self.errors, not self.entries)

    def add(self, entry: Entry) -> bool:
        """Append a point; a full buffer drops it, latches an overflow and answers False."""
        if not self.free:
            self.errors |= OVERFLOW
            return False
        self.entries.append(entry)
        self.next_number = self.next_number + 1 & 0xFFFF
        return True

    def take(self) -> Entry | None:
        """The oldest point, removed; None from an empty buffer."""
        return self.entries.popleft() if self.entries else None

    def clear(self) -> None:
        """Remove every point; latched errors and the running number stay."""
        self.entries.clear()

    def pop(self, count: int) -> None:
        """Remove the `count` most recently added points, or all where there are fewer."""
        for _ in range(min(count, len(self.entries))):
            self.entries.pop()


def entry_of(point: WirePoint) -> Entry:
    """The entry of a point whose time is in milliseconds."""
    return Entry(point.position, point.velocity, point.time * 1000, point.relative)
