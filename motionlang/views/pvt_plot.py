"""PVT moves drawn as in the note: position, velocity, acceleration.

The given points are red asterisks.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from motionlang.errors import need
from motionlang.files import replacing
from motionlang.planners.curve import Profile
from motionlang.planners.pvt.points import knots
from motionlang.views.plot import STYLE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

QUANTITIES = (("Position", "counts"), ("Velocity", "counts/s"), ("Acceleration", "counts/s²"))
LINE, MARK, GRID = "#1f5fae", "#d01c1f", "#d9dfe5"
MAX_MARKS = 400
POINTS = 2000
SIZE, NARROW, DPI = (8.0, 7.5), 4.2, 120


def write_pvt_plot(profiles: Sequence[Profile], titles: Sequence[str], path: str) -> None:
    """Draw moves side by side into a .png or .svg file.

    Raises OSError, and MissingExtra if matplotlib is missing.
    """
    need("a picture", "matplotlib")
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    kind = os.path.splitext(path)[1].lower()[1:]
    with rc_context(cast("Any", STYLE)), replacing(path) as file:
        width = SIZE[0] if len(profiles) == 1 else NARROW * len(profiles)
        picture = Figure(figsize=(width, SIZE[1]), layout="constrained")
        grid = picture.subplots(3, len(profiles), sharex="col", sharey="row", squeeze=False)
        for column, (profile, title) in enumerate(zip(profiles, titles, strict=True)):
            _draw(list(grid[:, column]), profile, title, leftmost=column == 0)
        picture.align_ylabels()
        _save(picture, file, kind)


def _save(picture: Figure, file: object, kind: str) -> None:
    metadata = {"Creator": "motionlang", "Date": None} if kind == "svg" else {"Software": "motionlang"}
    picture.savefig(file, format=kind, dpi=DPI, metadata=metadata)  # type: ignore[arg-type]  # any binary file


def _draw(panels: list[Axes], profile: Profile, title: str, *, leftmost: bool) -> None:
    marks = knots(profile)
    times = np.array([mark.time for mark in marks]) * 1000.0
    given = (
        [mark.position for mark in marks],
        [mark.next_velocity for mark in marks[:-1]] + [marks[-1].velocity],
    )
    for order, (axes, (name, unit)) in enumerate(zip(panels, QUANTITIES, strict=True)):
        x, y = _curve(profile, order)
        axes.plot(x, y, color=LINE, linewidth=1.4)
        if order < 2 and len(marks) <= MAX_MARKS:
            axes.plot(times, given[order], "*", color=MARK, markersize=9, clip_on=False, zorder=3)
        axes.grid(True, color=GRID, linewidth=0.6)
        axes.set_axisbelow(True)
        axes.margins(x=0.02)
        if leftmost:
            axes.set_ylabel(f"{name} ({unit})")
    panels[0].set_title(title)
    panels[-1].set_xlabel("Time (ms)")


def _curve(profile: Profile, order: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the points of each piece, with both ends, so that jumps are vertical."""
    per_piece = max(2, min(60, POINTS // max(1, len(profile.pieces))))
    xs, ys = [], []
    for piece, (begin, finish) in zip(profile.pieces, pairwise(profile.knots), strict=True):
        x = np.linspace(0.0, finish - begin, per_piece)
        c0, c1, c2, c3 = piece[:4]
        y = (
            ((c3 * x + c2) * x + c1) * x + c0,
            (3.0 * c3 * x + 2.0 * c2) * x + c1,
            6.0 * c3 * x + 2.0 * c2,
        )[order]
        xs.append((x + begin) * 1000.0)
        ys.append(y)
    return np.concatenate(xs), np.concatenate(ys)
