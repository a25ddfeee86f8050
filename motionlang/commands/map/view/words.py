"""Words for the states and transitions of a map."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from motionlang.commands.map.channels import DEVICES
from motionlang.commands.map.program_map import ProgramMap
from motionlang.commands.map.states import Action, Condition, State, Transition
from motionlang.kernel.lang import KINDS, READ

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
    if statement is not None:
        used = {(use.channel, use.number) for use in statement.channels if use.access == READ}
        used |= {(DEVICES[kind], str(n)) for kind, n in state.readings if kind in DEVICES}
        known = [each for each in made.channels if (each.kind, each.number) in used and each.kind != "answer"]
        is_level = not state.readings and statement.condition.endswith((" on", " off"))
        level = f" to be {statement.condition.rpartition(' ')[2]}" if is_level else ""
        found |= dict.fromkeys(f"{each.known_as}{level}" for each in known)
        axes = {n for kind, n in state.readings if KINDS[kind] == "axis" and n is not None}
        titles = {each.axis: each.title for each in made.axes}
        found |= dict.fromkeys(
            titles.get(axis, f"axis {axis}") for axis in sorted(axes.union(statement.what))
        )
    if state.cause == "operator":
        return "the operator"
    if state.cause == "task":
        found |= dict.fromkeys(_writers(made, state))
    return ", ".join(found) or CAUSES[state.cause]


def _writers(made: ProgramMap, state: State) -> Iterator[str]:
    """Yield the tasks and handlers that write a variable that a state reads."""
    lines = {line for each in made.variables if state.line in each.reads for line in each.writes}
    for diagram in made.diagrams.diagrams:
        actions = (each for transition in diagram.transitions for each in transition.path)
        written = {made.structure.line(each.at) for each in actions if isinstance(each, Action)}
        if lines & written and diagram.unit.kind in ("task", "event"):
            yield diagram.unit.title


def name_of(state: State) -> str:
    """Return a short name of a state: its line and its text."""
    if state.kind in ("start", "return", "end", "jump"):
        return {"start": "begin"}.get(state.kind, state.text)
    return f"{state.line} {state.text}"


def segments(transition: Transition) -> list[tuple[str, list[Action]]]:
    """Return the path of a transition as conditions, such as "if a > 1", and the actions that follow each of them.

    "" is no condition. A Case that holds says it alone, without the ones before it.
    """
    selected = {each.select for each in transition.path if isinstance(each, Condition) and each.holds}
    found: list[tuple[list[Condition], list[Action]]] = [([], [])]
    for each in transition.path:
        if isinstance(each, Action):
            found[-1][1].append(each)
        elif each.holds or each.select < 0 or each.select not in selected:
            if found[-1][1]:
                found.append(([], []))
            found[-1][0].append(each)
    return [(_when(conditions), actions) for conditions, actions in found]


def _when(conditions: Sequence[Condition]) -> str:
    first: dict[int, Condition] = {}
    found: list[Condition] = []
    for each in conditions:
        if each.holds or each.select < 0:
            found.append(each)
        elif each.select not in first:
            text = each.text.replace(" is ", " is not ", 1)
            found.append(Condition(each.at, text, True))
            first[each.select] = found[-1]
        else:
            first[each.select].text += f", {each.text.partition(' is ')[2]}"
    conditions = found
    if len(conditions) == 1 and not conditions[0].holds and not conditions[0].text.startswith("not ("):
        return f"unless {conditions[0].text}"
    return "if " + " and ".join(dict.fromkeys(map(str, conditions))) if conditions else ""


def when(transition: Transition) -> str:
    """Return the conditions that hold before the first action of a transition, such as "if a > 1"."""
    return segments(transition)[0][0]


def then(transition: Transition) -> str:
    """Return what follows these conditions, in the order of a run: "n = n + 1; if n = 3: Print n"."""
    (_, first), *more = segments(transition)
    parts = [does(first), *(f"{condition}: {does(actions)}".rstrip() for condition, actions in more)]
    return "; ".join(part for part in parts if part)


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
