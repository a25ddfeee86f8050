"""The replacements that an editor offers for each diagnostic: `fixes.txt`.

Each line has the program, the line, the marked text and the code; `fix` is certain, a candidate is a choice.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from motionlang.commands.check import check
from motionlang.kernel import ProgramError, Source, dialect_of

TESTS = Path(__file__).parents[1]
# The programs of these folders that have such diagnostics.
LINTED = ("conditions", "host", "values")
PROGRAMS = [
    *(TESTS / "lint" / "mint" / f"{name}.mnt" for name in LINTED),
    *(TESTS / "errors" / "mint" / f"{name}.mnt" for name in ("typography", "unreadable", "words")),
]


def offered(path: Path) -> list[str]:
    """Return a line for each diagnostic of a program that has a replacement."""
    language, source = dialect_of(path.name), Source.read(path)
    assert language is not None
    try:
        found = check(language.program(source, {}))
    except ProgramError as error:
        found = list(error.diagnostics)
    lines = []
    for each in found:
        marked = source.line(each.line)[each.column - 1 : each.column - 1 + each.length] if each.line else ""
        offers = [f"fix {each.fix!r}"] * bool(each.fix) + [f"candidate {one!r}" for one in each.candidates]
        if offers:
            lines.append(f"{path.name}:{each.line} {marked!r} {each.code}: {', '.join(offers)}")
    return lines


def test_the_replacements_of_diagnostics(golden: Callable[[Path, str], None]) -> None:
    golden(TESTS / "lint" / "fixes.txt", "".join(f"{line}\n" for path in PROGRAMS for line in offered(path)))
