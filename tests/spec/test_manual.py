"""The manual by example is complete: each page has a subject and a chapter, and each keyword a page."""

from __future__ import annotations

import re

from motionlang.kernel.mccl import table as mccl_table
from motionlang.kernel.mint import table as mint_table
from tests.cases import cases
from tools.mint_manual import CHAPTERS, FOLDER, heading, pages

PAGES = pages()
MCCL = sorted((FOLDER.parent / "mccl").glob("*.mcl"))
# A line of code without its texts, character literals and comments.
NOT_CODE = re.compile(r"\"[^\"\n]*\"|`[^`\n]*`|'.*|(?<=\bREM)\b.*", re.IGNORECASE)
NOT_MCCL = re.compile(r"\"[^\"\n]*\"|;.*")
# Texts of a page in which keywords are shown in lower case; a command is two letters.
COMMAND = re.compile(r"(?<![A-Za-z])[A-Za-z]{2}(?![A-Za-z])")


@cases("name", PAGES)
def test_a_page_begins_with_its_subject(name: str) -> None:
    assert re.match(r"[A-Z].{20,}\.", heading((FOLDER / f"{name}.mnt").read_text(encoding="utf-8")))


def test_every_page_is_in_a_chapter() -> None:
    """Add the name of a new page to CHAPTERS of tools/mint_manual.py."""
    assert sorted(" ".join(CHAPTERS.values()).split()) == PAGES


def test_every_simulated_keyword_of_mint_is_on_a_page() -> None:
    """A variable of the type Controller can be declared, but not used, as its row says."""
    code = (NOT_CODE.sub(" ", (FOLDER / f"{name}.mnt").read_text(encoding="utf-8")) for name in PAGES)
    used = {word.lower() for text in code for word in re.findall(r"\w+", text)}
    assert {row.name for row in mint_table() if row.simulated and row.name.lower() not in used} == {
        "Controller"
    }


def test_every_command_of_mccl_is_on_a_page() -> None:
    """VE and HE have no page: their answers change with every version."""
    code = (NOT_MCCL.sub(" ", path.read_text(encoding="utf-8")) for path in MCCL)
    used = {word.upper() for text in code for word in COMMAND.findall(text)}
    assert {row.name for row in mccl_table()} - used == {"VE", "HE"}
