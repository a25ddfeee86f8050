"""A terminal that delivers single keys."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager


def has_keys() -> bool:
    """True if standard input is a terminal that reports single keys."""
    if not sys.stdin.isatty():
        return False
    try:
        import termios  # noqa: F401 - Windows has none
    except ImportError:
        return False
    return True


@contextmanager
def single_keys(file: int) -> Iterator[None]:
    """Make the terminal deliver each key at once, not echoed; Ctrl-C still interrupts."""
    import termios
    import tty

    before = termios.tcgetattr(file)
    tty.setcbreak(file, termios.TCSADRAIN)  # what is typed already stays
    try:
        yield
    finally:
        termios.tcsetattr(file, termios.TCSADRAIN, before)
