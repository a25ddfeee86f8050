"""The tables of a map: one view of each list, for text, JSON, Markdown and HTML."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from motionlang.commands.map.axes import TITLES, AxisFact, AxisMap
from motionlang.commands.map.channels import lines
from motionlang.commands.map.program_map import ProgramMap
from motionlang.commands.map.states import Transition
from motionlang.commands.map.view.words import does, name_of, then, waits_for, when
from motionlang.views.table import Column, Table


@dataclass(eq=False, slots=True)
class AxisRow:
    """A fact of an axis as a row; the first one of an axis has its title."""

    axis: AxisMap
    fact: AxisFact

    @property
    def title(self) -> str:
        return self.axis.title if self.fact is self.axis.facts[0] else ""


@dataclass(eq=False, slots=True)
class TransitionRow:
    """A transition as a row, with its unit."""

    unit: str
    transition: Transition


def tables(made: ProgramMap) -> list[Table]:
    """Return all tables of a map, the most asked for first."""
    return [
        channels(made),
        axes(made),
        units(made),
        variables(made),
        states(made),
        transitions(made),
        unreached(made),
    ]


def channels(made: ProgramMap) -> Table:
    """Return the table of inputs, outputs and other devices."""
    columns = [
        Column("channel", get=lambda row: row.title, left=True),
        Column("name", get=lambda row: row.name, left=True),
        Column("kind", data=True),
        Column("number", data=True),
        Column("direction", "use", left=True, drop=3),
        _lines("waits", "waited for"),
        _lines("reads", "read"),
        _lines("writes", "written"),
        Column("values", "values", text=", ".join, left=True, drop=4),
        _lines("set_up", "assigned"),
        Column("starts", text="; ".join, left=True),
        Column("named_by", data=True),
    ]
    return Table("channels", columns, made.channels, empty="no inputs or outputs", head="Inputs and outputs")


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
        Column("lines", get=lambda row: row.fact.lines, text=lines, left=True),
    ]
    return Table("axes", columns, rows, empty="no axes", head="Axes")


def units(made: ProgramMap) -> Table:
    """Return the table of the program, its subs, tasks, handlers and macros."""
    columns = [
        Column("unit", get=lambda row: row.title, left=True),
        Column("line", text=lambda line: str(line) if line else ""),
        Column("called_by", "called by", text=_titles, left=True),
        Column("started_by", "started by", text=_titles, left=True, drop=1),
        Column("calls", text=_titles, left=True, drop=2),
        Column("starts", text=_titles, left=True, drop=2),
        Column("meaning", left=True, drop=1),
        Column("is_reached", "", text=lambda is_reached: "" if is_reached else "never reached", left=True),
    ]
    return Table("units", columns, made.units, head="Structure")


def variables(made: ProgramMap) -> Table:
    """Return the table of variables, constants and registers."""
    columns = [
        Column("name", left=True),
        Column("meaning", left=True, drop=1),
        Column("kind", left=True),
        Column("home", "of", left=True, drop=2),
        Column("value", left=True, drop=1),
        _lines("writes", "written"),
        _lines("reads", "read"),
        Column("is_used", "", text=lambda is_used: "" if is_used else "unused", left=True, drop=1),
        Column("is_retained", "", text=lambda is_retained: "non-volatile" if is_retained else "", left=True),
    ]
    return Table("variables", columns, made.variables, empty="no variables", head="Variables")


def states(made: ProgramMap) -> Table:
    """Return the table of all states."""
    rows = [(diagram.unit.title, state) for diagram in made.diagrams.diagrams for state in diagram.states]
    columns = [
        Column("id", get=lambda row: row[1].id, data=True),
        Column("unit", get=lambda row: row[0], left=True),
        Column("line", get=lambda row: row[1].line or None),
        Column("kind", get=lambda row: row[1].kind, left=True),
        Column("text", "state", get=lambda row: row[1].text, left=True),
        Column("cause", get=lambda row: row[1].cause, data=True),
        Column("waits_for", "waits for", get=lambda row: waits_for(made, row[1]), left=True),
        Column("meanwhile", get=lambda row: does(row[1].meanwhile), left=True, drop=1),
    ]
    return Table("states", columns, rows, head="States")


def transitions(made: ProgramMap) -> Table:
    """Return the table of all transitions; those that a run took have a count and times."""
    rows = [
        TransitionRow(diagram.unit.title, each)
        for diagram in made.diagrams.diagrams
        for each in diagram.transitions
    ]

    def taken(row: TransitionRow, name: str) -> Any:
        found = made.taken(row.transition)
        return None if found is None else getattr(found, name)

    columns = [
        Column("unit", get=lambda row: row.unit, left=True),
        Column("source", get=lambda row: row.transition.source.id, data=True),
        Column("target", get=lambda row: row.transition.target.id, data=True),
        Column("from", get=lambda row: name_of(row.transition.source), left=True),
        Column("to", get=lambda row: name_of(row.transition.target), left=True),
        Column("when", get=lambda row: when(row.transition), left=True),
        Column("does", get=lambda row: then(row.transition), left=True),
    ]
    if made.observed is not None:
        columns += [
            Column("count", "taken", get=lambda row: taken(row, "count")),
            Column("first", unit="s", get=lambda row: taken(row, "first"), decimals=3),
            Column("shortest", unit="s", get=lambda row: taken(row, "shortest"), decimals=3),
            Column("longest", unit="s", get=lambda row: taken(row, "longest"), decimals=3),
        ]
    return Table("transitions", columns, rows, head="Transitions")


def unreached(made: ProgramMap) -> Table:
    """Return the table of lines that nothing reaches."""
    rows = [
        {"first": first, "last": last, "text": made.source.line(first).strip()}
        for first, last in made.unreached
    ]
    columns = [Column("first", "from line"), Column("last", "to line"), Column("text", left=True)]
    return Table("never_reached", columns, rows, empty="every statement can be reached", head="Never reached")


def _lines(key: str, title: str) -> Column:
    return Column(key, title, text=lines, left=True, drop=5 if key == "set_up" else 0)


def _computed(is_computed: bool) -> str:
    return "computed" if is_computed else ""


def _titles(units: Mapping[str, list[int]]) -> str:
    return "; ".join(f"{title} ({lines(at)})" if at else title for title, at in units.items())
