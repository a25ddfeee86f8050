"""The run as a picture: position, velocity and acceleration over time, phases shaded, moves named by their lines.

matplotlib draws it, without pyplot and without a display. The same run gives the same bytes: no dates, no random
names. Long runs are drawn from their outline, which keeps every peak.
"""

from __future__ import annotations

import os
from typing import IO, TYPE_CHECKING, Any

from motionlang import __version__
from motionlang.report import moves as moves_of
from motionlang.views.files import replacing
from motionlang.views.outline import outline
from motionlang.views.terminal import printable
from motionlang.views.words import dialect_name, outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from motionlang.controller.trace import Trace
    from motionlang.execution import Run

QUANTITIES = {"position": "uu", "velocity": "uu/s", "acceleration": "uu/s²"}
INK, FAINT = "#1c2733", "#6b7785"
LINES = {"position": "#1f5fae", "velocity": "#0b7a5b", "acceleration": "#b4490f"}
PHASES = {
    "accel": "#e3f4ea",
    "slew": "#edf3fb",
    "decel": "#fdeee2",
    "stop": "#fadede",
    "segment": "#f1ebf9",
    "hold": "#f4f6f8",
}
# Beyond these numbers shading is noise and names lie on top of each other.
MOST_SHADED, MOST_NAMED = 60, 40
MOST_AXES = 8
# Inches: the picture's width, the height of a panel (of one axis, of several), what is above and below them all.
WIDTH, DPI = 11.0, 120
PANEL, MARGIN = (1.9, 1.35), 1.35
LEFT, RIGHT = 0.095, 0.985
# "Any": every release of matplotlib types its keys differently.
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


def write_plot(run: Run, path: str) -> None:
    """Draw `run` into a .png or .svg file; raises OSError, and ImportError where matplotlib is missing."""
    import warnings

    from matplotlib import rc_context

    kind = os.path.splitext(path)[1].lower()[1:]
    with rc_context(STYLE), replacing(path) as file, warnings.catch_warnings():
        warnings.simplefilter("ignore")  # a letter that the font lacks is drawn as a box, and that is that
        _save(_figure(run), file, kind)


def _save(figure: Figure, file: IO[bytes], kind: str) -> None:
    creator = f"motionlang {__version__}"
    metadata = {"Creator": creator, "Date": None} if kind == "svg" else {"Software": creator}
    figure.savefig(file, format=kind, dpi=DPI, metadata=metadata)


def _figure(run: Run) -> Figure:
    from matplotlib.figure import Figure

    trace = run.trace
    axes = trace.axes[:MOST_AXES]
    height = PANEL[len(axes) > 1] * 3 * len(axes) + MARGIN
    figure = Figure(figsize=(WIDTH, height), facecolor="white")
    rows = list(moves_of(run))
    unit = _time_unit(trace.end)
    panels = _panels(figure, len(axes), height)
    for axis, group in zip(axes, panels, strict=True):
        _axis(group, trace, axis, [row for row in rows if row["axis"] == axis], unit[1])
        if len(axes) > 1:
            group[0].set_title(f"axis {axis}", loc="left", fontsize=9.5, fontweight="bold", pad=4)
    _title(figure, run, len(trace.axes) - len(axes), height)
    if any(_is_shaded([row for row in rows if row["axis"] == axis]) for axis in axes):
        _legend(figure, rows, height)
    panels[-1][-1].set_xlabel(f"time ({unit[0]})")
    panels[-1][-1].set_xlim(0.0, (trace.end or 1.0) / unit[1])
    figure.align_ylabels([panel for group in panels for panel in group])
    return figure


def _panels(figure: Figure, count: int, height: float) -> list[list[Axes]]:
    """Three panels an axis, one time scale for all, which only the last one spells out."""
    outer = figure.add_gridspec(
        count, 1, left=LEFT, right=RIGHT, top=1 - 0.85 / height, bottom=0.5 / height, hspace=0.16
    )
    groups: list[list[Axes]] = []
    first = None
    for k in range(count):
        inner = outer[k].subgridspec(3, 1, hspace=0.13)
        groups.append([])
        for i in range(3):
            panel = figure.add_subplot(inner[i], sharex=first)
            first = first or panel
            panel.tick_params(labelbottom=k == count - 1 and i == 2)
            groups[-1].append(panel)
    return groups


def _title(figure: Figure, run: Run, hidden: int, height: float) -> None:
    name = printable(run.source.name)
    what = f"{dialect_name(run.dialect.name)}  ·  {outcome(run)}"
    if hidden:
        what += f"  ·  {hidden} more axes moved and are not drawn"
    figure.text(LEFT, 1 - 0.3 / height, name, fontsize=14, fontweight="bold", va="center", parse_math=False)
    figure.text(LEFT, 1 - 0.53 / height, what, fontsize=9, color=FAINT, va="center", parse_math=False)


