"""The errors of a text, and what can be warned of once it has none."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.mint.check.check import check_module
from motionlang.kernel.mint.check.error_recovery import with_other_lines
from motionlang.kernel.mint.check.model import check_model
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.resolve.names import Names
from motionlang.kernel.mint.resolve.problems import Problems
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.parser import parse
from motionlang.kernel.source import Source
from motionlang.kernel.tools import StackSpace

# What finds the warnings of a program without errors.
Linter = Callable[[Module, Names], Iterable[Diagnostic]]


def errors(source: Source, settings: Mapping[str, object]) -> list[Diagnostic]:
    """Return all errors of a program, in text order."""
    return [each for each in diagnostics(source, settings) if each.severity == "error"]


def diagnostics(
    source: Source, settings: Mapping[str, object], lint: Linter = lambda module, names: ()
) -> list[Diagnostic]:
    """Return all errors of a program and, if it has none, the warnings of the check and of a linter."""
    with StackSpace():
        found = _found(source, settings, lint)
    return sorted(found, key=lambda each: (each.line, each.column, each.code, each.message))


def _found(source: Source, settings: Mapping[str, object], lint: Linter) -> list[Diagnostic]:
    try:
        module = parse(source)
    except ProgramError as error:
        return with_other_lines(source, lambda module: check_module(module, settings), error).diagnostics
    try:
        checked = check_module(module, settings)
    except ProgramError as error:
        found = list(error.diagnostics)
    else:
        found = list(checked.problems.found.values())
        reported = {(each.code, each.line, each.column) for each in found}
        warnings = lint(module, checked.names)
        found += [each for each in warnings if (each.code, each.line, each.column) not in reported]
    return found + _foreign(module, source, str(settings.get("controller.model", "")))


def _foreign(module: Module, source: Source, model: str) -> list[Diagnostic]:
    """Find notation and keywords that the configured controller model does not accept.

    Returns nothing if the machine file names no model.
    """
    problems = Problems(module)
    if model:
        check_model(module, source, model, table(), problems.add)
    return list(problems.found.values())
