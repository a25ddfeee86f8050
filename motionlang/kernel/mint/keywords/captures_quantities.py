"""The quantities that a capture can record, exact at any past time.

Nothing is sampled as time passes. The motion of an axis is known at every time, the motion of a motor is
simulated again, and channels have a log of their changes.
"""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.kernel.controller.io.bits import signed
from motionlang.kernel.controller.io.channels import Channels
from motionlang.kernel.controller.motion.encoder import AUXILIARY
from motionlang.kernel.lang.keyword import BANK
from motionlang.kernel.mint.keywords.following_auxiliary import AuxEncoders, checked_channel
from motionlang.kernel.mint.keywords.io_inputs import LAST_CHANNEL, checked
from motionlang.kernel.mint.keywords.io_outputs import LAST_ANALOGUE, Analogue
from motionlang.kernel.mint.keywords.sensing import Encoders, channel_of
from motionlang.kernel.mint.runtime.binding import axis_of, scale_of
from motionlang.kernel.mint.runtime.environment import Environment

Datums = Sequence[tuple[float, float]]

NAMES = (
    "Off",
    "Measured position",
    "Measured velocity",
    "Demand position",
    "Demand velocity",
    "Demand acceleration",
    "Following error",
    "Drive output",
    "Motor torque",
    "Encoder",
    "Auxiliary encoder",
    "Analogue input",
    "Analogue output",
    "Digital inputs",
    "Digital outputs",
)
OFF, MEASURED, MEASURED_SPEED, DEMAND, SPEED, ACCELERATION, ERROR, OUTPUT, TORQUE = range(9)
ENCODER, AUX_ENCODER, ADC, DAC, INPUTS, OUTPUTS = range(9, len(NAMES))
# Quantities of the motor, by their name in its history. Without a motor they are the demand, or 0.
_MOTOR = {
    MEASURED: "actual",
    MEASURED_SPEED: "actual velocity",
    ERROR: "following error",
    OUTPUT: "output",
    TORQUE: "torque",
}
_DEMANDED = {MEASURED: DEMAND, MEASURED_SPEED: SPEED}
_PERCENT = 10.0  # percent of full scale in one volt


def is_of(quantity: int) -> bool:
    """True if a quantity belongs to an axis and not to a channel."""
    return OFF < quantity < ENCODER


def check(environment: Environment, quantity: int, where: int) -> None:
    """Raise Rejected if the axis, encoder, channel or bank does not exist."""
    if is_of(quantity):
        axis_of(environment, where)
    elif quantity == ENCODER:
        channel_of(environment, where)
    elif quantity == AUX_ENCODER:
        checked_channel(where)
    elif quantity in (ADC, DAC):
        checked(where, LAST_ANALOGUE, "analogue channel")
    elif quantity in (INPUTS, OUTPUTS):
        checked(where, LAST_CHANNEL // BANK, "bank")


# ---------------------------------------------------------------------------------------------------- values


def column(
    environment: Environment, quantity: int, where: int, times: Sequence[float], datums: Datums
) -> list[float]:
    """Return the values of a quantity at ascending times, none later than now.

    `datums` lists the times at which the zero of the axis changed, each with the new zero in counts.
    """
    if quantity == AUX_ENCODER:
        return _auxiliary(environment, where, times)
    if quantity == ENCODER:
        return _encoder(environment, where, times, datums)
    if quantity in (ADC, DAC):
        return _analogue(environment, quantity, where, times)
    if quantity in (INPUTS, OUTPUTS):
        return _bank(environment, quantity, where, times)
    return _of(environment, quantity, where, times)


def _of(environment: Environment, quantity: int, axis: int, times: Sequence[float]) -> list[float]:
    a, scale = environment.controller.axes[axis], scale_of(environment, axis)
    wrap = scale.wrap
    if quantity in _MOTOR and a.feedback is not None:
        found = _recalled(environment, axis, _MOTOR[quantity], times)
        if quantity in (OUTPUT, TORQUE):
            return [value * _PERCENT for value in found] if quantity == OUTPUT else found
    elif quantity in _MOTOR and quantity not in _DEMANDED:
        return [0.0] * len(times)
    else:
        which = _DEMANDED.get(quantity, quantity)
        states = [a.at(time) for time in times]
        found = [
            s.position if which == DEMAND else s.velocity if which == SPEED else s.acceleration
            for s in states
        ]
    if quantity in (MEASURED, DEMAND):
        shown = [scale.position_to_user(value) for value in found]
        return [value % wrap for value in shown] if wrap else shown
    unit = "uu" if quantity == ERROR else "uu/s2" if quantity == ACCELERATION else "uu/s"
    return [scale.to_user(value, unit) for value in found]


def _recalled(environment: Environment, axis: int, name: str, times: Sequence[float]) -> list[float]:
    from motionlang.kernel.tracks.history import recall

    return recall(environment.controller, axis, name, times)


def _encoder(environment: Environment, channel: int, times: Sequence[float], datums: Datums) -> list[float]:
    controller, encoders = environment.controller, environment.component(Encoders)
    if channel in controller.encoders:
        return [encoders.shown(channel, controller.encoders[channel].position(time)) for time in times]
    a = controller.axes[channel]
    positions = [a.position(time) for time in times]
    if a.feedback is not None:
        positions = _recalled(environment, channel, "actual", times)
    zeros = _stepped(datums, times)
    return [encoders.shown(channel, position - zero) for position, zero in zip(positions, zeros, strict=True)]


def _auxiliary(environment: Environment, channel: int, times: Sequence[float]) -> list[float]:
    track, encoders = environment.controller.encoder(AUXILIARY + channel), environment.component(AuxEncoders)
    return [encoders.shown(channel, track.position(time)) for time in times]


def _analogue(environment: Environment, quantity: int, channel: int, times: Sequence[float]) -> list[float]:
    controller = environment.controller
    log = controller.log
    changes = log.analogue_inputs if quantity == ADC else log.analogue_outputs
    levels = _stepped([(each.time, each.value) for each in changes if each.channel == channel], times)
    if quantity == DAC:
        return levels
    analogue = environment.component(Analogue)
    return [analogue.shown(channel, level) for level in levels]


def _bank(environment: Environment, quantity: int, bank: int, times: Sequence[float]) -> list[float]:
    controller, first = environment.controller, bank * BANK
    channels: Channels = controller.inputs if quantity == INPUTS else controller.outputs
    bits, steps = 0, []
    for each in controller.log.inputs if quantity == INPUTS else controller.log.outputs:
        if first <= each.channel < first + BANK:
            bit = 1 << each.channel - first
            bits = bits | bit if each.value else bits & ~bit
            steps.append((each.time, float(bits)))
    low = 0
    if quantity == INPUTS:
        low = sum(1 << k for k in range(BANK) if first + k in channels.active_low)
    return [float(signed(int(value) ^ low)) for value in _stepped(steps, times)]


def _stepped(steps: Sequence[tuple[float, float]], times: Sequence[float]) -> list[float]:
    """Return the values of a stepwise quantity at ascending times.

    `steps` are the times of change with the values from then on. The value before the first change is 0.
    """
    found, k, value = [], 0, 0.0
    for time in times:
        while k < len(steps) and steps[k][0] <= time:
            value = steps[k][1]
            k += 1
        found.append(value)
    return found
