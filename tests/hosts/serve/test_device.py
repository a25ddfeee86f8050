"""A serial device: a pseudo-terminal with the board at its other end."""

from __future__ import annotations

import os
import select
from collections.abc import Iterator

import pytest

from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import LockStep, Server
from motionlang.kernel import Machine

pytest.importorskip("pty")


@pytest.fixture
def device() -> Iterator[str]:
    console = Console(Machine(first_axis=1))
    with Server(console, LockStep(console)) as server:
        path = server.device()
        with server.in_thread():
            yield path


def until(line: int, mark: bytes) -> bytes:
    """Return everything up to and including `mark`; nothing may follow."""
    found = b""
    while not found.endswith(mark):
        ready, _, _ = select.select([line], [], [], 20.0)
        assert ready, found
        found += os.read(line, 4096)
    return found


def test_a_terminal_program(device: str) -> None:
    """Keys are echoed as by the board, and the first output is the prompt."""
    line = os.open(device, os.O_RDWR | os.O_NOCTTY)
    assert until(line, b">") == b">"
    for key in b"1TX\x08P\r":
        os.write(line, bytes([key]))
    assert until(line, b"\n>") == b"1TX\b \bP\n01 0\n>"
    os.close(line)


def test_the_board_does_not_notice_that_a_program_has_ended(device: str) -> None:
    """As on a serial line, a partial line is not lost; ESC discards one."""
    line = os.open(device, os.O_RDWR | os.O_NOCTTY)
    os.write(line, b"EF\r")
    until(line, b"\n>")
    os.write(line, b"1MN,1MR")
    os.close(line)
    line = os.open(device, os.O_RDWR | os.O_NOCTTY)
    os.write(line, b"700,1WS,1TP\r")
    assert until(line, b"\n>") == b"01 700\n>"
    os.write(line, b"1MR")
    os.write(line, b"\x1b1TP\r")
    assert until(line, b"700\n>") == b"\n>01 700\n>"
    os.close(line)


def test_all_bytes_pass(device: str) -> None:
    """No line discipline consumes Ctrl-C, Ctrl-D, or a carriage return."""
    line = os.open(device, os.O_RDWR | os.O_NOCTTY)
    until(line, b">")
    os.write(line, b"\x03\x04\x1a\x1c\x00\xff1TP\r")
    assert until(line, b"\n>") == b"\xff1TP\n?2\n>"
    os.close(line)
