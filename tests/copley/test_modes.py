"""Profile position, profile velocity and homing without a bus; figures by hand.

Speeds are written in 0.1 counts/s and rates in 10 counts/s². At power-up they are 10 000 counts/s and
100 000 counts/s², so a ramp takes 0.1 s and 500 counts.
"""

from __future__ import annotations

import pytest

from motionlang.copley.drive import IDLE, MOVING, Drive
from motionlang.copley.objects import Abort, ObjectServer
from motionlang.copley.pdo import Sent
from motionlang.copley.switches import Switches

CONTROL, STATUS, MODE, POSITION, VELOCITY = 0x6040, 0x6041, 0x6060, 0x6064, 0x606C
TARGET, SPEED, ACCEL, TARGET_VELOCITY, METHOD = 0x607A, 0x6081, 0x6083, 0x60FF, 0x6098
REACHED, LIMIT, BIT_12, BIT_13 = 0x0400, 0x0800, 0x1000, 0x2000
PP, PV, HM = 1, 3, 6


class Axis:
    """A drive in some mode, with its operation enabled."""

    def __init__(self, mode: int, switches: Switches | None = None) -> None:
        self.drive = Drive()
        self.objects = ObjectServer(self.drive, switches)
        self.errors: list[int] = []
        self.objects.emergency = self.errors.append
        self.write(MODE, mode)
        for control in (0x06, 0x07, 0x0F):
            self.write(CONTROL, control)

    def write(self, index: int, value: int, sub: int = 0) -> None:
        self.objects.write(index, sub, value)

    def at(self, seconds: float) -> int:
        """Let time pass to `seconds` and return the position over the bus."""
        self.drive.run_until(round(seconds * 1e6))
        return self.objects.read(POSITION, 0)

    def has(self, *bits: int) -> list[bool]:
        return [bool(self.objects.read(STATUS, 0) & bit) for bit in bits]

    def move(self, target: int, control: int = 0x1F) -> None:
        """Write a set-point and complete its handshake."""
        self.write(TARGET, target)
        self.write(CONTROL, control)
        self.write(CONTROL, 0x0F)


# ------------------------------------------------------------------------------------------------ profile position


def test_the_position_over_the_bus_is_that_of_the_trapezoid() -> None:
    """5000 counts take 0.1 s up, 0.4 s at speed and 0.1 s down."""
    axis = Axis(PP)
    axis.move(5000)
    assert [axis.at(t) for t in (0.05, 0.1, 0.3, 0.5, 0.55, 0.6)] == [125, 500, 2500, 4500, 4875, 5000]
    assert axis.objects.read(VELOCITY, 0) == 0


def test_the_handshake_of_a_set_point() -> None:
    axis = Axis(PP)
    axis.write(TARGET, 5000)
    assert axis.has(REACHED, BIT_12) == [True, False]
    axis.write(CONTROL, 0x1F)
    assert axis.has(REACHED, BIT_12) == [False, True]
    axis.write(CONTROL, 0x0F)
    assert axis.has(REACHED, BIT_12) == [False, False]
    axis.at(0.6)
    assert axis.has(REACHED, BIT_12) == [True, False]


def test_a_second_set_point_waits_and_keeps_the_acknowledge_until_it_begins() -> None:
    """Both moves take 0.6 s; a third set-point is ignored while the second one waits."""
    axis = Axis(PP)
    axis.move(5000)
    axis.move(0)
    assert axis.has(BIT_12) == [True]
    axis.write(TARGET, 9999)
    axis.write(CONTROL, 0x1F)
    axis.write(CONTROL, 0x0F)
    assert axis.at(0.6) == 5000
    assert axis.has(REACHED, BIT_12) == [False, False]
    assert [axis.at(0.9), axis.at(1.3)] == [2500, 0]
    assert axis.has(REACHED) == [True]


def test_bit_5_changes_the_target_at_once() -> None:
    """At 0.3 s it is at 2500 with 10 000/s; the other 6500 take 0.6 s and 0.1 s down."""
    axis = Axis(PP)
    axis.move(5000)
    axis.at(0.3)
    axis.move(9000, 0x3F)
    assert [axis.at(0.5), axis.at(0.9), axis.at(1.0)] == [4500, 8500, 9000]


def test_bit_6_makes_a_target_relative_to_the_one_before() -> None:
    axis = Axis(PP)
    axis.move(5000)
    axis.move(500, 0x5F)
    assert axis.at(3.0) == 5500
    axis.move(-500, 0x5F)
    assert axis.at(6.0) == 5000


def test_halt_brakes_and_its_end_continues_to_the_target() -> None:
    """Halted at 2500 with 10 000 counts/s, it is at rest at 3000 after 0.1 s."""
    axis = Axis(PP)
    axis.move(5000)
    axis.at(0.3)
    axis.write(CONTROL, 0x10F)
    assert axis.at(1.0) == 3000
    assert axis.has(REACHED) == [True]
    axis.write(CONTROL, 0x0F)
    assert axis.has(REACHED) == [False]
    assert axis.at(3.0) == 5000


