"""The Mint linter: warnings about programs that compile but are probably wrong.

`check` returns the errors of a program. If it compiles, the warnings are added: those of the compiler and those
of the checks in this package. A comment in the program can silence a warning.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from motionlang.errors import Diagnostic, ProgramError
from motionlang.lang.collector import CollectorOff
from motionlang.lang.lint import has_host, silence
from motionlang.lang.nesting import StackSpace
from motionlang.mint.compile.compiler import compile_module
from motionlang.mint.compile.error_recovery import with_other_lines
from motionlang.mint.keywords import table
from motionlang.mint.lint.axis_state import Follower
from motionlang.mint.lint.blends import check_blends
from motionlang.mint.lint.brackets import check_brackets
from motionlang.mint.lint.buffer import Buffers
from motionlang.mint.lint.busy_loops import check_busy_loops
from motionlang.mint.lint.conditions import Conditions
from motionlang.mint.lint.effects import Facts
from motionlang.mint.lint.iterations import check_iterations
from motionlang.mint.lint.model import check_model
from motionlang.mint.lint.motion import Motion, Reach
from motionlang.mint.lint.names import check_names, check_tasks
from motionlang.mint.lint.reachability import Ways
from motionlang.mint.lint.servers import check_servers
from motionlang.mint.lint.settings import Settings
from motionlang.mint.resolve.names import Names
from motionlang.mint.resolve.problems import Problems
from motionlang.mint.syntax.nodes import Module
from motionlang.mint.syntax.parser import parse
from motionlang.source import Source

# Finds the start of a comment, as group 1. An apostrophe inside a string in double quotes starts none.
COMMENT = re.compile(r"""^(?:[^'"\n]|"[^"\n]*")*?('|(?<![\w.])rem)""", re.IGNORECASE)


def check(source: Source, settings: Mapping[str, object] | None = None) -> list[Diagnostic]:
    """Return all errors of a program and, if it compiles, all warnings."""
    with CollectorOff(), StackSpace():
        return _check(source, dict(settings or {}))


def _check(source: Source, settings: dict[str, object]) -> list[Diagnostic]:
    try:
        module = parse(source)
    except ProgramError as error:
        return with_other_lines(source, settings, error).diagnostics
    try:
        compiled = compile_module(module, dict(settings))
    except ProgramError as error:
        found = list(error.diagnostics)
    else:
        found = [*compiled.problems.found.values(), *lint(module, compiled.names, settings)]
    found += _foreign(module, source, str(settings.get("controller.model", "")))
    found = silence(source, found, COMMENT)
    return sorted(found, key=lambda each: (each.line, each.column, each.code))


def _foreign(module: Module, source: Source, model: str) -> list[Diagnostic]:
    """Find notation and keywords that the configured controller model does not accept.

    Returns nothing if the machine file names no model.
    """
    problems = Problems(module)
    if model:
        check_model(module, source, model, table(), problems.add)
    return list(problems.found.values())


def lint(module: Module, names: Names, settings: Mapping[str, object]) -> list[Diagnostic]:
    """Return the warnings of a program that compiles, in no particular order."""
    facts = Facts(names, table(), has_host(module.places.source, COMMENT))
    found: dict[tuple[str, int, str], Diagnostic] = {}

    def add(
        code: str,
        message: str,
        at: int,
        hint: str = "",
        candidates: Sequence[str] = (),
        *,
        length: int = 0,
        fix: str = "",
    ) -> None:
        where = module.line(at), module.column(at)
        length = length or module.length(at)
        found.setdefault(
            (code, at, message),
            Diagnostic(
                code,
                message,
                *where,
                length=length,
                hint=hint,
                severity="warning",
                fix=fix,
                candidates=candidates,
            ),
        )

    reach = Reach(facts, settings)
    follower = Follower(facts, lambda key, axis: bool(reach.beyond(key, axis)))
    Motion(follower, reach, add).check()
    Buffers(facts, follower, add).check()
    Settings(facts, follower, add).check()
    check_blends(facts, add)
    Ways(facts, follower, settings, add).check()
    Conditions(facts, follower, module.places, settings, add).check()
    check_busy_loops(facts, add)
    check_iterations(facts, add)
    check_brackets(facts, module.places, add)
    check_names(facts, add)
    check_tasks(facts, add)
    check_servers(module, settings, add)
    return list(found.values())
