"""The narrow interface: all commands of a language, and a recorder of them.

Lengths are counts, times are seconds, axes are numbered like in the dialect (Mint from 0, MCCL from 1).
"""

from __future__ import annotations

from motionlang.controller import readers
from motionlang.controller.axis import Axis
from motionlang.controller.axis_verbs import SETTINGS
from motionlang.controller.clock import Clock
from motionlang.controller.readers import NO_SUBSCRIBER
from motionlang.controller.triggers.limit import Limit

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from motionlang.controller.readers import Loader, Reader, Subscriber, Writer
    from motionlang.controller.triggers.limit import Limit

# Verb -> description. Every verb is a method of `Controller`; the dialects call no other.
VERBS: dict[str, str] = {
    "configure": "Set one of an axis's settings: a speed, a rate, a time, a shape, a buffer size.",
    "set_home_switch": "Close or open the home switch of an axis.",
    "add_limit": "A further limit of an axis's travel.",
    "set_limit_action": "Say what an axis does at a limit.",
    "lock": "Say with which faults an axis takes no motion.",
    "set_brake": "Set or lift the brake of an axis by hand.",
    "follow_profiles": "Subscribe to each profile that an axis begins.",
    "warn_of_error": "Subscribe to following errors that exceed a limit.",
    "forget_history": "Drop data that is no longer needed.",
    "set_fault_handler": "Subscribe to errors between statements.",
    "set_servo_model": "Say whose gains those of a servo loop are.",
    "restore": "Give all settings of an axis their values at power-up.",
    "setting": "Read a setting back.",
    "reader": "A reading of an axis, to be called again and again, in its unit.",
    "writer": "A function that sets one setting of an axis, for repeated calls.",
    "loader": "A function that loads plain moves of an axis, for repeated calls.",
    "set_units": "Set the units of speeds and of accelerations of an axis.",
    "set_time_unit": "Set the seconds in the unit of time of an axis.",
    "set_scale": "Set the counts per user unit (and the time base) of an axis.",
    "enable": "Switch an axis on, at its present position.",
    "disable": "Switch an axis off: motion ends at once, the buffer is emptied.",
    "define_position": "Give the present position a new value.",
    "load_to": "Put a move to a position into the move buffer.",
    "load_by": "Put a move by a distance into the move buffer, counted from the end of the last one.",
    "load_dwell": "Put a rest of some seconds into the move buffer.",
    "load_output": "Put a change of outputs into the move buffer.",
    "load_pulse": "Put a pulse of an output into the move buffer.",
    "load_line": "Put a straight line of several axes to a point into their buffers.",
    "load_line_by": "Put a straight line of several axes by distances into their buffers.",
    "load_arc": "Put an arc, or a helix, into the buffers of its axes.",
    "load_guided": "Load a path whose speed follows a path policy.",
    "drop": "Report a suspended motion that will not run.",
    "replan_path": "Go on along a path at the pace that its guide says now.",
    "blend": "Begin the next path now, on top of what remains of the present one.",
    "move_id": "The mark of the move in progress, or of the last one.",
    "room": "Number of moves that the buffer of an axis can still take.",
    "go": "Start what the buffers of some axes hold.",
    "move_to": "Move to a position now, replacing what the axis is doing.",
    "move_by": "Move by a distance from the present target now.",
    "retarget_to": "Let the move in progress end at a position.",
    "retarget_by": "Let the move in progress end some distance further on.",
    "jog": "Run at a velocity until the next command.",
    "refer_speed": "Follow a speed reference: ramp to what is written.",
    "refer_position": "Follow a position reference within a period of the profiler.",
    "track": "Let a function set the velocity of an axis at every tick of the profiler.",
    "play": "Follow a ready-made profile now: a path, or the motion of a master.",
    "stop": "Decelerate to rest and empty the buffer.",
    "come_to_rest": "Decelerate to rest and keep the buffer, which is next.",
    "suspend": "Ramp to rest and keep the moves until `resume`.",
    "resume": "Go on with what `suspend` held.",
    "is_suspended": "Whether `suspend` holds an axis.",
    "abort": "Come to rest at once and empty the buffer.",
    "fault": "Raise a fault on an axis and act on it.",
    "together": "A block in which several axes are given their motion.",
    "clear_faults": "Forget an axis's faults.",
    "position": "The actual position of an axis: the demand, where no motor is simulated.",
    "velocity": "The actual velocity of an axis.",
    "demand": "The demanded position of an axis.",
    "demand_velocity": "The demanded velocity of an axis.",
    "following_error": "Demanded position minus actual position.",
    "servo_output": "The output to a simulated motor.",
    "motor_current": "The current of a simulated motor.",
    "is_open": "True if a simulated motor runs without its loop.",
    "is_still": "True if an axis is idle and its simulated motor is at rest.",
    "has_motor": "True if an axis has a simulated motor.",
    "set_gain": "Set a gain of the servo loop.",
    "gain": "Read a gain of the servo loop back.",
    "set_gains": "Set all gains of the servo loop at once.",
    "set_error_limit": "Set the following error beyond which an axis trips.",
    "settle_within": "Say when a simulated motor counts as settled.",
    "settled_time": "Time at which an axis has settled, or at which to check again.",
    "recall": "Motion of a motor at past times.",
    "settled_since": "Time since which an axis has been within the window of `settle_within`.",
    "open_loop": "Give a simulated motor an output whatever it does.",
    "close_loop": "Let an axis hold its position again.",
    "encoder_crossing_time": "The time at which an encoder channel will pass a position.",
    "demand_velocity_crossing_time": "The time at which the demanded velocity of an axis will next be a velocity.",
    "error_crossing_time": "The time at which the following error of an axis will pass a value.",
    "velocity_crossing_time": "The time at which the velocity of an axis will next be a velocity.",
    "remaining_crossing_time": "The time at which so much of the present move is still to go.",
    "offset_crossing_time": "The time at which so much is still to go of an offset, or of the present move.",
    "turns": "True if an encoder channel is turning.",
    "demand_crossing_time": "The time at which the demand of an axis will pass a position.",
    "target": "The end point of the last move.",
    "remaining": "The distance still to go in the present move.",
    "path_speed": "The speed along the path that an axis is on.",
    "vector_angle": "The direction in which two axes move in their plane.",
    "gear": "Follow a master, an axis or an encoder channel, at a ratio.",
    "set_ratio": "Let an axis that follows a master do so at another ratio.",
    "leave_master": "Stop following a master, and end the motion in progress.",
    "cam_index": "The segment of its table that a cam is in.",
    "load_fly": "Put a segment of a flying shear into the move buffer.",
    "load_cam": "Put a cam, whose table may change from cycle to cycle, into the move buffer.",
    "load_offset": "Put an offset on top of following into the move buffer.",
    "load_points": "Put points with velocities and times into the move buffer, for once or again and again.",
    "offset": "Add a distance on top of following a master.",
    "offset_remaining": "Remaining distance of a slave's offset, or of another axis's move.",
    "offset_status": "Result of the last offset.",
    "master_of": "The axis or encoder channel that an axis follows.",
    "drive_encoder": "Let the world turn an encoder channel.",
    "encoder_position": "The position of an encoder channel.",
    "encoder_velocity": "The velocity of an encoder channel.",
    "is_enabled": "True if an axis is on.",
    "is_on_home_switch": "True if the home switch of an axis is closed.",
    "is_idle": "True if an axis is at rest with nothing left to do.",
    "faults": "The fault bits of an axis.",
    "idle_time": "The time at which an axis will be idle if nothing else happens.",
    "is_at_standstill": "True if an axis is idle, or follows a master at standstill.",
    "standstill_time": "The time at which an axis comes to rest, following or not, if nothing else happens.",
    "end_of_moves": "The reader of the time at which all of some axes will be idle.",
    "crossing_time": "The time at which an axis will pass a position if nothing else happens.",
    "watch": "Subscribe to an axis passing a position, at the exact time.",
    "unwatch": "Unsubscribe.",
    "input": "A digital input.",
    "output": "A digital output, as it was set.",
    "set_output": "Set a digital output.",
    "pulse": "Turn a digital output on for some seconds.",
    "analogue_input": "An analogue input.",
    "set_analogue_output": "Set an analogue output.",
    "encoder": "An encoder channel that the world turns, as the track of its counts.",
    "rates": "The rates in force for a move at some speed.",
    "may_enable": "True if the enable input of an axis is on, or it has none.",
    "moving": "The axes that are not idle.",
    "settling": "The axes whose motors have not come to rest.",
    "rest_time": "The time at which a motor is at rest, or can be checked again.",
    "notify": "Notify the listeners of an event of an axis.",
    "run_time_fault": "Report an error that happened outside the program's statements.",
}


