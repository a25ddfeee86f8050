"""The MCCL state of an axis, in addition to the controller's.

It consists of user units, mode, limits and flags.
"""

from __future__ import annotations

from collections.abc import Callable
from math import floor

from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.controller.readers import Writer
from motionlang.kernel.controller.scale import Scale
from motionlang.kernel.mccl.axis.backlash import Backlash
from motionlang.kernel.mccl.axis.flags import FAULTS
from motionlang.kernel.mccl.models import Model

# Modes of operation, named like their commands.
POSITION, VELOCITY, TORQUE, GAIN, CONTOUR = "position", "velocity", "torque", "gain", "contour"


def nearest_whole(value: float) -> float:
    """Return the nearest integer, with halves rounded up."""
    return float(floor(value + 0.5))


class Units:
    """The user units set for an axis, which take effect at the next MN."""

    def __init__(self) -> None:
        self.counts = self.rate = self.constant = 1.0
        self.offset = self.zero = 0.0


class JogSettings:
    """Joystick settings of an axis: rates in counts and seconds, voltages in volts."""

    def __init__(self) -> None:
        self.accel, self.gain = 100_000.0, 1000.0
        self.minimum, self.offset, self.deadband = 0.0, 0.0, 0.1


class VectorSettings:
    """Velocity, acceleration and deceleration along contour paths, counts and seconds.

    `override` is a factor on the velocity.
    """

    def __init__(self) -> None:
        self.velocity, self.accel, self.decel, self.override = 40_000.0, 100_000.0, 100_000.0, 1.0


class Writers(dict[str, "Writer"]):
    """Functions that write the controller's settings of an axis, created on first use.

    They take counts and seconds.
    """

    def __init__(self, controller: Controller, number: int) -> None:
        self._controller, self._number = controller, number

    def __missing__(self, name: str) -> Writer:
        made = self[name] = self._controller.writer(name, self._number)
        return made


class AxisState:
    """One axis of the board; positions without a unit in their name are counts.

    `flags` holds the bits of the status word that only events and commands change. `rested` is the time at
    which the axis last came to rest, `controlling` the axis that controls its contour.
    """

    def __init__(self, number: int, model: Model, controller: Controller) -> None:
        self.number, self.model = number, model
        # Writers of the settings of the controller's axis, by name.
        self.write = Writers(controller, number)
        self.rested = 0.0
        self.reset()

    def reset(self) -> None:
        """Reset to the state at power-up."""
        self.units, self.scale, self.scaled, self.constant = Units(), Scale(), False, 1.0
        self.mode, self.direction = POSITION, 1
        # True in velocity mode between GO and the stop.
        self.running = False
        self.flags = 0
        self.deadband = self.deadband_delay = 0.0
        self.breakpoint: float | None = None
        self.breakpoint_reached = False
        self.index_position, self.index_found, self.edge_found = 0.0, False, False
        self.limit_mode, self.soft_high, self.soft_low = 0, 0.0, 0.0
        self.slave_ratio = 1.0
        self.controlling: int | None = None
        self.vector = VectorSettings()
        self.segments, self.synchronised, self.on_arc, self.on_line = 0, False, False, False
        self.jog, self.jogging = JogSettings(), False
        self.half_steps = self.reversed_phase = False
        # The velocity at which a stepper starts and stops.
        self.minimum = 0.0
        # Half the backlash, counts, and its compensation by the motor while that is on.
        self.backlash = 0.0
        self.play: Backlash | None = None
        # The compensation when PR began to record.
        self.recorded_play: Backlash | None = None
        # The counts of the auxiliary encoder at its zero and at its last index.
        self.aux_zero = self.aux_index = 0.0
        # Settings of the servo loop and the output stage, by the function of their row.
        self.stored: dict[str, float] = {}

    @property
    def shift(self) -> float:
        """The position of the motor relative to the load, counts.

        The controller's positions are those of the load.
        """
        return 0.0 if self.play is None else self.play.shift()

    def set_backlash(self, half: float) -> None:
        """Set half the backlash, counts (BD)."""
        self.backlash = half
        if self.play is not None:
            self.play.resize(half)

    def forget_faults(self) -> None:
        """Clear the faults that MN clears."""
        self.flags &= ~FAULTS

    def apply_units(self) -> None:
        """Apply the user units."""
        units, scale = self.units, self.scale
        scale.set(units.counts, units.rate, (units.offset + units.zero) * units.counts)
        self.constant = units.constant
        self.scaled = scale.counts != 1.0 or scale.rate != 1.0 or scale.zero != 0.0

    def distance(self, value_uu: float) -> float:
        """Convert a distance to counts, rounded to an integer as on the board."""
        return nearest_whole(value_uu * self.scale.counts)

    def position(self, value_uu: float) -> float:
        """Convert a position to counts, rounded to an integer."""
        return nearest_whole(self.scale.position_to_counts(value_uu))

    def rate(self, value_uu: float, unit: str) -> float:
        """Convert a velocity or acceleration to counts and seconds.

        The result is rounded to an integer only if no scale is set.
        """
        value = self.scale.to_counts(value_uu, unit)
        return nearest_whole(value) if self.model.rounds and not self.scaled else value

    def reported(self, counts: float, unit: str = "position") -> float:
        """Return a quantity as the board reports it: integer counts, or user units.

        Positions and distances are rounded to counts before they are scaled, because an encoder resolves only
        counts.
        """
        if unit == "position":
            value = self.scale.position_to_user(nearest_whole(counts))
        else:
            value = self.scale.to_user(counts, unit)
        return value if self.scaled else nearest_whole(value)

    def say(self, counts: float, unit: str = "position", whole: Callable[[int], str] = str) -> str:
        """Format a quantity as the board does: whole counts, or user units, 6 decimals.

        `whole` formats the counts.
        """
        value = self.reported(counts, unit)
        return real(value) if self.scaled else whole(int(value))


def real(value: float) -> str:
    """Format a real number as the board does."""
    text = f"{value:.6f}"
    return "0.000000" if text == "-0.000000" else text
