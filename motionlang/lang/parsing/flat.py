"""Compile a rule that is not recursive into one regular expression.

`re` matches in one step what takes a table several steps. The pattern is built from Lark's own compiled rules
and terminals, just like its LALR(1) table.
"""

from __future__ import annotations

import re

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Collection, Sequence

    from lark import Lark


LINE_END = "\\\n"
# A terminal that begins with this is only found at the beginning of a line.
_LINE_START = "(?<![^\n])"
# A pattern begins with a set of characters or with a single one.
_FIRST = re.compile(r"\[((?!\^)(?:\\.|[^\]\\])+)\]|(\\?[^\[\](){}?*+|.^$\\])")


def _first(pattern: str) -> str:
    """Return the characters that may begin a terminal, in the notation of a set."""
    match = _FIRST.match(pattern)
    if match is None:
        raise ValueError(f"{pattern} must begin with a character or a set of characters")
    return match[1] or match[2]


def _ends_everywhere(pattern: str) -> bool:
    """True if every character that may begin a terminal is also a complete terminal."""
    begins = re.compile(f"[{_first(pattern)}]")
    return all(
        re.fullmatch(pattern, character) for character in map(chr, range(128)) if begins.match(character)
    )


class Flat:
    """A rule of a grammar as a pattern.

    The groups of the pattern are the rules and terminals named in `kept`.
    """

    def __init__(self, lark: Lark, rule: str, kept: Collection[str]) -> None:
        self._kept = kept
        self._terminals = {str(each.name): each.pattern.to_regexp() for each in lark.terminals}
        self._alternatives: dict[str, list[tuple[str, ...]]] = {}
        for each in lark.rules:
            symbols = tuple(str(symbol.name) for symbol in each.expansion)
            self._alternatives.setdefault(str(each.origin.name), []).append(symbols)
        self._open: list[str] = []
        self._used: set[str] = set()
        self.pattern = self._symbol(rule)

    def outside(self, names: Collection[str] | None = None) -> list[str]:
        """Return the patterns of the terminals that the rule does not use.

        Line ends are left out. `names` limits them to some of the grammar's terminals.
        """
        found = (name for name in sorted(self._terminals) if name not in self._used)
        patterns = (self._terminals[name] for name in found if names is None or name in names)
        return [pattern for pattern in patterns if pattern != LINE_END]

    @property
    def begins(self) -> dict[str, str]:
        """Map each group that is a terminal to the character with which it begins.

        Groups with several possible first characters are left out.
        """
        found = (
            (name, _FIRST.match(self._terminals[name])) for name in self._kept if name in self._terminals
        )
        return {name: match[2].removeprefix("\\") for name, match in found if match and match[2]}

    def chunk(self, quoted: str) -> str:
        """Return the pattern of a text that ends where a match should end.

        The text need not match the rule. It ends before anything that the rule does not use, and at the end
        of the line. The terminal `quoted` begins and ends with the same character; if its end is missing, it
        continues to the end of the line.
        """
        quote = _first(self._terminals[quoted])
        ends = [pattern for pattern in self.outside() if not pattern.startswith(_LINE_START)]
        firsts = "".join(map(_first, ends))
        found = [f"[^{firsts}\\n{quote}]++", f"{quote}[^{quote}\\n]*+(?:{quote}|$)"]
        if not all(_ends_everywhere(pattern) for pattern in ends):
            found.append(f"(?!{'|'.join(ends)})[{firsts}]")
        return f"(?>(?:{'|'.join(found)})+)"

    def _symbol(self, name: str) -> str:
        if name in self._terminals:
            self._used.add(name)
            found = self._terminals[name]
        else:
            if name in self._open:
                raise ValueError(f"{name} holds itself: it is no pattern")
            self._open.append(name)
            found = self._choice(self._alternatives[name])
            self._open.remove(name)
        return f"({found})" if name in self._kept else found

    def _choice(self, alternatives: Sequence[tuple[str, ...]]) -> str:
        """Return the pattern of alternatives, with common prefixes merged.

        Merging ensures that each group occurs in the pattern only once.
        """
        firsts = dict.fromkeys(alternative[0] for alternative in alternatives if alternative)
        found = []
        for first in firsts:
            rests = [alternative[1:] for alternative in alternatives if alternative[:1] == (first,)]
            rest = self._choice(rests) if any(rests) else ""
            found.append(self._symbol(first) + rest)
        text = "|".join(found)
        if () in alternatives:
            return f"(?:{text})?"
        return text if len(found) == 1 else f"(?:{text})"
