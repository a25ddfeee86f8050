"""Warn of names that may be misspelt keywords."""

from __future__ import annotations

from motionlang.kernel.mint.check.body import CheckContext
from motionlang.kernel.mint.resolve.problems import bracketed
from motionlang.kernel.mint.resolve.symbols import Symbol
from motionlang.kernel.tools import Spellings

# A shorter name resembles too many keywords.
MIN_LENGTH = 3


def warn_of_misspellings(program: CheckContext) -> None:
    """Warn of names that are only assigned to and resemble a keyword.

    Such a name may be a typing error, or a variable that an old program no longer uses. A keyword with a number and
    without brackets, as in `OUT3 = 1`, is an error.
    """
    words: Spellings | None = None
    problems = program.problems
    for symbol in _only_assigned(program):
        if problems.is_full:
            return
        message, meant = f"{symbol.name} is assigned but never read", bracketed(symbol.name, program.table)
        if meant is not None:
            hint = f"did you mean {meant}? If it is a variable, declare it with Dim"
            problems.add("unknown-word", message, symbol.at, hint, fix=meant)
            continue
        words = words or Spellings(r.name for r in program.table if r.simulated and r.kind != "statement")
        near = words.nearest(symbol.name, 0.75)
        if near is not None:
            problems.in_run.add(("unused-variable", symbol.at))
            hint = f"did you mean {near}?"
            problems.add("unused-variable", message, symbol.at, hint, "warning", candidates=(near,))


def _only_assigned(program: CheckContext) -> list[Symbol]:
    """Return the undeclared variables that are never read, without the shortest names."""
    symbols = (symbol for each in program.names.functions for symbol in each.scope.names.values())
    return [
        symbol
        for symbol in symbols
        if symbol.kind == "variable"
        and not symbol.declared
        and symbol.uses <= 0
        and len(symbol.name) >= MIN_LENGTH
    ]
