"""The mistakes of a program, found without a run: the command check."""

from importlib import import_module

from motionlang.kernel import Diagnostic, Program

# The module of each language, which is imported for its programs only.
_LINTERS = {"mint": "mint", "mccl": "mccl.check"}


def check(program: Program) -> list[Diagnostic]:
    """Return all errors of a program and, if it has none, all warnings, without those that a comment silences."""
    linter = import_module(f"{__name__}.{_LINTERS[program.language]}")
    found: list[Diagnostic] = linter.check(program)
    return found
