"""The tasks and handlers of a program: the lines of each, and which of them read what another one sets.

A task that reads nothing of another one, such as one that blinks a lamp, only shares the controller with it. One that
waits for a variable, an output, an input that follows an output, or the position of an axis of another task works with
it.
"""

from __future__ import annotations

from collections.abc import Iterable

from motionlang.commands.channels import channels_of
from motionlang.kernel import Run
from motionlang.kernel.lang import Structure
from motionlang_explore.map.units import variables


class Tasks:
    """The tasks and handlers of a run. `cycle` are the lines that the run repeats, none if it repeats nothing."""

    def __init__(self, run: Run, cycle: Iterable[int]) -> None:
        assert run.program is not None
        self._lines = run.program.structure.owners()
        structure = run.program.structure
        for unit in structure.units:
            if unit.kind == "event":
                for line in _lines(structure, unit.entry):
                    self._lines.setdefault(line, unit.title)
        moved: dict[int, set[str]] = {}
        for move in run.machine.log.moves:
            moved.setdefault(move.axis, set()).add(self.at(move.line))
        self._pairs: set[tuple[str, str]] = set()
        channels = {(each.kind, each.number): each for each in channels_of(run.program, run.dialect)}
        for variable in variables(structure, run.program.names.definitions, ()):
            self._reads(variable.reads, map(self.at, variable.writes))
        for channel in channels.values():
            self._reads([*channel.reads, *channel.waits], map(self.at, channel.writes))
        entries: list[dict[str, object]] = run.machine.settings.get("input", [])  # type: ignore[assignment]
        for entry in entries:
            source = channels.get(("output", str(entry.get("output"))))
            follower = channels.get(("input", str(entry["channel"])))
            if source is not None and follower is not None:
                self._reads([*follower.reads, *follower.waits], map(self.at, source.writes))
                self._triggers(structure, str(entry["channel"]), map(self.at, source.writes))
        repeated = range(min(cycle, default=0), max(cycle, default=-1) + 1)
        titles = {name.lower(): unit.title for unit in structure.units for name in (unit.name, unit.title)}
        for each in structure.statements.values():
            read = {axis for use in each.uses if use.role == "read" for axis in use.axes} | set(each.what)
            for axis in read:
                self._reads([each.line], moved.get(axis, ()) if isinstance(axis, int) else ())
            for name in each.starts:
                if each.line in repeated and name.lower() in titles:
                    self._pairs.add((titles[name.lower()], self.at(each.line)))

    def at(self, line: int) -> str:
        """Return the task or handler that carries out a line."""
        return self._lines.get(line, "")

    def reads(self, task: str, other: str) -> bool:
        """True if a task reads something that another one sets."""
        return (task, other) in self._pairs

    def _reads(self, lines: Iterable[int], setters: Iterable[str]) -> None:
        others = set(setters)
        self._pairs |= {(self.at(line), other) for line in lines for other in others}

    def _triggers(self, structure: Structure, channel: str, setters: Iterable[str]) -> None:
        others = set(setters)
        for unit in structure.units:
            if any(use.channel == "input" and use.number == channel for use in unit.triggers):
                self._pairs |= {(unit.title, other) for other in others}


def _lines(structure: Structure, entry: int) -> set[int]:
    """Return the lines that a unit reaches, also through calls."""
    points = structure.points
    found = (structure.statements.get(points[p].at) for p in structure.graph.reached(entry))
    return {each.line for each in found if each is not None}
