"""A map as one HTML page with no external resources: tables, diagrams, the program with its lines as targets."""

from __future__ import annotations

import re
from dataclasses import replace
from html import escape
from importlib.resources import files

from motionlang.commands.map.program_map import ProgramMap
from motionlang.commands.map.view import tables
from motionlang.commands.map.view.mermaid import COLOURS
from motionlang.commands.map.view.svg import picture
from motionlang.commands.map.view.text import headline
from motionlang.commands.map.view.words import CAUSES
from motionlang.views.html_table import html_table
from motionlang.views.table import Table

_KEY = (
    '<p class="key">'
    + "".join(
        f'<span style="background:{colour};border-radius:8px">waits for {CAUSES[cause]}</span>'
        for cause, colour in COLOURS.items()
    )
    + '<span style="background:#fff;border-width:2px">runs another unit</span></p>'
)
# Columns whose cells are text of the program, and those whose cells are lines.
_CODE = frozenset(
    ("statement", "value", "state", "from", "to", "when", "does", "text", "values", "meanwhile")
)
_LINES = frozenset(("waited for", "read", "written", "assigned", "lines", "line", "from line", "to line"))
# Columns whose cells are units with lines in brackets.
_UNITS = frozenset(("called by", "calls"))
# A cell of fewer characters is not broken.
MAX_SHORT = 40
_LINES_IN_TEXT = re.compile(r"\((\d[\d, -]*)\)")


def _style() -> str:
    """Return the style sheet, with the colours of states."""
    colours = "".join(
        f"svg .state.{cause} {{ fill: {colour}; }} svg .state.{cause} ~ text {{ fill: #111; }}\n"
        for cause, colour in COLOURS.items()
    )
    return files(__name__.rpartition(".")[0]).joinpath("style.css").read_text(encoding="utf-8") + colours


def page(made: ProgramMap, timing: str = "", *, graphviz: bool | None = None) -> str:
    """Return the page; `timing` is the SVG of a cycle, `graphviz` as for `svg.picture`."""
    sections = [
        ("channels", tables.channels(made)),
        ("axes", tables.axes(made)),
        ("structure", tables.units(made)),
        ("variables", tables.variables(made)),
        ("never", tables.unreached(made)),
    ]
    name = escape(made.source.name)
    body = [f"<h1>{name}</h1>", f'<p class="head">{escape(headline(made))}</p>']
    for key, table in sections:
        body += [f'<h2 id="{key}">{escape(table.head)}</h2>', *_table(table)]
    body += ['<h2 id="states">States</h2>', _KEY]
    for k, diagram in enumerate(made.diagrams.diagrams):
        at = f' <a href="#L{diagram.unit.line}">line {diagram.unit.line}</a>' if diagram.unit.line else ""
        body += [f'<h3 id="U{k}">{escape(diagram.unit.title)}{at}</h3>', '<div class="scroll">']
        body += [picture(made, diagram, graphviz=graphviz), "</div>"]
    if timing:
        body += ['<h2 id="cycle">One cycle</h2>', '<div class="scroll">', timing, "</div>"]
    body += ['<h2 id="transitions">Transitions</h2>', *_table(tables.transitions(made))]
    body += ['<h2 id="program">Program</h2>', *_program(made)]
    links = [
        ("channels", "Inputs and outputs"),
        ("axes", "Axes"),
        ("structure", "Structure"),
        ("states", "States"),
    ]
    links += [("cycle", "One cycle")] if timing else []
    links += [("transitions", "Transitions"), ("program", "Program")]
    nav = "".join(f'<a href="#{key}">{title}</a>' for key, title in links)
    head = '<meta charset="utf-8"><meta name="viewport" content="width=device-width">'
    return (
        f'<!doctype html>\n<html lang="en"><head>{head}<title>Map of {name}</title><style>{_style()}</style></head>\n'
        f"<body><nav>{nav}</nav><main>\n" + "\n".join(body) + "\n</main></body></html>\n"
    )


def _table(table: Table) -> list[str]:
    """Return a table whose line numbers are links."""
    if not table.rows:
        return [f"<p>{escape(table.empty)}</p>"]
    used = [each for each in table.columns if any(each.texts(table.rows))]
    return [f'<div class="scroll">{html_table(replace(table, columns=used), _cell)}</div>']


def _cell(head: str, text: str) -> str:
    shown = escape(text)
    if head in _LINES:
        shown = _linked(shown)
    elif head in _UNITS:
        shown = _LINES_IN_TEXT.sub(lambda found: f"({_linked(found[1])})", shown)
    if head in _CODE:
        return f'<td class="code">{shown}</td>'
    return f'<td class="short">{shown}</td>' if len(text) < MAX_SHORT else f"<td>{shown}</td>"


def _linked(numbers: str) -> str:
    return re.sub(r"\d+", lambda found: f'<a href="#L{found[0]}">{found[0]}</a>', numbers)


def _program(made: ProgramMap) -> list[str]:
    """Return the lines of the program, each a target of links."""
    never = {line for first, last in made.unreached for line in range(first, last + 1)}
    rows = []
    for number, line in made.source.numbered():
        style = "row never" if number in never else "row"
        rows.append(
            f'<span class="{style}" id="L{number}"><a class="n" href="#L{number}">{number}</a>{escape(line)}</span>'
        )
    return ["<pre>" + "\n".join(rows) + "</pre>"]
