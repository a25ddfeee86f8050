"""The ends and the pieces of a profile: how far they may differ, by hand."""

from __future__ import annotations

from math import inf
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.prove.axes import (
    _check_edges,
    _check_knots,
    _completes_trapezoid,
)
from motionlang.commands.prove.checker import Proof
from motionlang.commands.prove.order import Order, PathOrder
from motionlang.commands.prove.segments import Span
from motionlang.kernel.planners import State
from tests.cases import cases

FREE = (inf, inf)
FLAT = (0.0, 0.0, 0.0, 0.0)


def path(entry: int, *scales: float, comes_to_rest: bool = False) -> PathOrder:
    return PathOrder(
        tuple(range(len(scales))), scales, 0.0, 0, True, (), (0.0, 0.0), 0.0, (), (0, 1), None, FREE, FREE, FREE,
        0.0, entry=entry, comes_to_rest=comes_to_rest,
    )  # fmt: skip


# ------------------------------------------------------------------------------------------- edges


def edges(profile: Any, start: float = 0.0) -> list[str]:
    proof = Proof()
    a: Any = SimpleNamespace(index=0, starts=[start], profiles=[profile])
    _check_edges(proof, a, 0, Order("move", 3))
    return [each.message.removeprefix(f"axis 0 from {start:.6f} s: ") for each in proof.violations]


def pieced(start: float, end: float, speed: float = 5.0, duration: float = 3.0) -> Any:
    """Return a profile whose pieces go from 10 to 15 in 1 s, and to 20 in 2 s."""
    pieces = (10.0, speed, *FLAT, 0.0), (15.0, 2.5, *FLAT, 0.0)
    return SimpleNamespace(
        pieced=True, start=start, end=end, duration=duration, knots=(0.0, 1.0, 3.0), pieces=pieces
    )


EDGES: list[tuple[Any, float, list[str]]] = [
    (pieced(10.0, 20.0), 0.0, []),
    # A millionth of 20.
    (pieced(10.000_019, 20.000_019), 0.0, []),
    (pieced(10.000_021, 20.0), 0.0, ["it begins at 10, its pieces at 10"]),
    (pieced(10.0, 19.999_979), 0.0, ["it ends at 20, its pieces at 20"]),
    (pieced(11.0, 21.0), 0.0, ["it begins at 11, its pieces at 10", "it ends at 21, its pieces at 20"]),
    (pieced(10.0, 9e9, duration=inf), 0.0, []),
    (pieced(10.0, 9e9, duration=0.0), 0.0, []),
    # Four roundings of 1e9 s, 1.6 µs, at 1000 counts/s are 1.6 mcounts.
    (pieced(10.001_61, 20.001_61, 1000.0), 1e9, []),
    (pieced(10.001_63, 20.0, 1000.0), 1e9, ["it begins at 10.0016, its pieces at 10"]),
    # Of 4 s, 6.4e-15 s, at 1e10 counts/s they are 64 µ.
    (pieced(10.000_08, 20.0, 1e10), 0.0, []),
    (pieced(10.000_09, 20.0, 1e10), 0.0, ["it begins at 10.0001, its pieces at 10"]),
]


@cases("profile, start, expected", EDGES)
def test_a_profile_begins_and_ends_like_its_pieces(profile: Any, start: float, expected: list[str]) -> None:
    assert edges(profile, start) == expected


@pytest.mark.parametrize(
    ("knots", "early", "end", "expected"),
    [
        # 2 ns before its end: 2 mcounts at 1e6 counts/s, and as much again at 1e15 counts/s².
        ((0.0, 1.0, 2.0), 2e-9, 7.004, []),
        ((0.0, 1.0, 2.0), 2e-9, 7.002, ["it ends at 7.002, its pieces at 7.004"]),
        # On its last piece, which takes 2 ns.
        ((0.0, 2.0 - 2e-9, 2.0), 1e-9, 7.001_5, []),
    ],
)
def test_a_profile_without_pieces_ends_as_it_does_just_before(
    knots: tuple[float, ...], early: float, end: float, expected: list[str]
) -> None:
    seen: list[float] = []

    def at(time: float) -> State:
        seen.append(time)
        return State(7.0, 1e6, 1e15, 0.0)

    profile = SimpleNamespace(pieced=False, start=7.0, end=end, duration=2.0, knots=knots, at=at)
    assert edges(profile) == expected
    assert sorted(seen) == [0.0, pytest.approx(2.0 - early, abs=1e-15)]


# ------------------------------------------------------------------------------------------- knots


def ending(position: float, velocity: float = 0.0, acceleration: float = 0.0) -> Span:
    """Return a span of 1 s that ends in a state."""
    half = 0.5 * acceleration
    start = position - velocity + half
    return Span(0.0, 1.0, (start, velocity - acceleration, half, 0.0, 0.0, 0.0, 0.0))


