"""Joins of profiles: which jumps are within rounding, commanded, or a violation."""

from __future__ import annotations

from math import cos, inf, radians, sin
from types import SimpleNamespace
from typing import Any

from motionlang.commands.prove.checker import Proof
from motionlang.commands.prove.checks import _check_join
from motionlang.commands.prove.order import Order, PathOrder, Tie
from motionlang.kernel.planners import State
from tests.cases import cases

FREE = (inf, inf)


def state(
    position: float = 0.0, velocity: float = 0.0, acceleration: float = 0.0, jerk: float = 0.0
) -> State:
    return State(position, velocity, acceleration, jerk)


def path(angle_into: float, *scales: float) -> PathOrder:
    return PathOrder(
        tuple(range(len(scales))), scales, 0.0, 0, True, (), (0.0, 0.0), 0.0, (), (0, 1), None, FREE, FREE, FREE,
        angle_into,
    )  # fmt: skip


def result(
    orders: tuple[Order, Order],
    axes: list[tuple[State, State]],
    time: float = 0.0,
    data: tuple[float, float] = (0.0, 0.0),
    **fields: Any,
) -> tuple[list[str], list[str]]:
    """Return the violations and exceptions of a join of axis 0."""
    tracks = {
        index: SimpleNamespace(
            index=index,
            starts=[0.0, time],
            profiles=[
                SimpleNamespace(
                    at=lambda _, state=state: state,
                    shape=fields.get("shape", ""),
                    duration=inf,
                    end=0.0,
                    pieced=False,
                )
                for state in states
            ],
            index_at=lambda _: 1,
            feedback=fields.get("feedback"),
        )
        for index, states in enumerate(axes)
    }
    expected = SimpleNamespace(
        of={0: orders}, data={0: data}, standstills=fields.get("standstills", frozenset())
    )
    run: Any = SimpleNamespace(axes=tracks, expected_motion=expected, members=fields.get("members"))
    proof, a = Proof(), tracks[0]
    _check_join(proof, run, a, 1)  # type: ignore[arg-type]
    assert proof.counts["joins"] == 1
    where = f"axis 0 at {time:.6f} s: "
    assert all(each.message.startswith(where) for each in proof.violations)
    return [f"{each.line}: {each.message.removeprefix(where)}" for each in proof.violations], list(
        proof.exceptions
    )


MOVE, REST, JOG = Order("move", 3), Order("rest", 0), Order("jog", 4)
# The states on both sides, the time, and the violations.
POSITIONS: list[tuple[State, State, float, list[str]]] = [
    (state(10.0), state(10.0 + 0.9e-6), 0.0, []),
    (state(10.0), state(10.0 - 1.1e-6), 0.0, ["the position jumps by 1.1e-06 counts"]),
    # A millionth of a millionth of the position, if that is more than a millionth of a count.
    (state(3e6), state(3e6 + 2.9e-6), 0.0, []),
    (state(-3e6), state(-3e6 - 2.0**-18), 0.0, ["the position jumps by 3.8147e-06 counts"]),
    # Four roundings of the time, 4e-16 of 1e9 s and one more, at 100 counts/s: 160 µ; and the millionth.
    (state(0.0, 100.0), state(0.000_160_9, 100.0), 1e9, []),
    (state(0.0, 100.0), state(0.000_161_1, 100.0), 1e9, ["the position jumps by 0.0001611 counts"]),
    (state(0.0, -1e9), state(1.000_002_5, -1e9), 0.0, ["the position jumps by 1 counts"]),
    (state(0.0, -1e10), state(0.000_016_9, -1e10), 0.0, []),
    (state(0.0, -1e10), state(0.000_017_1, -1e10), 0.0, ["the position jumps by 1.71e-05 counts"]),
    # Velocities agree to a millionth of the larger one, and of 1 count/s.
    (state(0.0, 0.5), state(0.0, 0.5 + 0.9e-6), 0.0, []),
    (state(0.0, 0.5), state(0.0, 0.5 + 1.1e-6), 0.0, ["the velocity jumps by 1.1e-06 counts/s"]),
    (state(0.0, -900.0), state(0.0, -900.0009), 0.0, []),
    (state(0.0, -900.0), state(0.0, -900.00091), 0.0, ["the velocity jumps by 0.00091 counts/s"]),
    (state(0.0, 900.00091), state(0.0, 900.0), 0.0, ["the velocity jumps by 0.00091 counts/s"]),
    (state(0.0, 1.0, -100.0), state(0.0, 1.000_160_9), 1e9, []),
    (state(0.0, 1.0, -100.0), state(0.0, 1.000_161_1), 1e9, ["the velocity jumps by 0.0001611 counts/s"]),
]


