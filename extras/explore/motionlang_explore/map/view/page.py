"""A map as one HTML page with no external resources: tables, diagrams, the program with its lines as targets."""

from __future__ import annotations

import re
from dataclasses import replace
from html import escape
from importlib.resources import files

from motionlang.views import documents
from motionlang.views.table import Table
from motionlang_explore.map.program_map import ProgramMap
from motionlang_explore.map.view import tables
from motionlang_explore.map.view.text import cycle_line, headline, world_lines

# Columns whose cells are text of the program, and those whose cells are lines.
_CODE = frozenset(("statement", "value", "text", "values", "waits in"))
_LINES = frozenset(("waited for", "read", "written", "assigned", "lines", "line", "from line", "to line"))
# Columns whose cells are units with lines in brackets.
_UNITS = frozenset(("called by", "calls"))
# A cell of fewer characters is not broken.
MAX_SHORT = 40
_LINES_IN_TEXT = re.compile(r"\((\d[\d, -]*)\)")


def page(made: ProgramMap, timing: str = "") -> str:
    """Return the page; `timing` is the SVG of a cycle."""
    name = escape(made.source.name)
    body = [f"<h1>{name}</h1>", f'<p class="head">{escape(headline(made))}</p>']
    links = []
    behaviour = made.behaviour
    if behaviour is not None:
        world = "\n".join(world_lines(behaviour))
        body += ['<h2 id="cycle">Cycle</h2>', f"<p>{escape(cycle_line(behaviour))}</p>"]
        body += ['<div class="scroll">', timing, "</div>", *_table(tables.cycle(behaviour))]
        cautions = tables.cautions(behaviour)
        body += [f'<h2 id="cautions">{cautions.head}</h2>', *_table(cautions)]
        never = tables.unreached(made)
        body += [f'<h2 id="{never.name}">{never.head}</h2>', *_table(never)]
        body += ['<h2 id="states">States</h2>']
        if world:
            body.append(f"<p>In this world, which motionlang init writes:</p><pre>{escape(world)}</pre>")
        body += [f"<p>{escape(each)}</p>" for each in behaviour.remarks]
        body += _table(tables.transitions(behaviour))
        body += ['<h2 id="choices">Choices</h2>', *_table(tables.choices(behaviour))]
        body += ['<h2 id="handlers">Handlers</h2>', *_table(tables.handlers(behaviour))]
        host = tables.host_numbers(made, behaviour)
        body += [f'<h2 id="host">{host.head}</h2>', *_table(host)] if host.rows else []
        links = [
            ("cycle", "Cycle"),
            ("cautions", "Cautions"),
            (never.name, never.head),
            ("states", "States"),
            ("handlers", "Handlers"),
        ]
    for table in tables.of_text(made)[: None if behaviour is None else -1]:
        body += [f'<h2 id="{table.name}">{escape(table.head)}</h2>', *_table(table)]
        links.append((table.name, table.head))
    body += ['<h2 id="program">Program</h2>', *_program(made)]
    nav = "".join(f'<a href="#{key}">{title}</a>' for key, title in [*links, ("program", "Program")])
    head = '<meta name="viewport" content="width=device-width">'
    style = files(__name__.rpartition(".")[0]).joinpath("style.css").read_text(encoding="utf-8")
    main = "\n".join(["<main>", *body, "</main>"])
    return documents.page(f"Map of {made.source.name}", f"<nav>{nav}</nav>{main}", style, head=head)


def _table(table: Table) -> list[str]:
    """Return a table whose line numbers are links."""
    if not table.rows:
        return [f"<p>{escape(table.empty)}</p>"]
    used = [each for each in table.columns if any(each.texts(table.rows))]
    return [f'<div class="scroll">{documents.html_table(replace(table, columns=used), _cell)}</div>']


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
    never = {line for each in tables.unreached(made).rows for line in range(each.first, each.last + 1)}
    rows = []
    for number, line in made.source.numbered():
        style = "row never" if number in never else "row"
        rows.append(
            f'<span class="{style}" id="L{number}"><a class="n" href="#L{number}">{number}</a>{escape(line)}</span>'
        )
    return ["<pre>" + "\n".join(rows) + "</pre>"]
