"""The paths of a run in order: length, speed along the path, and transitions.

A path is a move of several axes that begin and end together on one line. Its figures are measured on the
motion itself, not taken from its plan: at `SAMPLES` points from the beginning to the end, and at the knots of the axes.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import acos, degrees
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel import Trace
from motionlang.views.formatting import figure, line_number
from motionlang.views.table import Column, Table

Array = NDArray[np.float64]

SAMPLES = 1001
# Fraction of a path's time at its ends in which its direction is taken, and fraction of its peak speed that
# counts as standstill.
_ENDS, _STILL = 1e-5, 1e-6
# Seconds within which the next path counts as following directly.
AT_ONCE = 1e-3
# Smaller angles, in degrees, are not corners.
SMOOTH = 0.05


class PathRow(NamedTuple):
    """One path: `length` in uu, speeds in uu/s, `corner` to the next path in degrees.

    `ended` is the cause of an early end, "" for none.
    """

    line: int
    command: str
    axes: tuple[int, ...]
    start_time: float
    duration: float
    length: float
    entry_speed: float
    peak_speed: float
    exit_speed: float
    corner: float | None
    ended: str


class _Path(NamedTuple):
    line: int
    command: str
    axes: tuple[int, ...]
    begin: float
    end: float
    ended: str


def paths(trace: Trace) -> list[PathRow]:
    """Return every path that has begun, in order of time."""
    found = _paths(trace)
    return [_row(trace, path, _following(path, found[k + 1 :])) for k, path in enumerate(found)]


def _paths(trace: Trace) -> list[_Path]:
    groups: dict[tuple[float, float, int, str], list[tuple[int, str]]] = {}
    for move in trace.controller.log.moves:
        if move.profile is not None and move.action is not None:
            begin, end = move.start_time, min(move.start_time + move.profile.duration, trace.end)
            groups.setdefault((begin, end, move.line, move.command), []).append((move.axis, move.ended))
    return [
        _Path(line, command, tuple(axis for axis, _ in moves), begin, end, moves[0][1])
        for (begin, end, line, command), moves in sorted(groups.items())
        if len(moves) > 1 and end > begin
    ]


def _following(path: _Path, later: Sequence[_Path]) -> _Path | None:
    """Return the path of the same axes that begins when this one ends."""
    for other in later:
        if other.begin > path.end + AT_ONCE:
            return None
        if set(other.axes) == set(path.axes):
            return other
    return None


def _row(trace: Trace, path: _Path, following: _Path | None) -> PathRow:
    times = _times(trace, path)
    inside = times.copy()
    inside[0], inside[-1] = np.nextafter(path.begin, path.end), np.nextafter(path.end, path.begin)
    speeds = _speeds(trace, path, inside)
    peak = float(speeds.max())
    still = _STILL * peak
    entry, leaving = (0.0 if speed <= still else float(speed) for speed in (speeds[0], speeds[-1]))
    corner = None if following is None else _angle(_tangent(trace, path, -1), _tangent(trace, following, 0))
    return PathRow(
        path.line,
        path.command,
        path.axes,
        path.begin,
        path.end - path.begin,
        _length(trace, path, times),
        entry,
        peak,
        leaving,
        corner,
        path.ended,
    )


def _times(trace: Trace, path: _Path) -> Array:
    """Return the times at which a path is measured, in order: between two of them its speed is smooth."""
    times = np.linspace(path.begin, path.end, SAMPLES)
    for axis in path.axes:
        knots = trace.table(axis).origins
        first, last = np.searchsorted(knots, path.begin, "right"), np.searchsorted(knots, path.end)
        times = np.union1d(times, knots[first:last])
    return times


def _speeds(trace: Trace, path: _Path, times: Array) -> Array:
    velocities = np.stack([trace.at(axis, "velocity", times) for axis in path.axes])
    speeds: Array = np.linalg.norm(velocities, axis=0)
    return speeds


def _length(trace: Trace, path: _Path, times: Array) -> float:
    """Return the length of a path, uu.

    For a line it is the distance between the ends, for any other path the integral of the speed by Gauss's rule of two
    points between all times.
    """
    positions = np.stack([trace.at(axis, "position", times) for axis in path.axes])
    chord = float(np.linalg.norm(positions[:, -1] - positions[:, 0]))
    steps = float(np.linalg.norm(np.diff(positions, axis=1), axis=0).sum())
    if steps - chord <= 1e-9 * steps:
        return chord
    middles, halves = 0.5 * (times[1:] + times[:-1]), 0.5 * np.diff(times)
    off = 3.0**-0.5 * halves
    return float(halves @ (_speeds(trace, path, middles - off) + _speeds(trace, path, middles + off)))


def _tangent(trace: Trace, path: _Path, side: int) -> Array:
    """Return the direction of a path at its beginning (0) or its end (-1)."""
    near = (path.end - path.begin) * _ENDS
    times = np.array([path.begin, path.begin + near] if side == 0 else [path.end - near, path.end])
    for _ in range(20):  # from rest it takes a while to cover a visible distance
        direction = np.array([np.diff(trace.at(axis, "position", times))[0] for axis in sorted(path.axes)])
        size = float(np.linalg.norm(direction))
        if size > 1e-7 * max(1.0, float(np.abs(trace.at(path.axes[0], "position", times)).max())):
            return direction / size
        times[1 + side] = path.begin + 2.0 * (times[1] - path.begin) if side == 0 else times[0]
        if side == -1:
            times[0] = path.end - 2.0 * (path.end - times[0])
    return np.zeros(len(path.axes))


def _angle(one: Array, other: Array) -> float:
    return degrees(acos(max(-1.0, min(1.0, float(one @ other)))))


def paths_table(rows: Sequence[PathRow]) -> Table:
    """Return the table of paths; speeds are those along the path."""
    columns = (
        Column("line", text=line_number),
        Column("command", left=True, style="word"),
        Column("axes", left=True, drop=2),
        Column("start_time", "start", "s", text="{:.6f}".format, drop=1),
        Column("duration", "time", "s", decimals=6),
        Column("length", unit="uu", decimals=4),
        Column("entry_speed", "entry", "uu/s", text=figure, drop=3),
        Column("peak_speed", "peak", "uu/s", text=figure),
        Column("exit_speed", "exit", "uu/s", text=figure),
        Column("corner", unit="°", text="{:.1f}".format),
        Column("end", "at its end", get=_at_its_end, left=True),
    )
    empty = "no path was run: no axes begin and end together on one line"
    return Table("paths", columns, rows, most=60, empty=empty)


def _at_its_end(row: PathRow) -> str:
    """Return how a path continues into the next, or why it stops.

    This is inferred from the motion alone.
    """
    if row.ended:
        return f"ended by {row.ended}"
    if row.exit_speed:
        return "continues"
    if row.corner is None:
        return "stops: no next path"
    return f"stops: corner of {row.corner:.1f}°" if row.corner > SMOOTH else "stops: the paths are not joined"