@cases("before, after, time, expected", POSITIONS)
def test_position_and_velocity_continue_to_within_rounding(
    before: State, after: State, time: float, expected: list[str]
) -> None:
    assert result((REST, MOVE), [(before, after)], time) == ([f"3: {each}" for each in expected], [])


NEW_ZERO = "a position set to a new value"
IMMEDIATE = "an immediate stop: cancelled, disabled, or at a limit"
ACTION = "{}: a table or a reference of the program"
STEPPED = "a step of a stepper that starts or stops at once"
MASTER: Any = None
TIED = Order("FOLLOW", 5, tie=Tie(MASTER, 2.0, ramp=True))
SLOWER = Order("FOLLOW", 6, tie=Tie(MASTER, 1.0, ramp=True))
AT_ONCE = Order("FOLLOW", 6, tie=Tie(MASTER, 1.0))
STILL, FAST = state(), state(0.0, 8.0)
# Orders, states, other fields of the run; the violations and the exceptions.
JUMPS: dict[str, tuple[tuple[Order, Order], tuple[State, State], dict[str, Any], list[str], list[str]]] = {
    "a new zero": ((MOVE, REST), (state(5.0), state(12.0)), {"data": (1.0, 8.0)}, [], [NEW_ZERO]),
    "another position than the new zero": (
        (MOVE, REST), (state(5.0), state(13.0)), {"data": (1.0, 8.0)},
        ["3: the position jumps by 1 counts"], [NEW_ZERO],
    ),
    "a motor that is enabled": (
        (MOVE, REST), (state(5.0), state(7.0)), {"feedback": 1}, [], ["a demand set to the motor position"],
    ),
    "no motor": ((MOVE, REST), (state(5.0), state(7.0)), {}, ["3: the position jumps by 2 counts"], []),
    "a motor that is to move": (
        (REST, MOVE), (state(5.0), state(7.0)), {"feedback": 1}, ["3: the position jumps by 2 counts"], [],
    ),
    "a motor at a speed": (
        (MOVE, REST), (state(5.0, 8.0), state(7.0, 8.0)), {"feedback": 1}, ["3: the position jumps by 2 counts"], [],
    ),
    "cancelled": ((MOVE, REST), (FAST, STILL), {"standstills": {(0, 0.0)}}, [], [IMMEDIATE]),
    "another axis is cancelled": (
        (MOVE, REST), (FAST, STILL), {"standstills": {(1, 0.0)}}, ["3: the velocity jumps by 8 counts/s"], [],
    ),
    "cancelled at another time": (
        (MOVE, REST), (FAST, STILL), {"standstills": {(0, 1.0)}}, ["3: the velocity jumps by 8 counts/s"], [],
    ),
    # The steps of both sides add up.
    "a stepper": ((Order("step", 3, step=5.0), Order("step", 4, step=3.0)), (FAST, STILL), {}, [], [STEPPED]),
    "a stepper that is too fast": (
        (Order("step", 3, step=5.0), Order("step", 4, step=2.9)), (FAST, STILL), {},
        ["4: the velocity jumps by 8 counts/s"], [],
    ),
    "rounded": ((Order("step", 3, step=8.0 - 7e-6), MOVE), (FAST, STILL), {}, [], [STEPPED]),
    # A slave takes up a ratio by a ramp. It is moved at once by a table, or by a ratio without one.
    "a ramp to a ratio": ((REST, TIED), (STILL, FAST), {}, ["5: the velocity jumps by 8 counts/s"], []),
    "a ramp to another ratio": ((TIED, SLOWER), (STILL, FAST), {}, ["6: the velocity jumps by 8 counts/s"], []),
    "the same ratio": (
        (TIED, TIED), (STILL, FAST), {}, [], ["FOLLOW: a jump of its master or in its table"],
    ),
    "a ratio at once": ((TIED, AT_ONCE), (STILL, FAST), {}, [], ["FOLLOW: a new ratio at once"]),
    "engaged at once": ((REST, AT_ONCE), (STILL, FAST), {}, [], ["FOLLOW engaged at once"]),
    "the end of a table": (
        (Order("CAM", 3), MOVE), (FAST, STILL), {}, [], [ACTION.format("CAM")],
    ),
    "from one action to another": (
        (Order("CAM", 3), Order("FLY", 4)), (FAST, STILL), {}, [],
        [ACTION.format("FLY")],
    ),
    "two planned motions": ((JOG, MOVE), (FAST, STILL), {}, ["3: the velocity jumps by 8 counts/s"], []),
}  # fmt: skip


@cases("name", JUMPS)
def test_a_jump_needs_a_command(name: str) -> None:
    orders, states, fields, violations, exceptions = JUMPS[name]
    assert result(orders, [states], **fields) == (violations, exceptions)


