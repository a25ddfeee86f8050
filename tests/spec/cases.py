"""Programs with their results as text: how the files below are read, run and rewritten. README.md has the legend.

A case is a program of its file's length: the lines of other cases are empty in it. So a line of a message or of an
event is the line of the file.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from motionlang.commands.check import check
from motionlang.kernel import Diagnostic, ProgramError, Source, dialect_of, read_machine
from tests.proof import is_recorded, prove, run

FOLDER = Path(__file__).parent
COMMENTS = {".mnt": "'", ".mcl": ";"}
MARKS = ">?!=#|*"
TITLE = "== "
HINT = "; hint: "
# Characters that a page shows as symbols.
SYMBOLS = str.maketrans({"\x1b": "␛", "\r": "␍", "\a": "␇"})


@dataclass
class Line:
    """A line of a file: its number from 1, its mark ("" for a line of the program), its text, and its indentation."""

    number: int
    mark: str
    text: str
    indent: str = ""


@dataclass
class Case:
    """A program with the results beside it: the lines shared by all cases of its file, then its own."""

    path: Path
    title: str
    lines: list[Line]
    row: dict[str, str] = field(default_factory=dict)

    @property
    def name(self) -> str:
        title = ": ".join(
            filter(None, (self.title, ", ".join(f"{name} {self.row[name]}" for name in self.row)))
        )
        return f"{self.path.relative_to(FOLDER).with_suffix('')}{': ' if title else ''}{title}"

    @property
    def is_only_checked(self) -> bool:
        return "check" in self.path.relative_to(FOLDER).parts

    def texts(self, marks: str) -> list[str]:
        """Return the filled texts of the lines with one of these marks."""
        return [self.filled(line.text) for line in self.lines if line.mark and line.mark in marks]

    def has(self, mark: str) -> bool:
        return any(line.mark == mark for line in self.lines)

    def filled(self, text: str) -> str:
        return re.sub(r"\{(\w+)\}", lambda found: self.row.get(found[1], found[0]), text)

    def source(self, machine: bool = False) -> str:
        """Return the program or the machine file, with each line where it is in the file."""
        count = max((line.number for line in self.lines), default=0)
        rows = [""] * count
        for line in self.lines:
            if line.mark == ("|" if machine else ""):
                rows[line.number - 1] = self.filled(line.text)
        return "\n".join(rows)


@dataclass
class Found:
    """What a case shows: the diagnostics and events by line, `machine` for those of the machine file."""

    printed: list[str] = field(default_factory=list)
    diagnostics: list[tuple[bool, int, Diagnostic]] = field(default_factory=list)
    events: list[tuple[int, str]] = field(default_factory=list)
    unknown: list[str] = field(default_factory=list)
    end: str = ""


def cases(path: Path) -> list[Case]:
    """Return the cases of a file, once for each row of a table."""
    blocks: list[tuple[str, list[Line]]] = [("", [])]
    for number, text in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
        if text.startswith(TITLE):
            blocks.append((text.removeprefix(TITLE).strip(), []))
        else:
            blocks[-1][1].append(read_line(number, text, COMMENTS[path.suffix]))
    shared = blocks[0][1]
    titled = [(title, shared + lines) for title, lines in blocks[1:]] or [("", shared)]
    return [Case(path, title, lines, row) for title, lines in titled for row in rows(lines)]


def read_line(number: int, text: str, comment: str) -> Line:
    """Return a line of a file; a comment that begins with an unknown mark is an error."""
    stripped = text.lstrip()
    mark = stripped[1:2] if stripped.startswith(comment) else ""
    if mark and mark in MARKS and stripped[2:3] in ("", " "):
        return Line(number, mark, stripped[3:], text[: len(text) - len(stripped)])
    if mark and not (mark.isalnum() or mark in " \"('-+.…" or mark == comment):
        raise ValueError(f"line {number}: {comment}{mark} is no mark; README.md lists them")
    return Line(number, "", text)


def rows(lines: list[Line]) -> list[dict[str, str]]:
    """Return the rows of the table of a case; one empty row if it has none.

    Columns are separated by two spaces or more, or by |.
    """
    table = [re.split(r"\s*\|\s*|\s{2,}", line.text.strip()) for line in lines if line.mark == "*"]
    return [dict(zip(table[0], row, strict=True)) for row in table[1:]] if table else [{}]


def found(case: Case) -> Found:
    """Return what the program of a case shows; programs in a folder `check` are only checked."""
    source = Source(case.path.name, case.source())
    language = dialect_of(source.name)
    assert language is not None
    result = Found()
    try:
        settings = read_machine(Source(f"{case.path.stem}.machine.toml", case.source(machine=True)))
    except ProgramError as error:
        result.diagnostics = [(True, each.line, each) for each in error.diagnostics]
        return result
    if case.is_only_checked:
        result.diagnostics = [(False, each.line, each) for each in check(language.program(source, settings))]
        return result
    ran = run(source, machine=settings)
    if is_recorded(ran):
        assert prove(ran).violations == []
    result.printed = [line.translate(SYMBOLS).rstrip() for line in ran.output]
    result.diagnostics = [(False, each.line, each) for each in ran.diagnostics]
    result.unknown = ran.notes or ["none"]
    result.end = f"{ran.status} {ran.report['time']:.9g} s"
    if case.has("="):
        events = [(event["line"], shown(event)) for event in ran.report["events"]]
        result.events = events or [(located(case, "=")[0][1], "none")]
    return result


def shown(event: Any) -> str:
    """Return an event as its line beside a program: kind, axis, value and limit, and how often."""
    axis = f" axis {event['axis']}" if "axis" in event else ""
    values = " → ".join(f"{event[name]:.9g}" for name in ("value", "limit") if event.get(name) is not None)
    text = f" {event['text']}" if not values and not axis and event.get("text") else ""
    count = f", {event['count']} times" if "count" in event else ""
    return f"{event['kind']}{axis}{': ' * bool(values)}{values}{text}{count}"


def located(case: Case, mark: str) -> list[tuple[bool, int, str]]:
    """Return the marked texts, each with the line of the program or machine file in front of it."""
    at: tuple[bool, int] = (False, 0)
    texts = []
    for line in case.lines:
        if line.mark in ("", "|") and (line.text.strip() or line.mark):
            at = (line.mark == "|", line.number)
        elif line.mark == mark:
            texts.append((*at, case.filled(line.text)))
    return texts


def as_expected(diagnostic: Diagnostic, expected: str) -> str:
    """Return a diagnostic in as much detail as the expected text has."""
    text = f"{diagnostic.column} {diagnostic.code}" if diagnostic.column else diagnostic.code
    if ":" in expected or not expected:
        text += f": {diagnostic.message}"
    return f"{text}{HINT}{diagnostic.hint}" if HINT in expected else text


def compared(case: Case, result: Found) -> Iterator[tuple[str, list[Any], list[Any]]]:
    """Yield each kind of result with the expected and the found lines."""
    printed = [text.rstrip() for text in case.texts(">")]
    yield ">", printed, result.printed
    expected = sorted(located(case, "?"), key=lambda each: each[:2])
    reported = []
    for index, (machine, line, each) in enumerate(sorted(result.diagnostics, key=lambda each: each[:2])):
        detail = expected[index][2] if index < len(expected) else ""
        reported.append((machine, line, as_expected(each, detail)))
    yield "?", expected, reported
    if case.has("!"):
        yield "!", case.texts("!"), result.unknown
    if case.has("="):
        events = sorted(located(case, "="), key=lambda each: each[1])
        yield "=", [each[1:] for each in events], sorted(result.events, key=lambda each: each[0])
    if case.has("#"):
        yield "#", case.texts("#"), [result.end]


def differences(case: Case) -> list[str]:
    """Return what the program shows otherwise than the text beside it."""
    return [
        f"{mark} expected {wanted}\n{mark} found    {given}"
        for mark, wanted, given in compared(case, found(case))
        if wanted != given
    ]


def updated(path: Path) -> str:
    """Return the text of a file with what its programs now show.

    A case with a table keeps its text, since each row would write it.
    """
    texts = path.read_text(encoding="utf-8").split("\n")
    comment = COMMENTS[path.suffix]
    replaced: dict[int, list[str]] = {}
    behind: dict[int, list[str]] = {}
    for case in cases(path):
        if case.row:
            continue
        for mark, wanted, given in compared(case, found(case)):
            if wanted != given:
                _write(case, mark, given, comment, replaced, behind)
    lines = behind.get(0, [])
    for number, text in enumerate(texts, 1):
        lines += replaced.get(number, [text])
        lines += behind.get(number, [])
    return "\n".join(lines)


def _write(
    case: Case,
    mark: str,
    given: list[Any],
    comment: str,
    replaced: dict[int, list[str]],
    behind: dict[int, list[str]],
) -> None:
    """Put the results of a kind where its lines are, or behind the lines of the program that they belong to."""
    old = [line for line in case.lines if line.mark == mark]

    def line(text: str, indent: str = "") -> str:
        return f"{indent}{comment}{mark} {text}".rstrip()

    if mark in ("?", "="):
        replaced.update({each.number: [] for each in old})
        for *_, number, text in given:
            behind.setdefault(number or case.lines[0].number - 1, []).append(line(text))
        return
    if len(old) == len(given):
        replaced.update(
            {each.number: [line(text, each.indent)] for each, text in zip(old, given, strict=True)}
        )
        return
    replaced.update({each.number: [] for each in old})
    last = [each.number for each in case.lines if each.text.strip()][-1]
    behind.setdefault(last, []).extend(line(text) for text in given)


def files(matches: Callable[[Path], bool] = lambda path: True) -> list[Path]:
    """Return the files with cases, in order."""
    found = [path for path in sorted(FOLDER.rglob("*.m*")) if path.suffix in COMMENTS]
    return [path for path in found if matches(path)]
