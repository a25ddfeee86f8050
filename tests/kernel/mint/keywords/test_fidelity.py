"""Every simulated Mint keyword that depends on memory has a listed assumption."""

from __future__ import annotations

import re
from pathlib import Path

from motionlang.kernel.mint import table

ROOT = Path(__file__).parents[4]
PAGE = (ROOT / "docs/contributing/assumptions.md").read_text(encoding="utf-8")
FACTS = (ROOT / "motionlang/commands/evidence/mint/facts.txt").read_text(encoding="utf-8")
CHAPTERS = ("Mint: ", "Motion on the controller", "The servo")


def mint() -> str:
    """Return the chapters about Mint of the list of assumptions, in lower case."""
    chapters = PAGE.split("\n## ")[1:]
    return "\n".join(chapter for chapter in chapters if chapter.startswith(CHAPTERS)).lower()


def test_what_rests_on_memory_is_listed() -> None:
    """The list has the keyword, or its beginning and an ellipsis, such as LATCH…"""
    text = mint()
    words = set(re.findall(r"\w+", text))
    stems = tuple(re.findall(r"(\w{3,})…", text))
    simulated = {row.name for row in table() if row.simulated}
    remembered = [
        name.lower()
        for below in re.findall(r"^meaning\b.* · memory .*\n((?:  .*\n)+)", FACTS, re.MULTILINE)
        for name in below.split()
        if name in simulated
    ]
    assert len(remembered) > 100
    assert [name for name in remembered if name not in words and not name.startswith(stems)] == []


def test_no_question_is_answered_twice_in_a_chapter() -> None:
    for chapter in PAGE.split("\n### "):
        questions = re.findall(r"^\| ([^|]+) \|", chapter, re.MULTILINE)
        answered = [each for each in questions if each not in ("question", "word | bits")]
        assert len(answered) == len(set(answered))


def test_the_contents_are_the_chapters() -> None:
    listed = re.findall(r"^\* \[([^\]]+)\]", PAGE, re.MULTILINE)
    assert listed == re.findall(r"^## (?!Contents)(.+)$", PAGE, re.MULTILINE)
