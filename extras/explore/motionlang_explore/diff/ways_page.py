"""Two programs compared in all ways as one HTML page: the differences, and the states of both side by side."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from html import escape
from importlib.resources import files
from typing import NamedTuple

from motionlang.views import documents
from motionlang.views.table import Column, Table
from motionlang_explore.diff.ways import WaysCompared
from motionlang_explore.diff.ways_view import Names, ways_text
from motionlang_explore.map import view
from motionlang_explore.map.program_map import ProgramMap, map_of_exploration

STYLE = """
pre { white-space: pre-wrap; }
.both { display: grid; grid-template-columns: 1fr 1fr; gap: 2rem; } tr:has(td.only) td { background: #ffb34740; }
@media (max-width: 60rem) { pre { white-space: pre-wrap; }
.both { grid-template-columns: 1fr; } }
"""


class _Row(NamedTuple):
    """A way of a state, or what a handler does: where it begins, what leads on, what happens, and where it leads."""

    place: str
    statement: str
    until: str
    then: str
    to: str

    @property
    def key(self) -> Hashable:
        """The row without its lines and times."""
        return self.statement.lower(), self.until, self.then


def ways_page(found: WaysCompared, names: Names) -> str:
    """Return the page. A row that the other program has not is marked; lines do not count in it."""
    sides = [map_of_exploration(each) for each in (found.a, found.b)]
    rows = [list(_rows(each)) for each in sides]
    parts = []
    for k, (side, letter) in enumerate(zip(sides, "AB", strict=True)):
        known = {each.key for each in rows[1 - k]}
        table = _table(rows[k], [f"only in {letter}" if each.key not in known else "" for each in rows[k]])
        head = f"<h2>{letter}: {escape(side.source.name)}</h2>"
        parts.append(f'<div>{head}<div class="scroll">{documents.html_table(table, _cell)}</div></div>')
    title = f"{sides[0].source.name} and {sides[1].source.name} in all ways"
    text = f"<h1>{escape(title)}</h1><pre>{escape(ways_text(found, names))}</pre>"
    style = files(view).joinpath("style.css").read_text(encoding="utf-8")
    body = f'<main>{text}<div class="both">{"".join(parts)}</div></main>'
    head = '<meta name="viewport" content="width=device-width">'
    return documents.page(title, body, style + STYLE, head=head)


def _rows(made: ProgramMap) -> Iterator[_Row]:
    if made.behaviour is None:
        return
    for state in made.behaviour.states:
        for way in state.transitions:
            yield _Row(state.name, state.statement, way.until, "; ".join(way.then), way.to)
    for each in made.behaviour.handlers:
        yield _Row(each.unit, "", each.start, "; ".join(each.then), each.to)


def _table(rows: Sequence[_Row], marks: Sequence[str]) -> Table:
    columns = [
        Column("state", "waits in", get=lambda row: f"{row[0].place}: {row[0].statement}".removesuffix(": ")),
        Column("until", get=lambda row: row[0].until),
        Column("then", get=lambda row: row[0].then),
        Column("to", "goes on in", get=lambda row: row[0].to),
        Column("only", "", get=lambda row: row[1]),
    ]
    return Table("ways", columns, list(zip(rows, marks, strict=True)))


def _cell(heading: str, text: str) -> str:
    is_mark = not heading and text
    return f"<td{' class=only' if is_mark else ''}>{escape(text)}</td>"
