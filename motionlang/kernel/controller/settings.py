"""The settings of an axis, and what those do that change while it moves.

Mint's FEEDRATE page (MN1270 p. 79-81): in speed mode a new speed acts at once on the move in progress and on
loaded ones. In feed rate mode a move keeps the speed that it was loaded with. In both modes the override
multiplies the speed, at once.
"""

from __future__ import annotations

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.events import note, too_late
from motionlang.kernel.controller.queue.life import continue_with, replan_move
from motionlang.kernel.controller.queue.plan import plan_move
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.log.records import ChangedSetting
from motionlang.kernel.planners import Profile

# All that a language may set.
SETTINGS = frozenset(
    {
        "speed",
        "accel",
        "decel",
        "accel_time",
        "decel_time",
        "accel_jerk",
        "decel_jerk",
        "accel_jerk_time",
        "decel_jerk_time",
        "s_ramp",
        "error_decel",
        "ramp",
        "shape",
        "buffer_size",
        "buffer_low",
        "move_id",
        "live_speed",
        "feedrate_mode",
        "override",
        "suspend_time",
        "max_speed",
        "max_accel",
        "max_decel",
        "contour_mode",
        "contour_angle",
    }
)
# Those that may act on a move in progress.
LIVE = frozenset(
    {
        "speed",
        "accel",
        "decel",
        "accel_time",
        "decel_time",
        "override",
        "feedrate_mode",
        "max_speed",
        "max_accel",
        "max_decel",
    }
)
_LIMITS = frozenset({"max_speed", "max_accel", "max_decel"})
_SPEEDS = frozenset({"speed", "override", "feedrate_mode", "max_speed"})
# Those that are a rate, and which of the two.
_RATES = {"accel": 0, "accel_time": 0, "max_accel": 0, "decel": 1, "decel_time": 1, "max_decel": 1}


def configure(a: Axis, name: str, value: object) -> None:
    """Set one of `SETTINGS`; a rate replaces its ramp time, and vice versa."""
    assert name in SETTINGS, name
    acts = a.move is not None and name in LIVE
    if acts and _is_in_force(a, name, value):
        return
    if name == "override" and any(_concerns(move, name) for move in a.entries):
        note(a, "override", float(value))  # type: ignore[arg-type]
    log = a.controller.log
    if getattr(a, name) != value:
        log.settings.add(ChangedSetting(a.clock.now, a.index, name, value))
    setattr(a, name, value)
    if name == "speed" and not value:
        a.zeroed_at = log.where()
    if name == "accel":
        a.accel_time = None
    elif name == "decel":
        a.decel_time = None
    if acts:
        apply_in_motion(a, name)
        a.controller.motion_listener.heed(a)


def restore(a: Axis) -> None:
    """Reset all `SETTINGS` of an axis at rest to their values at power-up."""
    new = Axis(a.index, a.controller)
    for name in sorted(SETTINGS):
        configure(a, name, getattr(new, name))


def apply_in_motion(a: Axis, name: str) -> None:
    """Apply a setting of `LIVE` changed during a move; if suspended, apply it later."""
    entries = a.entries
    if name == "feedrate_mode":
        for move in entries:
            move.overridden = a.feedrate_mode > 1
    concerned = [move for move in entries if _concerns(move, name)]
    if a.suspended or not concerned:
        return
    if name in _SPEEDS or name in _LIMITS or any(move.speed is None for move in concerned):
        _replan(a, name)


def _is_in_force(a: Axis, name: str, value: object) -> bool:
    """True if a setting of `LIVE` already has this value, as when a loop rewrites it.

    A rate of 0 means no motion; it is rejected every time it is written.
    """
    if getattr(a, name) != value or (not value and name in ("accel", "decel")):
        return False
    if name in ("accel", "decel"):
        return getattr(a, f"{name}_time") is None
    return name != "feedrate_mode" or all(move.overridden is (a.feedrate_mode > 1) for move in a.entries)


def _concerns(move: LoggedMove, name: str) -> bool:
    """True if a move in progress depends on the setting."""
    if move.action is not None and not move.action.live:
        return name in move.action.live_limits
    if name == "speed":
        return move.speed is None
    return move.overridden if name == "override" else True


def _replan(a: Axis, name: str) -> None:
    """Apply a new setting to the rest of the move, unless its rate comes too late.

    Then the axis brakes as planned; no source says what a controller does there. A new speed acts at the rates in
    force, and a new rate beside one that came too late before.
    """
    move = a.move
    assert move is not None
    if move.action is not None:
        replan_move(a)
        return
    in_force = move.rates_in_force
    profile = plan_move(a, move)
    written = move.rates_in_force
    if in_force is None or written is None or not _is_late(a, move, profile):
        continue_with(a, profile, "")
        return
    k = _RATES.get(name)
    if k is None:
        if written != in_force:
            too_late(a, move, int(written[1] != in_force[1]), written, in_force)
        continue_with(a, plan_move(a, move, in_force), "")
        return
    alone = (in_force[0], written[1]) if k else (written[0], in_force[1])
    if alone != written:
        profile = plan_move(a, move, alone)
        if not _is_late(a, move, profile):
            continue_with(a, profile, "")
            return
    too_late(a, move, k, written, in_force)
    move.rates_in_force = in_force


def _is_late(a: Axis, move: LoggedMove, profile: Profile) -> bool:
    """True if a profile leaves the way to the target of its move on a side where the rest of the plan does not.

    An axis that moves away from its target, or passes it to turn round, leaves the way under any rates.
    """
    leaves = _leaves(profile, move.target)
    if not any(leaves):
        return False
    planned = _leaves(a.profiles[-1].after(a.clock.now - a.starts[-1]), move.target)
    return any(new and not old for new, old in zip(leaves, planned, strict=True))


def _leaves(profile: Profile, target: float) -> tuple[bool, bool]:
    """True if a profile goes below, and above, the way from its start to `target`."""
    low, high = profile.extrema()
    slack = 1e-9 * (high - low) + 1e-9
    return low < min(profile.start, target) - slack, high > max(profile.start, target) + slack
