"""History of typed lines, stored between sessions in the user's state folder.

If that folder cannot be written, the history is in memory only.
"""

from __future__ import annotations

import os
import stat

from prompt_toolkit.history import FileHistory, History, InMemoryHistory

from motionlang.kernel.cache import own_folder

# Names another file; an empty value stores no history.
VARIABLE = "MOTIONLANG_HISTORY"


def history(dialect: str) -> History:
    folder = own_folder("Application Support", "XDG_STATE_HOME", os.path.join(".local", "state"))
    path = os.environ.get(VARIABLE, os.path.join(folder, f"{dialect}-history") if folder else "")
    return SafeHistory(path) if path and _is_writable(path) else InMemoryHistory()


class SafeHistory(FileHistory):
    """A history whose errors, such as a full disk, do not disturb the session."""

    def store_string(self, string: str) -> None:
        try:
            super().store_string(string)
        except OSError:
            return


def _is_writable(path: str) -> bool:
    """True if the file is, or can be created, writable and private to this user.

    Typed lines are private.
    """
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