# Two axes at 10 units/s turn by an angle; axis 1 has 4 counts per unit.
def turned(angle: float, speed: float = 10.0) -> tuple[State, State]:
    """Return the states of both axes at an angle from axis 0."""
    x, y = cos(radians(angle)), sin(radians(angle))
    return state(0.0, speed * x), state(0.0, speed * y * 4.0)


# The angles before and after, the speed after, the allowed angle; true if it is an exception.
KINKS: list[tuple[float, float, float, float, bool]] = [
    (0.0, 30.0, 10.0, 30.0, True),
    (0.0, 30.0, 10.0, 29.9, False),
    (20.0, 50.0, 10.0, 30.0, True),
    (20.0, 50.0, 10.0, 29.9, False),
    (0.0, 120.0, 10.0, 120.0, True),
    (0.0, 120.0, 10.0, 119.9, False),
    (50.0, 170.0, 10.0, 120.0, True),
    (45.0, 45.01, 10.0, 0.01, True),
    (45.0, 45.01, 10.0, 0.009, False),
    # It keeps its speed to a millionth.
    (0.0, 30.0, 10.000_009, 30.0, True),
    (0.0, 30.0, 10.000_011, 30.0, False),
    (0.0, 30.0, 9.0, 30.0, False),
]


@cases("before, after, speed, allowed, is_excused", KINKS)
def test_a_path_may_turn_by_the_contour_angle(
    before: float, after: float, speed: float, allowed: float, is_excused: bool
) -> None:
    old, new = turned(before), turned(after, speed)
    order = Order("path", 7, path=path(allowed, 1.0, 4.0))
    violations, exceptions = result((order, order), [(old[0], new[0]), (old[1], new[1])])
    jump = abs(new[0].velocity - old[0].velocity)
    assert (violations, exceptions) == (
        ([], ["a kink within CONTOURANGLE"])
        if is_excused
        else ([f"7: the velocity jumps by {jump:g} counts/s"], [])
    )


SMOOTH = Order("move", 3, rates=(200.0, 100.0), jerks=(1000.0, 2000.0))
WAVED = Order("move", 3, rates=(0.5, 0.5), shape="scurve")
PLAIN = Order("move", 3, rates=(200.0, 100.0))
# Orders, states, the time, and the violations.
BENDS: list[tuple[tuple[Order, Order], State, State, float, list[str]]] = [
    # A millionth of the larger rate, and of 1 count/s².
    ((SMOOTH, SMOOTH), state(0.0, 5.0, 10.0), state(0.0, 5.0, 10.000_199), 0.0, []),
    ((SMOOTH, SMOOTH), state(0.0, 5.0, 10.0), state(0.0, 5.0, 10.000_201), 0.0, ["0.000201"]),
    ((WAVED, WAVED), state(0.0, 5.0, 10.0), state(0.0, 5.0, 10.000_000_9), 0.0, []),
    ((WAVED, WAVED), state(0.0, 5.0, 10.0), state(0.0, 5.0, 9.999_998_9), 0.0, ["1.1e-06"]),
    # Four roundings of the time, 1.6 µs, at the larger jerk, or that of the profile.
    ((SMOOTH, SMOOTH), state(0.0, 5.0, 10.0), state(0.0, 5.0, 10.0033), 1e9, []),
    ((SMOOTH, SMOOTH), state(0.0, 5.0, 10.0), state(0.0, 5.0, 10.0035), 1e9, ["0.0035"]),
    ((WAVED, WAVED), state(0.0, 5.0, 10.0, -1000.0), state(0.0, 5.0, 10.0016), 1e9, []),
    ((WAVED, WAVED), state(0.0, 5.0, 10.0, -1000.0), state(0.0, 5.0, 10.0017), 1e9, ["0.0017"]),
    # From rest, but not at trapezoids or actions.
    ((REST._replace(jerks=(1.0, 1.0)), SMOOTH), state(), state(0.0, 0.0, 7.0), 0.0, ["7"]),
    ((REST, SMOOTH), state(), state(0.0, 0.0, 7.0), 0.0, []),
    ((PLAIN, SMOOTH), state(), state(0.0, 0.0, 7.0), 0.0, []),
    ((SMOOTH, PLAIN), state(), state(0.0, 0.0, 7.0), 0.0, []),
    ((SMOOTH, Order("CAM", 3, jerks=(1.0, 1.0))), state(), state(0.0, 0.0, 7.0), 0.0, []),
    ((Order("CAM", 3, jerks=(1.0, 1.0)), SMOOTH), state(), state(0.0, 0.0, 7.0), 0.0, []),
]


