"""Errors of calls: refusals, and the error codes of rejected commands."""

from __future__ import annotations

from motionlang.kernel import Rejected
from motionlang.kernel.mccl import Fault, codes
from motionlang_mcapi import table as mc

_CODES = {
    codes.PARAMETER: mc.MCERR_RANGE,
    codes.NEGATIVE_REPEAT: mc.MCERR_RANGE,
    codes.MACRO_RANGE: mc.MCERR_RANGE,
    codes.NO_MACRO: mc.MCERR_RANGE,
    codes.CANCELLED: mc.MCERR_CANCEL,
    codes.NO_AXIS: mc.MCERR_ALL_AXES,
    codes.IO: mc.MCERR_UNKNOWN_REPLY,
}
_KINDS = {"model": mc.MCERR_NOTSUPPORTED, "moving": mc.MCERR_AXIS_ACTIVE, "axis": mc.MCERR_AXIS_NUMBER}


class CallRefused(Exception):
    """A call fails with an error code before it reaches the board."""

    def __init__(self, code: int) -> None:
        self.code = code
        super().__init__(mc.text_of(code))


def code_of(trouble: Fault | Rejected) -> int:
    """Return the error code of a command that the board rejects."""
    if isinstance(trouble, Rejected):
        return mc.MCERR_AXIS_ACTIVE if trouble.code == "moving" else mc.MCERR_RANGE
    if trouble.code in _CODES:
        return _CODES[trouble.code]
    return _KINDS.get(trouble.kind, mc.MCERR_UNKNOWN_REPLY)
