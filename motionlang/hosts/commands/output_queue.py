"""Standard output and standard error of a server, whose writes never block.

A pipe holds 64 KB and a terminal can be stopped with Ctrl-S. A write to either can then block indefinitely, and
a blocked server serves no host and ignores SIGTERM. So a thread writes to the descriptor, from a queue of at
most `CAPACITY` characters. Text that does not fit is dropped and its lines are counted. When the queue has been
written, a line on standard error reports the count, so that a log shows where lines are missing. Regular files
are written directly, because they accept every write.
"""

from __future__ import annotations

import os
import stat
import sys
from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Condition, Thread
from typing import Any, TextIO, cast

from motionlang.kernel.tools import count_of

CAPACITY = 1 << 18
# Seconds at the end for writing the queue.
FAREWELL = 0.5


class OutputQueue:
    """A text stream with a queue in front of `stream`; a full queue drops lines.

    Reports of dropped lines go to `notes`, or into the stream itself if there is none.
    """

    def __init__(self, stream: TextIO, name: str, notes: OutputQueue | None = None) -> None:
        self._stream, self.name, self._notes = stream, name, notes
        self._descriptor = stream.fileno()
        self._queue: deque[str] = deque()
        self._size = 0
        self._dropped = 0
        self._broken = False
        self._changed = Condition()
        # Lines dropped so far.
        self.dropped = 0
        stream.flush()
        Thread(target=self._serve, name=name, daemon=True).start()

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def write(self, text: str) -> int:
        """Queue `text`, or drop it if there is no space; never block."""
        with self._changed:
            # Nothing is queued after a gap before the gap has been reported.
            if self._dropped or self._size + len(text) > CAPACITY:
                lines = text.count("\n") or 1
                self._dropped += lines
                self.dropped += lines
            elif text:
                self._queue.append(text)
                self._size += len(text)
                self._changed.notify_all()
        return len(text)

    def flush(self) -> None:
        """Do nothing: the thread writes as soon as it can."""

    def close(self) -> None:
        """Wait until everything is written, but no longer than `FAREWELL`."""
        with self._changed:
            self._changed.wait_for(lambda: not (self._size or self._dropped), FAREWELL)

    def _serve(self) -> None:
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._size or self._dropped)
                text = "".join(self._queue) if self._queue else self._note()
                self._queue.clear()
            self._put(text)
            with self._changed:
                self._size -= len(text)
                self._changed.notify_all()

    def _note(self) -> str:
        """Report the dropped lines and make space again.

        Returns the text to write to this stream, "" if `notes` has taken it.
        """
        lines = count_of(self._dropped, "line")
        text = f"motionlang: {lines} of {self.name} dropped, because it was not read\n"
        self._dropped = 0
        if self._notes is not None:
            self._notes.write(text)
            return ""
        self._size += len(text)
        return text

    def _put(self, text: str) -> None:
        """Write all of `text`; ignore a closed pipe."""
        data = memoryview(text.encode(self._stream.encoding, self._stream.errors or "strict"))
        try:
            while data and not self._broken:
                data = data[os.write(self._descriptor, data) :]
        except OSError:
            self._broken = True


@contextmanager
def never_waiting() -> Iterator[list[OutputQueue]]:
    """Put a queue before standard output and error where a write could block.

    Yields these queues.
    """
    before = sys.stdout, sys.stderr
    queues: list[OutputQueue] = []
    notes: OutputQueue | None = None
    try:
        if _may_wait(sys.stderr):
            notes = OutputQueue(sys.stderr, "standard error")
            sys.stderr = cast("TextIO", notes)
            queues.append(notes)
        if _may_wait(sys.stdout):
            queues.append(OutputQueue(sys.stdout, "standard output", notes))
            sys.stdout = cast("TextIO", queues[-1])
        yield queues
    finally:
        for queue in reversed(queues):
            queue.close()
        sys.stdout, sys.stderr = before


def _may_wait(stream: TextIO) -> bool:
    try:
        return not stat.S_ISREG(os.fstat(stream.fileno()).st_mode)
    except (OSError, ValueError):  # no descriptor: a stream in memory
        return False


def dropped(queues: list[OutputQueue]) -> str:
    """Return the end of a sentence with the number of dropped lines, "" for none."""
    return "".join(
        f"; {count_of(each.dropped, 'line')} of {each.name} dropped" for each in queues if each.dropped
    )
