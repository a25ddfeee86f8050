"""The errors of a program with syntax errors: these, and those that the check finds in the rest of its tree."""

from __future__ import annotations

from collections.abc import Iterable, Set
from copy import copy

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.mint.check.other_machines import as_typed
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.syntax.blocks import DECLARATIONS, OPENERS
from motionlang.kernel.mint.syntax.expectations import SEPARATED
from motionlang.kernel.mint.syntax.nodes import Module, Wrong
from motionlang.kernel.mint.syntax.tokens import Tokens
from motionlang.kernel.mint.syntax.traversal import walk
from motionlang.kernel.source import Source

# Errors that concern a statement by itself, or that one repeats a name. Other errors, such as an Exit outside a loop,
# may be caused by what is not in the tree.
_OF_A_STATEMENT = frozenset(
    {
        "unknown-word",
        "duplicate",
        "not-simulated",
        "values",
        "read-only",
        "write-only",
        "not-a-command",
        "type",
        "range",
        "axis",
        "channel",
        "index",
        "division-by-zero",
    }
)

_OPENERS = frozenset(OPENERS.values())


def with_syntax_errors(found: Iterable[Diagnostic], module: Module, declared: Set[str]) -> list[Diagnostic]:
    """Return the syntax errors of a module, and what the check has found that would remain if these were corrected.

    Without syntax errors it is all that the check has found. A name in a line with one may have been declared there, so
    lines that use it are not reported. If the beginning or the end of a block is missing, a name that is `declared` in
    one block may be known in another one, and two declarations of a name may be in different blocks.
    """
    if not module.errors:
        return ProgramError(found).diagnostics
    source = module.source
    lines = {each.line for each in module.errors}
    for node in walk([*module.everything, *module.types]):
        if isinstance(node, Wrong):
            lines |= {*range(module.line(node.start), module.line(node.end) + 1)}
    names = {name for line in lines for name in _names(source.line(line))}
    if any(map(_is_of_blocks, module.errors)):
        found = [
            each
            for each in found
            if each.code != "duplicate"
            and not (each.code == "unknown-word" and _marked(each, source).lower() in declared)
        ]
    remaining = [
        each
        for each in found
        if each.line not in lines
        and each.code in _OF_A_STATEMENT
        and not _words(source.line(each.line)) & names
    ]
    errors = [_with_other_hint(each, source) for each in module.errors]
    return ProgramError([*errors, *remaining]).diagnostics


def _with_other_hint(error: Diagnostic, source: Source) -> Diagnostic:
    """Return an error; one in a statement of another machine gets what is typed here as its hint."""
    hint = as_typed(source.line(error.line), error.column - 1) if error.hint == SEPARATED else ""
    found = copy(error)
    found.hint = hint or error.hint
    return found


def _is_of_blocks(error: Diagnostic) -> bool:
    """True if the beginning or the end of a block is missing, or misspelt."""
    return error.code in ("missing-end", "stray-end") or not _OPENERS.isdisjoint(error.candidates)


def _names(line: str) -> set[str]:
    """Return the words of a line that are no keywords of Mint, and a keyword that it declares."""
    rows, tokens = table(), Tokens(line)
    declared = {tokens.texts[1].lower()} if tokens.kinds[0] in DECLARATIONS else set[str]()
    return declared | {word for word in _words(line) if (row := rows.get(word)) is None or not row.simulated}


def _words(line: str) -> set[str]:
    tokens = Tokens(line)
    pairs = zip(tokens.kinds, tokens.texts, strict=True)
    return {text.lower() for kind, text in pairs if kind in ("NAME", "DOTTED")}


def _marked(error: Diagnostic, source: Source) -> str:
    return source.line(error.line)[error.column - 1 :][: error.length]
