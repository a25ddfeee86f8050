"""One sample of a servo: from a commanded position to an output and the motion after it.

Order of a sample: measure, error, integral, derivative, sum of the terms, limits, DAC, then the plant advances with
constant output. The laws are those of `docs/servo.md`:

    real        u = Kp e + Ki Σe + Kd (e - e') - Kv (y - y') + feed-forward    (TN1069; MN1902, figure 47)
    chapter12   u = (Kp e + (Ki/256) Σe + Kd (e - e')) / 2^(16 - bits)         (rounded towards zero, like C)
    lm628       u = (Kp e + Ki (Σe/256) + Kd (e - e')) / 2^(16 - bits)         (words of 16 bits, rounded down)

The integral's contribution is limited, and e' is the error at the derivative sample before. The first law computes in
volts, the others in whole numbers and DAC steps.
"""

from __future__ import annotations

from motionlang.kernel.servo.discrete import Motion, discretise
from motionlang.kernel.servo.loop import FINE_BITS, Loop
from motionlang.kernel.servo.plant import Motor, VelocityDrive

# The readings of a sample: counts, counts, counts, counts/s, A, V, V; in motor coordinates, at its measurement.
COLUMNS = ("demand", "measured", "position", "velocity", "current", "integral", "output")
Reading = tuple[float, float, float, float, float, float, float]

# The loop's own state: sum of errors, derivative samples, counters, and the stored DAC value.
MEMORY = ("total", "last_error", "change", "last_measured", "derivative_wait", "hold_wait", "held")
Memory = tuple[float, float, float, float, int, int, float]
State = tuple[Motion, Memory]

# Adding and subtracting 1.5 * 2**52 rounds a float to a whole number, infinite ones included.
_ROUNDER = 1.5 * 2.0**52


def at_rest(position: float) -> State:
    """Return the state at rest at `position` (counts) without wind-up."""
    return (position, 0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0, position, 0, 0, 0.0)


