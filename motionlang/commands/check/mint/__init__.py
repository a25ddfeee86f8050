"""The Mint linter: warnings about programs without errors that are probably wrong.

`check` returns the errors of a program. If it has none, the warnings are added: those of `kernel/mint/check` and those
of the checks in this package. A comment in the program can silence a warning.
"""

from __future__ import annotations

import re

from motionlang.commands.check.mint.blends import check_blends
from motionlang.commands.check.mint.busy_loops import check_busy_loops
from motionlang.commands.check.mint.facts import MintFacts
from motionlang.commands.check.mint.findings import Findings
from motionlang.commands.check.mint.functions import check_functions
from motionlang.commands.check.mint.names import check_names, check_tasks
from motionlang.commands.check.mint.servers import check_servers
from motionlang.commands.check.silence import has_host, silence
from motionlang.kernel import Diagnostic
from motionlang.kernel.mint import MintProgram
from motionlang.kernel.tools import StackSpace

# Finds the start of a comment, as group 1. An apostrophe inside a string in double quotes starts none.
COMMENT = re.compile(r"""^(?:[^'"\n]|"[^"\n]*")*?('|(?<![\w.])rem)""", re.IGNORECASE)


def check(program: MintProgram) -> list[Diagnostic]:
    """Return all errors of a program and, if it has none, all warnings."""
    with StackSpace():
        found = list(program.mistakes)
        if not found:
            checked = program.checked
            found = list(checked.problems.found.values())
            reported = {(each.code, each.line, each.column) for each in found}
            warnings = lint(program)
            found += [each for each in warnings if (each.code, each.line, each.column) not in reported]
        found += program.notes_on_model
    return sorted(silence(program.source, sorted(found, key=_place), COMMENT), key=_place)


def _place(found: Diagnostic) -> tuple[int, int, str, str]:
    return found.line, found.column, found.code, found.message


def lint(program: MintProgram) -> list[Diagnostic]:
    """Return the warnings of a program without errors, in no particular order."""
    module, settings = program.tree, program.settings
    facts = MintFacts(program, has_host(module.source, COMMENT))
    found = Findings(module)
    check_functions(facts, settings, module, found.add)
    add = found.add
    check_blends(facts, add)
    check_busy_loops(facts, add)
    check_names(facts, add)
    check_tasks(facts, add)
    check_servers(module, settings, add)
    return list(found.found.values())
