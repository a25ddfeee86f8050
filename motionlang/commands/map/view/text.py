"""A map as text for a terminal, and as Markdown."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from math import inf
from textwrap import wrap

from motionlang.commands.map.behaviour import HandlerRow, MachineBehaviour, StateRow, TransitionRow
from motionlang.commands.map.program_map import ProgramMap
from motionlang.commands.map.view import tables
from motionlang.commands.map.view.graph import mermaid
from motionlang.commands.map.view.timing import drawn
from motionlang.kernel.lang import Unit
from motionlang.kernel.tools import count_of
from motionlang.views.terminal import printable, styled

# So much of what happens in a transition is shown, or so much of its begin and its end, and so much of the cycle.
# So many ways of states that are not in the cycle, and effects of handlers, each in so many states, are shown at first.
MAX_WAYS, MAX_HANDLERS, MAX_NAMES = 40, 10, 2
MAX_ACTS, FIRST_ACTS, LAST_ACTS, MAX_CYCLE_ROWS = 10, 5, 3, 40


def headline(made: ProgramMap) -> str:
    """Return one line about the size of a program."""
    parts = [
        made.language.title,
        count_of(len(made.channels), "channel"),
        count_of(len([each for each in made.axes if each.axis is not None]), "axis", "axes"),
        count_of(len(made.units), "unit"),
    ]
    if made.behaviour is not None:
        exploration = made.behaviour.exploration
        parts += [
            count_of(len(made.behaviour.states) - 1, "state"),
            f"played {count_of(exploration.trials, 'time')}"
            + ("" if exploration.is_whole else ", more states are possible"),
        ]
    return f"{made.source.name}: {', '.join(parts)}"


def render(made: ProgramMap, *, width: int, colour: bool = False, has_all: bool = False) -> str:
    """Return a map as text: the ways that matter, those of the cycle first, or all of them."""
    found = [headline(made)]
    if made.behaviour is not None:
        found += ["", *_cycle(made, made.behaviour, width, colour), *_cautions(made.behaviour, width, colour)]
        found += ["", styled("States", "bold", colour)]
        for remark in made.behaviour.remarks:
            found += _wrapped(remark, "", width)
        if len(made.behaviour.states) == 1:
            found.append("the program waits for nothing around it")
        found += _states(made.behaviour.states, width, colour, inf if has_all else MAX_WAYS)
        if made.behaviour.choices:
            found += ["", styled("Choices", "bold", colour)]
        for choice in made.behaviour.choices:
            text = f"{choice.instead}, waiting in {choice.state}: {_then(choice.then)}"
            found += _wrapped(text, "  ", width)
        found += _handlers(made.behaviour.handlers, width, colour, has_all)
        host = tables.host_numbers(made, made.behaviour)
        found += ["", *host.lines(width, colour=colour)] if host.rows else []
    for table in tables.of_text(made):
        found += ["", *table.lines(width, colour=colour)]
    return "\n".join(found) + "\n"


def cycle_line(behaviour: MachineBehaviour) -> str:
    """Return one line about the cycle of a machine."""
    run = behaviour.run
    if run.cycle is not None:
        then = f"; then the program ends: {_then(behaviour.ending)}" if behaviour.ending else ""
        return f"{run.cycle}{then}"
    if not len(run.machine.log.moves):
        return "none: no axis moved"
    return f"none; one run takes {run.time:.5g} s"


def world_lines(behaviour: MachineBehaviour) -> Iterator[str]:
    """Yield the world of the cycle, in the form of a machine file."""
    for table, entries in behaviour.exploration.world.settings.items():
        assert isinstance(entries, list)
        given = Counter(", ".join(f"{key} = {value!r}" for key, value in each.items()) for each in entries)
        for entry, count in given.items():
            yield f"[[{table}]] {entry}{f'  ({count} times)' if count > 1 else ''}"


def _cycle(made: ProgramMap, behaviour: MachineBehaviour, width: int, colour: bool) -> list[str]:
    """Return the cycle: its time, what happens in it, a picture, and the world in which it runs."""
    found = [styled("Cycle", "bold", colour), *_wrapped(cycle_line(behaviour), "", width)]
    table = tables.cycle(behaviour)
    left = len(table.rows) - MAX_CYCLE_ROWS
    if left > 0:
        table.rows = table.rows[:MAX_CYCLE_ROWS]
        table.notes.append(f"… and {left} more: -o FILE.html or FILE.json has all")
    found += ["", *table.lines(width, colour=colour)] if table.rows else []
    picture = list(drawn(made, width, colour))
    if picture:
        found += ["", *picture]
    world = list(world_lines(behaviour))
    if world:
        found += ["", "in this world, which motionlang init writes:"]
        for each in world:
            found += _wrapped(each, "  ", width)
    return found


def _cautions(behaviour: MachineBehaviour, width: int, colour: bool) -> Iterator[str]:
    """Yield what to know before the program is changed."""
    if behaviour.cautions:
        yield from ("", styled("Before you change anything", "bold", colour))
    for each in behaviour.cautions:
        yield from _wrapped(f"{each.what} {each.why}", "  ", width)


def _some(names: Sequence[str]) -> str:
    """Return names, of many the first ones and how many there are."""
    more = len(names) - MAX_NAMES
    return "; ".join(names if more < 2 else [*names[:MAX_NAMES], f"{more} more states"])


def _states(states: Sequence[StateRow], width: int, colour: bool, most: float) -> Iterator[str]:
    """Yield states with at most so many ways in all; those that are left out are counted."""
    ways = 0
    for number, state in enumerate(states):
        if number and ways + len(state.transitions) > most and not state.is_in_cycle:
            left = states[number:]
            count = sum(len(each.transitions) for each in left)
            yield ""
            yield f"… {count_of(count, 'way')} more in {count_of(len(left), 'state')}: --all shows them"
            return
        ways += len(state.transitions)
        yield from _state(state, width, colour)


def _state(state: StateRow, width: int, colour: bool) -> list[str]:
    if not state.statement and not state.transitions:
        return []
    if not state.statement:
        return [styled(state.name, "bold", colour), *_ways(state.transitions, width)]
    reads = f"   [{', '.join(state.reads)}]" if state.reads else ""
    name = state.name.removesuffix(f" ({state.statement})")
    head = _wrapped(f"waits in {name}: {state.statement}{reads}", "", width)
    return ["", *(styled(line, "bold", colour) for line in head), *_ways(state.transitions, width)]


def _ways(transitions: Sequence[TransitionRow], width: int) -> Iterator[str]:
    for each in transitions:
        then = f": {_then(each.then)}" if each.then else ""
        yield from _wrapped(f"{each.until} → {each.to}, {each.seconds:.2f} s{then}", "  ", width)


def _handlers(rows: Sequence[HandlerRow], width: int, colour: bool, has_all: bool) -> Iterator[str]:
    """Yield what handlers do, the first rows or all of them."""
    shown = rows[: None if has_all else MAX_HANDLERS]
    if shown:
        yield from ("", styled("Handlers", "bold", colour))
    for row in shown:
        then = f": {_then(row.then)}" if row.then else ""
        states = _some(list(row.states))
        yield from _wrapped(f"{row.unit}: {row.start}, waiting in {states} → {row.to}{then}", "  ", width)
    if len(rows) > len(shown):
        yield f"  … {len(rows) - len(shown)} more: --all shows them"


def _then(acts: Sequence[str]) -> str:
    """Return what happens; of a long list the begin, the end, and the last lines that are printed."""
    if len(acts) <= MAX_ACTS:
        return "; ".join(acts)
    printed = [k for k, each in enumerate(acts) if each.startswith(("'", '"'))]
    shown = sorted({*range(FIRST_ACTS), *printed[-LAST_ACTS:], *range(len(acts) - LAST_ACTS, len(acts))})
    found = []
    for before, k in pairwise((-1, *shown)):
        found += [f"… {k - before - 1} more …"] if k > before + 1 else []
        found.append(acts[k])
    return "; ".join(found)


def _wrapped(text: str, indent: str, width: int) -> list[str]:
    return wrap(
        printable(text), min(width, 120), initial_indent=indent, subsequent_indent=indent + "    ",
        break_long_words=False, break_on_hyphens=False,
    )  # fmt: skip


def line_text(made: ProgramMap, line: int, *, width: int, colour: bool = False, has_all: bool = False) -> str:
    """Return the states and the ways in which a line runs, or why it never ran."""
    source, behaviour = made.source, made.behaviour
    assert behaviour is not None
    text = source.line(line).strip() if line <= source.text.count("\n") + 1 else ""
    found = [styled(f"line {line}: {printable(text)}".removesuffix(": "), "bold", colour)]
    for state in behaviour.states:
        ways = [each for each in state.transitions if line in (*each.lines, *state.lines)]
        found += (
            _state(replace(state, transitions=ways), width, colour) if ways or line in state.lines else []
        )
    handlers = [each for each in behaviour.handlers if line in each.lines]
    found += _handlers(handlers, width, colour, has_all)
    if len(found) == 1:
        found.append(f"  {_why_in_none(made, behaviour, line)}")
    return "\n".join(found) + "\n"


def _why_in_none(made: ProgramMap, behaviour: MachineBehaviour, line: int) -> str:
    """Return why a line is in none of the states and ways."""
    never = next((each for each in behaviour.unreached if each.first <= line <= each.last), None)
    if never is not None and never.why:
        return f"never ran: {never.why}"
    if not any(each.line == line and not each.is_silent for each in made.structure.statements.values()):
        return "has no statement of its own"
    if line in behaviour.exploration.missed:
        return "never ran in what was played"
    return "ran in what was played, but in none of the states and ways"


def unit_text(made: ProgramMap, unit: Unit, *, width: int, colour: bool = False) -> str:
    """Return the statements of one unit, with what each waits for."""
    return "\n".join(tables.statements(made, unit).lines(width, colour=colour)) + "\n"


def markdown(made: ProgramMap) -> str:
    """Return a map as Markdown, with a diagram that GitHub and others draw."""
    found = [f"# {made.source.name}", "", headline(made)]
    behaviour = made.behaviour
    if behaviour is not None:
        found += ["", "## Cycle", "", cycle_line(behaviour), "", *tables.cycle(behaviour).markdown()]
        found += ["", "## States", "", "```mermaid", *mermaid(behaviour), "```"]
        found += (
            ["", *(f"Unless said otherwise, {each}" for each in behaviour.remarks)]
            if behaviour.remarks
            else []
        )
        more = (tables.transitions, tables.choices, tables.handlers, tables.cautions)
        for table in (*(each(behaviour) for each in more), tables.host_numbers(made, behaviour)):
            found += ["", f"### {table.head}", "", *(table.markdown() if table.rows else [table.empty])]
    for table in tables.of_text(made):
        found += ["", f"## {table.head}", "", *(table.markdown() if table.rows else [table.empty])]
    return "\n".join(found) + "\n"
