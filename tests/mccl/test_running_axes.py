"""Velocity mode, moves without an axis, rates at power-up, and torque limits."""

from __future__ import annotations

import pytest

from motionlang.lang.machine.machine import Machine
from motionlang.mccl.hosts.console import Console
from motionlang.mccl.models import MODELS
from tests.mccl.conftest import Runner

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


RUNNING = "1MN,1VM,1SV1000,1GO,WA0.5,"


def test_a_running_axis_takes_the_speed_that_is_written_to_its_variable(mccl: Runner) -> None:
    """WL has the effect of SV."""
    for change in ("1SV2000", 'LU"SPEED",AR10,AL2000,1WL@10'):
        assert mccl(f"{RUNNING}{change},WA0.5,1TV").output == ["01 2000"]


def test_a_joystick_ends_the_run_of_velocity_mode(mccl: Runner) -> None:
    """The joystick is at rest, so SV starts nothing."""
    assert mccl(f"{RUNNING}1JN,WA0.5,1TV,1SV2000,WA0.5,1TV").output == ["01 0", "01 0"]


def test_the_torque_limit_is_stored_as_it_is_written() -> None:
    """The self-test sets 12345/i for several i and reads each one back."""
    for i in range(1, 4):
        reply, _ = answers(f"1SQ{12345 / i:g}\r1TQ\r")
        assert f"{12345 / i:g}".encode() in reply
        assert b"?" not in reply


@pytest.mark.parametrize("model", MODELS)
def test_each_board_reports_the_torque_limit_with_its_fraction(model: str, mccl: Runner) -> None:
    """The gains of some boards are whole numbers; the torque limit is in volts."""
    assert mccl("1SQ3.5,1TQ", machine={"controller.model": model}).output == ["01 3.500000"]


def test_a_move_without_an_axis_moves_those_that_are_on(mccl: Runner) -> None:
    result = mccl("1MN,MR100,WS,1TP,2TP\n2MN,MR7,WS,1TP,2TP")
    assert result.output == ["01 100", "02 0", "01 107", "02 7"]


def test_the_vector_rates_of_a_contour_at_power_up(mccl: Runner) -> None:
    """100 000 counts at 40 000 counts/s take 2.5 s.

    The ramps of 0.4 s each add half of that.
    """
    machine = {"controller.instruction_time": 1e-9}
    result = mccl("1MN,2MN,1CM1,2CM1,1CP1,1MR100000,2MR0,1WS", machine=machine)
    assert result.time == pytest.approx(2.9, abs=1e-6)


def test_a_move_without_an_axis_needs_one_that_is_on(mccl: Runner) -> None:
    result = mccl("MR100")
    assert [(each.code, each.message) for each in result.diagnostics] == [("disabled-axis", "axis 1 is off")]
