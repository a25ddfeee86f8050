"""A dialect: the one face that a language shows to everything above it.

`motionlang.mint.DIALECT` and `motionlang.mccl.DIALECT` are the two. Each method imports what it needs when it is
called, so that a cached program starts without a parser.
"""

from __future__ import annotations

import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping
    from typing import Any

    from motionlang.errors import Diagnostic
    from motionlang.lang.asked import Asked
    from motionlang.lang.keyword import Table
    from motionlang.lang.listing import Listing
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.machine.switch import Switch
    from motionlang.lang.program import Program
    from motionlang.lang.task import Task
    from motionlang.source import Source

    # The accelerator of that name: the followed variables of a function, and the ranges by node.
    Ranges = Callable[[Any], tuple[set[Any], dict[int, Any]]]


# Where each dialect lives: found by its name when somebody wants it, as nothing below it may import it.
PACKAGES = {"mint": "motionlang.mint", "mccl": "motionlang.mccl"}


def dialects() -> tuple[str, ...]:
    """The names of the dialects."""
    return tuple(PACKAGES)


def dialect(name: str) -> Dialect:
    """A dialect by its name; KeyError where there is none."""
    __import__(PACKAGES[name])
    found: Dialect = sys.modules[PACKAGES[name]].DIALECT
    return found


def unknown_model(name: str) -> tuple[str, str] | None:
    """What is wrong with the name of a controller that no dialect knows, and a hint; None where one does."""
    from motionlang.errors import nearest, shown

    languages = [dialect(each) for each in dialects()]
    if any(each.knows_model(name) for each in languages):
        return None
    models = [model for each in languages for model in each.models()]
    near = nearest(name, models)
    hint = f"did you mean {near}?" if near else f"there are {', '.join(models)}"
    return f"{shown(name)} is no controller that is known here", hint


class Dialect:
    """`name` as users write it, `title` as a sentence has it, its file `suffixes`, the number of its first axis.

    `cached` says that compiled programs are worth keeping: `Program.payload` and `load` are for those.
    """

    name: str
    title: str
    suffixes: tuple[str, ...]
    first_axis: int
    cached = False

    def compile(
        self, source: Source, settings: dict[str, object] | None = None, ranges: Ranges | None = None
    ) -> Program:
        """Parse and compile; ProgramError with every mistake of the text.

        `ranges` is the accelerator of that name.
        """
        raise NotImplementedError

    def compile_given(
        self,
        source: Source,
        settings: dict[str, object],
        values: Mapping[str, float | str],
        ranges: Ranges | None = None,
    ) -> Program:
        """A program that is to be run with many `values` of its names; like `compile` where it is no matter."""
        return self.compile(source, settings, ranges)

    def listing(
        self,
        source: Source,
        settings: dict[str, object],
        overrides: Mapping[str, float | str],
        ranges: Ranges | None = None,
    ) -> Listing:
        """What a run with these settings and overrides executes, to read; ProgramError with every mistake.

        `ranges` is as in `compile`.
        """
        raise NotImplementedError

    def compiled_in(self, key: str) -> bool:
        """Whether a compiled program depends on a key of the machine file."""
        return False

    def check(self, source: Source, settings: Mapping[str, object] | None = None) -> list[Diagnostic]:
        """Every mistake and every warning, nothing run; `settings` are those of the machine file."""
        raise NotImplementedError

    def models(self) -> tuple[str, ...]:
        """The names of the controllers that speak the dialect."""
        return ()

    def knows_model(self, name: str) -> bool:
        """Whether a name is that of such a controller, however it may be spelt."""
        return name in self.models()

    def setting_problem(self, key: str, value: object) -> tuple[str, str] | None:
        """What is wrong with a key of the dialect's own section of the machine file, and a hint; None for nothing."""
        return None

    def switches(self) -> Mapping[str, Switch]:
        """The readings that the machine file may set, by their names."""
        return {}

    def what_ends(self, why: str) -> str:
        """A hint at what would end a wait that is told as `why`; "" where the dialect knows nothing better."""
        return ""

    def load(self, payload: bytes) -> Program:
        """The program that `Program.payload` was made of."""
        raise NotImplementedError

    def table(self) -> Table:
        """The vocabulary."""
        raise NotImplementedError

    def locate(self, source: Source, at: int) -> tuple[int, int, int]:
        """Line, column and length of the place `at` that a task or a node names."""
        raise NotImplementedError

    def blocks(self, source: Source) -> list[tuple[str, int, int]]:
        """The subs, tasks and handlers of a program: how each is called, its first and its last line."""
        return []

    def has_code(self, line: str) -> bool:
        """Whether a line has more than blanks and a comment; cheap, as a profile asks it after every run."""
        return bool(line.strip())

    def asked(self, source: Source) -> Callable[[int], Asked | None]:
        """What the loop, or the wait for a condition, at a place asks for; None where that is not known."""
        return lambda place: None

    def interactive(self, machine: Machine) -> Interactive:
        """An interpreter for a person who types one line after the other."""
        raise NotImplementedError

    def tokens(self, text: str) -> Iterator[tuple[str, str, int]]:
        """Kind, text and offset of each piece of `text`, for highlighting; never fails."""
        raise NotImplementedError


class Interactive:
    """Keeps a program's names alive between lines.

    `keeps_places` says that the diagnostics of an earlier text, such as of a macro, have columns of that text.
    """

    keeps_places = False

    def is_complete(self, text: str) -> bool:
        """False while `text` leaves a block open, so that more lines must follow."""
        return True

    def task(self, source: Source) -> Task:
        """The task that executes `source`; ProgramError when it is wrong."""
        raise NotImplementedError
