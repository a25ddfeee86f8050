"""Checks of slaves, of tables and of references, each figure by hand."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from motionlang.commands.prove.checker import Proof
from motionlang.commands.prove.followers import _check_table, _moments, check_reference, check_tie
from motionlang.commands.prove.order import Order, Tie
from motionlang.kernel.planners import Profile, from_curve, hold, plan_stop, plan_trapezoid, plan_velocity
from motionlang.kernel.planners.table_motion import table_curve
from tests.cases import cases

MASTER: Any = None


def track(starts: list[float], profiles: list[Profile]) -> Any:
    return SimpleNamespace(
        index=0,
        starts=starts,
        profiles=profiles,
        index_at=lambda time: max((k for k, start in enumerate(starts) if start <= time), default=0),
    )


def jog(start: float, v0: float, v1: float, rate: float = 20.0) -> Profile:
    return plan_velocity("trapezoid", start, v0, v1, rate, rate)


def messages(proof: Proof) -> list[str]:
    return [each.message.removeprefix("axis 0 ") for each in proof.violations]


def tied(tie: Tie, slave: Any, master: Any, i: int = 0, end: float = 4.0, **fields: Any) -> list[str]:
    """Return the violations of a slave."""
    order = Order("FOLLOW", 3, rates=fields.get("rates", (20.0, 20.0)), tie=tie)
    expected = SimpleNamespace(of={0: [*fields.get("before", []), order]})
    offsets: dict[int, Any] = {0: fields["offset"]} if "offset" in fields else {}
    run: Any = SimpleNamespace(track=lambda _: master, expected_motion=expected, offsets=offsets)
    proof = Proof()
    check_tie(proof, run, slave, i, order, end)
    return messages(proof)


# The master is at 10 counts/s, and the slave at 5.
STEADY, HALF = track([0.0], [jog(0.0, 10.0, 10.0)]), track([0.0], [jog(3.0, 5.0, 5.0)])
RATIOS: list[tuple[float, float, list[str]]] = [
    (0.5, 4.0, []),
    # From 0.2 s on, by 0.01 of its 12 counts.
    (0.51, 4.0, ["from 0.000000 s: at 1.400000 s it is at 10, its master requires 10.12"]),
    (-0.5, 4.0, ["from 0.000000 s: at 1.400000 s it is at 10, its master requires -2"]),
    # At 3.8 s it is at 22, and 36 counts of the master are a millionth of that.
    (0.500_000_6, 4.0, []),
    (0.500_000_63, 4.0, ["from 0.000000 s: at 3.800000 s it is at 22, its master requires 22"]),
    # At 0.095 s it is at 3.475, and 0.9 counts of the master are a millionth of that.
    (0.500_003_7, 0.1, []),
    (0.500_004, 0.1, ["from 0.000000 s: at 0.095000 s it is at 3.475, its master requires 3.475"]),
]


@cases("ratio, end, expected", RATIOS)
def test_a_slave_moves_by_its_ratio(ratio: float, end: float, expected: list[str]) -> None:
    assert tied(Tie(MASTER, ratio, locked=0.0), HALF, STEADY, end=end) == expected


def test_a_position_late_in_a_run_is_as_exact_as_its_time() -> None:
    """Eight roundings of 1e9 s, 0.8 µs, at 5000 counts/s are 4 mcounts.

    A millionth of 5000 counts is 5 mcounts, so that a jump by 8 is rounding, and one by 10 is not.
    """
    master = track([1e9], [jog(0.0, 10.0, 10.0)])
    for jump, count in ((0.008, 0), (0.01, 1)):
        pieces = tuple((start, 5000.0, 0.0, 0.0, 0.0, 0.0, 0.0) for start in (0.0, 5000.0 + jump))
        curve = (0.0, 1.0, 4.0), pieces, (("slew", 0), ("slew", 1))
        slave = track([1e9], [from_curve("jog", 0.0, 20000.0, curve, 5000.0, 5000.0)])
        found = tied(Tie(MASTER, 500.0, locked=1e9), slave, master, end=1e9 + 3.0)
        assert len(found) == count, jump


def test_a_position_near_zero_is_exact_to_a_millionth_of_a_count() -> None:
    """Over 0.18 s the master covers 0.018 counts; a ratio of 0.5 is 0.009 of them."""
    slave, master = track([0.0], [jog(0.0, 0.05, 0.05)]), track([0.0], [jog(0.0, 0.1, 0.1)])
    assert tied(Tie(MASTER, 0.500_05, locked=0.0), slave, master, end=0.2) == []
    assert len(tied(Tie(MASTER, 0.500_06, locked=0.0), slave, master, end=0.2)) == 1


def test_an_offset_does_not_count() -> None:
    """The slave is at rest while an offset moves it by 5 counts/s."""
    offset = SimpleNamespace(travelled=lambda time: 5.0 * time, is_active_at=lambda _: True)
    still = track([0.0], [hold(0.0)])
    assert tied(Tie(MASTER, 0.0, locked=0.0), HALF, still, offset=offset) == []
    assert tied(Tie(MASTER, 0.5, locked=0.0), HALF, still, offset=offset) == []
    assert len(tied(Tie(MASTER, 0.5, locked=0.0), HALF, STEADY, offset=offset)) == 1
    # Its acceleration is not its own then.
    assert tied(RAMPED, CHASING, STEADY, rates=(9.0, 9.0), end=0.25, offset=offset) == []


# The slave reaches 5 counts/s after 0.25 s, at 20 counts/s²; or slows down to it from 10.
RAMPED = Tie(MASTER, 0.5, locked=0.25, ramp=True)
CHASING, EASING = track([0.0], [jog(0.0, 0.0, 5.0)]), track([0.0], [jog(0.0, 10.0, 5.0)])
SLOW = "at 0.012500 s: its rate while ramping to its ratio is 20 counts/s², commanded {}"
HARD = "from 0.000000 s: the rate of a slave reaches 20 counts, above {}"
RATES: list[tuple[Any, tuple[float, float], list[str]]] = [
    (CHASING, (20.0, 9.0), []),
    (CHASING, (20.000_019, 9.0), []),
    (CHASING, (20.000_021, 9.0), [SLOW.format(20)]),
    (CHASING, (25.0, 9.0), [SLOW.format(25)]),
    (CHASING, (15.0, 9.0), [HARD.format(15)]),
    (EASING, (9.0, 20.0), []),
    (EASING, (9.0, 25.0), [SLOW.format(25)]),
    (EASING, (9.0, 15.0), [HARD.format(15)]),
    (HALF, (20.0, 25.0), ["at 0.012500 s: its rate while ramping to its ratio is 0 counts/s², commanded 25"]),
]


@cases("slave, rates, expected", RATES)
def test_a_slave_changes_to_its_ratio_at_its_rates(
    slave: Any, rates: tuple[float, float], expected: list[str]
) -> None:
    assert tied(RAMPED, slave, STEADY, rates=rates) == expected


AT_ONCE = "from 1.000000 s: it ramps to its ratio, commanded to engage at once"
# The previous order, if a ramp is commanded, and the violations.
ENGAGED: list[tuple[Order, bool, list[str]]] = [
    (Order("rest", 0), False, [AT_ONCE]),
    (Order("rest", 0), True, []),
    (Order("stop", 2), False, []),
    (Order("FOLLOW", 2, tie=Tie(MASTER, 0.5)), False, []),
    (Order("FOLLOW", 2, tie=Tie(MASTER, 0.4)), False, [AT_ONCE]),
]


@cases("before, ramp, expected", ENGAGED)
def test_a_slave_engages_at_once_or_by_a_ramp(before: Order, ramp: bool, expected: list[str]) -> None:
    slave = track([0.0, 1.0], [hold(0.0), jog(0.0, 0.0, 5.0)])
    assert tied(Tie(MASTER, 0.5, locked=1.25, ramp=ramp), slave, STEADY, 1, before=[before]) == expected


def test_a_slave_on_a_curve_follows_it_from_its_origin_in_its_direction() -> None:
    """20 counts of the curve over 40 of the master are 5 counts/s."""
    table = (0.0, 40.0), (0.0, 20.0), "linear"
    curve = table_curve(*table[:2])
    tie = Tie(MASTER, curve=curve, table=table)
    assert tied(tie, HALF, STEADY) == []
    back = track([0.0], [jog(40.0, -10.0, -10.0)])
    assert tied(tie._replace(origin=40.0, direction=-1), HALF, back) == []
    assert len(tied(tie._replace(direction=-1), HALF, STEADY)) == 1
    # A bend in the curve at 20 of the master is at 2 s; with another origin it is earlier.
    bent = (0.0, 20.0, 40.0), (0.0, 10.0, 30.0), "linear"
    slave = track([0.0, 2.0], [jog(3.0, 5.0, 5.0), jog(13.0, 10.0, 10.0)])
    tie = Tie(MASTER, curve=table_curve(*bent[:2]), table=bent)
    assert tied(tie, slave, STEADY) == []
    assert tied(tie._replace(origin=-10.0), slave, STEADY) == [
        "from 0.000000 s: at 1.300000 s it is at 9.5, its master requires 11"
    ]


def test_times_at_which_master_and_slave_are_compared() -> None:
    """The ends of all pieces, and four times within each of the first 24."""
    master = track([0.0, 1.0], [jog(0.0, 10.0, 10.0), plan_trapezoid(10.0, 20.0, 10.0, 10.0, 10.0, 10.0)])
    found = _moments(track([0.5], [hold(0.0)]), master, 0.5, 1.5)
    inside = [start + share * 0.5 for start in (0.5, 1.0) for share in (0.05, 0.35, 0.65, 0.95)]
    assert [round(each, 9) for each in found] == sorted([1.0, 1.5, *(round(each, 9) for each in inside)])
    many = track([float(k) for k in range(40)], [hold(0.0)] * 40)
    assert len(_moments(many, track([0.0], [hold(0.0)]), 0.0, 40.0)) == 40 + 4 * 24


# ------------------------------------------------------------------------------------------ tables


def table(
    kind: str, positions: tuple[float, ...], values: tuple[float, ...], curve: Profile, **fields: Any
) -> list[str]:
    tie = Tie(MASTER, curve=curve, origin=fields.get("origin", 0.0), table=(positions, values, kind))
    order, i = Order("CAM", 3, tie=tie), len(fields.get("before", []))
    run: Any = SimpleNamespace(expected_motion=SimpleNamespace(of={0: [*fields.get("before", []), order]}))
    proof = Proof()
    _check_table(proof, run, track([0.0] * (i + 1), [hold(0.0)] * (i + 1)), i, order, curve)
    return [each.removeprefix("from 0.000000 s: ") for each in messages(proof)]


def line(
    width: float, start: float, slope: float, end_slope: float | None = None, **fields: float
) -> Profile:
    """Return a curve of one piece, with its slopes at both ends as stated."""
    bend = fields.get("bend", 0.0)
    end = start + slope * width + bend * width**3
    last = slope + 3.0 * bend * width**2 if end_slope is None else end_slope
    curve = (0.0, width), ((start, slope, 0.0, bend, 0.0, 0.0, 0.0),), (("segment", 0),)
    return from_curve("table", start, end, curve, fields.get("begin_slope", slope), last)


def stated(curve: Profile, **fields: float) -> Profile:
    for name, value in fields.items():
        setattr(curve, name, value)
    return curve


RISE = (0.0, 10.0), (2.0, 7.0)
TABLES: list[tuple[tuple[tuple[float, ...], tuple[float, ...]], Profile, list[str]]] = [
    (RISE, line(10.0, 2.0, 0.5), []),
    (RISE, line(10.0, 0.0, 0.5), []),  # its start is that of the slave
    (RISE, line(10.0, 2.0, 0.500_000_6), []),
    # A millionth of the largest value, 7, is allowed over its 10.
    (RISE, line(10.0, 2.0, 0.500_000_8), ["its curve has 5.00001 at 10 of its master, commanded 5"]),
    (RISE, line(10.0, 2.0, 0.6), ["its curve has 6 at 10 of its master, commanded 5"]),
    (
        ((0.0, 5.0, 10.0), (2.0, 5.0, 7.0)), line(10.0, 2.0, 0.5),
        ["its curve has 2.5 at 5 of its master, commanded 3"],
    ),
    (RISE, line(8.0, 2.0, 0.5), ["its curve rises by 4, commanded 5", "its curve is 8 long, commanded 10"]),
    (RISE, stated(line(10.0, 2.0, 0.5), end=7.000_006_9), []),
    (RISE, stated(line(10.0, 2.0, 0.5), end=7.000_007_1), ["its curve rises by 5.00001, commanded 5"]),
    (RISE, stated(line(10.0, 2.0, 0.5), start=2.5), ["its curve rises by 4.5, commanded 5"]),
    (RISE, line(10.0, 2.0, 0.5, 0.500_000_6), []),
    (RISE, line(10.0, 2.0, 0.5, 0.500_000_8), ["its curve has a slope of 0.5 at one end, and is run on at 0.500001"]),
    (
        RISE, line(10.0, 2.0, 0.5, begin_slope=0.4),
        ["its curve has a slope of 0.5 at one end, and is run on at 0.4"],
    ),
    # A millionth of a value less than 1 is a millionth of 1.
    (((0.0, 1.0), (0.0, 0.5)), line(1.0, 0.0, 0.500_000_9), []),
    (
        ((0.0, 1.0), (0.0, 0.5)), line(1.0, 0.0, 0.500_001_1),
        ["its curve has 0.500001 at 1 of its master, commanded 0.5"],
    ),
    # Straight between its points: 0.01 x + 0.0049 x³ is 0.6625 in the middle of 10, not 2.5.
    (RISE, line(10.0, 2.0, 0.01, bend=0.0049), ["its curve is not straight from 0 to 10 of its master"]),
]  # fmt: skip


@cases("given, curve, expected", TABLES)
def test_a_curve_passes_through_its_table(given: Any, curve: Profile, expected: list[str]) -> None:
    positions, values = given
    assert table("linear", positions, values, curve) == expected


# A flying shear: 5 of the slave over 10 of the master from rest, and on from a ratio of 1 over 10 to 2.


def even(distance: float, start: float, begins: float, ends: float) -> Profile:
    """Return a curve over 10 of the master whose slope changes linearly."""
    curve = (0.0, 10.0), ((start, begins, 0.05 * (ends - begins), 0.0, 0.0, 0.0, 0.0),), (("segment", 0),)
    return from_curve("table", start, start + distance, curve, begins, ends)


def fly(curve: Profile, distance: float, **fields: Any) -> Order:
    tie = Tie(MASTER, curve=curve, table=((0.0, 10.0), (0.0, distance), fields.pop("kind", "even")), **fields)
    return Order("FLY", 2, tie=tie)


FASTER = even(5.0, 0.0, 0.0, 1.0)
BEGINS = "its segment begins at a ratio of {}, expected {}"
# The previous order, the slopes at the ends of the segment, its distance, and the violations.
SEGMENTS: dict[str, tuple[list[Order], tuple[float, float, float], dict[str, Any], list[str]]] = {
    "from rest": ([], (5.0, 0.0, 1.0), {}, []),
    "from a ratio it never had": ([], (10.0, 1.0, 1.0), {}, [BEGINS.format(1, 0)]),
    "after a move": ([Order("move", 1)], (10.0, 1.0, 1.0), {}, [BEGINS.format(1, 0)]),
    "after a ratio": ([Order("FOLLOW", 1, tie=Tie(MASTER, 1.0))], (10.0, 1.0, 1.0), {}, [BEGINS.format(1, 0)]),
    "after another segment": ([fly(FASTER, 5.0)], (10.0, 1.0, 1.0), {}, []),
    "slower than before": ([fly(FASTER, 5.0)], (9.5, 0.9, 1.0), {}, [BEGINS.format(0.9, 1)]),
    "by rounding": ([fly(FASTER, 5.0)], (10.0, 1.000_000_9, 0.999_999_1), {}, []),
    "of another direction": ([fly(FASTER, 5.0, direction=-1)], (10.0, 1.0, 1.0), {}, [BEGINS.format(1, 0)]),
    "after a table": ([fly(FASTER, 5.0, kind="cubic")], (10.0, 1.0, 1.0), {}, [BEGINS.format(1, 0)]),
    "the same segment again": ([fly(even(5.0, 0.0, 1.0, 0.0), 5.0)], (5.0, 1.0, 0.0), {}, []),
    "the same segment at a new zero": (
        [fly(even(5.0, 0.0, 1.0, 0.0), 5.0)], (5.0, 1.0, 0.0), {"origin": 4.0}, [],
    ),
    "an equal segment after the first": (
        [fly(even(5.0, 7.0, 1.0, 0.0), 5.0)], (5.0, 1.0, 0.0), {"origin": 4.0}, [BEGINS.format(1, 0)],
    ),
}  # fmt: skip


@cases("name", SEGMENTS)
def test_a_segment_begins_at_the_ratio_of_the_one_before(name: str) -> None:
    before, (distance, begins, ends), fields, expected = SEGMENTS[name]
    curve = even(distance, 0.0, begins, ends)
    assert table("even", (0.0, 10.0), (0.0, distance), curve, before=before, **fields) == expected


def test_the_ratio_of_a_segment_changes_linearly() -> None:
    """A cubic begins at the right ratio, but bends."""
    assert table("even", (0.0, 10.0), (0.0, 5.0), line(10.0, 0.0, 0.0, bend=0.005)) == [BEGINS.format(0, 0)]


# --------------------------------------------------------------------------------------- references


def referred(profile: Profile, order: Order) -> list[str]:
    """Return the violations of a reference that begins after 1 s at rest, or at any velocity."""
    proof = Proof()
    check_reference(proof, track([0.0, 1.0], [hold(0.0), profile]), 1, order)
    return [each.removeprefix("from 1.000000 s: ") for each in messages(proof)]


TO = Order("reference", 3, goal=50.0)
POSITIONS: list[tuple[float, float, list[str]]] = [
    (50.0, 50.0, []),
    (50.0, 50.000_049, []),
    (50.0, 50.000_051, ["it ends at 50, commanded 50.0001"]),
    (0.5, 0.500_000_9, []),
    (0.5, 0.500_001_1, ["it ends at 0.5, commanded 0.500001"]),
    (-50.0, 50.0, ["it ends at -50, commanded 50"]),
]


@cases("end, goal, expected", POSITIONS)
def test_a_position_reference_ends_there(end: float, goal: float, expected: list[str]) -> None:
    assert referred(plan_trapezoid(0.0, end, 10.0, 20.0, 20.0), TO._replace(goal=goal)) == expected


# 20 counts/s at 100 counts/s² up, and at 50 down.
UP, DOWN = (100.0, 0.0, 0.0), (50.0, 0.0, 0.0)
SPEED = Order("reference", 3, 20.0, (100.0, 50.0), goal=20.0, slopes=(UP, DOWN))


def ramp(v0: float, v1: float, up: float = 100.0, down: float = 50.0) -> Profile:
    return plan_velocity("trapezoid", 0.0, v0, v1, up, down)


SAMPLED: Any = SimpleNamespace(pieced=False)
SPEEDS: dict[str, tuple[Profile, Order, list[str]]] = {
    "up": (ramp(0.0, 20.0), SPEED, []),
    "down": (ramp(20.0, 5.0), SPEED._replace(goal=5.0), []),
    "to rest": (plan_stop("trapezoid", 0.0, 20.0, 50.0), SPEED._replace(goal=0.0), []),
    "reversed": (ramp(20.0, -20.0), SPEED._replace(goal=-20.0), []),
    "too slowly": (ramp(0.0, 20.0, 80.0), SPEED, []),
    "too fast": (
        ramp(0.0, 20.0, 125.0), SPEED,
        ["the rate of a reference reaches 125 counts, above 100"],
    ),
    "down too fast": (
        plan_stop("trapezoid", 0.0, 20.0, 100.0), SPEED._replace(goal=0.0),
        ["the rate of a reference reaches 100 counts, above 50"],
    ),
    "above its speed": (
        ramp(0.0, 25.0), SPEED._replace(goal=25.0), ["the speed reaches 25 counts, above 20"],
    ),
    "from a higher speed": (ramp(30.0, 20.0), SPEED, []),
    "to another speed": (
        ramp(0.0, 18.0), SPEED, ["it reaches 18 counts/s, commanded 20"],
    ),
    "never to rest": (
        ramp(20.0, 1e-9), SPEED._replace(goal=0.0), ["it never reaches its end"],
    ),
    "by rounding": (ramp(0.0, 20.0, 99.99995), SPEED, []),
    "sampled": (SAMPLED, SPEED, []),
}  # fmt: skip


@cases("name", SPEEDS)
def test_a_speed_reference_is_reached_by_its_slopes(name: str) -> None:
    profile, order, expected = SPEEDS[name]
    assert referred(profile, order) == expected
