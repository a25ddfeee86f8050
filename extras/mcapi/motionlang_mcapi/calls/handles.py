"""Functions for handles: open and close, errors, time-outs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang_mcapi import table as mc
from motionlang_mcapi.errors import CallRefused
from motionlang_mcapi.registry import at_once

if TYPE_CHECKING:
    from motionlang_mcapi.call import ApiCall
    from motionlang_mcapi.session import HostProcess

# 4.4.1.
VERSION = 4 << 16 | 4 << 8 | 1


@at_once("MCOpen")
def open_handle(session: HostProcess, call: ApiCall, nID: int, mode: int, name: str | None) -> None:  # noqa: N803
    if not 0 <= nID <= mc.MC_MAX_ID:
        raise CallRefused(mc.MCERR_NO_CONTROLLER)
    call.value = session.open(mode).number


@at_once("MCClose")
def close(session: HostProcess, call: ApiCall) -> None:
    assert call.handle is not None
    session.close(call.handle)


@at_once("MCReopen")
def reopen(session: HostProcess, call: ApiCall, newmode: int) -> None:
    assert call.handle is not None
    session.reopen(call.handle, newmode)


@at_once("MCGetError")
def last_error(session: HostProcess, call: ApiCall) -> None:
    assert call.handle is not None
    call.value, call.handle.error = call.handle.error, 0


@at_once("MCTranslateErrorEx")
def translate(session: HostProcess, call: ApiCall, nError: int, length: int) -> None:  # noqa: N803
    """Return the text of an error code.

    It is truncated to a buffer that is too short, which is an error itself.
    """
    if length <= 0:
        raise CallRefused(mc.MCERR_RANGE)
    text = mc.text_of(nError)
    call.outputs = (text[: length - 1],)
    if len(text) >= length:
        call.value = mc.MCERR_RANGE


@at_once("MCSetTimeoutEx")
def set_timeout(session: HostProcess, call: ApiCall, timeout: float) -> None:
    assert call.handle is not None
    if timeout < 0.0:
        raise CallRefused(mc.MCERR_RANGE)
    call.outputs = (call.handle.timeout,)
    call.handle.timeout = timeout


@at_once("MCGetVersion")
def version(session: HostProcess, call: ApiCall) -> None:
    call.value = VERSION
