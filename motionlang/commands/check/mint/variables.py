"""The use of variables, for the rules about their names."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meaning, walk
from motionlang.kernel.tools import nearest

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
