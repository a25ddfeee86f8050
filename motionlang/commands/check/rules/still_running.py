"""A command needs an axis at rest that runs in velocity mode, which nothing has stopped.

The lines are followed in their order. Behind a line that may continue elsewhere nothing is known to run. There is one
warning each time the axis runs.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.commands.check.mccl.verbs import ELSEWHERE, POSITIONING, WAITS
from motionlang.commands.check.rule import Case, Rule, Warn

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.facts import MacroFacts
    from motionlang.kernel.mccl import Command

# The shapes of moves, and the name of those that start at rest.
_SHAPES = {"shape_trapezoid": "", "shape_scurve": "S-curve", "shape_parabolic": "parabola"}
_STOPS = frozenset({"stop", "abort", "motor_off", "reset"})


@dataclass
class _Axis:
    """What is known of an axis at a command."""

    velocity_mode: bool = False
    running: bool = False
    shape: str = ""


def check(facts: MacroFacts, warn: Warn) -> None:
    axes: dict[int, _Axis] = {}
    for line in facts.lines:
        if any(command.verb in ELSEWHERE for command in line.commands):
            for axis in axes.values():
                axis.running = False
            continue
        for command, at in zip(line.commands, line.offsets, strict=True):
            for number in list(axes) if command.axis == 0 else [command.axis]:
                axis = axes.setdefault(number, _Axis())
                if axis.running and command.verb in WAITS:
                    axis.running = False
                    what = f"axis {number} runs in velocity mode until it is stopped"
                    warn(f"{command.text} never ends: {what}", at, f"{number}ST first")
                elif axis.running and command.verb in POSITIONING and not axis.velocity_mode:
                    axis.running = False
                    if axis.shape:
                        rest = f"{number}ST,{number}WS first, or {number}PT for a trapezoid"
                        warn(
                            f"{command.text} is rejected: axis {number} still runs in velocity mode",
                            at,
                            f"with {axis.shape}, a move starts at rest: {rest}",
                        )
                _follow(axis, command)


def _follow(axis: _Axis, command: Command) -> None:
    """Record what a command changes."""
    verb = command.verb
    if verb in _SHAPES:
        axis.shape = _SHAPES[verb]
    elif verb in ("velocity_mode", "position_mode"):
        axis.velocity_mode = verb == "velocity_mode"
    elif verb == "go":
        axis.running = axis.running or axis.velocity_mode
    elif verb in _STOPS:
        axis.running = False


RULE = Rule(
    code="still-running",
    group="Motion",
    text="""\
An axis runs in velocity mode (VM, GO) and has not been stopped, and then a WS or WT waits for it to come to rest, or a
position move needs it at rest. A move with an S-curve or parabolic profile starts from rest and is rejected. Lines that
jump, and macros, are not analysed.
""",
    fix="stop the axis with ST before you wait for it",
    mccl=Case(
        check,
        wrong="1MN,1VM,1GO\n1WS\n",
        right="1MN,1VM,1GO\n1ST,1WS\n",
    ),
)
