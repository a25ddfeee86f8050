"""The run as a figure: position, velocity and acceleration over time.

Phases are shaded, and moves are labelled with their program lines. Long runs are drawn from their outline, which
preserves every peak.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from motionlang.commands.plot.path import path_figure
from motionlang.kernel import Run
from motionlang.kernel.log import GRAVE
from motionlang.kernel.report import events as events_of
from motionlang.kernel.report import moves as moves_of
from motionlang.kernel.servo import ServoTrace
from motionlang.views.figure import Band, Curve, Figure, Lane, MarkedTime, Panel, PanelLabel
from motionlang.views.formatting import dialect_name, outcome
from motionlang.views.lanes import ChannelLane as Channel
from motionlang.views.lanes import lanes
from motionlang.views.panels import panels
from motionlang.views.quantities import PHASES
from motionlang.views.terminal import printable
from motionlang.views.window import WHOLE, Window

Rows = Sequence[dict[str, Any]]

MAX_AXES, MAX_LANES, MAX_ANALOGUE = 8, 24, 4
# With more than these, shading is noise and labels overlap.
MAX_SHADED, MAX_NAMED, MAX_EVENTS = 60, 40, 12
# The height of a panel of several axes, relative to that of one; and of an analogue channel.
SEVERAL, ANALOGUE = 0.68, 66.0


def run_figure(
    run: Run, servos: Mapping[int, ServoTrace] = MappingProxyType({}), window: Window = WHOLE
) -> Figure:
    """Return the figure of a window of `run`, with as many axes and channels as fit.

    `servos` has the simulated motion of the motors, by axis. Raises ValueError if the window is empty.
    """
    if window.path is not None:
        return path_figure(run, window.path, window)
    trace, channels = run.trace, lanes(run.controller)
    moved, span = window.of(trace.axes), window.span(trace.end)
    chosen = moved[:MAX_AXES]
    unit, second = _time_unit(span[1] - span[0])
    moves = _visible_moves(run, span)
    by_axis = {axis: [row for row in moves if row["axis"] == axis] for axis in chosen}
    happened: list[dict[str, Any]] = list(events_of(run))
    events = [row for row in happened if row["kind"] in GRAVE and span[0] <= row["time"] <= span[1]]
    made: list[Panel] = []
    for axis in chosen:
        group = _of_axis(
            panels(trace, axis, servos.get(axis), span),
            by_axis[axis],
            [row for row in events if row.get("axis") == axis],
        )
        if len(chosen) > 1:
            group = [replace(panel, height=SEVERAL * panel.height) for panel in group]
            group[0] = replace(group[0], title=f"axis {axis}")
        made += group
    of_channels = _of_channels(channels, span[1])
    made += of_channels
    shown = [lane for panel in of_channels for lane in panel.lanes or panel.curves]
    hidden = len(moved) - len(chosen), len(channels) - len(shown)
    shaded = [row for rows in by_axis.values() if is_shaded(rows) for row in rows]
    names = {phase["name"] for row in shaded for phase in row["phases"]}
    limits = span[0] / second, (span[1] or 1.0) / second
    return Figure(
        [[replace(_scaled(panel, second), x_limits=limits)] for panel in made],
        x_label=f"time ({unit})",
        title=printable(run.source.name),
        subtitle=_subtitle(run, *hidden),
        legend=[(_darker(PHASES[name]), name) for name in PHASES if name in names],
    )


def _visible_moves(run: Run, span: tuple[float, float]) -> list[dict[str, Any]]:
    rows: list[dict[str, Any]] = list(moves_of(run))
    return [r for r in rows if r["start_time"] <= span[1] and r["start_time"] + r["duration"] >= span[0]]


def is_shaded(rows: Rows) -> bool:
    """True if the phases of these moves are long enough to be distinguished."""
    return 0 < sum(len(row["phases"]) for row in rows) <= MAX_SHADED


def _of_axis(group: Sequence[Panel], rows: Rows, events: Rows) -> list[Panel]:
    """Return the panels of an axis with its moves and its events; the first has their names."""
    bands = list(_bands(rows)) if is_shaded(rows) else []
    labels = [
        PanelLabel(row["start_time"], row["start_time"] + row["duration"], move_names(row)) for row in rows
    ] if len(rows) <= MAX_NAMED else []  # fmt: skip
    kinds: dict[float, list[str]] = {}
    for row in events[:MAX_EVENTS]:
        kinds.setdefault(row["time"], []).append(row["kind"])
    named = [MarkedTime(time, ", ".join(dict.fromkeys(each))) for time, each in kinds.items()]
    lines = [MarkedTime(time, "") for time in kinds]
    made = []
    for n, panel in enumerate(group):
        curves = panel.curves
        if len(rows) > MAX_SHADED:
            curves = [replace(curve, width=0.6, opacity=0.7) for curve in curves]
        made.append(
            replace(
                panel,
                curves=curves,
                bands=bands,
                labels=() if n else labels,
                events=lines if n else named,
            )
        )
    return made


def _bands(rows: Rows) -> list[Band]:
    made = []
    for row in rows:
        begin = row["start_time"]
        for phase in row["phases"]:
            end = begin + phase["duration"]
            made.append(Band(begin, end, PHASES.get(phase["name"], PHASES["hold"])))
            begin = end
    return made


def move_names(row: Mapping[str, Any]) -> tuple[str, str, str]:
    """Return the possible labels of a move, the longest first."""
    command, line = row["command"] or "move", row["line"]
    return f"{command} · line {line}", f"{command} {line}", str(line)


def _of_channels(channels: Sequence[Channel], end: float) -> list[Panel]:
    """Return a panel for each analogue channel and one for the digital ones."""
    made = [
        Panel(
            [Curve([*lane.times, end], [*lane.values, lane.values[-1]], "#3f6d9e", width=1.3, is_stepped=True)],
            label=lane.name,
            unit="%",
            height=ANALOGUE,
        )
        for lane in [lane for lane in channels if not lane.is_digital][:MAX_ANALOGUE]
    ]  # fmt: skip
    digital = [lane for lane in channels if lane.is_digital][:MAX_LANES]
    if digital:
        made.append(Panel(lanes=[Lane(lane.name, lane.spans(end)) for lane in digital]))
    return [replace(made[0], title="channels"), *made[1:]] if made else []


def _scaled(panel: Panel, second: float) -> Panel:
    """Return a panel over time in units of so many seconds."""
    if second == 1.0:
        return panel

    def spans(rows: Sequence[Any]) -> list[Any]:
        return [replace(each, begin=each.begin / second, end=each.end / second) for each in rows]

    return replace(
        panel,
        curves=[replace(curve, x=[x / second for x in curve.x]) for curve in panel.curves],
        bands=spans(panel.bands),
        labels=spans(panel.labels),
        events=[replace(event, x=event.x / second) for event in panel.events],
        lanes=[replace(e, spans=[(a / second, b / second) for a, b in e.spans]) for e in panel.lanes],
    )


def _subtitle(run: Run, hidden_axes: int, hidden_channels: int) -> str:
    what = f"{dialect_name(run.dialect.name)} · {outcome(run)}"
    if hidden_axes:
        what += f" · {hidden_axes} more axes moved but are not drawn"
    if hidden_channels:
        what += f" · {hidden_channels} more channels changed but are not drawn"
    return what


def _darker(colour: str) -> str:
    """Return a shade of `colour` that is strong enough for a small square on paper."""
    channels = (int(colour[i : i + 2], 16) for i in (1, 3, 5))
    return "#" + "".join(f"{int(255 - 2.6 * (255 - channel)):02x}" for channel in channels)


def _time_unit(end: float) -> tuple[str, float]:
    if end >= 3 * 3600.0:
        return "h", 3600.0
    return ("min", 60.0) if end >= 600.0 else ("s", 1.0)
