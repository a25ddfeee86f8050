"""Calls that a session of `sessions.txt` cannot show: buffers for text, time-outs, and several hosts."""

from __future__ import annotations

import math

import pytest

import motionlang_mcapi as mc
from motionlang_mcapi import Mcapi, McapiException
from test_mcapi.conftest import opened

# A move of 5000 counts at 100 000 counts/s² never reaches 40 000 counts/s: it takes twice the root of s/a.
SHORT, SHORT_TIME = 5000.0, 2.0 * math.sqrt(5000.0 / 100_000.0)


def test_scale_takes_effect_when_the_axis_is_switched_on(host: Mcapi) -> None:
    """First the values of PMC's self-test, then 40 counts per unit.

    1000 counts are 25 units, minus both zeros.
    """
    host.EnableAxis(1, False)
    scale, found = mc.MCSCALE(), mc.MCSCALE()
    scale.fill([10.0, 20.0, 30.0, 40.0, 50.0, 1.0])
    host.SetScale(1, scale)
    assert host.GetPositionEx(1) == 0.0
    host.EnableAxis(1, True)
    host.GetScale(1, found)
    assert found.values() == scale.values()
    host.MoveAbsolute(1, 0.0)
    assert host.IsStopped(1, 1000.0) == 1
    port = host.board.console.open(echo=False)
    assert port is not None
    assert host.GetPositionEx(1) == 0.0
    assert host.board.console.board.controller.position(1) == (20.0 + 50.0) * 40.0


def test_an_ascii_handle_has_its_own_accumulator() -> None:
    """Binary handles share one interface, ASCII handles another."""
    first = opened()
    second, third = Mcapi(first.board), Mcapi(first.board)
    assert second.Open(0, mc.MC_OPEN_BINARY) == 2
    assert third.Open(0, mc.MC_OPEN_ASCII) == 3
    first.SetRegister(0, 11, mc.MC_TYPE_LONG)
    third.pmcputs("AL22\r")
    assert second.GetRegister(0, mc.MC_TYPE_LONG) == 11
    assert third.GetRegister(0, mc.MC_TYPE_LONG) == 22


def test_text_of_a_board_that_ends_lines_with_cr() -> None:
    """The prompt of an older board needs a separate read."""
    host = opened({"controller.model": "dcx-at200"}, mc.MC_OPEN_ASCII)
    buffer = bytearray(255)
    host.pmcputs("TC1\r")
    assert host.pmcgets(buffer, 255) == 5
    assert buffer[:5] == b"01 0\r"
    assert host.pmcgets(buffer, 255) == 1
    assert buffer[:1] == b">"


def test_text_waits_for_the_board() -> None:
    """The answer comes only after the move."""
    host = opened(mode=mc.MC_OPEN_ASCII)
    buffer = bytearray(255)
    host.pmcputs("1MN,1MR5000,1WS,1TP\r")
    assert host.pmcrdy() == 0
    began = host.now
    host.pmcgets(buffer, 255)
    assert buffer.startswith(b"01 5000\n")
    assert host.now - began == pytest.approx(SHORT_TIME, abs=2e-3)
    assert host.pmcrdy() == 1


def test_a_wait_of_the_interface_gives_up_after_the_time_out(host: Mcapi) -> None:
    """The call returns 25, but the board still waits, which delays the next call."""
    assert host.SetTimeoutEx(0.1) == 0.0
    with pytest.raises(McapiException) as caught:
        host.Wait(1.0)
    assert caught.value.code == mc.MCERR_TIMEOUT
    assert host.now == pytest.approx(0.1, abs=5e-3)
    assert host.SetTimeoutEx(0.0) == 0.1
    assert host.GetPositionEx(1) == 0.0
    assert host.now == pytest.approx(1.0, abs=5e-3)


def test_a_reserved_interface(host: Mcapi) -> None:
    """While one handle has reserved it, another waits until its own time-out."""
    other = Mcapi(host.board)
    other.Open(0, mc.MC_OPEN_BINARY)
    assert host.pmclock(0) == 0
    began = host.now
    assert other.pmclock(500) == mc.MCERR_TIMEOUT
    assert host.now - began == pytest.approx(0.5 + 0.001, abs=1e-4)  # a call takes 1 ms
    third = Mcapi(host.board)
    third.Open(0, mc.MC_OPEN_BINARY)
    third.Close()  # not the handle that has it
    assert other.pmclock(50) == mc.MCERR_TIMEOUT
    host.pmcunlock()
    assert other.pmclock(50) == 0
    other.Close()
    assert host.pmclock(50) == 0
