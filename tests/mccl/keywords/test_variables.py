"""The variables of an axis: their values at power-up, and what can be written."""

from __future__ import annotations

import pytest

from motionlang.mccl.axis.variables import NAMES
from tests.cases import cases
from tests.mccl.conftest import Runner

REFUSED = "?-1"
# The value at power-up, and whether 7 and -7 can be written. Status bits 2 and 3 are on at rest; words 1 to 3 have bit
# 0: full steps, trapezoid, position mode.
VARIABLES: dict[str, tuple[float, bool, bool]] = {
    "STATUS": (12, False, False),
    "AUXSTATUS": (1, False, False),
    "PROFILE": (1, False, False),
    "MODE": (1, False, False),
    "POSITION": (0, True, True),
    "OPTIMAL": (0, False, False),
    "TARGET": (0, False, False),
    "VELOCITY": (0, False, False),
    "ERROR": (0, False, False),
    "INDEX": (0, False, False),
    "SEGMENT": (0, False, False),
    "SPEED": (40_000, True, False),
    "ACCEL": (100_000, True, False),
    "DECEL": (100_000, True, False),
    "MINSPEED": (0, True, False),
    "DEADBAND": (0, True, False),
    "HIGHLIMIT": (0, True, True),
    "LOWLIMIT": (0, True, True),
    "BACKLASH": (0, True, False),
    "AUXPOSITION": (0, True, True),
    "AUXINDEX": (0, False, False),
    "OUTPUTMODE": (0, False, False),
    "INPUTMODE": (0, False, False),
    "ENCODERSCALE": (1, False, False),
    "CURRENT": (1, False, False),
    "LOOPRATE": (4000, False, False),
}


@cases("name", VARIABLES)
def test_a_variable_at_power_up_and_after_a_write(name: str, mccl: Runner) -> None:
    value, takes_positive, takes_negative = VARIABLES[name]
    write = "AL{0},1WL@10,1RD@10,TR0\n"
    result = mccl(f'LU"{name}",AR10,1RD@10,TR0\n{write.format(7)}{write.format(-7)}')
    assert result.output == [
        f"{value:.6f}",
        "7.000000" if takes_positive else REFUSED,
        "-7.000000" if takes_negative else REFUSED,
    ]
    reasons = {each.message.partition(" (")[0] for each in result.diagnostics}
    if not takes_positive:
        assert reasons == {f"{name} can only be read"}
    elif not takes_negative:
        assert reasons == {f"{name} accepts 0 or more, not -7"}


def test_the_table_has_every_variable() -> None:
    assert list(VARIABLES) == list(NAMES)


@cases("name", [name for name, (_, writable, _) in VARIABLES.items() if writable])
def test_0_can_be_written_and_only_that_variable_changes(name: str, mccl: Runner) -> None:
    """A position of the axis is that of its target, too."""
    followed = {"POSITION": {"POSITION", "OPTIMAL", "TARGET"}}.get(name, {name})
    reads = "".join(f'LU"{each}",1RD@0,TR0\n' for each in VARIABLES)
    result = mccl(f'LU"{name}",AR10,AL3,1WL@10\n{reads}AL0,1WL@10,1RL@10,TR0\n')
    expected = [3 if each in followed else value for each, (value, *_) in VARIABLES.items()]
    assert result.output == [*(f"{each:.6f}" for each in expected), "0"]


@pytest.mark.parametrize(("model", "decel"), [("dcx-pci100", 7), ("dcx-pci300", 100_000)])
def test_a_board_without_a_deceleration_brakes_as_it_accelerates(
    model: str, decel: int, mccl: Runner
) -> None:
    text = 'LU"ACCEL",AR10,AL7,1WL@10\nLU"SPEED",AR10,AL9,1WL@10\nLU"DECEL",1RL@0,TR0'
    assert mccl(text, machine={"controller.model": model}).output == [str(decel)]


@cases(
    "command, message",
    [
        ("1WL7", "address 7 cannot be written"),
        ("1RL7", "address 7 cannot be read"),
        ('LU"NOWHERE"', "there is no variable 'NOWHERE'"),
    ],
)
def test_an_address_that_is_none(command: str, message: str, mccl: Runner) -> None:
    (found,) = mccl(command).diagnostics
    assert found.message == f"{message} (?-1: command parameter error)"
    assert found.hint == {
        "1WL7": "these can be written: " + ", ".join(name for name, (_, yes, _) in VARIABLES.items() if yes),
        "1RL7": 'find an address with LU"STATUS"',
    }.get(command, "the variables are " + ", ".join(VARIABLES))
