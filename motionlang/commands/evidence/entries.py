"""The assumptions in the evidence files: chapters, sections, entries."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from motionlang.commands.evidence.assumption import Assumption
from motionlang.commands.evidence.fact_evidence import STRENGTHS
from motionlang.commands.evidence.fact_evidence import of_word as facts_of_word
from motionlang.kernel import Keyword, dialects
from motionlang.kernel.files import package_text
from motionlang.kernel.lang import ASSUMPTIONS, switch
from motionlang.kernel.mint import name_of, row_with_default, with_default

# The files of evidence, in the order of the chapters of docs/contributing/assumptions.md.
FILES = (
    "commands/evidence/mint/language.toml",
    "commands/evidence/mint/machine.toml",
    "commands/evidence/mint/motion.toml",
    "commands/evidence/mccl/board.toml",
    "commands/evidence/controller.toml",
    "commands/evidence/models.toml",
    "commands/evidence/servo.toml",
    "commands/evidence/copley.toml",
    "commands/evidence/serving.toml",
    "commands/evidence/prompt.toml",
    "commands/evidence/report.toml",
)
# The number of chapters before that of Mint's settings at power-up.
AFTER = 3
# The head of an entry after "[[section", and its line of keywords.
_HEAD, _WORDS = ".reading]]", re.compile(r'^words = "([^"]*)"', re.MULTILINE)
# If an integer setting has no more values than this, each alternative is named.
MAX_NAMED_VALUES = 4
DEFAULTS = """\
A setting of an axis that no program has written yet. Each can be given another value in the machine file's
`[assumptions]`."""


@dataclass(eq=False, slots=True)
class Section:
    """Assumptions on one subject, with a common text.

    `title` may be "" in a chapter with a single section.
    """

    title: str
    text: str
    assumptions: Sequence[Assumption]


@dataclass(eq=False, slots=True)
class Chapter:
    """One evidence file."""

    title: str
    text: str
    sections: Sequence[Section]


@cache
def chapters() -> tuple[Chapter, ...]:
    """Return all evidence files as chapters; AssertionError for a duplicate name."""
    of_files = [_chapter(file) for file in FILES]
    found = (*of_files[:AFTER], _defaults(), *of_files[AFTER:])
    names = [each.name for each in _assumptions(found)]
    assert len(names) == len(set(names)), sorted(name for name in names if names.count(name) > 1)
    return found


@cache
def assumptions() -> Mapping[str, Assumption]:
    """Return all assumptions by name, in the order of the chapters."""
    return {each.name: each for each in _assumptions(chapters())}


def entries_naming(word: str) -> list[Assumption]:
    """Return the assumptions that name a keyword, in the order of the chapters.

    Only the entries that name it are parsed.
    """
    texts = _texts().get(word, [])
    row = row_with_default(word)
    defaults = [] if row is None else [_default(row)]
    first, last = (
        [_assumption(tomllib.loads(text)) for n, text in texts if (n < AFTER) is early]
        for early in (True, False)
    )
    return [*first, *defaults, *last]


def of_word(language: str, row: Keyword) -> list[Assumption]:
    """Return the open assumptions about a keyword."""
    others = tuple(f"{each}." for each in dialects() if each != language)
    return [each for each in entries_naming(row.name) if each.is_open and not each.name.startswith(others)]


@cache
def _texts() -> Mapping[str, list[tuple[int, str]]]:
    """Return by word the TOML of the entries that name it, with their file numbers."""
    found: dict[str, list[tuple[int, str]]] = {}
    for number, file in enumerate(FILES):
        for entry in package_text(file).split("\n[[section")[1:]:
            words = _WORDS.search(entry) if entry.startswith(_HEAD) else None
            for word in words[1].split() if words else ():
                found.setdefault(word, []).append((number, entry.removeprefix(_HEAD)))
    return found


def _assumptions(found: Sequence[Chapter]) -> Iterator[Assumption]:
    for chapter in found:
        for section in chapter.sections:
            yield from section.assumptions


def _chapter(file: str) -> Chapter:
    tree = tomllib.loads(package_text(file))
    sections = [
        Section(
            each["title"], each.get("text", ""), [_assumption(entry) for entry in each.get("reading", ())]
        )
        for each in tree["section"]
    ]
    return Chapter(tree["title"], tree.get("text", ""), sections)


def _assumption(entry: dict[str, Any]) -> Assumption:
    """Convert an entry of a file."""
    if "key" not in entry and switch(entry["name"]) is not None:
        entry["key"] = ASSUMPTIONS + entry["name"]
    assert entry["strength"] in STRENGTHS, entry
    entry["words"] = tuple(entry.get("words", "").split())
    entry["alternatives"] = tuple(entry.get("alternatives", ()))
    return Assumption(**entry)


def _defaults() -> Chapter:
    """Return Mint's settings at power-up, with values from the keyword rows."""
    found = [_default(row) for row in with_default()]
    return Chapter("Mint: settings at power-up", DEFAULTS, [Section("", "", found)])


def _default(row: Keyword) -> Assumption:
    evidence = facts_of_word("mint", row)["default"]
    return Assumption(
        name_of(row),
        f"What {row.name} is until a program writes it",
        f"{row.default:.10g}",
        alternatives=tuple(_other_defaults(row)),
        why=evidence.source,
        strength=evidence.strength,
        words=(row.name,),
        key=ASSUMPTIONS + name_of(row),
    )


def _other_defaults(row: Keyword) -> list[str]:
    """Return the alternatives to a default: each possible value, or a general text."""
    low, high = row.low if row.low is not None else 0, 1 if row.unit == "bool" else row.high
    if not row.takes_fractions and high is not None and high - low < MAX_NAMED_VALUES:
        few = [f"{value}" for value in range(int(low), int(high) + 1) if value != row.default]
        if few:
            return few
    return ["any other text" if isinstance(row.default, str) else "any other number"]
