"""The life cycle of a move, from the axis's buffer (or `move_to`) to its end.

`start_move` plans a `Profile` from the axis's state and settings, appends it to the axis's track and
schedules one event for its end. `arrive` starts the next move of the buffer, if `go` (in `axis_verbs`) has
released it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from motionlang.kernel.controller import events, watch
from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.events import BY_DESIGN
from motionlang.kernel.controller.queue import buffer, stop
from motionlang.kernel.controller.readings import Readings
from motionlang.kernel.controller.triggers import conditions
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import MAX_PIECES, Move
from motionlang.kernel.planners import Profile, hold
from motionlang.kernel.planners.target import plan_trapezoid

if TYPE_CHECKING:
    from motionlang.kernel.controller.triggers.conditions import Together


class Core(Readings):
    """The execution of moves, for every kind of motion in the buffer or in progress."""

    def move_to(self, axis: int, position: float, command: str = "", line: int = 0) -> None:
        """Move to `position` now, from any state of motion."""
        a = self.movable(axis)
        move = buffer.stamped(a, Move(axis, command, line, position))
        move.released = True
        profile = self.plan_move(a, move)
        self.end_move(a, "retarget")
        self.run_profile(a, move, profile)

    def move_by(self, axis: int, distance: float, command: str = "", line: int = 0) -> None:
        """Move by `distance` now, from the present target, if any, or from the position."""
        a = self.movable(axis)
        base = a.target if abs(a.target) < INFINITY else a.position(self.clock.now)
        self.move_to(axis, base + distance, command, line)

    def movable(self, axis: int) -> Axis:
        """Return an axis that may move.

        Raises Rejected while the axis is disabled, is locked by an error, has its brake set, or is in a motion that
        allows no other.
        """
        a = self.axes[axis]
        conditions.refuse_motion(self, a)
        if a.move is not None and a.move.action is not None and a.move.action.exclusive:
            words = f"axis {axis} is in {a.move.command}, which takes no other motion"
            raise Rejected("moving", words, "stop it before another motion")
        self._hold(a)
        return a

    def _hold(self, a: Axis) -> None:
        """Close the loop of a simulated motor whose output was set manually."""
        if a.feedback is not None and a.enabled:
            a.feedback.take_over(self)

    def rates(self, a: Axis, speed: float) -> tuple[float, float]:
        """Return the rates for a move at `speed`; raise Rejected unless both are positive."""
        accel, decel = a.rates(speed)
        _check_rate(a, accel, "an acceleration", "move")
        _check_rate(a, decel, "a deceleration", "move")
        return accel, decel

    def speed_and_rates(self, a: Axis, move: Move) -> tuple[float, float, float]:
        """Like `Axis.speed_and_rates`; at speed 0 the axis holds, and the rates in force stay.

        Raises Rejected if the axis cannot move.
        """
        speed, accel, decel = a.speed_and_rates(move)
        if speed:
            self.rates(a, speed)
            return speed, accel, decel
        self.notify("held", a.index)
        in_force = move.rates_in_force or (a.accel, a.decel)
        return 0.0, accel or in_force[0], decel or in_force[1]

    def decel(self, a: Axis, speed: float) -> float:
        """Return the rate of a stop from `speed`; raise Rejected unless positive."""
        decel = a.rates(speed)[1]
        _check_rate(a, decel, "a deceleration", "stop")
        return decel

    def plan_move(self, a: Axis, move: Move, rates: tuple[float, float] | None = None) -> Profile:
        """Return the profile of a move from the present state of its axis, at `rates` or those of the settings."""
        speed, accel, decel = self.speed_and_rates(a, move)
        accel, decel = rates or (accel, decel)
        shape = a.shape
        jerks = a.jerks(speed, accel, decel) if shape == "scurve" else (INFINITY, INFINITY)
        if move.overridden:
            speed *= a.override
        move.commanded_speed = speed
        if a.limited:
            if speed > a.max_speed:
                events.clamped(self, a, move.line, speed)
            speed, accel, decel = min(speed, a.max_speed), min(accel, a.max_accel), min(decel, a.max_decel)
        move.rates_in_force = accel, decel
        if a.suspended or not speed:
            return stop.with_standstill(self, a)
        last = a.profiles[-1]
        try:
            if last.shape == "hold" and shape == "trapezoid":  # the case of nearly every move
                return plan_trapezoid(last.end, move.target, speed, accel, decel)
            # Changes of a motion in progress, and shapes, are imported by the first program that uses them.
            from motionlang.kernel.planners import plan
            from motionlang.kernel.planners.ramp_down import onset

            eased, start, velocity, acceleration = onset(last, self.clock.now - a.starts[-1], shape, jerks[0])
            made = plan(
                shape, start, move.target, speed, accel, decel, velocity, a.ramp, *jerks, acceleration
            )
            return made if eased is None else eased.then(made)
        except ValueError as problem:
            raise Rejected("range", f"axis {a.index} cannot move: {problem}") from None

    def start_move(self, a: Axis, move: Move) -> None:
        self.run_profile(a, move, self.plan_move(a, move))

    def run_profile(self, a: Axis, move: Move, profile: Profile, cause: str = "") -> None:
        self.log_move(a, move, profile)
        self.append_profile(a, profile, cause)

    def log_move(self, a: Axis, move: Move, profile: Profile) -> None:
        """Log the start of a move and make it the move in progress of its axis."""
        move.profile, move.start_time = profile, self.clock.now
        move.scale, move.zero = a.scale.counts, a.scale.zero
        a.move = move  # first: an interrupt in between then leaves no log entry without an owner
        self.log.moves.add(move)
        a.target = move.target
        for limit in a.limits:
            limit.forget()

    def together(self) -> Together:
        """Return a block that starts several axes; limits are checked at its end."""
        return conditions.Together(self)

    def append_profile(self, a: Axis, profile: Profile, cause: str = "") -> None:
        """Follow `profile` from now on, and schedule its end."""
        if a.arrival is not None:
            a.arrival.cancel()
        end = self.clock.now + profile.duration
        a.arrival = self.clock.at(end, lambda: self.arrive(a)) if end < INFINITY else None
        self.extend_track(a, profile, cause)

    def extend_track(self, a: Axis, profile: Profile, cause: str = "", ended: Move | None = None) -> None:
        """Put `profile` on the track now: solve watches, notify followers, check limits.

        A jump of velocity is reported with its `cause`, unless the profile is `BY_DESIGN`. `ended` is the move that a
        standstill ends.
        """
        if cause != BY_DESIGN and (profile.start_velocity or a.profiles[-1].shape != "hold"):
            events.check_velocity(self, a, profile, cause, ended or a.move)
        self.motion_listener.add(a)
        now = self.clock.now
        a.starts.append(now)
        a.profiles.append(profile)
        a.present = profile
        log = self.log
        log.room -= 1
        if log.room < 0:
            self.make_room()
        if a.feedback is not None:
            a.feedback.changed()
        else:
            if a.watches:
                watch.solve(a, self.clock)
            if a.present is not profile:  # a crossed watch has given it another profile and notified of that
                return
        for follower in tuple(a.followers):
            follower(profile)
        for limit in a.limits:
            limit.check()

    def make_room(self) -> None:
        """Pack old profiles of all tracks to free memory."""
        self.log.make_room((*self.axes.values(), *self.encoders.values()))

    def finish_updates(self) -> None:
        """Roll back or finish partial updates after an interrupt."""
        axes = (*self.axes.values(), *self.encoders.values())
        self.log.finish_updates(axes)
        for a in axes:
            del a.starts[len(a.profiles) :]
        self.motion_listener.finish_updates()

    def arrive(self, a: Axis) -> None:
        """Handle the end of the profile of the move in progress."""
        a.arrival = None
        a.move = None
        self.extend_track(a, hold(a.profiles[-1].end), BY_DESIGN)
        self.go_on(a)

    def go_on(self, a: Axis) -> None:
        """Start the next entry of the buffer at rest; skip an entry that cannot begin."""
        if a.index in self.homings:
            self.homings[a.index].at_rest()
        self.start_waiting(a)
        if a.move is None:
            self.notify("idle", a.index)

    def start_waiting(self, a: Axis) -> None:
        """Start the next entry like `start_next`, with no statement waiting for it.

        Each rejected entry is a run-time fault.
        """
        while True:
            try:
                self.start_next(a)
                return
            except Rejected as rejected:
                self.run_time_fault(rejected)

    def start_next(self, a: Axis) -> None:
        """Start the next entry of the buffer, if it is released.

        Raises Rejected for an entry that cannot begin. The entry is skipped, and the ones behind it start once the
        error has been handled.
        """
        while a.move is None and a.index not in self.homings and a.buffer and a.buffer[0].released:
            move = a.buffer[0]
            if move.action is not None and not (
                move.action.ready(self, a, move) and (move.action.can_stand or not a.suspended)
            ):
                return
            self.take_entry(a)
            try:
                if move.action is None:
                    buffer.resolve(a, move)
                    self.start_move(a, move)
                else:
                    move.action.begin(self, a, move)
            except Rejected as rejected:
                rejected.line = rejected.line or move.line
                for each in (a,) if move.action is None else move.action.together_with(a):
                    self.motion_listener.refuse(each)
                    self._begin_waiting(each)
                raise

    def take_entry(self, a: Axis, index: int = 0) -> None:
        """Remove an entry, by default the first one, from the move buffer."""
        a.last_id = a.buffer.pop(index).id
        if a.buffer_low >= 0:
            buffer.taken(self, a)

    def empty(self, a: Axis, ended: str) -> None:
        """Discard and log the buffer, with related entries in the buffers of other axes."""
        entries, a.buffer = a.buffer, []
        for move in entries:
            dropped = [move] if move.action is None else [move, *move.action.purge(a)]
            for each in dropped:
                each.ended = ended
            if move.action is None or not move.action.is_sequel:
                for each in dropped:
                    self._log_dropped(each)
            for each in dropped:
                if each.axis != a.index:  # entries behind a path continue, unless they are discarded too
                    self._begin_waiting(self.axes[each.axis])

    def _begin_waiting(self, a: Axis) -> None:
        """Schedule the start of the buffer after all other events of this time."""

        def begin() -> None:
            if a.index in self.homings or not a.buffer:
                return
            if a.move is None:
                if not a.suspended:
                    self.go_on(a)
            elif a.move.action is not None:
                a.move.action.more(self, a)

        self.clock.at(self.clock.now, begin)

    def drop(self, axes: Iterable[int], command: str, line: int, ended: str) -> None:
        """Log a motion that a language had deferred and will not execute."""
        for axis in axes:
            move = Move(axis, command, line, self.axes[axis].target)
            move.ended = ended
            self._log_dropped(move)

    def _log_dropped(self, move: Move) -> None:
        self.log.dropped.add(move)
        self.log.note(self.clock.now, "dropped", move.axis, ordered=move.line, text=move.command)

    def replan_move(self, a: Axis) -> None:
        """Replan the move in progress to the same target with the present settings."""
        assert a.move is not None
        if a.move.action is None:
            self.continue_with(a, self.plan_move(a, a.move), "")
        else:
            a.move.action.replan(self, a)

    def continue_with(self, a: Axis, profile: Profile, ended: str) -> None:
        """Replace the rest of the present move by `profile`."""
        assert a.move is not None
        self.amend_log([a.move], [profile], ended)
        self.append_profile(a, profile)

    def amend_log(self, entries: Sequence[Move], profiles: Sequence[Profile], ended: str) -> None:
        """Replace the rest of a move, or of a path's moves, in the log only.

        Entries with many pieces continue as others, those of a path all at once.
        """
        now = self.clock.now
        parts = [move.until(now) for move in entries]
        is_full = not ended and max(len(done.knots) for done in parts) > MAX_PIECES
        for move, done, profile in zip(entries, parts, profiles, strict=True):
            self.log.room -= 2  # a changed profile is stored piece by piece, and takes three times as much
            if is_full:
                self.log.moves.split(move, done, now, len(done.knots))
                move.profile = profile
                continue
            # If a new zero was set in between, the two differ by it, and by its rounding.
            move.profile = done.then(profile.scaled(done.end, 1.0) if move.offset else profile)
            move.ended = ended or move.ended

    def end_move(self, a: Axis, ended: str) -> None:
        """Close the log entry of a move that is being replaced; the motion continues."""
        move = a.move
        if move is not None and move.profile is not None:
            if move.action is not None:
                move.action.leave(self, a, ended)
            done = move.until(self.clock.now)
            exact = a.here(self.clock.now) - move.offset
            # An axis that has not moved is where it was. The position of one on two blended paths is that of
            # neither path.
            if done.distance and abs(exact - done.end) < watch.margin(exact):
                done = done.ending_at(exact)
            move.profile = done
            move.ended = ended
            a.move = None
            if a.index in self.homings:
                self.homings[a.index].replaced(move)

    def freeze(self, a: Axis, ended: str) -> None:
        """Stop the axis at once at its present position."""
        self.motion_listener.freeze(a, ended)
        conditions.release(self, a)
        if a.index in self.homings:
            self.homings[a.index].cancel()
        self.empty(a, ended)
        if a.arrival is not None:
            a.arrival.cancel()
            a.arrival = None
        move = a.move
        if move is None:
            return
        a.target = here = a.here(self.clock.now)
        self.end_move(a, ended)
        self.extend_track(a, hold(here), ended, move)
        self.notify("idle", a.index)


def _check_rate(a: Axis, rate: float, what: str, purpose: str) -> None:
    """Raise Rejected unless a rate is positive; `what` is its name with an article."""
    if not rate > 0:
        name = what.split()[1]
        raise Rejected(
            "zero-acceleration",
            f"axis {a.index} cannot {purpose}: its {name} is {rate:.10g}",
            f"a {purpose} needs {what} above zero",
        )
