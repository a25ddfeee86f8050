"""Bounds of paths, each computed by hand from orders and segments of motion.

Unless stated otherwise a path is a line of one axis over 100 counts at 10 counts/s and 10 counts/s², which stops
over 5 counts.
"""

from __future__ import annotations

from math import inf
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.prove.checker import Proof
from motionlang.commands.prove.order import Order, PathOrder
from motionlang.commands.prove.path_bounds import (
    _check_joins,
    _profile_at,
)
from motionlang.commands.prove.path_layout import PathLayout
from motionlang.commands.prove.paths import (
    _check_geometry,
    _speeds_up,
    check_path_end,
)
from motionlang.commands.prove.segments import Span
from motionlang.kernel.planners import Profile, hold, plan_trapezoid
from motionlang.kernel.planners.sequence import chained

PATH = PathOrder(
    (0,), (1.0,), 0.0, 0, True, (100.0,), (0.0, 0.0), 0.0, (), (0, 1), None, (inf,), (inf,), (inf,), 0.0
)
ORDER = Order("path", 3, speed=10.0, rates=(10.0, 10.0), shape="trapezoid", path=PATH)
SMOOTH = ORDER._replace(shape="scurve", jerks=(20.0, 20.0))
TWO = PATH._replace(
    members=(0, 1), scales=(2.0, -4.0), line=(12.0, -32.0),
    most=(12.0, 100.0), most_accel=(60.0, 1e9), most_decel=(inf, 160.0),
)  # fmt: skip
WHOLE = plan_trapezoid(0.0, 100.0, 10.0, 10.0, 10.0)


def span(begin: float, length: float, *coefficients: float) -> Span:
    """Return a segment c0 + c1 x + c2 x² + c3 x³."""
    c0, c1, c2, c3 = (*coefficients, 0.0, 0.0, 0.0, 0.0)[:4]
    return Span(begin, length, (c0, c1, c2, c3, 0.0, 0.0, 0.0))


def then(order: Order, **fields: Any) -> Order:
    """Return the order of a path with other fields."""
    assert order.path is not None
    return order._replace(path=order.path._replace(**fields))


# -- what the axes allow


# -- room for a stop

# -- speed along a path


@pytest.mark.parametrize(
    ("order", "came", "jump", "bend", "names"),
    [
        (ORDER, 0.0, 0.9e-5, 0.0, []),
        (ORDER, 0.0, 1.2e-5, 0.0, ["speed"]),
        (ORDER, 0.0, 0.0, 1.0, []),  # the acceleration of a trapezoid jumps
        (SMOOTH, 0.0, 0.0, 1.0, ["acceleration"]),
        (SMOOTH, 0.0, 1.0, 1.0, ["speed", "acceleration"]),
        (ORDER, 100.0, 0.9e-4, 0.0, []),
        (ORDER, 100.0, 1.2e-4, 0.0, ["speed"]),
        (ORDER._replace(speed=inf, rates=(10.0, inf)), 0.0, 1.2e-5, 0.0, ["speed"]),
        (ORDER._replace(speed=0.1, rates=(0.1, 0.1)), 0.0, 0.9e-6, 0.0, []),
        (ORDER._replace(speed=0.1, rates=(0.1, 0.1)), 0.0, 1.2e-6, 0.0, ["speed"]),
    ],
)
def test_the_speed_along_a_path_is_continuous(
    order: Order, came: float, jump: float, bend: float, names: list[str]
) -> None:
    """A millionth of the largest bound is rounding, or of 1 if that is more."""
    proof = Proof()
    _check_joins(
        proof, order, [span(0.0, 1.0, 0.0, 5.0), span(1.0, 1.0, 5.0, 5.0 + jump, 0.5 * bend)], came, "x"
    )
    assert [each.message.split()[2] for each in proof.violations] == names


def test_the_profile_of_a_sequence_in_force_at_a_time() -> None:
    """WHOLE takes 11 s, a second one from 100 on as long."""
    second = WHOLE.shifted(100.0)
    both = chained(WHOLE, second)
    found = {time: _profile_at(both, time) for time in (0.0, 10.0, 11.0, 12.0, 23.0)}
    assert {time: each[1:] for time, each in found.items()} == {
        0.0: (0.0, 11.0), 10.0: (10.0, 1.0), 11.0: (0.0, 11.0), 12.0: (1.0, 10.0), 23.0: (12.0, inf),
    }  # fmt: skip
    assert [each[0].start for each in found.values()] == [0.0, 0.0, 100.0, 100.0, 100.0]
    assert _profile_at(WHOLE, 10.0)[1:] == (10.0, 1.0)
    assert [_profile_at(WHOLE, time)[1:] for time in (11.0, 12.0)] == [(11.0, inf), (12.0, inf)]


# -- one path after another


def track(*entries: tuple[float, Profile]) -> Any:
    """Return the track of axis 0 with profiles and their starts."""
    starts = [start for start, _ in entries]
    return SimpleNamespace(
        index=0,
        starts=starts,
        profiles=[profile for _, profile in entries],
        index_at=lambda time: max(k for k, start in enumerate(starts) if start <= time),
    )


# When the path before was replaced, its order, and whether it was speeding up. It is at speed from 1 s to 10 s.
BEFORE: dict[str, tuple[float, Order, bool]] = {
    "while it sped up": (0.5, ORDER, True),
    "at its speed": (5.0, ORDER, True),
    "while it braked": (10.5, ORDER, False),
    "as it began": (0.0, ORDER, False),
    "it was another motion": (0.5, Order("move", 1), False),
    "it came to rest": (0.5, then(ORDER, comes_to_rest=True), False),
    "it was one of other axes": (0.5, ORDER._replace(path=TWO), False),
}  # fmt: skip


