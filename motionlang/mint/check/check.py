"""Check a program: resolve its names, report its mistakes, and annotate its expressions."""

from __future__ import annotations

from motionlang.lang.nesting import StackSpace
from motionlang.mint.keywords import table
from motionlang.mint.resolve.aliases import rename_old_words
from motionlang.mint.resolve.names import Names
from motionlang.mint.resolve.problems import Problems

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from motionlang.mint.resolve.recall import Recall
    from motionlang.mint.resolve.symbols import Scope
    from motionlang.mint.syntax.nodes import Module


class Checked:
    """A program without errors: its names and its warnings."""

    __slots__ = ("names", "problems")

    def __init__(self, names: Names, problems: Problems) -> None:
        self.names, self.problems = names, problems


def check_module(module: Module, settings: Mapping[str, object], recall: Recall | None = None) -> Checked:
    """Check a program; raise ProgramError with all errors.

    With `recall` the functions that it already has are not checked again, so they have no types.
    """
    rename_old_words(module, settings)
    return _checked(module, settings, Problems(module), None)


def check_line(
    module: Module, settings: Mapping[str, object], scope: Scope, of_program: bool = False
) -> Checked:
    """Check a line typed at a prompt, with the names of `scope`; raise ProgramError with all errors.

    With `of_program` it is a whole program, whose lines may trigger faults of the machine file.
    """
    with StackSpace():
        return _checked(module, settings, Problems(module), scope)


def _checked(
    module: Module, settings: Mapping[str, object], problems: Problems, scope: Scope | None
) -> Checked:
    names = Names(table(), problems, scope)
    names.declare_module(module)
    problems.raise_errors()
    return Checked(names, problems)
