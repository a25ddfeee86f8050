"""The linter: the problems that the kernel reports, the rules of the language, and comments that silence them."""

from __future__ import annotations

from collections.abc import Sequence
from pkgutil import resolve_name

from motionlang.commands.check.rules import RULES
from motionlang.commands.check.silence import silence
from motionlang.kernel import Diagnostic, Program, dialect
from motionlang.kernel.tools import StackSpace

# The facts that the rules of each language read, imported for its programs only.
_FACTS = {
    "mint": "motionlang.commands.check.mint.mint_facts:MintFacts",
    "mccl": "motionlang.commands.check.mccl.mccl_facts:MacroFacts",
}


def lint(program: Program) -> list[Diagnostic]:
    """Return all errors of a program and, if it has none, all warnings, without those that a comment silences."""
    with StackSpace():
        found = list(program.diagnostics)
        if not program.errors:
            reported = {(each.code, each.line, each.column) for each in found}
            found += (
                each for each in _warnings(program) if (each.code, each.line, each.column) not in reported
            )
    return sorted(
        silence(program.source, program.worded(found), program.language),
        key=lambda each: (each.line, each.column, each.code, each.message),
    )


def _warnings(program: Program) -> list[Diagnostic]:
    """Return the warnings of all rules about a program without errors."""
    facts = resolve_name(_FACTS[program.language])(program)
    found: list[Diagnostic] = []
    for code, rule in RULES.items():
        case = rule.cases.get(program.language)
        if case is not None and case.check is not None:
            warnings = _Warnings(code, program)
            case.check(facts, warnings.add)
            found += warnings.found.values()
    return found


class _Warnings:
    """The warnings of one rule about a program, by offset and message."""

    def __init__(self, code: str, program: Program) -> None:
        self._code, self._program = code, program
        self.found: dict[tuple[int, str], Diagnostic] = {}

    def add(
        self,
        message: str,
        at: int,
        hint: str = "",
        *,
        candidates: Sequence[str] = (),
        length: int = 0,
        fix: str = "",
    ) -> None:
        """Record a warning, as `Warn` describes."""
        if (at, message) in self.found:
            return
        line, column, own = dialect(self._program.language).locate(self._program.source, at)
        self.found[at, message] = Diagnostic(
            self._code,
            message,
            line,
            column,
            length=length or own,
            hint=hint,
            severity="warning",
            fix=fix,
            candidates=candidates,
        )
