"""Compiled programs and read machine files, kept between runs as Python keeps its .pyc files.

An entry is a file of the user's cache folder, named after what it was made of: of a program text, dialect, settings and
the version of Python. It holds all of that, and the state of every file of the package that was loaded to make it: one
that belongs to something else, or to files that are others by now, is ignored, and so is a damaged one.
"""

from __future__ import annotations

import os
import sys
from marshal import dumps, loads

from motionlang import user_cache
from motionlang.kept_file import digest

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.user_cache import State

# What compiling takes besides a language's own package; a test holds it to what a compilation imports.
SHARED = ("lang" + os.sep, "errors.py", "source.py", os.path.join("controller", "faults.py"))
# What of that package no compilation takes: the operations of keywords, what looks programs over, what rows rest on.
RUN, ASIDE = "_operations.py", ("lint", "evidence")
# How long the digest at the beginning of an entry is.
DIGEST = 8


class Entry:
    """The place in the cache of what is made of some parts by some files of the package."""

    __slots__ = ("_makers", "_name", "_states", "_whose")

    def __init__(self, kind: str, makers: tuple[str, ...], *parts: str) -> None:
        """`makers` are folders, which end with a separator, and files: those that are loaded count."""
        self._makers = makers
        self._whose = (sys.version, *makers, *parts)
        text = "\0".join(self._whose)
        self._name = f"{kind}-{digest(text.encode('utf-8', 'surrogatepass')).hex()}"
        # Of what made what is kept already.
        self._states: dict[str, State] = {}

    def get(self) -> bytes | None:
        """What was put; None where there is nothing that these files would make."""
        file = user_cache.opened(self._name)
        if file is None:
            return None
        try:
            with open(file, "rb") as entry:
                data = entry.read()
        except OSError:
            return None
        if digest(data[DIGEST:]) != data[:DIGEST]:
            return None
        whose, states, payload = loads(data[DIGEST:])
        if whose != self._whose or not user_cache.unchanged(states):
            return None
        self._states = dict(states)
        found: bytes = payload
        return found

    def put(self, payload: bytes) -> None:
        """Keep what has just been made, or more of what was kept; no reader sees half of it.

        Nothing is kept where there are no files to look at, as in a zip archive.
        """
        try:
            loaded = _loaded(self._makers)
        except OSError:
            return
        states = {**self._states, **loaded}
        if any(states[place] != state for place, state in self._states.items()):
            return  # what was kept is of other files than what has been added
        self._states = states
        data = dumps((self._whose, [*states.items()], payload))
        from motionlang.user_cache_writing import write

        write(self._name, (digest(data), data))


def program_entry(package: str, *parts: str) -> Entry:
    """The place of a program, compiled by the language whose folder is `package`."""
    root = os.path.dirname(package) + os.sep
    return Entry("program", (package + os.sep, *(root + name for name in SHARED)), *parts)


def machine_entry(text: str) -> Entry:
    """The place of the settings of a machine file, which all that was loaded by then may have judged."""
    return Entry("machine", (os.path.dirname(os.path.dirname(__file__)) + os.sep,), text)


def _loaded(makers: tuple[str, ...]) -> dict[str, State]:
    """The files of the package that made something, and their state; OSError where one is not there."""
    places = [
        place
        for module in [*sys.modules.values()]
        if (place := getattr(module, "__file__", None)) is not None and place.startswith(makers)
        if not place.endswith(RUN) and not any(f"{os.sep}{name}{os.sep}" in place for name in ASIDE)
    ]
    for folder, _, files in os.walk(makers[0], onerror=_refuse):
        if os.path.basename(folder) not in ASIDE:
            places += [os.path.join(folder, name) for name in files if name.endswith(".txt")]
    found = {}
    for place in places:
        state = user_cache.state(place)
        if state is None:
            raise FileNotFoundError(place)
        found[place] = state
    return found


def _refuse(error: OSError) -> None:
    raise error
