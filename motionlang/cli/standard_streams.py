"""Standard input, output and error, prepared so that writes cannot end a command."""

from __future__ import annotations

import os
import sys
from io import BufferedWriter, FileIO, TextIOWrapper


def prepare() -> None:
    """Prepare the three streams of this process, except those in memory, as in tests."""
    _open_closed()
    _write_whole()
    for stream in (sys.stdout, sys.stderr):
        # A character that the terminal's encoding lacks is shown by its number; it never ends the run.
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="backslashreplace")


def silence() -> None:
    """Discard further standard output after its reader has closed the pipe.

    Python's last flush would report an error.
    """
    try:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except (OSError, ValueError, AttributeError):
        pass


class CompleteWriter(FileIO):
    """A file descriptor whose writes are complete: an interrupted write continues.

    Without a buffer below it, Python's own text layer takes an interrupted write for a complete one and loses the
    rest.
    """

    def write(self, data: bytes) -> int:  # type: ignore[override]
        """Write all of `data` and return its length; BlockingIOError if it would block."""
        left = memoryview(data).cast("B")
        size = len(left)
        while left:
            written = super().write(left)
            if written is None:
                raise BlockingIOError("the output is closed")
            left = left[written:]
        return size


class Dispensable(CompleteWriter):
    """A descriptor whose write errors are ignored, so that only the text is lost.

    Such errors are a full disk and a closed pipe.
    """

    def write(self, data: bytes) -> int:  # type: ignore[override]
        try:
            return super().write(data)
        except OSError:
            return len(data)


def _open_closed() -> None:
    """Replace a stream that was closed at the start with the null device.

    As in Python's own streams, the descriptor stays open when the object is deleted. With any other descriptor
    `-X dev` reports an unclosed file.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            descriptor = os.open(os.devnull, os.O_RDWR)
            setattr(sys, name, open(descriptor, mode, encoding="utf-8", closefd=False))  # noqa: SIM115


def _write_whole() -> None:
    """Make unbuffered writes complete, and ignore errors on standard error.

    The exit status states how the command ended, and a lost message must not change it.
    """
    if type(getattr(sys.stdout, "buffer", None)) is FileIO:
        sys.stdout = _text(sys.stdout, CompleteWriter)
    below = getattr(sys.stderr, "buffer", None)
    if type(below) is FileIO or (type(below) is BufferedWriter and type(below.raw) is FileIO):
        sys.stderr = _text(sys.stderr, Dispensable)


def _text(stream: object, kind: type[CompleteWriter]) -> TextIOWrapper:
    """Return a text stream on the descriptor of `stream` that writes at once."""
    assert isinstance(stream, TextIOWrapper)
    raw = kind(stream.fileno(), "wb", closefd=False)
    return TextIOWrapper(raw, stream.encoding, stream.errors, write_through=True)
