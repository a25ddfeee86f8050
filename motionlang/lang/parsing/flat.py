"""Compile a rule that is not recursive into one regular expression.

`re` matches in one step what a table matches in several. The pattern is built from Lark's own compiled rules
and terminals, just like its LALR(1) table.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Collection, Sequence

    from lark import Lark


class Flat:
    """A rule of a grammar as a pattern.

    Its groups are the rules and terminals named in `kept`.
    """

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
        """The pattern of text that may separate two matches on one line.

        It has all terminals that the rule does not use, except line ends.
        """
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
        """Return the pattern of alternatives, with common prefixes merged.

        Merging ensures that a group occurs in the pattern only once.
        """
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
