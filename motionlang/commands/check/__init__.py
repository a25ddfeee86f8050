"""The mistakes of a program, found without a run: the command check."""

from motionlang.kernel import Diagnostic, Program


def check(program: Program) -> list[Diagnostic]:
    """Return all errors of a program and, if it has none, all warnings, without those that a comment silences."""
    # Other commands import modules of this package that show findings, and need no rules.
    from motionlang.commands.check.linter import lint

    return lint(program)