class Recorder:
    """A controller without physics, which records every verb.

    Readings return values from `answers`. `calls` is a list of `(verb, argument, …)` tuples. It has a clock and
    axes with a scale, so that a language can run on it; nothing ever moves.
    """

    def __init__(self, axes: int = 8, first: int = 0, answers: dict[str, Any] | None = None) -> None:
        self.clock = Clock()
        self.axes = {number: Axis(number) for number in range(first, first + axes)}
        self.calls: list[tuple[Any, ...]] = []
        self.answers: dict[str, Any] = {
            "is_idle": True,
            "is_at_standstill": True,
            "master_of": None,
            "is_enabled": True,
            "room": 2,
            "moving": [],
            "settling": [],
            **(answers or {}),
        }

    def set_scale(self, axis: int, counts: float, rate: float = 1.0, zero: float = 0.0) -> None:
        """Record and apply the scale, which everything else needs."""
        self.calls.append(("set_scale", axis, counts, rate, zero))
        self.axes[axis].scale.set(counts, rate, zero)

    def add_limit(self, axis: int, sign: int, bit: int, action: str, physical: bool = False) -> Limit:
        """Return a limit that is never passed."""
        return Limit(self, axis, sign, bit, action, physical)  # type: ignore[arg-type]

    def reader(self, name: str, axis: int, unit: str = "", subscriber: Subscriber = NO_SUBSCRIBER) -> Reader:
        """Return a reader that records every reading."""
        a = self.axes[axis]
        if name in SETTINGS:
            return readers.setting(lambda _: self.setting(axis, name), a, unit)
        if unit == readers.POSITION:
            return lambda *level: a.scale.position_to_user(getattr(self, name)(axis))
        until = readers.passing(self, name, a, unit, subscriber.wraps)  # type: ignore[arg-type]
        return readers.converted(lambda: getattr(self, name)(axis), a.scale, unit, subscriber, until)

    def writer(self, name: str, axis: int, unit: str = "") -> Writer:
        """Return a writer that records every setting, in counts."""
        scale = self.axes[axis].scale
        return lambda value: self.configure(axis, name, scale.to_counts(value, unit))

    def loader(self, axis: int, relative: bool, command: str) -> Loader:
        """Return a loader that never loads, so that the verbs are recorded."""
        return lambda value, line: False

    def __getattr__(self, verb: str) -> Any:
        if verb not in VERBS:
            raise AttributeError(verb)

        def record(*arguments: Any) -> Any:
            self.calls.append((verb, *arguments))
            return self.answers.get(verb, 0.0)

        return record
