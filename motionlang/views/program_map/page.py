"""A map as one HTML page with no external resources: tables, diagrams, the program with its lines as targets."""

from __future__ import annotations

import re
from html import escape

from motionlang.analysis.program_map.program_map import ProgramMap
from motionlang.views.program_map import tables
from motionlang.views.program_map.svg import picture
from motionlang.views.program_map.text import headline
from motionlang.views.table import Table

_STYLE = """
:root { --ink: #1b1f24; --dim: #667; --line: #d5d9de; --paper: #fff; --wash: #f4f6f8; --link: #0b57a4; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e8ea; --dim: #9aa4ad; --line: #3a424a; --paper: #16191d; --wash: #20252b; --link: #7db7f5; }
}
body { font: 15px/1.45 system-ui, sans-serif; color: var(--ink); background: var(--paper); margin: 0; }
main { max-width: 76rem; margin: 0 auto; padding: 1rem 1.5rem 4rem; }
nav { position: sticky; top: 0; background: var(--paper); border-bottom: 1px solid var(--line); padding: .5rem 1.5rem; }
nav a { margin-right: 1.2rem; }
a { color: var(--link); text-decoration: none; } a:hover { text-decoration: underline; }
h1 { font-size: 1.5rem; margin: .6rem 0 .2rem; } h2 { font-size: 1.2rem; margin: 2.2rem 0 .6rem; }
h3 { font-size: 1rem; margin: 1.6rem 0 .4rem; }
p.head { color: var(--dim); margin: 0; }
table { border-collapse: collapse; } td, th { text-align: left; vertical-align: top; padding: .18rem .9rem .18rem 0; }
th { border-bottom: 1px solid var(--line); font-weight: 600; } tr:hover td { background: var(--wash); }
.scroll { overflow-x: auto; } td.code, pre { font-family: ui-monospace, Consolas, monospace; font-size: .86rem; }
pre { line-height: 1.4; background: var(--wash); padding: .6rem; overflow-x: auto; }
pre a.n { color: var(--dim); display: inline-block; width: 3.2rem; text-align: right; margin-right: 1rem; }
pre span.row:target { background: #ffe9a8; color: #000; display: inline-block; min-width: 100%; }
pre span.never { opacity: .55; text-decoration: line-through; }
svg text { font-family: system-ui, sans-serif; fill: var(--ink); }
svg text.name { text-anchor: middle; font-size: 12px; } svg text.label { text-anchor: middle; font-size: 11px; }
svg .state { fill: var(--paper); stroke: #5b6770; stroke-width: 1.2; }
svg .state.start, svg .state.end, svg .state.return { fill: var(--wash); }
svg .state.axis { fill: #dbeafe; } svg .state.input { fill: #dcf5df; } svg .state.operator { fill: #fdeccb; }
svg .state.time { fill: #eee6fb; } svg .state.call { stroke-width: 2.2; }
svg .state.axis + text, svg .state.input + text, svg .state.operator + text, svg .state.time + text { fill: #111; }
svg .state.axis ~ text, svg .state.input ~ text, svg .state.operator ~ text, svg .state.time ~ text { fill: #111; }
svg .edge { fill: none; stroke: #7a8790; stroke-width: 1.2; marker-end: url(#tip); }
svg .edge.taken { stroke: #0b57a4; stroke-width: 1.8; } svg .edge.untaken { stroke-dasharray: 4 4; }
svg .back { fill: var(--paper); } svg marker path { fill: #7a8790; }
.key span { display: inline-block; padding: .05rem .6rem; margin-right: .6rem; border: 1px solid #5b6770; color: #111; }
"""
_KEY = (
    '<p class="key"><span style="background:#dbeafe;border-radius:8px">waits for motion</span>'
    '<span style="background:#dcf5df;border-radius:8px">for an input</span>'
    '<span style="background:#eee6fb;border-radius:8px">for a time</span>'
    '<span style="background:#fdeccb;border-radius:8px">for the operator</span>'
    '<span style="background:#fff;border-width:2px">runs another unit</span></p>'
)
# Columns whose cells are text of the program, and those whose cells are lines.
_CODE = frozenset(
    ("statement", "value", "state", "from", "to", "when", "does", "text", "values", "meanwhile")
)
_LINES = frozenset(("waited for", "read", "written", "assigned", "lines", "line", "from line", "to line"))
_LINES_IN_TEXT = re.compile(r"\((\d[\d, -]*)\)")


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
        f'<!doctype html>\n<html lang="en"><head>{head}<title>Map of {name}</title><style>{_STYLE}</style></head>\n'
        f"<body><nav>{nav}</nav><main>\n" + "\n".join(body) + "\n</main></body></html>\n"
    )


def _table(table: Table) -> list[str]:
    """Return a table whose line numbers are links."""
    if not table.rows:
        return [f"<p>{escape(table.empty)}</p>"]
    heads, rows = table.cells()
    used = [k for k in range(len(heads)) if any(row[k] for row in rows)]
    found = [
        '<div class="scroll"><table>',
        f"<tr>{''.join(f'<th>{escape(heads[k])}</th>' for k in used)}</tr>",
    ]
    for row in rows:
        found.append(f"<tr>{''.join(_cell(heads[k], row[k]) for k in used)}</tr>")
    return [*found, "</table></div>"]


def _cell(head: str, text: str) -> str:
    shown = escape(text)
    if head in _LINES:
        shown = _linked(shown)
    else:
        shown = _LINES_IN_TEXT.sub(lambda found: f"({_linked(found[1])})", shown)
    return f'<td class="code">{shown}</td>' if head in _CODE else f"<td>{shown}</td>"


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
