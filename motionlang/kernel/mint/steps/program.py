"""The steps of a program on one machine, or of a line typed at a prompt."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from motionlang.kernel.lang.machine.machine import DEFAULT_AXES
from motionlang.kernel.lang.steps import CALL, DO, END, NOW, RETURN, Steps
from motionlang.kernel.mint.keywords.machine_readings import words
from motionlang.kernel.mint.resolve.handlers import handles, label_handlers
from motionlang.kernel.mint.resolve.names import Symbols
from motionlang.kernel.mint.resolve.symbols import Function
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.printing import shows_float
from motionlang.kernel.mint.steps.places import is_shared, variables_of
from motionlang.kernel.mint.steps.statements import block
from motionlang.kernel.mint.steps.unit import UnitWriter
from motionlang.kernel.mint.syntax.traversal import is_stop, walk


@dataclass(slots=True, eq=False)
class FunctionSteps:
    """A function of a program: its steps, and the index of the first one."""

    function: Function
    steps: Steps
    entry: int = 0


def stops(names: Symbols) -> list[int]:
    """Return the offsets of the statements at which a debugger can stop."""
    return sorted(
        {each.start for function in names.functions for each in walk(function.body) if is_stop(each)}
    )


class ProgramWriter:
    """Writes the steps of all functions of a program.

    `given` are the values of the names that differ between runs. With `is_debug` a debugger can stop before each
    statement. With the settings of a machine file the program is `checked` for them: its errors are reported, its
    tree is annotated, and no steps are written.
    """

    def __init__(
        self,
        names: Symbols,
        environment: Environment,
        line: Callable[[int], int],
        given: Mapping[str, float | str],
        is_debug: bool = False,
        checked: Mapping[str, object] | None = None,
    ) -> None:
        self.names, self.environment, self.line = names, environment, line
        self.given = {name.lower(): value for name, value in given.items()}
        self.is_debug = is_debug
        hook = environment.machine.hook
        # What a debug build calls with both sides of each comparison.
        self.report = hook.compared if is_debug and hook is not None else None
        # What it calls with a number whose truth decides.
        self.tested = hook.tested if is_debug and hook is not None else None
        self.places = environment.places
        self.is_guarded = handles(names, "onerror")
        self.show_float = shows_float(environment.machine)
        self.steps = {function: environment.steps_of(function) for function in names.functions}
        for function, steps in self.steps.items():
            steps.origin, steps.name = names, function.qualified_name
            steps.title = "program" if function.kind == "main" else f"{function.kind} {function.name}"
        # The tasks and handlers, by names such as "task blink" and "event timer".
        self.blocks: dict[str, FunctionSteps] = {}
        self.checks = checked is not None
        if checked is not None:
            axes = checked.get("controller.axes", DEFAULT_AXES)
            self.axes = range(axes if isinstance(axes, int) else DEFAULT_AXES)
            # The keywords whose values the machine file gives.
            self.supplied = words(checked)
            for function in names.functions:
                block(UnitWriter(self, function), function.body)
            return
        for function in names.functions:
            self._write(function)
        observer = environment.machine.observer
        if observer is not None:
            for steps in self.steps.values():
                observer.written(steps)

    def unit(self, function: Function) -> FunctionSteps:
        """Return a function as a unit that can be started."""
        return FunctionSteps(function, self.environment.steps_of(function))

    def _write(self, function: Function) -> None:
        for symbol in variables_of(function):
            self.places.index(symbol)
        w = UnitWriter(self, function)
        if function.kind in ("task", "event"):
            self._reset(w)
        block(w, function.body)
        w.at = function.at
        self._end(w)
        for index, name in w.jumps:
            w.steps.set_target(index, w.labels[name])
            if w.steps[index].kind == CALL:
                w.steps.called[index] = w.steps, w.labels[name]
        if function.kind in ("task", "event"):
            self.blocks[f"{function.kind} {function.name.lower()}"] = self.unit(function)
        if function.jumps:
            for name in label_handlers(function):
                self.blocks[f"event {name}"] = FunctionSteps(function, w.steps, w.labels[name])

    def _reset(self, w: UnitWriter) -> None:
        """Give the variables of a task or a handler their first values, each time that it begins."""
        own = [(self.places.index(each), each) for each in variables_of(w.function) if is_shared(each)]
        if own:
            places = self.places
            w.add(DO, lambda values: places.reset(own))

    def _end(self, w: UnitWriter) -> None:
        """Write the end of a function; the end of the program's text ends a task even within a Gosub."""
        environment, function = self.environment, w.function
        if function.kind in ("sub", "event"):
            result = function.result
            index = None if result is None else self.places.index(result)
            w.add(RETURN, None if index is None else lambda values: values[index])
            return
        if function.kind == "main" and self.is_guarded:
            w.add(NOW)  # the failure of the last statement is handled before the end
        w.add(
            END,
            (lambda values: environment.end_program())
            if function.kind == "main" and function.jumps
            else None,
        )
