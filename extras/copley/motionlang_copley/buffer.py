"""The drive's trajectory buffer: a FIFO queue of 32 points with latched errors."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

from motionlang.lab.pvt.drive.packet import OVERFLOW, SIZE, BufferStatus
from motionlang.lab.pvt.drive.point import WirePoint


@dataclass(frozen=True, slots=True)
class BufferedPoint:
    """One point in the buffer.

    `position` is in counts, `velocity` in 0.1 counts/s (None for a linear segment). The time is in
    microseconds, because object 0x60C2 can set fixed times finer than the milliseconds of a point. An
    `initial` entry only states the start position of the move, and takes no time.
    """

    position: int
    velocity: int | None
    microseconds: int
    relative: bool = False
    initial: bool = False


class Buffer:
    """The queued entries, the number of the next segment, and the latched errors."""

    def __init__(self) -> None:
        self.entries: deque[BufferedPoint] = deque()
        self.next_number = 0
        self.errors = 0

    @property
    def free(self) -> int:
        """The number of free positions."""
        return SIZE - len(self.entries)

    @property
    def status(self) -> BufferStatus:
        """The value of object 0x2012."""
        return BufferStatus(self.next_number, self.free, self.errors, not self.entries)

    def add(self, entry: BufferedPoint) -> bool:
        """Append a point; if full, drop it, latch an overflow and return False."""
        if not self.free:
            self.errors |= OVERFLOW
            return False
        self.entries.append(entry)
        self.next_number = self.next_number + 1 & 0xFFFF
        return True

    def take(self) -> BufferedPoint | None:
        """Remove and return the oldest point; return None if the buffer is empty."""
        return self.entries.popleft() if self.entries else None

    def clear(self) -> None:
        """Remove every point, but keep the latched errors and the running number."""
        self.entries.clear()

    def pop(self, count: int) -> None:
        """Remove the last `count` points, or all if there are fewer."""
        for _ in range(min(count, len(self.entries))):
            self.entries.pop()


def entry_of(point: WirePoint) -> BufferedPoint:
    """Return the entry of a point whose time is in milliseconds."""
    return BufferedPoint(point.position, point.velocity, point.time * 1000, point.relative)
