"""The steps of a Mint program, as a list to read."""

from __future__ import annotations

from collections.abc import Mapping

from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.step_list import ListedUnit, listed
from motionlang.kernel.lang.steps import END, Step
from motionlang.kernel.mint.resolve.names import Names
from motionlang.kernel.mint.resolve.symbols import Function
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.steps.places import Places
from motionlang.kernel.mint.steps.program import ProgramWriter
from motionlang.kernel.source import Source


def step_list(source: Source, names: Names, settings: Mapping[str, object]) -> list[ListedUnit]:
    """Return the steps of all functions of a program on a machine, beside their lines."""
    environment = Environment(Machine(dict(settings)), Places())
    environment.prepare()

    def line_of(offset: int) -> int:
        return source.location(offset)[0]

    def line_of_step(step: Step) -> int:
        is_end_of_text = step.kind == END and step.at == names.main.at
        return line_of(step.at) if step.at >= 0 and not is_end_of_text else 0

    environment.line_of = line_of
    writer = ProgramWriter(names, environment, line_of, {})
    return [
        listed(source, _title(each), steps, line_of_step) for each, steps in writer.steps.items() if steps
    ]


def _title(function: Function) -> str:
    return "program" if function.kind == "main" else f"{function.kind} {function.name}"
