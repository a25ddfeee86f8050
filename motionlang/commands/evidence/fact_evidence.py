"""The evidence of each fact of a keyword: meaning, short form, brackets, unit, …

The facts themselves are only in the keyword's row. Their evidence is in the `facts.txt` of the dialect, for each fact
of each keyword. It is read by `help`, the documents and `check --evidence`, and never in a run.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from motionlang.kernel import Keyword, dialects
from motionlang.kernel.files import package_text

# How well a fact is known. A sibling is another product of the same maker, or in the same style, whose rule
# is printed; a choice has no evidence. For a meaning that is "name only" the source has the name, the
# arguments and the type.
STRENGTHS = ("manual", "code", "name only", "sibling", "memory high", "memory medium", "memory low", "choice")
# The facts that a row may have, in the order of the keyword's page.
FACTS = ("meaning", "short", "index", "unit", "default", "range")


class Evidence:
    """The evidence of a fact: its strength, one of `STRENGTHS`, and its source or ""."""

    def __init__(self, strength: str, source: str = "") -> None:
        assert strength in STRENGTHS, strength
        self.strength, self.source = strength, source

    def __str__(self) -> str:
        return f"{self.strength}, {self.source}" if self.source else self.strength


# For a keyword that is not listed, such as one that is being added.
UNKNOWN = Evidence("choice")


def of_word(language: str, row: Keyword) -> dict[str, Evidence]:
    """Return the evidence of each fact of a keyword's row, by fact name.

    A fact that `facts.txt` does not have is a choice.
    """
    known = listed(language)
    return {fact: known.get((row.name, fact), UNKNOWN) for fact in facts_of(row)}


def is_remembered(row: Keyword, language: str) -> bool:
    """True if a keyword is simulated by a meaning that no document states."""
    return row.simulated and of_word(language, row)["meaning"].strength == "memory low"


def facts_of(row: Keyword) -> list[str]:
    has = {
        "meaning": True,
        "short": row.short != "",
        "index": row.index not in ("none", ""),
        "unit": row.unit != "",
        "default": row.default is not None,
        "range": row.low is not None or row.high is not None,
    }
    return [fact for fact in FACTS if has[fact]]


@cache
def listed(language: str) -> Mapping[tuple[str, str], Evidence]:
    """Return `facts.txt` by keyword and fact; AssertionError for duplicates."""
    assert language in dialects(), language
    found: dict[tuple[str, str], Evidence] = {}
    facts, evidence = [""], UNKNOWN
    for line in package_text(f"commands/evidence/{language}/facts.txt").splitlines():
        if line.startswith("  "):
            for word in line.split():
                for fact in facts:
                    assert (word, fact) not in found, (word, fact)
                    found[word, fact] = evidence
        elif line and not line.startswith("#"):
            names, strength, *source = line.split(" · ")
            facts = names.split()
            assert set(facts) <= set(FACTS), line
            evidence = Evidence(strength, *source)
    return found
