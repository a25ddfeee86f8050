"""Mint, the motion language of Baldor and ABB controllers.

`DIALECT` is its interface for programs. `PUBLIC` are the names for hosts and questions, each imported on first use.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.lang.dialect import Dialect, Interactive, Target
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.machine.switch import Switch
from motionlang.kernel.lang.names import LineLayout, Names
from motionlang.kernel.lang.program import Program
from motionlang.kernel.lang.step_list import ListedUnit
from motionlang.kernel.lang.task import Task
from motionlang.kernel.lang.vocabulary import Vocabulary
from motionlang.kernel.lang.wait_causes import InputRead, LoopDependencies, Read
from motionlang.kernel.lazy import lazy_names
from motionlang.kernel.source import Source

if TYPE_CHECKING:
    from motionlang.kernel.lang.program_graph import Structure
    from motionlang.kernel.mint.interactive import MintInteractive as MintInteractive
    from motionlang.kernel.mint.keywords import table as table
    from motionlang.kernel.mint.keywords.identity import VIRTUAL as VIRTUAL
    from motionlang.kernel.mint.keywords.switchable import name_of as name_of
    from motionlang.kernel.mint.keywords.switchable import row_with_default as row_with_default
    from motionlang.kernel.mint.keywords.switchable import with_default as with_default
    from motionlang.kernel.mint.models import named as named
    from motionlang.kernel.mint.runtime.errors import NUMBERS as NUMBERS
    from motionlang.kernel.mint.runtime.printing import shows_float as shows_float
    from motionlang.kernel.mint.syntax.nodes import Module

PUBLIC = {
    "models": "named",
    "keywords": "table",
    "keywords.identity": "VIRTUAL",
    "interactive": "MintInteractive",
    "runtime.errors": "NUMBERS",
    "runtime.printing": "shows_float",
    "keywords.switchable": "name_of row_with_default with_default",
}


class Mint(Dialect):
    """The Mint dialect.

    Axes count from 0. Every method imports what it needs.
    """

    name, title = "mint", "Mint"
    suffixes = (".mnt", ".mntx", ".prg")
    first_axis = 0
    others = "another task or an Event"
    comment = "'"
    constant = "Const {} = {}"
    declaring = frozenset(("const", "define", "dim", "nv"))
    before_statements = frozenset(("define", "do", "else", "loop", "repeat", "then"))
    before_conditions = frozenset(("pause", "if", "elseif", "while", "until", "and", "or", "not"))
    counting = ("for", "to", "step")

    def compile(self, source: Source, settings: dict[str, object] | None = None) -> Program:
        from motionlang.kernel.mint.program import checked_program

        return checked_program(source, settings)

    def debug(self, source: Source, settings: dict[str, object] | None = None) -> Program:
        from motionlang.kernel.mint.program import checked_program

        return checked_program(source, settings, is_debug=True)

    def parse(self, source: Source) -> Module:
        from motionlang.kernel.mint.syntax.parser import parse

        return parse(source)

    def compile_given(
        self, source: Source, settings: dict[str, object], values: Mapping[str, float | str]
    ) -> Program:
        """Check once, to run with many values of the program's own names."""
        from motionlang.kernel.mint.program import program_with

        return program_with(source, settings, values)

    def step_list(self, source: Source, settings: Mapping[str, object]) -> list[ListedUnit]:
        from motionlang.kernel.mint.program import checked_program
        from motionlang.kernel.mint.steps.listing import step_list

        return step_list(source, checked_program(source, settings).checked.names, settings)

    def structure(self, source: Source, settings: Mapping[str, object]) -> Structure:
        from motionlang.kernel.mint.program import checked_program
        from motionlang.kernel.mint.steps.program_graph import structure

        return structure(source, checked_program(source, settings).checked.names, settings)

    def compiled_in(self, key: str) -> bool:
        return key in ("controller.axes", "fault") or key.startswith("mint.")

    def errors(self, source: Source, settings: Mapping[str, object]) -> list[Diagnostic]:
        from motionlang.kernel.mint.check.text import errors

        return errors(source, settings)

    def names(self, source: Source, settings: Mapping[str, object] | None = None) -> Names:
        from motionlang.kernel.mint.resolve.definitions import names

        return names(source)

    def layout(self, source: Source) -> list[LineLayout]:
        from motionlang.kernel.mint.syntax.layout import layout

        return layout(source.text)

    def models(self) -> tuple[str, ...]:
        from motionlang.kernel.mint.models import NAMES, PRODUCTS

        return (*NAMES, *PRODUCTS)

    def knows_model(self, name: str) -> bool:
        from motionlang.kernel.mint.models import age

        return age(name) is not None

    def written_for(self, source: Source) -> Target:
        from motionlang.kernel.mint.check.model import written_for

        return written_for(source)

    def port_differences(
        self, before: Source, source: Source, settings: Mapping[str, object]
    ) -> list[Diagnostic]:
        from motionlang.kernel.mint.check.port import port_differences

        return port_differences(before, source, settings)

    def setting_problem(self, key: str, value: object) -> tuple[str, str] | None:
        from motionlang.kernel.mint.keywords import machine_readings
        from motionlang.kernel.mint.resolve import aliases

        checks = aliases.problem if key.startswith(aliases.SECTION) else machine_readings.problem
        return checks(key, value)

    def switches(self) -> Mapping[str, Switch]:
        from motionlang.kernel.mint.keywords.switchable import switches

        return switches()

    def input_reads(self, source: Source) -> list[InputRead]:
        from motionlang.kernel.mint.resolve.wait_causes import input_reads

        return input_reads(source)

    def remarks(self, source: Source, settings: Mapping[str, object]) -> list[str]:
        """Return a line about rates that no statement sets."""
        from motionlang.kernel.errors import ProgramError
        from motionlang.kernel.mint.resolve.chosen_rates import chosen_rates
        from motionlang.kernel.mint.syntax.parser import parse

        try:
            return chosen_rates(parse(source), settings)
        except ProgramError:
            return []

    def driven_by(self, why: str) -> list[str]:
        from motionlang.kernel.mint.runtime.wait_sources import driven_by

        return driven_by(why)

    def triggers(self, task: Task, latches: Sequence[int]) -> tuple[frozenset[Read], str]:
        from motionlang.kernel.mint.keywords.latches import triggers
        from motionlang.kernel.mint.runtime.task import MintTask

        assert isinstance(task, MintTask)
        return triggers(task.environment, latches)

    def table(self) -> Vocabulary:
        from motionlang.kernel.mint.keywords import table

        return table()

    def locate(self, source: Source, at: int) -> tuple[int, int, int]:
        from motionlang.kernel.mint.syntax.tokens import value_length

        return (*source.location(at), value_length(source.text, at))

    def blocks(self, source: Source) -> list[tuple[str, int, int]]:
        from motionlang.kernel.mint.syntax.extent import blocks

        return blocks(source)

    def loop_dependencies(self, source: Source) -> Callable[[int], LoopDependencies | None]:
        from motionlang.kernel.mint.resolve.wait_causes import finder

        return finder(source)

    def interactive(self, machine: Machine) -> Interactive:
        from motionlang.kernel.mint.interactive import MintInteractive

        return MintInteractive(machine)

    def has_code(self, line: str) -> bool:
        """True if a line has code.

        `REM x`, `rem` and `REMConfigure` are comments, like `' x`. `remaining` and `REMOTEOUT` are names.
        """
        code = line.strip()
        if code[:3].lower() != "rem":
            return bool(code) and code[0] != "'"
        joined = code[:3] == "REM" and code[3:4].isupper() and code[4:5].islower()
        return (code[3:4].isalnum() or code[3:4] == "_") and not joined

    def tokens(self, text: str) -> Iterator[tuple[str, str, int]]:
        from motionlang.kernel.mint.syntax.tokens import tokens

        return tokens(text)


DIALECT = Mint()

if not TYPE_CHECKING:
    __getattr__ = lazy_names(__name__, PUBLIC)
