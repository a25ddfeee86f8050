"""Extremes with their times, columns of a trace on request, and tracks, by hand."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from motionlang.commands.certify.extremes import extremes, motor_peak, peak_speed
from motionlang.kernel import Controller, Trace
from motionlang.kernel.planners import pieces_of
from motionlang.kernel.tracks import axes_of, quantity_of
from tests.kernel.tracks.test_trace import ballscrew


def machine(**settings: float) -> Controller:
    """Return a controller of one axis.

    50 counts/s, 500 counts/s² up, 250 counts/s² down.
    """
    controller = Controller(1)
    for name, value in {"speed": 50.0, "accel": 500.0, "decel": 250.0, **settings}.items():
        controller.configure(0, name, value)
    return controller


@pytest.mark.parametrize(
    ("until", "speed"), [(0.0, 0.0), (0.05, 25.0), (0.1, 50.0), (1.0, 50.0), (9.0, 50.0)]
)
def test_the_peak_speed_up_to_a_time(until: float, speed: float) -> None:
    """After 0.05 s at 500 counts/s² an axis has 25 counts/s."""
    controller = machine()
    controller.move_to(0, 100.0)
    controller.clock.advance(9.0)
    axis = controller.axes[0]
    assert peak_speed(axis, until) == pytest.approx(speed)
    assert extremes(axis, until).speed.value == pytest.approx(speed)


def test_extremes_are_in_user_units() -> None:
    """A scale of -2 counts per unit turns the axis around.

    The highest position is that of the start.
    """
    controller = machine()
    controller.set_scale(0, -2.0)
    controller.move_to(0, 100.0)
    controller.clock.advance(5.0)
    found = extremes(controller.axes[0], 5.0)
    assert (found.lowest.value, found.highest.value) == pytest.approx((-50.0, 0.0))
    assert (found.speed.value, found.acceleration.value) == pytest.approx((25.0, 250.0))
    assert peak_speed(controller.axes[0], 5.0) == pytest.approx(25.0)


def test_a_figure_is_in_the_scale_of_its_time() -> None:
    """One unit is two counts, then half of one, in the middle of a hold after 100 counts at 50."""
    controller = machine()
    controller.set_scale(0, 2.0)
    controller.move_to(0, 100.0)
    controller.clock.advance(5.0)
    controller.set_scale(0, 0.5)
    found = extremes(controller.axes[0], 6.0)
    assert (found.highest.value, found.highest.time) == pytest.approx((200.0, 5.0))
    assert (found.speed.value, peak_speed(controller.axes[0], 6.0)) == pytest.approx((25.0, 25.0))


def test_a_speed_is_in_the_scales_before_and_after_its_time() -> None:
    """25 counts/s in units of one count at 0.05 s, and 50 counts/s in those of two from 1 s on."""
    controller = machine()
    controller.move_to(0, 100.0)
    for time, counts in ((0.05, 4.0), (1.0, 2.0), (3.0, 0.5)):
        controller.clock.advance(time)
        controller.set_scale(0, counts)
    assert extremes(controller.axes[0], 4.0).speed.value == pytest.approx(25.0)


def test_an_s_curve_has_its_peaks_inside_its_ramps() -> None:
    """A sinusoidal ramp to v at a mean rate A has the peak π/2·A in its middle.

    Its jerk is π²/2·A²/v at its ends.
    """
    controller = Controller(1)
    for name, value in (("speed", 50.0), ("accel", 500.0), ("decel", 500.0)):
        controller.configure(0, name, value)
    controller.configure(0, "shape", "sinusoidal")
    controller.move_to(0, 100.0)
    controller.clock.advance(5.0)
    found = extremes(controller.axes[0], 5.0)
    assert found.speed.value == pytest.approx(50.0)
    ramp = controller.axes[0].profiles[1].knots[1]
    mean = 50.0 / ramp
    assert found.acceleration.value == pytest.approx(pi / 2.0 * mean)
    assert found.acceleration.time == pytest.approx(ramp / 2.0)
    assert found.jerk.value == pytest.approx(pi**2 / 2.0 * mean / ramp)


def test_a_motor_that_is_not_simulated_has_no_peak() -> None:
    assert motor_peak(machine().axes[0], 1.0, "torque") is None


def test_columns_by_name_and_axis() -> None:
    trace = Trace(ballscrew())
    rows = trace(10.0, axes=[0], quantities=["position", "jerk"])
    assert rows.dtype.names == ("time_s", "axis0_position_uu", "axis0_jerk_uu_per_s3")
    assert rows["axis0_position_uu"][-1] == pytest.approx(200.0)
    assert len(trace(10.0, until=0.55)) == 7  # six on the grid, and the end
    assert len(trace(10.0)) == trace.rows(10.0) == 11
    assert repr(trace) == "<Trace of axis 0: 0 to 1 s>"
    with pytest.raises(ValueError, match=r"there is no axis 4; this controller has 0, 1, 2, 3"):
        trace(axes=[4])


@pytest.mark.parametrize(
    ("wanted", "names"),
    [
        (["velocity"], ["time_s", "axis0_velocity_uu_per_s"]),
        (["velocity.3", "position"], ["time_s", "axis3_velocity_uu_per_s", "axis0_position_uu"]),
        (["following-error.2"], ["time_s", "axis2_following_error_uu"]),
        ([], ["time_s"]),
    ],
)
def test_chosen_columns(wanted: list[str], names: list[str]) -> None:
    trace = Trace(ballscrew())
    trace.choose(wanted)
    assert [column.name for column in trace.columns()] == names
    assert len(trace.columns(axes=(0,))) == 4
    assert len(trace.columns(quantities=("jerk",))) == 2


@pytest.mark.parametrize(
    ("wanted", "message"),
    [
        ("velocity.4", "'velocity.4': there is no axis 4; this controller has 0, 1, 2, 3"),
        ("velocity.x", "'velocity.x': there is no axis x"),
        (
            "speed",
            "'speed' is not a quantity of an axis; choose from position, velocity, acceleration, jerk, actual",
        ),
    ],
)
def test_a_column_that_does_not_exist(wanted: str, message: str) -> None:
    with pytest.raises(ValueError, match=message.replace(".", r"\.")):
        Trace(ballscrew()).choose([wanted])


def test_a_quantity_and_its_axis() -> None:
    assert quantity_of("velocity") == ("velocity", "")
    assert quantity_of("following-error.12") == ("following error", "12")


def test_values_at_any_times() -> None:
    """In any order, also before the start and after the end; a count is 1/1200 mm."""
    trace = Trace(ballscrew())
    found = trace.at(0, "position", np.array([0.5, 0.0, 2.0, 0.1]))
    assert found.tolist() == pytest.approx([100.0, 0.0, 200.0, 6.25])
    assert trace.at(0, "velocity", np.array([0.05])).tolist() == pytest.approx([62.5])


@pytest.mark.parametrize(("counts", "decimals"), [(1.0, 6), (1200.0, 9), (-1e6, 9), (1e9, 12), (1e15, 12)])
def test_a_thousandth_of_a_count_is_shown(counts: float, decimals: int) -> None:
    controller = Controller(1)
    controller.set_scale(0, counts)
    trace = Trace(controller)
    assert [trace.decimals(column) for column in trace.columns()] == [9, decimals, decimals, decimals]


@pytest.mark.parametrize(
    ("rate", "until", "rows"),
    [(10.0, 0.0, 1), (10.0, 0.1, 2), (10.0, 0.11, 3), (10.0, 0.1 + 1e-12, 2), (3.0, 1.0, 4)],
)
def test_the_number_of_rows(rate: float, until: float, rows: int) -> None:
    """One at 0, one for each step, and one at the end, unless that is on the grid."""
    trace = Trace(Controller(1))
    assert trace.rows(rate, until) == rows
    times = trace.sample(rate, until=until).time
    assert len(times) == rows
    assert times[-1] == until


def test_the_profile_in_force_at_a_time() -> None:
    """A move of 10 from 1 s on takes 0.35 s, as long as that back from 3 s on.

    Each is followed by a standstill.

    50 counts/s need 2.5 and 5 counts of ramps, 2.5 counts at speed take 0.05 s.
    """
    controller = machine()
    controller.clock.advance(1.0)
    controller.move_to(0, 10.0)
    controller.clock.advance(3.0)
    controller.move_to(0, 0.0)
    controller.clock.advance(9.0)
    track = controller.axes[0]
    assert track.starts == pytest.approx([0.0, 1.0, 3.0, 3.35])  # a rest before a move is none of its own
    times = (-1.0, 0.0, 0.99, 1.0, 1.34, 1.36, 2.99, 3.0, 99.0)
    assert [track.index_at(time) for time in times] == [-1, 0, 0, 1, 1, 1, 1, 2, 3]
    assert (track.position(2.9), track.at(2.9).velocity) == pytest.approx((10.0, 0.0))


def test_the_pieces_of_a_track() -> None:
    """Standstill, three pieces of the move, and standstill again.

    The last piece has no end.
    """
    controller = machine()
    controller.clock.advance(1.0)
    controller.move_to(0, 100.0)
    controller.clock.advance(9.0)
    track = controller.axes[0]
    begins, pieces = pieces_of(track.starts, track.profiles)
    assert begins[-4:] == pytest.approx([1.0, 1.1, 2.95, 3.15])
    assert [piece[0] for piece in pieces[-4:]] == pytest.approx([0.0, 2.5, 95.0, 100.0])
    assert [piece[1] for piece in pieces[-4:]] == pytest.approx([0.0, 50.0, 50.0, 0.0])
    assert (begins[0], pieces[0]) == (0.0, (0.0,) * 7)


def test_axes_that_ever_moved() -> None:
    controller = Controller(4, first=1)
    assert axes_of(controller) == (1,)
    controller.move_to(3, 10.0)
    controller.define_position(2, 5.0)
    assert axes_of(controller) == (2, 3)
