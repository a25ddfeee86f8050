"""Velocity mode with a profile that needs a standstill, in a telescope program."""

from __future__ import annotations

import pytest

from motionlang.hosts.mccl.console import Console
from motionlang.kernel import Machine

PADDLE = "1MN,1{},1SV120000,1SA70000,1DS70000\r1VM,1GO\rWA0.4\r1PM\r1MA0\r"


def answers(text: str) -> tuple[bytes, Console]:
    console = Console(Machine({"controller.model": "multiflex"}, first_axis=1))
    port = console.open()
    for line in text.splitlines():
        port.feed(line.encode() + b"\r")
        assert console.settle(60.0), f"{line} is never answered"
    return port.take(), console


@pytest.mark.parametrize("shape", ["PS", "PS0.1", "PP"])
def test_a_move_that_could_never_begin_is_refused(shape: str) -> None:
    """Without an error, such a move would never be answered.

    By a remark in the telescope's source, the axis runs until it is stopped.
    """
    reply, console = answers(PADDLE.format(shape))
    assert reply.endswith((b"?-2\r\n>", b"?-2\n>"))
    assert console.machine.controller.velocity(1) > 1000
    reply, console = answers(PADDLE.format(shape) + "1ST,1WS\r1MA0,1WS\r1TP\r")
    assert console.machine.controller.position(1) == 0.0


def test_with_the_trapezoid_it_is_taken() -> None:
    reply, console = answers(PADDLE.format("PT") + "1WS\r")
    assert b"?" not in reply
    assert console.machine.controller.position(1) == 0.0
