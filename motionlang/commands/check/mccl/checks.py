"""The linter of MCCL.

It reports commands that never run, motors never switched on, axes that never stop, and waits that never end.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from motionlang.commands.check.mccl.equalities import exact_positions
from motionlang.commands.check.mccl.loops import endless_lines
from motionlang.commands.check.mccl.running import running_axes
from motionlang.kernel.lang import Structure
from motionlang.kernel.mccl import Command, Fault, Line
from motionlang.kernel.mccl.resolve.flow import Flow

Add = Callable[[int, Fault], None]

_MOVES = frozenset(
    {
        "move_to", "move_by", "go_home", "go", "move_to_point", "find_index", "find_edge", "path", "slave", "jog_on",
    }
)  # fmt: skip
# Commands that select a mode whose motion GO starts.
_STARTED = frozenset({"velocity_mode", "contour_mode"})
_WAITS = frozenset({"wait_stop", "wait_target"})
# Commands after which a line does not continue, and those that jump within it.
_LEAVES = frozenset({"jump_macro", "leave"})
_REPEATS = frozenset({"repeat", "jump", "jump_by"})
# Verbs that need a defined macro.
CALLS = frozenset({"call_macro", "jump_macro", "start_task"})


def lint(lines: list[Line], structure: Structure, flow: Flow, add: Add) -> None:
    """Call `add` with the offset and warning of each suspicious construct.

    The file must have no errors.
    """
    _unreached(lines, structure, add)
    _motors(lines, add)
    _waits(lines, add)
    running_axes(lines, add)
    endless_lines(lines, flow, add)
    exact_positions(lines, add)
    _starts(lines, add)


def _is_macro(line: Line) -> bool:
    return line.commands[0].verb == "define_macro"


def _unreachable(why: str, what: str = "command") -> Fault:
    return Fault(0, f"this {what} can never run: {why}", "", "unreachable")


# ---------------------------------------------------------------------------------------- unreachable commands


def _unreached(lines: list[Line], structure: Structure, add: Add) -> None:
    """Warn of the first line, or the first command of a line, of each stretch that nothing leads to."""
    graph = structure.graph
    reached = {graph.points[p].at for p in graph.reached(*(unit.entry for unit in structure.units))}
    is_reported = False
    for line in lines:
        if line.offsets[0] in reached:
            is_reported = is_reported and _is_macro(line)
            _unreached_commands(line, reached, add)
        elif not is_reported:
            is_reported = True
            add(line.offsets[0], _unreachable("the line before repeats forever", "line"))


def _unreached_commands(line: Line, reached: set[int], add: Add) -> None:
    is_reported = False
    for k, (command, at) in enumerate(zip(line.commands, line.offsets, strict=True)):
        if at in reached or command.verb == "nothing":
            is_reported = is_reported and at not in reached
        elif not is_reported:
            is_reported = True
            add(at, _unreachable(_reason(line, k)))


def _reason(line: Line, k: int) -> str:
    # The first command runs, so there is one between that does not lead to the next.
    before = next(command for command in reversed(line.commands[:k]) if command.verb in _REPEATS | _LEAVES)
    if before.verb == "repeat":
        return f"{before.text} repeats the commands before it forever"
    return f"{before.text} always jumps elsewhere"


# ------------------------------------------------------------------------------------------------------ motors


def _motors(lines: list[Line], add: Add) -> None:
    """Warn, once per axis, of moves of an axis that the file never switches on."""
    on = {command.axis for command, _ in _commands(lines) if command.verb == "motor_on"}
    reported: set[int] = set()
    for command, at in _commands(lines):
        if command.verb not in _MOVES or command.axis in reported:
            continue
        if not on if command.axis == 0 else not on & {0, command.axis}:
            reported.add(command.axis)
            which = "an axis" if command.axis == 0 else f"axis {command.axis}"
            number = command.axis or ""
            add(at, Fault(0, f"no line of this file switches {which} on", f"{number}MN does", "motor-off"))


def _starts(lines: list[Line], add: Add) -> None:
    """Warn of each GO of an axis for which the file never selects a mode that uses GO."""
    modes = {command.axis for command, _ in _commands(lines) if command.verb in _STARTED}
    for command, at in _commands(lines):
        if command.verb == "go" and not modes & {0, command.axis} and (command.axis or not modes):
            message = f"{command.text} starts nothing: no line of this file selects velocity mode"
            number = command.axis or ""
            add(at, Fault(0, message, f"{number}VM before it, or MA or MR for a move", "nothing-loaded"))


def _commands(lines: list[Line]) -> Iterator[tuple[Command, int]]:
    for line in lines:
        yield from zip(line.commands, line.offsets, strict=True)


# ------------------------------------------------------------------------------------------------------- waits


def _waits(lines: list[Line], add: Add) -> None:
    """Warn of WS and WT in the foreground before any motion of the axis."""
    bodies = {line.commands[0].number: line for line in lines if _is_macro(line)}
    moved: set[int] = set()
    for line in lines:
        if _is_macro(line):
            continue
        repeats = any(command.verb in _REPEATS for command in line.commands)
        if repeats:
            moved |= _moved(line, bodies, set())
        for command, at in zip(line.commands, line.offsets, strict=True):
            if command.verb in _WAITS and 0 not in moved and not _has_moved(command, moved):
                message = f"{command.text} waits for the end of a move, and nothing has moved yet"
                add(at, Fault(0, message, "move first, as in 1MR1000,1WS", "nothing-to-wait-for"))
            moved |= _moved_by(command, bodies, set())


def _has_moved(command: Command, moved: set[int]) -> bool:
    return bool(moved) if command.axis == 0 else command.axis in moved


def _moved(line: Line, bodies: dict[int | None, Line], seen: set[int]) -> set[int]:
    """Return the axes that a line moves; 0 means all axes or an unknown one."""
    return {axis for command in line.commands for axis in _moved_by(command, bodies, seen)}


def _moved_by(command: Command, bodies: dict[int | None, Line], seen: set[int]) -> set[int]:
    verb = command.verb
    if verb in _MOVES:
        return {command.axis}
    if verb not in CALLS:
        return set()
    body = bodies.get(command.number)
    if body is None or command.number is None:
        return {0}
    if command.number in seen:
        return set()
    seen.add(command.number)
    return _moved(body, bodies, seen)
