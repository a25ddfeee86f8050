"""Checks of axes in motion: velocity mode without a stop, and waits beyond a move.

Commands are reported that need an axis at rest while it runs, and a WR for a longer distance than the axis's
move.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from motionlang.kernel.mccl import NUMBER, Command, Fault, Line

Add = Callable[[int, Fault], None]

_SHAPES = {"shape_trapezoid": "", "shape_scurve": "S-curve", "shape_parabolic": "parabola"}
_MOVES = frozenset({"move_to", "move_by", "go_home", "move_to_point"})
_WAITS = frozenset({"wait_stop", "wait_target"})
_STOPS = frozenset({"stop", "abort", "motor_off", "reset"})
# Commands that change neither the target nor the position of an axis.
_HARMLESS = frozenset({"motor_on", "position_mode", *_SHAPES})
# A line with one of these may continue anywhere, and macros are not followed, so the state after it is
# unknown.
_ELSEWHERE = frozenset(
    {
        "define_macro", "repeat", "jump", "jump_by", "call_macro", "jump_macro", "start_task", "leave", "if_below",
        "if_equal", "if_greater", "if_unequal", "if_set", "if_clear", "if_on", "if_off", "do_if_on", "do_if_off",
    }
)  # fmt: skip


class _Axis:
    """The state of an axis at the current position in the file."""

    def __init__(self) -> None:
        self.velocity_mode = self.running = False
        self.shape = ""
        # The distance of the only move since the axis was last at rest, None if unknown.
        self.distance: float | None = 0.0


def running_axes(lines: Iterable[Line], add: Add) -> None:
    """Warn of rejected moves and endless waits due to an axis that keeps running.

    There is one warning each time the axis runs.
    """
    axes: dict[int, _Axis] = {}
    for line in lines:
        if any(command.verb in _ELSEWHERE for command in line.commands):
            for axis in axes.values():
                axis.running, axis.distance = False, None
            continue
        for command, at in zip(line.commands, line.offsets, strict=True):
            for number in _named(command, axes):
                axis = axes.setdefault(number, _Axis())
                fault = _after(axis, number, command) or _waits_too_far(axis, number, command)
                if fault is not None:
                    add(at, fault)


def _named(command: Command, axes: dict[int, _Axis]) -> list[int]:
    return list(axes) if command.axis == 0 else [command.axis]


def _after(axis: _Axis, number: int, command: Command) -> Fault | None:
    """Apply a command to the known state of an axis; return the command's fault."""
    verb = command.verb
    if verb in _SHAPES:
        axis.shape = _SHAPES[verb]
    elif verb == "velocity_mode":
        axis.velocity_mode = True
    elif verb == "position_mode":
        axis.velocity_mode = False
    elif verb == "go":
        axis.running = axis.running or axis.velocity_mode
    elif verb in _STOPS:
        axis.running = False
    elif axis.running and verb in _WAITS:
        axis.running = False
        message = f"{command.text} never ends: axis {number} runs in velocity mode until it is stopped"
        return Fault(0, message, f"{number}ST first", "still-running")
    elif axis.running and verb in _MOVES and not axis.velocity_mode:
        axis.running = False
        if axis.shape:
            message = f"{command.text} is rejected: axis {number} still runs in velocity mode"
            rest = f"{number}ST,{number}WS first, or {number}PT for a trapezoid"
            hint = f"with {axis.shape}, a move starts at rest: {rest}"
            return Fault(0, message, hint, "still-running")
    return None


def _waits_too_far(axis: _Axis, number: int, command: Command) -> Fault | None:
    """Track the distance of a move, and return the fault of a WR for a longer one."""
    verb = command.verb
    if verb == "move_by":
        known = axis.distance == 0.0 and command.kind == NUMBER
        axis.distance = abs(float(command.value)) if known else None
    elif verb in _WAITS:
        axis.distance = 0.0
    elif verb == "wait_relative":
        if axis.distance and command.kind == NUMBER and abs(float(command.value)) > axis.distance:
            message = f"{command.text} never ends: axis {number} moves only {axis.distance:.10g}"
            return Fault(
                0, message, f"wait for less, or for the end of the move with {number}WS", "endless-wait"
            )
    elif command.row is not None and command.row.kind in ("move", "command") and verb not in _HARMLESS:
        axis.distance = None
    return None