def _legend(figure: Figure, rows: list[dict[str, Any]], height: float) -> None:
    names = {phase["name"] for row in rows for phase in row["phases"]}
    for i, name in enumerate(reversed([name for name in PHASES if name in names])):
        x = RIGHT - 0.068 * (i + 1)
        figure.text(x + 0.02, 1 - 0.3 / height, name, fontsize=8.5, color=FAINT, va="center")
        figure.text(x, 1 - 0.3 / height, "■", fontsize=13, color=_darker(PHASES[name]), va="center")


def _darker(colour: str) -> str:
    """The shade of a patch of `colour` on paper, strong enough for a small square."""
    channels = (int(colour[i : i + 2], 16) for i in (1, 3, 5))
    return "#" + "".join(f"{int(255 - 2.6 * (255 - channel)):02x}" for channel in channels)


def _time_unit(end: float) -> tuple[str, float]:
    """The unit that time is drawn in, and its seconds."""
    if end >= 3 * 3600.0:
        return "h", 3600.0
    return ("min", 60.0) if end >= 600.0 else ("s", 1.0)


def _axis(panels: list[Axes], trace: Trace, axis: int, rows: list[dict[str, Any]], second: float) -> None:
    """The three panels of one axis."""
    for panel, (quantity, unit) in zip(panels, QUANTITIES.items(), strict=True):
        times, values = outline(trace, axis, quantity)
        if _is_shaded(rows):
            _shade(panel, rows, second)
        dense = len(rows) > MOST_SHADED
        panel.plot(
            times / second,
            values,
            color=LINES[quantity],
            linewidth=0.6 if dense else 1.6,
            alpha=0.7 if dense else 1.0,
            solid_joinstyle="round",
            zorder=3,
        )
        if quantity != "position":
            panel.axhline(0.0, color="#9aa6b2", linewidth=0.8, zorder=1.5)
            _peak(panel, float(abs(values).max()), unit)
        panel.set_ylabel(f"{quantity}\n({unit})", fontsize=8.5)
        _dress(panel, float(values.min()), float(values.max()))
    _name_moves(panels[0], rows, trace.end, second)


def _peak(panel: Axes, peak: float, unit: str) -> None:
    panel.annotate(
        f"peak {peak:.6g} {unit}",
        (1.0, 1.0),
        (0, 3),
        xycoords="axes fraction",
        textcoords="offset points",
        ha="right",
        fontsize=7.5,
        color=FAINT,
    )


def _dress(panel: Axes, low: float, high: float) -> None:
    from matplotlib.ticker import MaxNLocator

    panel.grid(True, color="#8496a8", alpha=0.25, linewidth=0.7)
    panel.set_axisbelow(True)
    panel.tick_params(length=0, labelsize=8)
    panel.yaxis.set_major_locator(MaxNLocator(nbins=5, steps=[1, 2, 2.5, 5, 10], min_n_ticks=3))
    plain = max(abs(low), abs(high)) < 1e7
    panel.ticklabel_format(axis="y", style="plain" if plain else "sci", useOffset=False)
    for side in ("top", "right"):
        panel.spines[side].set_visible(False)
    room = 0.08 * ((high - low) or abs(high) or 1.0)
    panel.set_ylim(low - room, high + room)


def _is_shaded(rows: list[dict[str, Any]]) -> bool:
    return 0 < sum(len(row["phases"]) for row in rows) <= MOST_SHADED


def _shade(panel: Axes, rows: list[dict[str, Any]], second: float) -> None:
    """Colour the phases of every move."""
    for row in rows:
        begin = row["start_time"]
        for phase in row["phases"]:
            end = begin + phase["duration"]
            colour = PHASES.get(phase["name"], PHASES["hold"])
            panel.axvspan(begin / second, end / second, color=colour, linewidth=0, zorder=0.5)
            begin = end


def _name_moves(panel: Axes, rows: list[dict[str, Any]], end: float, second: float) -> None:
    """Above the top panel: which line of the program each move comes from, where there is room to say so."""
    if len(rows) > MOST_NAMED or not end:
        return
    free = 0.0
    for row in rows:
        begin, duration = row["start_time"], row["duration"]
        share = duration / end
        text = next((t for t in _names(row) if len(t) * 0.0072 < share), "")
        middle = begin + 0.5 * duration
        if not text or middle / end - len(text) * 0.0036 < free:
            continue
        free = middle / end + len(text) * 0.0036 + 0.004
        panel.annotate(
            text,
            (middle / second, 1.0),
            (0, 4),
            xycoords=("data", "axes fraction"),
            textcoords="offset points",
            ha="center",
            fontsize=8,
            color=FAINT,
            parse_math=False,
        )


def _names(row: dict[str, Any]) -> tuple[str, str, str]:
    """What a move may be called, the longest first."""
    command, line = row["command"] or "move", row["line"]
    return f"{command} · line {line}", f"{command} {line}", str(line)
