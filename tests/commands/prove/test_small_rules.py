"""Small rules of the proof with figures, each covered by this test alone."""

from __future__ import annotations

from math import acos, inf, nextafter, pi
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from motionlang.commands.prove.axes import _check_knots
from motionlang.commands.prove.checker import Proof, position
from motionlang.commands.prove.followers import FOUR, _check_table, _moments, _wanted
from motionlang.commands.prove.order import Order, PathOrder, Tie
from motionlang.commands.prove.outputs import check_trace
from motionlang.commands.prove.path_bounds import spans_along
from motionlang.commands.prove.path_layout import PathLayout
from motionlang.commands.prove.segments import Span, _from
from motionlang.kernel import Source, WholeTrack, run
from motionlang.kernel.planners import hold, plan_trapezoid
from motionlang.kernel.planners.sequence import chained
from motionlang.kernel.planners.table_motion import table_curve
from motionlang.kernel.tracks import Column, servo_traces
from motionlang.kernel.tracks.history import MoveFigures
from tests.kernel.controller.machines import machine, until
from tests.kernel.planners.splines import cubic_table

FREE = (inf, inf)


def test_a_slave_is_checked_where_a_piece_ends_and_within_each() -> None:
    c = machine(1)
    c.move_to(0, 20.0)
    track = WholeTrack(until(c, 1.0).axes[0])
    inside = [0.1 * share for share in FOUR] + [0.1 + 0.9 * share for share in FOUR]
    assert _moments(track, track, 0.0, 1.0) == pytest.approx(sorted([0.1, 1.0, *inside]))
    assert all(0.0 < share < 1.0 for share in FOUR)


def test_a_position_between_two_of_a_table_is_on_the_line_between_them() -> None:
    master: Any = None
    tie = Tie(master, table=((0.0, 2.0, 4.0), (0.0, 8.0, 10.0), "linear"))
    assert [_wanted(tie, hold(0.0), along) for along in (1.0, 2.0, 3.0)] == [4.0, 8.0, 9.0]


@pytest.mark.parametrize(
    ("make", "message"), [(table_curve, ""), (cubic_table, "is not straight from 0 to 2 of its master")]
)
def test_a_curve_is_straight_between_the_points_of_its_table(make: Any, message: str) -> None:
    positions, values = (0.0, 2.0, 4.0), (3.0, 8.0, 10.0)
    some: Any = SimpleNamespace(index=1, starts=[0.0])
    proof, order = Proof(), Order("CurveFollow", 1, tie=Tie(some, table=(positions, values, "linear")))
    _check_table(proof, some, some, 0, order, make(positions, values))
    assert [message in each.message for each in proof.violations] == [True] * bool(message)


def test_just_at_a_new_zero_a_track_is_where_it_came_from_for_what_ends_there() -> None:
    """The end of a move, a sum of two times, may be one rounding after the new zero."""
    c = machine(1)
    until(c, 1000.0).define_position(0, 7.0)
    track = WholeTrack(until(c, 1001.0).axes[0])
    for time in (1000.0, nextafter(1000.0, inf)):
        assert (position(track, time), position(track, time, ending=True)) == (7.0, 0.0)
    assert position(track, 1000.1, ending=True) == 7.0


@pytest.mark.parametrize(
    ("row", "value", "message"),
    [
        (0, 0.5, ""),
        (0, 0.5 + 5e-10, ""),
        (0, 0.6, "axis 0 at 0.250000 s: the trace has it at 2.4, the track at 2"),
        (0, -0.5, "axis 0 at 0.250000 s: the trace has it at -2, the track at 2"),
        (1, 1.0, ""),  # just before the new zero: 4 counts
        (1, 12.5, ""),  # just after it
        (1, 9.0, "axis 0 at 1.000000 s: the trace has it at 36, the track at 50"),
        (2, 12.5, ""),
        (2, 1.0, "axis 0 at 2.000000 s: the trace has it at 4, the track at 50"),
    ],
)
def test_a_row_of_a_trace_at_a_new_zero_may_be_before_or_after_it(
    row: int, value: float, message: str
) -> None:
    """A unit has 4 counts, and position 0 is at 8 counts.

    A move of 4 counts at 10/s and 100/s² takes 0.5 s, and is at 2 after half of it.
    At 1 s the program sets the position to 50. The other rows are right; velocities are not compared.
    """
    c = machine(1)
    c.axes[0].scale.set(4.0, zero=8.0)
    c.move_to(0, 4.0)
    until(c, 1.0).define_position(0, 50.0)
    until(c, 3.0)
    values = [0.5 - 2.0, 12.5 - 2.0, 12.5 - 2.0]
    values[row] = value - 2.0
    column = Column("axis0_position_uu", "position", "uu", 0)
    time = Column("time_s", "time", "s", None)
    times = np.array([0.25, 1.0, 2.0])
    run_of: Any = SimpleNamespace(axes=[WholeTrack(c.axes[0])])
    speed = Column("axis0_velocity_uu_s", "velocity", "uu/s", 0)
    data = times, np.full(3, 1e9), np.array(values)
    samples: Any = SimpleNamespace(columns=(time, speed, column), data=data, time=times)
    proof = Proof()
    check_trace(proof, run_of, samples)
    assert [each.message for each in proof.violations] == [message] * bool(message)


