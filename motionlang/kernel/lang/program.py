"""A checked program: a dialect's result for a source, ready to be started."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from motionlang.kernel.errors import Diagnostic

if TYPE_CHECKING:
    from motionlang.kernel.lang.machine.machine import Machine
    from motionlang.kernel.lang.task import Task


class Program:
    """A program that can be started; each dialect has its own class."""

    __slots__ = ()

    @property
    def is_doubtful(self) -> bool:
        """True if the program begins with unknown text, perhaps of another language."""
        return False

    @property
    def offsets(self) -> Sequence[int]:
        """The source offsets of the statements of a debug build, at which it can stop."""
        return ()

    @property
    def entries(self) -> Sequence[int]:
        """The statements of a debug build that begin a macro within a line."""
        return ()

    @property
    def warnings(self) -> Sequence[Diagnostic]:
        """Warnings to report before a run."""
        return ()

    @property
    def remarks(self) -> Sequence[str]:
        """Chosen defaults that the motion depends on, a line each."""
        return ()

    def start(self, machine: Machine) -> Task:
        """Return the program's parent task, bound to `machine` but not yet run."""
        raise NotImplementedError