@cases("orders, before, after, time, expected", BENDS)
def test_the_acceleration_of_an_s_ramp_continues(
    orders: tuple[Order, Order], before: State, after: State, time: float, expected: list[str]
) -> None:
    found, exceptions = result(orders, [(before, after)], time)
    assert (found, exceptions) == (
        [f"3: the acceleration of an S-ramp jumps by {each} counts/s²" for each in expected],
        [],
    )


# The accelerations of both axes before and after, along a path at 45°, and the jump along the path.
PATH_BENDS: list[tuple[tuple[float, float], tuple[float, float], float, list[str]]] = [
    ((10.0, 40.0), (10.0, 40.0), 10.0, []),
    ((10.0, 40.0), (30.0, 120.0), 10.0, ["28.2843"]),
    ((10.0, 40.0), (-10.0, 40.0), 10.0, ["14.1421"]),
    ((10.0, 40.0), (20.0, 0.0), 10.0, []),  # the direction of an arc changes, not its speed
    ((10.0, 40.0), (30.0, 120.0), 0.9e-6, []),  # practically at rest it has no direction
]


@cases("before, after, speed, expected", PATH_BENDS)
def test_the_acceleration_along_a_path_continues(
    before: tuple[float, float], after: tuple[float, float], speed: float, expected: list[str]
) -> None:
    """The component at 45° is (x + y / 4) / √2, as axis 1 has 4 counts per unit."""
    velocities = [each.velocity for each in turned(45.0, speed)]
    axes = [
        (state(0.0, velocity, old), state(0.0, velocity, new))
        for velocity, old, new in zip(velocities, before, after, strict=True)
    ]
    order = Order("path", 7, rates=(10.0, 10.0), jerks=(10.0, 10.0), path=path(0.0, 1.0, 4.0))
    assert result((order, order), axes) == (
        [f"7: the acceleration along the path jumps by {each}" for each in expected],
        [],
    )


class Blended:
    """Two paths from 0 s and from 2 s on, and a third one that is blended with both."""

    def __init__(self, angle: float, end: float = 2.0, begun: float = 2.0, other: float = 1.0) -> None:
        """Let the paths meet at an angle, where the third one changes its velocity."""
        first, second = path(30.0, 1.0, 4.0), path(30.0, 1.0, 4.0)._replace(begun=begun, nth=1)
        old, new = turned(0.0), turned(angle)
        self.orders = Order("path", 6, path=first), Order("path", 7, path=second)
        self.entries = {
            0: [self.entry(each, end) for each in old],
            1: [self.entry(each, 9.0) for each in new],
        }
        third = turned(90.0, 5.0)[1].velocity
        self.axes = [
            (old[0], new[0]),
            (state(0.0, old[1].velocity + third), state(0.0, new[1].velocity + third * other)),
        ]

    def entry(self, moving: State, duration: float) -> Any:
        """Return the entry of an axis, which is at rest at its end itself."""
        profile = SimpleNamespace(at=lambda time: moving if time < duration else STILL, duration=duration)
        return SimpleNamespace(profile=profile)

    def result(self, **fields: Any) -> tuple[list[str], list[str]]:
        given = {"shape": "blend", "members": lambda path: self.entries[path.nth], **fields}
        return result(self.orders, self.axes, 2.0, **given)


KINK = ["a kink within CONTOURANGLE"]


def test_paths_that_are_blended_with_a_third_one_meet_at_their_own_angle() -> None:
    """They meet at 30°. The sum with the third path has another angle.

    Axis 0 is at 10 counts/s before, and at 10 cos 30° = 8.66 after.
    """
    jump = ["7: the velocity jumps by 1.33975 counts/s"]
    assert Blended(30.0).result() == ([], KINK)
    assert Blended(30.1).result() == (["7: the velocity jumps by 1.34849 counts/s"], [])
    # Not if nothing is blended, or the first path did not end there.
    assert Blended(30.0).result(shape="") == (jump, [])
    assert Blended(30.0, end=1.9).result() == (jump, [])
    assert Blended(30.0, begun=2.1).result() == (jump, [])
    assert Blended(30.0).result(members=lambda path: []) == (jump, [])
    # Just at its end, by rounding.
    assert Blended(30.0, begun=2.0 + 8e-16).result() == ([], KINK)


def test_a_third_path_that_jumps_is_no_kink() -> None:
    """Both the paths and the third one add 5 units/s of 4 counts."""
    made = Blended(30.0, other=2.0)
    made.axes.reverse()
    for k in (0, 1):
        made.entries[k].reverse()
    first, second = (path(30.0, 4.0, 1.0)._replace(begun=2.0 * nth, nth=nth) for nth in (0, 1))
    made.orders = made.orders[0]._replace(path=first), made.orders[1]._replace(path=second)
    assert made.result() == (["7: the velocity jumps by 40 counts/s"], [])
