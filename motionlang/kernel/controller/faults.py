"""The faults of an axis."""

from __future__ import annotations

# Bits of `Axis.faults`, in the order that MintMT users know from AXISERROR (docs/contributing/assumptions.md).
ABORT = 1
ERROR_INPUT = 2
LIMIT_FORWARD = 4
LIMIT_REVERSE = 8
SOFT_LIMIT_FORWARD = 16
SOFT_LIMIT_REVERSE = 32
FOLLOWING_ERROR = 64
DRIVE = 256
ALL = 511
# The text of a limit that homing has searched for.
HOMING = "homing"
NAMES = (
    "abort",
    "error input",
    "forward limit",
    "reverse limit",
    "forward soft limit",
    "reverse soft limit",
    "following error",
    "analogue limit",
    "drive",
)


def fault_names(bits: int) -> str:
    """Return the faults of a bit pattern as text."""
    return ", ".join(name for k, name in enumerate(NAMES) if bits >> k & 1)
