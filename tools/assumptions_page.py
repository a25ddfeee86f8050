"""Pages of the documentation that are generated from the assumptions.

These are docs/contributing/assumptions.md and the tables of docs/fidelity.md.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from motionlang.commands.evidence.assumption import Assumption
from motionlang.commands.evidence.entries import Chapter, Section, chapters
from motionlang.commands.evidence.fact_evidence import of_word
from motionlang.kernel.lang.dialect import dialect

HEAD = """\
# Assumptions

[What is confirmed](../fidelity.md) is the short version of this page. Nothing here has been checked on a real
controller. `motionlang help KEYWORD` shows what is known about a keyword and from which source. This page lists the
rest: each assumption that was made where the sources are silent, with the reason why a user of the real controller
would expect it. `python -m tools.derived` writes it from the evidence files.

The column *evidence* is a *manual*, running *code*, a *sibling* (another product of the same maker, or one in the same
style whose rule is printed), *memory* (high, medium or low confidence) or a *choice* where there was no evidence.
Assumptions based on a manual or on code are confirmed, all others are open. The marks mean:

* *set*: the machine file's `[assumptions]` can select another behaviour.
* *own*: the matter concerns this program alone; no controller has a different answer.

The alternatives are what the sources leave possible; each is a guess.
"""
# Titles of the strengths that the meaning of a simulated keyword may have.
MEANINGS = {
    "manual": "printed in a manual",
    "code": "read in running code",
    "name only": "known by name only",
    "memory high": "memory, high confidence",
    "memory medium": "memory, medium confidence",
    "memory low": "memory, low confidence",
}
# The kinds of evidence by the first word of their strength.
KINDS = {
    "manual": "printed in a manual",
    "code": "read in running code",
    "name": "known by name, or from a sibling product",
    "sibling": "known by name, or from a sibling product",
    "memory": "remembered",
    "choice": "chosen here",
}
TABLE = "| question | assumption | evidence | name |\n|---|---|---|---|\n"


def markdown() -> str:
    """Return the page of assumptions."""
    sections = [HEAD, "\n## Contents\n\n"]
    sections += [f"* [{each.title}](#{anchor(each.title)})\n" for each in chapters()]
    for chapter in chapters():
        sections += _chapter(chapter)
    return "".join(sections)


def summary() -> str:
    """Count keywords by source and assumptions by subject, for docs/fidelity.md."""
    lines = ["\n| source of the meaning | Mint keywords | MCCL commands |\n|---|---|---|\n"]
    counts = [_strengths(language) for language in ("mint", "mccl")]
    for strength, title in MEANINGS.items():
        lines.append(f"| {title} | {' | '.join(str(each[strength]) for each in counts)} |\n")
    assert all(each.keys() <= MEANINGS.keys() for each in counts)
    lines.append(
        "\nThe share of all facts about simulated keywords (meaning, short form, brackets, unit, default,\n"
    )
    lines.append("range) that is printed, read, remembered or chosen:\n\n")
    lines.append("| facts | Mint | MCCL |\n|---|---|---|\n")
    shares = [_shares(language) for language in ("mint", "mccl")]
    for title in dict.fromkeys(KINDS.values()):
        lines.append(f"| {title} | {' | '.join(f'{each[title]:.0%}' for each in shares)} |\n")
    lines.append("\nThe assumptions by subject:\n\n")
    lines.append("| subject | assumptions | confirmed | the machine file sets |\n")
    lines.append("|---|---|---|---|\n")
    for chapter in chapters():
        found = [each for section in chapter.sections for each in section.assumptions if not each.own]
        if found:
            numbers = (
                len(found),
                len([each for each in found if not each.is_open]),
                len([each for each in found if each.key]),
            )
            link = f"[{chapter.title}](contributing/assumptions.md#{anchor(chapter.title)})"
            lines.append(f"| {link} | {' | '.join(map(str, numbers))} |\n")
    return "".join(lines) + "\n"


def _strengths(language: str) -> Counter[str]:
    """Count a language's simulated keywords by the evidence of their meaning."""
    rows = (row for row in dialect(language).table() if row.simulated)
    return Counter(of_word(language, row)["meaning"].strength for row in rows)


def _shares(language: str) -> dict[str, float]:
    """Return the share of each kind of evidence in all facts about a language's simulated keywords."""
    rows = (row for row in dialect(language).table() if row.simulated)
    found = Counter(
        KINDS[each.strength.partition(" ")[0]] for row in rows for each in of_word(language, row).values()
    )
    return {kind: found[kind] / found.total() for kind in KINDS.values()}


def basis_of(assumption: Assumption) -> str:
    """Return the strength of an assumption, and the reason for the choice."""
    kind, _, confidence = assumption.strength.partition(" ")
    strength = f"{kind} ({confidence})" if confidence else kind
    return f"{strength}: {assumption.why}" if assumption.why else strength


def _chapter(chapter: Chapter) -> Iterator[str]:
    yield f"\n## {chapter.title}\n"
    if chapter.text:
        yield f"\n{chapter.text}\n"
    for section in chapter.sections:
        yield from _section(section)


def _section(section: Section) -> Iterator[str]:
    if section.title:
        yield f"\n### {section.title}\n"
    if section.text:
        yield f"\n{section.text}\n"
    if section.assumptions:
        yield f"\n{TABLE}" + "".join(map(_row, section.assumptions))


def _row(assumption: Assumption) -> str:
    others = f"; open: {'; or '.join(assumption.alternatives)}" if assumption.alternatives else ""
    marks = " · set" * bool(assumption.key) + " · own" * assumption.own
    row = (
        assumption.question,
        assumption.chosen + others,
        basis_of(assumption),
        f"`{assumption.name}`{marks}",
    )
    return f"| {' | '.join(map(cell, row))} |\n"


def cell(text: str) -> str:
    """Return the text of a cell of a table in Markdown."""
    return text.replace("|", "\\|").replace("\n", " ")


def anchor(title: str) -> str:
    """Return the anchor of a heading in Markdown."""
    return "".join(letter for letter in title.lower() if letter.isalnum() or letter in " -_").replace(
        " ", "-"
    )
