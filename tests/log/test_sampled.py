"""Samples of a moving axis are computed when the log is read."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang.log.sampled import SampledRecords, Sampling
from motionlang.log.stream import Store, Stream
from motionlang.planners import Profile, hold, plan
from tests.cases import cases

PERIOD = 1e-3
BEFORE, AFTER = [(0.5, 3, 1.0), (0.501, 3, 2.0)], [(9.0, 3, 7.0)]


def move(end: float = 1000.0, shape: str = "trapezoid") -> Profile:
    """Return a move from 0 that takes 1.1 s over 1000 counts."""
    return plan(shape, 0.0, end, 1000.0, 10_000.0, 10_000.0, 0.0, 0.2)


def sampling(profile: Profile, per_unit: float = 0.5, value: float = 0.0) -> Sampling:
    """Return samples of a profile that begins at 2 s, in user units of 10 counts."""
    return Sampling(3, PERIOD, 2.0, (value, per_unit, 4.0, 25.0, (1.0, 10.0)), profile)


def one_by_one(made: Sampling, numbers: range) -> list[tuple[float, int, float]]:
    return [(number * PERIOD, 3, made.value(number)) for number in numbers]


@cases("shape", ("trapezoid", "scurve", "sinusoidal", "parabolic"))
def test_the_rows_are_those_of_each_tick(shape: str) -> None:
    made, ticks = sampling(move(shape=shape)), range(2000, 3110)
    assert made.rows(ticks) == one_by_one(made, ticks)


def test_a_value_is_that_of_the_position() -> None:
    """At tick 2550 the axis is at 500 counts.

    These are 47.5 uu from the zero at 25 counts, and 43.5 uu from the origin.
    """
    assert sampling(move()).value(2550) == pytest.approx(0.5 * 43.5)


def test_a_value_in_units_of_two_factors() -> None:
    """At tick 2550 the axis is 475 · 3/10 = 142.5 uu from its zero."""
    made = Sampling(3, PERIOD, 2.0, (2.0, 0.5, 4.0, 25.0, (3.0, 10.0)), move())
    assert made.value(2550) == pytest.approx(2.0 + 0.5 * 138.5)
    assert made.rows([2550]) == one_by_one(made, range(2550, 2551))


@cases(
    "profile, per_unit, first, last, is_distinct",
    (
        (move(), 0.5, 2001, 3098, True),
        (move(-1000.0), -0.5, 2001, 3098, True),
        (move(), 0.0, 2001, 3098, False),
        (move(), 1e-12, 2001, 3098, False),
        (move(), 0.5, 2000, 3098, False),
        (move(), 0.5, 2001, 3100, False),
        (move(), 0.5, 1999, 3098, False),
        (move(), 0.5, 2050, 2050, False),
        (hold(5.0), 0.5, 2001, 3098, False),
    ),
)
def test_samples_differ_while_the_axis_moves_in_one_direction(
    profile: Profile, per_unit: float, first: int, last: int, is_distinct: bool
) -> None:
    made = sampling(profile, per_unit, value=5.0)
    assert made.is_distinct(first, last) is is_distinct
    if is_distinct:
        values = [row[2] for row in made.rows(range(first, last + 1))]
        assert len(set(values)) == len(values)


def test_a_rest_between_two_moves_is_found() -> None:
    """The speed is 0 at a knot between the ticks; the axis never reverses."""
    made = sampling(Profile("jog", 0.0, 20.0, 2.0, (0.0, 0.5, 0.0, 20.0, 1.0, 0.0, 0.0, 0.5, 0.0, 20.0)))
    assert made.is_distinct(2001, 2500)
    assert not made.is_distinct(2001, 3900)


def stored() -> tuple[list[Any], Stream[Any]]:
    """Return rows, and a stream that has them in a template between other rows."""
    made = sampling(move())
    stream: Stream[Any] = Stream(Store())
    stream.add((0.1, 3, 5.0))
    stream.add_samples(made.template(BEFORE, AFTER, 2010, 300))
    stream.add((9.9, 3, 6.0))
    return [(0.1, 3, 5.0), *BEFORE, *made.rows(range(2010, 2310)), *AFTER, (9.9, 3, 6.0)], stream


def test_a_stream_reads_a_template_like_other_records() -> None:
    rows, stream = stored()
    assert len(stream) == len(rows)
    assert list(stream) == list(stream.as_stored()) == rows
    assert list(reversed(stream)) == rows[::-1]
    assert [stream[index] for index in range(len(rows))] == rows
    assert [stream[index] for index in range(-len(rows), 0)] == rows


@cases(
    "part",
    (
        slice(None),
        slice(0, 2),
        slice(1, 5),
        slice(2, 302),
        slice(300, 304),
        slice(302, 400),
        slice(7, 7),
        slice(3, 250, 7),
        slice(None, None, -1),
        slice(290, 1, -13),
        slice(1, 40, 3),
        slice(40, 1, -1),
        slice(500, 600),
    ),
)
def test_slices_of_a_template(part: slice) -> None:
    made = sampling(move())
    rows = [*BEFORE, *made.rows(range(2010, 2310)), *AFTER]
    records = SampledRecords(made.template(BEFORE, AFTER, 2010, 300), list)
    assert list(records[part]) == rows[part]


def test_a_template_without_rows_around_it_in_several_batches() -> None:
    made, ticks = sampling(move(shape="scurve")), range(2000, 5000)
    records = SampledRecords(made.template([], [], 2000, 3000), list)
    assert list(records) == one_by_one(made, ticks)
    assert list(reversed(records)) == one_by_one(made, ticks)[::-1]
