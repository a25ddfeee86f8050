"""A map as text for a terminal, and as Markdown."""

from __future__ import annotations

from textwrap import wrap

from motionlang.commands.map.program_map import ProgramMap
from motionlang.commands.map.states import Diagram, State, Transition
from motionlang.commands.map.view import tables
from motionlang.commands.map.view.mermaid import clipped, mermaid
from motionlang.commands.map.view.words import does, name_of, then, waits_for, when
from motionlang.kernel.tools import count_of
from motionlang.views.terminal import printable, styled


def headline(made: ProgramMap) -> str:
    """Return one line about the size of a program."""
    states = sum(len(diagram.states) for diagram in made.diagrams.diagrams)
    transitions = sum(len(diagram.transitions) for diagram in made.diagrams.diagrams)
    return (
        f"{made.source.name}: {made.language.title}, {count_of(len(made.channels), 'channel')}, "
        f"{count_of(len([each for each in made.axes if each.axis is not None]), 'axis', 'axes')}, "
        f"{count_of(len(made.units), 'unit')}, {count_of(states, 'state')}, {count_of(transitions, 'transition')}"
    )


def render(made: ProgramMap, *, width: int, colour: bool = False) -> str:
    """Return a map as text."""
    found = [headline(made)]
    for table in (tables.channels(made), tables.axes(made), tables.units(made), tables.variables(made)):
        found += ["", *table.lines(width, colour=colour)]
    found += ["", *tables.unreached(made).lines(width, colour=colour)]
    found += ["", styled("States", "bold", colour), "", ""]
    return "\n".join(found) + render_states(made, width=width, colour=colour)


def render_states(made: ProgramMap, *, width: int, colour: bool = False) -> str:
    """Return the states of all units, each with the transitions from it."""
    diagrams = (_diagram(made, diagram, width, colour) for diagram in made.diagrams.diagrams)
    return "\n\n".join("\n".join(lines) for lines in diagrams) + "\n"


def _diagram(made: ProgramMap, diagram: Diagram, width: int, colour: bool) -> list[str]:
    """Return the states of a unit, each with the transitions from it."""
    title = diagram.unit.title
    heading = f"{title}, line {diagram.unit.line}" if diagram.unit.line else title
    meaning = made.meaning(title)
    found = [styled(f"{heading}: {meaning}" if meaning else heading, "bold", colour)]
    leaving: dict[int, list[Transition]] = {}
    for each in diagram.transitions:
        leaving.setdefault(id(each.source), []).append(each)
    for state in diagram.states:
        if state.kind in ("return", "end", "jump"):
            continue
        found += _wrapped(_state(made, state), "  ", width)
        for each in leaving.get(id(state), ()):
            found += _wrapped(_transition(made, each), "      ", width)
    return found


def _state(made: ProgramMap, state: State) -> str:
    if state.kind == "start":
        return "begin"
    what = {"call": f"runs {state.unit}", "loop": "runs for ever"}.get(state.kind, "")
    if state.cause and state.cause != "time":
        what = f"waits for {waits_for(made, state)}"
    elif state.readings:
        what = f"polls {waits_for(made, state)}"
    notes = [what, f"meanwhile {does(state.meanwhile)}" if state.meanwhile else ""]
    again = made.observed.recovered.get(state, 0) if made.observed is not None else 0
    if again:
        notes.append(f"goes on here after an error, {count_of(again, 'time')}")
    shown = "; ".join(note for note in notes if note)
    return f"{state.line:4}  {state.text}" + (f"   [{shown}]" if shown else "")


def _transition(made: ProgramMap, each: Transition) -> str:
    condition, actions = when(each), then(each)
    target = each.target
    goes = target.text if target.kind in ("return", "end", "jump") else clipped(name_of(target))
    end = "" if not actions or actions.endswith(":") else ";"
    parts = [f"{condition}:" if condition else "", f"{actions}{end}", f"-> {goes}"]
    taken = made.taken(each)
    if taken is not None:
        parts.append(f"({taken.count} x)" if taken.count > 1 else "(once)")
    elif made.observed is not None:
        parts.append("(not taken)")
    return " ".join(part for part in parts if part)


def _wrapped(text: str, indent: str, width: int) -> list[str]:
    return wrap(
        printable(text), width, initial_indent=indent, subsequent_indent=indent + "    ", break_long_words=False,
        break_on_hyphens=False, drop_whitespace=True,
    )  # fmt: skip


def markdown(made: ProgramMap) -> str:
    """Return a map as Markdown, with diagrams that GitHub and others draw."""
    found = [f"# {made.source.name}", "", headline(made)]
    for table in (tables.channels(made), tables.axes(made), tables.units(made), tables.variables(made)):
        found += ["", f"## {table.head}", "", *(table.markdown() if table.rows else [table.empty])]
    unreached = tables.unreached(made)
    found += [
        "",
        f"## {unreached.head}",
        "",
        *(unreached.markdown() if unreached.rows else [unreached.empty]),
    ]
    found += ["", "## States"]
    for diagram in made.diagrams.diagrams:
        at = f" (line {diagram.unit.line})" if diagram.unit.line else ""
        found += ["", f"### {diagram.unit.title}{at}", "", "```mermaid", *mermaid(made, [diagram]), "```"]
    return "\n".join(found) + "\n"
