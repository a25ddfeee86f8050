"""The peak speed of a report, compared with the speeds on a track, by hand."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.prove.checker import Proof
from motionlang.commands.prove.order import Order
from motionlang.commands.prove.outputs import _check_peak
from motionlang.kernel.planners import Profile, hold, plan_trapezoid
from tests.cases import cases

# 1 s to 10 counts/s, 9 s at that, and 1 s to rest.
WHOLE = plan_trapezoid(0.0, 100.0, 10.0, 10.0, 10.0)
MOVE, REST = Order("move", 3), Order("rest", 0)


def violations(
    reported: float,
    time: tuple[float, float],
    profiles: list[tuple[float, Profile, Order]],
    until: float = 99.0,
) -> list[str]:
    starts = [start for start, _, _ in profiles]
    a: Any = SimpleNamespace(
        index=0,
        starts=starts,
        profiles=[profile for _, profile, _ in profiles],
        index_at=lambda at: max((k for k, start in enumerate(starts) if start <= at), default=-1),
    )
    run: Any = SimpleNamespace(
        until=until, expected_motion=SimpleNamespace(of={0: [order for _, _, order in profiles]})
    )
    proof = Proof()
    _check_peak(proof, run, a, reported, time, 3)
    assert all(each.line == 3 for each in proof.violations)
    return [
        each.message.removeprefix(f"axis 0 from {time[0]:.6f} s: the report has a ")
        for each in proof.violations
    ]


ONE = [(2.0, WHOLE, MOVE), (13.0, hold(100.0), REST)]
# It goes on from 5 counts/s at 2.5 s by another profile, up to 8 counts/s.
TWO = [
    (2.0, WHOLE, MOVE),
    (2.5, plan_trapezoid(1.25, 50.0, 8.0, 10.0, 10.0, 5.0), MOVE),
]
WRONG = "peak of {:g}, the track {:g}"
# The reported peak, from when to when, the track, the end of the run, and the violations.
PEAKS: list[tuple[float, tuple[float, float], list[tuple[float, Profile, Order]], float, list[str]]] = [
    (10.0, (2.0, 13.0), ONE, 99.0, []),
    (10.000_009, (2.0, 13.0), ONE, 99.0, []),
    (10.000_02, (2.0, 13.0), ONE, 99.0, [WRONG.format(10.00002, 10)]),
    (9.999_991, (2.0, 13.0), ONE, 99.0, []),
    (9.99, (2.0, 13.0), ONE, 99.0, [WRONG.format(9.99, 10)]),
    (0.0, (2.0, 13.0), ONE, 99.0, [WRONG.format(0, 10)]),
    # Up to 2.5 s it is at 5 counts/s.
    (5.0, (2.0, 2.5), ONE, 99.0, []),
    (10.0, (2.0, 2.5), ONE, 99.0, [WRONG.format(10, 5)]),
    (10.0, (2.5, 2.75), ONE, 99.0, [WRONG.format(10, 7.5)]),
    (5.0, (12.5, 13.0), ONE, 99.0, []),
    # The peak of a move that the run cuts short may still come.
    (10.0, (2.0, 13.0), ONE, 2.5, []),
    (4.0, (2.0, 13.0), ONE, 2.5, [WRONG.format(4, 5)]),
    # Both profiles count, up to the end of the move.
    (8.0, (2.0, 9.0), TWO, 99.0, []),
    (7.0, (2.0, 9.0), TWO, 99.0, [WRONG.format(7, 8)]),
    (10.0, (2.0, 9.0), TWO, 99.0, [WRONG.format(10, 8)]),
    (5.0, (2.0, 2.5), TWO, 99.0, []),
    # Neither rests nor blends are compared.
    (77.0, (2.0, 14.0), ONE, 99.0, []),
    (77.0, (13.0, 14.0), ONE, 99.0, []),
]


@cases("reported, time, profiles, until, expected", PEAKS)
def test_the_peak_of_a_move_is_that_of_its_track(
    reported: float,
    time: tuple[float, float],
    profiles: list[tuple[float, Profile, Order]],
    until: float,
    expected: list[str],
) -> None:
    assert violations(reported, time, profiles, until) == expected


@pytest.mark.parametrize(("reported", "expected"), [(10.0, []), (99.0, []), (9.9, [WRONG.format(9.9, 10)])])
def test_a_profile_without_pieces_is_sampled(reported: float, expected: list[str]) -> None:
    """It is compared at 17 times. The true peak may lie between two of them."""
    seen: list[float] = []

    def velocity(time: float) -> float:
        seen.append(time)
        return 10.0 - 5.0 * abs(time - 4.0)

    profile: Any = SimpleNamespace(pieced=False, shape="guided", velocity=velocity)
    assert violations(reported, (2.0, 10.0), [(2.0, profile, MOVE)]) == expected
    assert seen == pytest.approx([0.5 * n for n in range(17)], abs=1e-12)
    assert 0.0 < min(seen) < max(seen) < 8.0
    blend: Any = SimpleNamespace(pieced=False, shape="blend", velocity=velocity)
    assert violations(77.0, (2.0, 10.0), [(2.0, blend, MOVE)]) == []
