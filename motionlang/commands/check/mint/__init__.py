"""The Mint linter: warnings about programs without errors that are probably wrong.

`check` returns the errors of a program. If it has none, the warnings are added: those of `kernel/mint/check` and those
of the checks in this package. A comment in the program can silence a warning.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from motionlang.commands.check.mint.blends import check_blends
from motionlang.commands.check.mint.busy_loops import check_busy_loops
from motionlang.commands.check.mint.effects import Facts
from motionlang.commands.check.mint.findings import Findings
from motionlang.commands.check.mint.functions import check_functions
from motionlang.commands.check.mint.names import check_names, check_tasks
from motionlang.commands.check.mint.servers import check_servers
from motionlang.commands.check.silence import has_host, silence
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

# Finds the start of a comment, as group 1. An apostrophe inside a string in double quotes starts none.
COMMENT = re.compile(r"""^(?:[^'"\n]|"[^"\n]*")*?('|(?<![\w.])rem)""", re.IGNORECASE)


def check(source: Source, settings: Mapping[str, object] | None = None) -> list[Diagnostic]:
    """Return all errors of a program and, if it has none, all warnings."""
    with StackSpace():
        return _check(source, dict(settings or {}))


def _check(source: Source, settings: dict[str, object]) -> list[Diagnostic]:
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
        warnings = lint(module, checked.names, settings)
        found += [each for each in warnings if (each.code, each.line, each.column) not in reported]
    found += _foreign(module, source, str(settings.get("controller.model", "")))
    found = silence(source, found, COMMENT)
    return sorted(found, key=lambda each: (each.line, each.column, each.code, each.message))


def _foreign(module: Module, source: Source, model: str) -> list[Diagnostic]:
    """Find notation and keywords that the configured controller model does not accept.

    Returns nothing if the machine file names no model.
    """
    problems = Problems(module)
    if model:
        check_model(module, source, model, table(), problems.add)
    return list(problems.found.values())


def lint(module: Module, names: Names, settings: Mapping[str, object]) -> list[Diagnostic]:
    """Return the warnings of a program without errors, in no particular order."""
    facts = Facts(names, table(), has_host(module.source, COMMENT))
    found = Findings(module)
    check_functions(facts, settings, module, found.add)
    add = found.add
    check_blends(facts, add)
    check_busy_loops(facts, add)
    check_names(facts, add)
    check_tasks(facts, add)
    check_servers(module, settings, add)
    return list(found.found.values())
