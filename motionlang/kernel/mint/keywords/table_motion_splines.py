"""Splines: positions at given times, with velocities given or computed.

The tables are arrays of the program. SPLINE_1 uses the mean velocity of the two segments that meet at a point.
SPLINE_2 uses the velocities that make the acceleration continuous. Which of Mint's two profiles is which is from
memory.
"""

from __future__ import annotations

from itertools import pairwise

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.motion.profile_playback import Playback, Timed
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword, constant
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.buffer import loads
from motionlang.kernel.mint.keywords.table_motion_cams import (
    ABSOLUTE,
    CONTINUOUS,
    TRULY_ABSOLUTE,
    command_row,
    elements,
    index_row,
    setting_row,
    span,
)
from motionlang.kernel.mint.runtime.binding import Operation, check, of, of_word
from motionlang.kernel.mint.runtime.changes import with_dependency
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.planners.pvt.velocities import average_velocities, smooth_velocities
from motionlang.kernel.planners.table_motion import spline_slopes

Array = list[float]


SECOND = 8
# Minimum and maximum time of a segment in ms, and the step to which it is rounded.
MIN_TIME, MAX_TIME, STEP = 4, 60000, 2
DEFAULTS = {"SPLINESTART": 1, "SPLINETIME": 100}


class Splines(StoredSettings):
    """The spline tables and settings of every axis."""

    defaults = DEFAULTS

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.arrays: dict[int, tuple[Array, Array | None, Array | None]] = {}
        self.modes: dict[int, int] = {}
        # The last segment of the spline in motion.
        self.ends: dict[int, int] = {}

    def motion(self, axis: int, mode: int, start: float, first_time: bool) -> Timed:
        """Return the motion through the table from `start`, in counts.

        The first run starts from rest, each further run at the final velocity of the preceding one.
        """
        points, velocities, times = self._points(axis, mode, start)
        cyclic = bool(mode & CONTINUOUS)
        try:
            if velocities is None:
                last = _seam(points, times, bool(mode & SECOND)) if cyclic else 0.0
                choose = smooth_velocities if mode & SECOND else average_velocities
                velocities = choose(points, times, 0.0 if first_time else last, last)
            else:
                velocities = [0.0 if first_time else velocities[-1], *velocities]
            return points, velocities, times
        except ValueError as problem:
            raise Rejected("range", f"axis {axis} cannot follow the spline: {problem}") from None

    def _points(
        self, axis: int, mode: int, start: float
    ) -> tuple[list[float], list[float] | None, list[float]]:
        if axis not in self.arrays:
            raise Rejected(
                "range", f"axis {axis} has no spline", f"write SPLINETABLE({axis}, positions) first"
            )
        positions, velocities, times = self.arrays[axis]
        steps, scale = elements(positions, "SPLINETABLE"), self.scale(axis)
        first, end = span(
            self.setting("SPLINESTART", axis), self.setting("SPLINEEND", axis), len(steps), "SPLINE"
        )
        self.ends[axis] = end
        points, base = [start], steps[first - 1] if first else 0.0
        for step in steps[first:end]:
            if mode & TRULY_ABSOLUTE:
                points.append(scale.position_to_counts(step))
            else:
                points.append((start if mode & ABSOLUTE else points[-1]) + scale.to_counts(
                    step - base if mode & ABSOLUTE else step))  # fmt: skip
        spans = [seconds(self.setting("SPLINETIME", axis))] * (end - first)
        if times is not None:
            spans = [seconds(time) for time in _section(times, first, end)]
        speeds = None
        if velocities is not None:
            speeds = [scale.to_counts(v, "uu/s") for v in _section(velocities, first, end)]
        return points, speeds, spans


