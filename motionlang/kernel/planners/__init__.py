"""Motion mathematics: planners, and the `Profile` that each of them returns.

A `Profile` is position as an exact function of time. Each name is imported on first use, so a program without motion
loads no planner. `ORDERS` and `PieceTable` load NumPy.

Units. The unit of length, L, is the caller's: counts for an axis, user units along a path.

    start, target, end, position, distance         L, signed
    velocity, v0, v1                               L/s, signed
    acceleration, a0                               L/s², signed
    speed, accel, decel                            L/s, L/s², magnitudes
    jerk, accel_jerk, decel_jerk                   L/s³; as limits magnitudes
    time, duration, knots                          s; times count from the start of the profile
    ramp, ratio                                    a fraction of the duration of a ramp, 0 to 0.5
    omega, phase of a sine piece                   rad/s, rad

Names:

    0 and 1 at the end of a name    at the beginning and at the end of a motion
    u, b                            velocity and acceleration in the direction of motion
    per_speed, per_square           distance per unit of a speed, and of its square
    x                               time since the knot at which a piece begins

Where a profile is a curve over a length (a path, a cam), its "time" is that length: user units of path, or
counts of the master. `pvt/` is in counts and seconds.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lazy import lazy_names

if TYPE_CHECKING:
    from motionlang.kernel.planners.curve import MotionState as MotionState
    from motionlang.kernel.planners.curve import Phase as Phase
    from motionlang.kernel.planners.curve import Profile as Profile
    from motionlang.kernel.planners.curve import from_curve as from_curve
    from motionlang.kernel.planners.curve import hold as hold
    from motionlang.kernel.planners.curve import pieces_of as pieces_of
    from motionlang.kernel.planners.curve import state_in as state_in
    from motionlang.kernel.planners.evaluate import piece_values as piece_values
    from motionlang.kernel.planners.limits import check_finite as check_finite
    from motionlang.kernel.planners.limits import check_positive as check_positive
    from motionlang.kernel.planners.lookahead import PathPace as PathPace
    from motionlang.kernel.planners.pieces import acceleration_in as acceleration_in
    from motionlang.kernel.planners.pieces import crest_points as crest_points
    from motionlang.kernel.planners.pieces import even_points as even_points
    from motionlang.kernel.planners.pieces import jerk_in as jerk_in
    from motionlang.kernel.planners.pieces import recentred as recentred
    from motionlang.kernel.planners.pieces import still_points as still_points
    from motionlang.kernel.planners.pieces import velocity_in as velocity_in
    from motionlang.kernel.planners.pvt.motion import plan_pvt as plan_pvt
    from motionlang.kernel.planners.pvt.motion import pvt_piece as pvt_piece
    from motionlang.kernel.planners.pvt.velocities import VELOCITY_METHODS as VELOCITY_METHODS
    from motionlang.kernel.planners.pvt.velocities import compare_velocities as compare_velocities
    from motionlang.kernel.planners.pvt.velocities import knot_accelerations as knot_accelerations
    from motionlang.kernel.planners.pvt.velocities import pvt_velocities as pvt_velocities
    from motionlang.kernel.planners.ramps import Piece as Piece
    from motionlang.kernel.planners.ramps import Plain as Plain
    from motionlang.kernel.planners.ramps import Recipe as Recipe
    from motionlang.kernel.planners.ramps import named_ramps as named_ramps
    from motionlang.kernel.planners.root import summit as summit
    from motionlang.kernel.planners.sample import ORDERS as ORDERS
    from motionlang.kernel.planners.sample import PieceTable as PieceTable
    from motionlang.kernel.planners.stop import plan_stop as plan_stop
    from motionlang.kernel.planners.stop import plan_velocity as plan_velocity
    from motionlang.kernel.planners.target import plan as plan
    from motionlang.kernel.planners.target import plan_trapezoid as plan_trapezoid

PUBLIC = {
    "curve": "Phase Profile MotionState hold from_curve pieces_of state_in",
    "target": "plan plan_trapezoid",
    "stop": "plan_stop plan_velocity",
    "ramps": "Piece Plain Recipe named_ramps",
    "pieces": "acceleration_in velocity_in jerk_in crest_points even_points recentred still_points",
    "evaluate": "piece_values",
    "root": "summit",
    "sample": "ORDERS PieceTable",
    "lookahead": "PathPace",
    "limits": "check_finite check_positive",
    "pvt.motion": "plan_pvt pvt_piece",
    "pvt.velocities": "VELOCITY_METHODS pvt_velocities compare_velocities knot_accelerations",
}

if not TYPE_CHECKING:
    __getattr__ = lazy_names(__name__, PUBLIC)
