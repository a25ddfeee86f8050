"""No fact claims more than a source of its kind can state."""

from __future__ import annotations

import re

from motionlang.commands.probe.facts import listed, of_word
from motionlang.commands.probe.keyword_facts import TRUST, facts
from motionlang.kernel import dialect, dialects
from tests.commands.probe.draw import FACTS, ROWS, drawn, line

# The type library has names, arguments, types and read or write: no meaning, short form, default or range.
LIBRARIES = ("Mint type library", "Mint ActiveX type library, build 5626")
# A contents page and a blog print names; what they mean is remembered.
NAMES_ONLY = ("MN1955 contents", "Mint programming tutorial, part 5")


def test_the_type_library_is_the_source_of_no_meaning() -> None:
    for (word, fact), evidence in listed("mint").items():
        if evidence.source in LIBRARIES and evidence.strength == "code":
            assert fact in ("index", "unit"), word


def test_a_contents_page_and_a_blog_print_nothing() -> None:
    for (word, _), evidence in listed("mint").items():
        if evidence.source in NAMES_ONLY:
            assert evidence.strength.startswith("memory"), word


def test_only_a_meaning_is_known_by_name_only() -> None:
    found = {
        fact
        for language in dialects()
        for (_, fact), each in listed(language).items()
        if each.strength == "name only"
    }
    assert found == {"meaning"}


def test_a_keyword_known_by_name_only_has_no_meaning() -> None:
    """Its text is the group, a note that the host has it, or its name spelt out; a simulated one does what it says."""
    group = re.compile(r"group$|^host|^listed by the type library without a meaning$|obsolete")
    more = [
        row.name
        for row in dialect("mint").table()
        if of_word("mint", row)["meaning"].strength == "name only"
        and not row.simulated
        and not group.search(row.help)
        and not all(word[:4] in row.name.lower() for word in re.findall(r"[a-z]{3,}", row.help))
    ]
    assert more == []


def test_every_meaning_has_a_source() -> None:
    for language in dialects():
        known = [(row.name, of_word(language, row)["meaning"]) for row in dialect(language).table()]
        assert [name for name, each in known if not each.source and each.strength != "choice"] == []


def test_the_page_shows_the_three_strengths_of_memory() -> None:
    """Recollections have a recorded confidence: TM medium, AV low, MC high."""
    table = dialect("mccl").table()
    for word, strength in (("MC", "high"), ("TM", "medium"), ("AV", "low")):
        row = table.get(word)
        assert row is not None
        assert f"from memory with {strength} confidence" in dict(facts(row, "mccl"))["known from"]
    assert len(set(TRUST.values())) == len(TRUST)


def test_what_the_type_library_reads_and_writes() -> None:
    table = dialect("mint").table()
    for word in ("SPEEDDEMAND", "COMPARELATCH", "NUMBEROF"):
        row = table.get(word)
        assert row is not None
        assert row.access == "RW"


def test_a_draw_is_repeatable() -> None:
    rows, found = drawn("2026-11-21")
    assert (len(rows), len(found)) == (ROWS, FACTS) == (60, 40)
    again = drawn("2026-11-21")
    assert [line(*each) for each in rows + found] == [line(*each) for each in again[0] + again[1]]
    assert drawn("2026-11-22") != (rows, found)
