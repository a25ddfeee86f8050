"""How an entry of the user's cache is written: whole or not at all, and the oldest ones make room."""

from __future__ import annotations

import os

from motionlang.files import replacing
from motionlang.user_cache import folder, is_private, wanted

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

ENTRIES = 512


def writable() -> bool:
    """Whether the folder is there and an entry may be written into it; it is made where it is not there yet."""
    return _writable() is not None


def write(name: str, parts: Iterable[bytes]) -> None:
    """Write an entry; no reader sees half of it, and the oldest entries make room."""
    place = _writable()
    if place is None:
        return
    try:
        with replacing(os.path.join(place, name), private=True) as file:
            file.write(b"".join(parts))
        _prune(place)
    except OSError:
        pass


def _writable() -> str | None:
    """The cache folder, made if it is missing; None if the cache is off or the folder cannot be written."""
    place = folder() if wanted() else None
    if place is None:
        return None
    try:
        os.makedirs(place, 0o700, exist_ok=True)
        return place if is_private(os.stat(place)) and os.access(place, os.W_OK) else None
    except OSError:
        return None


def _prune(place: str) -> None:
    """Drop the oldest half once there are too many."""
    entries = [entry for entry in os.scandir(place) if entry.is_file()]
    if len(entries) <= ENTRIES:
        return
    entries.sort(key=lambda entry: entry.stat().st_mtime)
    for entry in entries[: len(entries) - ENTRIES // 2]:
        _remove(entry.path)


def _remove(path: str) -> None:
    try:
        os.remove(path)
    except OSError:
        pass
