"""The behaviour that no edit may change: outcome, outputs, prints, and where its moves end.

The order of outputs and prints counts by task: a task that commands no axis, starts no other, and switches what no
other reads, such as one that blinks a lamp, runs beside the work. How often it blinks in a cycle does not count. Where
a homing search or a jog comes to rest does not count either, since the switch or the program's stop decides; what moves
from there counts.
"""

from __future__ import annotations

import re

from motionlang.kernel import Run
from motionlang.kernel.lang import READ, WRITE, Structure, Unit
from motionlang.kernel.log import GRAVE

# Positions are equal within this, user units.
SAME = 1e-6
_FIGURE = re.compile(r"[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")


class Behaviour:
    """The behaviour of a run; `beside` maps the lines of tasks beside the work to the names of these tasks."""

    def __init__(self, run: Run, beside: dict[int, str]) -> None:
        self._beside = beside
        self._status = run.status
        self._happened = self._by_task(run)
        self._moves = _moves(run)
        self._ends = _ends(run) if run.status == "ended" else {}
        self._grave = _grave(run)

    def difference(self, run: Run) -> str:
        """Return what another run does differently; "" if nothing that matters."""
        if run.status != self._status:
            errors = [each.message for each in run.diagnostics if each.severity == "error"]
            return errors[0] if errors else f"the run {run.status}, not {self._status}"
        if _grave(run) != self._grave:
            return "a limit, a fault or a clamp comes or goes"
        others = self._by_task(run)
        for task, happened in self._happened.items():
            for was, is_ in zip(happened, others.get(task, []), strict=False):
                if was != is_:
                    where = f" of {task}" if task else ""
                    return f"the order of outputs and prints{where}: {is_} in place of {was}"
        moved = _moves(run)
        for axis, moves in self._moves.items():
            for move, other in zip(moves, moved.get(axis, []), strict=False):
                if move[:2] != other[:2] or abs(move[2] - other[2]) > SAME:
                    return f"the move of line {move[1]} no longer ends at {move[2]:.6g}"
        if self._ends and any(abs(end - self._ends[axis]) > SAME for axis, end in _ends(run).items()):
            return "the final positions"
        return ""

    def _by_task(self, run: Run) -> dict[str, list[str]]:
        """Return outputs and prints in the order of time, by task beside the work; figures of prints do not count."""
        log, found, lines = run.machine.log, dict[str, list[str]](), {-1: 0}
        spans = _spans(run)
        records = [
            (each.time, 0, each.at, f"output {each.channel} = {each.value}{_moving(spans, each.time)}")
            for each in log.outputs
        ]
        records += [(each.time, 1, each.at, repr(_FIGURE.sub("#", each.text).strip())) for each in log.prints]
        for _, _, at, text in sorted(records, key=lambda each: each[:2]):
            if at not in lines:
                lines[at] = run.dialect.locate(run.source, at)[0]
            found.setdefault(self._beside.get(lines[at], ""), []).append(text)
        return found


def _moves(run: Run) -> dict[int, list[tuple[str, int, float]]]:
    """Return command, line and end of the moves that were over, by axis; an end that does not count is 0."""
    found: dict[int, list[tuple[str, int, float]]] = {}
    table = run.dialect.table()
    for move in run.machine.log.moves:
        if move.profile is None or move.start_time + move.profile.duration > run.time:
            continue
        counts = not move.ended and not table.homes(move.command)
        end = move.to_user(move.profile.end) if counts else 0.0
        found.setdefault(move.axis, []).append((move.command, move.line, end))
    return found


def _spans(run: Run) -> dict[int, list[tuple[float, float]]]:
    """Return when each axis begins and ends to move, without its homing."""
    found: dict[int, list[tuple[float, float]]] = {}
    table = run.dialect.table()
    for move in run.machine.log.moves:
        if move.profile is not None and not table.homes(move.command):
            end = move.start_time + move.profile.duration
            found.setdefault(move.axis, []).append((move.start_time, end))
    return found


def _moving(spans: dict[int, list[tuple[float, float]]], time: float) -> str:
    """Return which axes move at a time, in words."""
    axes = [axis for axis, times in sorted(spans.items()) if any(a < time < b for a, b in times)]
    return f" while axis {', '.join(map(str, axes))} moves" if axes else ""


def _ends(run: Run) -> dict[int, float]:
    axes = run.controller.axes.values()
    moved = {move.axis for move in run.machine.log.moves}
    return {a.index: a.scale.position_to_user(a.position(run.time)) for a in axes if a.index in moved}


def _grave(run: Run) -> list[str]:
    return sorted({f"{each.kind} {each.axis}" for each in run.machine.log.events if each.kind in GRAVE})


# ------------------------------------------------------------------------------------------ tasks beside the work


def lines_beside(structure: Structure) -> dict[int, str]:
    """Return the lines of tasks that run beside the work, with the names of these tasks."""
    started = {name.lower() for each in structure.statements.values() for name in each.starts}
    tasks = [
        unit
        for unit in structure.units
        if unit.kind == "task" or (unit.kind == "macro" and unit.name.lower() in started)
    ]
    others = [unit for unit in structure.units if unit not in tasks and unit.kind in ("program", "event")]
    work = {at for unit in others for at in _reached(structure, unit)}
    found: dict[int, str] = {}
    for task in tasks:
        rest = work.union(*(_reached(structure, each) for each in tasks if each is not task))
        own = _reached(structure, task)
        if own and not own & rest and _is_beside(structure, own, set(structure.statements) - own):
            found |= dict.fromkeys(map(structure.line, own), task.title)
    return found


def _reached(structure: Structure, unit: Unit) -> set[int]:
    """Return the offsets of the statements that a unit reaches, also through calls."""
    points = structure.points
    return {points[p].at for p in structure.graph.reached(unit.entry)} - {-1}


def _is_beside(structure: Structure, own: set[int], rest: set[int]) -> bool:
    """True if statements command no axis, start no task, and switch nothing that the others read."""
    mine = [structure.statements[at] for at in own if at in structure.statements]
    if any(each.axes or each.starts or each.ends for each in mine):
        return False
    written = {use.number for each in mine for use in each.channels if use.access != READ}
    read = {use.number for at in rest for use in structure.statements[at].channels if use.access != WRITE}
    return "?" not in written | read and not written & read
