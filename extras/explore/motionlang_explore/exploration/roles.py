"""The roles of the parts of a program: tasks that work or stand beside, handlers, channels that it writes."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping

from motionlang.kernel import Program
from motionlang.kernel.lang import DRIVES, SET_UP, WRITE, ChannelUse, Structure, Unit
from motionlang_explore.exploration.changes import REGISTERS, WHOLE, Channel

# The tables of what has more than two levels, by the device that a statement reads.
_TABLES = {DRIVES[table][0]: table for table in ("key", "analogue", "comms", *WHOLE)}


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


def numbers_that_start(units: Iterable[Unit]) -> set[Channel]:
    """Return the channels with more than two levels that start handlers, such as elements that a host writes."""
    found = (_channel_of(each) for unit in units for each in unit.triggers)
    return {each for each in found if each is not None}


def beside_work(structure: Structure) -> frozenset[int]:
    """Return the statements of the tasks beside the work: those that command no motion and wait for nothing but time.

    They blink, regulate or watch, as timers do. One that sets what alone another task waits for leads the work. If no
    task works, none is beside it.
    """
    points, graph, statements = structure.points, structure.graph, structure.statements
    works = {at for at, each in statements.items() if each.waits not in ("", "time") or each.moves}
    uses = [(points[p].at, use) for p, use in enumerate(graph.uses) if use is not None]
    alone = {at for at in works if not (statements[at].moves or statements[at].channels)}
    waited = set[int]().union(*(use.reads for at, use in uses if at in alone and len(use.reads) == 1))
    works |= {at for at, use in uses if waited.intersection(each for each in use.sets if each >= 0)}
    timed = (unit for unit in structure.units if unit.is_timed)
    reached = [{points[p].at for p in graph.reached(task.entry)} for task in (*structure.tasks(), *timed)]
    working, others = set[int](), set[int]()
    for each in reached:
        (others if works.isdisjoint(each) else working).update(each)
    return frozenset(others - working) if working else frozenset()


def written_at(program: Program) -> dict[int, set[Channel]]:
    """Return the channels with more than two levels that statements write and do not read, by source offset."""
    found: dict[int, set[Channel]] = {}
    for at, each in program.structure.statements.items():
        uses = [(use.access == "read", _channel_of(use)) for use in each.channels]
        read = {channel for is_read, channel in uses if is_read}
        found[at] = {channel for is_read, channel in uses if channel is not None and not is_read} - read
    return {at: channels for at, channels in found.items() if channels}


def given_inputs(structure: Structure) -> Mapping[str, set[int]]:
    """Return the inputs that a program gives to its axes and latches, by the group of the keyword; "" for a latch."""
    found: defaultdict[str, set[int]] = defaultdict(set)
    for each in structure.statements.values():
        group = next((axis.row.group for axis in each.axes if axis.row.group != "latches"), "")
        for use in each.channels:
            if (use.channel, use.access) == ("input", SET_UP) and use.number.isdecimal():
                found[group].add(int(use.number))
    return found


def encoders_read(structure: Structure) -> set[int]:
    """Return the encoders that a program reads, but for those of the axes that it commands."""
    statements = structure.statements.values()
    read = {
        int(use.number)
        for each in statements
        for use in each.channels
        if (use.channel, use.access) == ("encoder", "read") and use.number.isdecimal()
    }
    return read - {use.axis for each in statements for use in each.axes}


def _channel_of(use: ChannelUse) -> Channel | None:
    """Return the channel with more than two levels that a statement uses, None if its number is unknown."""
    table = _TABLES.get(use.channel, "")
    number = _number_of(table, use.number) if table else None
    return None if number is None else (table, number)


def _number_of(table: str, text: str) -> int | None:
    """Return the number of a channel from the text of a program, such as "1, 5" for a register of a server."""
    numbers = [int(each) for each in text.split(", ") if each.isdecimal()]
    if table == "key" or len(numbers) != (2 if table == "modbus.register" else 1):
        return None
    return numbers[0] * REGISTERS + numbers[1] if table == "modbus.register" else numbers[0]
