"""What the controller refuses to do, and what can go wrong on an axis."""

from __future__ import annotations

# Bits of `Axis.faults`, in the order in which MintMT users remember AXISERROR (docs/fidelity.md).
ABORT = 1
ERROR_INPUT = 2
LIMIT_FORWARD = 4
LIMIT_REVERSE = 8
SOFT_LIMIT_FORWARD = 16
SOFT_LIMIT_REVERSE = 32
FOLLOWING_ERROR = 64
ANALOGUE_LIMIT = 128
DRIVE = 256
ALL = 511
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


def names(bits: int) -> str:
    """The faults of a bit pattern in words."""
    return ", ".join(name for k, name in enumerate(NAMES) if bits >> k & 1)


class Refusal(Exception):
    """A command that the controller does not carry out; `code` is one of `errors.CODES`.

    The language decides what becomes of it: Mint a run-time error, MCCL a `?` code, both a diagnostic when
    the program does not handle it.
    """

    def __init__(self, code: str, message: str, hint: str = "") -> None:
        self.code, self.message, self.hint = code, message, hint
        self.line = 0  # the program line at fault, where it is not the one being executed
        super().__init__(message)
