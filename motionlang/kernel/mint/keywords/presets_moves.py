"""The types of preset, implemented by moves, jogs and references."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.kernel.errors import Rejected
from motionlang.kernel.mint.keywords.homing import Homes
from motionlang.kernel.mint.keywords.limits_resetting import StopModes, stop
from motionlang.kernel.mint.keywords.torque import TorqueReferences
from motionlang.kernel.planners.reference import Slope

if TYPE_CHECKING:
    from motionlang.kernel.mint.keywords.presets import Presets

Start = Callable[["Preset"], None]

COMMAND = "PRESETMOVE"


@dataclass(eq=False, slots=True)
class Preset:
    """One preset on one axis, with its values in counts and seconds."""

    presets: Presets
    axis: int
    number: int
    line: int

    def value(self, name: str) -> float:
        return self.presets.entry(name, self.number)

    @property
    def move_counts(self) -> float:
        """PRESETMOVEPOSITION as a distance in counts, which ignores the zero."""
        return self.presets.controller.axes[self.axis].scale.to_counts(self.value("PRESETMOVEPOSITION"))

    def speed(self, name: str) -> float | None:
        """Return a speed in counts/s, None if the axis's own speed applies."""
        scale = self.presets.controller.axes[self.axis].scale
        return abs(scale.to_counts(self.value(name), "uu/s")) or None

    def rate(self, name: str, speed: float | None) -> float | None:
        """Return a rate in counts/s², None if the axis's own rate applies."""
        a = self.presets.controller.axes[self.axis]
        time = self.presets.entry(name, self.number, 1)
        if time:
            return (speed or a.speed) / time * 1000.0
        return abs(a.scale.to_counts(self.value(name), "uu/s2")) or None

    def rates(self, speed: float | None) -> tuple[float | None, float | None]:
        return self.rate("PRESETACCEL", speed), self.rate("PRESETDECEL", speed)


def begin(presets: Presets, axis: int, number: int, line: int) -> None:
    """Start a preset on an axis, even while the axis moves."""
    kind = int(presets.entry("PRESETMOVETYPE", number))
    if not 0 < kind < len(MOVES):
        raise Rejected("range", f"preset {number} has no type", f"write PRESETMOVETYPE({number}, 0) first")
    MOVES[kind](Preset(presets, axis, number, line))


def _home(preset: Preset) -> None:
    homes = preset.presets.environment.component(Homes)
    homes.begin(preset.axis, int(preset.value("PRESETMOVEHOMETYPE")), preset.line)


def _jog(preset: Preset) -> None:
    controller = preset.presets.controller
    speed = preset.speed("PRESETJOGSPEED") or controller.axes[preset.axis].speed
    sign = -1.0 if preset.value("PRESETJOGDIRECTION") else 1.0
    controller.jog(preset.axis, sign * speed, COMMAND, preset.line, preset.rates(speed), True)


def _move(preset: Preset, by: bool) -> None:
    """Start a move at the preset's speed and rates, which later writes do not change."""
    controller, speed = preset.presets.controller, preset.speed("PRESETMOVESPEED")
    before = controller.axes[preset.axis].own_rates
    controller.configure(preset.axis, "own_rates", (speed, *preset.rates(speed)))
    try:
        if by:
            controller.move_by(preset.axis, preset.move_counts, COMMAND, preset.line)
        else:
            controller.move_to(preset.axis, preset.move_counts, COMMAND, preset.line)
    finally:
        controller.configure(preset.axis, "own_rates", before)


def _position(preset: Preset) -> None:
    preset.presets.controller.define_position(preset.axis, preset.move_counts)


def _speed(preset: Preset) -> None:
    controller = preset.presets.controller
    scale = controller.axes[preset.axis].scale
    velocity = scale.to_counts(preset.value("PRESETMOVESPEED"), "uu/s")
    own = controller.rates(preset.axis)
    accel, decel = (rate or its for rate, its in zip(preset.rates(abs(velocity)), own, strict=True))
    slopes = Slope(accel), Slope(decel)
    controller.refer_speed(preset.axis, velocity, slopes, 0.0, "SPEEDREF", preset.line)


def _torque(preset: Preset) -> None:
    references = preset.presets.environment.component(TorqueReferences)
    references.set("TORQUEREF", preset.axis, preset.value("PRESETMOVEPARAMETER"))
    references.run(preset.axis)


def _stop(preset: Preset) -> None:
    environment = preset.presets.environment
    stop(environment, preset.axis, environment.component(StopModes).setting("STOPMODE", preset.axis))


def _suspend(preset: Preset) -> None:
    preset.presets.controller.suspend(preset.axis)


def _cancel(preset: Preset) -> None:
    preset.presets.controller.abort(preset.axis)
    preset.presets.controller.clear_faults(preset.axis)


# By the number of PRESETMOVETYPE, in the order in which the library lists the commands of presets.
MOVES: tuple[Start, ...] = (
    lambda preset: None,
    _home,
    _jog,
    lambda preset: _move(preset, False),
    lambda preset: _move(preset, True),
    _position,
    _speed,
    _torque,
    _stop,
    _suspend,
    _cancel,
)
