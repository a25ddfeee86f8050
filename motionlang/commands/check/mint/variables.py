"""The use of variables, for the rules about their names."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from motionlang.commands.check.mint.conditions import COMPARISONS, tested
from motionlang.kernel.mint.resolve.diagnostics import bracketed
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import changed, meaning, walk
from motionlang.kernel.tools import Spellings, nearest

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.mint.resolve.symbols import Symbol

# More findings are not shown.
MAX_SUGGESTIONS = 100


def variables(facts: MintFacts) -> Iterator[tuple[Symbol, bool]]:
    """Yield each variable, and whether more than its own next value depends on it.

    In `n = n + 1`, for example, only the next value of `n` depends on it.
    """
    own = _own_reads(facts)
    for function in facts.functions:
        for symbol in function.scope.names.values():
            if symbol.home is function and symbol.kind == "variable":
                yield symbol, symbol.uses > own.get(symbol, 0)


def _own_reads(facts: MintFacts) -> dict[Symbol, int]:
    """Count the reads of each variable that only compute its own next value."""
    found: dict[Symbol, int] = {}
    for node in facts.of_kind(nodes.Assign):
        if type(node.target) is not nodes.Name or node.target.args is not None:
            continue
        symbol = meaning(node.target)
        symbols = [meaning(each) for each in walk(node.values) if type(each) is nodes.Name]
        # A sub may print its argument or use it in another way.
        is_called = any(each is not None and each.kind == "sub" for each in symbols)
        if symbol is not None and symbol in symbols and not is_called:
            found[symbol] = found.get(symbol, 0) + symbols.count(symbol)
    return found


def constants_only(facts: MintFacts) -> Iterator[tuple[Symbol, str]]:
    """Yield each undeclared variable that is named like a keyword and not used as a variable, and what may be meant.

    It is only tested and assigned constants, as `OUT4`, or never has another value than 0, as `TIMER` for TIME.
    """
    given: dict[Symbol | None, set[float | None]] = {}
    for kind in (nodes.Assign, nodes.Input, nodes.For, nodes.Name):
        for node in facts.of_kind(kind):
            for name in changed(node):
                value = facts.number(node.values[0]) if isinstance(node, nodes.Assign) else None
                given.setdefault(meaning(name), set()).add(value)
    tests = Counter(meaning(each) for each in _tested(facts))
    table = facts.names.table
    words = Spellings(row.name for row in table if row.simulated and row.kind != "statement")
    left = MAX_SUGGESTIONS
    for symbol, _ in variables(facts):
        values = given.get(symbol, {None})
        if symbol.declared or None in values or not 0 < symbol.uses == tests[symbol] or not left:
            continue
        meant = bracketed(symbol.name, table)
        if meant is None and values == {0.0}:
            left -= 1
            meant = words.nearest(symbol.name, 0.75)
        if meant is not None:
            yield symbol, meant


def _tested(facts: MintFacts) -> Iterator[nodes.Name]:
    """Yield the names that conditions test, alone or in a comparison."""
    for condition in tested(facts):
        left = [condition]
        while left:
            each = left.pop()
            if type(each) is nodes.Binary and (each.op in COMPARISONS or each.op in ("And", "Or")):
                left += [each.left, each.right]
            elif type(each) is nodes.Unary and each.op == "Not":
                left.append(each.operand)
            elif type(each) is nodes.Name:
                yield each


class Suggestions:
    """The search for names that the author may have meant.

    Each search takes time in proportion to the size of the program. So only the first findings, which are shown, get a
    suggestion.
    """

    def __init__(self) -> None:
        self._left = MAX_SUGGESTIONS

    def most_similar(self, symbol: Symbol, wanted: Callable[[Symbol], bool]) -> str | None:
        """Return the name of the most similar variable that is `wanted`, or None."""
        if self._left == 0:
            return None
        self._left -= 1
        others = [
            each.name
            for each in symbol.home.scope.symbols()
            if each is not symbol and each.kind == "variable" and wanted(each)
        ]
        return nearest(symbol.name, others)
