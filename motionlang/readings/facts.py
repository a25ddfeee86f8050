"""What each fact of a word rests on: its meaning, short form, brackets, unit, default and range.

The facts stand in the word's row, once. What the word itself is known from is the row's `source` and `trust`, or, with
its page, in the `facts.txt` of the dialect, which says what its other facts rest on, as far as a source has them.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from motionlang.lang.dialect import dialects
from motionlang.lang.keyword import STRENGTHS

if TYPE_CHECKING:
    from collections.abc import Mapping

    from motionlang.lang.keyword import Keyword

ROOT = Path(__file__).parent.parent
# The facts that a row may have, as a page of the word shows them.
FACTS = ("meaning", "short", "index", "unit", "default", "range")
# Without a source these are chosen; the others follow from what the word is.
CHOSEN = ("default", "range")


class Evidence:
    """What a fact rests on: its strength, one of `lang.keyword.STRENGTHS`, and the source, "" where there is none."""

    __slots__ = ("source", "strength")

    def __init__(self, strength: str, source: str = "") -> None:
        assert strength in STRENGTHS, strength
        self.strength, self.source = strength, source

    def __str__(self) -> str:
        return f"{self.strength}, {self.source}" if self.source else self.strength


def of_word(language: str, row: Keyword) -> dict[str, Evidence]:
    """The evidence of each fact that the row of a word has, by its name."""
    known = listed(language)
    own = Evidence("memory low" if row.trust == "memory" else row.trust, row.source)
    meaning = known.get((row.name, "meaning"), own)
    others = meaning if row.trust == "manual" or not row.simulated else Evidence("memory low")
    found = {"meaning": meaning}
    for fact in facts_of(row)[1:]:
        otherwise = Evidence("choice") if fact in CHOSEN else others
        found[fact] = known.get((row.name, fact), otherwise)
    return found


def facts_of(row: Keyword) -> list[str]:
    """The facts that a row has."""
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
    """What `facts.txt` of a dialect says, by word and fact; AssertionError where it says a thing twice."""
    assert language in dialects(), language
    found: dict[tuple[str, str], Evidence] = {}
    fact, evidence = "", Evidence("choice")
    for line in (ROOT / language / "evidence" / "facts.txt").read_text(encoding="utf-8").splitlines():
        if line.startswith("  "):
            for word in line.split():
                assert (word, fact) not in found, (word, fact)
                found[word, fact] = evidence
        elif line and not line.startswith("#"):
            fact, strength, *source = line.split(" · ")
            assert fact in FACTS, line
            evidence = Evidence(strength, *source)
    return found
