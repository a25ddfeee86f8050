"""A dialect: the interface of a language to the layers above.

`motionlang.kernel.mint.DIALECT` and `motionlang.kernel.mccl.DIALECT` implement it. Each method imports its modules when
it is called, so that a command imports only what it needs.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.source import Source
from motionlang.kernel.tools import nearest, shown

if TYPE_CHECKING:
    from motionlang.kernel.lang.debugging import Variable
    from motionlang.kernel.lang.keyword import Keyword
    from motionlang.kernel.lang.machine.machine import Machine
    from motionlang.kernel.lang.machine.switch import Switch
    from motionlang.kernel.lang.program import Program
    from motionlang.kernel.lang.task import Task
    from motionlang.kernel.lang.vocabulary import Vocabulary
    from motionlang.kernel.lang.wait_causes import Read


# The package of each dialect, imported by name on demand, as nothing below may import it.
PACKAGES = {"mint": "motionlang.kernel.mint", "mccl": "motionlang.kernel.mccl"}


def dialects() -> tuple[str, ...]:
    """Return the names of the dialects."""
    return tuple(PACKAGES)


def dialect(name: str) -> Dialect:
    """Return a dialect by its name.

    Raises ValueError with the choices if there is none.
    """
    if name not in PACKAGES:
        raise ValueError(f"there is no dialect {name!r}: {' or '.join(PACKAGES)}")
    __import__(PACKAGES[name])
    found: Dialect = sys.modules[PACKAGES[name]].DIALECT
    return found


def dialect_of(file: str) -> Dialect | None:
    """Return the dialect of a file extension, or None."""
    suffix = os.path.splitext(file)[1].lower()
    for name in dialects():
        if suffix in dialect(name).suffixes:
            return dialect(name)
    return None


def language_of(wanted: str | None, file: str) -> Dialect | None:
    """Return the requested dialect, or that of the file extension; None if there is neither."""
    return dialect(wanted) if wanted else dialect_of(file)


def dialect_for(source: Source, wanted: str | Dialect | None) -> Dialect:
    """Return the requested dialect, or that of the file extension.

    Raises ValueError if there is none.
    """
    if wanted is not None:
        return dialect(wanted) if isinstance(wanted, str) else wanted
    found = dialect_of(source.name)
    if found is None:
        raise ValueError(
            f"{source.name}: unknown file extension; choose the language with --lang mint or mccl"
        )
    return found


def parse(text: str, language: str) -> object:
    """Return the syntax tree of a text in "mint" or "mccl".

    A tree is a `Module` of `motionlang.kernel.mint.syntax.nodes` or of `motionlang.kernel.mccl.syntax.tree`. Raises
    ProgramError with all syntax errors, and ValueError for another language.
    """
    return dialect(language).program(Source("", text)).tree


def unknown_model(name: str, language: Dialect | None = None) -> tuple[str, str] | None:
    """Return message and hint for a controller name that is unknown, or known in another language only.

    Returns None if it is known. Without a language those of all languages are known.
    """
    languages = [dialect(each) for each in dialects()] if language is None else [language]
    if any(each.knows_model(name) for each in languages):
        return None
    near = nearest(name, [model for each in languages for model in each.models()])
    known = [f"{each.title} runs on {', '.join(each.models())}" for each in languages]
    hint = f"did you mean {near}?" if near else "; ".join(known)
    return f"{shown(name)} is not a known controller{f' of {language.title}' if language else ''}", hint


class Dialect:
    """A dialect: `name` for users, `title` for sentences, file `suffixes`, first axis."""

    name: str
    title: str
    suffixes: tuple[str, ...]
    first_axis: int
    # True if inputs and outputs have one series of numbers, so that an output can be read as an input is.
    has_one_series = False
    # The sign that begins a comment.
    comment: str
    # What of a program changes a variable while a task waits, for hints.
    others = "another task"
    # What gives a loop without an end one, for hints.
    ends_loops = "RP10 ends after ten repetitions, and BK or a jump leads out"
    # Verbs of commands whose parameter is a macro or a position in the program, and so no quantity.
    jumps: frozenset[str] = frozenset()

    def program(
        self, source: Source, settings: Mapping[str, object] | None = None, *, is_debug: bool = False
    ) -> Program:
        """Return the program of a text, for a machine with some settings.

        With `is_debug` it counts its statements, for a machine with a `hook`, and runs otherwise bit for bit alike.
        """
        raise NotImplementedError

    def port_differences(self, before: Program, program: Program) -> list[Diagnostic]:
        """Return what a program does differently on the model of its settings, with fixes where they are certain.

        `before` is the program as it was written, for another model; `program` is in the notation of this one.
        """
        return []

    def compiled_in(self, key: str) -> bool:
        """True if the check of a program depends on a key of the machine file."""
        return False

    def forms(self, row: Keyword) -> tuple[str, ...]:
        """Return the spellings of a keyword, with a for an axis and n for a number.

        The result is () if the keyword's row states them.
        """
        return ()

    def models(self) -> tuple[str, ...]:
        """Return the names of the controllers that use the dialect."""
        return ()

    def knows_model(self, name: str) -> bool:
        """True if a name is that of a controller of the dialect, in any spelling."""
        return name in self.models()

    def setting_problem(self, key: str, value: object) -> tuple[str, str] | None:
        """Return message and hint for a key of the dialect's own section, None if valid."""
        return None

    def switches(self) -> Mapping[str, Switch]:
        """Return the assumptions that the machine file may set, by name."""
        return {}

    def driven_by(self, why: str) -> list[str]:
        """Return the tables and keys of the machine file that could end a wait.

        `why` is the text that describes the wait.
        """
        return []

    def triggers(self, task: Task, latches: Sequence[int]) -> tuple[frozenset[Read], str]:
        """Return the inputs that trigger latches, and a hint if one of the latches does not wait for its trigger."""
        return frozenset(), ""

    def table(self) -> Vocabulary:
        """Return the vocabulary."""
        raise NotImplementedError

    def opener(self, word: str) -> str:
        """Return the keyword of the block that a word closes or continues, such as WHILE for ENDW; "" for others."""
        return ""

    def locate(self, source: Source, at: int) -> tuple[int, int, int]:
        """Return line, column and length of the source position `at` of a task or a node."""
        raise NotImplementedError

    def locations(self, source: Source, offsets: Sequence[int]) -> list[tuple[int, int, int]]:
        """Return line, column and length for each of many source positions."""
        return [self.locate(source, at) for at in offsets]

    def has_code(self, line: str) -> bool:
        """True if a line has more than blanks and a comment.

        The test is cheap, because a profile calls it after every run.
        """
        return bool(line.strip())

    def interactive(self, machine: Machine) -> Interactive:
        """Return an interpreter for lines that are typed one after another."""
        raise NotImplementedError

    def tokens(self, text: str) -> Iterator[tuple[str, str, int]]:
        """Yield kind, text and offset of each token, for highlighting; never fails."""
        raise NotImplementedError


class Interactive:
    """An interpreter that remembers the names of a program from line to line.

    `keeps_columns` is true if diagnostics about an earlier text, such as a macro, have columns of that text.
    """

    keeps_columns = False

    def is_complete(self, text: str) -> bool:
        """False while `text` leaves a block open, so that more lines must follow."""
        return True

    def task(self, source: Source) -> Task:
        """Return the task that executes `source`; ProgramError if it is invalid."""
        raise NotImplementedError

    def variables(self) -> list[Variable]:
        """Return the variables or registers that the lines so far have assigned."""
        raise NotImplementedError
