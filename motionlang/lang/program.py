"""A compiled program: what a dialect makes of a source, ready to be started on a machine."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.errors import Diagnostic
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.task import Task

    # The blocks of a program as `Dialect.blocks` has them, and the lines of places in it.
    Outline = tuple[list[tuple[str, int, int]], dict[int, int]]


class Program:
    """Something that can be started; each dialect has its own."""

    __slots__ = ()

    @property
    def size(self) -> int:
        """How much of it is compiled, where that grows as it runs."""
        return 0

    @property
    def is_doubtful(self) -> bool:
        """Whether it begins with what the language does not know: it may be in another one."""
        return False

    @property
    def warnings(self) -> Sequence[Diagnostic]:
        """What a run of it must be told beforehand."""
        return ()

    @property
    def outline(self) -> Outline | None:
        """What of the text is known without reading it again: blocks and lines; None where nothing is kept."""
        return None

    def start(self, machine: Machine) -> Task:
        """The parent task of the program, bound to `machine`, not yet run."""
        raise NotImplementedError

    def payload(self) -> bytes | None:
        """The program as bytes for the cache, for `Dialect.load`; None where compiling is as quick."""
        return None
