"""The status word for client programs."""

from __future__ import annotations

from enum import IntFlag

from motionlang.kernel.mccl.axis import flags


class Status(IntFlag):
    """The primary status word of DCX-AT200, DCX-PCI and MultiFlex boards, bit by bit.

    Unnamed bits are preserved.
    """

    BUSY = flags.BUSY
    MOTOR_ON = flags.MOTOR_ON
    AT_TARGET = flags.AT_TARGET
    STOPPED = flags.TRAJECTORY_COMPLETE
    NEGATIVE = flags.DIRECTION
    JOG_ENABLED = flags.JOG_ENABLED
    HOMED = flags.HOMED
    MOTOR_ERROR = flags.MOTOR_ERROR
    LOOKING_FOR_INDEX = flags.LOOKING_FOR_INDEX
    LOOKING_FOR_EDGE = flags.LOOKING_FOR_EDGE
    BREAKPOINT_REACHED = flags.REACHED
    FOLLOWING_ERROR = flags.FOLLOWING_ERROR
    AMPLIFIER_ON = flags.AMPLIFIER_ON
    AMPLIFIER_FAULT = flags.AMPLIFIER_FAULT
    HARD_PLUS_ENABLED = flags.HARD_PLUS_ENABLED
    HARD_PLUS_TRIPPED = flags.HARD_PLUS_TRIPPED
    HARD_MINUS_ENABLED = flags.HARD_MINUS_ENABLED
    HARD_MINUS_TRIPPED = flags.HARD_MINUS_TRIPPED
    SOFT_HIGH_ENABLED = flags.SOFT_HIGH_ENABLED
    SOFT_HIGH_TRIPPED = flags.SOFT_HIGH_TRIPPED
    SOFT_LOW_ENABLED = flags.SOFT_LOW_ENABLED
    SOFT_LOW_TRIPPED = flags.SOFT_LOW_TRIPPED
    HOME_INPUT = flags.INPUTS["home"]
    AMPLIFIER_FAULT_INPUT = flags.INPUTS["amplifier_fault"]
    LIMIT_PLUS_INPUT = flags.INPUTS["limit_plus"]
    LIMIT_MINUS_INPUT = flags.INPUTS["limit_minus"]
    PHASE = flags.PHASE

    @property
    def faults(self) -> list[str]:
        """Return the names of the errors that are set, except the general motor error.

        Each of these errors also sets the motor error.
        """
        found = self & Status(flags.FAULTS) & ~Status.MOTOR_ERROR
        return [(each.name or "").lower().replace("_", " ") for each in found]
