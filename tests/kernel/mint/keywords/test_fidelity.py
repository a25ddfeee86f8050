"""Every simulated Mint keyword that depends on memory has a listed assumption."""

from __future__ import annotations

import re
from pathlib import Path

from motionlang.commands.probe.facts import of_word
from motionlang.kernel.mint import table

PAGE = (Path(__file__).parents[4] / "docs" / "contributing" / "assumptions.md").read_text(encoding="utf-8")
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
    remembered = [
        row.name.lower()
        for row in table()
        if row.simulated and of_word("mint", row)["meaning"].strength.startswith("memory")
    ]
    assert [name for name in remembered if name not in words and not name.startswith(stems)] == []


def test_no_question_is_answered_twice_in_a_chapter() -> None:
    for chapter in PAGE.split("\n### "):
        questions = re.findall(r"^\| ([^|]+) \|", chapter, re.MULTILINE)
        answered = [each for each in questions if each not in ("question", "word | bits")]
        assert len(answered) == len(set(answered))


def test_the_contents_are_the_chapters() -> None:
    listed = re.findall(r"^\* \[([^\]]+)\]", PAGE, re.MULTILINE)
    assert listed == re.findall(r"^## (?!Contents)(.+)$", PAGE, re.MULTILINE)
