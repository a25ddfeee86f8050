"""Writer of docs/sources.md, the table of the source documents."""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[1]
DATA = ROOT / "tests" / "sources" / "entries.txt"
PAGE = ROOT / "docs" / "sources.md"
KINDS = ("statement", "formula", "table row", "figure", "code", "context")
HEAD = """\
# The source documents, line by line

motionlang follows five documents: two scans of PMC's TN1069, ABB's AN00115, a chapter on move profiles and Copley's
note on PVT. This page lists every statement, formula, table row, figure and listing of them, in their order, by its
first words. Each row has the command that reproduces it, what its output shows, and the test. Run the command, or
search the page that is named, and compare. The scans have no page numbers, so rows are grouped by the documents' own
headings.

The scripts in [tests/lab/notes/scripts](../tests/lab/notes/scripts) print the tables, the formulas and the figures of
the documents: [tn1069.py](../tests/lab/notes/scripts/tn1069.py),
[an00115.py](../tests/lab/notes/scripts/an00115.py), and for chapter 12
[chapter12.py](../tests/lab/notes/scripts/chapter12.py),
[chapter12_drawn.py](../tests/lab/notes/scripts/chapter12_drawn.py),
[slip.py](../tests/lab/notes/scripts/slip.py), [dac.py](../tests/lab/notes/scripts/dac.py) and
[listing.py](../tests/lab/notes/scripts/listing.py). They need a clone of the repository.

A test runs every command and compares its output (`tests/sources/test_sources.py`). Rows of kind *context* have nothing
to compute: they say why. Where no command shows a figure, the row has the formula with the document's figures, which
that test calculates.

"""


class Entry(NamedTuple):
    """One statement of a document.

    `shows` are texts in the output of `command`; `test` is the test that proves it. For a context entry, `command`
    is the reason why there is nothing to compute.
    """

    document: str
    section: str
    kind: str
    words: str
    command: str
    shows: tuple[str, ...] = ()
    test: str = ""


def entries() -> list[Entry]:
    """Return all entries, in the order of the documents.

    Raises AssertionError for a line with an invalid form.
    """
    found: list[Entry] = []
    names: dict[str, str] = {}
    document = section = ""
    for line in DATA.read_text(encoding="utf-8").splitlines():
        mark, _, rest = line.partition(" ")
        if mark == "!":
            name, _, command = rest.partition(" = ")
            names[name] = command
        elif mark == "=":
            document = rest
        elif mark == "@":
            section = rest
        elif mark not in ("#", ""):
            kind, words, command, *more = line.split(" | ")
            assert kind in KINDS, line
            assert len(more) == (0 if kind == "context" else 2), line
            command = re.sub(r"^\{(.+)\}$", lambda match: names[match[1]], command)
            shows = tuple(more[0].split(" … ")) if more else ()
            found.append(Entry(document, section, kind, words, command, shows, more[1] if more else ""))
    return found


def page() -> str:
    """Return the text of docs/sources.md."""
    lines, document, section = [HEAD], "", ""
    every = entries()
    for title in dict.fromkeys(each.document for each in every):
        own = [each for each in every if each.document == title]
        counts = [f"{count} {kind}" for kind in KINDS if (count := sum(each.kind == kind for each in own))]
        lines.append(f"* {title}: {len(own)} rows ({', '.join(counts)})\n")
    for each in every:
        if each.document != document:
            lines.append(f"\n## {each.document}\n")
        if (each.document, each.section) != (document, section):
            document, section = each.document, each.section
            lines.append(
                f"\n### {section}\n\n| | first words | command | shows | test |\n|---|---|---|---|---|\n"
            )
        lines.append(f"| {each.kind} | {_cell(each.words)} | {_proof(each)} |\n")
    return "".join(lines)


def _proof(each: Entry) -> str:
    if each.kind == "context":
        return f"*{each.command}* | | "
    verb, _, rest = each.command.partition(" ")
    command = f"`{each.command}`"
    if verb == "page":
        command = f"[{rest}]({rest.removeprefix('docs/')})"
    elif verb == "calc":
        command = f"`{rest}` in `tests/sources/test_sources.py`"
    return f"{_cell(command)} | {_cell(' … '.join(each.shows))} | `{each.test}`"


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


def files() -> dict[Path, str]:
    return {PAGE: page()}