@pytest.mark.parametrize(("gap", "count"), [(0.01, 0), (0.02, 1)])
def test_at_a_high_speed_late_in_a_run_a_position_is_as_exact_as_its_time(gap: float, count: int) -> None:
    """Four roundings of 10⁶ s are 1.6 ns, at 10⁷ counts/s 0.016 counts."""
    fast = Span(0.0, 1.0, (0.0, 1e7, 0.0, 0.0, 0.0, 0.0, 0.0))
    other = Span(1.0, 1.0, (1e7 + gap, 1e7, 0.0, 0.0, 0.0, 0.0, 0.0))
    some: Any = SimpleNamespace(index=0, starts=[1e6], profiles=[hold(0.0)])
    proof = Proof()
    _check_knots(proof, some, 0, Order("jog", 1), [fast, other])
    assert len(proof.violations) == count


def test_a_cubic_piece_is_cut_at_extrema_of_velocity_and_acceleration() -> None:
    """4 + 9 x - 6 x² + x³ has the velocity 9 - 12 x + 3 x², which is 0 at 1 and 3.

    The acceleration 6 x - 12 is 0 at 2.
    """
    span = Span(0.0, 4.0, (4.0, 9.0, -6.0, 1.0, 0.0, 0.0, 0.0))
    assert span.cuts() == pytest.approx([0.0, 1.0, 2.0, 3.0, 4.0])
    assert (span.peak(1), span.peak(2), span.peak(3)) == (9.0, 12.0, 6.0)


def test_the_distance_along_a_line_that_counts_as_longer_than_it_is() -> None:
    path = PathOrder(
        (0, 1), (1.0, 1.0), 0.0, 0, True, (30.0, 40.0), (0.0, 0.0), 0.0, (), (0, 1), 100.0, FREE, FREE, FREE, 0.0
    )  # fmt: skip
    half = plan_trapezoid(0.0, 15.0, 30.0, 60.0, 60.0)
    whole = chained(half, half.shifted(15.0))
    rows = [(whole, 0.0), (whole.scaled(0.0, 4.0 / 3.0), 0.0)]
    found = spans_along(rows, PathLayout(path, [0.0, 0.0]), whole.duration)
    assert found[-1].begin + found[-1].length == pytest.approx(whole.duration)
    assert [found[0].at(0.0)[0], found[-1].at(found[-1].length)[0]] == pytest.approx([0.0, 100.0])


def test_a_piece_counted_from_elsewhere_is_the_same_piece() -> None:
    piece = (1.0, 2.0, 3.0, 4.0, 0.0, 0.0, 0.0)
    assert _from(piece, 2.0) == (1.0 + 4.0 + 12.0 + 32.0, 2.0 + 12.0 + 48.0, 3.0 + 24.0, 4.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize(("error", "settled"), [([0.0, 5.0, 5.0, 5.0], None), ([0.0, 5.0, 5.0, 0.0], 0.3)])
def test_a_motor_that_is_outside_its_window_at_last_has_not_settled(
    error: list[float], settled: float | None
) -> None:
    made: Any = SimpleNamespace(
        loop=SimpleNamespace(servo_rate=10.0, period=0.1),
        error=np.array(error), output=np.zeros(4), torque=np.zeros(4),
    )  # fmt: skip
    figures = MoveFigures(0.0, 0.0, 9.0)
    figures.take(0.0, made, 1.0)
    assert figures.settle_time == (settled if settled is None else pytest.approx(settled))


def test_an_axis_with_a_motor_has_a_trace_of_it() -> None:
    made = run(
        Source("a.mnt", "MOVER(0) = 10 : GO(0) : PAUSE IDLE(0)"),
        machine={"axis.0.plant.inertia": 2e-4},
    )
    assert list(servo_traces(made.controller)) == [0]


def test_a_wave_on_a_line_turns_where_its_velocity_is_0() -> None:
    """0.5 x + sin 2x has the velocity 0.5 + 2 cos 2x, which is 0 at acos(-1/4)/2.

    The acceleration is 0 at pi/2, as is sin 2x.
    """
    cuts = Span(0.0, 2.0, (0.0, 0.5, 0.0, 0.0, 1.0, 2.0, 0.0)).cuts()
    assert any(cut == pytest.approx(acos(-0.25) / 2.0) for cut in cuts)
    assert any(cut == pytest.approx(pi / 2.0) for cut in cuts)
    assert (cuts[0], cuts[-1]) == (0.0, 2.0)
