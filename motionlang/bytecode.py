"""The package's bytecode in one file of the user's cache, so that a command need not look for each of its modules.

Python finds, opens and checks a .pyc file for each of the hundred modules of a start, which takes longer than to make
code of what is in them. Here they are found in an index. Only the command does so: who imports the package gets it as
always.

A module is taken from the file only where its source is what it was: size, time of the text and time of the last
change, of which Python itself asks the first two. Whatever else there is (a new module, another Python, a damaged file)
is left to Python, and put into the file when the command ends, unless no bytecode is to be written.
"""

from __future__ import annotations

import _frozen_importlib as bootstrap
import _frozen_importlib_external as external
import _imp
import os
import sys
from marshal import dumps, loads

from motionlang import user_cache

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from importlib.machinery import ModuleSpec
    from types import CodeType, ModuleType

    # Size, time of the text and time of the last change.
    State = tuple[int, int, int]
    # Source, where the bytecode would be, state of the source, where the code begins and ends, and its digest.
    Entry = tuple[str, str | None, State, int, int, bytes]
    # The same with the code itself.
    Compiled = tuple[str, str | None, State, bytes]

PACKAGE = "motionlang."
# What digests are made with: another number where the layout of the file changes.
LAYOUT = 1
# How long the numbers are at the beginning of the file: the length of the index, and its digest.
NUMBER = 8


def install() -> Finder | None:
    """Find the package's modules in the file from now on; None where it is not to be used.

    That is where there is no cache, and where somebody looks on who may want to see each module as it is read.
    """
    if sys.implementation.name != "cpython" or not hasattr(os, "pread"):
        return None
    if type(user_cache.__loader__) is not external.SourceFileLoader or sys.gettrace() or sys.getprofile():
        return None
    if not user_cache.wanted() or "--no-cache" in sys.argv:
        return None
    finder = Finder(os.path.dirname(__file__))
    sys.meta_path.insert(0, finder)
    return finder


class Finder:
    """Finds modules of the package in the file, and knows which it did not find there."""

    __slots__ = ("_begin", "_entries", "_file", "_name", "missed")

    def __init__(self, folder: str) -> None:
        whose = (folder, sys.version, external.MAGIC_NUMBER, sys.flags.optimize, sys.pycache_prefix)
        self._name = f"bytecode-{_digest(repr(whose).encode('utf-8', 'backslashreplace')).hex()}"
        self._file, self._begin, self._entries = _opened(self._name)
        self.missed: list[str] = []

    def find_spec(
        self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """As every finder of `sys.meta_path` has it; None leaves the module to the next one."""
        entry = self._entries.get(name)
        if entry is None or _state(entry[0]) != entry[2]:
            if name.startswith(PACKAGE):
                self.missed.append(name)
            return None
        source = entry[0]
        spec: ModuleSpec = bootstrap.ModuleSpec(name, Loader(name, source, self), origin=source)
        spec.has_location = True
        spec.cached = entry[1]
        if source.endswith("__init__.py"):
            spec.submodule_search_locations = [os.path.dirname(source)]
        return spec

    def code(self, name: str) -> CodeType | None:
        """The code of a module that was found; None where the file is damaged."""
        _, _, _, begin, end, digest = self._entries[name]
        assert self._file is not None
        data = os.pread(self._file, end - begin, self._begin + begin)
        if _digest(data) != digest:
            self.missed.append(name)
            return None
        code: CodeType = loads(data)
        return code

    def keep(self) -> None:
        """Put what was missed into the file, beside what stands there and still holds."""
        if not self.missed or sys.dont_write_bytecode or not user_cache.writable():
            return
        new = {name: each for name in self.missed if (each := _compiled(sys.modules.get(name))) is not None}
        if new:
            everything = _still_valid(self._name) | new
            user_cache.write(self._name, _parts(everything))


class Loader(external.SourceFileLoader):
    """Python's own loader of sources, but for where the code comes from."""

    def __init__(self, name: str, path: str, finder: Finder) -> None:
        super().__init__(name, path)
        self._finder = finder

    def get_code(self, fullname: str) -> CodeType | None:
        """The code in the file, or else what Python makes of the source."""
        return self._finder.code(fullname) or super().get_code(fullname)


def _opened(name: str) -> tuple[int | None, int, dict[str, Entry]]:
    """The file's descriptor, where codes begin in it, and its index; nothing of a file that cannot be trusted."""
    file = user_cache.opened(name)
    if file is None:
        return None, 0, {}
    length = int.from_bytes(os.read(file, NUMBER), "little")
    if NUMBER < length < os.fstat(file).st_size:
        data = os.read(file, length)
        if _digest(data[NUMBER:]) == data[:NUMBER]:
            return file, NUMBER + length, loads(data[NUMBER:])
    os.close(file)
    return None, 0, {}


def _still_valid(name: str) -> dict[str, Compiled]:
    """What stands in the file now, as another process may have written it, without sources that are another by now."""
    file, begin, entries = _opened(name)
    if file is None:
        return {}
    with open(file, "rb") as whole:
        whole.seek(begin)
        data = whole.read()
    return {
        name: (source, cached, state, code)
        for name, (source, cached, state, begin, end, digest) in entries.items()
        if _state(source) == state and _digest(code := data[begin:end]) == digest
    }


def _parts(everything: dict[str, Compiled]) -> list[bytes]:
    """The file, piece by piece."""
    index: dict[str, Entry] = {}
    begin = 0
    for name, (source, cached, state, code) in everything.items():
        index[name] = source, cached, state, begin, begin + len(code), _digest(code)
        begin += len(code)
    head = dumps(index)
    length = (NUMBER + len(head)).to_bytes(NUMBER, "little")
    return [length, _digest(head), head, *(code for _, _, _, code in everything.values())]


def _compiled(module: ModuleType | None) -> Compiled | None:
    """A module's source and code; None for one that Python did not load from a source."""
    spec = getattr(module, "__spec__", None)
    if spec is None or spec.origin is None or not isinstance(spec.loader, external.SourceFileLoader):
        return None
    before = _state(spec.origin)
    try:
        code = external.SourceFileLoader.get_code(spec.loader, spec.name)
    except (OSError, SyntaxError):  # the source is another one by now
        return None
    if before is None or _state(spec.origin) != before:
        return None
    return spec.origin, spec.cached, before, dumps(code)


def _state(source: str) -> State | None:
    try:
        status = os.stat(source)
    except OSError:
        return None
    return status.st_size, status.st_mtime_ns, status.st_ctime_ns


def _digest(data: bytes) -> bytes:
    """Python's own digest of sources: it is there already, and takes a twentieth of the time of SHA-256."""
    return _imp.source_hash(LAYOUT, data)
