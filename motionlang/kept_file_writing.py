"""How a file of the user's cache that has many parts is given more of them: it is written anew."""

from __future__ import annotations

from marshal import dumps

from motionlang.kept_file import NUMBER, digest, opened
from motionlang.user_cache_writing import write

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from typing import Any

    from motionlang.kept_file import Entry


def add(name: str, parts: Mapping[str, tuple[Any, bytes]], holds: Callable[[Any], bool]) -> None:
    """Write the file of a name with more parts, and those that it has by now and whose note holds."""
    everything = {**_held(name, holds), **parts}
    index: dict[str, Entry] = {}
    begin = 0
    for each, (note, part) in everything.items():
        index[each] = note, begin, begin + len(part), digest(part)
        begin += len(part)
    head = dumps(index)
    length = (NUMBER + len(head)).to_bytes(NUMBER, "little")
    write(name, [length, digest(head), head, *(part for _, part in everything.values())])


def _held(name: str, holds: Callable[[Any], bool]) -> dict[str, tuple[Any, bytes]]:
    """What stands in the file now, as another process may have written it, as far as its notes hold."""
    file, first, index = opened(name)
    if file is None:
        return {}
    with open(file, "rb") as whole:
        whole.seek(first)
        data = whole.read()
    return {
        name: (note, part)
        for name, (note, begin, end, wanted) in index.items()
        if holds(note) and digest(part := data[begin:end]) == wanted
    }
