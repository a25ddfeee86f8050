"""The user's folders of motionlang: the cache folder, and the folder of what a user keeps."""

from __future__ import annotations

import os
import sys


def folder() -> str | None:
    """Return the user's cache folder; None without a home.

    `MOTIONLANG_CACHE` overrides it.
    """
    return os.environ.get("MOTIONLANG_CACHE") or own_folder("Caches", "XDG_CACHE_HOME", ".cache")


def own_folder(on_a_mac: str, variable: str, elsewhere: str) -> str | None:
    """Return the user's motionlang folder of one kind.

    It is in ~/Library, in the folder that the environment `variable` names, or in the home. The result is None if that
    would be relative to the working folder: a user without an entry in the password file and without HOME, as in a
    container, has no home. A relative `variable` is ignored, as the XDG specification requires.
    """
    home = os.path.expanduser("~")
    if sys.platform == "win32":
        root = os.environ.get("LOCALAPPDATA") or os.path.join(home, "AppData", "Local")
    elif sys.platform == "darwin":
        root = os.path.join(home, "Library", on_a_mac)
    else:
        root = os.environ.get(variable, "")
        if not os.path.isabs(root):
            root = os.path.join(home, elsewhere)
    return os.path.join(root, "motionlang") if os.path.isabs(root) else None


def path_of(name: str) -> str | None:
    """Return the path of a file in the cache folder; None if the folder or the file is not trustworthy."""
    directory = folder()
    if directory is None:
        return None
    try:
        os.makedirs(directory, 0o700, exist_ok=True)
        if not _is_private(os.stat(directory)) or not os.access(directory, os.W_OK):
            return None
        path = os.path.join(directory, name)
        return path if not os.path.exists(path) or _is_private(os.stat(path)) else None
    except OSError:
        return None


def _is_private(status: os.stat_result) -> bool:
    """True if a file belongs to this user and no other user can write to it.

    Windows folders are per user already.
    """
    if not hasattr(os, "getuid"):
        return True
    return status.st_uid == os.getuid() and not status.st_mode & 0o022
