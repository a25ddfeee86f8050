"""Profile position, profile velocity and homing, as a master on the bus sees them; figures by hand.

Speeds are written in 0.1 counts/s and rates in 10 counts/s². At power-up they are 10 000 counts/s and
100 000 counts/s², so a ramp takes 0.1 s and 500 counts.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar

import pytest

from motionlang_copley.switches import Switches
from test_copley.bus import Master, SdoAbort

CONTROL, STATUS, MODE, POSITION, VELOCITY = 0x6040, 0x6041, 0x6060, 0x6064, 0x606C
TARGET, SPEED, ACCEL, TARGET_VELOCITY, METHOD = 0x607A, 0x6081, 0x6083, 0x60FF, 0x6098
REACHED, LIMIT, BIT_12, BIT_13 = 0x0400, 0x0800, 0x1000, 0x2000
# Voltage is on (bit 4), and the drive is remote (bit 9).
OTHERS = 0x0210
PP, PV, HM = 1, 3, 6


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


# ------------------------------------------------------------------------------------------------ profile position


def test_the_position_over_the_bus_is_that_of_the_trapezoid() -> None:
    """5000 counts take 0.1 s up, 0.4 s at speed and 0.1 s down."""
    axis = Axis(PP)
    axis.move(5000)
    assert [axis.at(t) for t in (0.05, 0.1, 0.3, 0.5, 0.55, 0.6)] == [125, 500, 2500, 4500, 4875, 5000]
    assert axis.read(VELOCITY) == 0


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


def test_the_present_position_as_a_target() -> None:
    """At rest there is no motion; from 10 000/s at 2500 the axis comes back from 3000."""
    axis = Axis(PP)
    axis.move(0)
    assert axis.has(REACHED) == [True]
    axis.move(5000)
    assert axis.at(0.3) == axis.drive.position == 2500.0
    axis.move(2500, 0x3F)
    assert axis.has(REACHED) == [False]
    assert [axis.at(0.4), axis.at(1.0)] == [3000, 2500]


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
    assert axis.read(VELOCITY) == round(10 * peak)
    assert axis.at(2.0) == 500


def test_each_rate_is_that_of_its_side() -> None:
    """Between the ramps are 0.4 s and 4000 counts.

    10 000/s up at 50 000/s² takes 0.2 s and 1000 counts, down at 200 000/s² 50 ms and 250.
    """
    axis = Axis(PP)
    axis.write(ACCEL, 5000)
    axis.write(0x6084, 20_000)
    axis.move(5250)
    assert [axis.at(t) for t in (0.1, 0.2, 0.6, 0.65)] == [250, 1000, 5000, 5250]


def test_halt_brakes_at_the_deceleration_of_set_points() -> None:
    """From 10 000/s at 200 000/s² it stops in 50 ms and 250 counts."""
    axis = Axis(PP)
    axis.write(0x6084, 20_000)
    axis.move(5000)
    axis.at(0.3)
    axis.write(CONTROL, 0x10F)
    assert axis.at(0.35) == 2750
    assert axis.drive.velocity == 0.0


def test_a_second_halt_brakes_like_the_first_one() -> None:
    """From 10 000/s each stop takes 0.1 s and 500 counts, as each start does."""
    axis = Axis(PP)
    axis.move(9000)
    positions = []
    for time in (0.3, 1.0):
        axis.at(time)
        axis.write(CONTROL, 0x10F)
        positions.append(axis.at(time + 0.4))
        axis.write(CONTROL, 0x0F)
    assert positions == [3000, 6000]
    assert axis.at(3.0) == 9000


def test_halt_at_rest_starts_no_motion_when_it_ends() -> None:
    axis = Axis(PP)
    axis.write(TARGET, 5000)
    axis.write(CONTROL, 0x10F)
    axis.write(CONTROL, 0x0F)
    assert axis.has(REACHED, BIT_12) == [True, False]
    assert axis.at(1.0) == 0


def test_a_set_point_while_halted_is_ignored() -> None:
    """Bit 4 rises while bit 8 is set, and does not rise again when bit 8 falls."""
    axis = Axis(PP)
    axis.write(TARGET, 5000)
    axis.write(CONTROL, 0x10F)
    axis.write(CONTROL, 0x11F)
    axis.write(CONTROL, 0x1F)
    assert axis.has(REACHED, BIT_12) == [True, False]
    assert axis.at(1.0) == 0


def test_the_acknowledge_stays_while_bit_4_is_set_although_the_second_move_begins() -> None:
    axis = Axis(PP)
    axis.move(5000)
    axis.write(TARGET, 9000)
    axis.write(CONTROL, 0x1F)
    axis.at(0.7)
    assert axis.has(BIT_12) == [True]
    axis.write(CONTROL, 0x0F)
    assert axis.has(REACHED, BIT_12) == [False, False]
    assert axis.at(2.0) == 9000


def test_a_set_point_at_once_is_ignored_while_another_one_waits() -> None:
    """The drive cannot acknowledge it: bit 12 is still set for the one that waits, 0."""
    axis = Axis(PP)
    axis.move(5000)
    axis.move(0)
    axis.at(0.3)
    axis.move(9000, 0x3F)
    assert [axis.at(0.6), axis.at(1.2)] == [5000, 0]


def test_a_relative_set_point_at_once_counts_from_the_target_in_force() -> None:
    """The target is 5000, the position 2500."""
    axis = Axis(PP)
    axis.move(5000)
    axis.at(0.3)
    axis.move(1000, 0x7F)
    assert axis.at(3.0) == 6000


def test_a_limit_switch_ends_the_motion_towards_it_only() -> None:
    """At the switch, 1000, it has 10 000/s; at 1 000 000/s² it stops 50 counts later."""
    axis = Axis(PP, Switches(positive=1000.0))
    axis.move(5000)
    assert axis.at(1.0) == 1050
    assert axis.has(LIMIT) == [True]
    assert axis.errors == [0x8612]
    assert axis.read(0x60FD) == 2
    axis.write(CONTROL, 0)
    assert axis.read(STATUS) == REACHED | LIMIT | OTHERS | DISABLED
    for control in (0x06, 0x07, 0x0F):
        axis.write(CONTROL, control)
    axis.move(6000)
    assert axis.at(2.0) == 1050
    assert axis.errors == [0x8612, 0x8612]
    axis.move(0)
    assert axis.at(3.0) == 0
    assert axis.has(LIMIT) == [False]


@pytest.mark.parametrize("sign", [1, -1])
def test_a_motion_may_end_on_a_limit_switch_but_not_begin_there(sign: int) -> None:
    """The switches are 1000 counts from the start, and are bits 0 and 1 of 0x60FD."""
    axis = Axis(PP, Switches(negative=-1000.0, positive=1000.0))
    axis.move(999 * sign)
    assert axis.at(1.0) == 999 * sign
    assert axis.read(0x60FD) == 0
    axis.move(1000 * sign)
    assert axis.at(2.0) == 1000 * sign
    assert axis.has(REACHED, LIMIT) == [True, False]
    assert axis.read(0x60FD) == (2 if sign > 0 else 1)
    axis.move(1001 * sign)
    assert axis.has(REACHED, LIMIT) == [True, True]
    assert axis.at(3.0) == 1000 * sign
    assert axis.has(REACHED, LIMIT) == [True, True]
    assert axis.errors == [0x8612]
    axis.move(0)
    assert axis.at(4.0) == 0
    assert axis.has(REACHED, LIMIT) == [True, False]


@pytest.mark.parametrize("sign", [1, -1])
def test_a_limit_switch_ends_a_velocity_towards_it(sign: int) -> None:
    """At 1 000 000/s² a stop from 5000/s takes 12.5 counts behind the switch at 1000."""
    axis = Axis(PV, Switches(negative=-1000.0, positive=1000.0))
    axis.write(TARGET_VELOCITY, 50_000 * sign)
    assert axis.at(0.1) == 375 * sign
    axis.at(1.0)
    assert axis.drive.position == pytest.approx(1012.5 * sign)
    assert axis.has(LIMIT) == [True]
    axis.write(TARGET_VELOCITY, -50_000 * sign)
    assert axis.has(LIMIT) == [False]
    axis.at(1.05)
    assert axis.drive.position == pytest.approx((1012.5 - 125.0) * sign)


def test_the_switches_belong_to_the_machine_and_not_to_the_zero_position() -> None:
    """After homing at 800 the positive switch, at 3000 on the machine, is at 2200.

    The stop behind it takes 50 counts; there the home switch, bit 2, is active, too.
    """
    axis = Axis(HM, MACHINE)
    axis.write(METHOD, 19)
    axis.write(CONTROL, 0x1F)
    axis.at(10.0)
    assert axis.read(0x60FD) == 0b100
    axis.write(CONTROL, 0x0F)
    axis.write(MODE, PP)
    axis.move(9000)
    assert axis.at(20.0) == 2250
    assert axis.read(0x60FD) == 0b110
    axis.move(-9000)
    assert axis.at(30.0) == -2850
    assert axis.read(0x60FD) == 0b001


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


def test_a_target_one_count_behind_a_limit_switch_after_homing() -> None:
    """The home switch at 800 is the zero position, so the limit switch is at 2200."""
    axis = Axis(HM, MACHINE)
    axis.write(METHOD, 19)
    axis.write(CONTROL, 0x1F)
    axis.at(10.0)
    axis.write(CONTROL, 0x0F)
    axis.write(MODE, PP)
    for target, limited in ((2200, False), (2201, True), (-2800, False), (-2801, True)):
        axis.move(target)
        assert axis.at(axis.drive.now + 10.0) == (
            target if not limited else target - (1 if target > 0 else -1)
        )
        assert axis.has(LIMIT) == [limited]


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
    assert axis.read(VELOCITY) == 50_000
    assert axis.has(REACHED, BIT_12) == [True, False]
    axis.write(TARGET_VELOCITY, -50_000)
    assert [axis.at(1.05), axis.at(1.1)] == [5000, 4875]
    axis.write(TARGET_VELOCITY, 0)
    assert [axis.at(1.15), axis.at(9.0)] == [4750, 4750]
    assert axis.drive.state == "idle"


def test_the_slowest_velocity_is_a_motion() -> None:
    """0.1 counts/s is reached in 1 µs; bit 12 is the speed zero."""
    axis = Axis(PV)
    axis.write(TARGET_VELOCITY, 1)
    assert axis.has(REACHED, BIT_12) == [False, True]
    assert axis.at(20.0) == 2
    assert axis.has(REACHED, BIT_12) == [True, False]


def test_each_rate_of_a_velocity_is_that_of_its_side() -> None:
    """5000/s takes 0.1 s and 250 counts up at 50 000/s², 25 ms and 62.5 counts down."""
    axis = Axis(PV)
    axis.write(ACCEL, 5000)
    axis.write(0x6084, 20_000)
    axis.write(TARGET_VELOCITY, 50_000)
    assert [axis.at(0.1), axis.at(0.2)] == [250, 750]
    axis.write(TARGET_VELOCITY, 0)
    axis.at(0.225)
    assert axis.drive.position == pytest.approx(812.5)
    assert axis.drive.state == "idle"


def test_the_mode_starts_with_the_velocity_that_was_written_before_it() -> None:
    axis = Axis(PP)
    axis.write(TARGET_VELOCITY, 50_000)
    assert axis.at(1.0) == 0
    axis.write(MODE, PV)
    assert axis.at(1.05) == 125


def test_a_velocity_waits_until_operation_is_enabled() -> None:
    axis = Axis(PV)
    axis.write(CONTROL, 0x07)
    axis.write(TARGET_VELOCITY, 50_000)
    assert axis.at(1.0) == 0
    axis.write(CONTROL, 0x0F)
    assert axis.at(1.05) == 125


def test_an_axis_at_rest_has_reached_its_velocity_before_it_is_enabled() -> None:
    axis = Axis()
    axis.write(MODE, PV)
    axis.write(TARGET_VELOCITY, 50_000)
    assert axis.read(STATUS) == REACHED | BIT_12 | OTHERS | DISABLED


def test_the_present_velocity_written_again_changes_nothing() -> None:
    axis = Axis(PV)
    axis.write(TARGET_VELOCITY, 50_000)
    axis.at(0.02)
    profiles = len(axis.drive.profiles)
    axis.write(TARGET_VELOCITY, 50_000)
    assert len(axis.drive.profiles) == profiles
    assert axis.at(0.05) == 125


def test_halt_and_disabling_bring_a_velocity_to_rest() -> None:
    axis = Axis(PV)
    axis.write(TARGET_VELOCITY, 50_000)
    axis.at(1.0)
    axis.write(CONTROL, 0x10F)
    axis.at(1.05)
    assert axis.has(REACHED, BIT_12) == [True, True]
    axis.write(CONTROL, 0x0F)
    axis.at(2.0)
    assert axis.read(VELOCITY) == 50_000
    axis.write(CONTROL, 0x06)
    axis.at(3.0)
    assert axis.read(VELOCITY) == 0


# ------------------------------------------------------------------------------------------------------------ homing

MACHINE = Switches(negative=-2000.0, positive=3000.0, home=800.0, index=300.0)


def test_homing_from_an_active_switch_leaves_it() -> None:
    """At 5000/s it covers 125 counts in 50 ms, 75 in 15 ms, and 125 to stop."""
    axis = Axis(HM, MACHINE)
    axis.drive.shift(-1000.0)
    axis.drive.datum = 0.0  # the axis is at 1000, and the home switch is active from 800 up
    axis.write(METHOD, 20)
    axis.write(CONTROL, 0x1F)
    for time, position in ((0.0, 1000.0), (0.05, 875.0), (0.065, 800.0), (0.115, 675.0)):
        axis.at(time)
        assert axis.drive.position == pytest.approx(position, abs=1e-3)
    axis.at(60.0)
    assert (axis.drive.datum, axis.read(POSITION)) == (800.0, 0)


def test_the_time_of_a_search() -> None:
    """With method 33 at 500/s and 100 000/s², 300 counts take 0.6 s and 2.5 ms."""
    axis = Axis(HM, MACHINE)
    axis.write(METHOD, 33)
    axis.write(CONTROL, 0x1F)
    assert axis.at(0.6025) == -300
    assert axis.has(REACHED, BIT_12) == [False, False]
    axis.at(1.0)
    assert axis.has(REACHED, BIT_12) == [True, True]


@pytest.mark.parametrize(("method", "mark"), [(33, -0.5), (34, 0.5)])
def test_a_search_may_end_within_a_count(method: int, mark: float) -> None:
    """At 1 count/s the index mark is half a second away, the ramp takes 10 µs."""
    axis = Axis(HM, Switches(index=0.5))
    axis.write(0x6099, 10, 2)
    axis.write(METHOD, method)
    axis.write(CONTROL, 0x1F)
    axis.at(0.4)
    assert axis.has(BIT_12) == [False]
    axis.at(0.6)
    assert axis.has(BIT_12) == [True]
    assert axis.drive.datum == mark


def test_a_search_moves_to_a_limit_switch_within_a_count() -> None:
    """At 1 count/s the axis arrives at the switch; the index mark at 10 is behind it."""
    axis = Axis(HM, Switches(positive=0.5, index=10.0))
    axis.write(0x6099, 10, 2)
    axis.write(METHOD, 34)
    axis.write(CONTROL, 0x1F)
    axis.at(1.0)
    assert axis.drive.position == pytest.approx(0.5, abs=1e-4)
    assert axis.errors == [0x8612]


@pytest.mark.parametrize(("method", "sign"), [(19, 1), (20, 1), (18, 1), (17, -1)])
def test_the_time_of_a_search_for_a_switch(method: int, sign: int) -> None:
    """The switch is 800 counts away, or the axis leaves it at once.

    Up to 5000/s at 100 000/s² takes 50 ms and 125 counts, the other 675 take 135 ms. The stop takes 50 ms and 125
    counts, and the return at 500/s 5 ms for 1.25 counts and 247.5 ms for 123.75. So it is back at 0.4875 s, stops
    5 ms and 1.25 counts later, and returns these in 2 sqrt(1.25 / 100 000) s = 7.07 ms.
    """
    axis = Axis(HM, Switches(negative=-800.0, positive=800.0, home=800.0))
    axis.write(METHOD, method)
    axis.write(CONTROL, 0x1F)
    if method == 20:  # The switch is not active, so the axis looks for its edge forwards and slowly.
        assert axis.at(1.6025) == 800
        assert axis.has(BIT_12) == [False]
        axis.at(1.62)
    else:
        times = (0.05, 0.185, 0.235, 0.4875, 0.4925)
        positions = (125.0, 800.0, 925.0, 800.0, 798.75)
        for time, position in zip(times, positions, strict=True):
            axis.at(time)
            assert axis.drive.position == pytest.approx(sign * position, abs=1e-3)
        axis.at(0.499)
        assert axis.has(REACHED, BIT_12) == [False, False]
        axis.at(0.5)
    assert axis.has(REACHED, BIT_12) == [True, True]
    assert (axis.drive.datum, axis.read(POSITION)) == (sign * 800.0, 0)


@pytest.mark.parametrize("method", [1, 2, 17, 18, 19, 20, 33, 34, 35, 37])
def test_homing_again_ends_at_a_position_on_the_machine(method: int) -> None:
    """The first homing moves the zero position to 3000 on the machine.

    The next one starts there, with two active switches. The index marks next to it are 2700, and 3300 behind the limit.
    """
    axis = Axis(HM, MACHINE)
    for each in (18, method):
        axis.write(METHOD, each)
        axis.write(CONTROL, 0x1F)
        axis.at(axis.drive.now + 60.0)
        axis.write(CONTROL, 0x0F)
    ends = {1: -1800, 2: 2700, 17: -2000, 18: 3000, 19: 800, 20: 800, 33: 2700, 34: 3000, 35: 3000, 37: 3000}
    homed = method != 34
    assert axis.has(REACHED, BIT_12, BIT_13) == [True, homed, not homed]
    assert axis.drive.datum + axis.read(POSITION) == ends[method]
    assert axis.drive.datum == ends[method]
    assert axis.errors == ([] if homed else [0x8612])


@pytest.mark.parametrize(("method", "position"), [(33, -100), (34, 200), (1, -900), (2, 600)])
def test_the_next_index_mark_is_beyond_the_one_that_the_axis_is_on(method: int, position: int) -> None:
    """Marks are 100 counts apart, and the axis is on one.

    It is 0, with method 34 100, and with methods 1 and 2 that of a limit, -1000 and 700.
    """
    axis = Axis(HM, Switches(negative=-1000.0, positive=700.0, index=100.0))
    if method == 34:
        axis.drive.shift(-100.0)
        axis.drive.datum = 0.0
    axis.write(METHOD, method)
    axis.write(CONTROL, 0x1F)
    axis.at(60.0)
    assert axis.drive.datum == position


@pytest.mark.parametrize(
    ("method", "switches"),
    [
        (17, Switches(negative=0.0)),
        (18, Switches(positive=0.0)),
        (19, Switches(home=0.0)),
        (19, Switches(positive=-1.0, home=0.0)),
        (20, Switches(home=0.0)),
    ],
)
def test_an_axis_on_the_edge_of_its_switch_is_homed_at_once(method: int, switches: Switches) -> None:
    """A switch is active at its position, so there is nothing to search."""
    axis = Axis(HM, switches)
    axis.write(METHOD, method)
    axis.write(CONTROL, 0x1F)
    assert axis.has(REACHED, BIT_12, BIT_13) == [True, True, False]


def test_the_home_offset_is_that_of_the_home_position_wherever_it_is() -> None:
    """The switch at 800 on the machine becomes -250; the axis stops on it."""
    axis = Axis(HM, MACHINE)
    axis.write(0x607C, 250)
    axis.write(METHOD, 19)
    axis.write(CONTROL, 0x1F)
    assert axis.at(60.0) == -250
    assert axis.drive.datum == 1050.0


def test_before_homing_there_is_no_result_of_one() -> None:
    assert Axis(HM, MACHINE).has(REACHED, LIMIT, BIT_12, BIT_13) == [True, False, False, False]


def test_halt_interrupts_homing() -> None:
    axis = Axis(HM, MACHINE)
    axis.write(METHOD, 18)
    axis.write(CONTROL, 0x1F)
    axis.at(0.1)
    axis.write(CONTROL, 0x11F)
    axis.at(1.0)
    assert axis.has(REACHED, BIT_12, BIT_13) == [True, False, False]
    assert axis.drive.state == "idle"


def test_a_new_homing_forgets_the_result_of_the_last_one() -> None:
    axis = Axis(HM, MACHINE)
    for method, bits in ((35, [True, False]), (0, [False, True]), (37, [True, False])):
        axis.write(METHOD, method)
        axis.write(CONTROL, 0x0F)
        axis.write(CONTROL, 0x1F)
        assert axis.has(BIT_12, BIT_13) == bits


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


@pytest.mark.parametrize(
    ("method", "switches", "code", "reason"),
    [
        (19, Switches(), 0xFF01, "the machine has no home switch"),
        (20, Switches(), 0xFF01, "the machine has no home switch"),
        (17, Switches(), 0xFF01, "the machine has no negative limit switch"),
        (19, Switches(positive=500.0), 0x8612, "there is no home switch before the positive limit switch"),
        (
            19,
            Switches(positive=500.0, home=800.0),
            0x8612,
            "there is no home switch before the positive limit switch",
        ),
        (33, Switches(negative=-9.0), 0x8612, "there is no index mark before the negative limit switch"),
        (0, Switches(), 0xFF02, "0x6098 is 0, which selects no method"),
    ],
)
def test_a_homing_that_fails_says_why(method: int, switches: Switches, code: int, reason: str) -> None:
    axis = Axis(HM, switches)
    axis.write(METHOD, method)
    axis.write(CONTROL, 0x1F)
    axis.at(60.0)
    axis.write(CONTROL, 0)
    assert axis.read(STATUS) == REACHED | BIT_13 | OTHERS | DISABLED
    assert axis.errors == [code]
    assert axis.complaints == [f"drive 1: homing failed: {reason}"]


def test_bit_4_that_stays_set_starts_another_method_after_a_failure() -> None:
    """The axis stops 12.5 counts behind the limit switch: 5000/s at 1 000 000/s², in 5 ms."""
    axis = Axis(HM, Switches(positive=500.0))
    axis.write(METHOD, 19)
    for time in (0.127, 0.128):  # the switch comes at 125 counts in 50 ms, and 375 in 75 ms
        axis.write(CONTROL, 0x1F)
        axis.at(time)
        assert axis.has(BIT_13) == [True]
    assert axis.errors == [0x8612]
    axis.write(METHOD, 35)
    axis.write(CONTROL, 0x1F)
    axis.at(1.0)
    assert axis.has(REACHED, BIT_12, BIT_13) == [True, True, False]
    axis.write(METHOD, 37)
    axis.write(CONTROL, 0x1F)
    assert axis.errors == [0x8612]


# ----------------------------------------------------------------------------------------------------- state machine


def test_a_quick_stop_brakes_and_disables() -> None:
    """A stop from 10 000/s at 1 000 000/s² takes 10 ms."""
    axis = Axis(PP)
    axis.move(50_000)
    axis.at(1.0)
    axis.write(CONTROL, 0x0B)
    assert axis.read(STATUS) & 0x6F == 0x07
    axis.at(1.011)
    assert axis.read(STATUS) & 0x4F == 0x40


def test_a_fault_brakes_and_ends_with_bit_7() -> None:
    axis = Axis(PV)
    axis.write(TARGET_VELOCITY, 50_000)
    axis.at(1.0)
    axis.node.objects.trip(0x8130)
    assert axis.read(STATUS) & 0x4F == 0x08
    axis.write(CONTROL, 0x0F)
    assert axis.read(STATUS) & 0x4F == 0x08
    assert axis.read(0x603F) == 0x8130
    axis.write(CONTROL, 0x80)
    assert axis.read(STATUS) & 0x4F == 0x40
    assert axis.errors == [0x8130, 0]
    axis.at(2.0)
    assert axis.drive.state == "idle"


def test_a_mode_is_chosen_at_rest() -> None:
    axis = Axis(PP)
    assert axis.read(0x6502) == 0b1100101
    axis.move(50_000)
    with pytest.raises(SdoAbort) as refused:
        axis.write(MODE, PV)
    assert refused.value.args == (0x08000022,)
    assert axis.drive.state == "moving"
    axis.write(MODE, PP)


def test_a_quick_stop_of_a_stopped_drive_disables_at_once() -> None:
    """With option 2, and only with it."""
    for option, status in ((2, 0x40), (6, 0x07)):
        axis = Axis(PP)
        axis.write(0x605A, option)
        axis.write(CONTROL, 0x0B)
        assert axis.read(STATUS) & 0x6F == status


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


def test_a_fault_ends_when_bit_7_rises_and_not_while_it_is_set() -> None:
    axis = Axis(PP)
    axis.write(CONTROL, 0x8F)
    axis.node.objects.trip(0x8130)
    for control in (0x8F, 0x00, 0x0F):
        axis.write(CONTROL, control)
        assert axis.read(STATUS) & 0x4F == 0x08
    axis.write(CONTROL, 0x8F)
    assert axis.read(STATUS) & 0x4F == 0x40
    assert axis.read(0x603F) == 0


def test_a_reset_restores_the_values_at_power_up() -> None:
    """The control word is one of them, so the drive is disabled. The position stays."""
    axis = Axis(PP)
    axis.move(700)
    axis.at(1.0)
    changed = {
        SPEED: 5,
        ACCEL: 6,
        0x6084: 7,
        0x609A: 8,
        0x607C: 9,
        METHOD: 35,
        TARGET_VELOCITY: 10,
        0x605A: 6,
    }
    for index, value in changed.items():
        axis.write(index, value)
        assert axis.read(index) == value
    axis.write(0x6099, 11, 1)
    axis.write(0x6099, 12, 2)
    assert [axis.read(0x6099, sub) for sub in (1, 2)] == [11, 12]
    axis.node.objects.trip(0x8130)
    axis.send(0, 129, 1)
    after = {SPEED: 100_000, ACCEL: 10_000, 0x6084: 10_000, 0x609A: 10_000, 0x607C: 0, METHOD: 0,
             TARGET_VELOCITY: 0, 0x605A: 2, TARGET: 0, MODE: 0, CONTROL: 0, 0x6086: 0, 0x603F: 0,
             POSITION: 700}  # fmt: skip
    assert {index: axis.read(index) for index in after} == after
    assert [axis.read(0x6099, sub) for sub in (1, 2)] == [50_000, 5000]
    assert [axis.read(0x60C1, sub) for sub in (1, 2, 3)] == [0, 0, 0]
    assert [axis.read(0x60C2, sub) for sub in (1, 2)] == [1, -3]
    assert (axis.read(0x60C0), axis.drive.steering) == (0, True)
    assert axis.read(STATUS) & 0x4F == 0x40


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
