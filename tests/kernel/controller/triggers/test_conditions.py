"""The table of conditions: every motion, every cause of a limit, every mode.

The expected rest position is computed by hand from the same motion without a limit. When the limit becomes
true, the axis is at p with the velocity v. Then it comes to rest at

* p for a crash stop, with or without disabling the drive;
* p + v² / 2d for a stop at DECEL or at ERRORDECEL; on a path this applies to the distance along it, and to
  each path that is blended;
* its end without the limit, if the limit is to be ignored or only reported.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import count, product
from math import cos

import pytest

from motionlang.kernel import Controller, Machine, Rejected
from motionlang.kernel.controller.axis import BY_INPUT, BY_WORD
from motionlang.kernel.controller.faults import LIMIT_FORWARD, LIMIT_REVERSE, SOFT_LIMIT_FORWARD
from motionlang.kernel.controller.triggers.conditions import ACTIONS
from motionlang.kernel.controller.triggers.homing import Homing
from motionlang.kernel.controller.triggers.limit import Limit
from motionlang.kernel.planners import plan
from motionlang.kernel.planners.reference import Slope
from tests.cases import cases, one_in
from tests.kernel.controller.machines import cam, offset

DECEL, ERROR_DECEL = 200.0, 400.0
END = 6.0
MOTOR = {
    "axis.0.plant.amplifier": "current",
    "axis.0.servo.proportional": 0.02,
    "axis.0.servo.derivative": 0.5,
}


def machine(motor: bool) -> Controller:
    c = Machine(MOTOR if motor else {}).controller
    for axis in (0, 1):
        for name, value in (
            ("speed", 50.0),
            ("accel", 100.0),
            ("decel", DECEL),
            ("error_decel", ERROR_DECEL),
        ):
            c.configure(axis, name, value)
        c.configure(axis, "buffer_size", 10)
    return c


class Kind:
    """One kind of motion: `begin` starts it forward, `reverse` reverses it.

    `moment` is a time at which it is fast. `along` gives the position of the axis after a distance along an
    arc.
    """

    def __init__(
        self,
        begin: Callable[[Controller], object],
        reverse: Callable[[Controller], object] | None,
        moment: float = 1.0,
        along: Callable[[float], float] | None = None,
        renamed: bool = True,
    ) -> None:
        self.begin, self.reverse, self.moment, self.along, self.renamed = (
            begin,
            reverse,
            moment,
            along,
            renamed,
        )


def _buffered(c: Controller) -> None:
    for _ in range(4):
        c.load_by(0, 20.0)
    c.go([0])


def _line(c: Controller, first: int = 0) -> None:
    if first == 0:
        c.load_line([0, 1], [60.0, 80.0])
    else:
        c.load_line([1, 0], [80.0, 60.0])
    c.go([first])


def _several(c: Controller, blend: bool) -> None:
    for axis in (0, 1):
        c.configure(axis, "contour_mode", not blend)
        c.configure(axis, "blend_mode", blend)
        c.configure(axis, "blend_distance", 1.0)
    c.load_line([0, 1], [60.0, 80.0])
    c.load_line([0, 1], [90.0, 120.0])
    c.go([0])


def _blended(c: Controller, count: int) -> None:
    """Load lines of 50 units; each is blended from 0.85 to 1.375 s after its start."""
    for axis in (0, 1):
        c.configure(axis, "blend_mode", True)
        c.configure(axis, "blend_distance", 20.0)
    for _ in range(count):
        c.load_line_by([0, 1], [30.0, 40.0])
    c.go([0])


def _there_and_back(c: Controller, axes: list[int], mode: str = "") -> None:
    """Load paths of 60 forward and 60 back on axis 0, while axis 1 continues forward.

    By `mode` the paths stop in between, form a contour, or are blended.
    """
    for axis in (0, 1):
        c.configure(axis, "contour_mode", mode == "contour")
        c.configure(axis, "contour_angle", 180.0)
        c.configure(axis, "blend_mode", mode == "blend")
        c.configure(axis, "blend_distance", 3.0)
    there, back = {0: 60.0, 1: 80.0}, {0: -60.0, 1: 80.0}
    c.load_line_by(axes, [there[axis] for axis in axes])
    c.load_line_by(axes, [back[axis] for axis in axes])
    c.go([axes[0]])


def _arc(c: Controller) -> None:
    c.load_arc([0, 1], [30.0, 0.0], 180.0, relative=True)
    c.load_arc([0, 1], [-30.0, 0.0], 180.0, relative=True)
    c.go([0])


def _slave(c: Controller) -> None:
    c.gear(0, 1, 1.0)
    c.jog(1, 20.0)


def _cam(c: Controller) -> None:
    cam(c, 0, 1, [0.0, 10.0, 20.0, 30.0, 60.0], [0.0, 10.0, 20.0, 10.0, 0.0], smooth=True)
    c.jog(1, 10.0)


def _fly(c: Controller) -> None:
    c.load_fly(0, 1, 100.0, 100.0)
    c.go([0])
    c.jog(1, 20.0)


def _offset(c: Controller) -> None:
    c.gear(0, 1, 1.0)
    offset(c, 0, 60.0)


def _spline(c: Controller) -> None:
    there = plan("trapezoid", 0.0, 40.0, 40.0, 100.0, 100.0)
    c.play(0, there.then(plan("trapezoid", 40.0, -40.0, 40.0, 100.0, 100.0)), on_path=True)


def _home(c: Controller) -> None:
    Homing(c, 0, +1, 20.0, 5.0, 2.0)


def _switch_home(c: Controller) -> None:
    c.set_home_switch(0, True)


def _speed(c: Controller, velocity: float) -> None:
    c.refer_speed(0, velocity, (Slope(100.0, 0.0, 0.0), Slope(DECEL, 0.0, 0.0)))


KINDS = {
    "move": Kind(lambda c: c.move_to(0, 80.0), lambda c: c.retarget_to(0, -20.0)),
    "buffered": Kind(_buffered, lambda c: c.retarget_to(0, -20.0), 0.3),
    "jog": Kind(lambda c: c.jog(0, 20.0), lambda c: c.jog(0, -20.0)),
    "path": Kind(_line, None, 1.0, renamed=False),
    "path of another axis": Kind(lambda c: _line(c, 1), None, 1.0, renamed=False),
    "contour": Kind(lambda c: _several(c, False), None, 1.0, renamed=False),
    "blend": Kind(lambda c: _several(c, True), None, 1.0, renamed=False),
    "two blended": Kind(lambda c: _blended(c, 2), None, 1.0, renamed=False),
    "three blended": Kind(lambda c: _blended(c, 3), None, 1.9, renamed=False),
    "arc": Kind(_arc, _arc, 1.0, lambda s: 30.0 * (1.0 - cos(s / 30.0)), renamed=False),
    "slave": Kind(_slave, lambda c: c.jog(1, -20.0)),
    "cam": Kind(_cam, _cam),
    "fly": Kind(_fly, lambda c: c.jog(1, -20.0)),
    "offset": Kind(_offset, lambda c: offset(c, 0, -100.0)),
    "spline": Kind(_spline, _spline),
    "speed reference": Kind(lambda c: _speed(c, 20.0), lambda c: _speed(c, -20.0)),
    "position reference": Kind(
        lambda c: c.refer_position(0, 0.4), lambda c: c.refer_position(0, -0.4), 0.0005
    ),
    "home": Kind(_home, _switch_home),
}
# The kinds that reverse by themselves, and those that cannot.
BY_THEMSELVES = ("arc", "cam", "spline")
SOFT = ("met", "placed", "renamed")
# Paths reverse if another one leads back: each with its start.
BACK: dict[str, Callable[[Controller], None]] = {
    "path": lambda c: _there_and_back(c, [0, 1]),
    "path of another axis": lambda c: _there_and_back(c, [1, 0]),
    "contour": lambda c: _there_and_back(c, [0, 1], "contour"),
    "blend": lambda c: _there_and_back(c, [0, 1], "blend"),
    "two blended": lambda c: _there_and_back(c, [0, 1], "blend"),
    "three blended": lambda c: _there_and_back(c, [0, 1], "blend"),
}


@cache
def _back(name: str, motor: bool) -> tuple[Kind, Free]:
    """Return the kind of motion that leads there and back, and its state at reversal."""
    kind = Kind(BACK[name], None, 1.0, renamed=False)
    low, high = 0.0, 0.5 * END
    probe = Free(kind, END, motor).controller.axes[0]
    reversed_at = next(k for k in range(round(END * 1e3)) if probe.velocity(k * 1e-3) < 0.0)
    low, high = (reversed_at - 1) * 1e-3, reversed_at * 1e-3
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if probe.velocity(middle) < 0.0 else (middle, high)
    free = Free(kind, high, motor)
    free.velocity = -1.0 if free.velocity == 0.0 else free.velocity
    return kind, free


def _reversal_of_path(name: str, action: str, motor: bool) -> tuple[Controller, float, Free, Kind]:
    """Return a case with an active reverse limit, whose path back begins at 60."""
    kind, free = _back(name, motor)
    c = machine(motor)
    limit(c, action, -1).set_active(True)
    kind.begin(c)
    return c, 0.0, free, kind


def limit(c: Controller, action: str, sign: int = +1) -> Limit:
    """Return a limit of axis 0 by a switch, so it has no position of its own."""
    made = Limit(c, 0, sign, LIMIT_FORWARD if sign > 0 else LIMIT_REVERSE, action, True)
    c.axes[0].limits.append(made)
    return made


def soft(c: Controller, action: str, position: float) -> Limit:
    made = Limit(c, 0, +1, SOFT_LIMIT_FORWARD, action)
    c.axes[0].limits.append(made)
    made.set_position(position)
    return made


class Free:
    """The motion without a limit at a time: position, speed, and distance.

    `lines` are the straight paths in progress. Each has the axis's share of a unit of path, the speed, and
    the remaining distance.
    """

    def __init__(self, kind: Kind, time: float, motor: bool, reverses: bool = False) -> None:
        self.controller = c = machine(motor)
        kind.begin(c)
        if reverses and kind.reverse is not None:
            c.clock.advance(kind.moment)
            kind.reverse(c)
        c.clock.advance(time)
        a = c.axes[0]
        self.position, self.velocity = a.position(c.clock.now), a.velocity(c.clock.now)
        run = getattr(a.move.action, "run", None) if a.move is not None else None
        self.moves = a.move is not None
        self.speed = c.path_speed(0)
        self.travelled = run.present.segment.length - run.present.remaining if run is not None else 0.0
        courses = run.courses if run is not None else []
        self.lines: list[tuple[float, float, float]] = [
            (course.segment.entry[course.axes.index(a)], course.speed, course.remaining)
            for course in courses
            if not course.segment.curvature
        ]


def rest(kind: Kind, free: Free, action: str) -> float | None:
    """Return where the axis comes to rest by the rule; None if no limit takes effect."""
    if action in ("ignore", "event"):
        return None
    if action in ("abort", "off"):
        return free.position
    rate = DECEL if action == "stop" else ERROR_DECEL
    if free.lines:
        return free.position + sum(x * min(v * v / (2.0 * rate), left) for x, v, left in free.lines)
    if kind.along is not None and free.speed:
        return kind.along(free.travelled + free.speed**2 / (2.0 * rate))
    return free.position + free.velocity * abs(free.velocity) / (2.0 * rate)


CAUSES = ("met", "already active", "turned into", "placed", "mode", "enabled", "input", "renamed")
WITHOUT_DIRECTION = ("mode", "enabled", "input")


# The motion without a limit does not depend on the limit: each is computed once.
free_at = cache(Free)


@cache
def _midway(kind: Kind, motor: bool) -> tuple[float, Free]:
    """Return a position through which the motion passes, and the motion there."""
    # A position reference is over within a period: its motor passes the position after the command has ended.
    before = free_at(kind, kind.moment if kind.moment > 0.01 else END, motor)
    position = 0.9 * before.controller.position(0)
    probe = machine(motor)
    passed: list[float] = []
    kind.begin(probe)
    probe.watch(0, position, lambda _: passed.append(probe.clock.now))
    probe.clock.advance(END)
    return position, Free(kind, passed[0], motor)


def _met(kind: Kind, action: str, motor: bool) -> tuple[Controller, float, Free]:
    position, free = _midway(kind, motor)
    c = machine(motor)
    soft(c, action, position)
    kind.begin(c)
    return c, 0.0, free


def _already(kind: Kind, action: str, motor: bool) -> tuple[Controller, float, Free]:
    c = machine(motor)
    limit(c, action).set_active(True)
    kind.begin(c)
    return c, 0.0, free_at(kind, 0.0, motor)


@cache
def _at_reversal(kind: Kind, name: str, motor: bool) -> Free:
    """Return the motion at its maximum, where it reverses."""
    own = name in BY_THEMSELVES
    probe = Free(kind, END, motor, reverses=not own)
    a = probe.controller.axes[0]
    # First by milliseconds, then by tenths of one from before the fall.
    after = next(k for k in count() if a.position((k + 1) * 1e-3) < a.position(k * 1e-3))
    top = next(k for k in count(10 * max(after - 1, 0)) if a.position((k + 1) * 1e-4) < a.position(k * 1e-4))
    free = Free(kind, top * 1e-4, motor, reverses=not own)
    # It is at rest there, except for a reference that jumps between velocities.
    free.position, free.speed = a.position(top * 1e-4), 0.0
    free.velocity = a.velocity(top * 1e-4 + 1e-7) if name == "position reference" else 0.0
    return free


def _reversed(kind: Kind, name: str, action: str, motor: bool) -> tuple[Controller, float, Free]:
    """Return a case in which the reverse limit is always active."""
    c = machine(motor)
    limit(c, action, -1).set_active(True)
    kind.begin(c)
    if name not in BY_THEMSELVES and kind.reverse is not None:
        c.clock.advance(kind.moment)
        kind.reverse(c)
    return c, 0.0, _at_reversal(kind, name, motor)


def _at_moment(kind: Kind, cause: str, action: str, motor: bool) -> tuple[Controller, float, Free]:
    c = machine(motor)
    if cause == "placed":
        made = soft(c, action, 1e6)
    elif cause == "renamed":
        made = soft(c, action, 1000.0)
    else:
        made = limit(c, "ignore" if cause == "mode" else action)
        made.enabled = cause != "enabled"
        made.set_active(cause != "input")
    kind.begin(c)
    c.clock.advance(kind.moment)
    shift = 0.0
    if cause == "placed":
        made.set_position(c.position(0) - 1.0)
    elif cause == "mode":
        made.action = action
    elif cause == "enabled":
        made.enabled = True
    elif cause == "input":
        made.set_active(True)
    else:
        shift = 2000.0 - c.position(0)
        c.define_position(0, 2000.0)
    return c, shift, free_at(kind, kind.moment, motor)


def third_of_actions(name: str, cause: str, third: int) -> tuple[str, ...]:
    """Return every third action.

    In each third, any two of motion, cause and action meet.
    """
    return ACTIONS[(list(KINDS).index(name) + CAUSES.index(cause) + third) % 3 :: 3]


@pytest.mark.parametrize("name", KINDS)
@cases("cause", CAUSES)
def test_a_limit_holds(name: str, cause: str) -> None:
    _holds(name, cause, ACTIONS, motor=False)


# The simulation of a motor takes ten times as long.
@pytest.mark.parametrize("third", one_in(3, range(3)))
@pytest.mark.parametrize("name", KINDS)
@cases("cause", CAUSES)
def test_a_limit_holds_a_motor(name: str, cause: str, third: int) -> None:
    _holds(name, cause, third_of_actions(name, cause, third), motor=True)


@pytest.mark.parametrize("causes", [CAUSES, WITHOUT_DIRECTION])
def test_a_third_of_the_actions_still_meets_every_motion_and_every_cause(causes: tuple[str, ...]) -> None:
    chosen = {
        (name, cause, action)
        for name in KINDS
        for cause in causes
        for action in third_of_actions(name, cause, 0)
    }
    assert {(name, action) for name, _, action in chosen} == set(product(KINDS, ACTIONS))
    assert {(cause, action) for _, cause, action in chosen} == set(product(causes, ACTIONS))


def _holds(name: str, cause: str, actions: tuple[str, ...], motor: bool) -> None:
    kind = KINDS[name]
    for action in actions:
        if cause == "renamed" and not kind.renamed:
            with pytest.raises(Rejected):
                _at_moment(kind, cause, action, motor)
            continue
        if cause == "met":
            c, shift, free = _met(kind, action, motor)
        elif cause == "already active":
            c, shift, free = _already(kind, action, motor)
        elif cause == "turned into" and name in BACK:
            c, shift, free, kind = _reversal_of_path(name, action, motor)
        elif cause == "turned into":
            c, shift, free = _reversed(kind, name, action, motor)
        else:
            c, shift, free = _at_moment(kind, cause, action, motor)
        c.clock.advance(END)
        # A homing passes soft limits, and limits do not affect a command that has ended.
        concerned = free.moves and not (name == "home" and cause in SOFT)
        expected = rest(kind, free, action) if concerned else None
        a = c.axes[0]
        if expected is None:
            untouched = free_at(
                kind, END, motor, reverses=cause == "turned into" and name not in BY_THEMSELVES
            )
            assert a.position(END) - shift == pytest.approx(untouched.position, abs=1e-6), action
        else:
            assert a.velocity(END) == 0.0, action
            # A motor is checked once per servo period.
            slack = 2e-3 + (1e-3 * abs(free.velocity) if motor and cause == "met" else 0.0)
            assert a.position(END) - shift == pytest.approx(expected, abs=slack), action
        assert bool(c.faults(0)) is (concerned and action != "ignore"), action
        assert c.is_enabled(0) is not (concerned and action == "off"), action
        if expected is not None:
            assert c.axes[0].move is None, action


def test_every_kind_reverses_or_cannot() -> None:
    assert all(kind.reverse is not None or name in BACK for name, kind in KINDS.items())


# Conditions independent of direction: an error or analogue input, as it comes and as its mode is put in
# force; the drive.
@pytest.mark.parametrize("name", KINDS)
def test_an_error_of_no_direction_holds(name: str) -> None:
    for motor in (False, True):
        for cause in WITHOUT_DIRECTION:
            for action in third_of_actions(name, cause, 0) if motor else ACTIONS:
                kind, c = KINDS[name], machine(motor)
                made = limit(c, "ignore" if cause == "mode" else action, 0)
                made.enabled = cause != "enabled"
                made.set_active(cause != "input")
                kind.begin(c)
                c.clock.advance(kind.moment)
                if cause == "mode":
                    made.action = action
                elif cause == "enabled":
                    made.enabled = True
                else:
                    made.set_active(True)
                free = free_at(kind, kind.moment, motor)
                expected = rest(kind, free, action)
                c.clock.advance(END)
                where = f"{cause}, {action}, {'a motor' if motor else 'none'}"
                assert bool(c.faults(0)) is (action != "ignore"), where
                if expected is not None:
                    assert c.axes[0].position(END) == pytest.approx(expected, abs=2e-3), where
                    assert c.axes[0].velocity(END) == 0.0, where


# A verb that ends a motion, where the axis comes to rest, and how the log calls it.
ENDING = (("stop", "stop", "stop"), ("abort", "abort", "cancel"), ("disable", "abort", "cancel"))
PLAYBACKS, REFUSING = ("spline",), ("cam", "fly")


@pytest.mark.parametrize("name", KINDS)
@cases("verb, action, ended", ENDING)
def test_a_verb_ends_a_motion_and_all_that_waits_behind_it(
    name: str, verb: str, action: str, ended: str
) -> None:
    kind, c = KINDS[name], machine(False)
    kind.begin(c)
    c.clock.advance(kind.moment)
    free = free_at(kind, kind.moment, False)
    expected = rest(kind, free, action)
    if name in PLAYBACKS and verb == "stop":  # its playback slows down linearly within 0.1 s
        expected = free_at(kind, kind.moment + 0.05, False).position
    getattr(c, verb)(0)
    c.clock.advance(END)
    assert c.position(0) == pytest.approx(expected, abs=2e-3)
    assert (c.velocity(0), c.is_idle(0), c.room(0), c.master_of(0)) == (0.0, True, 10, None)
    assert c.target(0) == pytest.approx(c.position(0))
    assert {move.ended for move in c.log.moves if move.axis == 0} <= {ended, "", "blend"}
    assert next(move for move in reversed(c.log.moves) if move.axis == 0).ended == ended
    c.enable(0)
    c.clock.advance(END + 5.0)
    assert c.is_idle(0)


@pytest.mark.parametrize("name", KINDS)
def test_a_suspend_holds_and_lets_go(name: str) -> None:
    """Suspended by keyword or input, the axis stops at DECEL and later continues.

    A table stops in its own time.
    """
    for reason in (BY_WORD, BY_INPUT):
        for motor in (False, True):
            kind, c = KINDS[name], machine(motor)
            kind.begin(c)
            c.clock.advance(kind.moment)
            if name in REFUSING:
                with pytest.raises(Rejected):
                    c.suspend(0, reason)
                continue
            free = free_at(kind, kind.moment, motor)
            expected = rest(kind, free, "stop")
            if name in PLAYBACKS:  # its playback slows down linearly within 0.1 s
                expected = free_at(kind, kind.moment + 0.05, motor).position
            c.suspend(0, reason)
            c.clock.advance(END)
            a = c.axes[0]
            where = f"reason {reason}, {'a motor' if motor else 'none'}"
            assert a.position(END) == pytest.approx(expected, abs=2e-3), where
            assert a.velocity(END) == 0.0, where
            assert c.axes[0].move is not None, where
            c.resume(0, reason)
            c.clock.advance(6.0 * END)
            whole = free_at(kind, 6.0 * END, motor).controller.axes[0]
            if whole.move is None and name != "home":
                assert a.position(6.0 * END) == pytest.approx(whole.position(6.0 * END), abs=1e-5), where
            else:
                assert a.velocity(6.0 * END) == pytest.approx(whole.velocity(6.0 * END), abs=1e-6), where
