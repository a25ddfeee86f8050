"""The open readings as they stand in the files of evidence: chapters, sections, entries."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from motionlang.lang.keyword import STRENGTHS

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

ROOT = Path(__file__).parent.parent
# The files of evidence, in the order of the chapters of docs/fidelity.md.
FILES = (
    "mint/evidence/language.toml",
    "mint/evidence/machine.toml",
    "mint/evidence/motion.toml",
    "mccl/evidence/board.toml",
    "readings/evidence/controller.toml",
    "readings/evidence/models.toml",
    "readings/evidence/servo.toml",
    "readings/evidence/copley.toml",
    "readings/evidence/serving.toml",
    "readings/evidence/prompt.toml",
    "readings/evidence/report.toml",
)
# What a source prints is not open, nor what running code shows.
SETTLED = ("manual", "code")
KEYS = ("name", "question", "chosen", "alternatives", "why", "strength", "words")


class Reading:
    """One question that somebody had to answer, and the answer.

    `name` is that of the machine file's `[readings]`, `alternatives` are the other answers, `why` the reason for the
    one `chosen`, `strength` one of `lang.keyword.STRENGTHS`; `words` are those whose use makes a program depend on it,
    in the spelling of the language, `@motor` for a machine with a simulated motor and `@always` for any.
    """

    __slots__ = ("alternatives", "chosen", "name", "question", "strength", "why", "words")

    def __init__(
        self,
        name: str,
        question: str,
        chosen: str,
        *,
        alternatives: Sequence[str] = (),
        why: str = "",
        strength: str,
        words: str = "",
    ) -> None:
        assert strength in STRENGTHS, (name, strength)
        self.name, self.question, self.chosen = name, question, chosen
        self.alternatives, self.why, self.strength = tuple(alternatives), why, strength
        self.words = tuple(words.split())

    @property
    def is_open(self) -> bool:
        """Whether another answer is as possible: no manual prints this one, and no code shows it."""
        return self.strength not in SETTLED


class Section:
    """Readings about one matter, behind what there is to say of all of them; `title` "" for a chapter's only one."""

    __slots__ = ("readings", "text", "title")

    def __init__(self, title: str, text: str, readings: Sequence[Reading]) -> None:
        self.title, self.text, self.readings = title, text, readings


class Chapter:
    """One file of evidence."""

    __slots__ = ("sections", "text", "title")

    def __init__(self, title: str, text: str, sections: Sequence[Section]) -> None:
        self.title, self.text, self.sections = title, text, sections


@cache
def chapters() -> tuple[Chapter, ...]:
    """Every file of evidence, read; AssertionError where two readings have one name."""
    found = tuple(_chapter(ROOT / file) for file in FILES)
    names = [each.name for each in _readings(found)]
    assert len(names) == len(set(names)), sorted(name for name in names if names.count(name) > 1)
    return found


@cache
def readings() -> Mapping[str, Reading]:
    """Every reading by its name, in the order of the chapters."""
    return {each.name: each for each in _readings(chapters())}


def _readings(found: Sequence[Chapter]) -> Iterator[Reading]:
    for chapter in found:
        for section in chapter.sections:
            yield from section.readings


def _chapter(path: Path) -> Chapter:
    tree = tomllib.loads(path.read_text(encoding="utf-8"))
    sections = [
        Section(each["title"], each.get("text", ""), [Reading(**entry) for entry in each.get("reading", ())])
        for each in tree["section"]
    ]
    return Chapter(tree["title"], tree.get("text", ""), sections)
