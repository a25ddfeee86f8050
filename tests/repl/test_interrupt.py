"""Ctrl-C while a command runs."""

from __future__ import annotations

import os
import signal

import pytest

from motionlang.repl.interrupt import Interrupts


def test_ctrl_c_is_a_request_first_and_an_order_the_second_time() -> None:
    before = signal.getsignal(signal.SIGINT)
    interrupts = Interrupts()
    with interrupts:
        assert not interrupts.pressed()
        signal.raise_signal(signal.SIGINT)
        assert interrupts.pressed()
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    assert signal.getsignal(signal.SIGINT) is before


def test_interrupt_request_ends_with_its_command() -> None:
    interrupts = Interrupts()
    with interrupts:
        signal.raise_signal(signal.SIGINT)
    assert not interrupts.pressed()
    with interrupts:
        assert not interrupts.pressed()


def test_output_after_ctrl_c_has_its_own_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """The terminal has shown ^C; standard error has the number 2."""
    written: list[tuple[int, bytes]] = []
    monkeypatch.setattr(os, "isatty", lambda file: file == 2)
    monkeypatch.setattr(os, "write", lambda *given: written.append(given))
    with Interrupts():
        signal.raise_signal(signal.SIGINT)
    assert written == [(2, b"\n")]
