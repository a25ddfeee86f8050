"""Standard input, output and error, in a state in which no write to them ends the command in the wrong way."""

from __future__ import annotations

import os
import sys
from io import BufferedWriter, FileIO, TextIOWrapper


def prepare() -> None:
    """Prepare the three streams of this process; streams in memory, as tests use, stay as they are."""
    _open_closed()
    _write_whole()
    for stream in (sys.stdout, sys.stderr):
        # A letter that the terminal's encoding lacks is shown by its number; it never ends the run.
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="backslashreplace")


def silence() -> None:
    """Discard what standard output still holds: its reader has gone, and Python's last flush would complain."""
    try:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except (OSError, ValueError, AttributeError):
        pass


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


class Dispensable(Whole):
    """A descriptor whose write errors are ignored: a full disk or a reader that has gone costs the text alone."""

    def write(self, data: bytes) -> int:  # type: ignore[override]
        try:
            return super().write(data)
        except OSError:
            return len(data)


def _open_closed() -> None:
    """Replace a stream that was closed at the start with the null device.

    As in Python's own streams the descriptor stays open with the object gone: `-X dev` reports any other.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            descriptor = os.open(os.devnull, os.O_RDWR)
            setattr(sys, name, open(descriptor, mode, encoding="utf-8", closefd=False))  # noqa: SIM115


def _write_whole() -> None:
    """Make writes whole where standard output has no buffer, and on standard error, whose errors are ignored.

    The exit status states how the command ended, which a lost message does not change.
    """
    if type(getattr(sys.stdout, "buffer", None)) is FileIO:
        sys.stdout = _text(sys.stdout, Whole)
    below = getattr(sys.stderr, "buffer", None)
    if type(below) is FileIO or (type(below) is BufferedWriter and type(below.raw) is FileIO):
        sys.stderr = _text(sys.stderr, Dispensable)


def _text(stream: object, kind: type[Whole]) -> TextIOWrapper:
    """A text stream on the descriptor of `stream` that writes at once."""
    assert isinstance(stream, TextIOWrapper)
    raw = kind(stream.fileno(), "wb", closefd=False)
    return TextIOWrapper(raw, stream.encoding, stream.errors, write_through=True)
