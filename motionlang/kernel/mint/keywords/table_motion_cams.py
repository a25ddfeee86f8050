"""Cams: a follower moves by a table of positions over the travel of its master.

The tables are arrays of the program. Element 1 is the number of segments, and each later element belongs to one
segment. A value that the program writes to an array takes effect in the next cycle.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.readers import Level
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.buffer import loads
from motionlang.kernel.mint.keywords.following_masters import MASTER_SETTING, Masters, distance
from motionlang.kernel.mint.runtime.binding import Operation, check, of, of_word
from motionlang.kernel.mint.runtime.changes import with_dependency
from motionlang.kernel.mint.runtime.environment import Environment

Array = list[float]

Points = tuple[list[float], list[float]]


# Bits of CAM and SPLINE.
ABSOLUTE, TRULY_ABSOLUTE, CONTINUOUS = 1, 2, 4


def elements(array: Sequence[float], word: str) -> list[float]:
    """Return the elements of a table, which follow its count.

    Raises Rejected if the array is shorter than the count.
    """
    count = int(array[1]) if len(array) > 1 else 0
    if not 1 <= count <= len(array) - 2:
        words = f"element 1 of the table says that it has {count:.10g} segments, and the array has room for "
        raise Rejected(
            "range", f"{word}: {words}{max(0, len(array) - 2)}", "element 1 is the number of segments"
        )
    return [float(value) for value in array[2 : 2 + count]]


def span(first: float, last: float, count: int, word: str) -> tuple[int, int]:
    """Return the segments in use as a half-open range, counted from 0.

    `first` and `last` count from 1; 0 as `last` is the last segment of the table.
    """
    end = int(last) or count
    if not 1 <= first <= end <= count:
        words = f"the table has segments 1 to {count}, not {first:.10g} to {end:.10g}"
        raise Rejected("range", f"{word}: {words}", f"write {word}START and {word}END")
    return int(first) - 1, end


class Cams:
    """The tables of every axis, and the state of the cams in motion."""

    def __init__(self, environment: Environment) -> None:
        self.environment, self.masters = environment, environment.component(Masters)
        self.arrays: dict[int, tuple[Array, Array | None]] = {}
        self.modes: dict[int, int] = {}
        # The points of the last cycle of each axis, and the data they were computed from.
        self._made: dict[int, tuple[object, Points]] = {}

    def table(self, axis: int, mode: int, start: float) -> Points:
        """Return the positions of the master and of the follower for a cycle, in counts.

        If nothing has changed, the result is the same object as before.
        """
        masters, scale = self.masters, self.masters.scale(axis)
        steps, lengths = self.steps(axis), self.lengths(axis)
        first, end = span(
            masters.setting("CAMSTART", axis), masters.setting("CAMEND", axis), len(steps), "CAM"
        )
        amplitude = masters.setting("CAMAMPLITUDE", axis)
        start = start if mode & TRULY_ABSOLUTE else 0.0
        source = (steps, lengths, first, end, mode, amplitude, start, scale.counts)
        made = self._made.get(axis)
        if made is not None and made[0] == source:
            return made[1]
        values = [start]
        for n in range(first, end):
            if mode & TRULY_ABSOLUTE:
                values.append(scale.position_to_counts(steps[n]))
            elif mode & ABSOLUTE:
                base = steps[first - 1] if first else 0.0
                values.append(start + scale.to_counts((steps[n] - base) * amplitude))
            else:
                values.append(values[-1] + scale.to_counts(steps[n] * amplitude))
        positions = [0.0]
        for length in lengths[first:end]:
            positions.append(positions[-1] + length)
        self._made[axis] = source, (positions, values)
        return positions, values

    def steps(self, axis: int) -> list[float]:
        """Return the positions of a table as the program wrote them."""
        if axis not in self.arrays:
            raise Rejected(
                "range", f"axis {axis} has no cam table", f"write CAMTABLE({axis}, positions) first"
            )
        return elements(self.arrays[axis][0], "CAMTABLE")

    def lengths(self, axis: int) -> list[float]:
        """Return the travel of the master in each segment, in counts."""
        count, array = len(self.steps(axis)), self.arrays[axis][1]
        if array is None:
            return [distance(self.environment, axis, "CAM")[1]] * count
        per_unit = self.masters.of(axis).per_unit
        lengths = [length * per_unit for length in elements(array, "CAMTABLE")]
        if len(lengths) < count:
            words = f"the table of axis {axis} has {count} positions and {len(lengths)} lengths"
            raise Rejected("range", words, "give a length for each position")
        return lengths


# ----------------------------------------------------------------------------------------------- operations


def do_table(
    cams: Cams, row: Keyword, axis: int, positions: Array | None, lengths: Array | None, line: int
) -> None:
    """CAMTABLE: set the arrays of positions and lengths in user units, or clear both."""
    if positions is None:
        cams.arrays.pop(axis, None)
        return
    elements(positions, row.name)
    cams.arrays[axis] = positions, lengths


def put_cam(cams: Cams, row: Keyword, axis: int, mode: int, line: int) -> None:
    """CAM: follow the table once or continuously; each cycle reads the arrays again."""
    check(row, mode)
    found = cams.masters.of(axis)
    found.refuse(cams.environment, axis)
    first = int(cams.masters.setting("CAMSTART", axis)) - 1

    def table(start: float) -> tuple[list[float], list[float]]:
        return cams.table(axis, mode, start)

    cams.environment.controller.load_cam(
        axis, found.number, table, bool(mode & CONTINUOUS), first, found.encoder, row.name, line
    )
    cams.modes[axis] = mode


def bind_index(environment: Environment, row: Keyword) -> Operation:
    """CAMINDEX: make a reading of the executing segment, 0 without a cam."""
    controller = environment.controller

    def index(environment: Environment, axis: int, level: Level = None) -> int:
        return controller.cam_index(axis) + 1

    def until(axis: int, level: float | None = None) -> float:
        if level is None or abs(level) == INFINITY:
            return controller.cam_index_time(axis)
        return controller.cam_index_time(axis, ceil(level) - 1)

    return with_dependency(environment, of(Environment, index)(environment, row), until)


# ------------------------------------------------------------------------------------------------- keywords

_CAM_ACTIONS = Actions(read=of(Cams, lambda cams, axis: cams.modes.get(axis, 0)), load=loads(Cams, put_cam))

_MAX_VALUE = 8388607.0
_CAM = (
    "Dim rise(5) As Float = 4, 1, 2, 2, 1\nSPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
    "CAMTABLE(1, rise)\nMASTERDISTANCE(1) = 10\n{}CAM(1) = 0\nGO(1)\nMOVER(0) = 40\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(1)"
)


def setting_row(
    name: str,
    actions: str | Actions,
    unit: str,
    help: str,
    example: str,
    default: float,
    low: float,
    high: float,
) -> Keyword:
    """Return the row of a setting of a cam or a spline."""
    return Keyword(name, "", "setting", "RW", "axis", unit, actions, help, example, default=default, low=low,
                   high=high, group="tables")  # fmt: skip


def index_row(name: str, help: str, example: str, actions: Actions, solved: bool = False) -> Keyword:
    return Keyword(name, "", "reading", "R", "axis", "integer", actions, help, example, default=0.0,
                   group="tables", solved=solved)  # fmt: skip


def command_row(name: str, index: str, actions: Actions, help: str, example: str) -> Keyword:
    return Keyword(name, "", "command", "C", index, "", actions, help, example, group="motion")  # fmt: skip


ROWS = (
    command_row("CAMTABLE", "axis, array, array", Actions(do=of_word(Cams, do_table)),
             "Attach arrays to a cam: positions of each segment, and lengths of the master's way in it, without which "
             "MASTERDISTANCE is that of each. Element 1 is the number of segments.", _CAM.format("")),
    Keyword("CAM", "", "move", "RW", "axis", "integer", _CAM_ACTIONS,
            "Load a cam over the master; GO begins it where both axes then are. Bits: 0 positions count from its start "
            "and not from segment to segment, 1 they are those of the axis, 2 again and again.",
            _CAM.format(""), low=0, high=7, group="motion", effect="course follows"),
    setting_row("CAMSTART", MASTER_SETTING, "integer", "The first segment of a cam that is used.",
             _CAM.format("CAMSTART(1) = 2\n"), 1.0, 1, 16777215),
    setting_row("CAMEND", MASTER_SETTING, "integer",
             "The last segment of a cam that is used; 0 for the table's last.",
             _CAM.format("CAMEND(1) = 3\n"), 0.0, 0, 16777215),
    setting_row("CAMAMPLITUDE", MASTER_SETTING, "number", "Factor of the positions of a cam.",
             _CAM.format("CAMAMPLITUDE(1) = 2\n"), 1.0, -_MAX_VALUE, _MAX_VALUE),
    index_row("CAMINDEX", "The segment of the cam that is executing, 0 without a cam.",
           _CAM.format("") + "\nPRINT CAMINDEX(1)",
           Actions(read=bind_index), solved=True),
)  # fmt: skip
