"""Plots of a sweep: lines over one name, a heat map over two, the Pareto front."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from motionlang.views.servo_plot import BLUE, COLOURS, GREY, RED, drawing, dress

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Point = tuple[float, ...]

WIDTH, HEIGHT, PANEL = 9.0, 5.0, 2.2
# The largest number of lines in one panel; more are indistinguishable.
MAX_LINES = 8
# The largest number of points of a line with markers.
MAX_MARKED = 60


def plot_lines(
    path: str,
    x: str,
    curves: Mapping[str, Mapping[str, Sequence[Point]]],
    units: Mapping[str, str],
    best: Mapping[str, Point] | None = None,
) -> None:
    """Draw a panel for each result over the varied name `x`.

    A panel has a line for each combination of the other names. `curves` has the points of each line by result
    and label; `best` has a point to mark, by result.
    """
    with drawing(path, WIDTH, max(HEIGHT, PANEL * len(curves) + 0.6)) as figure:
        panels = figure.subplots(len(curves), 1, sharex=True, squeeze=False)[:, 0]
        for panel, (name, lines) in zip(panels, curves.items(), strict=True):
            for n, (label, points) in enumerate(lines.items()):
                xs, ys = [p[0] for p in points], [p[1] for p in points]
                panel.plot(
                    xs, ys, color=COLOURS[n % len(COLOURS)], linewidth=1.4, label=label or None,
                    linestyle="-" if n < len(COLOURS) else "--", marker="o" if len(xs) <= MAX_MARKED else None,
                    markersize=3,
                )  # fmt: skip
            if best and name in best:
                _mark(panel, best[name])
            dress(panel, name, units.get(name, ""))
            if any(lines):
                panel.legend(frameon=False, fontsize=8)
        panels[-1].set_xlabel(_labelled(x, units))


def plot_map(
    path: str,
    names: tuple[str, str, str],
    points: Sequence[Point],
    units: Mapping[str, str],
    best: Point | None = None,
) -> None:
    """Draw the third name as colour over the first two; `points` are (x, y, value)."""
    x, y, z = names
    with drawing(path, WIDTH, HEIGHT + 1.0) as figure:
        panel = figure.subplots()
        xs, ys = sorted({p[0] for p in points}), sorted({p[1] for p in points})
        if len(xs) * len(ys) <= 4 * len(points) and len(xs) > 1 and len(ys) > 1:
            values = {(p[0], p[1]): p[2] for p in points}
            table = [[values.get((a, b), float("nan")) for a in xs] for b in ys]
            drawn: Any = panel.pcolormesh(xs, ys, table, shading="nearest", cmap="viridis")
        else:  # sampled points, not a grid
            drawn = panel.scatter(
                [p[0] for p in points], [p[1] for p in points], c=[p[2] for p in points], cmap="viridis", s=22
            )
        figure.colorbar(drawn, label=_labelled(z, units))
        if best is not None:
            _mark(panel, best)
        dress(panel, _labelled(y, units))
        panel.grid(False)
        panel.set_xlabel(_labelled(x, units))


def plot_front(
    path: str,
    names: tuple[str, str],
    points: Sequence[Point],
    front: Sequence[Point],
    units: Mapping[str, str],
) -> None:
    """Plot all variants over two results, and connect the points of the Pareto front."""
    x, y = names
    with drawing(path, WIDTH, HEIGHT) as figure:
        panel = figure.subplots()
        panel.plot(
            [p[0] for p in points], [p[1] for p in points], ".", color=GREY, markersize=4, label="variants"
        )
        panel.plot(
            [p[0] for p in front], [p[1] for p in front], "o-", color=BLUE, markersize=4, linewidth=1.2,
            drawstyle="steps-post", label="Pareto front",
        )  # fmt: skip
        panel.legend(frameon=False, fontsize=8)
        dress(panel, _labelled(y, units))
        panel.set_xlabel(_labelled(x, units))


def _mark(panel: Axes, point: Point) -> None:
    panel.plot([point[0]], [point[1]], "D", color=RED, markersize=6, markeredgecolor="white", zorder=5)


def _labelled(name: str, units: Mapping[str, str]) -> str:
    unit = units.get(name, "")
    return f"{name} ({unit})" if unit else name
