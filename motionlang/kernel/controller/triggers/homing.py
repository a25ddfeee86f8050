"""Homing: find the switch, leave it slowly, take an edge or index mark as datum.

A MintMT controller homes in this sequence: run at the homing speed towards the switch and stop on it, back off
at a lower speed until it opens, then, for an index, continue at creep speed in the same direction to the next mark.
The position becomes that of the datum at the exact time of the last edge. The axis continues to its stop and, if
an offset is given, moves to the position that far from the datum.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.faults import (
    LIMIT_FORWARD,
    LIMIT_REVERSE,
    SOFT_LIMIT_FORWARD,
    SOFT_LIMIT_REVERSE,
)
from motionlang.kernel.controller.motion.jog import jog
from motionlang.kernel.controller.motion.profile_playback import play
from motionlang.kernel.controller.queue.life import permit_motion
from motionlang.kernel.controller.queue.plan import plan_distance, rates
from motionlang.kernel.controller.queue.stop import come_to_rest
from motionlang.kernel.controller.queue.track import define_position
from motionlang.kernel.controller.triggers.limit import Limit
from motionlang.kernel.controller.watch import Watch, begin, end, watched_position
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import LoggedMove

Rates = tuple[float | None, float | None]

# The target of the search: the home switch, the limit switch of its direction, or only an index mark.
HOME, LIMIT, INDEX = "home", "limit", "index"
# In order of occurrence; "done" is also the state after any other end of the homing.
STATES = ("done", "search", "on-switch", "back-off", "index", "stopping", "offset")

# The endless motion of an axis that has nothing ahead of it.
_ENDLESS = {
    "search": "homes away from its {0} and never reaches it",
    "back-off": "backs off its {0} and never leaves it",
    "index": "homes and never reaches an index mark",
}
_SOFT = (SOFT_LIMIT_FORWARD, SOFT_LIMIT_REVERSE)


class Homing:
    """One homing in progress on one axis; `found` is set when the datum is known.

    `direction` is that of the search, speeds are counts/s, `rates` its acceleration and deceleration, counts/s² (None:
    that of the axis). `datum` is the position given to the datum, `before` its position until then, and `offset` how
    far from it the axis ends (None: where it stops). `line` is the program line that began the homing. `provided` is
    true if the machine has the switch or mark that the homing searches for. `ended` is called at the end, whatever its
    cause.
    """

    def __init__(
        self,
        a: Axis,
        direction: int,
        speed: float,
        back_off_speed: float,
        creep_speed: float,
        *,
        switch: str = HOME,
        index: bool = False,
        datum: float = 0.0,
        offset: float | None = None,
        rates: Rates = (None, None),
        provided: bool = True,
        ended: Callable[[Homing], None] | None = None,
        command: str = "HOME",
        line: int = 0,
    ) -> None:
        self.a, self._direction = a, direction
        self.speed, self.back_off_speed, self._creep_speed = speed, back_off_speed, creep_speed
        self._switch, self._index, self._datum, self._offset = switch, index, datum, offset
        self._rates = rates
        self._ended, self._command, self.line = ended, command, line
        self.provided = provided
        self._watch: Watch | None = None
        self._move: LoggedMove | None = None
        self.found = False
        self.before = 0.0
        self.state = "done"
        # Called first when the axis comes to rest, so that no other subscriber sees it at rest in between.
        a.homing = self
        a.controller.listeners.put_first(self._on_change)
        self._allow_limit(False)
        try:
            if switch == INDEX:
                self._seek_index(direction, speed)
            else:
                self._search()
        except Rejected:
            self._release()
            raise

    def cancel(self) -> None:
        """End the homing, complete or not; the cause of its end then controls the axis."""
        self.state = "done"
        if self._move is not None:
            self._move.rates = None  # a stop that ends the homing is one at the rates of the axis
        if self._on_change not in self.a.controller.listeners:
            return
        self._release()
        if self._ended is not None:
            self._ended(self)

    def replaced(self, move: LoggedMove) -> None:
        """End the homing if `move`, which another motion has replaced, is its own."""
        if move is self._move:
            self.cancel()

    def _release(self) -> None:
        """Return the control of the axis and of its limits."""
        self.a.controller.listeners.remove(self._on_change)
        self.a.homing = None
        self._allow_limit(True)
        self._unwatch()

    @property
    def endless_motion(self) -> str:
        """The reason why the motion never ends; "" if it will reach a watch or stop."""
        a = self.a
        velocity = a.profiles[-1].end_velocity
        if self.state not in _ENDLESS or not velocity:
            return ""
        here = a.actual_position
        deaf = {limit.watch for limit in a.limits if not limit.enabled and limit.bit in _SOFT}
        ahead = any(
            0.0 < (watched_position(a, watch) - here) * velocity < math.inf
            for watch in a.watches
            if watch not in deaf
        )
        if ahead:
            return ""
        what = "limit switch" if self._switch == LIMIT else "switch"
        if self.has_passed_switch:
            return f"axis {self.a.index} ran past its {what} while stopping and does not meet it again"
        if not self.provided and self.state == "search":
            return f"axis {self.a.index} homes towards a {what} that does not exist"
        return f"axis {self.a.index} {_ENDLESS[self.state].format(what)}"

    @property
    def has_passed_switch(self) -> bool:
        """True while the axis returns to a switch that opened during the stop."""
        return self.state == "back-off" and not self._on_switch()

    def _take(self, step: Callable[[], None]) -> None:
        """Take the next step; one that is rejected ends the homing with a run-time fault."""
        try:
            step()
        except Rejected as rejected:
            rejected.line = rejected.line or self.line
            a = self.a
            self.cancel()
            if a.move is not None:
                come_to_rest(a)
            a.controller.motion_listener.refuse(a)
            a.controller.run_time_fault(rejected)

    def _unwatch(self) -> None:
        if self._watch is not None:
            end(self.a, self._watch)
            self._watch = None

    # ---------------------------------------------------------------------------------------------- moving

    def _jog(self, velocity: float) -> None:
        self._move = None  # this jog may replace the previous one
        permit_motion(self.a)
        jog(self.a, velocity, self._command, self.line, self._rates)
        self._move = self.a.move

    def _search(self) -> None:
        """Move towards the switch; if the axis is already on it, back off at once."""
        if self._on_switch():
            self._back_off()
            return
        self.state = "search"
        self._jog(self._direction * self.speed)

    def _back_off(self) -> None:
        self.state = "back-off"
        self._jog(-self._direction * self.back_off_speed)

    def _seek_index(self, direction: int, speed: float) -> None:
        """Continue to the next mark of the encoder, a machine position."""
        self.state = "index"
        mark = next_index(self.a, direction)
        self._jog(direction * speed)
        self._watch = Watch(mark, lambda _: self._take(self._datum_found), physical=True)
        begin(self.a, self._watch)

    def _datum_found(self) -> None:
        """Set the datum at the last edge; the axis continues to its stop."""
        self._unwatch()
        self.state = "stopping"
        self.found = True
        self.before = round(self.a.actual_position, 5)  # an edge is met within a millionth of a count
        define_position(self.a, self._datum)
        self.a.set_home()
        come_to_rest(self.a)

    def _go_to_offset(self, offset: float) -> None:
        """Move from the stop to the offset position, at creep speed."""
        self.state = "offset"
        a = self.a
        accel, decel = self._rates
        if accel is None or decel is None:
            its = rates(a, self._creep_speed)
            accel, decel = accel or its[0], decel or its[1]
        jerks = a.jerks(self._creep_speed, accel, decel)
        accel, decel = min(accel, a.max_accel), min(decel, a.max_decel)
        target = self._datum + offset
        here, speed = a.position(a.clock.now), min(self._creep_speed, a.max_speed)
        profile = plan_distance(a, a.shape, here, target, (speed, accel, decel), jerks)
        permit_motion(a)
        play(a, profile, self._command, self.line)
        self._move = a.move

    # --------------------------------------------------------------------------------------------- switches

    def _limits(self) -> list[Limit]:
        bit = LIMIT_FORWARD if self._direction > 0 else LIMIT_REVERSE
        return [limit for limit in self.a.limits if limit.bit == bit]

    def _on_switch(self) -> bool:
        if self._switch == HOME:
            return self.a.is_at_home
        return any(limit.active for limit in self._limits())

    def _allow_limit(self, allowed: bool) -> None:
        """Enable or disable the software limits, and a limit switch used for homing."""
        searched = self._limits() if self._switch == LIMIT else []
        for limit in [*searched, *(each for each in self.a.limits if each.bit in _SOFT)]:
            limit.enabled = allowed

    def _on_change(self, what: str, axis: int) -> None:
        if axis != self.a.index:
            return
        if what == "fault":
            self.cancel()
        elif what == self._switch:
            self._take(self._switch_changed)

    def _switch_changed(self) -> None:
        active = self._on_switch()
        if self.state == "search" and active:
            self.state = "on-switch"
            come_to_rest(self.a)
        elif self.state == "back-off" and not active:
            if self._index:
                self._seek_index(-self._direction, self._creep_speed)
            else:
                self._datum_found()

    def at_rest(self) -> None:
        """Handle a stop: after the search, on the switch or past it, or at the end."""
        self._take(self._go_on)

    def _go_on(self) -> None:
        if self.state == "on-switch":
            self._back_off()  # also if the stop ran across the complete switch: it returns across it
            return
        offset = self._offset
        here = self.a.actual_position - self._datum
        if self.state == "stopping" and offset is not None and here != offset:
            self._go_to_offset(offset)
            return
        self.cancel()


def next_index(a: Axis, direction: int) -> float:
    """Return the next index mark in a direction, machine counts; infinite if none."""
    pitch = a.index_pitch
    if not pitch > 0:
        return math.inf * direction
    here = a.actual_position - a.datum - a.index_origin
    step = here / pitch
    mark = math.floor(step + 1e-9) + 1 if direction > 0 else math.ceil(step - 1e-9) - 1
    return mark * pitch + a.index_origin
