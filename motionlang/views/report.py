"""The report as text: outcome, moves with phases, final axes, a small chart.

A small number of moves is shown phase by phase, a larger one with one line per move, and a very large one as totals
per program line.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterator, Sequence
from math import fsum
from typing import Any, cast

from motionlang.kernel import Run
from motionlang.kernel.report import axes as axes_of
from motionlang.kernel.report import device_writes as writes_of
from motionlang.kernel.report import events as events_of
from motionlang.kernel.report import moves as moves_of
from motionlang.kernel.tools import exact_terms
from motionlang.views.chart import velocity_chart
from motionlang.views.formatting import (
    clock_time,
    decimals_of,
    dialect_name,
    figure,
    formatter,
    grouped,
    line_number,
    outcome,
)
from motionlang.views.table import Column, Document, Table
from motionlang.views.terminal import printable, styled

Row = dict[str, Any]

# At most `WITH_PHASES` moves are shown with their phases. Of more than `MAX_ROWS`, only `SHOWN` are shown,
# with the totals.
WITH_PHASES, MAX_ROWS, SHOWN = 10, 40, 10
MAX_TOTALS = 30
# More figures of a line than this are reduced to a few with the same sum.
MAX_TERMS = 4096
# A chart of more moves than this is a solid block.
MAX_CHARTED, MAX_CHARTS = 200, 4
# More writes into other devices than this are only in the JSON report.
MAX_WRITES = 40

# Of very many events, those of these kinds are left out first.
_USUAL = frozenset({"handler", "buffer full", "stop", "override"})


def render(
    run: Run, *, width: int = 100, colour: bool = False, charts: bool = False, everything: bool = False
) -> str:
    """Return the whole report as text that ends with a newline.

    `charts` adds the velocity of the axes that moved; `everything` shows every move, phase and line.
    """
    moves = _Gathered(moves_of(run, None if everything else MAX_ROWS), everything)
    sections = [_head(run, moves.count, colour)]
    if moves.count:
        sections.append(_moves(moves, width, colour, everything))
    if moves.count > MAX_ROWS:
        sections.append(_totals(moves, run.time, width, colour, everything))
    if moves.count and (cycle := run.cycle) is not None:
        sections.append([f"cycle: {cycle}"])
    events = _Events(events_of(run), everything)
    if events.count:
        sections.append(_happened(events, width, colour))
    if charts and moves.count:
        sections += _charts(run, moves, width, colour)
    if moves.motors:
        sections.append(motors_table(moves.motors, everything).lines(width, colour=colour))
    axes = axes_of(run)
    if axes:
        sections.append(axes_table(axes).lines(width, colour=colour))
    if writes := writes_of(run):
        sections.append(writes_table(writes).lines(width, colour=colour))
    if run.quantities:
        sections.append([f"{name}: {_quantity(value)}" for name, value in run.quantities.items()])
    sections += [[f"{styled('note:', 'note', colour)} {printable(each)}"] for each in run.notes]
    return "\n\n".join("\n".join(section) for section in sections) + "\n"


def run_document(run: Run) -> Document:
    """Return the moves, events and axes of a run as data; the moves are read from the log one by one."""
    moves, events = cast("Sequence[Row]", moves_of(run)), cast("Sequence[Row]", events_of(run))
    tables = Table("moves", moves_table([]).columns, moves), Table("events", events_table([]).columns, events)
    return Document([*tables, axes_table(axes_of(run))])


def _quantity(value: float | str | bool | None) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    return "no value" if value is None else printable(str(value))


class _Total:
    """Totals of a program line: seconds and distances of its moves, and top speed."""

    def __init__(self) -> None:
        self.durations, self.distances, self.peak = array("d"), array("d"), 0.0
        self.count = 0

    def add(self, row: Row) -> None:
        self.count += 1
        self.durations.append(row["duration"])
        self.distances.append(abs(row["distance"]))
        self.peak = max(self.peak, row["peak_speed"])
        if len(self.durations) >= MAX_TERMS:
            self.durations = array("d", exact_terms(self.durations))
            self.distances = array("d", exact_terms(self.distances))


class _Gathered:
    """The data of the moves for the table.

    Only the rows to be shown are stored, because a run can have a million moves.
    """

    def __init__(self, rows: Iterator[Row], everything: bool) -> None:
        self.shown: list[Row] = []
        self.motors: list[Row] = []
        self.totals: dict[tuple[int, str, int], _Total] = {}
        for number, row in enumerate(rows):
            if everything or number < MAX_ROWS:
                self.shown.append(row)
            if "motor" in row:
                self.motors.append(row)
            key = row["line"], row["command"], row["axis"]
            total = self.totals.get(key)
            if total is None:
                total = self.totals[key] = _Total()
            total.add(row)
        self.count = 0
        self.by_axis: dict[int, int] = {}
        for (_, _, axis), total in self.totals.items():
            self.count += total.count
            self.by_axis[axis] = self.by_axis.get(axis, 0) + total.count
        if not everything and self.count > MAX_ROWS:
            del self.shown[SHOWN:]


def _head(run: Run, moves: int, colour: bool) -> list[str]:
    count = {0: "no axis moved", 1: "1 move"}.get(moves, f"{grouped(moves)} moves")
    name = styled(printable(run.source.name), "bold", colour)
    return [f"{name} · {dialect_name(run.dialect.name)} · {outcome(run)} · {count}"]


def _moves(moves: _Gathered, width: int, colour: bool, everything: bool) -> list[str]:
    """Return one line per move, and one per phase if there are few moves."""
    shown = moves.shown
    rows = with_phases(shown) if everything or moves.count <= WITH_PHASES else shown
    table = moves_table(rows)
    if len(shown) < moves.count:
        more = f"… and {grouped(moves.count - len(shown))} more moves: --all shows all"
        table.notes.append(more)
    return table.lines(width, colour=colour)


def with_phases(moves: Sequence[Row]) -> list[Row]:
    """Return moves with a row for each phase below them, whose mark and name are in the place of the command."""
    rows: list[Row] = []
    for move in moves:
        rows.append(move)
        last = len(move["phases"]) - 1
        rows += [
            {**phase, "phase": phase["name"], "command": f"{'└' if k == last else '├'} {phase['name']}"}
            for k, phase in enumerate(move["phases"])
        ]
    return rows


def moves_table(rows: Sequence[Row]) -> Table:
    """Return the table of moves; the commanded speed is only shown if a move did not reach it."""
    place = formatter(row[end] for row in rows for end in ("start", "end") if end in row)
    columns = (
        Column("axis"),
        Column("command", left=True, style="word"),
        Column("line", drop=4, text=line_number),
        Column("profile", left=True, drop=1),
        Column("start_time", "start", "s", decimals=6, drop=5),
        Column("duration", "time", "s", decimals=6),
        Column("start", "from", "uu", text=place, drop=6),
        Column("end", "to", "uu", text=place, drop=3),
        Column("distance", unit="uu", decimals=4),
        Column("peak_speed", "peak", "uu/s", decimals=4),
        Column(
            "commanded_speed", "commanded", "uu/s", decimals=4, drop=7, data=not any(map(_is_short, rows))
        ),
        Column("ended", "ended by", left=True, drop=2, style="warning", text=lambda by: by.replace("-", " ")),
    )
    return Table("moves", columns, rows, style=lambda row: row.get("phase", ""))


def _is_short(row: Row) -> bool:
    """True if a move did not reach the commanded speed."""
    return bool(row.get("commanded_speed", 0.0) > row.get("peak_speed", 0.0) * (1.0 + 1e-9))


class _Events:
    """The data of the events for the table.

    It has the first events, the first important ones, and the number of each kind.
    """

    def __init__(self, rows: Iterator[Row], everything: bool) -> None:
        self.counts: dict[str, int] = {}
        self.count = 0
        first: list[Row] = []
        serious: list[Row] = []
        for row in rows:
            self.count += 1
            self.counts[row["kind"]] = self.counts.get(row["kind"], 0) + 1
            if everything or len(first) < MAX_ROWS:
                first.append(row)
            if row["kind"] not in _USUAL and len(serious) < SHOWN:
                serious.append(row)
        whole = everything or self.count <= MAX_ROWS
        self.shown = first if whole else serious or first[:SHOWN]


def _happened(events: _Events, width: int, colour: bool) -> list[str]:
    """Return one line per event.

    If there are many, only the first important ones are shown, with the number of each kind.
    """
    table = events_table(events.shown)
    table.head = "events"
    if len(events.shown) < events.count:
        named = ", ".join(f"{kind} {grouped(count)}" for kind, count in sorted(events.counts.items()))
        table.notes.append(f"total: {named}; --all shows all")
    return table.lines(width, colour=colour)


def events_table(rows: Sequence[Row]) -> Table:
    columns = (
        Column("time", unit="s", text=lambda time: figure(time, 6)),
        Column("kind", "event", left=True, style="warning"),
        Column("axis"),
        Column("value", text=figure, drop=3),
        Column("limit", text=figure, drop=4),
        Column("line", drop=5, text=line_number),
        Column("commanded_by", "motion of line", drop=2),
        Column("count", "times", text=grouped, drop=1),
        Column("text", "", left=True, drop=1),
    )
    return Table("events", columns, rows)


def _totals(moves: _Gathered, time: float, width: int, colour: bool, everything: bool) -> list[str]:
    """Return the total motion of each program line, the busiest first."""
    busiest = sorted(moves.totals.items(), key=lambda item: (-fsum(item[1].durations), item[0]))
    most = len(busiest) if everything else MAX_TOTALS
    table = Table("totals", _TOTALS, [_total(*each, time) for each in busiest[:most]])
    if len(busiest) > most:
        table.notes.append(f"… and {grouped(len(busiest) - most)} more")
    return table.lines(width, colour=colour)


_TOTALS = (
    Column("line", text=line_number),
    Column("command", left=True, style="word"),
    Column("axis"),
    Column("moves", text=grouped),
    Column("motion", "in motion", text=clock_time),
    Column("share", "of the run", text="{:.1%}".format, drop=2),
    Column("each", unit="s", text=figure, drop=1),
    Column("distance", unit="uu", text=lambda distance: figure(distance, decimals_of([distance], 3))),
    Column("peak", unit="uu/s", text=figure),
)


def _total(key: tuple[int, str, int], group: _Total, time: float) -> Row:
    line, command, axis = key
    motion = fsum(group.durations)
    return {
        "line": line,
        "command": command,
        "axis": axis,
        "moves": group.count,
        "motion": motion,
        "share": motion / time if time else None,
        "each": motion / group.count,
        "distance": fsum(group.distances),
        "peak": group.peak,
    }


def _charts(run: Run, moves: _Gathered, width: int, colour: bool) -> list[list[str]]:
    charted = [axis for axis, count in sorted(moves.by_axis.items()) if count <= MAX_CHARTED][:MAX_CHARTS]
    sections = []
    for axis in charted:
        height = 6 if len(charted) == 1 else 4
        lines = velocity_chart(run.controller.axes[axis], run.time, width=width, height=height, colour=colour)
        if lines:
            sections.append([styled(f"velocity of axis {axis}, uu/s", "bold", colour), *lines])
    return sections


def motors_table(rows: Sequence[Row], everything: bool) -> Table:
    """Return the figures of simulated motors, one row per move.

    If there are many moves, those with the largest errors are shown.
    """
    worst = sorted(rows, key=lambda row: -row["motor"]["peak_following_error"])
    shown = rows if everything or len(rows) <= MAX_ROWS else worst[:SHOWN]
    head = "motors" if shown is rows else f"motors, the {len(shown)} largest following errors"
    return Table("motors", _MOTORS, [{**row["motor"], **row} for row in shown], head=head)


_MOTORS = (
    Column("axis"),
    Column("line", text=line_number, drop=1),
    Column("peak_following_error", "peak error", "uu", decimals=4),
    Column(
        "",
        "settled after",
        "s",
        get=lambda row: "never" if row["settle_time"] is None else figure(row["settle_time"], 5),
    ),
    Column("rms_torque", "RMS torque", "N m", text=lambda torque: figure(torque, 6)),
    Column("peak_output", unit="V", text=lambda output: figure(output, 4), drop=2),
)


def axes_table(rows: Sequence[Row]) -> Table:
    """Return the table of the axes at the end of a run."""
    columns = (
        Column("axis"),
        Column("position", data=True),
        Column(
            "", "position", "uu", get=lambda row: row.get("wrapped_position", row["position"]), decimals=4
        ),
        Column("counts", decimals=2, drop=2),
        Column("scale", unit="counts/uu", decimals=4, drop=1),
        Column("feedback", left=True, drop=3),
        Column("", "state", get=_state, left=True),
        Column("enabled", data=True),
        Column("error", data=True),
    )
    return Table("axes", columns, rows)


def _state(axis: Row) -> str:
    state = "on" if axis["enabled"] else "off"
    return f"{state}, error {axis['error']}" if axis["error"] else state


def writes_table(rows: Sequence[Row]) -> Table:
    """Return the table of what was written into other devices, the first rows of many."""
    columns = (
        Column("", "written to", get=_device, left=True, style="word"),
        Column("", get=_target, left=True),
        Column("value"),
    )
    table = Table("writes", columns, rows[:MAX_WRITES])
    if len(rows) > MAX_WRITES:
        table.notes.append(f"… and {len(rows) - MAX_WRITES} more: --format json has all")
    return table


def _device(row: Row) -> str:
    return f"Modbus server {row['server']}" if "server" in row else f"node {row['node']} of bus {row['bus']}"


def _target(row: Row) -> str:
    return f"{str(row['kind']).replace('-', ' ')} {row['number']}"
