"""Blended paths: a change of motion acts on all of them, and the log has each end.

All paths here are straight, along one axis each, at 10 units/s with rates of 100 units/s². So a path that
began t ago has covered 50 t² at a speed of 100 t, and from 0.1 s on 0.5 + 10 (t - 0.1) at 10. A stop at rate
d adds a distance of v² / 2d and a time of v / d. Axis 1 has 50 counts per unit.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import pytest

from motionlang.kernel import Controller, Rejected
from tests.kernel.controller.machines import machine, until

FAST, RATE, ERROR_RATE = 10.0, 100.0, 200.0
COUNTS = (1.0, 50.0)


class Path:
    """A path along one axis: its state at the time of the test, in units and seconds.

    `over` is True if it has ended.
    """

    def __init__(self, axis: int, length: float, age: float) -> None:
        self.axis, self.length, self.age, self.over = axis, length, age, False
        self.speed = min(FAST, RATE * age)
        self.travelled = 50.0 * age**2 if age < 0.1 else 0.5 + FAST * (age - 0.1)
        whole = length / FAST + 0.1
        if age >= whole:
            self.over, self.age, self.travelled, self.speed = True, whole, length, 0.0

    @property
    def left(self) -> float:
        return self.length - self.travelled


class Case:
    """A case of blended paths, each along one of `axes`.

    `begin` loads them, blends them, and advances to `moment`.
    """

    def __init__(
        self, axes: Sequence[int], lengths: Sequence[float], begins: Sequence[float], moment: float
    ) -> None:
        self.axes, self.lengths, self.begins, self.moment = axes, lengths, begins, moment

    @property
    def paths(self) -> list[Path]:
        rows = zip(self.axes, self.lengths, self.begins, strict=True)
        return [Path(axis, length, self.moment - begin) for axis, length, begin in rows]

    def begin(self, mode: int = 2) -> Controller:
        c = machine(2, buffer_size=20, error_decel=ERROR_RATE, feedrate_mode=mode)
        c.set_scale(1, COUNTS[1])
        for path in self.paths:
            distances = [0.0, 0.0]
            distances[path.axis] = path.length * COUNTS[path.axis]
            c.load_line_by([0, 1], distances)
        c.go([0])
        for time in self.begins[1:]:
            until(c, time).blend(0)
        return until(c, self.moment)

    def positions(self, more: Sequence[float]) -> list[list[float]]:
        """Return the ends of the paths, counts, if each is `more` units further.

        Each path begins where the one before it ends.
        """
        here, found = [0.0, 0.0], []
        for path, distance in zip(self.paths, more, strict=True):
            here = list(here)
            here[path.axis] += (path.travelled + distance) * COUNTS[path.axis]
            found.append(here)
        return found


CASES = {
    "two": Case([0, 1], [40.0, 40.0], [0.0, 0.5], 0.55),
    "two along one axis": Case([0, 0], [40.0, 40.0], [0.0, 0.5], 0.55),
    "three, the first one over": Case([0, 1, 0], [5.0, 40.0, 40.0], [0.0, 0.5, 0.8], 0.85),
}


def at_rest(c: Controller, case: Case, more: Sequence[float], seconds: Sequence[float], ended: str) -> None:
    """Check that each path ended `more` units further and `seconds` later.

    All records must agree.
    """
    c.clock.advance(100.0)
    ends = case.positions(more)
    entries = list(c.log.moves)
    assert len(entries) == 2 * len(ends)
    start = [0.0, 0.0]
    for k, (path, end) in enumerate(zip(case.paths, ends, strict=True)):
        for axis, move in enumerate(entries[2 * k : 2 * k + 2]):
            assert move.profile is not None
            assert move.axis == axis
            assert move.start_time == pytest.approx(case.begins[k])
            assert move.profile.start == pytest.approx(start[axis], abs=1e-9)
            assert move.profile.end == pytest.approx(end[axis], abs=1e-9)
            assert move.profile.duration == pytest.approx(path.age + seconds[k])
            assert move.ended == ("" if path.over else ended)
        start = end
    for axis in (0, 1):
        assert c.is_idle(axis)
        assert c.position(axis) == c.target(axis) == pytest.approx(ends[-1][axis], abs=1e-9)
        assert entries[axis - 2].profile.end == pytest.approx(c.position(axis), abs=1e-12)  # type: ignore[union-attr]


AT_ONCE: dict[str, tuple[Callable[[Controller], None], str]] = {
    "cancel": (lambda c: c.abort(0), "cancel"),
    "cancel of the other axis": (lambda c: c.abort(1), "cancel"),
    "drive off": (lambda c: c.disable(0), "cancel"),
    "other drive off": (lambda c: c.disable(1), "cancel"),
    "fault": (lambda c: c.fault(0, 1, "abort"), "fault"),
    "fault that switches off": (lambda c: c.fault(1, 1, "off"), "fault"),
    "limit": (lambda c: c.add_limit(0, +1, 1, "abort", True).set_active(True), "fault"),
}
STOPS: dict[str, tuple[Callable[[Controller], None], float, str]] = {
    "stop": (lambda c: c.stop(0), RATE, "stop"),
    "stop of the other axis": (lambda c: c.stop(1), RATE, "stop"),
    "stop input": (lambda c: c.fault(0, 1, "stop"), RATE, "fault"),
    "error stop": (lambda c: c.fault(1, 1, "error-stop"), ERROR_RATE, "fault"),
    "stop, then error stop": (lambda c: (c.stop(0), c.fault(0, 1, "error-stop")), ERROR_RATE, "fault"),  # type: ignore[dict-item]
}


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("cause", AT_ONCE)
def test_what_holds_an_axis_at_once_ends_all_paths_where_they_are(name: str, cause: str) -> None:
    case, (act, ended) = CASES[name], AT_ONCE[cause]
    c = case.begin()
    act(c)
    none = [0.0] * len(case.paths)
    at_rest(c, case, none, none, ended)


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("command", STOPS)
def test_a_stop_brakes_on_all_paths(name: str, command: str) -> None:
    case, (act, rate, ended) = CASES[name], STOPS[command]
    c = case.begin()
    act(c)
    speeds = [path.speed for path in case.paths]
    for axis in (0, 1):  # its rest position is known at once
        end = case.positions([v * v / (2.0 * rate) for v in speeds])[-1]
        assert c.target(axis) == pytest.approx(end[axis], abs=1e-9)
        assert c.room(axis) == 20
    at_rest(c, case, [v * v / (2.0 * rate) for v in speeds], [v / rate for v in speeds], ended)


@pytest.mark.parametrize("name", CASES)
def test_a_suspend_holds_all_paths_and_a_resume_takes_all_to_their_ends(name: str) -> None:
    case = CASES[name]
    c = case.begin()
    c.suspend(0)
    c.clock.advance(case.moment + 2.0)
    braked = [path.speed**2 / (2.0 * RATE) for path in case.paths]
    for axis in (0, 1):
        assert c.position(axis) == pytest.approx(case.positions(braked)[-1][axis], abs=1e-9)
        assert not c.velocity(axis)
        assert not c.is_idle(axis)
    c.resume(0)
    left = [path.left for path in case.paths]
    seconds = [
        0.0 if path.over else 2.0 + (distance - brake) / FAST + 0.1
        for path, distance, brake in zip(case.paths, left, braked, strict=True)
    ]
    at_rest(c, case, left, seconds, "")


def _later(path: Path, speed: float) -> float:
    """Return how long a path takes from now on at another speed, s."""
    if path.over:
        return 0.0
    ramp = abs(path.speed**2 - speed**2) / (2.0 * RATE)
    stop = speed**2 / (2.0 * RATE)
    return abs(path.speed - speed) / RATE + (path.left - ramp - stop) / speed + speed / RATE


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("setting", ["override", "feedrate_mode", "speed"])
@pytest.mark.parametrize("to", [4.0, 20.0])
def test_a_new_speed_is_that_of_all_paths(name: str, setting: str, to: float) -> None:
    """SPEED and FEEDRATEOVERRIDE act at once, or as soon as FEEDRATEMODE permits it."""
    case = CASES[name]
    c = case.begin(0 if setting == "feedrate_mode" else 2)
    if setting == "speed":
        c.configure(0, "speed", to)
    else:
        c.configure(0, "override", to / FAST)
        c.configure(0, "feedrate_mode", 2)
    at_rest(c, case, [path.left for path in case.paths], [_later(path, to) for path in case.paths], "")


@pytest.mark.parametrize("name", CASES)
def test_an_override_of_zero_holds_all_paths(name: str) -> None:
    case = CASES[name]
    c = case.begin()
    c.configure(0, "override", 0.0)
    c.clock.advance(case.moment + 2.0)
    braked = [path.speed**2 / (2.0 * RATE) for path in case.paths]
    for axis in (0, 1):
        assert c.position(axis) == pytest.approx(case.positions(braked)[-1][axis], abs=1e-9)
    c.configure(0, "override", 1.0)
    c.clock.advance(100.0)
    ends = case.positions([path.left for path in case.paths])[-1]
    assert [c.position(axis) for axis in (0, 1)] == pytest.approx(ends)


@pytest.mark.parametrize("axis", [0, 1])
def test_a_limit_of_an_axis_acts_on_the_path_that_moves_it(axis: int) -> None:
    case = CASES["two"]
    c = case.begin()
    c.configure(axis, "max_speed", 4.0 * COUNTS[axis])
    paths = case.paths
    seconds = [_later(path, 4.0 if path.axis == axis else FAST) for path in paths]
    at_rest(c, case, [path.left for path in paths], seconds, "")


@pytest.mark.parametrize("name", CASES)
def test_what_a_path_allows_of_no_other_motion_it_allows_while_it_is_blended(name: str) -> None:
    c = CASES[name].begin()
    with pytest.raises(Rejected, match="on a path"):
        c.define_position(0, 1.0)
    with pytest.raises(Rejected, match="on a path"):
        c.move_to(0, 1.0)
    with pytest.raises(Rejected, match="on a path"):
        c.jog(1, 1.0)


def test_what_an_axis_says_of_itself_while_two_paths_come_to_rest() -> None:
    """Stopped at 0.55 s, the second path rests at 0.60 s, the first one at 0.65 s.

    At 0.62 s the first one has a speed of 3.
    """
    c = CASES["two"].begin()
    c.stop(0)
    until(c, 0.62)
    assert c.velocity(0) == pytest.approx(3.0)
    assert c.velocity(1) == 0.0
    assert c.path_speed(0) == c.path_speed(1) == pytest.approx(3.0)
    assert not c.is_idle(0)
    assert not c.is_idle(1)
    assert c.idle_time(0) == pytest.approx(0.65)
    assert c.remaining(0) == pytest.approx(0.045)
    until(c, 0.65)
    assert c.is_idle(0)
    assert c.is_idle(1)


def test_a_stop_after_the_second_path_is_over_leaves_that_complete() -> None:
    """The second path takes 0.2 s from 0.5 s on.

    At 0.8 s the first one has covered 7.5, and stops within 0.5.
    """
    case = Case([0, 1], [40.0, 1.0], [0.0, 0.5], 0.8)
    c = case.begin()
    c.stop(1)
    at_rest(c, case, [0.5, 0.0], [0.1, 0.0], "stop")


# ----------------------------------------------------------------------------------------- at most two


def row(distance: float, lengths: Sequence[float], **settings: float) -> Controller:
    """Return a controller with paths along axis 0 that are blended into each other."""
    c = machine(2, buffer_size=20, blend_mode=True, blend_distance=distance, **settings)
    for line, length in enumerate(lengths, 1):
        c.load_line_by([0, 1], [length, 0.0], "VECTORR", line)
    c.go([0])
    c.clock.advance(100.0)
    return c


def begins(c: Controller) -> list[float]:
    return [move.start_time for move in c.log.moves if move.axis == 0]


def shortened(c: Controller) -> list[float | None]:
    """Return the commanded and the actual distance of each shortened blend in turn."""
    events = [each for each in c.log.events if (each.kind, each.text) == ("clamp", "blend distance")]
    return [figure for each in events for figure in (each.value, each.limit)]


def test_no_more_than_half_of_a_path_is_blended_into_the_next_one() -> None:
    """At speed 40, half of a path of 10 takes 0.04 + 4.2 / 40 s.

    The complete path takes 0.29 s, so the path before it has just ended.
    """
    c = row(10.0, [10.0] * 5, speed=40.0, accel=1000.0, decel=1000.0)
    half = 0.04 + 4.2 / 40.0
    assert begins(c) == pytest.approx([k * half for k in range(5)])
    assert c.axes[0].starts[-1] == pytest.approx(4.0 * half + 0.29)
    assert max(c.axes[0].velocity(0.001 * k) for k in range(900)) == pytest.approx(80.0)
    assert c.position(0) == 50.0
    assert shortened(c) == pytest.approx([10.0, 5.0] * 4)


def test_a_distance_up_to_half_of_a_path_is_accepted_without_a_message() -> None:
    c = row(5.0, [10.0] * 3, speed=40.0, accel=1000.0, decel=1000.0)
    half = 0.04 + 4.2 / 40.0
    assert begins(c) == pytest.approx([0.0, half, 2.0 * half])
    assert shortened(c) == []


def test_a_path_is_not_blended_before_the_one_before_it_has_ended() -> None:
    """The second path begins at 0.4 s and has covered half at 0.4775 s.

    The first one ends at 0.5 s, the second one at 0.5549 s.
    """
    c = row(0.5, [4.0, 0.6, 4.0])
    assert begins(c) == pytest.approx([0.0, 0.4, 0.5])
    left = 50.0 * (2.0 * 0.006**0.5 - 0.1) ** 2
    assert shortened(c) == pytest.approx([0.5, left])


def test_a_path_that_ends_before_the_one_before_it_is_not_blended() -> None:
    """The first path is blended at 0.4 s and ends at 0.5 s.

    The second one takes 0.02 s, so it ends at 0.42 s.
    """
    c = row(0.5, [4.0, 0.01, 4.0])
    assert begins(c) == pytest.approx([0.0, 0.4, 0.5])
    assert shortened(c) == [0.5, 0.0]
    assert c.position(0) == 8.01


def test_a_blend_waits_until_the_one_before_it_is_over() -> None:
    """The first path ends at 4.1 s; the second, begun at 0.5 s, then has 4.5 left.

    At 0.6 s the second one has 39.5 left.
    """
    c = machine(2, buffer_size=20)
    for _ in range(3):
        c.load_line_by([0, 1], [40.0, 0.0])
    c.go([0])
    until(c, 0.5).blend(0)
    until(c, 0.6).blend(0)
    c.clock.advance(100.0)
    assert begins(c) == pytest.approx([0.0, 0.5, 4.1])
    assert shortened(c) == pytest.approx([39.5, 4.5])
    assert c.position(0) == 120.0


def test_a_path_that_is_run_through_is_not_blended() -> None:
    c = machine(2, buffer_size=20, contour_mode=True, contour_angle=90.0)
    c.load_line_by([0, 1], [40.0, 0.0])
    c.load_line_by([0, 1], [0.0, 40.0])
    c.go([0])
    with pytest.raises(Rejected) as rejected:
        until(c, 1.0).blend(0)
    assert rejected.value.code == "contour-and-blend"
    c.clock.advance(100.0)
    assert [c.position(axis) for axis in (0, 1)] == [40.0, 40.0]
