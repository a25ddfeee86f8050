"""The states of a machine as a Mermaid flowchart."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from motionlang.kernel.tools import clipped
from motionlang_explore.map.behaviour import MachineBehaviour, TransitionRow

# The longest text of a node or an edge; the tables have the rest.
MAX_LINES, MAX_TEXT = 5, 48
# The node of a program that has ended.
END = "the end"


def mermaid(behaviour: MachineBehaviour | None) -> list[str]:
    """Return the lines of a Mermaid flowchart; without states it has no node."""
    found = ["flowchart TD"]
    for name, lines in _nodes(behaviour):
        opening, closing = ("[", "]") if len(lines) > 1 else ("([", "])")
        found.append(f"    {name}{opening}{_quoted(lines)}{closing}")
    for source, target, lines in _edges(behaviour):
        found.append(f"    {source} -->|{_quoted(lines)}| {target}")
    return found


def _nodes(behaviour: MachineBehaviour | None) -> Iterator[tuple[str, list[str]]]:
    """Yield the name of each node and the lines of its text."""
    states = behaviour.states if behaviour is not None else []
    for number, state in enumerate(states):
        yield f"n{number}", [clipped(each, MAX_TEXT) for each in (state.name, state.statement) if each]
    if any(way.to == END for state in states for way in state.transitions):
        yield "n_end", [END]


def _edges(behaviour: MachineBehaviour | None) -> Iterator[tuple[str, str, list[str]]]:
    """Yield the nodes of each edge, and the lines of its text: what leads on, and what happens then."""
    states = behaviour.states if behaviour is not None else []
    numbers = {state.name: f"n{number}" for number, state in enumerate(states)} | {END: "n_end"}
    for state in states:
        for way in state.transitions:
            yield numbers[state.name], numbers.get(way.to, numbers[state.name]), _label(way)


def _label(way: TransitionRow) -> list[str]:
    found = [f"{way.until}, {way.seconds:.2f} s", *way.then]
    if len(found) > MAX_LINES:
        found[MAX_LINES:] = [f"… {len(found) - MAX_LINES} more"]
    return [clipped(each, MAX_TEXT) for each in found]


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
