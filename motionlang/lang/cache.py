"""Compiled programs, kept between runs as Python keeps its .pyc files.

An entry is a file of the user's cache folder, named after what is compiled: text, dialect, settings, the version of
Python. It holds all of that, and the state of every file of the compiler that was loaded when it was made: one that
belongs to something else, or to files that are others by now, is ignored, and so is a damaged one.
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
    """The place in the cache of one program, compiled by the language whose folder is `package`."""

    __slots__ = ("_compiler", "_name", "_package", "_whose")

    def __init__(self, package: str, *parts: str) -> None:
        self._package = package
        self._whose = (sys.version, package, *parts)
        text = "\0".join(self._whose)
        self._name = f"program-{digest(text.encode('utf-8', 'surrogatepass')).hex()}"
        # What made the parts of the program that were kept already.
        self._compiler: dict[str, State] = {}

    def get(self) -> bytes | None:
        """The program; None where there is none that this compiler would make."""
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
        whose, compiler, payload = loads(data[DIGEST:])
        if whose != self._whose or any(user_cache.state(place) != state for place, state in compiler):
            return None
        self._compiler = dict(compiler)
        found: bytes = payload
        return found

    def put(self, payload: bytes) -> None:
        """Keep a program that has just been compiled, or more of one that was kept; no reader sees half of it.

        Nothing is kept where there are no files to look at, as in a zip archive.
        """
        try:
            loaded = _compiler(self._package)
        except OSError:
            return
        compiler = {**self._compiler, **loaded}
        if any(compiler[place] != state for place, state in self._compiler.items()):
            return  # what was kept is of another compiler than what has been added
        self._compiler = compiler
        data = dumps((self._whose, [*compiler.items()], payload))
        user_cache.write(self._name, (digest(data), data))


def _compiler(package: str) -> dict[str, State]:
    """The files of a compiler, as far as it is loaded, and their state; OSError where one is not there."""
    root = os.path.dirname(package) + os.sep
    whole = (package + os.sep, *(root + name for name in SHARED))
    places = [
        place
        for module in [*sys.modules.values()]
        if (place := getattr(module, "__file__", None)) is not None and place.startswith(whole)
        if not place.endswith(RUN) and not any(f"{os.sep}{name}{os.sep}" in place for name in ASIDE)
    ]
    for folder, _, files in os.walk(package, onerror=_refuse):
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
