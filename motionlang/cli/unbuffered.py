"""Standard output without a buffer, as `PYTHONUNBUFFERED` has it, written whole."""

from __future__ import annotations

import sys
from io import FileIO, TextIOWrapper


class Whole(FileIO):
    """A file descriptor of which every write is whole: one that a signal cuts short goes on behind what was written.

    Python's own text layer takes such a write for a whole one where no buffer lies below it, and loses the rest.
    """

    def write(self, data: bytes) -> int:  # type: ignore[override]
        """Write all of `data` and say how much that is; BlockingIOError where it would have to wait."""
        left = memoryview(data).cast("B")
        size = len(left)
        while left:
            written = super().write(left)
            if written is None:
                raise BlockingIOError("the output takes no more")
            left = left[written:]
        return size


def write_whole() -> None:
    """Let standard output and standard error write so, where nothing buffers them."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if type(getattr(stream, "buffer", None)) is FileIO:
            raw = Whole(stream.fileno(), "wb", closefd=False)
            text = TextIOWrapper(raw, stream.encoding, stream.errors, write_through=True)
            setattr(sys, name, text)