class LoopStep:
    """The step of one loop and one plant; with `volts` the loop is open and that is its output."""

    def __init__(self, loop: Loop, plant: Motor | VelocityDrive, volts: float | None = None) -> None:
        self.loop, self.plant = loop, discretise(plant, loop.period)
        self._is_real, self._has_integral = loop.arithmetic == "real", loop.has_integral
        self._counts = self.plant.quantised or not self._is_real
        # The limit of the sum of errors, where that is what is limited.
        self._max_total = loop.integral_limit / abs(loop.integral) if loop.integral else 0.0
        self._divisor = float(1 << (FINE_BITS - loop.dac_bits))
        self._unit = 1.0 if self._is_real else loop.dac_step / self._divisor
        self._constant = None if volts is None else self._limited(volts)

    def __call__(self, state: State, demand: float, feed: float, acts: bool) -> tuple[State, Reading]:
        """Return the state after a sample, and its readings.

        `demand` is the commanded position in counts, `feed` the feed-forward in volts. The sum of errors changes only
        if the integral `acts`.
        """
        motion, memory = state
        measured = self.measured(motion)
        if self._constant is None:
            output, integral, memory = self._law(memory, demand, measured, motion[1], feed, acts)
        else:
            output, integral = self._constant, 0.0
        current = self.plant.current_of(motion, output)
        reading = demand, measured, motion[0], motion[1], current, integral, output
        return (self.plant.advance(motion, output), memory), reading

    def _law(
        self, memory: Memory, demand: float, measured: float, velocity: float, feed: float, acts: bool
    ) -> tuple[float, float, Memory]:
        """Return the output, the integral's contribution to it (both in volts), and the memory after a sample."""
        loop = self.loop
        total, last_error, change, last_measured, derivative_wait, hold_wait, held = memory
        error = demand - measured if self._is_real else rounded(demand) - measured
        if loop.arithmetic == "lm628":
            error = clamped(error, 32767.0, -32768.0)
        integral = 0.0
        if self._has_integral:
            total = self._summed(total, error, acts)
            integral = self._integral(total)
        if derivative_wait:
            derivative_wait -= 1
        else:
            derivative_wait, change, last_error = loop.derivative_every - 1, error - last_error, error
        if self._is_real:
            output = self._sum(error, integral, change, measured - last_measured, feed)
        else:
            output = self._whole_sum(error, integral, change)
        if loop.override:
            if hold_wait:
                hold_wait -= 1
            else:
                hold_wait, held = loop.override.hold - 1, self._near_velocity(output, velocity)
            output = held
        if loop.dac_bits:
            output = self._converted(output)
        after = total, last_error, change, measured, derivative_wait, hold_wait, held
        return output, integral * self._unit, after

    def measured(self, motion: Motion) -> float:
        """Return the position that the encoder measures, counts."""
        position = motion[0] - motion[3] if self.plant.load_encoder else motion[0]
        return rounded(position) if self._counts else position

    # -- terms

    def _summed(self, total: float, error: float, acts: bool) -> float:
        """Return the sum of errors, within its limit if it has one."""
        if not acts:
            return 0.0 if self.loop.integral_mode == "zeroed" else total
        if self.loop.arithmetic == "lm628":
            return clamped(total + error, 8388607.0, -8388608.0)
        if self._is_real and self.loop.limit_style == "sum":
            return clamped(total + error, self._max_total, -self._max_total)
        return total + error

    def _integral(self, total: float) -> float:
        """Return the integral's contribution, in volts or before the last division."""
        gain, limit = self.loop.integral, self.loop.integral_limit
        if self.loop.arithmetic == "lm628":
            return clamped(gain * (total // 256.0), limit, -limit)
        if self.loop.arithmetic == "chapter12":
            return clamped(truncated(gain * total, 256.0), limit, -limit)
        return gain * total if self.loop.limit_style == "sum" else clamped(gain * total, limit, -limit)

    def _sum(self, error: float, integral: float, change: float, moved: float, feed: float) -> float:
        """Return the output in volts, or for a DAC in its steps."""
        loop = self.loop
        output = loop.proportional * error + integral + loop.derivative * change
        output += -loop.velocity_feedback * moved
        output += feed
        if -loop.output_deadband < output < loop.output_deadband:
            output = 0.0
        output += loop.output_offset
        if loop.reversed:
            output = -output
        output = clamped(output, loop.output_limit, -loop.output_limit)
        return rounded(output * (1.0 / loop.dac_step)) if loop.dac_bits else output

    def _whole_sum(self, error: float, integral: float, change: float) -> float:
        """Return the output in DAC steps, by whole numbers."""
        loop = self.loop
        by_error, by_change = loop.proportional * error, loop.derivative * change
        if loop.arithmetic == "chapter12":
            steps = truncated(by_error + by_change + integral, self._divisor)
        else:
            steps = self._word(self._word(by_error) + self._word(by_change) + integral) // self._divisor
        if loop.reversed:
            steps = -steps
        most = float(int(loop.output_limit / loop.dac_step))
        return clamped(steps, most, -most)

    def _word(self, value: float) -> float:
        """Return a product of the LM628 in 16 bits."""
        return (value + 32768.0) % 65536.0 - 32768.0 if self.loop.wrap else clamped(value, 32767.0, -32768.0)

    # -- the DAC

    def _near_velocity(self, steps: float, velocity: float) -> float:
        """Return the DAC override of chapter 12: steps as near to the actual velocity as it allows."""
        override = self.loop.override
        assert override is not None
        actual = rounded(velocity * ((1 << (self.loop.dac_bits - 1)) / override.speed))
        return clamped(steps, actual + override.steps, actual - override.steps)

    def _converted(self, steps: float) -> float:
        """Return the volts of DAC steps, within the DAC's range."""
        full = float(1 << (self.loop.dac_bits - 1))
        return clamped(steps, full - 1.0, -full) * self.loop.dac_step

    def _limited(self, volts: float) -> float:
        """Return a constant output within the limits of the loop and the DAC."""
        loop = self.loop
        output = clamped(volts, loop.output_limit, -loop.output_limit)
        return self._converted(rounded(output * (1.0 / loop.dac_step))) if loop.dac_bits else output


def clamped(value: float, high: float, low: float) -> float:
    """Return the value within its limits; NaN stays."""
    return high if value > high else low if value < low else value


def rounded(value: float) -> float:
    """Return the nearest whole number, of two the even one."""
    return value + _ROUNDER - _ROUNDER


def truncated(value: float, divisor: float) -> float:
    """Return a quotient of whole numbers rounded towards zero, like C."""
    return value // divisor if value > 0.0 else 0.0 - (-value // divisor)
