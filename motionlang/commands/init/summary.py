"""Lines for the engineer about a run with guesses: which input ended which wait, and what never happened."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from motionlang.commands.init import Guesses
from motionlang.commands.init.ending import ending
from motionlang.commands.init.file import inline
from motionlang.commands.map.program_map import channels_of, names_in_comments
from motionlang.commands.worlds import TABLES, Worlds, entries
from motionlang.kernel import Run
from motionlang.kernel.lang import WRITE, InputRead, Structure
from motionlang.kernel.tools import count_of


def first_move(structure: Structure) -> int:
    """Return the first line that commands motion; 0 if there is none."""
    return min(_move_lines(structure), default=0)


def _move_lines(structure: Structure) -> set[int]:
    return {
        each.line
        for each in structure.statements.values()
        if any(use.row.topic == "move" for use in each.axes)
    }


def motionless(structure: Structure, result: Run) -> bool:
    """True if no axis moved although the program commands motion."""
    return bool(first_move(structure)) and not len(result.machine.log.moves)


def notes(structure: Structure, guesses: Guesses, worlds: Worlds, result: Run) -> list[str]:
    """Return one line for each thing that an engineer checks first."""
    found = _ended_waits(guesses, worlds.reads, result)
    never = _never_on(structure, result)
    if never:
        plural = len(never) > 1
        numbers = ", ".join(map(str, never))
        found.append(
            f"output{'s' if plural else ''} {numbers} {'were' if plural else 'was'} never switched on"
        )
    cycles = ending(result)
    if "prints" in cycles:
        found.append(f'{cycles["times"]} cycles ran, each of which prints "{cycles["prints"]}"')
    elif "line" in cycles:
        found.append(f"{cycles['times']} cycles began, in each of which line {cycles['line']} moves an axis")
    found += _unmoved(structure, guesses, worlds.reads, result)
    found += _unused(result)
    if motionless(structure, result):
        found.append(f"no axis moved, and line {first_move(structure)} commands motion")
    if worlds.is_over or (worlds.count > 1 and motionless(structure, result)):
        found.append(tried(worlds, guesses.settings(0.0)))
    return found


def _unmoved(structure: Structure, guesses: Guesses, reads: list[InputRead], result: Run) -> list[str]:
    """Return the lines that command motion and moved no axis, with the inputs that never changed."""
    lines = sorted(_move_lines(structure) - {each.line for each in result.machine.log.moves})
    still: dict[int, set[int]] = {}
    for each in reads:
        if each.is_input and each.channel is not None and each.channel not in guesses.inputs:
            still.setdefault(each.channel, set()).add(each.line)
    if not lines or not len(result.machine.log.moves):
        return []
    kept = "; ".join(f"input {each} ({_lines(still[each])})" for each in sorted(still))
    verb = "commands" if len(lines) == 1 else "command"
    text = f"{_lines(lines)} {verb} motion and moved no axis"
    return [f"{text}; unchanged so far: {kept}" if kept else text]


def _unused(result: Run) -> list[str]:
    """Return the inputs and outputs that comments name and the program does not use.

    A channel whose number is only known while the program runs may be any of its kind.
    """
    program = result.program or result.dialect.program(result.source)
    used = channels_of(program, result.dialect)
    known = {(each.kind, each.number) for each in used}
    open_ended = {each.kind for each in used if not each.number.isdecimal()}
    return [
        f"{each.kind} {each.number} ({each.name}): named in the comment of line {each.line}, never used"
        for each in names_in_comments(result.source, result.dialect)
        if each.kind in ("input", "output")
        and each.kind not in open_ended
        and (each.kind, str(each.number)) not in known
    ]


def tried(worlds: Worlds, kept: Mapping[str, object]) -> str:
    """Return how many worlds a search has tried, and what was new in the last one."""
    text = f"{count_of(worlds.count, 'world')} tried"
    if worlds.is_over:
        text += f" until the {worlds.seconds:.10g} s of --seconds were over"
    for table in TABLES:
        new = [inline(each) for each in entries(worlds.last, table) if each not in entries(kept, table)]
        if new:
            text += f"; the last one had {table} = [{', '.join(new)}]"
    return text


def _ended_waits(guesses: Guesses, reads: list[InputRead], result: Run) -> list[str]:
    waits: dict[int, set[int]] = {}
    for read in reads:
        if read.kind == "wait" and read.channel in guesses.inputs:
            waits.setdefault(read.line, set()).add(read.channel)
    ended: dict[int, set[int]] = {}
    for wait in result.machine.log.waits.written():
        line = guesses.line(result, wait.at)
        for channel in waits.get(line, ()):
            ended.setdefault(channel, set()).add(line)
    return [
        f"input {each} ended the {'wait' if len(ended[each]) == 1 else 'waits'} of {_lines(ended[each])}"
        for each in sorted(ended)
    ]


def _lines(lines: Iterable[int]) -> str:
    numbers = sorted(lines)
    return f"{'line' if len(numbers) == 1 else 'lines'} {', '.join(map(str, numbers))}"


def _never_on(structure: Structure, result: Run) -> list[int]:
    """Return the outputs that the program switches and that stayed off."""
    switched = {
        int(use.number)
        for each in structure.statements.values()
        for use in each.channels
        if use.channel == "output" and use.access == WRITE and use.value != "0" and use.number.isdecimal()
    }
    return sorted(switched - {each.channel for each in result.machine.log.outputs if each.value})
