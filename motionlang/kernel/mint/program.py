"""A Mint program: its text is read and checked once, its steps are written when it starts on a machine."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.names import NO_NAMES, LineLayout, Names
from motionlang.kernel.lang.program import Program, Target
from motionlang.kernel.lang.step_list import ListedUnit
from motionlang.kernel.lang.task import Task
from motionlang.kernel.lang.wait_causes import InputRead, LoopDependencies
from motionlang.kernel.mint.check.body import Program as Declared
from motionlang.kernel.mint.check.check import Checked, declared, examined
from motionlang.kernel.mint.check.error_recovery import unrelated
from motionlang.kernel.mint.check.model import check_model, written_for
from motionlang.kernel.mint.models import MINTMT, V4, age
from motionlang.kernel.mint.resolve.chosen_rates import chosen_rates
from motionlang.kernel.mint.resolve.facts import FactsReader
from motionlang.kernel.mint.resolve.overrides import override
from motionlang.kernel.mint.resolve.problems import Problems
from motionlang.kernel.mint.resolve.short_ramps import warn_of_short_ramps
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.task import PARENT, MintTask
from motionlang.kernel.mint.steps.inspection import Inspection
from motionlang.kernel.mint.steps.places import Places
from motionlang.kernel.mint.steps.program import ProgramWriter, stops
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.parser import parse
from motionlang.kernel.mint.syntax.recovery import readable
from motionlang.kernel.source import Source
from motionlang.kernel.tools import StackSpace

if TYPE_CHECKING:
    from motionlang.kernel.lang.facts import Structure
    from motionlang.kernel.lang.step_graph import StepGraph
    from motionlang.kernel.lang.steps import Steps
    from motionlang.kernel.mint.resolve.symbols import Function

# The maximum number of programs with other values that are kept for further runs.
MAX_KEPT = 64


class MintProgram(Program):
    """A Mint program, parsed and checked once, with values in place of its own.

    The values of the names in `given` are set when it starts. It maps each to True if its value is a text.
    """

    language = "mint"

    def __init__(
        self,
        source: Source,
        settings: Mapping[str, object] | None = None,
        overrides: Mapping[str, float | str] | None = None,
        given: Mapping[str, bool] | None = None,
        is_debug: bool = False,
    ) -> None:
        super().__init__(source, settings)
        self.given, self.is_debug = given or {}, is_debug
        self._overrides = overrides or {}
        self._others: dict[tuple[tuple[str, float | str], ...], MintProgram] = {}

    # ------------------------------------------------------------------------------------- the text and its names

    @cached_property
    def _parsed(self) -> Module | ProgramError:
        with StackSpace():
            try:
                return parse(self.source)
            except ProgramError as error:
                return error

    @cached_property
    def _read(self) -> tuple[Module | None, set[int], ProgramError | None]:
        """The tree, the lines left out of it, and the syntax errors; no tree if too little can be read."""
        if isinstance(self._parsed, Module):
            return self._parsed, set(), None
        with StackSpace():
            return *readable(self.source, self._parsed), self._parsed

    @cached_property
    def tree(self) -> Module:
        if isinstance(self._parsed, ProgramError):
            raise self._parsed
        with StackSpace():
            override(self._parsed, self._overrides, self.given)
        return self._parsed

    @property
    def _readable(self) -> Module:
        """The tree, without unreadable lines."""
        module, _, unreadable = self._read
        assert module is not None
        return self.tree if unreadable is None else module

    @cached_property
    def _declared(self) -> Declared:
        with StackSpace():
            return declared(self._readable, self.settings)

    @cached_property
    def checked(self) -> Checked:
        """The names and the problems of the readable lines."""
        with StackSpace():
            found = examined(self._readable, self._declared)
            if isinstance(self._parsed, Module) and not found.problems.has_errors:
                warn_of_short_ramps(self._facts.statements.values(), found.problems)
            return found

    @cached_property
    def mistakes(self) -> list[Diagnostic]:
        """All errors, with the warnings of the check beside them; empty if there is no error."""
        module, taken, unreadable = self._read
        has_errors = module is not None and self.checked.problems.has_errors
        found = list(self.checked.problems.found.values()) if has_errors else []
        if unreadable is not None:
            found = [*unreadable.diagnostics, *unrelated(found, self.source, taken)]
        return ProgramError(found).diagnostics

    @property
    def errors(self) -> list[Diagnostic]:
        found = [each for each in self.mistakes if each.severity == "error"]
        return sorted(found, key=lambda each: (each.line, each.column, each.code, each.message))

    @property
    def problems(self) -> list[Diagnostic]:
        found = self.mistakes or list(self.checked.problems.found.values())
        return [*found, *self.notes_on_model]

    @cached_property
    def notes_on_model(self) -> list[Diagnostic]:
        """Notation and keywords that the configured controller model does not accept."""
        model = str(self.settings.get("controller.model", ""))
        if isinstance(self._parsed, ProgramError) or not model:
            return []
        problems = Problems(self.tree)
        check_model(self._bound, self.source, model, problems.add)
        return list(problems.found.values())

    def require(self) -> None:
        if self.mistakes:
            raise ProgramError(self.mistakes)

    # ---------------------------------------------------------------------------------------- what it says

    @cached_property
    def names(self) -> Names:
        from motionlang.kernel.mint.resolve import definitions

        module, _, unreadable = self._read
        if module is None:
            return NO_NAMES
        with StackSpace():
            return definitions.names(module, self._declared.names, unreadable is None)

    @property
    def layout(self) -> list[LineLayout]:
        from motionlang.kernel.mint.syntax.layout import layout

        return layout(self.source.text)

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
    def reads(self) -> list[InputRead]:
        from motionlang.kernel.mint.resolve.wait_causes import input_reads

        return input_reads(self.tree, self._declared.names)

    @cached_property
    def polls(self) -> Callable[[int], LoopDependencies | None]:
        from motionlang.kernel.mint.resolve.wait_causes import finder

        return finder(self.tree, self.checked.names, self.graph)

    @cached_property
    def _steps(self) -> dict[Function, Steps]:
        from motionlang.kernel.mint.steps.structure import written

        self.require()
        return written(self.source, self.checked.names, self.settings)

    @cached_property
    def graph(self) -> StepGraph:
        from motionlang.kernel.mint.steps.structure import graph_of

        return graph_of(self.checked.names, self._steps)

    @cached_property
    def _facts(self) -> FactsReader:
        return FactsReader(self.source, self._declared.names)

    @cached_property
    def structure(self) -> Structure:
        from motionlang.kernel.mint.steps.structure import structure

        return structure(self._facts, self._steps, self.graph, self.polls)

    @cached_property
    def step_list(self) -> list[ListedUnit]:
        from motionlang.kernel.mint.steps.listing import step_list

        return step_list(self.source, self.checked.names, self._steps)

    @property
    def warnings(self) -> list[Diagnostic]:
        """Warnings about keywords that are not simulated and may end the run early."""
        return self.checked.problems.of_the_run()

    @cached_property
    def remarks(self) -> Sequence[str]:
        return [] if self.mistakes else chosen_rates(self._facts.statements.values(), self.settings)

    @property
    def offsets(self) -> Sequence[int]:
        return stops(self.checked.names) if self.is_debug else ()

    # --------------------------------------------------------------------------------------------- its run

    def for_values(self, values: Mapping[str, float | str]) -> MintProgram:
        """Return the program for runs with many values of some names, such as `values`.

        Names whose value the check needs, such as the size of an array, are not part of `given`: the text is checked
        again for each of their values. Raises ProgramError with all errors of the text with `values`.
        """
        self._made(values)
        given = {name: isinstance(value, str) for name, value in values.items()}
        try:
            return self._made({}, given)
        except ProgramError:
            given = {}
        for name, value in values.items():
            one = {name: isinstance(value, str)}
            others = {n: v for n, v in values.items() if n != name and n not in given}
            try:
                self._made(others, given | one)
            except ProgramError:
                continue
            given |= one
        others = {n: v for n, v in values.items() if n not in given} if given else {}
        return self._made(others, given)

    def start(self, machine: Machine) -> Task:
        """Return the parent task, bound to `machine`, which has the model of the program if it has none.

        Raises ProgramError if an override names no name of the program.
        """
        machine.model = machine.model or self.target.model
        overrides = machine.overrides
        values = {
            name: overrides[name]
            for name, is_text in self.given.items()
            if name in overrides and isinstance(overrides[name], str) is is_text
        }
        others = {name: value for name, value in overrides.items() if name not in values}
        if len(values) < len(self.given):
            return self._made(overrides).run(machine)
        return self._with(others).run(machine, values) if others else self.run(machine, values)

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
        """Return the parent task of the program as it is, with the values of its given names."""
        environment = Environment(machine, Places())
        environment.prepare()

        def line_of(offset: int) -> int:
            return self.source.location(offset)[0]

        environment.line_of = line_of
        writer = ProgramWriter(self.checked.names, environment, line_of, values or {}, self.is_debug)
        environment.take(writer)
        if self.is_debug:
            assert machine.hook is not None, "a debug build needs a machine with a hook"
            machine.hook.inspection = Inspection(environment, self.checked.names)
        task = MintTask(PARENT, writer.unit(self.checked.names.main), environment)
        task.timer = environment.timer
        environment.by_name[PARENT] = environment.task = task
        return task

    def _made(
        self, values: Mapping[str, float | str], given: Mapping[str, bool] | None = None
    ) -> MintProgram:
        """Return the program with other values; raise ProgramError with all errors."""
        made = MintProgram(self.source, self.settings, values, given, self.is_debug)
        made.require()
        return made


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

    return port.port_differences(program.tree, program.checked.names, graph)
