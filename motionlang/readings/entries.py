"""The open readings as they stand in the files of evidence: chapters, sections, entries."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from motionlang.lang.machine.machine import READINGS
from motionlang.lang.machine.switch import switch
from motionlang.mint.keywords.switchable import name_of, with_default
from motionlang.readings.facts import STRENGTHS, of_word

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence
    from typing import Any

    from motionlang.lang.keyword import Keyword

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
# Behind so many of them stand Mint's settings at power-up.
AFTER = 3
# What a source prints is not open, nor what running code shows.
SETTLED = ("manual", "code")
PROBE_KEYS = ("before", "ask", "after", "answers", "form", "scale", "motion")
DEFAULTS = """\
A setting of an axis that no program has written yet. Each can be given another value in the machine file's
`[readings]`; what `motionlang probe` prints of a controller counts as long as nothing was stored in it."""


class Probe:
    """How the owner of a controller asks it.

    `before`, `ask` and `after` are lines of the language, of Mint's `ask` what a PRINT shows; `{a}` is the axis and
    `{d}` a distance, of a probe that needs `motion`. `answers` are what a controller says to it, that of the reading
    chosen first, then those of the alternatives; a text that begins with `re:` is a pattern. Where a number is asked
    for, `form` is the pattern around it, and `scale` what it is multiplied with.
    """

    __slots__ = ("after", "answers", "ask", "before", "form", "language", "motion", "scale")

    def __init__(
        self,
        language: str,
        ask: str,
        *,
        before: Sequence[str] = (),
        after: Sequence[str] = (),
        answers: Sequence[str] = (),
        form: str = "",
        scale: float = 1.0,
        motion: bool = False,
    ) -> None:
        assert answers, ask
        self.language, self.ask, self.before, self.after = language, ask, tuple(before), tuple(after)
        self.answers, self.form, self.scale, self.motion = tuple(answers), form, scale, motion


class Reading:
    """One question that somebody had to answer, and the answer.

    `name` is that of the machine file's `[readings]`, `alternatives` are the other answers, `why` the reason for the
    one `chosen`, `strength` one of `facts.STRENGTHS`; `words` are those whose use makes a program depend on it,
    in the spelling of the language, `@motor` for a machine with a simulated motor and `@always` for any. `probe` is how
    a controller is asked, None where it cannot be; `key` is that of the machine file which sets the reading, "" where
    it is no value that could be set.
    """

    __slots__ = ("alternatives", "chosen", "key", "name", "probe", "question", "strength", "why", "words")

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
        probe: Probe | None = None,
        key: str = "",
    ) -> None:
        assert strength in STRENGTHS, (name, strength)
        self.name, self.question, self.chosen = name, question, chosen
        self.alternatives, self.why, self.strength = tuple(alternatives), why, strength
        self.words = tuple(words.split())
        self.probe, self.key = probe, key

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
    of_files = [_chapter(ROOT / file) for file in FILES]
    found = (*of_files[:AFTER], _defaults(), *of_files[AFTER:])
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
        Section(each["title"], each.get("text", ""), [_reading(entry) for entry in each.get("reading", ())])
        for each in tree["section"]
    ]
    return Chapter(tree["title"], tree.get("text", ""), sections)


def _reading(entry: dict[str, Any]) -> Reading:
    """An entry of a file: what is of the probe stands beside the rest."""
    asked = {key: entry.pop(key) for key in PROBE_KEYS if key in entry}
    language = entry.pop("language", entry["name"].partition(".")[0])
    if asked:
        entry["probe"] = Probe(language, **asked)
    if "key" not in entry and switch(entry["name"]) is not None:
        entry["key"] = READINGS + entry["name"]
    return Reading(**entry)


def _defaults() -> Chapter:
    """What Mint's settings are at power-up: as many readings, whose values stand in the rows of the words."""
    found = [_default(row) for row in with_default()]
    return Chapter("Mint: settings at power-up", DEFAULTS, [Section("", "", found)])


def _default(row: Keyword) -> Reading:
    assert isinstance(row.default, (int, float))
    evidence = of_word("mint", row)["default"]
    return Reading(
        name_of(row),
        f"What {row.name} is until a program writes it",
        f"{row.default:.10g}",
        why=evidence.source,
        strength=evidence.strength,
        words=row.name,
        probe=Probe("mint", f"{row.name}({{a}})", answers=(f"{row.default:.10g}",), form="{}"),
        key=READINGS + name_of(row),
    )
