"""Diagrams of states as Mermaid flowcharts and as DOT."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from motionlang.commands.map.program_map import ProgramMap
from motionlang.commands.map.states import Diagram, State, Transition
from motionlang.commands.map.view.words import does, segments, waits_for

# The brackets of a node in Mermaid, and its shape in DOT, by kind of state.
_BRACKETS = {
    "start": ("([", "])"),
    "return": ("([", "])"),
    "end": ("([", "])"),
    "jump": (">", "]"),
    "call": ("[[", "]]"),
    "wait": ("[", "]"),
    "poll": ("{{", "}}"),
    "loop": ("(", ")"),
    "meet": ("(", ")"),
    "branch": ("(", ")"),
}
_SHAPES = {
    "start": 'style="rounded,filled" fillcolor="#eeeeee"',
    "return": 'style="rounded,filled" fillcolor="#eeeeee"',
    "end": 'style="rounded,filled" fillcolor="#eeeeee"',
    "jump": "shape=cds style=filled",
    "call": "style=filled penwidth=2",
    "wait": 'style="rounded,filled"',
    "poll": "shape=hexagon style=filled",
    "loop": "shape=ellipse style=filled",
    "meet": "shape=ellipse style=filled",
    "branch": "shape=ellipse style=filled",
}
# The colours of states by what they wait for, also those of the page.
COLOURS = {"axis": "#dbeafe", "input": "#dcf5df", "operator": "#fdeccb", "time": "#eee6fb"}
# The attributes of an edge that a run took.
TAKEN = 'color="#0b57a4" penwidth=1.6'
# The longest text of a node or an edge; the tables have the rest.
MAX_LINES = 5
MAX_TEXT = 48


def mermaid(made: ProgramMap, diagrams: Sequence[Diagram] | None = None) -> list[str]:
    """Return the lines of a Mermaid flowchart of some diagrams, or of all, each in a frame of its own."""
    chosen = made.diagrams.diagrams if diagrams is None else diagrams
    found = ["flowchart TD"]
    for number, diagram in enumerate(chosen):
        if len(chosen) > 1:
            found.append(f"  subgraph s{number}[{_quoted([diagram.unit.title])}]")
        for state in diagram.states:
            opening, closing = _BRACKETS[state.kind]
            found.append(f"    {state.id}{opening}{_quoted(label(made, state))}{closing}")
        for each in diagram.transitions:
            text = edge_label(made, each)
            arrow = f"-->|{_quoted(text)}|" if text else "-->"
            found.append(f"    {each.source.id} {arrow} {each.target.id}")
        if len(chosen) > 1:
            found.append("  end")
    return found


def dot(made: ProgramMap, diagrams: Sequence[Diagram] | None = None, *, links: bool = False) -> str:
    """Return a DOT graph of some diagrams, or of all; with `links` each state leads to its line of a page."""
    chosen = made.diagrams.diagrams if diagrams is None else diagrams
    found = [
        f"digraph {_string('map of ' + made.source.name)} {{",
        '  graph [fontname="sans-serif" fontsize=12 rankdir=TB nodesep=0.35 ranksep=0.4]',
        '  node [fontname="sans-serif" fontsize=11 shape=box fillcolor=white]',
        '  edge [fontname="sans-serif" fontsize=10 color="#5b6770"]',
    ]
    for number, diagram in enumerate(chosen):
        if len(chosen) > 1:
            found += [f"  subgraph cluster_{number} {{", f"    label={_string(diagram.unit.title)}"]
        for state in diagram.states:
            link = f" URL={_string(f'#L{state.line}')}" if links and state.line else ""
            colour = f' fillcolor="{COLOURS[state.cause]}"' if state.cause in COLOURS else ""
            text = _string("\\n".join(map(_escaped, label(made, state))), is_escaped=True)
            found.append(f"    {state.id} [label={text} {_SHAPES[state.kind]}{colour}{link}]")
        for each in diagram.transitions:
            lines = edge_label(made, each)
            label_of = f"label={_string(_left(lines), is_escaped=True)}" if lines else ""
            style = ""
            if made.observed is not None:
                style = TAKEN if made.taken(each) is not None else "style=dashed"
            found.append(f"    {each.source.id} -> {each.target.id} [{f'{label_of} {style}'.strip()}]")
        if len(chosen) > 1:
            found.append("  }")
    return "\n".join([*found, "}"]) + "\n"


def label(made: ProgramMap, state: State) -> list[str]:
    """Return the lines of a node."""
    if state.kind in ("start", "return", "end"):
        return [{"start": "begin"}.get(state.kind, state.text)]
    if state.kind == "jump":
        return [state.text]
    found = [clipped(f"{state.line}  {state.text}")]
    if state.cause and state.cause != "time":
        found.append(clipped(f"waits for {waits_for(made, state)}"))
    elif state.kind == "loop":
        found.append("runs for ever")
    found += [clipped(does([each])) for each in state.meanwhile[:2]]
    return found


def edge_label(made: ProgramMap, transition: Transition) -> list[str]:
    """Return the lines of an edge: condition, actions, and how often a run took it."""
    found: list[str] = []
    for condition, actions in segments(transition):
        found += [clipped(f"{condition}:")] if condition else []
        found += [
            clipped("  " * each.depth + each.text + (":" if each.is_condition else "")) for each in actions
        ]
    if len(found) > MAX_LINES:
        found[MAX_LINES:] = [f"… {len(found) - MAX_LINES} more"]
    taken = made.taken(transition)
    if taken is not None:
        found.append(f"{taken.count} ×")
    return found


def clipped(text: str) -> str:
    """Return a text that is short enough for a diagram."""
    return text if len(text) <= MAX_TEXT else text[: MAX_TEXT - 1] + "…"


def _quoted(lines: Iterable[str]) -> str:
    """Return lines as a text of Mermaid, which has codes for signs with a meaning."""
    signs = {
        "#": "#35;",
        '"': "#quot;",
        "<": "#lt;",
        ">": "#gt;",
        "&": "#amp;",
        "`": "#96;",
        "|": "#124;",
        "\\": "#92;",
    }
    return '"' + "<br>".join("".join(signs.get(sign, sign) for sign in line) for line in lines) + '"'


def _escaped(text: str) -> str:
    return text.replace("\\", "\\\\").replace('"', '\\"')


def _left(lines: Iterable[str]) -> str:
    return "".join(f"\u00a0{_escaped(line)}\\l" for line in lines)


def _string(text: str, is_escaped: bool = False) -> str:
    return f'"{text if is_escaped else _escaped(text)}"'
