"""A keyword: one row of a dialect's vocabulary, from which everything else about the word derives.

Dispatch, diagnostics, did-you-mean, completion, `help`, highlighting, the linter and `docs/keywords/` read
these rows and nothing else. A row names behaviour (`verb`) and never contains code.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

# How the fact is known: printed in a manual, read off running code, or remembered.
TRUST = ("manual", "code", "memory")


class Keyword:
    """One word of a motion language.

    `kind`     "setting" | "reading" | "command" | "move" | "function" | "constant" | "statement"
    `access`   "R", "W", "RW" (values) or "C" (a command without a value)
    `index`    what stands in the brackets: "axis", "axes" (a list), "channel", "bank", "none"
    `unit`     "uu", "uu/s", "uu/s2", "uu/s3", "s", "ms", "counts", "%", "bool", "bits", "number", "text", ""
    `verb`     the controller verb or field that the word stands for; "" where it is not simulated
    `low`…`high`  the accepted range, inclusive; None where open
    `solved`   its reading takes the level that it is compared with, and so can tell when it passes that
    `simulated`   False: recognised, documented, answered as "not simulated"
    """

    __slots__ = (
        "access",
        "default",
        "example",
        "group",
        "help",
        "high",
        "index",
        "kind",
        "low",
        "name",
        "short",
        "simulated",
        "solved",
        "source",
        "trust",
        "unit",
        "verb",
    )

    def __init__(
        self,
        name: str,
        short: str,
        kind: str,
        access: str,
        index: str,
        unit: str,
        verb: str,
        help: str,
        example: str = "",
        *,
        default: float | str | None = None,
        low: float | None = None,
        high: float | None = None,
        source: str = "",
        trust: str = "memory",
        group: str = "",
        simulated: bool = True,
        solved: bool = False,
    ) -> None:
        assert trust in TRUST, trust
        self.name, self.short, self.kind, self.access, self.index = name, short, kind, access, index
        self.unit, self.verb, self.help, self.example = unit, verb, help, example
        self.default, self.low, self.high = default, low, high
        self.source, self.trust, self.group, self.simulated = source, trust, group, simulated
        self.solved = solved

    def __repr__(self) -> str:
        return f"Keyword({self.name!r})"


class Table:
    """All words of a dialect, found by name or short form in any case; `hidden` ones only by their name."""

    __slots__ = ("_by_name", "rows")

    def __init__(self, rows: Iterable[Keyword], hidden: Iterable[Keyword] = ()) -> None:
        self.rows = tuple(rows)
        self._by_name: dict[str, Keyword] = {}
        for row in self.rows:
            for spelling in filter(None, (row.name, row.short)):
                key = spelling.lower()
                assert key not in self._by_name, f"{spelling} stands twice in the table"
                self._by_name[key] = row
        self._by_name.update((row.name, row) for row in hidden)

    def __iter__(self) -> Iterator[Keyword]:
        return iter(self.rows)

    def __len__(self) -> int:
        return len(self.rows)

    def get(self, word: str) -> Keyword | None:
        """The row of a word, by its name or its short form, in any case."""
        return self._by_name.get(word.lower())

    def names(self) -> list[str]:
        """Every name, in the order of the table."""
        return [row.name for row in self.rows]
