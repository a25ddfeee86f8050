"""A checked Mint program, whose steps are written when it starts on a machine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.program import Program
from motionlang.kernel.lang.task import Task
from motionlang.kernel.mint.check.check import Checked, check_module
from motionlang.kernel.mint.check.error_recovery import parsed
from motionlang.kernel.mint.check.model import written_for
from motionlang.kernel.mint.resolve.chosen_rates import chosen_rates
from motionlang.kernel.mint.resolve.overrides import override
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.task import PARENT, MintTask
from motionlang.kernel.mint.steps.inspection import Inspection
from motionlang.kernel.mint.steps.places import Places
from motionlang.kernel.mint.steps.program import ProgramWriter, stops
from motionlang.kernel.source import Source
from motionlang.kernel.tools import StackSpace

# The maximum number of programs with other values that are kept for further runs.
MAX_KEPT = 64


class MintProgram(Program):
    """A program without errors, with its source.

    The values of the names in `given` are set when it starts. It maps each to True if its value is a text.
    """

    def __init__(
        self,
        source: Source,
        settings: Mapping[str, object] | None,
        checked: Checked,
        remarks: Sequence[str],
        given: Mapping[str, bool] | None = None,
        is_debug: bool = False,
    ) -> None:
        self.source, self.settings, self.checked = source, dict(settings or {}), checked
        self.given, self.is_debug = given or {}, is_debug
        self._remarks = remarks
        self._others: dict[tuple[tuple[str, float | str], ...], MintProgram] = {}

    @property
    def warnings(self) -> list[Diagnostic]:
        """Warnings about keywords that are not simulated and may end the run early."""
        return self.checked.problems.of_the_run()

    @property
    def remarks(self) -> Sequence[str]:
        """Chosen defaults that the motion depends on, a line each."""
        return self._remarks

    @property
    def offsets(self) -> Sequence[int]:
        return stops(self.checked.names) if self.is_debug else ()

    @cached_property
    def _model(self) -> str:
        return written_for(self.source).model

    def start(self, machine: Machine) -> Task:
        """Return the parent task, bound to `machine`, which has the model of the program if it has none.

        Raises ProgramError if an override names no name of the program.
        """
        machine.model = machine.model or self._model
        overrides = machine.overrides
        values = {
            name: overrides[name]
            for name, is_text in self.given.items()
            if name in overrides and isinstance(overrides[name], str) is is_text
        }
        others = {name: value for name, value in overrides.items() if name not in values}
        if len(values) < len(self.given):
            return checked_program(self.source, self.settings, overrides, is_debug=self.is_debug).run(machine)
        return self._with(others).run(machine, values) if others else self.run(machine, values)

    def _with(self, values: Mapping[str, float | str]) -> MintProgram:
        """Return the program with these values in place of its own; the last few are kept."""
        key = tuple(sorted(values.items()))
        found = self._others.get(key)
        if found is None:
            if len(self._others) >= MAX_KEPT:
                self._others.clear()
            found = checked_program(self.source, self.settings, values, self.given, self.is_debug)
            self._others[key] = found
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


def checked_program(
    source: Source,
    settings: Mapping[str, object] | None = None,
    overrides: Mapping[str, float | str] | None = None,
    given: Mapping[str, bool] | None = None,
    is_debug: bool = False,
) -> MintProgram:
    """Parse and check a program, with `overrides` in place of its own values; raise ProgramError with all errors.

    The values of the names in `given` are set when it starts; see `override`. With `is_debug` a debugger can stop it.
    """
    with StackSpace():
        module = parsed(source, lambda readable: check_module(readable, settings))
        if overrides or given:
            override(module, overrides or {}, given)
        checked = check_module(module, settings)
        return MintProgram(
            source, settings, checked, chosen_rates(module, dict(settings or {})), given, is_debug
        )


def program_with(
    source: Source, settings: Mapping[str, object] | None, values: Mapping[str, float | str]
) -> MintProgram:
    """Check a text that will run with many values of some names, such as `values`.

    Names whose value the check needs, such as the size of an array, are not part of `given`: the text is checked again
    for each of their values. Raises ProgramError with all errors of the text with `values`.
    """
    checked_program(source, settings, values)
    given = {name: isinstance(value, str) for name, value in values.items()}
    try:
        return checked_program(source, settings, {}, given)
    except ProgramError:
        given = {}
    for name, value in values.items():
        one = {name: isinstance(value, str)}
        others = {n: v for n, v in values.items() if n != name and n not in given}
        try:
            checked_program(source, settings, others, given | one)
        except ProgramError:
            continue
        given |= one
    others = {n: v for n, v in values.items() if n not in given} if given else {}
    return checked_program(source, settings, others, given)
