"""Watches: a call at the exact time at which an axis passes a position."""

from __future__ import annotations

import random
from collections.abc import Callable
from itertools import pairwise

import pytest

from motionlang.kernel import Controller
from tests.counted_calls import all_calls


def machine() -> Controller:
    c = Controller(1)
    for name, value in (("speed", 8.0), ("accel", 16.0), ("decel", 16.0)):
        c.configure(0, name, value)
    return c


def recorder(seen: list[tuple[float, int]], mark: float) -> Callable[[int], None]:
    return lambda direction: seen.append((mark, direction))


@pytest.mark.parametrize("days", [0.01, 1.0, 30.0])
@pytest.mark.parametrize("speed", [1e5, 1e7, 84e6])
def test_a_fast_axis_passes_once_also_after_days(days: float, speed: float) -> None:
    """After days the clock is coarser than a position's margin."""
    c = machine()
    for name, value in (("speed", speed), ("accel", 1e9), ("decel", 1e9)):
        c.configure(0, name, value)
    c.clock.advance(days * 86400.0 + 0.123456789)
    seen: list[int] = []
    positions = [speed * (0.013 * k + 0.0001) for k in range(1, 40)]

    def pass_by(direction: int) -> None:
        seen.append(direction)
        assert len(seen) <= 2 * len(positions)

    for position in positions:
        c.watch(0, position, pass_by)
    c.move_to(0, speed)
    c.clock.advance(c.clock.now + 3.0)
    c.move_to(0, 0.0)
    c.clock.advance(c.clock.now + 3.0)
    assert seen == [1] * len(positions) + [-1] * len(positions)


def test_a_watch_set_in_motion_sees_only_what_is_still_to_come() -> None:
    c = machine()
    seen: list[int] = []
    c.move_to(0, 12.0)
    c.clock.advance(1.5)
    c.watch(0, 6.0, seen.append)
    c.watch(0, 11.0, seen.append)
    c.clock.advance(9.0)
    assert seen == [1]


def test_a_watch_can_stop_the_axis_it_watches() -> None:
    c = machine()
    c.watch(0, 6.0, lambda _: c.stop(0))
    c.move_to(0, 12.0)
    c.clock.advance(9.0)
    assert c.position(0) == pytest.approx(8.0)


def test_a_thousand_marks_cost_as_much_as_ten() -> None:
    def calls(marks: int) -> int:
        c = machine()
        for k in range(marks):
            c.watch(0, 10.0 * k + 5.0, lambda _: None, physical=True)

        def shuttle() -> None:
            for _ in range(10):
                for velocity in (8.0, -8.0):
                    c.jog(0, velocity)
                    c.clock.advance(c.clock.now + 5.0)
                c.move_to(0, 30.0)
                c.clock.advance(c.clock.now + 9.0)
                c.move_to(0, 0.0)
                c.clock.advance(c.clock.now + 9.0)

        return all_calls(shuttle)

    assert calls(1000) < 1.02 * calls(10)


@pytest.mark.parametrize("seed", range(20))
def test_each_mark_between_two_targets_is_passed_once_in_order(seed: int) -> None:
    draw = random.Random(seed)
    marks = [float(draw.randrange(-50, 50)) + 0.5 for _ in range(draw.choice((3, 30, 200)))]
    targets = [0.0, *(float(draw.randrange(-60, 60)) for _ in range(6))]
    c = machine()
    passed: list[tuple[float, int]] = []
    for mark in marks:
        c.watch(0, mark, recorder(passed, mark), physical=mark % 2 < 1)
    for target in targets[1:]:
        c.move_to(0, target)
        c.clock.advance(c.clock.now + 60.0)
    assert passed == [
        (mark, 1 if begin < end else -1)
        for begin, end in pairwise(targets)
        for mark in sorted(marks, reverse=begin > end)
        if min(begin, end) < mark < max(begin, end)
    ]


def test_marks_passed_at_one_time_are_called_in_order_of_creation() -> None:
    """0.1 times 3 and 0.3 differ by a rounding, which a time does not show."""
    c = machine()
    c.clock.advance(1000.0)
    seen: list[tuple[float, int]] = []
    for number, position in enumerate((0.1 * 3, 0.3, 0.2, 0.1, 0.3, 0.1 * 3)):
        c.watch(0, position, recorder(seen, number))
    c.move_to(0, 12.0)
    c.clock.advance(1009.0)
    assert [number for number, _ in seen] == [3, 2, 0, 1, 4, 5]
    c.move_to(0, 0.0)
    c.clock.advance(1019.0)
    assert [number for number, _ in seen[6:]] == [0, 1, 4, 5, 2, 3]


def test_an_axis_that_turns_back_on_its_way_passes_the_same_marks() -> None:
    c = machine()
    seen: list[tuple[float, int]] = []
    for mark in range(1, 100):
        c.watch(0, float(mark), recorder(seen, mark))
    c.jog(0, 8.0)
    c.clock.advance(0.9)
    c.move_to(0, -1.0)
    c.clock.advance(9.0)
    assert seen == [(mark, 1) for mark in range(1, 8)] + [(mark, -1) for mark in range(7, 0, -1)]


def test_a_mark_that_sends_the_axis_back_hides_no_other() -> None:
    """Two marks are passed at one time: the first stops the axis, the second sends it back."""
    c = machine()
    seen: list[tuple[float, int]] = []
    c.watch(0, 8.0, lambda direction: c.stop(0) if direction > 0 else None)
    c.watch(0, 8.0, lambda direction: c.move_to(0, 0.0) if direction > 0 else None)
    for mark in (4.0, 6.0, 8.0):
        c.watch(0, mark, recorder(seen, mark))
    c.move_to(0, 12.0)
    c.clock.advance(19.0)
    assert seen == [(4.0, 1), (6.0, 1), (8.0, 1), (8.0, -1), (6.0, -1), (4.0, -1)]


def test_a_new_zero_set_at_a_mark_moves_the_marks_of_the_program_alone() -> None:
    c = machine()
    of_program: list[tuple[float, int]] = []
    of_machine: list[tuple[float, int]] = []
    for mark in (2.0, 3.0, 5.0):
        c.watch(0, mark, recorder(of_program, mark))
        c.watch(0, mark, recorder(of_machine, mark), physical=True)
    c.watch(0, 4.0, lambda _: c.define_position(0, 2.5), physical=True)
    c.move_by(0, 12.0)
    c.clock.advance(9.0)
    assert of_program == [(2.0, 1), (3.0, 1), (3.0, 1), (5.0, 1)]
    assert of_machine == [(2.0, 1), (3.0, 1), (5.0, 1)]
