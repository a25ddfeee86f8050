"""The report as text: outcome, moves with phases, final axes, a small chart.

A small number of moves is shown phase by phase, a larger one with one line per move, and a very large one as totals
per program line.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterator
from math import fsum
from typing import Any

from motionlang.planners.total import exact_terms
from motionlang.report import axes as axes_of
from motionlang.report import device_writes as writes_of
from motionlang.report import events as events_of
from motionlang.report import moves as moves_of
from motionlang.result import Run
from motionlang.views.chart import velocity_chart
from motionlang.views.grid import Column, decimals_of, grid
from motionlang.views.terminal import printable, styled
from motionlang.views.words import clock_time, dialect_name, figure, outcome
from motionlang.views.written import written

Row = dict[str, Any]

# At most `WITH_PHASES` moves are shown with their phases. Of more than `MAX_ROWS`, only `SHOWN` are shown,
# with the totals.
WITH_PHASES, MAX_ROWS, SHOWN = 10, 40, 10
MAX_TOTALS = 30
# More figures of a line than this are reduced to a few with the same sum.
MAX_TERMS = 4096
# A chart of more moves than this is a solid block.
MAX_CHARTED, MAX_CHARTS = 200, 4

_MOVES = (
    Column("axis"),
    Column("command", align="<", style="word"),
    Column("line", drop=4),
    Column("profile", align="<", drop=1),
    Column("start", "s", drop=5),
    Column("time", "s"),
    Column("from", "uu", drop=6),
    Column("to", "uu", drop=3),
    Column("distance", "uu"),
    Column("peak", "uu/s"),
    Column("commanded", "uu/s", drop=7),
    Column("ended by", align="<", drop=2, style="warning"),
)
# The index of the column of the commanded speed, which is shown if a move did not reach it.
_COMMANDED_COLUMN = 10
# Of very many events, those of these kinds are left out first.
_USUAL = frozenset({"handler", "buffer full", "stop", "override"})
_EVENTS = (
    Column("time", "s"),
    Column("event", align="<", style="warning"),
    Column("axis"),
    Column("value", drop=3),
    Column("limit", drop=4),
    Column("line", drop=5),
    Column("motion of line", drop=2),
    Column("", align="<", drop=1),
)
_AXES = (
    Column("axis"),
    Column("position", "uu"),
    Column("counts", drop=2),
    Column("scale", "counts/uu", drop=1),
    Column("feedback", align="<", drop=3),
    Column("state", align="<"),
)
_MOTORS = (
    Column("axis"),
    Column("line", drop=1),
    Column("peak error", "uu"),
    Column("settled after", "s"),
    Column("RMS torque", "N m"),
    Column("peak output", "V", drop=2),
)
_TOTALS = (
    Column("line"),
    Column("command", align="<", style="word"),
    Column("axis"),
    Column("moves"),
    Column("in motion", align=">"),
    Column("of the run", drop=2),
    Column("each", "s", drop=1),
    Column("distance", "uu"),
    Column("peak", "uu/s"),
)


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
    events = _Events(events_of(run), everything)
    if events.count:
        sections.append(_happened(events, width, colour))
    if charts and moves.count:
        sections += _charts(run, moves, width, colour)
    if moves.motors:
        sections.append(_motors(moves.motors, width, colour, everything))
    axes = axes_of(run)
    if axes:
        sections.append(_axes(axes, width, colour))
    if writes := writes_of(run):
        sections.append(written(writes, width, colour))
    if run.quantities:
        sections.append([f"{name}: {_quantity(value)}" for name, value in run.quantities.items()])
    sections += [[f"{styled('note:', 'note', colour)} {printable(each)}"] for each in run.notes]
    return "\n\n".join("\n".join(section) for section in sections) + "\n"


def _quantity(value: float | str | bool | None) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    return "does not occur twice" if value is None else printable(str(value))


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
    count = {0: "no axis moved", 1: "1 move"}.get(moves, f"{_grouped(moves)} moves")
    name = styled(printable(run.source.name), "bold", colour)
    return [f"{name} · {dialect_name(run.dialect.name)} · {outcome(run)} · {count}"]


def _moves(moves: _Gathered, width: int, colour: bool, everything: bool) -> list[str]:
    """Return one line per move, and one per phase if there are few moves."""
    shown = moves.shown
    phased = everything or moves.count <= WITH_PHASES
    texts, styles = [], []
    form = _Form(shown, phased)
    for row in shown:
        texts.append(form.move(row))
        styles.append("")
        phases = row["phases"] if phased else []
        for k, phase in enumerate(phases):
            texts.append(form.phase(phase, k == len(phases) - 1))
            styles.append(phase["name"])
    columns: tuple[Column, ...] = _MOVES
    if not any(_is_short(row) for row in shown):
        columns = columns[:_COMMANDED_COLUMN] + columns[_COMMANDED_COLUMN + 1 :]
        texts = [[*cells[:_COMMANDED_COLUMN], *cells[_COMMANDED_COLUMN + 1 :]] for cells in texts]
    lines = grid(columns, texts, width=width, colour=colour, styles=styles)
    if len(shown) < moves.count:
        more = f"… and {_grouped(moves.count - len(shown))} more moves: --all shows all"
        lines.append(styled(more, "dim", colour))
    return lines


def _is_short(row: Row) -> bool:
    """True if a move did not reach the commanded speed."""
    return bool(row.get("commanded_speed", 0.0) > row["peak_speed"] * (1.0 + 1e-9))


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
    texts = [
        [
            figure(event["time"], 6),
            event["kind"],
            str(event.get("axis", "")),
            figure(event["value"]) if "value" in event else "",
            figure(event["limit"]) if "limit" in event else "",
            str(event["line"] or ""),
            str(event.get("commanded_by", "")),
            printable(event.get("text", "")),
        ]
        for event in events.shown
    ]
    lines = [styled("events", "bold", colour), *grid(_EVENTS, texts, width=width, colour=colour)]
    if len(events.shown) < events.count:
        named = ", ".join(f"{kind} {_grouped(count)}" for kind, count in sorted(events.counts.items()))
        lines.append(styled(f"total: {named}; --all shows all", "dim", colour))
    return lines


class _Form:
    """Formats moves and phases as cells of `_MOVES`, with decimals by column."""

    def __init__(self, rows: list[Row], phased: bool) -> None:
        phases = [phase for row in rows for phase in row["phases"]] if phased else []
        self.start = decimals_of([row["start_time"] for row in rows], 6)
        self.time = decimals_of([each["duration"] for each in (*rows, *phases)], 6)
        self.position_decimals = decimals_of([row[end] for row in rows for end in ("start", "end")])
        self.distance = decimals_of([each["distance"] for each in (*rows, *phases)])
        self.speed = decimals_of([row["peak_speed"] for row in rows])
        self.speed_decimals = decimals_of(
            [row["commanded_speed"] for row in rows if "commanded_speed" in row]
        )

    def move(self, row: Row) -> list[str]:
        return [
            str(row["axis"]),
            row["command"],
            str(row["line"] or ""),
            row["profile"],
            figure(row["start_time"], self.start),
            figure(row["duration"], self.time),
            figure(row["start"], self.position_decimals),
            figure(row["end"], self.position_decimals),
            figure(row["distance"], self.distance),
            figure(row["peak_speed"], self.speed),
            figure(row["commanded_speed"], self.speed_decimals) if "commanded_speed" in row else "",
            row.get("ended", "").replace("-", " "),
        ]

    def phase(self, phase: Row, last: bool) -> list[str]:
        name = f"{'└' if last else '├'} {phase['name']}"
        time, distance = figure(phase["duration"], self.time), figure(phase["distance"], self.distance)
        return ["", name, "", "", "", time, "", "", distance, "", "", ""]


def _totals(moves: _Gathered, time: float, width: int, colour: bool, everything: bool) -> list[str]:
    """Return the total motion of each program line, the busiest first."""
    busiest = sorted(moves.totals.items(), key=lambda item: (-fsum(item[1].durations), item[0]))
    most = len(busiest) if everything else MAX_TOTALS
    texts = [_total(key, group, time) for key, group in busiest[:most]]
    lines = grid(_TOTALS, texts, width=width, colour=colour)
    if len(busiest) > most:
        lines.append(styled(f"… and {_grouped(len(busiest) - most)} more", "dim", colour))
    return lines


def _total(key: tuple[int, str, int], group: _Total, time: float) -> list[str]:
    line, command, axis = key
    motion, distance, count = fsum(group.durations), fsum(group.distances), group.count
    return [
        str(line or ""),
        command,
        str(axis),
        _grouped(count),
        clock_time(motion),
        f"{motion / time:.1%}" if time else "",
        figure(motion / count),
        figure(distance, decimals_of([distance], 3)),
        figure(group.peak),
    ]


def _charts(run: Run, moves: _Gathered, width: int, colour: bool) -> list[list[str]]:
    charted = [axis for axis, count in sorted(moves.by_axis.items()) if count <= MAX_CHARTED][:MAX_CHARTS]
    sections = []
    for axis in charted:
        height = 6 if len(charted) == 1 else 4
        lines = velocity_chart(run.controller.axes[axis], run.time, width=width, height=height, colour=colour)
        if lines:
            sections.append([styled(f"velocity of axis {axis}, uu/s", "bold", colour), *lines])
    return sections


def _motors(rows: list[Row], width: int, colour: bool, everything: bool) -> list[str]:
    """Return the figures of simulated motors, one line per move.

    If there are many moves, those with the largest errors are shown.
    """
    worst = sorted(rows, key=lambda row: -row["motor"]["peak_following_error"])
    shown = rows if everything or len(rows) <= MAX_ROWS else worst[:SHOWN]
    error = decimals_of([row["motor"]["peak_following_error"] for row in shown])
    texts = [
        [
            str(row["axis"]),
            str(row["line"] or ""),
            figure(row["motor"]["peak_following_error"], error),
            "never" if row["motor"]["settle_time"] is None else figure(row["motor"]["settle_time"], 5),
            figure(row["motor"]["rms_torque"], 6),
            figure(row["motor"]["peak_output"], 4),
        ]
        for row in shown
    ]
    head = "motors" if shown is rows else f"motors, the {len(shown)} largest following errors"
    return [styled(head, "bold", colour), *grid(_MOTORS, texts, width=width, colour=colour)]


def _axes(axes: list[Row], width: int, colour: bool) -> list[str]:
    decimals = decimals_of([axis["position"] for axis in axes])
    counts = decimals_of([axis["counts"] for axis in axes], 2)
    scale = decimals_of([axis["scale"] for axis in axes])
    texts = [
        [
            str(axis["axis"]),
            figure(axis["position"], decimals),
            figure(axis["counts"], counts),
            figure(axis["scale"], scale),
            axis["feedback"],
            _state(axis),
        ]
        for axis in axes
    ]
    return grid(_AXES, texts, width=width, colour=colour)


def _state(axis: Row) -> str:
    state = "on" if axis["enabled"] else "off"
    return f"{state}, error {axis['error']}" if axis["error"] else state


def _grouped(count: int) -> str:
    """Format an integer in groups of three digits: 20 000."""
    return f"{count:,}".replace(",", " ")
