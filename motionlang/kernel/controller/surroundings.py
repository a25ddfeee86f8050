"""The wiring of the controller: switches, inputs and faults from outside.

They depend on time, position or program line. Lengths are user units here, as in the machine file. They
become counts with the scale that the program sets, and are converted again when it sets another one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.events import note
from motionlang.kernel.controller.faults import (
    DRIVE,
    ERROR_INPUT,
    FOLLOWING_ERROR,
    LIMIT_FORWARD,
    LIMIT_REVERSE,
)
from motionlang.kernel.controller.io.sensor import Sensor
from motionlang.kernel.controller.motion.encoder import AUXILIARY
from motionlang.kernel.controller.triggers.limit import Limit
from motionlang.kernel.controller.triggers.region import Region

if TYPE_CHECKING:
    from motionlang.kernel.controller.operations import Controller

Entry = Mapping[str, object]

Settings = Mapping[str, object]

Pair = Sequence[float]

# The faults that a machine file may inject, with their fault bit and action.
FAULTS: dict[str, tuple[int, str]] = {
    "following-error": (FOLLOWING_ERROR, "off"),
    "error-input": (ERROR_INPUT, "error-stop"),
    "forward-limit": (LIMIT_FORWARD, "abort"),
    "reverse-limit": (LIMIT_REVERSE, "abort"),
    "drive": (DRIVE, "off"),
}
CONTROLLER = "controller"


class Surroundings:
    """All events that reach a controller from outside.

    `driven` are the digital inputs with an external source: a wait for any other input can never end. `actions`
    overrides `FAULTS` by (axis, bit), as requested by the program. `lines` are the faults that occur when the
    program first reaches a line. `failed` is true from the first error of the controller itself on.
    """

    def __init__(self, controller: Controller, settings: Settings) -> None:
        self._controller = controller
        self._settings = settings
        # Regions in user units: (region, low, high), converted again whenever the scale changes.
        self._regions: list[tuple[Region, float, float]] = []
        self._limits: list[tuple[Limit, float]] = []
        self._sensors: list[Sensor] = []
        self.driven: set[int] = set()
        self.actions: dict[tuple[int, int], str] = {}
        self.lines: dict[int, list[Callable[[], None]]] = {}
        self.failed = False
        for axis in controller.axes:
            self._wire_axis(axis)
        self.wire_inputs(settings)
        for entry in _entries(settings, "fault"):
            self._wire_fault(entry)
        for entry in _entries(settings, "encoder"):
            self._wire_encoder(entry)
        for axis in controller.axes:
            self._wire_interlock(axis)
        controller.listeners.append(self._on_change, "scale")

    def wire_inputs(self, settings: Settings) -> None:
        """Wire the `[[input]]` and `[[analogue]]` entries of some settings.

        Their times count from now.
        """
        for entry in _entries(settings, "input"):
            for each in _along(entry) if "every" in entry and "between" in entry else (entry,):
                self._wire_channel("input", each, self._controller.inputs.__setitem__)
        for entry in _entries(settings, "analogue"):
            self._wire_channel("analogue", entry, self._controller.analogue_inputs.__setitem__)

    def _wire_axis(self, axis: int) -> None:
        """Wire the travel limits and the home switch, with their input channels, if any."""
        get = self._settings.get
        self._fit_motor(axis)
        self._controller.axes[axis].index_every = get(f"axis.{axis}.index_every", 0.0)  # type: ignore[assignment]
        self._controller.axes[axis].index_origin = -self._start(axis) * self._scale(axis)
        travel: Pair | None = get(f"axis.{axis}.travel")  # type: ignore[assignment]
        if travel is not None:
            low, high = travel
            self._wire_limit(axis, -1, LIMIT_REVERSE, low, get(f"axis.{axis}.reverse_input"))
            self._wire_limit(axis, +1, LIMIT_FORWARD, high, get(f"axis.{axis}.forward_input"))
        switch: Pair | None = get(f"axis.{axis}.home_switch")  # type: ignore[assignment]
        if switch is not None:
            low, high = switch
            channel = get(f"axis.{axis}.home_input")
            self._wire_region(axis, low, high, self._home_change(axis, channel))

    def _wire_interlock(self, axis: int) -> None:
        """Wire the enable input: the drive is disabled while the input is off."""
        channel: int | None = self._settings.get(f"axis.{axis}.enable_input")  # type: ignore[assignment]
        if channel is None:
            return
        controller = self._controller
        controller.axes[axis].enable_input = channel
        self.driven.add(channel)

        def changed(number: int, _: float) -> None:
            if number == channel and not controller.may_enable(axis) and controller.is_enabled(axis):
                note(controller.axes[axis], "e-stop", text=f"input {channel} is off")
                controller.disable(axis)

        controller.inputs.listeners.append(changed)
        changed(channel, 0.0)

    def _fit_motor(self, axis: int) -> None:
        """Attach the simulated motor of the machine file; it trips with the axis's action."""
        start = f"axis.{axis}.plant."
        plant = {key[len(start) :]: value for key, value in self._settings.items() if key.startswith(start)}
        if not plant:
            return
        from motionlang.kernel.controller.feedback import Feedback

        start = f"axis.{axis}.servo."
        servo = {key[len(start) :]: value for key, value in self._settings.items() if key.startswith(start)}
        a, bit = self._controller.axes[axis], FOLLOWING_ERROR
        a.feedback = Feedback(a, plant, servo)
        a.feedback.tripped = lambda: self._controller.fault(axis, bit, self.actions.get((axis, bit), "off"))

    def _home_change(self, axis: int, channel: object) -> Callable[[bool], None]:
        def change(inside: bool) -> None:
            self._controller.set_home_switch(axis, inside)
            if channel is not None:
                self._controller.inputs[channel] = int(inside)  # type: ignore[index]

        if channel is not None:
            self.driven.add(channel)  # type: ignore[arg-type]
        return change

    def _wire_limit(self, axis: int, sign: int, bit: int, position: float, channel: object) -> None:
        limit = self._controller.add_limit(axis, sign, bit, "abort", physical=True)
        position -= self._start(axis)
        self._limits.append((limit, position))
        limit.set_position(position * self._scale(axis))
        if channel is not None:
            position += self._start(axis)
            low, high = (position, INFINITY) if sign > 0 else (-INFINITY, position)
            self.driven.add(channel)  # type: ignore[arg-type]
            self._wire_region(axis, low, high, self._channel_change(channel))

    def _channel_change(self, channel: object) -> Callable[[bool], None]:
        def change(inside: bool) -> None:
            self._controller.inputs[channel] = int(inside)  # type: ignore[index]

        return change

    def _wire_channel(self, table: str, entry: Entry, put: Callable[[int, float], None]) -> None:
        """Wire one `[[input]]` or `[[analogue]]`: by time, by position, or by an output."""
        channel, value = int(_number(entry, "channel")), _number(entry, "value", 1)
        self.driven.add(channel)
        if "asked" in entry:
            channels = self._controller.inputs if table == "input" else self._controller.analogue_inputs
            asking = self._controller.answering()
            asking.add_channel(table, channels, entry, self._controller.clock.now, value)
        elif "axis" in entry:
            self._wire_position(entry, channel, value, put)
        elif "output" in entry:
            self._wire_output(entry, partial(put, channel), int(value))
        else:
            stimuli, now = self._controller.stimuli, self._controller.clock.now
            stimuli.add_pulse(table, entry, partial(put, channel), value, since=now, at_once=True)

    def _wire_position(
        self, entry: Entry, channel: int, value: float, put: Callable[[int, float], None]
    ) -> None:
        def change(active: bool) -> None:
            put(channel, value if active else 0)

        axis, (low, high) = int(_number(entry, "axis")), _span(entry)
        if "per_unit" in entry:
            origin = (low if low > -INFINITY else high) - self._start(axis)
            rise = _number(entry, "per_unit")
            sensor = Sensor(self._controller.axes[axis], origin, float(value), rise, channel)
            self._sensors.append(sensor)
            change = sensor.switch
        self._wire_region(axis, low, high, change)

    def _wire_output(self, entry: Entry, put: Callable[[float], None], on: int) -> None:
        """Wire an `[[input]]` that follows an output after a delay, or is active for some time after it changes.

        An example is a valve and the sensor that sees it.
        """
        stimuli, off = self._controller.stimuli, int(not on)
        if "for" in entry:
            put(off)
            stimuli.add_pulse("input", entry, put, on, off)
            return
        put(on if self._controller.outputs.inverted(int(_number(entry, "output"))) else off)
        for level, value in ((1, on), (0, off)):
            stimuli.add("input", {**entry, "level": level}, partial(put, value))

    def _wire_encoder(self, entry: Entry) -> None:
        """Wire an `[[encoder]]`, which runs at a velocity, counts/s, from a given time."""
        controller = self._controller
        number = (
            int(_number(entry, "channel")) if "channel" in entry else AUXILIARY + int(_number(entry, "aux"))
        )
        velocity, accel = _number(entry, "velocity"), _number(entry, "accel", 0.0)
        encoder = controller.encoder(number)
        encoder.index_every = _number(entry, "index_every", encoder.index_every)
        self._at(_number(entry, "at", 0.0), lambda: controller.drive_encoder(number, velocity, accel))

    def _wire_fault(self, entry: Entry) -> None:
        axis = int(_number(entry, "axis", 0))
        kind = str(entry["kind"])
        bit, action = FAULTS.get(kind, (0, ""))

        def happen(active: bool = True) -> None:
            if not active:
                return
            if kind == CONTROLLER:
                if not self.failed:  # a pending error is not new
                    self.failed = True
                    self._controller.notify("misc", 1)
                return
            self._controller.fault(axis, bit, self.actions.get((axis, bit), action))

        if "line" in entry:
            self.lines.setdefault(int(_number(entry, "line")), []).append(happen)
        elif "above" in entry or "below" in entry:
            low, high = _span(entry)
            self._wire_region(axis, low, high, happen)
        else:
            self._at(_number(entry, "at", 0.0), happen)

    def reach(self, line: int) -> None:
        """Inject the faults of a line that the program has reached."""
        for happen in self.lines.pop(line, ()):
            happen()

    def _at(self, time: float, call: Callable[[], None]) -> None:
        """Call now if `time` is that of power-up; schedule the call if it is later."""
        if time <= self._controller.clock.now:
            call()
        else:
            self._controller.clock.at(time, call)

    def _wire_region(self, axis: int, low: float, high: float, change: Callable[[bool], None]) -> None:
        scale = self._scale(axis)
        low, high = low - self._start(axis), high - self._start(axis)
        region = Region(self._controller.axes[axis], low * scale, high * scale, change)
        self._regions.append((region, low, high))

    def _start(self, axis: int) -> float:
        """Return the machine position at power-up, at which counting begins."""
        return self._settings.get(f"axis.{axis}.start", 0.0)  # type: ignore[return-value]

    def _scale(self, axis: int) -> float:
        return self._controller.axes[axis].scale.counts

    def _on_change(self, what: str, axis: int) -> None:
        """Move every switch of an axis to its new count after a change of the scale."""
        scale = self._scale(axis)
        self._controller.axes[axis].index_origin = -self._start(axis) * scale
        for region, low, high in self._regions:
            if region.a.index == axis:
                region.place(low * scale, high * scale)
        for sensor in self._sensors:
            if sensor.a.index == axis:
                sensor.rescale()
        for limit, position in self._limits:
            if limit.a.index == axis:
                limit.set_position(position * scale)


def _entries(settings: Settings, name: str) -> Sequence[Entry]:
    return settings.get(name, ())  # type: ignore[return-value]


def _along(entry: Entry) -> Iterator[Entry]:
    for n in range(int(_number(entry, "times"))):
        yield {**entry, "between": [bound + n * _number(entry, "every") for bound in _span(entry)]}


def _number(entry: Entry, key: str, default: float | None = None) -> float:
    value = entry.get(key, default)
    assert value is not None, f"the machine file was not checked for {key}"
    return value  # type: ignore[return-value]


def _span(entry: Entry) -> tuple[float, float]:
    """Return the region that `above`, `below` or `between` names."""
    if "between" in entry:
        between: Pair = entry["between"]  # type: ignore[assignment]
        return between[0], between[1]
    if "above" in entry:
        return _number(entry, "above"), INFINITY
    return -INFINITY, _number(entry, "below")
