"""The run as a picture: position, velocity and acceleration over time.

Phases are shaded, and moves are labelled with their program lines. matplotlib draws it without pyplot and without a
display. The same run gives the same bytes: there are no dates and no random names. Long runs are drawn from
their outline, which preserves every peak.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping, Sequence
from math import fsum
from types import MappingProxyType
from typing import IO, TYPE_CHECKING, Any

from motionlang import __version__
from motionlang.errors import need
from motionlang.files import replacing
from motionlang.log.records import GRAVE
from motionlang.report import events as events_of
from motionlang.report import moves as moves_of
from motionlang.result import Run
from motionlang.servo.trace import ServoTrace
from motionlang.views.lanes import lanes
from motionlang.views.panels import HEIGHTS, panels
from motionlang.views.path_plot import path_figure
from motionlang.views.plot_panel import (
    FAINT,
    INK,
    PHASES,
    draw_analogue,
    draw_lanes,
    draw_panel,
    is_shaded,
    mark_events,
    name_moves,
)
from motionlang.views.terminal import printable
from motionlang.views.window import WHOLE, Window
from motionlang.views.words import dialect_name, outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MAX_AXES, MAX_LANES, MAX_ANALOGUE = 8, 24, 4
# In inches: the width of the picture; the heights of a panel of one axis, of several axes and of a lane; the
# margins above and below, and the gap between groups of panels.
WIDTH, DPI = 11.0, 120
PANEL, LANE = (1.9, 1.3), 0.26
TOP, BOTTOM, BETWEEN, WITHIN = (0.95, 1.12), 0.5, 0.6, 0.24
LEFT, RIGHT = 0.095, 0.985
# "Any", because every release of matplotlib types its keys differently.
STYLE: Any = {
    "font.family": "DejaVu Sans",
    "font.size": 9.0,
    "text.color": INK,
    "axes.edgecolor": "#b8c2cc",
    "axes.labelcolor": INK,
    "axes.linewidth": 0.8,
    "xtick.color": FAINT,
    "ytick.color": FAINT,
    "svg.hashsalt": "motionlang",
    "svg.fonttype": "path",
    "path.simplify": True,
}


def write_plot(
    run: Run, path: str, servos: Mapping[int, ServoTrace] = MappingProxyType({}), window: Window = WHOLE
) -> None:
    """Draw a window of `run` into a .png or .svg file.

    `servos` has the simulated motion of the motors, by axis. Raises OSError, MissingExtra without matplotlib,
    and ValueError if the window is empty.
    """

    need("a picture", "matplotlib")
    from matplotlib import rc_context

    kind = os.path.splitext(path)[1].lower()[1:]
    with rc_context(STYLE), replacing(path) as file, warnings.catch_warnings():
        warnings.simplefilter("ignore")  # a letter that the font lacks is drawn as a box
        if window.path is None:
            figure = _figure(run, servos, window)
        else:
            figure = path_figure(run, window.path, window)
        _save(figure, file, kind)


def _save(figure: Figure, file: IO[bytes], kind: str) -> None:
    creator = f"motionlang {__version__}"
    metadata = {"Creator": creator, "Date": None} if kind == "svg" else {"Software": creator}
    figure.savefig(file, format=kind, dpi=DPI, metadata=metadata)


class _Picture:
    """The content of a picture: as many axes and channels of the run as fit."""

    def __init__(self, run: Run, servos: Mapping[int, ServoTrace], window: Window) -> None:
        trace, channels = run.trace, lanes(run.controller)
        chosen = window.of(trace.axes)
        self.span = begin, end = window.span(trace.end)
        moves: list[dict[str, Any]] = list(moves_of(run))
        rows = [
            row for row in moves if row["start_time"] <= end and row["start_time"] + row["duration"] >= begin
        ]
        self.axes = chosen[:MAX_AXES]
        happened: list[dict[str, Any]] = list(events_of(run))
        self.events = [row for row in happened if row["kind"] in GRAVE and begin <= row["time"] <= end]
        self.moves = {axis: [row for row in rows if row["axis"] == axis] for axis in self.axes}
        self.panels = {axis: panels(trace, axis, servos.get(axis), self.span) for axis in self.axes}
        self.digital = [lane for lane in channels if lane.is_digital][:MAX_LANES]
        self.analogue = [lane for lane in channels if not lane.is_digital][:MAX_ANALOGUE]
        self.hidden_axes = len(chosen) - len(self.axes)
        self.hidden_channels = len(channels) - len(self.digital) - len(self.analogue)

    @property
    def heights(self) -> list[list[float]]:
        """The heights of all panels in inches: one group per axis, and the channels."""
        high = PANEL[len(self.axes) > 1]
        groups = [[high * HEIGHTS[panel.quantity] for panel in self.panels[axis]] for axis in self.axes]
        channels = [0.5 * high] * len(self.analogue)
        if self.digital:
            channels.append(LANE * len(self.digital) + 0.1)
        return [*groups, channels] if channels else groups


def _figure(run: Run, servos: Mapping[int, ServoTrace], window: Window) -> Figure:
    picture = _Picture(run, servos, window)
    several = len(picture.axes) > 1
    figure, groups = _layout(picture.heights, TOP[several])
    begin, end = picture.span
    unit, second = _time_unit(end - begin)
    for axis, group in zip(picture.axes, groups, strict=False):
        _draw_axis(group, picture, axis, second)
        if several:
            group[0].set_title(f"axis {axis}", loc="left", fontsize=10, fontweight="bold", pad=15)
    if len(groups) > len(picture.axes):
        _draw_channels(groups[-1], picture, second)
    _title(figure, run, picture.hidden_axes, picture.hidden_channels)
    _legend(figure, [row for rows in picture.moves.values() if is_shaded(rows) for row in rows])
    last = groups[-1][-1]
    last.set_xlabel(f"time ({unit})")
    last.set_xlim(begin / second, (end or 1.0) / second)
    figure.align_ylabels([axes for group in groups for axes in group])
    return figure


def _draw_axis(group: Sequence[Axes], picture: _Picture, axis: int, second: float) -> None:
    rows = picture.moves[axis]
    for axes, panel in zip(group, picture.panels[axis], strict=True):
        draw_panel(axes, panel, rows, picture.span, second)
    name_moves(group[0], rows, picture.span, second)
    mark_events(group, [row for row in picture.events if row.get("axis") == axis], picture.span, second)


def _draw_channels(group: Sequence[Axes], picture: _Picture, second: float) -> None:
    group[0].set_title("channels", loc="left", fontsize=10, fontweight="bold", pad=5)
    for axes, lane in zip(group, picture.analogue, strict=False):
        draw_analogue(axes, lane, picture.span[1], second)
    if picture.digital:
        draw_lanes(group[-1], picture.digital, picture.span, second)


def _layout(heights: Sequence[Sequence[float]], head: float) -> tuple[Figure, list[list[Axes]]]:
    """Return a figure with groups of panels and a common time scale.

    Heights are in inches. Only the last panel has labels of the time scale.
    """
    from matplotlib.figure import Figure

    total = (
        head
        + BOTTOM
        + fsum(height for group in heights for height in group)
        + WITHIN * sum(len(group) - 1 for group in heights)
    )
    total += BETWEEN * (len(heights) - 1)
    figure = Figure(figsize=(WIDTH, total), facecolor="white")
    groups: list[list[Axes]] = []
    top, first = total - head, None
    for group in heights:
        groups.append([])
        for height in group:
            box = (LEFT, (top - height) / total, RIGHT - LEFT, height / total)
            axes = figure.add_axes(box, sharex=first)
            first = first or axes
            axes.tick_params(labelbottom=False)
            groups[-1].append(axes)
            top -= height + WITHIN
        top += WITHIN - BETWEEN
    groups[-1][-1].tick_params(labelbottom=True)
    return figure, groups


def _title(figure: Figure, run: Run, hidden: int, unseen: int) -> None:
    height = figure.get_figheight()
    what = f"{dialect_name(run.dialect.name)}  ·  {outcome(run)}"
    if hidden:
        what += f"  ·  {hidden} more axes moved but are not drawn"
    if unseen:
        what += f"  ·  {unseen} more channels changed but are not drawn"
    name = printable(run.source.name)
    figure.text(LEFT, 1 - 0.3 / height, name, fontsize=14, fontweight="bold", va="center", parse_math=False)
    figure.text(LEFT, 1 - 0.54 / height, what, fontsize=9, color=FAINT, va="center", parse_math=False)


def _legend(figure: Figure, rows: Sequence[dict[str, Any]]) -> None:
    """Add a legend of the shades at the top right."""
    from matplotlib.patches import Patch

    names = {phase["name"] for row in rows for phase in row["phases"]}
    patches = [Patch(facecolor=_darker(PHASES[name]), label=name) for name in PHASES if name in names]
    if patches:
        figure.legend(
            handles=patches,
            loc="center right",
            bbox_to_anchor=(RIGHT + 0.008, 1 - 0.3 / figure.get_figheight()),
            ncols=len(patches),
            frameon=False,
            fontsize=8.5,
            labelcolor=FAINT,
            handlelength=1.1,
            handleheight=1.1,
            handletextpad=0.5,
            columnspacing=1.4,
        )


def _darker(colour: str) -> str:
    """Return a shade of `colour` that is strong enough for a small square on paper."""
    channels = (int(colour[i : i + 2], 16) for i in (1, 3, 5))
    return "#" + "".join(f"{int(255 - 2.6 * (255 - channel)):02x}" for channel in channels)


def _time_unit(end: float) -> tuple[str, float]:
    """Return the unit of the time axis and its length in seconds."""
    if end >= 3 * 3600.0:
        return "h", 3600.0
    return ("min", 60.0) if end >= 600.0 else ("s", 1.0)
