"""The bits of the primary status word, by MCAPI's flag numbers."""

from __future__ import annotations

BUSY = 1 << 0
MOTOR_ON = 1 << 1
# Bit 2 is velocity mode on the older boards, and at target on PCI300 and MultiFlex.
VELOCITY_MODE = AT_TARGET = 1 << 2
TRAJECTORY_COMPLETE = 1 << 3
DIRECTION = 1 << 4
JOG_ENABLED = 1 << 5
HOMED = 1 << 6
MOTOR_ERROR = 1 << 7
LOOKING_FOR_INDEX = 1 << 8
LOOKING_FOR_EDGE = 1 << 9
REACHED = 1 << 10
FOLLOWING_ERROR = 1 << 11
AMPLIFIER_ON = 1 << 12
AMPLIFIER_FAULT = 1 << 13
HARD_PLUS_ENABLED, HARD_PLUS_TRIPPED = 1 << 14, 1 << 15
HARD_MINUS_ENABLED, HARD_MINUS_TRIPPED = 1 << 16, 1 << 17
SOFT_HIGH_ENABLED, SOFT_HIGH_TRIPPED = 1 << 18, 1 << 19
SOFT_LOW_ENABLED, SOFT_LOW_TRIPPED = 1 << 20, 1 << 21
INDEX_INPUT = 1 << 22
PHASE = 1 << 30

# The bits that MN clears.
FAULTS = (
    MOTOR_ERROR
    | FOLLOWING_ERROR
    | AMPLIFIER_FAULT
    | HARD_PLUS_TRIPPED
    | HARD_MINUS_TRIPPED
    | SOFT_HIGH_TRIPPED
    | SOFT_LOW_TRIPPED
)

# The inputs of an axis, and the bits that show their current state.
INPUTS: dict[str, int] = {
    "home": 1 << 23,
    "amplifier_fault": 1 << 24,
    "auxiliary": 1 << 25,
    "limit_plus": 1 << 26,
    "limit_minus": 1 << 27,
    "user_1": 1 << 28,
    "user_2": 1 << 29,
}