@pytest.mark.parametrize("name", BEFORE)
def test_a_path_that_sped_up_was_not_slowing_down_for_the_next(name: str) -> None:
    time, earlier, speeds_up = BEFORE[name]
    master = track((2.0, WHOLE), (2.0 + time, hold(0.0)))
    run: Any = SimpleNamespace(axes={0: master}, expected_motion=SimpleNamespace(of={0: [earlier, ORDER]}))
    # Only the profile before counts, whatever follows it.
    master.index_at = lambda at: 0
    assert _speeds_up(run, ORDER, PATH, master, 1) is speeds_up


@pytest.mark.parametrize(
    ("scales", "speeds_up"),
    [((1.0, 1.0), True), ((1.0, 10.0), True), ((1.0, 0.1), False), ((0.1, 1.0), True)],
)
def test_a_path_speeds_up_by_the_sum_of_its_axes(scales: tuple[float, float], speeds_up: bool) -> None:
    """Axis 0 speeds up from 0.2 to 0.7 counts/s, axis 1 slows down from 0.4 to 0.3.

    Their accelerations are 1 and -0.2. With 0.1 counts per unit, axis 1 slows down from 4 to 3.
    """
    up = plan_trapezoid(0.0, 100.0, 10.0, 1.0, 1.0, 0.2)
    down = plan_trapezoid(0.0, 100.0, 0.1, 0.2, 0.2, 0.4)
    tracks = {0: track((2.0, up), (2.5, hold(0.0))), 1: track((2.0, down), (2.5, hold(0.0)))}
    for each in tracks.values():
        each.index_at = lambda at: 0
    path = PATH._replace(members=(0, 1), scales=scales)
    earlier = ORDER._replace(path=path)
    run: Any = SimpleNamespace(axes=tracks, expected_motion=SimpleNamespace(of={0: [earlier, earlier]}))
    assert _speeds_up(run, earlier, path, tracks[0], 1) is speeds_up


# The profile, its path, whether it is over, and the violations. The path ends at 100 counts.
ENDS: dict[str, tuple[Profile, PathOrder, bool, list[str]]] = {
    "at its end": (WHOLE, PATH, True, []),
    "beyond its end by a millionth": (plan_trapezoid(0.0, 100.00009, 10.0, 10.0, 10.0), PATH, True, []),
    "beyond its end": (
        plan_trapezoid(0.0, 100.001, 10.0, 10.0, 10.0), PATH, True, ["its path ends at 100.001, commanded 100"],
    ),
    "before its end": (
        plan_trapezoid(0.0, 99.999, 10.0, 10.0, 10.0), PATH, True, ["its path ends at 99.999, commanded 100"],
    ),
    "not over yet": (plan_trapezoid(0.0, 50.0, 10.0, 10.0, 10.0), PATH, False, []),
    "a short path, by a millionth": (
        plan_trapezoid(0.0, 0.1 + 9e-7, 10.0, 10.0, 10.0), PATH._replace(line=(0.1,)), True, [],
    ),
    "a short path, by more": (
        plan_trapezoid(0.0, 0.1 + 2e-6, 10.0, 10.0, 10.0), PATH._replace(line=(0.1,)), True,
        ["its path ends at 0.100002, commanded 0.1"],
    ),
    "in no time": (
        hold(0.0).cut(0.0), PATH._replace(line=(1e-5,)), True,
        ["its path ends at 0, commanded 1e-05", "a path in no time"],
    ),
    "nowhere in no time": (hold(0.0).cut(0.0), PATH._replace(line=(1e-7,)), True, []),
}  # fmt: skip


@pytest.mark.parametrize("name", ENDS)
def test_a_path_ends_at_its_commanded_position_and_takes_time(name: str) -> None:
    profile, path, over, messages = ENDS[name]
    move: Any = SimpleNamespace(axis=0, line=3, start_time=2.0, profile=profile, offset=0.0)
    order = ORDER._replace(path=path)
    run: Any = SimpleNamespace(
        order_of=lambda each: order, members=lambda each: [move], origins=lambda each: [profile.start]
    )
    proof = Proof()
    check_path_end(proof, run, move, over)
    where = "axis 0 from 2.000000 s: "
    assert [each.message for each in proof.violations] == [where + message for message in messages]
    move.offset = 5.0
    check_path_end(proof, run, move, over)
    assert len(proof.violations) == len(messages)


# -- motion along a path


@pytest.mark.parametrize(
    ("factor", "shift", "start", "off"),
    [
        (1.0, 0.0, 0.0, ""),
        (1.0 + 1e-6, 0.0, 0.0, ""),
        (1.0 + 3e-6, 0.0, 0.0, "1.152e-05"),
        (1.0, 8e-5, 0.0, ""),
        (1.0, 1e-4, 0.0, "1.2e-05"),
        (1.0, 1e-4, 400.0, ""),
    ],
)
def test_the_axes_of_a_line_are_on_it(factor: float, shift: float, start: float, off: str) -> None:
    """A millionth of its 10 units is rounding, or of the 100 units that it begins at.

    With s counts too many, axis 1 is s / 4 units off in y: 0.48 of these across the line in x, 0.36 in y.
    """
    base = plan_trapezoid(0.0, 10.0, 10.0, 10.0, 10.0)
    path = TWO._replace(relative=True)
    layout = PathLayout(path, [0.0, start])
    profiles = [base.scaled(0.0, 1.2), base.scaled(start + shift, -3.2 * factor)]
    proof = Proof()
    _check_geometry(proof, ORDER._replace(path=path), layout, profiles, [], (0.0, base.duration), "here")
    message = f"here: it is {off} off the commanded path"
    assert [each.message for each in proof.violations] == [message] * bool(off)


# -- blended paths