def test_speed_and_rates_of_a_set_point_are_those_written_before_it() -> None:
    """500 counts at 1000/s² have their peak, sqrt(500 000)/s, after 250 counts."""
    axis = Axis(PP)
    axis.write(SPEED, 10_000)
    axis.write(ACCEL, 100)
    axis.write(0x6084, 100)
    axis.move(500)
    axis.write(SPEED, 50)
    peak = 500_000**0.5
    assert axis.at(peak / 1000.0) == 250
    assert axis.objects.read(VELOCITY, 0) == round(10 * peak)
    assert axis.at(2.0) == 500


def test_a_limit_switch_ends_the_motion_towards_it_only() -> None:
    """At the switch, 1000, it has 10 000/s; at 1 000 000/s² it stops 50 counts later."""
    axis = Axis(PP, Switches(positive=1000.0))
    axis.move(5000)
    assert axis.at(1.0) == 1050
    assert axis.has(LIMIT) == [True]
    assert axis.errors == [0x8612]
    assert axis.objects.read(0x60FD, 0) == 2
    axis.move(6000)
    assert axis.at(2.0) == 1050
    axis.move(0)
    assert axis.at(3.0) == 0
    assert axis.has(LIMIT) == [False]


def test_a_set_point_at_the_present_position_is_no_motion_towards_a_limit_switch() -> None:
    """The axis is already 5 counts beyond the switch when it is enabled."""
    axis = Axis(PP, Switches(positive=-5.0))
    axis.move(0)
    assert axis.at(1.0) == 0
    assert axis.has(REACHED, LIMIT) == [True, False]
    assert axis.errors == []


# ------------------------------------------------------------------------------------------------ profile velocity


def test_a_velocity_is_followed_as_soon_as_it_is_written() -> None:
    """5000/s is reached in 0.05 s and 125 counts, -5000/s in 0.1 s without net travel."""
    axis = Axis(PV)
    assert axis.has(REACHED, BIT_12) == [True, True]
    axis.write(TARGET_VELOCITY, 50_000)
    assert axis.has(REACHED, BIT_12) == [False, True]
    assert [axis.at(0.05), axis.at(1.0)] == [125, 4875]
    assert axis.objects.read(VELOCITY, 0) == 50_000
    assert axis.has(REACHED, BIT_12) == [True, False]
    axis.write(TARGET_VELOCITY, -50_000)
    assert [axis.at(1.05), axis.at(1.1)] == [5000, 4875]
    axis.write(TARGET_VELOCITY, 0)
    assert [axis.at(1.15), axis.at(9.0)] == [4750, 4750]
    assert axis.drive.state == IDLE


def test_halt_and_disabling_bring_a_velocity_to_rest() -> None:
    axis = Axis(PV)
    axis.write(TARGET_VELOCITY, 50_000)
    axis.at(1.0)
    axis.write(CONTROL, 0x10F)
    axis.at(1.05)
    assert axis.has(REACHED, BIT_12) == [True, True]
    axis.write(CONTROL, 0x0F)
    axis.at(2.0)
    assert axis.objects.read(VELOCITY, 0) == 50_000
    axis.write(CONTROL, 0x06)
    axis.at(3.0)
    assert axis.objects.read(VELOCITY, 0) == 0


# ------------------------------------------------------------------------------------------------------------ homing

MACHINE = Switches(negative=-2000.0, positive=3000.0, home=800.0, index=300.0)


@pytest.mark.parametrize(
    ("method", "position"),
    [
        (1, -1800),
        (2, 2700),
        (17, -2000),
        (18, 3000),
        (19, 800),
        (20, 800),
        (33, -300),
        (34, 300),
        (35, 0),
        (37, 0),
    ],
)
def test_each_method_ends_at_its_position(method: int, position: int) -> None:
    """Index marks are 300 counts apart; those next to the limits are -1800 and 2700."""
    axis = Axis(HM, MACHINE)
    axis.write(METHOD, method)
    axis.write(CONTROL, 0x1F)
    axis.at(60.0)
    assert axis.has(REACHED, BIT_12, BIT_13) == [True, True, False]
    assert axis.objects.read(POSITION, 0) == 0
    assert axis.drive.datum == position


def test_homing_from_an_active_switch_leaves_it() -> None:
    axis = Axis(HM, MACHINE)
    axis.drive.shift(-1000.0)
    axis.drive.datum = 0.0  # the axis is at 1000, and the home switch is active from 800 up
    axis.write(METHOD, 20)
    axis.write(CONTROL, 0x1F)
    axis.at(60.0)
    assert (axis.drive.datum, axis.objects.read(POSITION, 0)) == (800.0, 0)


def test_the_time_of_a_search() -> None:
    """With method 33 at 500/s and 100 000/s², 300 counts take 0.6 s and 2.5 ms."""
    axis = Axis(HM, MACHINE)
    axis.write(METHOD, 33)
    axis.write(CONTROL, 0x1F)
    assert axis.at(0.6025) == -300
    assert axis.has(REACHED, BIT_12) == [False, False]
    axis.at(1.0)
    assert axis.has(REACHED, BIT_12) == [True, True]


