"""Latches: positions captured exactly at an edge of an input or an index mark."""

from __future__ import annotations

from math import inf

from motionlang.controller.triggers.homing import next_index
from motionlang.controller.triggers.position_zones import Cells

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.axis import Axis
    from motionlang.controller.controller import Controller
    from motionlang.controller.triggers.position_zones import Cells
    from motionlang.controller.triggers.watch import Watch

RISING, FALLING, BOTH = 1, -1, 0


class Latch:
    """One latch channel: the position and time, `value` and `time`, of the last edge.

    `enabled` arms it. If it is `automatic` it latches repeatedly; if not, one edge disarms it. After an edge,
    others are ignored for `inhibit_time` seconds and `inhibit_distance` counts. An edge sets `fired`, `take`
    resets it.
    """

    def __init__(self, controller: Controller, number: int) -> None:
        self._controller, self.number = controller, number
        self._track: Axis | None = None
        self._channel: int | None = None
        self._edge = RISING
        self._marks: IndexMarks | None = None
        self.enabled = self.automatic = self.fired = False
        self.inhibit_time = self.inhibit_distance = 0.0
        self.value, self.time = 0.0, -inf

    def on_input(self, track: Axis, channel: int, edge: int) -> None:
        """Capture the position of an axis or an encoder at an edge of a digital input."""
        self.release()
        self._track, self._channel, self._edge = track, channel, edge
        self._controller.inputs.listeners.append(self._changed)

    def on_index(self, track: Axis) -> None:
        """Capture the position of an axis at its index marks."""
        self.release()
        self._track = track
        self._marks = IndexMarks(self._controller, track.index, self)

    def release(self) -> None:
        """End all captures."""
        if self._channel is not None:
            self._controller.inputs.listeners.remove(self._changed)
            self._channel = None
        if self._marks is not None:
            self._marks.remove()
            self._marks = None

    def take(self) -> bool:
        """Return and reset `fired`."""
        fired, self.fired = self.fired, False
        return fired

    def capture(self) -> None:
        """Capture the position at an edge, unless the edge is inhibited."""
        if not self.enabled or self._track is None:
            return
        now = self._controller.clock.now
        here = self._track.here(now)
        near = abs(here - self.value) < self.inhibit_distance
        if self.time > -inf and (now - self.time < self.inhibit_time or near):
            return
        self.value, self.time, self.fired = here, now, True
        if not self.automatic:
            self.enabled = False
        self._controller.notify("latch", self.number)

    def _changed(self, channel: int, value: float) -> None:
        if channel == self._channel and self._edge in (BOTH, RISING if value else FALLING):
            self.capture()


class IndexMarks:
    """Watches of the index marks next to the axis, which move with it."""

    def __init__(self, controller: Controller, axis: int, latch: Latch) -> None:
        self._controller, self.axis, self._latch = controller, axis, latch
        self._watches: dict[float, Watch] = {}
        controller.listeners.append(self._on_change, "scale")
        self._set_region()

    def remove(self) -> None:
        """Stop watching."""
        self._controller.listeners.remove(self._on_change)
        self._clear()

    def _clear(self) -> None:
        for watch in self._watches.values():
            self._controller.unwatch(self.axis, watch)
        self._watches.clear()

    def _set_region(self) -> None:
        marks = [next_index(self._controller, self.axis, direction) for direction in (-1, 1)]
        self._window([mark for mark in marks if abs(mark) < inf])

    def _window(self, marks: list[float]) -> None:
        """Watch these marks only; present watches of them remain."""
        for mark in [mark for mark in self._watches if mark not in marks]:
            self._controller.unwatch(self.axis, self._watches.pop(mark))
        for mark in marks:
            if mark not in self._watches:
                call = self._passed_at(mark)
                self._watches[mark] = self._controller.watch(self.axis, mark, call, physical=True)

    def _passed_at(self, mark: float) -> Callable[[int], None]:
        def passed(direction: int) -> None:
            pitch = self._controller.axes[self.axis].index_pitch
            self._window([mark - pitch, mark, mark + pitch])
            self._latch.capture()

        return passed

    def _on_change(self, what: str, axis: int) -> None:
        if what == "scale" and axis == self.axis:
            self._clear()
            self._set_region()


class Compare:
    """A digital output that is on between two positions, switched at the exact times."""

    def __init__(self, controller: Controller, axis: int, output: int, low: float, high: float) -> None:
        self._controller, self.axis, self.output = controller, axis, output
        self.enabled, self._inside = True, False
        self._cells: Cells | None = None
        self.place(low, high)

    def place(self, low: float, high: float) -> None:
        """Set the two positions."""
        self.remove()
        self.low, self.high = min(low, high), max(low, high)
        track = self._controller.axes[self.axis]
        self._cells = Cells(self._controller, track, (self.low, self.high), self._moved)
        self._moved(self._cells.index)

    def enable(self, enabled: bool) -> None:
        """Let the comparison control the output, or not."""
        self.enabled = enabled
        if enabled:
            self._show()

    def remove(self) -> None:
        """Stop comparing."""
        if self._cells is not None:
            self._cells.remove()
            self._cells = None

    def _moved(self, index: int) -> None:
        """Handle a change between below, inside and above; a new zero may skip inside."""
        inside = index == 1
        if inside is not self._inside:
            self._inside = inside
            if self.enabled:
                self._show()

    def _show(self) -> None:
        self._controller.outputs[self.output] = int(self._inside)
