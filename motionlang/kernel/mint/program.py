"""A Mint program: its text is read and checked once, its steps are written when it starts on a machine."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.lang.literals import Literal, Placed, number, placed
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.program import Program, Target
from motionlang.kernel.lang.step_graph import StepGraph
from motionlang.kernel.lang.steps import Steps
from motionlang.kernel.lang.structure import Structure
from motionlang.kernel.lang.task import Task
from motionlang.kernel.mint.check.error_recovery import with_syntax_errors
from motionlang.kernel.mint.check.model import check_model, written_for
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.models import MINTMT, V4, age
from motionlang.kernel.mint.resolve import literals
from motionlang.kernel.mint.resolve.chosen_rates import chosen_rates
from motionlang.kernel.mint.resolve.diagnostics import Diagnostics
from motionlang.kernel.mint.resolve.names import Symbols
from motionlang.kernel.mint.resolve.overrides import override, override_literals
from motionlang.kernel.mint.resolve.short_ramps import short_ramps
from motionlang.kernel.mint.resolve.statements import FactsReader
from motionlang.kernel.mint.resolve.symbols import Function
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.task import PARENT, MintTask
from motionlang.kernel.mint.steps.check import declared, examined
from motionlang.kernel.mint.steps.inspection import Inspection
from motionlang.kernel.mint.steps.places import Places
from motionlang.kernel.mint.steps.program import ProgramWriter, stops
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.parser import read
from motionlang.kernel.mint.syntax.traversal import copied
from motionlang.kernel.source import Source
from motionlang.kernel.tools import StackSpace

if TYPE_CHECKING:
    from motionlang.kernel.lang.names import LineLayout, Names

# The maximum number of programs with other values that are kept for further runs.
MAX_KEPT = 64
_BRACKETS = re.compile(r"\b([A-Z]+)\(([^()\n]+)\)")


class Text:
    """A text, read once for all programs that are made of it."""

    def __init__(self, source: Source) -> None:
        self.source = source

    @cached_property
    def tree(self) -> Module:
        with StackSpace():
            return read(self.source)

    @cached_property
    def literals(self) -> list[Literal]:
        return literals.literals(self.tree)

    @cached_property
    def constants(self) -> list[Literal]:
        return literals.constants(self.tree)

    @cached_property
    def declared(self) -> frozenset[str]:
        return literals.declared(self.tree)


class MintProgram(Program):
    """A Mint program: a text, parsed once for all programs of it, and checked for a machine with some settings.

    `values` are in place of its own. Those of the names in `given` are set when it starts; it maps each to True if
    its value is a text. The names of both may be addresses.
    """

    language = "mint"

    def __init__(
        self,
        source: Source,
        settings: Mapping[str, object] | None = None,
        values: Mapping[str, float | str] | None = None,
        given: Mapping[str, bool] | None = None,
        is_debug: bool = False,
        text: Text | None = None,
    ) -> None:
        super().__init__(source, settings)
        self.values, self.given, self.is_debug = dict(values or {}), dict(given or {}), is_debug
        self._text = text or Text(source)
        self._others: dict[tuple[tuple[str, float | str], ...], MintProgram] = {}

    def __reduce__(self) -> tuple[Callable[..., MintProgram], tuple[object, ...]]:
        return MintProgram, (self.source, self.settings, self.values, self.given, self.is_debug)

    # ------------------------------------------------------------------------------------- the text and its names

    @property
    def tree(self) -> Module:
        if self._readable.errors:
            raise ProgramError(self._readable.errors)
        return self._readable

    @cached_property
    def _readable(self) -> Module:
        """A copy of the tree with the values, which the check completes."""
        module = self._text.tree
        with StackSpace():
            made: Module = copied(module)  # type: ignore[assignment]
            made.source, made.errors, made.tokens = module.source, module.errors, module.tokens
            if not module.errors and (self.values or self.given):
                self._put_values(made)
        return made

    def _put_values(self, module: Module) -> None:
        places = self.places
        put = {
            at: name if name in self.given else number(name, self.values[name])
            for at, name in places.literals.items()
        }
        override_literals(module, put)
        values = {name: value for name, value in self.values.items() if name in places.names}
        given = {name: is_text for name, is_text in self.given.items() if name in places.names}
        override(module, values, given)

    @cached_property
    def places(self) -> Placed:
        given: dict[str, float | str] = {name: "" if is_text else 0.0 for name, is_text in self.given.items()}
        return placed(self, {**self.values, **given})

    @cached_property
    def _declared(self) -> Symbols:
        with StackSpace():
            return declared(self._readable, self.settings)

    @cached_property
    def checked(self) -> Symbols:
        """The names of the readable lines, with the diagnostics of the check."""
        with StackSpace():
            return examined(self._declared, self.settings)

    @cached_property
    def _found(self) -> Sequence[Diagnostic]:
        """The syntax errors, and the errors and warnings of the check."""
        checked = self.checked.diagnostics
        is_known = checked.has_errors or not self._readable.errors
        names = {name for function in self.checked.functions for name in function.scope.names}
        found = with_syntax_errors(checked.found.values() if is_known else (), self._readable, names)
        return self.worded(found)

    def in_notation(self, text: str) -> str:
        """Return a hint, worded for MintMT, as Mint v4 writes it: `GO.0` and `VECTORA[0, 1]`.

        A part that is the text of the program itself is not changed.
        """

        def written(found: re.Match[str]) -> str:
            word, inside = found.groups()
            row = table().get(word)
            is_other = row is None or row.index == "none" or row.kind in ("function", "statement")
            if is_other or found[0] in self.source.text:
                return found[0]
            return f"{word}.{inside}" if inside.isdigit() else f"{word}[{inside}]"

        return _BRACKETS.sub(written, text) if self._is_v4 else text

    @cached_property
    def _is_v4(self) -> bool:
        model = age(str(self.settings.get("controller.model", "")))
        return self.checked.diagnostics.is_v4 if model is None else model == V4

    @property
    def errors(self) -> list[Diagnostic]:
        found = [each for each in self._found if each.severity == "error"]
        return sorted(found, key=lambda each: (each.line, each.column, each.code, each.message))

    @property
    def diagnostics(self) -> list[Diagnostic]:
        return [*self._found, *self._of_model]

    @cached_property
    def _of_model(self) -> list[Diagnostic]:
        """Notation and keywords that the configured controller model does not accept."""
        model = str(self.settings.get("controller.model", ""))
        if self._readable.errors or not model:
            return []
        diagnostics = Diagnostics(self.tree)
        check_model(self._bound, self.source, model, diagnostics.add)
        return list(diagnostics.found.values())

    def require(self) -> None:
        if self.errors:
            raise ProgramError(self._found)

    # ---------------------------------------------------------------------------------------- what it says

    @cached_property
    def names(self) -> Names:
        from motionlang.kernel.mint.resolve import definitions

        with StackSpace():
            return definitions.names(self._readable, self._declared)

    @property
    def layout(self) -> list[LineLayout]:
        from motionlang.kernel.mint.syntax.layout import layout

        return layout(self.source.text)

    @property
    def literals(self) -> list[Literal]:
        return self._text.literals

    @property
    def constants(self) -> list[Literal]:
        return self._text.constants

    @property
    def declared(self) -> frozenset[str]:
        return self._text.declared

    @property
    def _bound(self) -> Module:
        """The tree, with its names resolved."""
        module = self.tree
        self._declared  # noqa: B018 - it binds the names in the tree
        return module

    @cached_property
    def target(self) -> Target:
        return written_for(self._bound)

    @cached_property
    def blocks(self) -> list[tuple[str, int, int]]:
        from motionlang.kernel.mint.syntax.extent import blocks_of

        return blocks_of(self.tree)

    @cached_property
    def _written(self) -> tuple[dict[Function, Steps], dict[int, str]]:
        from motionlang.kernel.mint.steps.structure import written

        self.require()
        return written(self.source, self.checked, self.settings)

    @cached_property
    def graph(self) -> StepGraph:
        from motionlang.kernel.mint.steps.structure import graph_of

        return graph_of(self.checked, self._written[0])

    @cached_property
    def _facts(self) -> FactsReader:
        with StackSpace():
            return FactsReader(self.source, self._declared)

    @cached_property
    def structure(self) -> Structure:
        from motionlang.kernel.mint.steps.structure import structure

        if self.given:  # the steps need a value, and the text has one
            return self.with_values(self.values).structure
        steps, variables = self._written
        return structure(self._facts, steps, self.graph, variables)

    @cached_property
    def warnings(self) -> list[Diagnostic]:
        """Warnings about keywords that may end the run early, names that may be misspelt, and short ramps."""
        ramps = Diagnostics(self._readable)
        for message, at, hint in () if self.errors else short_ramps(self._facts.statements.values()):
            ramps.add("short-ramp", message, at, hint, "warning")
        found = [*self.checked.diagnostics.of_the_run(), *ramps.found.values()]
        return sorted(found, key=lambda each: (each.line, each.column))

    @cached_property
    def notes(self) -> Sequence[str]:
        found = [] if self.errors else chosen_rates(self._facts.statements.values(), self.settings)
        return [self.in_notation(each) for each in found]

    @property
    def offsets(self) -> Sequence[int]:
        return stops(self.checked) if self.is_debug else ()

    # --------------------------------------------------------------------------------------------- its run

    def on(self, settings: Mapping[str, object]) -> MintProgram:
        return MintProgram(self.source, settings, self.values, self.given, self.is_debug, self._text)

    def with_values(
        self, values: Mapping[str, float | str], given: Mapping[str, bool] | None = None
    ) -> MintProgram:
        """Return the program with values in place of some constants, and with those that it is `given`."""
        return MintProgram(self.source, self.settings, values, given, self.is_debug, self._text)

    def for_values(self, values: Mapping[str, float | str]) -> MintProgram:
        """Return the program for runs with many values of some names and addresses, such as `values`.

        Those whose value the check needs, such as the size of an array, are not part of `given`: the program is
        checked again for each of their values. Raises ProgramError with all errors of the program with `values`.
        """
        if not values:
            self.require()
            return self
        kinds = {name: isinstance(value, str) for name, value in values.items()}
        try:
            return self._made({}, kinds)
        except ProgramError:
            given: dict[str, bool] = {}
        for name, is_text in kinds.items():
            others = {n: v for n, v in values.items() if n != name and n not in given}
            try:
                self._made(others, {**given, name: is_text})
            except ProgramError:
                continue
            given[name] = is_text
        return self._made({name: value for name, value in values.items() if name not in given}, given)

    def _made(self, values: Mapping[str, float | str], given: Mapping[str, bool]) -> MintProgram:
        """Return the program with other values; raise ProgramError with all errors."""
        made = self.with_values(values, given)
        made.require()
        return made

    def start(self, machine: Machine) -> Task:
        """Return the parent task, bound to `machine`, which has the model of the program if it has none.

        Raises ProgramError if an override is none of a name or an address of the program.
        """
        machine.model = machine.model or self.target.model
        values = {
            name: value
            for name, value in machine.overrides.items()
            if name in self.given and isinstance(value, str) is self.given[name]
        }
        if len(values) < len(self.given):
            return self._made(machine.overrides, {}).run(machine)
        others = {name: value for name, value in machine.overrides.items() if name not in values}
        program = self if others.items() <= self.values.items() else self._with(others)
        return program.run(machine, values)

    def _with(self, values: Mapping[str, float | str]) -> MintProgram:
        """Return the program with these values in place of its own; the last few are kept."""
        key = tuple(sorted(values.items()))
        found = self._others.get(key)
        if found is None:
            if len(self._others) >= MAX_KEPT:
                self._others.clear()
            found = self._others[key] = self._made(values, self.given)
        return found

    def run(self, machine: Machine, values: Mapping[str, float | str] | None = None) -> Task:
        """Return the parent task of the program as it is, with the values that it is given."""
        environment = Environment(machine, Places())
        environment.prepare()

        def line_of(offset: int) -> int:
            return self.source.location(offset)[0]

        environment.line_of = line_of
        given = {
            name: number(name, value) if name in self.places.literals.values() else value
            for name, value in (values or {}).items()
        }
        writer = ProgramWriter(self.checked, environment, line_of, given, self.is_debug)
        environment.take(writer)
        if self.is_debug:
            assert machine.hook is not None, "a debug build needs a machine with a hook"
            machine.hook.inspection = Inspection(environment, self.checked)
        task = MintTask(PARENT, writer.unit(self.checked.main), environment)
        task.timer = environment.timer
        environment.by_name[PARENT] = environment.task = task
        return task


def port_differences(before: Program, program: Program) -> list[Diagnostic]:
    """Return what a program that was written for v4 does differently on MintMT.

    There are none if the model of the settings is no MintMT, or if the text has errors.
    """
    assert isinstance(before, MintProgram)
    assert isinstance(program, MintProgram)
    if age(str(program.settings.get("controller.model", ""))) != MINTMT:
        return []
    try:
        if age(before.target.model) != V4:
            return []
        graph = program.graph
    except ProgramError:
        return []
    from motionlang.kernel.mint.check import port

    return port.port_differences(program.tree, program.checked, graph)
