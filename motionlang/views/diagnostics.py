"""Layout of a diagnostic: message, location, excerpt with a mark, and hint.

    error[unknown-word]: there is no keyword MOVR
     --> pick.mnt:5:1
      |
    5 | MOVR(0) = 12
      | ^^^^
      hint: did you mean MOVER?

Plain text is the same on every system, so that tests can compare whole messages; only terminals get colours.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from textwrap import wrap

from motionlang.kernel import Diagnostic, Source
from motionlang.kernel.tools import clipped, count_of
from motionlang.views.formatting import significant
from motionlang.views.table import Column, Table
from motionlang.views.terminal import WIDTH, cells, printable, styled

TAB = 4
# A message quotes the user's text, which may be a megabyte without a space.
MAX_MESSAGE = 500
# The largest number of diagnostics shown for one file.
MAX_SHOWN = 100


def render(
    diagnostic: Diagnostic,
    source: Source | None = None,
    *,
    name: str = "",
    colour: bool = False,
    width: int = WIDTH,
    wrapped: bool = False,
) -> str:
    """Return one diagnostic with its excerpt, in lines that end with newlines.

    Without `source` there is no excerpt. `name` is the file as the user named it, if that differs from
    `source.name`. Message and hint are on one line each unless they are `wrapped` at words.
    """
    severity = diagnostic.severity
    head = f"{severity}[{diagnostic.code}]"
    first, *more = _lines(diagnostic.message, len(head) + 2, 2, width if wrapped else sys.maxsize)
    lines = [f"{styled(head, severity, colour)}: {styled(first, 'bold', colour)}"]
    lines += [f"  {styled(line, 'bold', colour)}" for line in more]
    gutter = len(str(diagnostic.line)) if source is not None and diagnostic.line else 1
    if source is not None:
        lines.append(
            f"{' ' * gutter}{styled('-->', 'location', colour)} {_location(diagnostic, name or source.name)}"
        )
        if diagnostic.line:
            lines += _excerpt(diagnostic, source.line(diagnostic.line), gutter, colour, width)
    if diagnostic.hint:
        indent = gutter + 7
        first, *more = _lines(diagnostic.hint, indent, indent, width if wrapped else sys.maxsize)
        lines.append(f"{' ' * (gutter + 1)}{styled('hint:', 'note', colour)} {first}")
        lines += [" " * indent + line for line in more]
    if diagnostic.count > 1:
        count = f"{diagnostic.count:,}".replace(",", " ")
        first, last = significant(diagnostic.first, 6), significant(diagnostic.last, 6)
        times = f"{count} times, from {first} s to {last} s"
        lines.append(f"{' ' * (gutter + 1)}{styled('note:', 'note', colour)} {times}")
    return "\n".join(lines) + "\n"


def render_all(
    diagnostics: Iterable[Diagnostic],
    source: Source | None = None,
    *,
    name: str = "",
    colour: bool = False,
    width: int = WIDTH,
) -> str:
    """Return the diagnostics, separated by empty lines.

    If there are very many, only the first are shown, with the number of the rest.
    """
    found = list(diagnostics)
    texts = [render(each, source, name=name, colour=colour, width=width) for each in found[:MAX_SHOWN]]
    if len(found) > MAX_SHOWN:
        texts.append(f"and {tally(found[MAX_SHOWN:])} more in the JSON report\n")
    return "\n".join(texts)


def diagnostics_table(found: Iterable[tuple[str, Diagnostic]]) -> Table:
    """Return diagnostics as data, each with the file that it is about."""
    names = ("file", "severity", "code", "message", "line", "column", "hint")
    rows = [{"file": file, **diagnostic.as_dict()} for file, diagnostic in found]
    return Table("diagnostics", [Column(name) for name in names], rows)


def tally(diagnostics: Iterable[Diagnostic]) -> str:
    """Count diagnostics by kind: "2 errors, 1 warning"; empty if there are none."""
    severities = [each.severity for each in diagnostics]
    counts = []
    for severity in ("error", "warning"):
        count = severities.count(severity)
        if count:
            counts.append(count_of(count, severity))
    return ", ".join(counts)


def _location(diagnostic: Diagnostic, name: str) -> str:
    location = printable(name)
    if diagnostic.line:
        location += f":{diagnostic.line}"
        if diagnostic.column:
            location += f":{diagnostic.column}"
    return location


def _short(text: str) -> str:
    return clipped(printable(text), MAX_MESSAGE)


def _lines(text: str, first: int, others: int, width: int) -> list[str]:
    """Return a text in lines without their indents, of `first` columns and, from the second line, of `others`."""
    found: list[str] = []
    for line in map(_short, text.split("\n")):
        indent = " " * (others if found else first)
        if len(indent) + len(line) <= width:
            found.append(line)
        else:
            found += [each.lstrip() for each in wrap(indent + line, width, subsequent_indent=" " * others)]
    return found


def _excerpt(diagnostic: Diagnostic, line: str, gutter: int, colour: bool, width: int) -> list[str]:
    """Return the line with its number, and carets below it if the column is known."""
    bar = styled("|", "location", colour)
    number = styled(f"{diagnostic.line:>{gutter}}", "location", colour)
    column = max(diagnostic.column, 1)
    shown, indent, marked = _window(line, column - 1, diagnostic.length, max(width - gutter - 3, 20))
    edge = " " * gutter
    lines = [f"{edge} {bar}", f"{number} {bar} {shown}".rstrip()]
    if diagnostic.column:
        carets = styled("^" * marked, diagnostic.severity, colour)
        lines.append(f"{edge} {bar} {' ' * indent}{carets}")
    return lines


def _window(line: str, at: int, length: int, room: int) -> tuple[str, int, int]:
    """Return the part of `line` around `at` that fits into `room` cells.

    Also returns the start and the width of the mark in it.
    """
    at = min(at, len(line))
    # More characters than `room` on either side never fit, so a megabyte costs as little as a line.
    first = max(0, at - room)
    before = _widened(line[first:at])
    after = _widened(line[at : at + room], cells(before))
    marked = cells(_widened(line[at : at + max(length, 1)][:room], cells(before)))
    cut_right = len(line) > at + room
    if cells(before) + max(cells(after), 1) + cut_right > room:
        if first or cells(before) + min(marked, room // 2) > room - 1:
            before = "…" + _last(before, room // 2)
        left = room - cells(before)
        cut_right = cut_right or cells(after) > left
        after = _first(after, left - 1) + "…" if cut_right else after
    indent = cells(before)
    return before + after, indent, max(1, min(marked, room - indent - cut_right))


def _widened(text: str, start: int = 0) -> str:
    """Return `text` as printable cells, with tabs expanded to spaces.

    The first character is in cell `start`.
    """
    if "\t" not in text:
        return printable(text)
    made, column = [], start
    for segment in text.split("\t"):
        shown = printable(segment)
        column += cells(shown)
        stop = TAB - column % TAB
        made.append(shown + " " * stop)
        column += stop
    return "".join(made)[: -stop or None]


def _last(text: str, room: int) -> str:
    """Return the end of `text` that fits into `room` cells."""
    shown = text[-room:]
    while cells(shown) > room:
        shown = shown[1:]
    return shown


def _first(text: str, room: int) -> str:
    """Return the start of `text` that fits into `room` cells."""
    shown = text[: max(room, 0)]
    while cells(shown) > room:
        shown = shown[:-1]
    return shown
