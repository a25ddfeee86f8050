"""The motion of the drive along the points in its buffer, in virtual time."""

from __future__ import annotations

from math import inf

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.kernel.planners import hold
from motionlang.lab.pvt.drive.packet import OVERFLOW, SIZE, UNDERFLOW
from motionlang.lab.pvt.drive.point import WirePoint, from_wire
from motionlang.lab.pvt.points import plan_points
from motionlang_copley.buffer import BufferedPoint
from motionlang_copley.drive import IDLE, MOVING, STOPPING, WAITING, Drive

SCURVE = [
    WirePoint(0, 0, 100),
    WirePoint(83, 25_000, 100),
    WirePoint(500, 50_000, 100),
    WirePoint(917, 25_000, 100),
    WirePoint(1000, 0, 0),
]


def loaded(points: list[WirePoint], position: float = 0.0) -> Drive:
    drive = Drive(position)
    for point in points:
        assert drive.add(point)
    return drive


def positions(drive: Drive, milliseconds: list[int]) -> list[float]:
    """Return the positions of the drive at the given times, ms."""
    found = []
    for time in milliseconds:
        drive.run_until(time * 1000)
        found.append(drive.position)
    return found


def events(drive: Drive) -> list[str]:
    return [what for _, what in drive.log]


def test_the_s_curve_of_the_note() -> None:
    drive = loaded(SCURVE)
    drive.start()
    assert positions(drive, [0, 100, 200, 300, 400, 500]) == pytest.approx([0, 83, 500, 917, 1000, 1000])
    assert drive.state == IDLE
    assert drive.log == [(0.0, "move started at 0"), (0.4, "move ended at 1000")]
    assert drive.starts == pytest.approx([0.0, 0.0, 0.1, 0.2, 0.3, 0.4])
    phases = [phase for profile in drive.profiles if profile.shape == "pvt" for phase in profile.phases]
    assert [(phase.name, phase.duration) for phase in phases] == [("segment", 0.1)] * 4


wire_points = st.builds(
    WirePoint,
    st.integers(-5000, 5000),
    st.one_of(st.none(), st.integers(-100_000, 100_000)),
    st.integers(1, 255),
    st.booleans(),
)


