"""The roles of the parts of a program: tasks that work, tasks beside the work, handlers and what starts them."""

from __future__ import annotations

from collections.abc import Iterable

from motionlang.kernel.lang import WRITE, Structure, Unit


def reached_in(structure: Structure, unit: Unit) -> frozenset[int]:
    """Return the statements of a unit, and of what it calls."""
    return frozenset(structure.points[point].at for point in structure.graph.reached(unit.entry)) - {-1}


def commands(structure: Structure, unit: Unit) -> bool:
    """True if a unit commands an axis, or switches an output."""
    statements = (structure.statements.get(at) for at in reached_in(structure, unit))
    return any(
        each is not None and (each.axes or any(use.access == WRITE for use in each.channels))
        for each in statements
    )


def triggers_of(units: Iterable[Unit]) -> set[int]:
    """Return the inputs whose changes start handlers."""
    return {
        int(each.number)
        for unit in units
        for each in unit.triggers
        if each.channel == "input" and each.number.isdecimal()
    }


def beside_work(structure: Structure) -> frozenset[int]:
    """Return the statements of the tasks beside the work: those that command no motion and wait for nothing but time.

    They blink, regulate or watch. If no task works, none is beside it.
    """
    points, graph = structure.points, structure.graph
    work = {
        at
        for at, each in structure.statements.items()
        if each.waits not in ("", "time") or any(use.row.topic == "move" for use in each.axes)
    }
    working: set[int] = set()
    others: set[int] = set()
    for task in structure.tasks():
        reached = {points[point].at for point in graph.reached(task.entry)}
        (others if reached.isdisjoint(work) else working).update(reached)
    return frozenset(others - working) if working else frozenset()
