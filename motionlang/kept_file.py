"""A file of the user's cache that has many parts, each of which is read when it is asked for.

Every part has a note beside it and a digest of its own. A damaged or foreign file has no parts, and a damaged part is
none. The digest is that which Python has for sources: it is there already, and takes a twentieth of SHA-256's time.
"""

import _imp
import os
import sys
from marshal import loads

from motionlang import user_cache

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    # What stands beside a part, where it begins and ends, and its digest.
    Entry = tuple[Any, int, int, bytes]

# What digests are made with: another number where the layout of the file changes.
LAYOUT = 2
# How long the numbers are at the beginning of the file: the length of the index, and its digest.
NUMBER = 8


class KeptFile:
    """The parts of one file as they were when it was opened, by their names."""

    __slots__ = ("_begin", "_descriptor", "_index", "name")

    def __init__(self, kind: str, whose: tuple[object, ...]) -> None:
        """The file of a kind; `whose` is everything besides notes by which its parts are what they are."""
        self.name = f"{kind}-{digest(repr((sys.version, *whose)).encode('utf-8', 'backslashreplace')).hex()}"
        self._descriptor, self._begin, self._index = opened(self.name)

    def note(self, name: str) -> "Any":
        """What stands beside a part; None where there is none of that name."""
        entry = self._index.get(name)
        return None if entry is None else entry[0]

    def part(self, name: str) -> bytes | None:
        """The part of a name; None where there is none or it is damaged."""
        if name not in self._index or self._descriptor is None:
            return None
        _, begin, end, wanted = self._index[name]
        data = os.pread(self._descriptor, end - begin, self._begin + begin)
        return data if digest(data) == wanted else None


def digest(data: bytes) -> bytes:
    """The digest of a part."""
    return _imp.source_hash(LAYOUT, data)


def opened(name: str) -> "tuple[int | None, int, dict[str, Entry]]":
    """The file's descriptor, where its parts begin, and its index; no parts in a file that cannot be trusted."""
    file = user_cache.opened(name)
    if file is None:
        return None, 0, {}
    length = int.from_bytes(os.read(file, NUMBER), "little")
    if NUMBER < length < os.fstat(file).st_size:
        data = os.read(file, length)
        if digest(data[NUMBER:]) == data[:NUMBER]:
            return file, NUMBER + length, loads(data[NUMBER:])
    os.close(file)
    return None, 0, {}