def seconds(milliseconds: float) -> float:
    """Convert the time of a segment to seconds, rounded to whole controller steps.

    Raises Rejected if the time is out of range.
    """
    if not MIN_TIME <= milliseconds <= MAX_TIME:
        words = f"a segment of a spline cannot take {milliseconds:.10g} ms"
        raise Rejected("range", words, f"it takes {MIN_TIME} to {MAX_TIME} ms, in steps of {STEP}")
    return STEP * int(milliseconds // STEP) / 1000.0


def _section(array: Array, first: int, end: int) -> list[float]:
    values = elements(array, "SPLINETABLE")
    if len(values) < end:
        raise Rejected("range", f"SPLINETABLE: one of the arrays has {len(values)} segments and another {end}",
                      "the arrays must be equally long")  # fmt: skip
    return values[first:end]


def _seam(points: list[float], times: list[float], smooth: bool) -> float:
    """Return the velocity at which the end of a continuous spline joins its start."""
    steps = [b - a for a, b in pairwise(points)]
    if smooth and len(times) > 1:
        return spline_slopes(times, [d / h for d, h in zip(steps, times, strict=True)], True)[0]
    return (steps[-1] + steps[0]) / (times[-1] + times[0])


# ----------------------------------------------------------------------------------------------- operations


def do_table(
    splines: Splines,
    row: Keyword,
    axis: int,
    positions: Array | None,
    velocities: Array | None,
    times: Array | None,
    line: int,
) -> None:
    """SPLINETABLE: set the arrays of positions, velocities and times, or clear them."""
    if positions is None:
        splines.arrays.pop(axis, None)
        return
    elements(positions, row.name)
    splines.arrays[axis] = positions, velocities, times


def put_spline(splines: Splines, row: Keyword, axis: int, mode: int, line: int) -> None:
    """SPLINE: run through the table once or continuously.

    Raises Rejected unless the axis is idle and its buffer empty.
    """
    check(row, mode)
    controller = splines.controller
    if not controller.is_idle(axis) or controller.axes[axis].buffer:
        raise Rejected("moving", f"axis {axis} is moving, or its buffer is not empty",
                      "a spline needs the axis idle and nothing else in its buffer")  # fmt: skip

    def make(start: float) -> Timed:
        return splines.motion(axis, mode, start, True)

    def again(start: float) -> Timed:
        return splines.motion(axis, mode, start, False)

    controller.load_points(axis, make, again if mode & CONTINUOUS else None, row.name, line)
    splines.modes[axis] = mode


def read_index(splines: Splines, axis: int) -> int:
    """Return the number of the executing segment, 0 if there is no spline.

    It is computed from the number of segments that remain.
    """
    a = splines.controller.axes[axis]
    if a.move is None or a.move.command != "SPLINE" or not isinstance(a.move.action, Playback):
        return 0
    ahead = a.move.action.segments_left(a)
    # A cycle that was suspended near its end is followed by the next one.
    return splines.ends[axis] - ahead % (splines.ends[axis] - int(splines.setting("SPLINESTART", axis)) + 1)


def bind_index(environment: Environment, row: Keyword) -> Operation:
    """SPLINEINDEX: make a reading that changes where a segment ends."""
    controller = environment.controller

    def until(axis: int) -> float:
        a = controller.axes[axis]
        if a.move is None or not isinstance(a.move.action, Playback):
            return INFINITY
        return a.move.action.next_segment_time(a)

    return with_dependency(environment, of(Splines, read_index)(environment, row), until)


# ------------------------------------------------------------------------------------------------- keywords

_SPLINE_ACTIONS = Actions(
    read=of(Splines, lambda splines, axis: splines.modes.get(axis, 0)), load=loads(Splines, put_spline)
)
_SETTING = Actions(read=setting_reader(Splines), write=setting_writer(Splines))

_SPLINE = (
    "Dim way(4) As Float = 3, 10, 20, 10\nSPLINETABLE(0, way, NULL, NULL)\n{}SPLINE(0) = 0\nGO(0)\nPAUSE IDLE(0)\n"
    'PRINT POS(0), " ", TIME'
)
_SPLINE_BITS = (
    ("SPLINE_1", 0, "velocities are the means of the segments at each point"),
    ("ABSOLUTE", 1, "positions count from the start of each cycle"),
    ("T_ABSOLUTE", 2, "positions are those of the axis"),
    ("CONTINUOUS", 4, "again and again until it is stopped"),
    ("SPLINE_2", 8, "the acceleration is continuous"),
)


ROWS = (
    *(constant(f"_sp{name}", value, f"SPLINE, and CAM: {help}.") for name, value, help in _SPLINE_BITS),
    command_row("SPLINETABLE", "axis, array, array, array", Actions(do=of_word(Splines, do_table)),
             "Attach arrays to a spline: positions, velocities (NULL: chosen) and times of the segments in ms (NULL: "
             "SPLINETIME). Element 1 is the number of segments.", _SPLINE.format("")),
    Keyword("SPLINE", "SPL", "move", "RW", "axis", "integer", _SPLINE_ACTIONS,
            "Load a spline through the positions of SPLINETABLE; GO begins it. The bits are the _sp constants; "
            "the axis must be idle.",
            _SPLINE.format(""), low=0, high=15, group="motion", effect="course", family="splines"),
    setting_row("SPLINESTART", _SETTING, "integer", "The first segment of a spline that is used.",
             _SPLINE.format("SPLINESTART(0) = 2\n"), 1.0, 1, 16777215),
    setting_row("SPLINEEND", _SETTING, "integer",
             "The last segment of a spline that is used; 0 for the table's last.",
             _SPLINE.format("SPLINEEND(0) = 2\n"), 0.0, 0, 16777215),
    setting_row("SPLINETIME", _SETTING, "ms",
             "Milliseconds of each segment of a spline, in whole steps of 2.",
             _SPLINE.format("SPLINETIME(0) = 250\n"), 100.0, 4, 60000),
    setting_row("SPLINESUSPENDTIME", "suspend_time", "ms",
             "Milliseconds in which SUSPEND, STOP and the controlled stop of an error bring a spline to rest on its "
             "path, and in which it does the rest of its segment when it goes on.",
             _SPLINE.format("SPLINESUSPENDTIME(0) = 20\n"), 100.0, 0, 60000),
    index_row("SPLINEINDEX", "The segment of the spline that is executing, 0 without one.",
           _SPLINE.format("") + "\nPRINT SPLINEINDEX(0)", Actions(read=bind_index)),
)  # fmt: skip
