"""Profile position, profile velocity and homing of DS402, with our planners.

Problem. A master writes targets, speeds and rates, and bits of the control word. The drive must move as the standard
requires, and its status word must show each step: set-point acknowledged, target reached, speed zero, homed.

Idea. Each motion is one profile from the state of the drive at that microsecond: a trapezoid to a position, or a ramp
to a velocity. The drive calls back when the profile ends. Between two calls nothing is computed; a position read over
the bus is evaluated from the profile.

    profile position   bit 4 rises: a set-point is taken and acknowledged (bit 12). At rest, or with bit 5, its motion
                       begins at once. Otherwise it waits until the motion in progress ends, and bit 12 stays set
    profile velocity   0x60FF is followed as long as operation is enabled
    homing             bit 4 rises: a sequence of searches; the last one ends at the home position, which becomes
                       minus the home offset

Invariants. At most one motion is in progress, which belongs to the current mode. A limit switch ends a motion in its
direction; a motion away from it is allowed. Units of the objects: 0.1 counts/s, 10 counts/s².
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from math import copysign, inf

from motionlang.kernel.planners import Profile, plan_stop, plan_trapezoid, plan_velocity
from motionlang.kernel.tools import bisected
from motionlang_copley.drive import IDLE, Drive
from motionlang_copley.switches import Switches

PROFILE_POSITION, PROFILE_VELOCITY, HOMING = 1, 3, 6
SPEED_UNIT, RATE_UNIT = 0.1, 10.0
START, AT_ONCE, RELATIVE, HALT = 0x10, 0x20, 0x40, 0x100
TARGET_REACHED, LIMIT_ACTIVE, BIT_12, HOMING_ERROR = 0x0400, 0x0800, 0x1000, 0x2000
# The homing methods: limit switches with and without index, home switch, index, present position.
METHODS = (1, 2, 17, 18, 19, 20, 33, 34, 35, 37)
# Codes of EMCY: a limit switch, and two that are specific to this drive.
REFERENCE_LIMIT, NO_SWITCH, NO_METHOD = 0x8612, 0xFF01, 0xFF02

Values = dict[tuple[int, int], int]
# A target position, a speed and two rates.
SetPoint = tuple[float, float, float, float]


class _NotFound(Exception):
    """The position searched for is not there; `code` is that of EMCY."""

    def __init__(self, code: int, why: str) -> None:
        super().__init__(why)
        self.code = code


class ProfileModes:
    """The three modes of one drive; `emergency` is called with an error code and the reason."""

    def __init__(
        self, drive: Drive, values: Values, switches: Switches, emergency: Callable[[int, str], None]
    ) -> None:
        self._drive, self._values, self._switches, self._emergency = drive, values, switches, emergency
        # Profile position: the target in force, the one that waits, and the acknowledge bit.
        self._point: SetPoint | None = None
        self._next: SetPoint | None = None
        self._acknowledged = self._halted = False
        # Profile velocity: the commanded one, None while none is followed.
        self._velocity: float | None = None
        # Homing: the stages that are left, and how the last one ended.
        self._stages: Iterator[None] | None = None
        self._homed = False
        self._failed_method: int | None = None
        self._limited = False

    # ---------------------------------------------------------------------------------------------- control

    def control(self, mode: int, before: int, now: int) -> None:
        """Act on the control word while operation is enabled."""
        rises, falls = now & ~before & START, before & ~now & START
        if mode == PROFILE_POSITION:
            self._control_position(now, bool(rises), bool(falls))
        elif mode == PROFILE_VELOCITY:
            self._halted = bool(now & HALT)
            self.follow_velocity()
        elif mode == HOMING:
            if now & HALT or falls:
                self.leave("interrupted by the control word")
            elif self._stages is None and (rises or (now & START and self._is_other_method())):
                self._begin_homing()

    def leave(self, why: str) -> None:
        """End the motion in progress, because operation or the mode has ended."""
        self._point = self._next = None
        self._acknowledged = self._halted = False
        self._velocity, self._stages = None, None
        self._drive.stop(why)

    def status(self, mode: int) -> int:
        """Return the bits of the status word that belong to the mode."""
        idle = self._drive.state == IDLE
        bits = LIMIT_ACTIVE if self._limited else 0
        if mode == PROFILE_POSITION:
            reached = idle and (self._halted or self._next is None)
            return bits | (TARGET_REACHED * reached) | (BIT_12 * self._acknowledged)
        if mode == PROFILE_VELOCITY:
            wanted = self._wanted_velocity() if self._velocity is not None else 0.0
            reached = abs(self._drive.velocity - wanted) <= 1e-6 * max(1.0, abs(wanted))
            return bits | (TARGET_REACHED * reached) | (BIT_12 * (abs(self._drive.velocity) < 1e-6))
        return (
            bits
            | (TARGET_REACHED * idle)
            | (BIT_12 * self._homed)
            | (HOMING_ERROR * (self._failed_method is not None))
        )

    # ------------------------------------------------------------------------------------- profile position

    def _control_position(self, now: int, rises: bool, falls: bool) -> None:
        if now & HALT:
            if not self._halted:
                self._halted = True
                self._drive.brake(self._rate(0x6084))
            return
        if self._halted:
            self._halted = False
            if self._point is not None:
                self._move(self._point)
        if rises and not self._acknowledged:
            self._take(now)
        elif falls and self._next is None:
            self._acknowledged = False

    def _take(self, control: int) -> None:
        """Take a set-point; it waits if a motion is in progress."""
        target = float(self._values[0x607A, 0])
        if control & RELATIVE:
            last = self._next or self._point
            target += self._drive.position if last is None else last[0]
        point = (target, self._speed(0x6081), self._rate(0x6083), self._rate(0x6084))
        self._acknowledged = True
        if control & AT_ONCE or self._drive.state == IDLE:
            self._next = None
            self._move(point)
        else:
            self._next = point

    def _move(self, point: SetPoint) -> None:
        drive = self._drive
        self._point = point
        target, speed, accel, decel = point
        if target == drive.position and drive.velocity == 0.0:
            self._arrived()
            return
        profile = plan_trapezoid(drive.position, target, speed, accel, decel, drive.velocity)
        self._run(profile, profile.duration, self._arrived, target)

    def _arrived(self) -> None:
        self._drive.rest()
        self._point = None
        following, self._next = self._next, None
        if following is not None:
            self._acknowledged = bool(self._values[0x6040, 0] & START)
            self._move(following)

    # ------------------------------------------------------------------------------------- profile velocity

    def follow_velocity(self) -> None:
        """Ramp to object 0x60FF, or to rest while halted."""
        drive, wanted = self._drive, self._wanted_velocity()
        if wanted == self._velocity or (self._velocity is None and wanted == 0.0 and drive.state == IDLE):
            self._velocity = wanted
            return
        self._velocity = wanted
        profile = plan_velocity(
            "trapezoid", drive.position, drive.velocity, wanted, self._rate(0x6083), self._rate(0x6084)
        )
        ramps = profile.knots[-2]
        if wanted == 0.0:
            self._run(profile.cut(ramps), ramps, drive.rest, profile.end)
        else:
            self._run(profile, ramps, _nothing, copysign(inf, wanted))

    def _wanted_velocity(self) -> float:
        return 0.0 if self._halted else self._values[0x60FF, 0] * SPEED_UNIT

    # ------------------------------------------------------------------------------------------ limit switches

    def _run(self, profile: Profile, seconds: float, then: Callable[[], None], end: float) -> None:
        """Begin a motion that ends at a limit switch, if it meets one.

        A motion that begins on an active limit switch in its direction is refused.
        """
        drive, switches = self._drive, self._switches
        here, last = self._position, end + drive.datum
        forwards = last > here
        side, limit = ("positive", switches.positive) if forwards else ("negative", switches.negative)
        is_within = last <= limit if forwards else last >= limit
        if not is_within and (here >= limit if forwards else here <= limit):
            self._stopped_by_limit(side)
            return
        self._leave_limit()
        if is_within:
            drive.follow(profile, seconds, then)
        else:
            end_of_motion = partial(self._stopped_by_limit, side)
            drive.follow(profile, crossing(profile, limit - drive.datum), end_of_motion)

    @property
    def is_at_limit(self) -> bool:
        """True if a limit switch has stopped the axis, and no motion away from it has begun."""
        return self._limited

    def _leave_limit(self) -> None:
        if self._limited:
            self._limited = False
            self._emergency(0, "")

    def _stopped_by_limit(self, side: str) -> None:
        self._point = self._next = None
        self._limited = True
        self._emergency(REFERENCE_LIMIT, f"the {side} limit switch has stopped the axis")
        self._drive.brake(self._drive.abort_deceleration)

    # -------------------------------------------------------------------------------------------------- homing

    def _is_other_method(self) -> bool:
        """True if another method than the one that failed is selected.

        The homing of `canopen` does not clear bit 4 after an error, so a new method starts without an edge.
        """
        return self._failed_method not in (None, self._values[0x6098, 0])

    def _begin_homing(self) -> None:
        self._leave_limit()
        self._homed, self._failed_method = False, None
        self._stages = self._homing(self._values[0x6098, 0])
        self._continue_homing()

    def _continue_homing(self) -> None:
        """Begin the next stage of homing; end homing after the last one."""
        if self._stages is None:
            return
        try:
            next(self._stages)
        except StopIteration:
            self._stages, self._homed = None, True
        except _NotFound as problem:
            self._stages, self._failed_method = None, self._values[0x6098, 0]
            self._emergency(problem.code, f"homing failed: {problem}")
            self._drive.brake(self._drive.abort_deceleration)

    def _homing(self, method: int) -> Iterator[None]:
        """Run the stages of a homing method; yield after each has begun.

        The end of the stage's motion resumes the sequence.
        """
        switches, fast, slow = self._switches, self._speed(0x6099, 1), self._speed(0x6099, 2)
        home = self._position
        if method not in METHODS:
            raise _NotFound(NO_METHOD, f"0x6098 is {method}, which selects no method")
        if method in (1, 17):
            active = self._position <= switches.negative
            yield from self._leave_switch("negative limit switch", switches.negative, -fast, slow, active)
            home = switches.negative
        elif method in (2, 18):
            active = self._position >= switches.positive
            yield from self._leave_switch("positive limit switch", switches.positive, fast, -slow, active)
            home = switches.positive
        elif method == 19:
            active = self._position >= switches.home
            yield from self._leave_switch("home switch", switches.home, fast, -slow, active)
            home = switches.home
        elif method == 20:
            active = self._position < switches.home
            yield from self._leave_switch("home switch", switches.home, -fast, slow, active)
            home = switches.home
        if method in (1, 2, 33, 34):
            direction = slow if method in (1, 34) else -slow
            home = switches.next_index(self._position, direction)
            yield from self._search("index mark", home, direction)
        yield from self._return_to(home)
        self._drive.shift(home - self._drive.datum + self._values[0x607C, 0])

    @property
    def _position(self) -> float:
        """The position on the machine, counts."""
        return self._drive.position + self._drive.datum

    def _leave_switch(self, name: str, edge: float, fast: float, slow: float, active: bool) -> Iterator[None]:
        """Move onto a switch at a fast velocity, and off it again at a slow one."""
        if not active:
            yield from self._search(name, edge, fast)
            yield from self._halt()
        yield from self._search(name, edge, slow)

    def _search(self, name: str, edge: float, velocity: float) -> Iterator[None]:
        """Move at a velocity to a position on the machine, where `name` is.

        Raises _NotFound if a limit comes before the position.
        """
        drive, switches, rate = self._drive, self._switches, self._rate(0x609A)
        side, limit = ("positive", switches.positive) if velocity > 0 else ("negative", switches.negative)
        reach = min(edge, limit) if velocity > 0 else max(edge, limit)
        if abs(reach) == inf:
            raise _NotFound(NO_SWITCH, f"the machine has no {name}")
        if (reach - self._position) * velocity > 0.0:
            profile = plan_velocity("trapezoid", drive.position, drive.velocity, velocity, rate, rate)
            drive.follow(profile, crossing(profile, reach - drive.datum), self._continue_homing)
            yield
        if reach != edge:
            raise _NotFound(REFERENCE_LIMIT, f"there is no {name} before the {side} limit switch")

    def _halt(self) -> Iterator[None]:
        drive = self._drive
        if drive.velocity:
            stop = plan_stop("trapezoid", drive.position, drive.velocity, self._rate(0x609A))
            drive.follow(stop, stop.duration, self._continue_homing)
            yield
            drive.rest()

    def _return_to(self, home: float) -> Iterator[None]:
        """Brake, return to a position on the machine, and come to rest there."""
        yield from self._halt()
        drive, rate = self._drive, self._rate(0x609A)
        target = home - drive.datum
        if target != drive.position:
            move = plan_trapezoid(drive.position, target, self._speed(0x6099, 2), rate, rate)
            drive.follow(move, move.duration, self._continue_homing)
            yield
            drive.rest()

    def _speed(self, index: int, sub: int = 0) -> float:
        return self._values[index, sub] * SPEED_UNIT

    def _rate(self, index: int) -> float:
        return self._values[index, 0] * RATE_UNIT


def crossing(profile: Profile, position: float) -> float:
    """Return the last time at which a profile crosses a position.

    The profile must start on one side of the position and end on the other.
    """
    ramps = profile.knots[-2]
    if profile.duration == inf and (position - profile.position(ramps)) * profile.end_velocity >= 0.0:
        return float(ramps + (position - profile.position(ramps)) / profile.end_velocity)
    low, high = 0.0, ramps if profile.duration == inf else profile.duration
    upwards = profile.position(high) > position
    return bisected(high, low, lambda time: (profile.position(time) > position) is upwards)


def _nothing() -> None:
    """Do nothing at the end of a ramp: the motion continues at its velocity."""
