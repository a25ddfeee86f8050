"""The manual of Mint by example: every page of tests/spec/mint runs as printed.

A line that begins with `'| ` is a line of the machine file, `'> ` is one of the terminal's output (`'>` alone
is an empty one), `'? ` is a diagnostic, its line and its message, and `'! ` is a fact that a run cannot show.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from motionlang import run
from motionlang.lang.machine.file import read_machine
from motionlang.mint.keywords import table
from motionlang.source import Source
from tests.cases import cases
from tests.mint_manual import CHAPTERS, FOLDER, INDEX, contents, heading, pages

PAGES = pages()


def marked(text: str, mark: str) -> list[str]:
    """Return the text behind each occurrence of a mark at the start of a line."""
    return [line[3:] for line in map(str.lstrip, text.split("\n")) if line.startswith(mark)]


# Characters that a page shows as symbols.
SIGNS = str.maketrans({"␛": "\x1b", "␍": "\r", "␇": "\a"})


def page(name: str) -> Path:
    return FOLDER / f"{name}.mnt"


@pytest.mark.parametrize("name", PAGES)
def test_page_shows_its_output(name: str) -> None:
    text = page(name).read_text(encoding="utf-8")
    settings = read_machine(Source("machine.toml", "\n".join(marked(text, "'| "))))
    result = run(page(name), machine=settings, cache=False, prove=True)
    assert result.expected_motion is None or result.proof().violations == []
    assert [f"{each.line}: {each.message}" for each in result.diagnostics] == marked(text, "'? ")
    assert result.output == [line.translate(SIGNS) for line in marked(text, "'>")]
    assert "'! " not in text or result.notes == marked(text, "'! ")


@cases("name", PAGES)
def test_the_page_begins_with_what_it_is_about(name: str) -> None:
    assert re.match(r"[A-Z].{20,}\.", heading(page(name).read_text(encoding="utf-8")))


def test_every_page_is_in_a_chapter() -> None:
    """Add the name of a new page to CHAPTERS of tests/mint_manual.py."""
    listed = " ".join(CHAPTERS.values()).split()
    assert sorted(listed) == PAGES


def test_the_contents_are_those_of_the_pages() -> None:
    assert INDEX.read_text(encoding="utf-8") == contents(), "python -m tests.derived writes them anew"


# A line of code without its texts, character literals and comments.
NOT_CODE = re.compile(r"\"[^\"\n]*\"|`[^`\n]*`|'.*|(?<=\bREM)\b.*", re.IGNORECASE)


def used() -> set[str]:
    """Return every keyword that occurs in the code of any page, in lower case."""
    code = (NOT_CODE.sub(" ", page(name).read_text(encoding="utf-8")) for name in PAGES)
    return {word.lower() for text in code for word in re.findall(r"\w+", text)}


# A variable of this type can be declared, but not used, as its row states.
NO_PAGE = {"Controller"}


def test_every_simulated_word_is_in_the_manual() -> None:
    words = used()
    missing = {row.name for row in table() if row.simulated and row.name.lower() not in words}
    assert missing == NO_PAGE
