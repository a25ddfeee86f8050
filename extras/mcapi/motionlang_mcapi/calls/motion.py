"""Functions for motors on and off, modes, motion, and waits."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import inf
from typing import TYPE_CHECKING, TypeAlias

from motionlang.kernel.mccl import AxisState, Board, Command, at_target_time
from motionlang_mcapi import table as mc
from motionlang_mcapi.command import command
from motionlang_mcapi.errors import CallRefused
from motionlang_mcapi.registry import commands, poll

if TYPE_CHECKING:
    from motionlang_mcapi.call import ApiCall
    from motionlang_mcapi.interface import Interface
    from motionlang_mcapi.session import HostProcess

# Whether it is so, when it may be so next, the time-out, and what to do at the end.
Polled: TypeAlias = tuple[Callable[[], bool], Callable[[], float], float, Callable[[bool], None]]

# The command of each constant.
PROFILES = {mc.MC_PROF_TRAPEZOID: "PT", mc.MC_PROF_SCURVE: "PS", mc.MC_PROF_PARABOLIC: "PP"}
MODES = {mc.MC_MODE_GAIN: "GM", mc.MC_MODE_POSITION: "PM", mc.MC_MODE_TORQUE: "QM", mc.MC_MODE_VELOCITY: "VM"}
DIRECTIONS = {mc.MC_DIR_POSITIVE: 0, mc.MC_DIR_NEGATIVE: 1}
LEARNS = {mc.MC_LRN_POSITION: "LP", mc.MC_LRN_TARGET: "LT"}


def of(constants: Mapping[int, str], value: int) -> str:
    """Return the command for a constant; raise Refused if there is none."""
    if value not in constants:
        raise CallRefused(mc.MCERR_CONSTANT)
    return constants[value]


@commands("MCEnableAxis")
def enable(interface: Interface, axis: int, state: int) -> list[Command]:
    return [command("MN" if state else "MF", axis)]


@commands("MCEnableJog")
def enable_jog(interface: Interface, axis: int, state: int) -> list[Command]:
    return [command("JN" if state else "JF", axis)]


@commands("MCEnableSync")
def enable_sync(interface: Interface, axis: int, state: int) -> list[Command]:
    return [command("SN" if state else "NS", axis)]


@commands("MCEnableBacklash")
def enable_backlash(interface: Interface, axis: int, backlash: float, state: int) -> list[Command]:
    return [command("BD", axis, backlash), command("BN" if state else "BF", axis)]


@commands("MCEnableGearing")
def enable_gearing(interface: Interface, axis: int, master: int, ratio: float, state: int) -> list[Command]:
    if not state:
        return [command("SM", axis, 0)]
    return [command("SS", axis, ratio), command("SM", axis, master)]


@commands("MCDirection")
def direction(interface: Interface, axis: int, dir: int) -> list[Command]:
    if dir not in DIRECTIONS:
        raise CallRefused(mc.MCERR_CONSTANT)
    return [command("DI", axis, DIRECTIONS[dir])]


@commands("MCGo", "MCGoEx")
def go(interface: Interface, axis: int, param: float = 0.0) -> list[Command]:
    return [command("GO", axis)]


@commands("MCLearnPoint")
def learn(interface: Interface, axis: int, index: int, mode: int) -> list[Command]:
    return [command(of(LEARNS, mode), axis, index)]


@commands("MCReset")
def reset(interface: Interface, axis: int) -> list[Command]:
    return [command("RT", axis)]


@commands("MCSetOperatingMode")
def set_mode(interface: Interface, axis: int, caxis: int, mode: int) -> list[Command]:
    if mode == mc.MC_MODE_CONTOUR:
        return [command("CM", axis, caxis)]
    return [command(of(MODES, mode), axis)]


@commands("MCSetProfile")
def set_profile(interface: Interface, axis: int, mode: int) -> list[Command]:
    return [command(of(PROFILES, mode), axis)]


@commands("MCWaitForEdge")
def wait_edge(interface: Interface, axis: int, state: int) -> list[Command]:
    """Wait for the home switch; the argument of WE has the opposite sense."""
    return [command("WE", axis, 0 if state else 1)]


# ------------------------------------------------------------------------------------------------ conditions


def _condition(
    holds: Callable[[Board, AxisState], bool],
    due: Callable[[Board, AxisState], float] = lambda board, each: inf,
) -> Callable[[HostProcess, ApiCall, int, float], Polled]:
    def begin(session: HostProcess, call: ApiCall, axis: int, timeout: float) -> Polled:
        board = session.desk.board
        axes = board.all_axes if axis == 0 else (board.axis(axis),)

        def ready() -> bool:
            return all(holds(board, each) for each in axes)

        def next_time() -> float:
            return max(due(board, each) for each in axes)

        def finish(is_ready: bool) -> None:
            call.value = int(is_ready)

        return ready, next_time, timeout, finish

    return begin


poll("MCIsStopped")(
    _condition(
        lambda board, each: board.is_complete(each),
        lambda board, each: inf if board.awaits_path(each) else board.controller.idle_time(each.number),
    )
)
poll("MCIsAtTarget")(
    _condition(lambda board, each: at_target_time(board, each) <= board.controller.clock.now, at_target_time)
)
poll("MCIsIndexFound")(_condition(lambda board, each: each.index_found))
poll("MCIsEdgeFound")(_condition(lambda board, each: each.edge_found))
