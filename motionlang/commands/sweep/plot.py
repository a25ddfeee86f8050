"""Figures of a sweep: lines over one name, a heat map over two, the Pareto front."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

from motionlang.views.figure import (
    AXIS,
    BLUE,
    COLOURS,
    RED,
    VIRIDIS,
    Area,
    ColourScale,
    Curve,
    Figure,
    Panel,
    named,
)

Point = tuple[float, ...]

WIDTH, HEIGHT, PANEL = 648.0, 290.0, 140.0
# The largest number of lines in one panel; more are indistinguishable.
MAX_LINES = 8
# The largest number of points of a line with markers.
MAX_MARKED = 60


def line_figure(
    x: str,
    curves: Mapping[str, Mapping[str, Sequence[Point]]],
    units: Mapping[str, str],
    best: Mapping[str, Point] | None = None,
) -> Figure:
    """Return a panel for each result over the varied name `x`.

    A panel has a line for each combination of the other names; the first one names them. `curves` has the points
    of each line by result and label; `best` has a point to mark, by result.
    """
    panels: list[list[Panel]] = []
    for name, lines in curves.items():
        drawn = [
            _points(
                points,
                COLOURS[n % len(COLOURS)],
                "" if panels else label,
                width=1.4,
                is_dashed=n >= len(COLOURS),
                marker="circle" if len(points) <= MAX_MARKED else "",
                size=1.8,
            )
            for n, (label, points) in enumerate(lines.items())
        ]
        if best and name in best:
            drawn.append(_best(best[name]))
        height = max(HEIGHT / len(curves), PANEL)
        panels.append([Panel(drawn, name, units.get(name, ""), height=height)])
    return Figure(panels, x_label=named(x, units.get(x, "")), width=WIDTH)


def map_figure(
    names: tuple[str, str, str], points: Sequence[Point], units: Mapping[str, str], best: Point | None = None
) -> Figure:
    """Return the third name as colour over the first two; `points` are (x, y, value)."""
    x, y, z = (named(name, units.get(name, "")) for name in names)
    values = [p[2] for p in points]
    scale = ColourScale(z, min(values), max(values), VIRIDIS)
    xs, ys = sorted({p[0] for p in points}), sorted({p[1] for p in points})
    mark = [] if best is None else [_best(best)]
    if len(xs) * len(ys) <= 4 * len(points) and len(xs) > 1 and len(ys) > 1:
        across, up = _edges(xs), _edges(ys)
        areas = [Area(*_corners(across[p[0]], up[p[1]]), scale.colour(p[2])) for p in points]
        x_limits, y_limits = (across[xs[0]][0], across[xs[-1]][1]), (up[ys[0]][0], up[ys[-1]][1])
        panel = Panel(mark, y, areas=areas, height=330.0, x_limits=x_limits, y_limits=y_limits)
    else:  # sampled points, not a grid
        dots = [_points([p], scale.colour(p[2]), width=0.0, marker="circle") for p in points]
        panel = Panel([*dots, *mark], y, height=330.0)
    return Figure([[panel]], x_label=x, scale=scale, width=WIDTH)


def front_figure(
    names: tuple[str, str], points: Sequence[Point], front: Sequence[Point], units: Mapping[str, str]
) -> Figure:
    """Return all variants over two results, with the points of the Pareto front connected."""
    x, y = (named(name, units.get(name, "")) for name in names)
    curves = [
        _points(points, AXIS, "variants", width=0.0, marker="circle", size=1.5),
        _points(front, BLUE, "Pareto front", width=1.2, marker="circle", size=2.2, is_stepped=True),
    ]
    return Figure([[Panel(curves, y, height=HEIGHT)]], x_label=x, width=WIDTH)


def _points(points: Sequence[Point], colour: str, name: str = "", **style: object) -> Curve:
    return Curve([p[0] for p in points], [p[1] for p in points], colour, name, **style)  # type: ignore[arg-type]


def _best(point: Point) -> Curve:
    return _points([point], RED, width=0.0, marker="diamond", size=5.0)


def _edges(values: Sequence[float]) -> dict[float, tuple[float, float]]:
    """Return the begin and the end of the cell around each value, half-way to its neighbours."""
    middles = [0.5 * (a + b) for a, b in pairwise(values)]
    first, last = 2.0 * values[0] - middles[0], 2.0 * values[-1] - middles[-1]
    return dict(zip(values, pairwise([first, *middles, last]), strict=True))


def _corners(across: tuple[float, float], up: tuple[float, float]) -> tuple[list[float], list[float]]:
    (left, right), (low, high) = across, up
    return [left, right, right, left], [low, low, high, high]
