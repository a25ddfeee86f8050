"""All questions for a controller: evidence entries, and open facts of keywords."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from motionlang.commands.probe.assumption import Assumption
from motionlang.commands.probe.entries import assumptions, entries_naming
from motionlang.commands.probe.rules import unsettled_facts
from motionlang.kernel import Keyword, dialect, dialects


@cache
def questions() -> Mapping[str, Assumption]:
    """Return all assumptions by name: the entries, then the facts.

    The entries are in the order of docs/contributing/assumptions.md, the facts in the order of the keyword tables.
    """
    facts = (
        fact
        for language in dialects()
        for row in dialect(language).table()
        for fact in unsettled_facts(language, row)
    )
    found = dict(assumptions())
    for each in facts:
        found.setdefault(each.name, each)
    return found


def of_word(language: str, row: Keyword) -> list[Assumption]:
    """Return the open assumptions about a keyword: its entries, then its own facts."""
    others = tuple(f"{each}." for each in dialects() if each != language)
    entries = [each for each in entries_naming(row.name) if each.is_open and not each.name.startswith(others)]
    known = {each.name for each in entries}
    return entries + [each for each in unsettled_facts(language, row) if each.name not in known]
