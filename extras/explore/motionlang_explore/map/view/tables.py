"""The tables of a map: one view of each list, for text, JSON, Markdown and HTML."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from motionlang.commands.channels import DEVICES, Channel, polled
from motionlang.kernel.lang import HOST_CHANNELS, KINDS, READ, Statement, Unit
from motionlang.kernel.tools import ranges
from motionlang.views.table import Column, Table
from motionlang_explore.map.axes import TITLES, AxisFact, AxisMap
from motionlang_explore.map.behaviour import CAUSES, MachineBehaviour, StateRow, TransitionRow
from motionlang_explore.map.program_map import ProgramMap

# More states than this that write or read a number of a host are only counted in a text.
MAX_STATES = 2


@dataclass(eq=False, slots=True)
class HostRow:
    """A number of a host: the lines that write and read it, what is written, and the states in which these run."""

    channel: Channel
    written_in: list[str]
    read_in: list[str]


@dataclass(eq=False, slots=True)
class AxisRow:
    """A fact of an axis as a row; the first one of an axis has its title."""

    axis: AxisMap
    fact: AxisFact

    @property
    def title(self) -> str:
        return self.axis.title if self.fact is self.axis.facts[0] else ""


def tables(made: ProgramMap) -> list[Table]:
    """Return all tables of a map, the channels first."""
    found = of_text(made)
    if made.behaviour is not None:
        found += [cycle(made.behaviour), states(made.behaviour), transitions(made.behaviour)]
        found += [choices(made.behaviour), handlers(made.behaviour), cautions(made.behaviour)]
        found.append(host_numbers(made, made.behaviour))
    return found


def of_text(made: ProgramMap) -> list[Table]:
    """Return the tables of what the text says, the most asked for first."""
    return [channels(made), axes(made), units(made), variables(made), unreached(made)]


def channels(made: ProgramMap) -> Table:
    """Return the table of inputs, outputs and other devices."""
    columns = [
        Column("channel", get=lambda row: row.title, left=True),
        Column("name", get=lambda row: row.name, left=True),
        Column("kind", data=True),
        Column("number", data=True),
        Column("direction", "use", left=True),
        _lines("waits", "waited for"),
        _lines("reads", "read"),
        _lines("writes", "written"),
        Column("values", "values", text=", ".join, left=True, drop=4),
        Column("decides", get=lambda row: list(row.decides), text="; ".join, left=True, drop=6),
        _lines("set_up", "assigned"),
        Column("starts", text="; ".join, left=True, drop=2),
        Column("is_used", "", text=lambda is_used: "" if is_used else "never used", left=True, drop=1),
        Column("named_by", data=True),
    ]
    return Table(
        "channels",
        columns,
        made.channels,
        empty="no inputs or outputs",
        head="Inputs and outputs",
        folds=True,
    )


def axes(made: ProgramMap) -> Table:
    """Return the table of what the program does to its axes."""
    rows = [AxisRow(axis, fact) for axis in made.axes for fact in axis.facts]
    columns = [
        Column("", "axis", get=lambda row: row.title, left=True),
        Column("axis", get=lambda row: row.axis.axis, data=True),
        Column("name", get=lambda row: row.axis.name, data=True),
        Column("topic", "what", get=lambda row: TITLES[row.fact.topic], left=True),
        Column("statement", get=lambda row: row.fact.text, left=True),
        Column("keyword", get=lambda row: row.fact.keyword, data=True),
        Column("value", get=lambda row: row.fact.value, data=True),
        Column("computed", "", get=lambda row: row.fact.is_computed, text=_computed, left=True, drop=2),
        Column("lines", get=lambda row: row.fact.lines, text=ranges, left=True),
    ]
    return Table("axes", columns, rows, empty="no axes", head="Axes", folds=True)


def units(made: ProgramMap) -> Table:
    """Return the table of the program, its subs, tasks, handlers and macros."""
    columns = [
        Column("unit", get=lambda row: row.title, left=True),
        Column("line", text=lambda line: str(line) if line else ""),
        Column("called_by", "called by", text=_titles, left=True, drop=1),
        Column("started_by", "started by", text=_titles, left=True, drop=1),
        Column("calls", text=_titles, left=True, drop=2),
        Column("starts", text=_titles, left=True, drop=2),
        Column("meaning", left=True, drop=1),
        Column("is_reached", "", text=lambda is_reached: "" if is_reached else "never reached", left=True),
    ]
    return Table("units", columns, made.units, head="Structure", folds=True)


def variables(made: ProgramMap) -> Table:
    """Return the table of variables, constants and registers."""
    columns = [
        Column("name", left=True),
        Column("meaning", left=True, drop=1),
        Column("kind", left=True),
        Column("home", "of", left=True, drop=2),
        Column("value", left=True, drop=1),
        _lines("writes", "written"),
        Column("given", "set to", text=_given, left=True, drop=3),
        _lines("reads", "read"),
        Column("decides", text="; ".join, left=True, drop=4),
        Column("is_used", "", text=lambda is_used: "" if is_used else "unused", left=True, drop=1),
        Column("is_retained", "", text=lambda is_retained: "non-volatile" if is_retained else "", left=True),
    ]
    return Table("variables", columns, made.variables, empty="no variables", head="Variables", folds=True)


def cycle(behaviour: MachineBehaviour) -> Table:
    """Return the table of what happens in one cycle."""
    columns = [
        Column("time", "at", unit="s", text="{:.3f}".format),
        Column("line", text=lambda line: str(line) if line else ""),
        Column("what", left=True),
        Column("seconds", "takes", unit="s", decimals=3),
    ]
    return Table("cycle", columns, behaviour.cycle_rows)


def cautions(behaviour: MachineBehaviour) -> Table:
    """Return the table of what to know before the program is changed."""
    columns = [Column("kind", data=True), Column("what", "", left=True), Column("why", "", left=True)]
    return Table(
        "cautions", columns, behaviour.cautions, empty="nothing was seen", head="Before you change anything"
    )


def states(behaviour: MachineBehaviour) -> Table:
    columns = [
        Column("name", "state", left=True),
        Column("statement", left=True),
        Column("reads", left=True, text=", ".join),
    ]
    return Table("states", columns, behaviour.states, head="States")


def transitions(behaviour: MachineBehaviour) -> Table:
    rows = [(state, way) for state in behaviour.states for way in state.transitions]

    def name(row: tuple[StateRow, TransitionRow]) -> str:
        statement = row[0].statement
        return f"{row[0].name.removesuffix(f' ({statement})')}: {statement}".removesuffix(": ")

    columns = [
        Column("state", get=lambda row: row[0].name, data=True),
        Column(
            "waits_in",
            "waits in",
            get=lambda row: name(row) if row[1] is row[0].transitions[0] else "",
            left=True,
        ),
        Column("until", get=lambda row: row[1].until, left=True),
        Column("seconds", "takes", unit="s", get=lambda row: row[1].seconds, text="{:.2f}".format),
        Column("to", "goes on in", get=lambda row: row[1].to, left=True),
        Column("then", get=lambda row: list(row[1].then), text="; ".join, left=True),
    ]
    return Table("transitions", columns, rows, head="Transitions")


def handlers(behaviour: MachineBehaviour) -> Table:
    """Return the table of what handlers do."""
    columns = [
        Column("unit", "handler", left=True),
        Column("start", "started by", left=True),
        Column("states", "waiting in", get=lambda row: list(row.states), text=", ".join, left=True),
        Column("to", "goes on in", left=True),
        Column("then", text="; ".join, left=True),
    ]
    return Table("handlers", columns, behaviour.handlers, empty="no handler was started", head="Handlers")


def host_numbers(made: ProgramMap, behaviour: MachineBehaviour) -> Table:
    """Return the table of the numbers that a host and the program leave for each other."""
    known = [each for each in made.channels if each.kind in HOST_CHANNELS]
    rows = [
        HostRow(each, _states_of(behaviour, each.writes), _states_of(behaviour, [*each.reads, *each.waits]))
        for each in known
    ]
    columns = [
        Column("channel", get=lambda row: row.channel.known_as, left=True),
        Column("writes", "written", get=lambda row: row.channel.writes, text=ranges, left=True),
        Column("values", "what", get=lambda row: row.channel.values, text=", ".join, left=True),
        Column("written_in", "in", text=_first_states, left=True),
        Column(
            "reads",
            "read",
            get=lambda row: sorted({*row.channel.reads, *row.channel.waits}),
            text=ranges,
            left=True,
        ),
        Column("read_in", "in", text=_first_states, left=True),
    ]
    return Table(
        "host_numbers", columns, rows, empty="no numbers of a host", head="Numbers of a host", folds=True
    )


def _states_of(behaviour: MachineBehaviour, lines: Sequence[int]) -> list[str]:
    """Return the states that wait in some lines, or behind which these run."""
    at = set(lines)
    return [
        each.name
        for each in behaviour.states
        if at & each.lines or any(at & way.lines for way in each.transitions)
    ]


def _first_states(names: Sequence[str]) -> str:
    return "; ".join(names) if len(names) <= MAX_STATES else f"{len(names)} states"


def choices(behaviour: MachineBehaviour) -> Table:
    """Return the table of what happens with other keys, answers and numbers of a host in the cycle."""
    columns = [
        Column("instead", "with", left=True),
        Column("state", "waiting in", left=True),
        Column("then", text="; ".join, left=True),
    ]
    return Table("choices", columns, behaviour.choices, empty="no choice moves another line", head="Choices")


def unreached(made: ProgramMap) -> Table:
    """Return the table of lines that nothing reaches, or that no trial has carried out."""
    if made.behaviour is not None:
        rows, empty = made.behaviour.unreached, "every statement ran"
    else:
        rows = list(made.unreached)
        empty = "every statement can be reached"
    columns = [
        Column("first", "from line"),
        Column("last", "to line"),
        Column("text", left=True),
        Column("why", left=True),
    ]
    return Table("never_reached", columns, rows, empty=empty, head="Never played")


def statements(made: ProgramMap, unit: Unit) -> Table:
    """Return the table of the statements of a unit, and what a task waits for at each."""
    in_loops = polled(made.structure)
    rows = [
        (each, _waits_for(made, each, in_loops.get(each.line, set()))) for each in _statements_of(made, unit)
    ]
    columns = [
        Column("line", get=lambda row: row[0].line),
        Column("statement", get=lambda row: row[0].text, left=True),
        Column("waits_for", "waits for", get=lambda row: row[1], left=True),
    ]
    at = f", line {unit.line}" if unit.line else ""
    meaning = next((each.meaning for each in made.units if each.title == unit.title), "")
    head = f"{unit.title}{at}{f': {meaning}' if meaning else ''}"
    return Table("statements", columns, rows, empty="no statements", head=head)


def _statements_of(made: ProgramMap, unit: Unit) -> list[Statement]:
    """Return the statements that a unit carries out itself, in the order of the text."""
    points, others = made.structure.points, {each.entry for each in made.structure.units} - {unit.entry}
    seen, stack = set[int](), [unit.entry]
    while stack:
        p = stack.pop()
        if p not in seen and p not in others:
            seen.add(p)
            stack += points[p].next
    ats = sorted({points[p].at for p in seen})
    found = (made.structure.statements.get(at) for at in ats)
    return [each for each in found if each is not None and not each.is_silent]


def _waits_for(made: ProgramMap, statement: Statement, readings: set[tuple[str, int | None]]) -> str:
    """Return what a task waits for at a statement, with the names of channels and axes; "" if it does not wait."""
    cause, is_polled = statement.waits, False
    used = {(use.channel, use.number) for use in statement.channels if use.access == READ}
    read = {(DEVICES[kind], str(n)) for kind, n in readings if kind in DEVICES}
    if not cause:
        is_polled = bool(used & read)
        cause = next((KINDS[kind] for kind, n in sorted(readings, key=str) if kind in DEVICES), "")
    if not cause or not (statement.waits or is_polled):
        return ""
    if cause == "operator":
        return "the operator"
    known = [
        each.known_as for each in made.channels if (each.kind, each.number) in used and each.kind != "answer"
    ]
    titles = {each.axis: each.title for each in made.axes}
    known += [titles.get(axis, f"axis {axis}") for axis in sorted(statement.what)]
    return ", ".join(dict.fromkeys(known)) or CAUSES[cause]


def _lines(key: str, title: str) -> Column:
    return Column(key, title, text=ranges, left=True, drop=5 if key == "set_up" else 0)


def _given(values: Mapping[str, list[int]]) -> str:
    return ", ".join(f"{value} ({ranges(lines)})" for value, lines in values.items())


def _computed(is_computed: bool) -> str:
    return "computed" if is_computed else ""


def _titles(units: Mapping[str, list[int]]) -> str:
    return "; ".join(f"{title} ({ranges(at)})" if at else title for title, at in units.items())
