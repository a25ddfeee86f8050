"""The replacements that an editor offers for each diagnostic: `fixes.txt`.

Each line has the program, the line, the marked text and the code; `fix` is certain, a candidate is a choice.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from motionlang.commands.check import check
from motionlang.kernel import Diagnostic, ProgramError, Source, dialect_of

TESTS = Path(__file__).parents[1]
# The programs of these folders that have such diagnostics.
LINTED = ("conditions", "host", "values")
PROGRAMS = [
    *(TESTS / "lint" / "mint" / f"{name}.mnt" for name in LINTED),
    *(TESTS / "errors" / "mint" / f"{name}.mnt" for name in ("typography", "unreadable", "words")),
]
EVERY = sorted(
    path
    for folder in ("lint", "errors")
    for path in (TESTS / folder).glob("*/*.*")
    if dialect_of(path.name) is not None and b"\0" not in path.read_bytes()
)


def found_in(source: Source) -> list[Diagnostic]:
    """Return the diagnostics of a program."""
    language = dialect_of(source.name)
    assert language is not None
    try:
        return check(language.program(source, {}))
    except ProgramError as error:
        return list(error.diagnostics)


def offered(path: Path) -> list[str]:
    """Return a line for each diagnostic of a program that has a replacement."""
    source = Source.read(path)
    lines = []
    for each in found_in(source):
        marked = source.line(each.line)[each.column - 1 : each.column - 1 + each.length] if each.line else ""
        offers = [f"fix {each.fix!r}"] * bool(each.fix) + [f"candidate {one!r}" for one in each.candidates]
        if offers:
            lines.append(f"{path.name}:{each.line} {marked!r} {each.code}: {', '.join(offers)}")
    return lines


def test_the_replacements_of_diagnostics(golden: Callable[[Path, str], None]) -> None:
    golden(TESTS / "lint" / "fixes.txt", "".join(f"{line}\n" for path in PROGRAMS for line in offered(path)))


@pytest.mark.parametrize("path", EVERY, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_a_fix_changes_its_text_and_removes_its_finding(path: Path) -> None:
    source = Source.read(path)
    for each in (one for one in found_in(source) if one.fix):
        lines = source.text.split("\n")
        line, begin = lines[each.line - 1], each.column - 1
        lines[each.line - 1] = line[:begin] + each.fix + line[begin + each.length :]
        text = "\n".join(lines)
        assert text != source.text, str(each)
        left = found_in(Source(source.name, text))
        assert (each.line, each.column, each.code, each.message) not in [
            (one.line, one.column, one.code, one.message) for one in left
        ]
