"""A diagram of states as SVG: laid out by Graphviz if it is installed, else by `layout.py`."""

from __future__ import annotations

import re
import shutil
import subprocess
from html import escape
from itertools import pairwise
from math import fsum

from motionlang.commands.map.program_map import ProgramMap
from motionlang.commands.map.states import Diagram, State
from motionlang.commands.map.view.layout import Layout, layout
from motionlang.commands.map.view.mermaid import dot, edge_label, label
from motionlang.commands.map.view.words import then, when

# Sizes of text in pixels: the width of a character is that of the widest common font at this size.
FONT, SMALL = 12.0, 11.0
CHARACTER = 0.6
LINE = 1.3
PAD = 8.0
# Seconds that Graphviz may take for one diagram.
PATIENCE = 20.0


def picture(made: ProgramMap, diagram: Diagram, *, graphviz: bool | None = None) -> str:
    """Return a diagram as an SVG element whose states lead to their lines (`#L12`).

    `graphviz` is True to lay it out by Graphviz, by default if its `dot` is found; False for the layout of our own.
    """
    program = shutil.which("dot") if graphviz is not False else None
    if program is not None:
        found = _by_graphviz(program, dot(made, [diagram], links=True))
        if found:
            return found
    return _own(made, diagram)


def _by_graphviz(program: str, text: str) -> str:
    """Return the SVG element of a DOT text, "" if `dot` fails."""
    try:
        done = subprocess.run(
            [program, "-Tsvg"], input=text, capture_output=True, text=True, timeout=PATIENCE, check=True
        )
    except (OSError, subprocess.SubprocessError):
        return ""
    found = done.stdout[done.stdout.find("<svg") :]
    found = re.sub(
        r'(<svg[^>]*?) width="(\d+)pt" height="(\d+)pt"', r'\1 width="\2" height="\3"', found, count=1
    )
    return found.replace("xlink:href", "href").replace("xlink:title", "title")


def _own(made: ProgramMap, diagram: Diagram) -> str:
    nodes = {state.id: label(made, state) for state in diagram.states}
    labels = [edge_label(made, each) for each in diagram.transitions]
    sizes = {name: _size(lines, FONT, 2 * PAD) for name, lines in nodes.items()}
    placed = layout(
        sizes,
        [
            (each.source.id, each.target.id, _size(lines, SMALL, 4.0))
            for each, lines in zip(diagram.transitions, labels, strict=True)
        ],
    )
    found = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{placed.width + 2 * PAD:.0f}" '
        f'height="{placed.height + 2 * PAD:.0f}" '
        f'viewBox="{-PAD} {-PAD} {placed.width + 2 * PAD:.0f} {placed.height + 2 * PAD:.0f}" '
        f'role="img" aria-label="{escape("states of " + diagram.unit.title)}">',
        '<defs><marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" '
        'orient="auto"><path d="M0 0L8 4L0 8z"/></marker></defs>',
    ]
    below = _below(diagram, labels)
    for k, (each, lines) in enumerate(zip(diagram.transitions, labels, strict=True)):
        taken = made.taken(each)
        style = " taken" if taken is not None else " untaken" if made.observed is not None else ""
        drawn = _edge(placed, k, each.source.id, each.target.id, sizes, lines, style, below.get(k, 0.0))
        whole = escape(f"{when(each)}: {then(each)}".removeprefix(": "))
        found += ["<g>", f"<title>{whole}</title>", *drawn, "</g>"]
    for state in diagram.states:
        found += _node(state, placed, sizes[state.id], nodes[state.id])
    return "\n".join([*found, "</svg>"])


def _size(lines: list[str], font: float, pad: float) -> tuple[float, float]:
    if not lines:
        return 6.0, 0.0
    return max(map(len, lines)) * font * CHARACTER + pad, len(lines) * font * LINE + pad


def _edge(
    placed: Layout,
    number: int,
    source: str,
    target: str,
    sizes: dict[str, tuple[float, float]],
    lines: list[str],
    style: str,
    below: float,
) -> list[str]:
    """Return the line of an edge with its label; that of a state to itself is `below` the middle of the state."""
    bends, middle = placed.edges[number]
    (x, y), (to_x, to_y) = placed.nodes[source], placed.nodes[target]
    if source == target:
        return _loop(lines, style, x + sizes[source][0] / 2, y, below)
    down = (bends[0][1] if bends else to_y) > y
    start = x, y + (1 if down else -1) * sizes[source][1] / 2
    end = to_x, to_y - (1 if down else -1) * sizes[target][1] / 2
    points = [start, *bends, end]
    path = f"M{points[0][0]:.0f} {points[0][1]:.0f}"
    for (ax, ay), (bx, by) in pairwise(points):
        half = (ay + by) / 2
        path += f"C{ax:.0f} {half:.0f} {bx:.0f} {half:.0f} {bx:.0f} {by:.0f}"
    shown = _texts(lines, *middle, SMALL, "label")
    if lines:
        width, height = _size(lines, SMALL, 4.0)
        back = f'<rect class="back" x="{middle[0] - width / 2:.0f}" y="{middle[1] - height / 2:.0f}" '
        shown.insert(0, back + f'width="{width:.0f}" height="{height:.0f}"/>')
    return [f'<path class="path{style}" d="{path}"/>', *shown]


def _below(diagram: Diagram, labels: list[list[str]]) -> dict[int, float]:
    """Return how far below the middle of its state the label of each edge to itself is, by number."""
    loops: dict[str, list[int]] = {}
    for k, each in enumerate(diagram.transitions):
        if each.source is each.target:
            loops.setdefault(each.source.id, []).append(k)
    found = {}
    for numbers in loops.values():
        heights = [_size(labels[k], SMALL, 4.0)[1] for k in numbers]
        for n, k in enumerate(numbers):
            found[k] = fsum(heights[:n]) + heights[n] / 2 - fsum(heights) / 2
    return found


def _loop(lines: list[str], style: str, right: float, y: float, below: float) -> list[str]:
    """Return the line of an edge from a state to itself, at the right of it."""
    width = _size(lines, SMALL, 4.0)[0]
    path = f"M{right:.0f} {y - 5:.0f}L{right + 16:.0f} {y + below - 4:.0f}v8L{right:.0f} {y + 5:.0f}"
    shown = _texts(lines, right + 22 + width / 2, y + below, SMALL, "label")
    return [f'<path class="path{style}" d="{path}"/>', *shown]


def _node(state: State, placed: Layout, size: tuple[float, float], lines: list[str]) -> list[str]:
    (x, y), (width, height) = placed.nodes[state.id], size
    radius = height / 2 if state.kind in ("start", "return", "end") else 10 if state.kind == "wait" else 2
    box = (
        f'<rect class="state {state.kind} {state.cause}" x="{x - width / 2:.0f}" y="{y - height / 2:.0f}" '
        f'width="{width:.0f}" height="{height:.0f}" rx="{radius:.0f}"/>'
    )
    shown = [box, *_texts(lines, x, y, FONT, "name")]
    return [f'<a href="#L{state.line}">', *shown, "</a>"] if state.line else shown


def _texts(lines: list[str], x: float, y: float, font: float, style: str) -> list[str]:
    top = y - len(lines) * font * LINE / 2
    return [
        f'<text class="{style}" x="{x:.0f}" y="{top + (k + 0.78) * font * LINE:.1f}">{escape(line)}</text>'
        for k, line in enumerate(lines)
    ]
