"""The virtual multi-axis controller, in counts and seconds, without any language.

Start with `verbs.Controller`. Its public methods are all that a language may
use.

Units, unless a docstring says differently:

    position, target, distance, following error      counts, from the zero that the program has set
    velocity, speed                                  counts/s
    acceleration, accel, decel, error_decel          counts/s²
    jerk, accel_jerk, decel_jerk                     counts/s³
    time, duration                                   s; a time counts from power-up
    angle                                            degrees
    ratio of a slave                                 counts of the slave per count of its master
    override                                         a factor of the speed

Other units are used for

    paths: length, and speed, rates and jerk along it        uu, uu/s, uu/s², uu/s³; positions of axes in counts
    `Axis.index_every`                                       uu
    simulated motors: output; current; torque                V; A; N m; SI units for the plant, except for counts
    gains                                                    see `kernel/servo/gains.py`
    log: `value` and `limit` of an event                     uu at that time; a `ChangedSetting` in counts and seconds
    trace                                                    the unit at the end of the column's name

Suffixes and prefixes of names:

    _time                            s: a time (start_time, crossing_time) or duration (accel_time, suspend_time)
    _speed, _accel, _decel, _jerk    as above; max_ is a limit of the axis
    _rate                            Hz (servo_rate, trajectory_rate); error_rate is a deceleration, counts/s²
    _uu                              user units, in `scale.py`, where both are in use
    _s, _uu, _uu_per_s, _uu_per_s2   units in the names of a trace's columns: time_s, axis0_velocity_uu_per_s

The `Scale` of an axis converts between user units and counts: `counts` is counts per uu, `rate` seconds per
user unit of time.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lazy import lazy_names

if TYPE_CHECKING:
    from motionlang.kernel.controller.clock import Clock as Clock
    from motionlang.kernel.controller.faults import HOMING as HOMING
    from motionlang.kernel.controller.faults import fault_names as fault_names
    from motionlang.kernel.controller.io.asking import Asking as Asking
    from motionlang.kernel.controller.io.asking import Responder as Responder
    from motionlang.kernel.controller.io.channels import Channels as Channels
    from motionlang.kernel.controller.io.host_memory import AREAS as AREAS
    from motionlang.kernel.controller.io.host_memory import PRODUCTS as PRODUCTS
    from motionlang.kernel.controller.io.host_memory import HostMemory as HostMemory
    from motionlang.kernel.controller.io.host_memory import product as product
    from motionlang.kernel.controller.motion.encoder import AUXILIARY as AUXILIARY
    from motionlang.kernel.controller.motion.follow import Gear as Gear
    from motionlang.kernel.controller.motion.jog import Jog as Jog
    from motionlang.kernel.controller.motion.profile_playback import Playback as Playback
    from motionlang.kernel.controller.motion_listener import MotionListener as MotionListener
    from motionlang.kernel.controller.moves.cam import CurveFollow as CurveFollow
    from motionlang.kernel.controller.moves.geometry import StraightLine as StraightLine
    from motionlang.kernel.controller.moves.path import PathMove as PathMove
    from motionlang.kernel.controller.moves.path_run import PathRun as PathRun
    from motionlang.kernel.controller.queue.stop import Stopping as Stopping
    from motionlang.kernel.controller.surroundings import Surroundings as Surroundings

PUBLIC = {
    "clock": "Clock",
    "faults": "fault_names HOMING",
    "io.channels": "Channels",
    "io.asking": "Asking Responder",
    "io.host_memory": "HostMemory AREAS PRODUCTS product",
    "motion.encoder": "AUXILIARY",
    "motion_listener": "MotionListener",
    "motion.follow": "Gear",
    "queue.stop": "Stopping",
    "surroundings": "Surroundings",
    "motion.jog": "Jog",
    "motion.profile_playback": "Playback",
    "moves.cam": "CurveFollow",
    "moves.geometry": "StraightLine",
    "moves.path": "PathMove",
    "moves.path_run": "PathRun",
}


if not TYPE_CHECKING:
    __getattr__ = lazy_names(__name__, PUBLIC)