def starting(position: float, velocity: float = 0.0, acceleration: float = 0.0, jerk: float = 0.0) -> Span:
    return Span(1.0, 1.0, (position, velocity, 0.5 * acceleration, jerk / 6.0, 0.0, 0.0, 0.0))


def knots(order: Order, spans: list[Span], **fields: Any) -> list[str]:
    profile = SimpleNamespace(
        start=fields.get("start", 0.0),
        peak_speed=fields.get("peak", 0.0),
        shape=fields.get("shape", "trapezoid"),
    )
    begin = fields.get("begin", 0.0)
    a: Any = SimpleNamespace(index=1, starts=[begin], profiles=[profile])
    proof = Proof()
    _check_knots(proof, a, 0, order, spans, fields.get("completes", False))
    where = f"axis 1 at {begin + 1.0:.6f} s: the "
    return [
        each.message.removeprefix(where).removesuffix(" counts within a profile") for each in proof.violations
    ]


MOVE, GEAR = Order("move", 3, rates=(100.0, 200.0)), Order("Gear", 3)
SMOOTH = MOVE._replace(jerks=(1000.0, 500.0))
WAVED = Order("move", 3, shape="scurve")
PATH = Order("path", 3, rates=(100.0, 50.0), shape="scurve", path=path(0, 1.0, -4.0))
KNOTS: list[tuple[Order, Span, Span, dict[str, Any], list[str]]] = [
    (MOVE, ending(5.0), starting(5.0), {}, []),
    # A millionth of a count, or of the position at which it begins.
    (MOVE, ending(5.0), starting(5.0 + 0.9e-6), {}, []),
    (MOVE, ending(5.0), starting(5.0 - 1.1e-6), {}, ["position jumps by 1.1e-06"]),
    (MOVE, ending(5.0), starting(5.000_099), {"start": -100.0}, []),
    (MOVE, ending(5.0), starting(5.000_125), {"start": -100.0}, ["position jumps by 0.000125"]),
    # Four roundings of 1e9 s at 100 counts/s: 160 µ.
    (MOVE, ending(5.0, 100.0), starting(5.000_160_5, 100.0), {"begin": 1e9}, []),
    (MOVE, ending(5.0, 100.0), starting(5.000_162, 100.0), {"begin": 1e9}, ["position jumps by 0.000162"]),
    # Of 2 s, with the second of the piece before: 3.2e-15 s at 1e10 counts/s are 32 µ.
    (MOVE, ending(0.0, 1e10), starting(0.000_03, 1e10), {}, []),
    (MOVE, ending(0.0, 1e10), starting(0.000_04, 1e10), {}, ["position jumps by 4e-05"]),
    # The velocity of planned motion and of paths, by its largest one.
    (MOVE, ending(5.0, 0.5), starting(5.0, 0.500_000_9), {"peak": 0.5}, []),
    (MOVE, ending(5.0, 0.5), starting(5.0, 0.500_001_1), {"peak": 0.5}, ["velocity jumps by 1.1e-06"]),
    (MOVE, ending(5.0, 9.0), starting(5.0, 9.000_049), {"peak": 50.0}, []),
    (MOVE, ending(5.0, 9.0), starting(5.0, 9.000_051), {"peak": 50.0}, ["velocity jumps by 5.1e-05"]),
    (PATH, ending(5.0, 9.0), starting(5.0, 8.0), {}, ["velocity jumps by 1"]),
    (GEAR, ending(5.0, 9.0), starting(5.0, 8.0), {}, []),
    (GEAR, ending(5.0, 9.0), starting(6.0, 9.0), {}, ["position jumps by 1"]),
    (MOVE, ending(5.0, 9.0, 100.0), starting(5.0, 9.000_161, 100.0), {"begin": 1e9}, []),
    (MOVE, ending(5.0, 9.0, 100.0), starting(5.0, 9.000_171, 100.0), {"begin": 1e9, "peak": 9.0},
     ["velocity jumps by 0.000171"]),
    # The acceleration of S-ramps, by the larger rate in counts.
    (MOVE, ending(5.0, 9.0, 3.0), starting(5.0, 9.0, 4.0), {}, []),
    (SMOOTH, ending(5.0, 9.0, 3.0), starting(5.0, 9.0, 3.000_199), {}, []),
    (SMOOTH, ending(5.0, 9.0, 3.0), starting(5.0, 9.0, 3.000_201), {}, ["acceleration jumps by 0.000201"]),
    (SMOOTH, ending(5.0, 9.0, 3.0), starting(5.0, 9.0, 4.0), {"shape": "blend"}, []),
    (SMOOTH, ending(5.0, 9.0, 3.0), starting(5.0, 8.0, 3.0), {"shape": "blend"}, ["velocity jumps by 1"]),
    (WAVED, ending(5.0, 9.0, 3.0), starting(5.0, 9.0, 3.000_000_9), {}, []),
    (WAVED, ending(5.0, 9.0, 3.0), starting(5.0, 9.0, 3.000_001_1), {}, ["acceleration jumps by 1.1e-06"]),
    (PATH, ending(5.0, 9.0, 3.0), starting(5.0, 9.0, 3.000_39), {}, []),
    (PATH, ending(5.0, 9.0, 3.0), starting(5.0, 9.0, 3.000_41), {}, ["acceleration jumps by 0.00041"]),
    (SMOOTH, ending(5.0, 9.0, 3.0), starting(5.0, 9.0, 3.001_7), {"begin": 1e9}, []),
    (SMOOTH, ending(5.0, 9.0, 3.0), starting(5.0, 9.0, 3.001_9), {"begin": 1e9}, ["acceleration jumps by 0.0019"]),
    (SMOOTH, ending(5.0), starting(6.0, 2.0, 3.0), {},
     ["position jumps by 1", "velocity jumps by 2", "acceleration jumps by 3"]),
    # A path that completes a trapezoid may change its acceleration.
    (PATH, ending(5.0, 9.0, 3.0), starting(5.0, 9.0, 4.0), {"completes": True}, []),
    (PATH, ending(5.0, 9.0, 3.0), starting(5.0, 8.0, 4.0), {"completes": True}, ["velocity jumps by 1"]),
]  # fmt: skip


