"""The package's bytecode in one file of the user's cache, so that a command need not look for each of its modules.

Python finds, opens and checks a .pyc file for each of the hundred modules of a start, which takes longer than to make
code of what is in them. Here they are found in an index. Only the command does so: who imports the package gets it as
always.

A module is taken from the file only where its source is what it was: size, time of the text and time of the last
change, of which Python itself asks the first two. Whatever else there is (a new module, another Python, a damaged file)
is left to Python, and `bytecode_writing` puts it into the file when the command ends, unless no bytecode is to be
written. So is what else a start needs and this Python always makes alike (`kept`, `remember`).

What stands here, and what it imports, Python itself has to look for, and so it imports no other file: `__future__` is
one.
"""

import _frozen_importlib as bootstrap
import _frozen_importlib_external as external
import os
import sys
from marshal import loads

from motionlang import user_cache
from motionlang.kept_file import KeptFile

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from importlib.machinery import ModuleSpec
    from types import CodeType, ModuleType

    from motionlang.user_cache import State

    # What stands beside a module's code: source, where the bytecode would be, the state of the source, and whether it
    # is the code that Python makes, with what no command shows.
    Note = tuple[str, str | None, State, bool]

PACKAGE = "motionlang."


class Finder:
    """Finds modules of the package in the file, and knows which it did not find there."""

    __slots__ = ("file", "made", "missed", "whole")

    # The one that `install` made; None in every process that is no command.
    of_the_command: "Finder | None" = None

    def __init__(self, folder: str) -> None:
        self.file = KeptFile(
            "bytecode", (folder, external.MAGIC_NUMBER, sys.flags.optimize, sys.pycache_prefix)
        )
        # Modules that were not there, and those that were with what no command shows.
        self.missed: list[str] = []
        self.whole: list[str] = []
        self.made: dict[str, bytes] = {}

    def find_spec(
        self, name: str, path: "Sequence[str] | None" = None, target: "ModuleType | None" = None
    ) -> "ModuleSpec | None":
        """As every finder of `sys.meta_path` has it; None leaves the module to the next one."""
        note: Note | None = self.file.note(name)
        if note is None or not holds(note):
            if name.startswith(PACKAGE):
                self.missed.append(name)
            return None
        source, cached, _, _ = note
        spec: ModuleSpec = bootstrap.ModuleSpec(name, Loader(name, source, self), origin=source)
        spec.has_location = True
        spec.cached = cached
        if source.endswith("__init__.py"):
            spec.submodule_search_locations = [os.path.dirname(source)]
        return spec

    def code(self, name: str) -> "CodeType | None":
        """The code of a module that was found; None where the file is damaged."""
        part = self.file.part(name)
        if part is None:
            self.missed.append(name)
            return None
        if self.file.note(name)[3]:
            self.whole.append(name)
        code: CodeType = loads(part)
        return code

    def kept(self, name: str) -> bytes | None:
        """What `remember` was told under a name that is none of a module, here or in an earlier command."""
        return self.file.part(name)

    def remember(self, name: str, part: bytes) -> None:
        """Keep what depends on nothing but this Python and its own name."""
        self.made[name] = part

    @property
    def lacks(self) -> bool:
        """Whether there is anything to put into the file."""
        return bool(self.missed or self.whole or self.made)


class Loader(external.SourceFileLoader):
    """Python's own loader of sources, but for where the code comes from."""

    def __init__(self, name: str, path: str, finder: Finder) -> None:
        super().__init__(name, path)
        self._finder = finder

    def get_code(self, fullname: str) -> "CodeType | None":
        """The code in the file, or else what Python makes of the source."""
        return self._finder.code(fullname) or super().get_code(fullname)


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
    finder = Finder.of_the_command = Finder(os.path.dirname(__file__))
    sys.meta_path.insert(0, finder)
    return finder


def holds(note: "Note | None") -> bool:
    """Whether the source beside which a code was noted is what it was; a part without a source always holds."""
    return note is None or user_cache.state(note[0]) == note[2]