@given(st.lists(wire_points, min_size=1, max_size=20), wire_points, st.integers(-100, 100))
def test_the_motion_is_that_of_the_points(points: list[WirePoint], last: WirePoint, position: int) -> None:
    """Cubic and linear, absolute and relative points in one move; exact positions."""
    move = [*points, WirePoint(last.position, last.velocity, 0, last.relative)]
    drive = loaded(move, float(position))
    drive.start()
    profile = plan_points(from_wire(move), float(position))
    total = sum(point.time for point in move)
    for step in range(1, 12):
        drive.run_until(total * 1000 * step // 11)
        assert drive.position == pytest.approx(profile.position(drive.now), abs=1e-6)
    assert drive.state == IDLE


def test_the_first_relative_point_counts_from_the_commanded_position() -> None:
    drive = loaded([WirePoint(5, 0, 10, relative=True), WirePoint(10, 0, 0, relative=True)], 100.0)
    drive.start()
    assert positions(drive, [0, 10]) == [105.0, 115.0]
    assert "commanded position steps from 100 to 105 at the start" in events(drive)


def test_points_after_the_end_wait_for_the_next_start() -> None:
    drive = loaded([WirePoint(0, 0, 10), WirePoint(5, 0, 0), WirePoint(5, 0, 10), WirePoint(9, 0, 0)])
    drive.start()
    assert positions(drive, [20]) == [5.0]
    assert drive.buffer.free == SIZE - 2
    drive.start()
    assert positions(drive, [40]) == [9.0]
    assert drive.buffer.free == SIZE


def test_a_segment_takes_the_point_that_ends_it() -> None:
    drive = loaded(SCURVE)
    free = [drive.buffer.free]
    drive.start()
    for time in (0, 50_000, 100_000, 200_000, 300_000):
        drive.run_until(time)
        free.append(drive.buffer.free)
    assert free == [27, 29, 29, 30, 31, 32]


def test_an_empty_buffer_in_mid_move_is_an_underflow_and_brakes() -> None:
    drive = loaded([WirePoint(0, 0, 100), WirePoint(500, 100_000, 100)])
    drive.abort_deceleration = 50_000.0
    drive.start()
    drive.run_until(100_000)
    assert drive.state == STOPPING
    assert drive.buffer.errors == UNDERFLOW
    drive.run_until(1_000_000)
    # 10 000 counts/s at 50 000 counts/s2: 0.2 s and 1000 counts
    assert drive.position == pytest.approx(1500.0)
    assert drive.state == IDLE
    assert drive.starts[-1] == pytest.approx(0.3)
    assert events(drive)[-1] == "underflow at 500: the next point was not in the buffer in time"


@pytest.mark.parametrize(
    ("seconds", "microseconds"),
    [(0.0, 1), (1e-7, 1), (1e-6, 1), (0.05, 50_000), (0.0500004, 50_001), (inf, None)],
)
def test_a_motion_ends_at_the_first_microsecond_after_it(seconds: float, microseconds: int | None) -> None:
    drive = Drive()
    drive.follow(hold(0.0), seconds, drive.rest)
    assert drive.next_boundary == microseconds


def test_a_stop_takes_at_least_a_microsecond() -> None:
    """From 0.1 counts/s at 1 000 000 counts/s² it takes 0.1 µs."""
    drive = loaded([WirePoint(0, 1, 100), WirePoint(0, 1, 0)])
    drive.start()
    drive.stop()
    assert (drive.state, drive.next_boundary) == (STOPPING, 1)


def test_a_stop_at_rest_ends_the_move() -> None:
    """The S-curve begins at rest, so there is nothing to brake."""
    drive = loaded(SCURVE)
    drive.start()
    drive.stop()
    assert (drive.state, drive.next_boundary) == (IDLE, None)
    assert events(drive) == ["move started at 0", "move ended at 0: stopped by the master"]


def test_a_drive_forgets_all_but_its_last_profiles_and_events() -> None:
    """The S-curve has four segments between two standstills, and two events."""
    drive = loaded(SCURVE)
    drive.start()
    drive.run_until(500_000)
    for most, profiles, logged in ((9, 6, 2), (6, 6, 2), (3, 3, 2), (1, 1, 1)):
        drive.forget(most)
        assert (len(drive.starts), len(drive.profiles), len(drive.log)) == (profiles, profiles, logged)
        assert drive.position == 1000.0
    assert (drive.starts, events(drive)) == ([0.4], ["move ended at 1000"])


def test_a_long_stop_ends_at_its_time_to_the_microsecond() -> None:
    """10 000 counts/s at 5000 counts/s² take 2 s, from 0.1 s on."""
    drive = loaded([WirePoint(0, 0, 100), WirePoint(500, 100_000, 100)])
    drive.abort_deceleration = 5_000.0
    drive.start()
    drive.run_until(3_000_000)
    assert drive.starts[-1] == pytest.approx(2.1, rel=0.0, abs=1e-7)


def test_a_start_without_points_is_an_underflow() -> None:
    drive = Drive(7.0)
    drive.start()
    assert (drive.buffer.errors, drive.position, drive.state) == (UNDERFLOW, 7.0, IDLE)


def test_a_full_buffer_drops_the_point_and_latches_an_overflow() -> None:
    drive = loaded([WirePoint(n, 0, 1) for n in range(SIZE)])
    assert drive.buffer.free == 0
    assert not drive.add(WirePoint(99, 0, 1))
    assert drive.buffer.errors == OVERFLOW
    assert drive.buffer.next_number == SIZE
    drive.clear_errors(OVERFLOW)
    assert drive.buffer.errors == 0


def test_pop_takes_the_newest_points() -> None:
    drive = loaded(SCURVE)
    drive.pop(2)
    assert [entry.position for entry in drive.buffer.entries] == [0, 83, 500]
    drive.pop(200)
    assert drive.buffer.free == SIZE


def test_clear_aborts_the_move() -> None:
    drive = loaded(SCURVE)
    drive.start()
    drive.run_until(200_000)
    drive.clear()
    assert (drive.state, drive.buffer.free) == (STOPPING, SIZE)
    drive.run_until(1_000_000)
    assert drive.position == pytest.approx(500 + 5000.0**2 / 2 / 1e6)
    assert "move aborted at 500: the buffer was cleared" in events(drive)


def test_a_second_stop_does_not_cut_the_first_one_short() -> None:
    """From 5000 counts/s at 1 000 000 counts/s² the stop takes 5 ms and 12.5 counts."""
    drive = loaded(SCURVE)
    drive.start()
    drive.run_until(200_000)
    drive.stop()
    drive.run_until(202_000)
    drive.stop()
    assert drive.state == STOPPING
    drive.run_until(300_000)
    assert drive.position == pytest.approx(512.5)
    assert drive.state == IDLE


def test_a_second_start_in_mid_move_changes_nothing() -> None:
    drive = loaded(SCURVE)
    drive.start()
    drive.run_until(150_000)
    drive.start()
    assert positions(drive, [400]) == [1000.0]


def test_an_initial_position_takes_an_entry_but_no_time() -> None:
    drive = Drive(9_000_000.0)
    drive.add_entry(BufferedPoint(9_000_000, None, 0, initial=True))
    drive.add(WirePoint(0, 0, 10, relative=True))
    drive.add(WirePoint(7, 0, 0, relative=True))
    drive.start()
    assert positions(drive, [10]) == [9_000_007.0]


class TestSubMode0:
    """Linear; starts after three new points; adjusts its times by one servo period."""

    def steering(self) -> Drive:
        drive = Drive()
        drive.steering = True
        return drive

    def test_it_forgets_earlier_points_and_waits_for_three(self) -> None:
        drive = self.steering()
        drive.add_entry(BufferedPoint(99, None, 10_000))
        drive.start()
        assert (drive.state, drive.buffer.free) == (WAITING, SIZE)
        for position, state in ((0, WAITING), (10, WAITING), (20, MOVING)):
            drive.add_entry(BufferedPoint(position, None, 10_000))
            assert drive.state == state
        assert drive.position == 0.0

    def test_a_stop_ends_the_waiting(self) -> None:
        drive = self.steering()
        drive.start()
        drive.stop()
        assert drive.state == IDLE
        for position in (0, 10, 20, 30):
            drive.add_entry(BufferedPoint(position, None, 10_000))
        assert (drive.state, drive.position) == (IDLE, 0.0)

    @pytest.mark.parametrize(("waiting", "span"), [(2, 10_250), (3, 10_000), (4, 9_750), (20, 9_750)])
    def test_a_segment_is_steered_by_the_points_left(self, waiting: int, span: int) -> None:
        drive = self.steering()
        for position in range(waiting + 2):
            drive.buffer.add(BufferedPoint(position, None, 10_000))
        drive._begin()
        assert drive.next_boundary == span

    def test_the_buffer_settles_at_three_however_the_clocks_differ(self) -> None:
        for period in (9_900, 10_000, 10_100):
            drive = self.steering()
            drive.start()
            levels = []
            for n in range(400):
                drive.add_entry(BufferedPoint(n * 10, None, 10_000))
                drive.run_until((n + 1) * period)
                levels.append(len(drive.buffer.entries))
            assert drive.buffer.errors == 0
            assert set(levels[200:]) <= {2, 3, 4}

    def test_without_steering_the_same_clocks_run_dry(self) -> None:
        drive = Drive()
        for n in range(4):
            drive.add_entry(BufferedPoint(n * 10, None, 10_000))
        drive.start()
        for n in range(4, 600):
            drive.run_until((n - 3) * 10_100)
            drive.add_entry(BufferedPoint(n * 10, None, 10_000))
        assert drive.buffer.errors & UNDERFLOW
