"""Tables of the state machine, refusals, switches and wrapped positions; `modes.txt` has the motion of each mode.

Speeds are written in 0.1 counts/s and rates in 10 counts/s². At power-up they are 10 000 counts/s and
100 000 counts/s², so a ramp takes 0.1 s and 500 counts.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar

import pytest

from motionlang_copley.switches import Switches
from test_copley.bus import Master, SdoAbort

CONTROL, STATUS, MODE, POSITION = 0x6040, 0x6041, 0x6060, 0x6064
SPEED, ACCEL, TARGET_VELOCITY, METHOD = 0x6081, 0x6083, 0x60FF, 0x6098
PP, PV = 1, 3


class Axis(Master):
    """A drive that is taken off the bus at the end of a test."""

    made: ClassVar[list[Master]] = []

    def __init__(self, mode: int = 0, switches: Switches | None = None) -> None:
        super().__init__(mode, switches)
        self.made.append(self)


@pytest.fixture(autouse=True)
def off_the_bus() -> Iterator[None]:
    yield
    while Axis.made:
        Axis.made.pop().close()


@pytest.mark.parametrize(
    ("mode", "switch", "end"),
    [(PV, 100.0, 110.0), (PV, 125.0, 137.5), (PV, 200.0, 212.5), (PP, 4900.0, 4910.0)],
)
@pytest.mark.parametrize("sign", [1, -1])
def test_a_limit_switch_within_a_ramp(mode: int, switch: float, end: float, sign: int) -> None:
    """A stop at 1 000 000/s² takes a tenth of the distance of the ramp at 100 000/s².

    The ramp to 5000/s ends at 125 counts, and the one from 10 000/s to rest at 5000 counts.
    """
    axis = Axis(mode, Switches(negative=-switch, positive=switch))
    if mode == PV:
        axis.write(TARGET_VELOCITY, 50_000 * sign)
    else:
        axis.move(5000 * sign)
    axis.at(1.0)
    assert axis.drive.position == pytest.approx(sign * end, abs=0.01)
    assert axis.errors == [0x8612]


def test_the_present_velocity_written_again_changes_nothing() -> None:
    axis = Axis(PV)
    axis.write(TARGET_VELOCITY, 50_000)
    axis.at(0.02)
    profiles = len(axis.drive.profiles)
    axis.write(TARGET_VELOCITY, 50_000)
    assert len(axis.drive.profiles) == profiles
    assert axis.at(0.05) == 125


# The state after the way to each of them, a control word, and the state of the drive after it.
DISABLED, READY, ON, ENABLED, STOPPED = 0x40, 0x21, 0x23, 0x27, 0x07


@pytest.mark.parametrize(
    ("way", "control", "state"),
    [
        ([], 0x06, READY),
        ([], 0x07, DISABLED),
        ([], 0x0F, DISABLED),
        ([0x06], 0x07, ON),
        ([0x06], 0x0F, ENABLED),
        ([0x06], 0x0E, READY),
        ([0x06, 0x07], 0x06, READY),
        ([0x06, 0x0F], 0x07, ON),
        ([0x06, 0x0F], 0x06, READY),
        ([0x06, 0x0F], 0x0D, DISABLED),
        ([0x06, 0x0F], 0x0B, STOPPED),
        ([0x06, 0x07], 0x0B, DISABLED),
        ([0x06], 0x02, DISABLED),
        ([0x06, 0x0F, 0x0B], 0x0B, STOPPED),
        ([0x06, 0x0F, 0x0B], 0x07, STOPPED),
        ([0x06, 0x0F, 0x0B], 0x0E, STOPPED),
        ([0x06, 0x0F, 0x0B], 0x0F, ENABLED),
        ([0x06, 0x0F, 0x0B], 0x00, DISABLED),
    ],
)
def test_transitions_of_the_state_machine(way: list[int], control: int, state: int) -> None:
    """Bits 0 to 3 are switch on, voltage, no quick stop and enable.

    Option 6 stays in the quick stop.
    """
    axis = Axis(PP)
    axis.write(CONTROL, 0)
    axis.write(0x605A, 6)
    for each in (*way, control):
        axis.write(CONTROL, each)
    mask = 0x4F if state == DISABLED else 0x6F
    assert axis.read(STATUS) & mask == state


@pytest.mark.parametrize(
    ("index", "value", "code"),
    [
        (0x6086, 3, 0x06090030),
        (0x605A, 1, 0x06090030),
        (METHOD, 3, 0x06090030),
        (MODE, 4, 0x06090030),
        (METHOD, 8, 0x06090030),
        (SPEED, 0, 0x06090030),
        (ACCEL, 0, 0x06090030),
        (0x6084, 0, 0x06090030),
        (0x609A, 0, 0x06090030),
        (POSITION, 0, 0x06010002),
    ],
)
def test_a_value_out_of_range_is_refused_with_its_code(index: int, value: int, code: int) -> None:
    axis = Axis(PP)
    with pytest.raises(SdoAbort) as refused:
        axis.write(index, value)
    assert refused.value.args == (code,)
    if index in (SPEED, ACCEL, 0x6084, 0x609A):
        axis.write(index, 1)
        assert axis.read(index) == 1


@pytest.mark.parametrize(
    ("position", "shown"),
    [
        (2.0**31 - 1.0, 2**31 - 1),
        (2.0**31, -(2**31)),
        (-(2.0**31), -(2**31)),
        (-(2.0**31) - 1.0, 2**31 - 1),
        (2.0**32 + 5.0, 5),
    ],
)
def test_positions_wrap_at_32_bits(position: float, shown: int) -> None:
    axis = Axis()
    axis.drive.shift(-position)
    assert [axis.read(index) for index in (0x6062, 0x6063, POSITION)] == [shown] * 3


@pytest.mark.parametrize(
    ("position", "inputs"),
    [
        (-101, 0b001),
        (-100, 0b001),
        (-99, 0),
        (299, 0),
        (300, 0b100),
        (499, 0b100),
        (500, 0b110),
        (501, 0b110),
    ],
)
def test_a_switch_is_active_from_its_position_on(position: int, inputs: int) -> None:
    """Bits 0 and 1 are the limit switches, bit 2 is the home switch."""
    assert Switches(negative=-100, positive=500, home=300).inputs(position) == inputs


@pytest.mark.parametrize("position", [-1e9, 0.0, 1e9])
def test_without_switches_none_is_active(position: float) -> None:
    """There is an index mark at each revolution of 4000 counts."""
    assert Switches().inputs(position) == 0
    assert [Switches().next_index(0.0, direction) for direction in (-5.0, 5.0)] == [-4000.0, 4000.0]
