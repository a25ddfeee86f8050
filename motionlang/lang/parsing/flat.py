"""From a rule that does not hold itself to one pattern: what a table would find in several steps, `re` finds in one.

The pattern is put together from Lark's own compiled rules and terminals, as its LALR(1) table is.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Collection, Sequence

    from lark import Lark


class Flat:
    """A rule of a grammar as a pattern; the parts named in `kept`, rules and terminals, are its groups."""

    def __init__(self, lark: Lark, rule: str, kept: Collection[str]) -> None:
        self._kept = kept
        self._terminals = {str(each.name): each.pattern.to_regexp() for each in lark.terminals}
        self._ways: dict[str, list[tuple[str, ...]]] = {}
        for each in lark.rules:
            symbols = tuple(str(symbol.name) for symbol in each.expansion)
            self._ways.setdefault(str(each.origin.name), []).append(symbols)
        self._open: list[str] = []
        self._used: set[str] = set()
        self.pattern = self._symbol(rule)

    @property
    def between(self) -> str:
        """What stands between two of them on a line: the terminals that the rule has no use for, but for line ends."""
        others = (pattern for name, pattern in sorted(self._terminals.items()) if name not in self._used)
        return "|".join(pattern for pattern in others if pattern != "\\\n")

    def _symbol(self, name: str) -> str:
        if name in self._terminals:
            self._used.add(name)
            found = self._terminals[name]
        else:
            if name in self._open:
                raise ValueError(f"{name} holds itself: it is no pattern")
            self._open.append(name)
            found = self._choice(self._ways[name])
            self._open.remove(name)
        return f"({found})" if name in self._kept else found

    def _choice(self, ways: Sequence[tuple[str, ...]]) -> str:
        """The ways that begin alike are written together, so that a group stands in the pattern once."""
        firsts = dict.fromkeys(way[0] for way in ways if way)
        found = []
        for first in firsts:
            rests = [way[1:] for way in ways if way[:1] == (first,)]
            rest = self._choice(rests) if any(rests) else ""
            found.append(self._symbol(first) + rest)
        text = "|".join(found)
        if () in ways:
            return f"(?:{text})?"
        return text if len(found) == 1 else f"(?:{text})"