@cases("order, left, right, fields, expected", KNOTS)
def test_the_pieces_of_a_profile_continue_one_another(
    order: Order, left: Span, right: Span, fields: dict[str, Any], expected: list[str]
) -> None:
    assert knots(order, [left, right], **fields) == expected
    assert knots(order, [left], **fields) == knots(order, [], **fields) == []


@pytest.mark.parametrize(("change", "expected"), [(5.0, []), (-5.0, []), (6.0, ["velocity jumps by 6"])])
def test_a_piece_shorter_than_the_rounding_of_its_time_counts_by_its_change(
    change: float, expected: list[str]
) -> None:
    """At 1e9 s a piece of 0.2 µs gains 5 counts/s, or loses as much."""
    left, short = ending(0.0, 9.0), Span(1.0, 2e-7, (0.0, 9.0, 0.5 * 5.0 / 2e-7, 0.0, 0.0, 0.0, 0.0))
    right = starting(2.3e-6, 9.0 + change)
    assert knots(MOVE, [left, short, right], begin=1e9) == expected
    # Not at 0 s, where the piece is longer than the rounding of its time; nor after the next piece.
    early = [] if change == 5.0 else [f"velocity jumps by {abs(change - 5.0):g}"]
    assert knots(MOVE, [left, short, right]) == early
    later = Span(1.0, 1.0, (2.3e-6 + 9.0 + change, 14.0 + change, *FLAT, 0.0))
    assert knots(MOVE, [left, short, right, later], begin=1e9) == [*expected, "velocity jumps by 5"]


def test_a_trapezoid_is_completed_at_the_first_standstill() -> None:
    """The acceleration jumps at three joins. At the second one the axis is at rest."""
    spans = [
        ending(0.0, 9.0, -5.0),
        starting(0.0, 9.0, -6.0, -12.0 * 3.0),
        Span(1.0, 1.0, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)),
        Span(1.0, 1.0, (0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0)),
    ]
    assert [spans[k].at(1.0)[2] != spans[k + 1].at(0.0)[2] for k in range(3)] == [True] * 3
    found = knots(PATH, spans, completes=True)
    assert [each for each in found if each.startswith("acceleration")] == ["acceleration jumps by 1"]
    assert len([each for each in knots(PATH, spans) if each.startswith("acceleration")]) == 3


STOPPED, RESUMED = path(4, 1.0, comes_to_rest=True), path(4, 1.0)
# The orders before and after, and if the second completes a trapezoid.
COMPLETED: list[tuple[Order, Order, bool]] = [
    (Order("path", 1, path=STOPPED), Order("path", 2, path=RESUMED), True),
    (Order("path", 1, path=STOPPED, shape="scurve"), Order("path", 2, path=RESUMED), False),
    (Order("path", 1, path=STOPPED, jerks=(9.0, 9.0)), Order("path", 2, path=RESUMED), False),
    (Order("path", 1, path=RESUMED), Order("path", 2, path=RESUMED), False),
    (Order("path", 1, path=STOPPED), Order("path", 2, path=STOPPED), False),
    (Order("path", 1, path=STOPPED), Order("path", 2, path=path(5, 1.0)), False),
    (Order("path", 1, path=STOPPED), Order("move", 2), False),
    (Order("stop", 1), Order("path", 2, path=RESUMED), False),
]


@cases("earlier, order, expected", COMPLETED)
def test_a_path_resumed_after_a_trapezoidal_stop_completes_it(
    earlier: Order, order: Order, expected: bool
) -> None:
    assert _completes_trapezoid(order, earlier) is expected
