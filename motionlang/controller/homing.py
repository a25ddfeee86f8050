"""Homing: find the switch, leave it slowly, find the index mark if asked to, and call that place the datum.

The sequence of a MintMT controller as its users know it: run at the homing speed towards the switch and stop on it,
back off at a lower speed until it opens, then, for an index, creep on in the same direction to the next mark. The
position becomes that of the datum at the exact moment of the last edge.
"""

from __future__ import annotations

import math

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.axis import Axis
    from motionlang.controller.controller import Controller
    from motionlang.controller.watch import Watch


class Homing:
    """One homing in progress on one axis; `found` turns true when the datum is known.

    `direction` is that of the search, `switch` and `index` say what is looked for, speeds are counts/s, `datum` is the
    position that the found place gets. `state` is "search", "back-off", "index", "stopping" or "done".
    """

    __slots__ = (
        "_command",
        "_controller",
        "_creep_speed",
        "_datum",
        "_direction",
        "_index",
        "_line",
        "_watch",
        "axis",
        "back_off_speed",
        "found",
        "speed",
        "state",
    )

    def __init__(
        self,
        controller: Controller,
        axis: int,
        direction: int,
        speed: float,
        back_off_speed: float,
        creep_speed: float,
        *,
        switch: bool = True,
        index: bool = False,
        datum: float = 0.0,
        command: str = "HOME",
        line: int = 0,
    ) -> None:
        self._controller, self.axis, self._direction = controller, axis, direction
        self.speed, self.back_off_speed, self._creep_speed = speed, back_off_speed, creep_speed
        self._index, self._datum, self._command, self._line = index, datum, command, line
        self._watch: Watch | None = None
        self.found = False
        self.state = "done"
        controller.listeners.append(self._heard)
        if switch:
            self._search()
        else:
            self._seek_index(direction, speed)

    @property
    def _axis(self) -> Axis:
        return self._controller.axes[self.axis]

    def cancel(self) -> None:
        """Give up; the axis is left to whatever ended the homing."""
        self.state = "done"
        if self._heard in self._controller.listeners:
            self._controller.listeners.remove(self._heard)
        if self._watch is not None:
            self._controller.unwatch(self.axis, self._watch)
            self._watch = None

    def _jog(self, velocity: float) -> None:
        self._controller.jog(self.axis, velocity, self._command, self._line)

    def _search(self) -> None:
        """Towards the switch; an axis that already stands on it backs off at once."""
        if self._axis.home:
            self._back_off()
            return
        self.state = "search"
        self._jog(self._direction * self.speed)

    def _back_off(self) -> None:
        self.state = "back-off"
        self._jog(-self._direction * self.back_off_speed)

    def _seek_index(self, direction: int, speed: float) -> None:
        """On to the next mark of the encoder, which is where the machine has it."""
        self.state = "index"
        mark = next_index(self._controller, self.axis, direction)
        self._jog(direction * speed)
        self._watch = self._controller.watch(self.axis, mark, lambda _: self._datum_found(), physical=True)

    def _datum_found(self) -> None:
        """The last edge: this place is the datum; the axis runs on to its stop and keeps counting from it."""
        controller = self._controller
        self.state = "stopping"
        self.found = True
        controller.define_position(self.axis, self._datum)
        controller.stop(self.axis, "")

    def _heard(self, what: str, axis: int) -> None:
        if axis != self.axis:
            return
        if what == "fault":
            self.cancel()
        elif what == "home":
            self._switch_changed(self._axis.home)
        elif what == "idle":
            self._at_rest()

    def _switch_changed(self, active: bool) -> None:
        if self.state == "search" and active:
            self.state = "on-switch"
            self._controller.stop(self.axis, "")
        elif self.state == "back-off" and not active:
            if self._index:
                self._seek_index(-self._direction, self._creep_speed)
            else:
                self._datum_found()

    def _at_rest(self) -> None:
        """Stopped: past the switch or on it after the search, or at the end."""
        if self.state == "on-switch":
            self._back_off()  # also where the stop ran over the whole switch: it comes back over it
        elif self.state != "done":
            self.cancel()


def next_index(controller: Controller, axis: int, direction: int) -> float:
    """The next index mark in a direction, in counts of the machine; infinite where the encoder has none."""
    a = controller.axes[axis]
    pitch = a.index_every * a.scale.counts
    if not pitch > 0:
        return math.inf * direction
    here = a.position(controller.clock.now) - a.datum - a.index_origin
    step = here / pitch
    mark = math.floor(step + 1e-9) + 1 if direction > 0 else math.ceil(step - 1e-9) - 1
    return mark * pitch + a.index_origin
