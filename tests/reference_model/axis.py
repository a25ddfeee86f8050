"""One axis as a simple state machine, written from the manual alone.

It shares no code with the package. Its motion is a sequence of sections of constant acceleration. Time
advances section by section, and a limit takes effect when the axis reaches it.
"""

from __future__ import annotations

from math import copysign, inf, sqrt

NEAR = 1e-9
# Counts that an axis may still move before a reversal and count as having reversed.
REVERSAL_TOLERANCE = 1e-6

# A section: its remaining duration, and its acceleration.
Stretches = list[tuple[float, float]]


class Limit:
    """An end of the travel: `sign` is its side, `action` the reaction to it.

    `position` is None if there is no limit. `hit` is true if the limit has ever been a fault. `number` is the axis
    that it belongs to, if several axes follow one path.
    """

    def __init__(self, sign: int, action: str, number: int = 0) -> None:
        self.sign, self.action, self.number = sign, action, number
        self.position: float | None = None
        self.raised = self.hit = False


class Axis:
    """Position, velocity, state, and the loaded moves."""

    def __init__(self, speed: float, accel: float, decel: float, error_decel: float) -> None:
        self.speed, self.accel, self.decel, self.error_decel = speed, accel, decel, error_decel
        self.override = 1.0
        self.time = self.position = self.velocity = 0.0
        self.doing = "idle"  # "move", "jog", "stop"
        self.target = self.jogging = 0.0
        self.suspended = self.fault = False
        self.stretches: Stretches = []
        self.queue: list[tuple[str, float]] = []
        self.released = 0
        self.limits = [Limit(+1, "abort"), Limit(-1, "abort")]
        self.end: float | None = None  # the end of the path along which this axis measures

    # ------------------------------------------------------------------------------------------------ commands

    def load(self, kind: str, value: float) -> None:
        """Load a move into the buffer: "to" a position or "by" a distance.

        The distance counts from the position at which the move begins.
        """
        self.queue.append((kind, value))

    def go(self) -> None:
        """Release the loaded moves."""
        self.released = len(self.queue)
        if self.doing == "idle":
            self._next()

    def jog(self, velocity: float) -> None:
        """Run at a velocity; allowed in any state."""
        self.doing, self.jogging = "jog", velocity
        self._begin()

    def stop(self) -> None:
        """Decelerate to rest, and drop the loaded moves."""
        self.suspended = False
        self._forget()
        if self.doing not in {"idle", "stop"}:
            self._brake(self.decel)

    def cancel(self) -> None:
        """Halt at once, and drop the loaded moves."""
        self.suspended = False
        self._forget()
        self._rest()

    def suspend(self, on: bool) -> None:
        """Decelerate to rest but do not drop the moves; or continue them."""
        if on is not self.suspended:
            self.suspended = on
            self._change()

    def set_override(self, factor: float) -> None:
        """Set the factor on the speed of moves."""
        if factor != self.override:
            self.override = factor
            if self.doing == "move":
                self._change()

    def set_speed(self, speed: float) -> None:
        """Set the speed; it applies to the move in progress, too."""
        if speed != self.speed:
            self.speed = speed
            if self.doing == "move":
                self._change()

    def retarget(self, target: float) -> None:
        """Set a new end position for the move in progress."""
        self.target = target
        self._change()

    def rename(self, position: float) -> None:
        """Assign a new value to the present position."""
        shift = position - self.position
        self.position += shift
        self.target += shift
        self._update_limits()

    def set_limit(self, number: int, position: float | None, action: str) -> None:
        """Set the position and the action of a limit."""
        limit = self.limits[number]
        limit.action, limit.position, limit.raised = action, position, False
        self._update_limits()

    # ------------------------------------------------------------------------------------------------- motion

    @property
    def endless(self) -> bool:
        """True if the position of rest is not known."""
        return self.doing == "jog"

    def _forget(self) -> None:
        self.queue, self.released = [], 0

    def _rest(self) -> None:
        self.velocity, self.stretches = 0.0, []
        self._end()

    def _end(self) -> None:
        """Come to rest, and begin the next move."""
        self.doing, self.target = "idle", self.position
        self._next()

    def _next(self) -> None:
        if self.doing == "idle" and self.released:
            kind, value = self.queue.pop(0)
            self.released -= 1
            self.target = value if kind == "to" else self.position + value
            self.doing = "move"
            self._begin()

    def _begin(self) -> None:
        """Begin a motion; from now on, entering a limit is a fault again."""
        for limit in self.limits:
            limit.raised = False
        self._change()

    def _change(self) -> None:
        """Plan the motion again from the present state with the present settings."""
        if self.doing == "move":
            speed = self.speed * self.override
            if self.suspended or not speed:
                self.stretches = [*self._to_rest(self.decel), (inf, 0.0)]
            else:
                self.stretches = self._to(self.target, speed)
        elif self.doing == "jog":
            self.stretches = self._to_velocity(0.0 if self.suspended else self.jogging)
        self._update_limits()

    def _brake(self, rate: float) -> None:
        rest = self.position + self.velocity * abs(self.velocity) / (2.0 * rate)
        self.doing = "stop"
        if self.end is None or rest <= self.end:
            self.stretches = self._to_rest(rate)  # if not, the path ends first, and is already braked for
        self._update_limits()

    def _to_rest(self, rate: float) -> Stretches:
        v = self.velocity
        return [(abs(v) / rate, -copysign(rate, v))] if v else []

    def _to_velocity(self, wanted: float) -> Stretches:
        v, stretches = self.velocity, []
        if v * wanted < 0.0:
            stretches, v = self._to_rest(self.decel), 0.0
        rate = self.accel if abs(wanted) > abs(v) else self.decel
        if wanted != v:
            stretches.append((abs(wanted - v) / rate, copysign(rate, wanted - v)))
        return [*stretches, (inf, 0.0)]

    def _to(self, target: float, speed: float) -> Stretches:
        """Return the fastest motion to rest at a target.

        It begins with a stop if the axis moves away from the target, or cannot stop before it.
        """
        v, distance = self.velocity, target - self.position
        sign = copysign(1.0, distance if distance else v)
        u, size = v * sign, abs(distance)
        stopping = u * abs(u) / (2.0 * self.decel)
        if u < 0.0 or stopping > size + NEAR * (1.0 + size):
            rest = self.position + sign * stopping
            return [*self._to_rest(self.decel), *self._from_rest(target - rest, speed)]
        if abs(stopping - size) <= NEAR * (1.0 + size):
            return self._to_rest(self.decel)
        if u > speed:
            cruise_time = (size - stopping) / speed
            ramps = [
                ((u - speed) / self.decel, -self.decel),
                (cruise_time, 0.0),
                (speed / self.decel, -self.decel),
            ]
        else:
            ramps = self._ramps(size + u * u / (2.0 * self.accel), speed, u)
        return [(time, rate * sign) for time, rate in ramps]

    def _from_rest(self, distance: float, speed: float) -> Stretches:
        return [
            (time, copysign(1.0, distance) * rate) for time, rate in self._ramps(abs(distance), speed, 0.0)
        ]

    def _ramps(self, size: float, speed: float, u: float) -> Stretches:
        """Return the sections of a move over a distance: ramp up, slew and ramp down.

        The distance counts from rest, but the ramp begins at speed `u`.
        """
        peak = min(speed, sqrt(2.0 * size / (1.0 / self.accel + 1.0 / self.decel)))
        cruise_time = (size - peak * peak * (0.5 / self.accel + 0.5 / self.decel)) / peak if peak else 0.0
        return [
            ((peak - u) / self.accel, self.accel),
            (max(0.0, cruise_time), 0.0),
            (peak / self.decel, -self.decel),
        ]

    # --------------------------------------------------------------------------------------------------- time

    def run(self, until: float) -> None:
        """Advance the time to `until`."""
        for _ in range(100_000):
            while self.stretches and self.stretches[0][0] <= 0.0:
                self.stretches.pop(0)
            if not self.stretches:
                if self.doing != "idle":
                    self._arrive()
                    continue
                self.time = until
                return
            span, rate = self.stretches[0]
            left = until - self.time
            limit, met = self._meets(rate, min(span, left))
            step = min(span, left, met)
            self._pass(step, rate)
            self.stretches[0] = (span - step, rate)
            if limit is not None:
                self._act(limit)
            elif step == span:
                self.stretches.pop(0)
                if rate and abs(self.velocity) < 1e-9 * (1.0 + self.speed):
                    self.velocity = 0.0
                self._update_limits()
            elif self.time >= until:
                return
            if (
                self.time >= until
                and not (self.stretches and self.stretches[0][0] <= 0.0)
                and (self.stretches or self.doing == "idle")
            ):
                return
        raise AssertionError("the reference axis comes to no end")

    def _pass(self, step: float, rate: float) -> None:
        self.position += (self.velocity + 0.5 * rate * step) * step
        self.velocity += rate * step
        self.time += step

    def _arrive(self) -> None:
        """Rest at the target if all sections are done."""
        self.velocity = 0.0
        if self.doing == "move":
            self.position = self.target
        self._end()

    # -------------------------------------------------------------------------------------------------- limits

    def _meets(self, rate: float, span: float) -> tuple[Limit | None, float]:
        """Return the first limit that is reached within `span`, and its time; inf if none."""
        found: tuple[Limit | None, float] = (None, inf)
        for limit in self.limits:
            if limit.position is None or limit.raised:
                continue
            gap = (limit.position - self.position) * limit.sign
            time = _first(self.velocity * limit.sign, rate * limit.sign, gap)
            if time is not None and time <= span and time < found[1]:
                found = (limit, time)
        return found

    def _update_limits(self) -> None:
        """React to every limit that the axis is beyond and moving further into."""
        rate = next((rate for time, rate in self.stretches if time > 0.0), 0.0)
        for limit in self.limits:
            if limit.position is None:
                limit.raised = False
                continue
            beyond = (self.position - limit.position) * limit.sign >= -1e-6
            heading = self.velocity * limit.sign > 0.0 or (not self.velocity and rate * limit.sign > 0.0)
            if (
                heading
                and rate * limit.sign < 0.0
                and self.velocity**2 < 2.0 * abs(rate) * REVERSAL_TOLERANCE
            ):
                heading = False
            if not (beyond and heading):
                limit.raised = False
            elif not limit.raised:
                self._act(limit)
                if limit.action not in {"ignore", "event"}:
                    return

    def _act(self, limit: Limit) -> None:
        limit.raised = True
        if limit.action == "ignore":
            return
        self.fault = limit.hit = True
        if limit.action == "abort":
            self.cancel()
        elif limit.action == "error-stop":
            self.suspended = False
            self._forget()
            self._brake(self.error_decel)


def _first(v: float, a: float, gap: float) -> float | None:
    """Return when a gap > 0 is closed, at velocity v and acceleration a.

    Return None if it is never closed, or is closed already.
    """
    if gap <= 1e-6:
        return None
    if not a:
        return gap / v if v > 0.0 else None
    under = v * v + 2.0 * a * gap
    if under < 0.0:
        return None
    root = sqrt(under)
    times = [time for time in ((-v + root) / a, (-v - root) / a) if time >= 0.0]
    return min(times, default=None)
