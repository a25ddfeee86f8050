"""Report words that are unknown, or that mean something else here, with what may be meant."""

from __future__ import annotations

from itertools import chain
from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.check.other_machines import as_typed
from motionlang.kernel.mint.resolve.diagnostics import bracketed
from motionlang.kernel.mint.resolve.symbols import OTHER_TYPES, TYPES, Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.blocks import OPENERS, closers
from motionlang.kernel.mint.syntax.expectations import ONE_FILE
from motionlang.kernel.tools import Spellings

if TYPE_CHECKING:
    from motionlang.kernel.mint.resolve.names import Symbols
    from motionlang.kernel.mint.steps.unit import UnitWriter

# Words of the grammar that begin a statement and are often misspelled.
_FIRST_WORDS = (
    *("Const", "End", "Pause", "Print", "Return", "Input", "Repeat"),
    *chain.from_iterable(map(closers, OPENERS)),
)
_DIM = "Dim declares a variable: Dim k As Integer"
# Words that begin a statement in other languages, and what is written here.
_OTHER_WORDS = {
    "break": "Exit leaves a loop",
    "call": "a sub is called by its name alone",
    **dict.fromkeys(("catch", "try"), "an event handles errors: Event ONERROR"),
    "continue": "there is no Continue: put the rest of the loop in an If",
    **dict.fromkeys(("import", "include"), ONE_FILE),
    "let": "a variable is assigned to by its name alone: k = 3",
    **dict.fromkeys(("local", "private", "public", "static", "var"), _DIM),
    "switch": "a choice between values is Select Case k … End Select",
}

# A shorter name resembles too many keywords.
MIN_LENGTH = 3


def unknown_name(w: UnitWriter, node: nodes.Name) -> None:
    """Report a word that is no variable: a keyword, or neither declared nor a keyword."""
    if node.row is not None:
        message = f"a variable is needed here, and {node.row.word} is a keyword"
        w.error("type", message, node, "" if node.args else another_name(node.name, node.row))
        return
    is_constant = node.name.startswith("_")

    def words() -> list[str]:
        symbols = [symbol.name for symbol in w.function.scope.symbols()]
        rows = [row.name for row in w.program.names.table if row.kind not in ("statement", "command")]
        return [word for word in (*symbols, *rows) if word.startswith("_") or not is_constant]

    hint = "a variable must be declared or assigned to before it is read"
    if node.args is not None:
        hint = f"an array needs a Dim, as in Dim {node.name}(10), and a function its Function"
    if is_constant:
        hint = f"if the controller has this constant, declare its value: Const {node.name} As Integer = …"
    diagnostics, table = w.program.names.diagnostics, w.program.names.table
    diagnostics.unknown(f"{node.name} is unknown", node.name, words, node.start, hint, table)


def another_name(name: str, row: Keyword) -> str:
    """Return a hint for a name that is meant as a variable, and is a keyword."""
    short = "" if name.lower() == row.name.lower() else f"it is short for {row.name}: "
    return f"{short}give the variable another name, such as {name.lower()}_value"


def unknown_command(w: UnitWriter, target: nodes.Name) -> None:
    """Report an unknown word used as a statement.

    A word that is only a value is not suggested.
    """

    def known() -> list[str]:
        subs = [symbol.name for symbol in w.function.scope.symbols() if symbol.kind == "sub"]
        commands = [
            row.name for row in w.program.names.table if row.kind == "command" or row.function == "wait"
        ]
        return [*subs, *commands, *_FIRST_WORDS]

    diagnostics, table = w.program.names.diagnostics, w.program.names.table
    message = f"{target.name} is neither a keyword nor a sub of this program"
    hint = _OTHER_WORDS.get(target.name.lower()) or as_typed(diagnostics.line_from(target.start), 0) or None
    behind = diagnostics.text(target.name.end)
    otherwise = label_hint(target.name) if behind == ":" else hint_at_type(target.name) if target.args else ""
    if behind == ":" and target.name.lower() in w.function.labels:
        hint = otherwise
    if hint is None:
        diagnostics.unknown(message, target.name, known, target.start, otherwise, table)
        return
    following = w.function.scope.find(behind)
    if target.name.lower() == "call" and following is not None and following.kind == "sub":
        hint += f": {following.name}"
    diagnostics.add("unknown-word", message, target.start, hint)


def label_hint(name: str) -> str:
    return f"a label has a line of its own: #{name}"


def hint_at_type(word: str) -> str:
    """Return a hint for a type that begins a statement, "" for any other word."""
    return _DIM if word.lower() in TYPES or word.lower() in OTHER_TYPES else ""


def task_named(w: UnitWriter, node: nodes.Name | nodes.Run | nodes.End, name: str) -> Symbol | None:
    """Return the task that a node refers to; report an error if there is none."""
    if node.symbol is not None and node.symbol.kind == "task":
        return node.symbol

    def tasks() -> list[str]:
        return [each.name for each in w.program.names.module.symbols() if each.kind == "task"]

    w.program.names.diagnostics.unknown(f"there is no task {name}".rstrip(), name, tasks, node.start)
    return None


def warn_of_misspellings(names: Symbols) -> None:
    """Warn of names that are only assigned to and resemble a keyword.

    Such a name may be a typing error, or a variable that an old program no longer uses. A keyword with a number and
    without brackets, as in `OUT3 = 1`, is an error.
    """
    words: Spellings | None = None
    diagnostics, table = names.diagnostics, names.table
    for symbol in _only_assigned(names):
        if diagnostics.is_full:
            return
        message, meant = f"{symbol.name} is assigned but never read", bracketed(symbol.name, table)
        if meant is not None:
            hint = f"did you mean {meant}? If it is a variable, declare it with Dim"
            diagnostics.add("unknown-word", message, symbol.at, hint, fix=meant)
            continue
        words = words or Spellings(r.name for r in table if r.simulated and r.kind != "statement")
        near = words.nearest(symbol.name, 0.75)
        if near is not None:
            diagnostics.in_run.add(("unused-variable", symbol.at))
            hint = f"did you mean {near}?"
            diagnostics.add("unused-variable", message, symbol.at, hint, "warning", candidates=(near,))


def _only_assigned(names: Symbols) -> list[Symbol]:
    """Return the undeclared variables that are never read, without the shortest names."""
    symbols = (symbol for each in names.functions for symbol in each.scope.names.values())
    return [
        symbol
        for symbol in symbols
        if symbol.kind == "variable"
        and not symbol.declared
        and symbol.uses <= 0
        and len(symbol.name) >= MIN_LENGTH
    ]
