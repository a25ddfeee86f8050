"""The functions that woven code calls: `__mutant__(number)` and `__seen__(file)`.

If a mutant is active, `__mutant__` is true for its number. While coverage is recorded, both functions append
their arguments to a file that all processes of a test share.
"""

from __future__ import annotations

import builtins
import os

# Environment variables: the number of the active mutant, and the file to record to.
ACTIVE, SEEN = "MOTIONLANG_MUTANT", "MOTIONLANG_REACHED"


class Recorder:
    """Appends each mutant and file that is reached to a file, once."""

    def __init__(self, path: str) -> None:
        self._file = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o600)
        self._seen: set[int | str] = set()

    def reached(self, what: int | str) -> bool:
        """Record the number of a mutant, or a file.

        Return False, because no mutant is active.
        """
        if what not in self._seen:
            self._seen.add(what)
            os.write(self._file, f"{what}\n".encode())
        return False

    def clear(self) -> None:
        """Forget everything that was recorded."""
        self._seen.clear()
        os.ftruncate(self._file, 0)


def activate(number: int) -> None:
    """Switch on one mutant in this process; -1 switches on none."""
    builtins.__mutant__ = number.__eq__  # type: ignore[attr-defined]
    builtins.__seen__ = lambda file: None  # type: ignore[attr-defined]


def record(path: str) -> Recorder:
    """Record what this process reaches; no mutant is active."""
    recorder = Recorder(path)
    builtins.__mutant__ = builtins.__seen__ = recorder.reached  # type: ignore[attr-defined]
    return recorder


def install() -> None:
    """Install the functions, as the environment requests, unless they exist."""
    if hasattr(builtins, "__mutant__"):
        return
    path = os.environ.get(SEEN)
    if path is not None and ACTIVE not in os.environ:
        record(path)
    else:
        activate(int(os.environ.get(ACTIVE, "-1")))
