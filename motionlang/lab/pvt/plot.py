"""PVT moves as a figure like those of the note: position, velocity, acceleration.

The given points are red asterisks.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from motionlang.kernel.planners import Profile
from motionlang.lab.pvt.points import knots
from motionlang.views.figure import BLUE, Curve, Figure, Panel

QUANTITIES = (("position", "counts"), ("velocity", "counts/s"), ("acceleration", "counts/s²"))
MARK = "#d01c1f"
MAX_MARKS = 400
POINTS = 2000
WIDTH, NARROW, HEIGHT = 576.0, 302.0, 150.0


def pvt_figure(profiles: Sequence[Profile], titles: Sequence[str]) -> Figure:
    """Return a figure of moves side by side."""
    columns = [_column(profile, title) for profile, title in zip(profiles, titles, strict=True)]
    return Figure(
        list(zip(*columns, strict=True)),
        x_label="time (ms)",
        width=WIDTH if len(profiles) == 1 else NARROW * len(profiles),
        has_shared_y=True,
    )


def _column(profile: Profile, title: str) -> list[Panel]:
    marks = knots(profile)
    times = [mark.time * 1000.0 for mark in marks]
    given = (
        [mark.position for mark in marks],
        [mark.next_velocity for mark in marks[:-1]] + [marks[-1].velocity],
    )
    made = []
    for order, (name, unit) in enumerate(QUANTITIES):
        curves = [Curve(*_curve(profile, order), BLUE, width=1.4)]
        if order < 2 and len(marks) <= MAX_MARKS:
            curves.append(Curve(times, given[order], MARK, width=0.0, marker="star", size=5.5))
        top = "" if order else title
        made.append(Panel(curves, name, unit, title=top, height=HEIGHT))
    return made


def _curve(profile: Profile, order: int) -> tuple[list[float], list[float]]:
    """Return the points of each piece, with both ends, so that jumps are vertical."""
    knots, pieces, _ = profile.drawn
    per_piece = max(2, min(60, POINTS // max(1, len(pieces))))
    xs: list[float] = []
    ys: list[float] = []
    for piece, (begin, finish) in zip(pieces, pairwise(knots), strict=True):
        x = np.linspace(0.0, finish - begin, per_piece)
        c0, c1, c2, c3 = piece[:4]
        y = (
            ((c3 * x + c2) * x + c1) * x + c0,
            (3.0 * c3 * x + 2.0 * c2) * x + c1,
            6.0 * c3 * x + 2.0 * c2,
        )[order]
        xs += ((x + begin) * 1000.0).tolist()
        ys += y.tolist()
    return xs, ys