def test_the_home_offset_shifts_the_zero_position() -> None:
    axis = Axis(HM, MACHINE)
    axis.write(0x607C, 250)
    axis.write(METHOD, 35)
    axis.write(CONTROL, 0x1F)
    assert axis.at(0.001) == -250


def test_homing_is_interrupted_when_bit_4_falls() -> None:
    axis = Axis(HM, MACHINE)
    axis.write(METHOD, 18)
    axis.write(CONTROL, 0x1F)
    axis.at(0.1)
    axis.write(CONTROL, 0x0F)
    axis.at(1.0)
    assert axis.has(REACHED, BIT_12, BIT_13) == [True, False, False]
    axis.write(CONTROL, 0x1F)
    axis.at(60.0)
    assert axis.has(BIT_12) == [True]


@pytest.mark.parametrize("switches", [Switches(), Switches(positive=500.0, home=800.0)])
def test_a_switch_that_does_not_come_is_a_homing_error(switches: Switches) -> None:
    axis = Axis(HM, switches)
    axis.write(METHOD, 19)
    axis.write(CONTROL, 0x1F)
    axis.at(60.0)
    assert axis.has(REACHED, BIT_12, BIT_13) == [True, False, True]
    assert axis.errors == [0x8612]


# ----------------------------------------------------------------------------------------------------- state machine


def test_a_quick_stop_brakes_and_disables() -> None:
    """A stop from 10 000/s at 1 000 000/s² takes 10 ms."""
    axis = Axis(PP)
    axis.move(50_000)
    axis.at(1.0)
    axis.write(CONTROL, 0x0B)
    assert axis.objects.read(STATUS, 0) & 0x6F == 0x07
    axis.at(1.011)
    assert axis.objects.read(STATUS, 0) & 0x4F == 0x40


def test_quick_stop_option_6_stays_and_can_be_enabled_again() -> None:
    axis = Axis(PP)
    axis.write(0x605A, 6)
    axis.write(CONTROL, 0x0B)
    axis.at(1.0)
    assert axis.objects.read(STATUS, 0) & 0x6F == 0x07
    axis.write(CONTROL, 0x0F)
    assert axis.objects.read(STATUS, 0) & 0x6F == 0x27


def test_a_fault_brakes_and_ends_with_bit_7() -> None:
    axis = Axis(PV)
    axis.write(TARGET_VELOCITY, 50_000)
    axis.at(1.0)
    axis.objects.trip(0x8130)
    assert axis.objects.read(STATUS, 0) & 0x4F == 0x08
    axis.write(CONTROL, 0x0F)
    assert axis.objects.read(STATUS, 0) & 0x4F == 0x08
    assert axis.objects.read(0x603F, 0) == 0x8130
    axis.write(CONTROL, 0x80)
    assert axis.objects.read(STATUS, 0) & 0x4F == 0x40
    assert axis.errors == [0x8130, 0]
    axis.at(2.0)
    assert axis.drive.state == IDLE


def test_a_mode_is_chosen_at_rest() -> None:
    axis = Axis(PP)
    assert axis.objects.read(0x6502, 0) == 0b1100101
    axis.move(50_000)
    with pytest.raises(Abort, match="while a move is in progress") as refused:
        axis.write(MODE, PV)
    assert refused.value.code == 0x08000022
    assert axis.drive.state == MOVING
    axis.write(MODE, PP)


@pytest.mark.parametrize(
    ("index", "sub", "value"),
    [
        (MODE, 0, 4),
        (SPEED, 0, 0),
        (ACCEL, 0, 0),
        (0x6086, 0, 3),
        (METHOD, 0, 8),
        (0x6099, 2, 0),
        (0x605A, 0, 1),
    ],
)
def test_values_that_are_not_simulated_are_refused(index: int, sub: int, value: int) -> None:
    axis = Axis(PP)
    with pytest.raises(Abort) as refused:
        axis.write(index, value, sub)
    assert refused.value.code == 0x06090030


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
    assert Switches().inputs(position) == 0


@pytest.mark.parametrize(
    ("kind", "sent"), [(1, [1, 2, 3, 4, 5, 6, 7]), (2, [2, 4, 6]), (3, [3, 6]), (240, []), (255, [])]
)
def test_a_pdo_of_type_n_is_sent_on_every_nth_sync(kind: int, sent: list[int]) -> None:
    pdo = Sent(0x182, kind, 0.0, 0.0, [])
    assert [sync for sync in range(1, 8) if pdo.on_sync(b"data")] == sent


def test_a_pdo_of_type_0_is_sent_on_a_sync_if_its_data_have_changed() -> None:
    pdo = Sent(0x182, 0, 0.0, 0.0, [], data=b"old")
    assert [pdo.on_sync(data) for data in (b"old", b"new", b"old")] == [False, True, False]
