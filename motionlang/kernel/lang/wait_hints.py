"""Hints for a wait that nothing can end: `--input 2=1@0.5`, GO, STOP.

The wait itself may state its purpose; if it does not, the condition at its source offset is analysed.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.lang.dialect import Dialect
from motionlang.kernel.lang.keyword import BANK
from motionlang.kernel.lang.program import Program
from motionlang.kernel.lang.task import Task

if TYPE_CHECKING:
    from motionlang.kernel.lang.machine.machine import Machine
    from motionlang.kernel.lang.structure import ChannelUse
    from motionlang.kernel.lang.wait_causes import Read
    from motionlang.kernel.lang.waits import Wait

# Seconds from now at which the suggested option acts.
SOON = 0.5
# A hint names so many inputs.
MAX_NAMED = 3
# The levels and the keys that are tried.
LEVELS = range(101)
# The kinds of readings that a motion can change.
_OF_AXES = ("axis", "position", "following")
KEYS = (*map(chr, range(33, 127)), "\r", "\x1b", "\t")


def what_ends(
    dialect: Dialect,
    program: Program | None,
    machine: Machine,
    task: Task,
    wait: Wait,
    at_prompt: bool = False,
) -> str:
    """Return a hint with the option to type, or "" if no option ends the wait.

    `at_prompt` is for the interactive prompt, whose commands have the names of the options and count time
    from now.
    """
    dash, now = (".", 0.0) if at_prompt else ("--", machine.clock.now)
    at = f"{round(now + SOON, 1):.10g}"
    driven = dialect.driven_by(wait.why)
    leaves = _reads(program, task, wait)
    latches = [number for kind, number in leaves if kind == "latch" and number is not None]
    unarmed = ""
    if latches:
        triggers, unarmed = dialect.triggers(task, latches)
        leaves |= triggers
    channels = sorted(number for kind, number in leaves if kind == "input" and number is not None)
    levels = dict(machine.controller.inputs.values)
    if not channels and driven == ["input"]:
        channels = _of_bank(program, machine, task, wait)
    options = []
    is_known = True
    if channels:
        ways = (way for count in range(1, MAX_NAMED + 1) for way in combinations(channels, count))
        ending = next((way for way in ways if _would_end(machine, wait, way)), None)
        is_known, channels = bool(ending or latches), list(ending or channels)
        options += [
            f"{dash}input {each}={int(not levels.get(each, 0))}@{at}" for each in channels[:MAX_NAMED]
        ]
        driven = driven or ["input"]
    if wait.cause == "operator":
        question = machine.operator.question.strip(" ?:")
        options.append(f'{dash}answer "{question}=1"' if question else f"{dash}answer 1")
        driven = ["answer"]
    elif "key" in driven:
        key = _key_that_ends(machine, wait)
        is_known = key is not None
        options = [*([] if is_known else options), f"{dash}keys {key or 'R'}@{at}"]
    elif "analogue" in driven:
        channel = next((n for kind, n in leaves if kind == "analogue" and n is not None), 0)
        level = _level_that_ends(machine, wait, channel)
        is_known = level is not None
        options = [
            *([] if is_known else options),
            f"{dash}analog {channel}={25 if level is None else level}@{at}",
        ]
    if is_known and len(options) == 1 and {"key", "analogue"} & set(driven):
        driven = [each for each in driven if each != "input"]
    if unarmed and not options:
        return unarmed
    entries = " or ".join(each if "." in each else f"[[{each}]]" for each in driven)
    if options:
        # A key or a level of which the wait does not end is an example: the program may wait for another one.
        verb = "end" if is_known else "change"
        verb += "s" * (len(options) == 1)
        return f"{' '.join(options)} {verb} it, as does {entries} of the machine file"
    if any("." in each for each in driven):
        for axis in (int(each.split(".")[1]) for each in driven if each.startswith("axis.")):
            if machine.controller.axes[axis].move is None:
                edge = "edge" if driven[0].endswith("switch") else "mark"
                return f"axis {axis} does not move and never finds the {edge}: start it before the search"
        return f"the machine file says where it is: {entries}"
    return f"{entries} of the machine file says when it comes" if entries else ""


def _of_bank(program: Program | None, machine: Machine, task: Task, wait: Wait) -> list[int]:
    """Return one or two inputs of a bank whose changes end a wait; none if it takes more."""
    made = None if program is None else program.structure.statements.get(task.at)
    read = [] if made is None else [use.number for use in made.channels if use.channel == "input bank"]
    banks = sorted({int(number) for number in read if number.isdecimal()})
    channels = [bank * BANK + k for bank in banks for k in range(BANK)]
    ways = (way for count in (1, 2) for way in combinations(channels, count))
    return list(next((way for way in ways if _would_end(machine, wait, way)), ()))


def _would_end(machine: Machine, wait: Wait, channels: Iterable[int]) -> bool:
    """True if a wait were over with some inputs changed."""
    inputs = machine.controller.inputs
    with inputs.supposing({each: 1 - inputs.present(each) for each in channels}):
        return wait.ready()


def _level_that_ends(machine: Machine, wait: Wait, channel: int) -> int | None:
    """Return the level of an analogue input, in percent, that ends a wait, the nearest multiple of 5 if one does."""
    controller = machine.controller
    present = controller.analogue_inputs.present(channel)
    for level in sorted(LEVELS, key=lambda each: (each % 5 != 0, abs(each - present))):
        with controller.inputs.supposing({}), controller.analogue_inputs.supposing({channel: level}):
            if wait.ready():
                return int(level)
    return None


def _key_that_ends(machine: Machine, wait: Wait) -> str | None:
    """Return the key that ends a wait, as the option has it; None if no single key does."""
    operator = machine.operator
    before = operator.keys
    try:
        for key in KEYS:
            operator.keys = [ord(key)]
            with machine.controller.inputs.supposing({}):
                if wait.ready():
                    return operator.typed(ord(key))
    finally:
        operator.keys = before
    return None


def what_frees(dialect: Dialect, program: Program | None, machine: Machine, task: Task, wait: Wait) -> str:
    """Return a hint about what a wait lacks, such as a GO; "" if there is none."""
    if wait.cause == "axis":
        axes = [("axis", number) for number in wait.what]
    else:
        if wait.why == "for its loop to end":
            return dialect.ends_loops
        leaves = _reads(program, task, wait)
        if not leaves and _is_of_program(program, task):
            return f"let {dialect.others} change it: this task does nothing while it waits"
        axes = sorted((kind, n) for kind, n in leaves if kind in _OF_AXES and n is not None)
    found = next(filter(None, (_frees(program, machine.controller, *each) for each in axes)), "")
    return found or _raises(program, machine)


def _is_of_program(program: Program | None, task: Task) -> bool:
    """Return True if a task waits for a condition that the program states."""
    return program is not None and program.structure.waits.at(task.at) is not None


def _raises(program: Program | None, machine: Machine) -> str:
    """Return the option that calls a handler of an input; "" if there is none."""
    units = [] if program is None else program.structure.units
    triggers = [(unit.line, int(each.number)) for unit in units for each in unit.triggers if _is_input(each)]
    if not triggers:
        return ""
    line, channel = triggers[0]
    level, at = 1 - machine.controller.inputs[channel], round(machine.clock.now + SOON, 1)
    option = f"--input {channel}={level:.10g}@{at:.10g}"
    return f"{option} calls the handler in line {line}, as does [[input]] of the machine file"


def _is_input(use: ChannelUse) -> bool:
    """True for the use of a digital input with a known number."""
    return use.channel == "input" and use.number.isdecimal()


def _frees(program: Program | None, controller: Controller, kind: str, axis: int) -> str:
    a = controller.axes[axis]
    if kind == "following" and a.feedback is None:
        return (
            f"axis {axis} has no motor and no following error: [axis.{axis}.plant] of the machine file is one"
        )
    if a.suspended and (a.move is not None or a.buffer):
        return f"resume axis {axis} first: it is suspended"
    if a.move is None and a.buffer and not a.buffer[0].released:
        return f"write GO({axis}) first: it starts the buffered moves"
    if a.move is not None and not a.speed_and_rates(a.move)[0]:
        at = a.zeroed_at
        since = f" since line {program.source.location(at)[0]}" if at >= 0 and program is not None else ""
        return f"set the speed of axis {axis} above 0 first: it is 0{since}, and the move holds"
    end = a.scale.position_to_user(a.target)
    if kind == "axis":
        return f"stop axis {axis} first: it runs without an end" if abs(end) == INFINITY else ""
    if abs(end) == INFINITY:
        return f"axis {axis} runs without an end and never gets there: check its direction"
    return f"axis {axis} stops at {end:.10g}" if len(a.starts) > 1 else ""


def _reads(program: Program | None, task: Task, wait: Wait) -> frozenset[Read]:
    if wait.cause == "input" and wait.what:
        return frozenset(("input", channel) for channel in wait.what)
    if program is None:
        return frozenset()
    offsets = [task.at, *(at for at, _, _ in reversed(task.loops))]
    found = next(filter(None, map(program.structure.waits.at, offsets)), None)
    return frozenset() if found is None else found.leaves
