"""The user's cache folder: where it is, and how an entry of it is opened.

An entry is used only if it belongs to this user and nobody else may write it, nor anything beside it. No trouble with
the cache is ever an error of a command.
"""

import os
import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

    # Size, time of the text and time of the last change.
    State = tuple[int, int, int]

OFF = "MOTIONLANG_NO_CACHE"


def wanted() -> bool:
    """Whether the environment leaves the cache on."""
    return not os.environ.get(OFF)


def folder() -> str | None:
    """The user's cache folder for motionlang; `MOTIONLANG_CACHE` names another one. None without a home."""
    named = os.environ.get("MOTIONLANG_CACHE")
    if named:
        return named
    return own_folder("Caches", "XDG_CACHE_HOME", ".cache")


def own_folder(on_a_mac: str, variable: str, elsewhere: str) -> str | None:
    """The user's folder for motionlang of one kind: in ~/Library, in the folder that `variable` names, or in the home.

    None where that would be relative to the working folder: a user without an entry in the password file and without
    HOME, as in a container, has no home, and a relative `variable` is ignored, as the XDG specification demands.
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


def opened(name: str) -> int | None:
    """The descriptor of an entry's file, which the caller closes; None where there is none that can be trusted."""
    place = folder() if wanted() else None
    if place is None:
        return None
    try:
        if not is_private(os.stat(place)):
            return None
        file = os.open(os.path.join(place, name), os.O_RDONLY | getattr(os, "O_BINARY", 0))
    except OSError:
        return None
    if is_private(os.fstat(file)):
        return file
    os.close(file)
    return None


def state(place: str) -> "State | None":
    """By what a file can be told from what it was; None where there is none.

    Nobody can set the time of the last change: an installer may give all files the same time, of all versions.
    """
    try:
        status = os.stat(place)
    except OSError:
        return None
    return status.st_size, status.st_mtime_ns, status.st_ctime_ns


def unchanged(states: "Iterable[tuple[str, State]]") -> bool:
    """Whether every file is in the state that `state` once had of it."""
    stat = os.stat  # written out: a start asks for a hundred files
    try:
        for place, (size, text, change) in states:
            status = stat(place)
            if status.st_ctime_ns != change or status.st_mtime_ns != text or status.st_size != size:
                return False
    except OSError:
        return False
    return True


def is_private(status: os.stat_result) -> bool:
    """Whether a file or folder is this user's own and closed to writers; Windows folders are per user already."""
    if not hasattr(os, "getuid"):
        return True
    return status.st_uid == os.getuid() and not status.st_mode & 0o022
