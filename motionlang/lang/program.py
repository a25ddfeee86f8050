"""A compiled program: the result of a dialect for a source, ready to be started."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.errors import Diagnostic
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.task import Task

    # The blocks of a program in the form of `Dialect.blocks`, and the lines of source positions in it.
    Outline = tuple[list[tuple[str, int, int]], dict[int, int]]


class Program:
    """A program that can be started; each dialect has its own class."""

    __slots__ = ()

    @property
    def size(self) -> int:
        """How much of it is compiled, if that grows as it runs."""
        return 0

    @property
    def is_doubtful(self) -> bool:
        """True if it begins with unknown text: it may be in another language."""
        return False

    @property
    def places(self) -> Sequence[int]:
        """The source offsets of the statements of a debug build, at which it can stop."""
        return ()

    @property
    def entries(self) -> Sequence[int]:
        """The statements of a debug build that begin a macro in the middle of a line."""
        return ()

    @property
    def warnings(self) -> Sequence[Diagnostic]:
        """Warnings to report before a run."""
        return ()

    @property
    def outline(self) -> Outline | None:
        """Blocks and lines, known without parsing again; None if they are not stored."""
        return None

    def start(self, machine: Machine) -> Task:
        """Return the parent task of the program, bound to `machine`, not yet run."""
        raise NotImplementedError

    def payload(self) -> bytes | None:
        """Return the program as bytes for the cache and `Dialect.load`.

        None if compiling is as quick.
        """
        return None
