"""What was typed, kept between sessions in the user's own state folder; in memory only where that cannot be written."""

from __future__ import annotations

import os
import stat

from prompt_toolkit.history import FileHistory, History, InMemoryHistory

from motionlang.cache import own_folder

# Names another file; empty: nothing is kept.
VARIABLE = "MOTIONLANG_HISTORY"


def history(dialect: str) -> History:
    """The history of a dialect."""
    folder = _folder()
    path = os.environ.get(VARIABLE, os.path.join(folder, f"{dialect}-history") if folder else "")
    return KeptHistory(path) if path and _is_writable(path) else InMemoryHistory()


class KeptHistory(FileHistory):
    """A history whose trouble is never the session's: a full disk costs the history, not the work."""

    def store_string(self, string: str) -> None:
        try:
            super().store_string(string)
        except OSError:
            return


def _folder() -> str | None:
    """The user's state folder for motionlang; None without a home."""
    return own_folder("Application Support", "XDG_STATE_HOME", os.path.join(".local", "state"))


def _is_writable(path: str) -> bool:
    """Whether the file is, or could be made, this user's alone: nobody else has a business with what was typed."""
    try:
        os.makedirs(os.path.dirname(path) or ".", 0o700, exist_ok=True)
        handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND | getattr(os, "O_NOFOLLOW", 0), 0o600)
        try:
            plain = stat.S_ISREG(os.fstat(handle).st_mode)
            if plain and hasattr(os, "fchmod"):
                os.fchmod(handle, 0o600)
        finally:
            os.close(handle)
    except OSError:
        return False
    return plain
