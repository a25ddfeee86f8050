"""A map as text for a terminal, and as Markdown."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from textwrap import wrap

from motionlang.kernel.lang import Unit
from motionlang.kernel.tools import count_of, ranges
from motionlang.views.terminal import printable, styled
from motionlang_explore.map.behaviour import HandlerRow, MachineBehaviour, StateRow, TransitionRow
from motionlang_explore.map.program_map import ProgramMap
from motionlang_explore.map.units import UNREACHED
from motionlang_explore.map.view import tables
from motionlang_explore.map.view.graph import mermaid
from motionlang_explore.map.view.timing import drawn

# So much of what happens in a transition is shown, or so much of its begin and its end.
MAX_ACTS, FIRST_ACTS, LAST_ACTS = 10, 5, 3
# So many lines of the cycle, of what to know, of one caution, and of what never ran are on the first screen.
MAX_CYCLE_ROWS, MAX_CAUTIONS, MAX_CAUTION, MAX_NEVER = 5, 9, 3, 1


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
            + ("" if exploration.is_whole else " and not to the end: --seconds 60 plays on"),
        ]
    return f"{made.source.name}: {', '.join(parts)}"


def render(made: ProgramMap, *, width: int, colour: bool = False, has_all: bool = False) -> str:
    """Return a map as text: one screen of what a maintainer asks first, or all of it."""
    found = [headline(made)]
    if made.behaviour is not None and not has_all:
        return "\n".join([*found, *_screen(made, made.behaviour, width, colour)]) + "\n"
    if made.behaviour is not None:
        found += ["", *_cycle(made, made.behaviour, width, colour), *_cautions(made.behaviour, width, colour)]
        found += ["", styled("States", "bold", colour)]
        for remark in made.behaviour.remarks:
            found += _wrapped(remark, "", width)
        if len(made.behaviour.states) == 1:
            found.append("the program waits for nothing around it")
        for state in made.behaviour.states:
            found += _state(state, width, colour)
        if made.behaviour.choices:
            found += ["", styled("Choices", "bold", colour)]
        for choice in made.behaviour.choices:
            text = f"{choice.instead}, waiting in {choice.state}: {_then(choice.then)}"
            found += _wrapped(text, "  ", width)
        found += _handlers(made.behaviour.handlers, width, colour)
        host = tables.host_numbers(made, made.behaviour)
        found += ["", *host.lines(width, colour=colour)] if host.rows else []
    for table in tables.of_text(made):
        found += ["", *table.lines(width, colour=colour)]
    return "\n".join(found) + "\n"


def cycle_line(behaviour: MachineBehaviour) -> str:
    """Return one line about the cycle of a machine."""
    run = behaviour.run
    rows = (each for each in behaviour.unreached if each.why == UNREACHED)
    unreached = {line for each in rows for line in range(each.first, each.last + 1)}
    missed = [line for line in behaviour.exploration.missed_moves if line not in unreached]
    lines = f"line{'s' if len(missed) > 1 else ''} {ranges(missed)}"
    others = f"; moves of {lines} were not played, so a good piece may take another cycle" if missed else ""
    fault = behaviour.exploration.fault_of(run)
    so_far = "" if behaviour.exploration.interrupted is None else " so far"
    bad = f"no good piece was found{so_far}; the best cycle {fault}: " if fault else ""
    if run.cycle is not None:
        then = f"; then the program ends: {_then(behaviour.ending)}" if behaviour.ending else ""
        return f"{bad}{run.cycle}{then}{others}"
    if not len(run.machine.log.moves):
        return f"none{so_far}: no axis moved{others}"
    return f"{bad}none; one run takes {run.time:.5g} s{others}"


def world_lines(behaviour: MachineBehaviour) -> Iterator[str]:
    """Yield the world of the cycle, in the form of a machine file."""
    for table, entries in behaviour.exploration.world.settings.items():
        assert isinstance(entries, list)
        given = Counter(", ".join(f"{key} = {value!r}" for key, value in each.items()) for each in entries)
        for entry, count in given.items():
            yield f"[[{table}]] {entry}{f'  ({count} times)' if count > 1 else ''}"


def _screen(made: ProgramMap, behaviour: MachineBehaviour, width: int, colour: bool) -> Iterator[str]:
    """Yield the cycle, what starts and stops it, alarms, and what never ran, so much that it fits a screen."""
    yield from ("", styled("Cycle", "bold", colour), *_wrapped(cycle_line(behaviour), "", width))
    table = tables.cycle(behaviour)
    yield from ["", *_first(table.lines(width, colour=colour), MAX_CYCLE_ROWS + 3)] if table.rows else []
    yield from _first(list(_cautions(behaviour, width, colour, MAX_CAUTION)), MAX_CAUTIONS + 2)
    never = tables.unreached(made)
    yield from ["", *_first(never.lines(width, colour=colour), MAX_NEVER + 3)]
    yield ""
    yield "--all shows all of this, the states, handlers, channels, axes, units and variables"


def _first(lines: Sequence[str], most: int) -> Iterator[str]:
    """Yield the first lines, and how many are left out."""
    yield from lines[:most]
    if len(lines) > most:
        yield f"… {count_of(len(lines) - most, 'line')} more"


def _cycle(made: ProgramMap, behaviour: MachineBehaviour, width: int, colour: bool) -> list[str]:
    """Return the cycle: its time, what happens in it, a picture, and the world in which it runs."""
    found = [styled("Cycle", "bold", colour), *_wrapped(cycle_line(behaviour), "", width)]
    table = tables.cycle(behaviour)
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


def _cautions(
    behaviour: MachineBehaviour, width: int, colour: bool, most: int | None = None
) -> Iterator[str]:
    """Yield what to know before the program is changed, so many lines of each."""
    if behaviour.cautions:
        yield from ("", styled("Before you change anything", "bold", colour))
    for each in behaviour.cautions:
        lines = _wrapped(f"{each.what} {each.why}", "  ", width - 2)
        yield from (
            lines if most is None or len(lines) <= most else [*lines[: most - 1], f"{lines[most - 1]} …"]
        )


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


def _handlers(rows: Sequence[HandlerRow], width: int, colour: bool) -> Iterator[str]:
    if rows:
        yield from ("", styled("Handlers", "bold", colour))
    for row in rows:
        then = f": {_then(row.then)}" if row.then else ""
        states = "; ".join(row.states)
        yield from _wrapped(f"{row.unit}: {row.start}, waiting in {states} → {row.to}{then}", "  ", width)


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


def line_text(made: ProgramMap, line: int, *, width: int, colour: bool = False) -> str:
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
    found += _handlers(handlers, width, colour)
    if len(found) == 1:
        found.append(f"  {_why_in_none(made, behaviour, line)}")
    return "\n".join(found) + "\n"


def _why_in_none(made: ProgramMap, behaviour: MachineBehaviour, line: int) -> str:
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
