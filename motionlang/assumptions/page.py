"""docs/fidelity.md, made from the readings."""

from __future__ import annotations

from collections.abc import Iterator

from motionlang.assumptions.entries import Chapter, Section, chapters
from motionlang.assumptions.reading import Reading

HEAD = """\
# Fidelity: what rests on memory, and the readings chosen

Nothing here was checked on a real controller. What is known of a word, and from where, `motionlang keywords WORD`
shows; this page lists what a word's row cannot say: the reading that was chosen where the sources are silent, and why a
user of the real controller would expect it. It is written from the files of evidence by `python -m tests.derived`.

Behind each reading stands what it rests on: a *manual*, running *code*, a *sibling* (another product of the same maker,
or in the same style, whose rule is printed), *memory* (high, medium or low confidence) or a *choice*, where there was
nothing to go by. All but the first two are open. What is marked *set* is a value, which the machine file's `[readings]`
can set to another one; what is marked *asked* is a question of `motionlang probe`, which the owner of a controller puts
to it, and what is marked *asked by name* has a program of its own (`motionlang probe NAME`), as it writes settings or
may end with an error. Alternatives are what the sources leave possible, each a guess. What is marked *own* is this
program's own matter: no controller has another answer.
"""
TABLE = "| question | reading | rests on | name |\n|---|---|---|---|\n"


def markdown() -> str:
    """The whole page."""
    parts = [HEAD, "\n## Contents\n\n"]
    parts += [f"* [{each.title}](#{_anchor(each.title)})\n" for each in chapters()]
    for chapter in chapters():
        parts += _chapter(chapter)
    return "".join(parts)


def rests_on(reading: Reading) -> str:
    """Its strength, and why it was chosen."""
    kind, _, confidence = reading.strength.partition(" ")
    strength = f"{kind} ({confidence})" if confidence else kind
    return f"{strength}: {reading.why}" if reading.why else strength


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
    if section.readings:
        yield f"\n{TABLE}" + "".join(map(_row, section.readings))


def _row(reading: Reading) -> str:
    others = f"; open: {'; or '.join(reading.alternatives)}" if reading.alternatives else ""
    marks = " · set" * bool(reading.key) + " · own" * reading.own
    if reading.probe is not None:
        marks += " · asked by name" if reading.probe.alone else " · asked"
    row = (reading.question, reading.chosen + others, rests_on(reading), f"`{reading.name}`{marks}")
    return f"| {' | '.join(map(_cell, row))} |\n"


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("\n", " ")


def _anchor(title: str) -> str:
    """The place of a heading, as a page of Markdown names it."""
    return "".join(letter for letter in title.lower() if letter.isalnum() or letter in " -").replace(" ", "-")
