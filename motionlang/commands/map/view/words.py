"""Words for the states and transitions of a map."""

from __future__ import annotations

from collections.abc import Iterable

from motionlang.commands.map.program_map import ProgramMap
from motionlang.commands.map.states import Action, State, Transition
from motionlang.kernel.lang.program_graph import READ

# What a task waits for, by cause.
CAUSES = {
    "time": "a time",
    "axis": "motion",
    "input": "an input",
    "operator": "the operator",
    "task": "another task",
    "host": "a host",
    "condition": "a condition",
}


def waits_for(made: ProgramMap, state: State) -> str:
    """Return what a state waits for, with the names of channels and axes; "" if it does not wait."""
    if not state.cause:
        return ""
    statement = made.structure.statements.get(state.at)
    found: dict[str, None] = {}
    polled = made.structure.polls(state.at)
    if statement is not None:
        used = {(use.channel, use.number) for use in statement.channels if use.access == READ}
        known = [each for each in made.channels if (each.kind, each.number) in used and each.kind != "answer"]
        level = (
            statement.condition.rpartition(" ")[2] if statement.condition.endswith((" on", " off")) else ""
        )
        found |= dict.fromkeys(f"{each.known_as} to be {level}" if level else each.known_as for each in known)
        axes = statement.what or (
            tuple(n for kind, n in polled.leaves if kind in ("axis", "position") and n is not None)
            if polled
            else ()
        )
        titles = {each.axis: each.title for each in made.axes}
        found |= dict.fromkeys(titles.get(axis, f"axis {axis}") for axis in sorted(axes))
    if state.cause == "operator":
        return "the operator"
    return ", ".join(found) or CAUSES[state.cause]


def name_of(state: State) -> str:
    """Return a short name of a state: its line and its text."""
    if state.kind in ("start", "return", "end", "jump"):
        return {"start": "begin"}.get(state.kind, state.text)
    return f"{state.line} {state.text}"


def when(transition: Transition) -> str:
    """Return the conditions of a transition, such as "if a > 1" or "unless a > 1", "" if it has none."""
    conditions = transition.conditions
    if len(conditions) == 1 and not conditions[0].holds and not conditions[0].text.startswith("not ("):
        return f"unless {conditions[0].text}"
    return "if " + " and ".join(dict.fromkeys(map(str, conditions))) if conditions else ""


def does(actions: Iterable[Action]) -> str:
    """Return actions on one line: "if a > 1: (b = 2; c = 3); d = 4"."""
    given = list(actions)
    found, lowest = "", min((each.depth for each in given), default=0)
    depth = lowest
    for each in given:
        while depth > each.depth:
            found, depth = found + ")", depth - 1
        gap = "" if not found or found.endswith("(") else " " if each.text == "else" else "; "
        found += f"{gap}{each.text}: (" if each.is_condition else f"{gap}{each.text}"
        depth = each.depth + each.is_condition
    return (found + ")" * (depth - lowest)).replace(": ()", "")
