"""The steps of a Mint program, as a list to read."""

from __future__ import annotations

from collections.abc import Mapping

from motionlang.kernel.lang.step_list import ListedUnit, listed
from motionlang.kernel.lang.steps import END, Step, Steps
from motionlang.kernel.mint.resolve.names import Names
from motionlang.kernel.mint.resolve.symbols import Function
from motionlang.kernel.source import Source


def step_list(source: Source, names: Names, steps: Mapping[Function, Steps]) -> list[ListedUnit]:
    """Return the steps of the functions of a program, beside their lines."""

    def line_of_step(step: Step) -> int:
        is_end_of_text = step.kind == END and step.at == names.main.at
        return source.location(step.at)[0] if step.at >= 0 and not is_end_of_text else 0

    return [listed(source, _title(each), own, line_of_step) for each, own in steps.items() if own]


def _title(function: Function) -> str:
    return "program" if function.kind == "main" else f"{function.kind} {function.name}"
