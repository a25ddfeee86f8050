"""A program: a text in a language, for a machine with some settings, and what it says."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.source import Source

if TYPE_CHECKING:
    from motionlang.kernel.lang.literals import Literal, Placed
    from motionlang.kernel.lang.machine.machine import Machine
    from motionlang.kernel.lang.names import LineLayout, Names
    from motionlang.kernel.lang.step_graph import StepGraph
    from motionlang.kernel.lang.structure import Structure
    from motionlang.kernel.lang.task import Task


@dataclass(eq=False, slots=True)
class Target:
    """The controller model that a program is written for, with the reasons; "" if nothing decides it.

    `others` are models that fit the program as well.
    """

    model: str
    reasons: list[str]
    others: list[str]


class Program:
    """A text, made once by `Dialect.program`; what it says is worked out once, when it is asked for.

    A program made of another one by `on`, `with_values` or `for_values` shares its text, which is not read again. The
    `values` of a program are in place of its own numbers and texts, by name or address.

    Any text has its `errors`, `diagnostics`, `names`, `layout` and `literals`. `tree`, `target` and `blocks`
    raise ProgramError for a text with syntax errors; `graph`, `structure` and `start` for a program with any error.
    """

    # The name of its language.
    language: str

    def __init__(self, source: Source, settings: Mapping[str, object] | None = None) -> None:
        self.source, self.settings = source, dict(settings or {})
        self.values: Mapping[str, float | str] = {}

    @property
    def tree(self) -> object:
        """The syntax tree."""
        raise NotImplementedError

    @property
    def errors(self) -> Sequence[Diagnostic]:
        """All errors, in text order."""
        raise NotImplementedError

    @property
    def diagnostics(self) -> Sequence[Diagnostic]:
        """The errors, and the warnings that come with them or that need no linter."""
        raise NotImplementedError

    def in_notation(self, text: str) -> str:
        """Return a hint or another text for the user in the notation of the program."""
        return text

    def worded(self, found: Sequence[Diagnostic]) -> Sequence[Diagnostic]:
        """Put hints and fixes of diagnostics of the program into its notation, and return these."""
        for each in found:
            each.hint, each.fix = self.in_notation(each.hint), self.in_notation(each.fix)
        return found

    def require(self) -> None:
        """Raise ProgramError if errors prevent a run."""
        if self.errors:
            raise ProgramError(self.errors)

    @property
    def names(self) -> Names:
        """The definitions, uses and blocks; statements with syntax errors have none."""
        raise NotImplementedError

    @property
    def layout(self) -> list[LineLayout] | None:
        """The indentation of each line; None for a language without blocks."""
        return None

    @property
    def literals(self) -> Sequence[Literal]:
        """The numbers of the text that have an address, in order; statements with syntax errors have none."""
        raise NotImplementedError

    @property
    def constants(self) -> Sequence[Literal]:
        """The numbers that the program gives to names, in order; they have a name in place of an address."""
        return ()

    @property
    def declared(self) -> Collection[str]:
        """The names that the program declares, in lower case; a keyword may be among them."""
        return ()

    @property
    def target(self) -> Target:
        """The controller model that the program is written for."""
        return Target("", [], [])

    @property
    def blocks(self) -> Sequence[tuple[str, int, int]]:
        """Name, first and last line of each sub, task and handler."""
        return ()

    @property
    def graph(self) -> StepGraph:
        """All steps on a machine with the settings, and which may follow each."""
        raise NotImplementedError

    @property
    def structure(self) -> Structure:
        """The statements, units and graph on a machine with the settings."""
        raise NotImplementedError

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
    def notes(self) -> Sequence[str]:
        """Chosen defaults that the motion depends on, a line each; none if the text has syntax errors."""
        return ()

    @property
    def places(self) -> Placed:
        """The places of the values in place of its own; raises ProgramError if an address is wrong."""
        raise NotImplementedError

    def on(self, settings: Mapping[str, object]) -> Program:
        """Return the program of the same text for a machine with other settings."""
        raise NotImplementedError

    def with_values(self, values: Mapping[str, float | str]) -> Program:
        """Return the program with values in place of some constants, by name or address.

        It has the positions of the text as it is. `require` raises ProgramError if a name or an address is wrong.
        """
        raise NotImplementedError

    def for_values(self, values: Mapping[str, float | str]) -> Program:
        """Return the program for runs with many values of some names and addresses, such as `values`.

        The machine of each run has the values. Raises ProgramError with all errors if no value of them is possible.
        """
        made = self.with_values(values)
        made.require()
        return self

    def start(self, machine: Machine) -> Task:
        """Return the program's parent task, bound to `machine` but not yet run."""
        raise NotImplementedError
