"""The moves of a run: `run.moves[0].duration`, or a polars or pandas table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, overload

from motionlang.kernel.report_types import ReportMove, ReportMoveMotor, ReportPhase
from motionlang.kernel.result import Run
from motionlang.kernel.rows import RowTable, transposed
from motionlang.kernel.tools import in_notebook

# The columns of every table of moves, with their types; those of a simulated motor follow if there is one.
_TYPES: dict[str, type] = {
    "axis": int, "command": str, "line": int, "profile": str, "start_time": float, "duration": float, "start": float,
    "end": float, "distance": float, "peak_speed": float, "commanded_speed": float, "ended": str,
}  # fmt: skip
COLUMNS = tuple(_TYPES)


class Move:
    """A move that was started.

    `axis` and `line` are numbered as in the program. `start_time` and `duration` are seconds; `start`, `end` and
    `distance` are user units of the axis (uu), `peak_speed` and `commanded_speed` uu/s. `commanded_speed` is
    None for a path, a follower or a table. `ended` is the reason why the move was cut short, or "". `phases` are in
    chronological order, `motor` has the figures of a simulated motor, or is None.
    """

    __slots__ = (*COLUMNS, "_run", "motor", "phases")

    axis: int
    command: str
    line: int
    profile: str
    start_time: float
    duration: float
    start: float
    end: float
    distance: float
    peak_speed: float
    commanded_speed: float | None
    ended: str
    phases: list[ReportPhase]
    motor: ReportMoveMotor | None

    def __init__(self, row: ReportMove, run: Run) -> None:
        for name in COLUMNS:
            setattr(self, name, row.get(name))
        self.ended = row.get("ended", "")
        self.phases, self.motor, self._run = row["phases"], row.get("motor"), run

    def __repr__(self) -> str:
        ended = f", ended by {self.ended}" if self.ended else ""
        return (
            f"<Move: {self.command} of axis {self.axis}, line {self.line}, {self.start:g} to {self.end:g} uu "
            f"in {self.duration:g} s from {self.start_time:g} s{ended}>"
        )

    def _repr_html_(self) -> str:
        return in_notebook("move_html", self, self._run)


class Moves(RowTable, Sequence[Move]):
    """The moves of a run in order of start time.

    They can be converted to a table, with `to_polars` and `to_pandas`.
    """

    __slots__ = ("_rows", "_run")
    types = _TYPES

    def __init__(self, rows: list[ReportMove], run: Run) -> None:
        self._rows, self._run = rows, run

    def __len__(self) -> int:
        return len(self._rows)

    @overload
    def __getitem__(self, index: int) -> Move: ...
    @overload
    def __getitem__(self, index: slice) -> Moves: ...
    def __getitem__(self, index: int | slice) -> Move | Moves:
        if isinstance(index, slice):
            return Moves(self._rows[index], self._run)
        return Move(self._rows[index], self._run)

    def columns(self) -> dict[str, list[Any]]:
        """Return the columns by name.

        The fields of a move except its phases come first, followed by the figures of its motor.
        """
        rows = [
            {name: row.get(name) for name in COLUMNS}
            | {"ended": row.get("ended", "")}
            | dict(row.get("motor") or {})
            for row in self._rows
        ]
        return transposed(rows, COLUMNS)

    def __repr__(self) -> str:
        return f"<Moves: {len(self)} of {self._run.source.name}>"

    def _repr_html_(self) -> str:
        return in_notebook("moves_html", self, self._run)
