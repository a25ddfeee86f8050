"""Motion that begins above its speed: the required deceleration, and bad planners."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from motionlang import run
from motionlang.analysis.proof.segments import Span
from motionlang.analysis.proof.slowing import Slowing, _stretches, slowing
from motionlang.analysis.proof.time_bounds import Law
from motionlang.planners import Profile, plan, plan_velocity
from motionlang.planners.lookahead import Pace, plan_course
from motionlang.result import Run
from motionlang.source import Source

TRAPEZOID = Law((100.0, 100.0))
S_RAMP = Law((100.0, 100.0), (500.0, 500.0))


def test_a_trapezoid_slows_down_at_its_rate() -> None:
    """From 50 to 10 counts/s at 100 counts/s² takes 0.4 s."""
    slow = slowing(-50.0, 0.0, 10.0, TRAPEZOID)
    assert slow.until == pytest.approx(0.4, rel=1e-5)
    assert [slow.expected(time) for time in (0.0, 0.1, 0.3, 0.5)] == pytest.approx([50.0, 40.0, 20.0, 10.0])


def test_an_s_ramp_slows_down_within_its_jerk() -> None:
    """The deceleration rises to 100 in 0.2 s and falls in 0.2 s, 10 counts/s each.

    In between it is 100 for 0.2 s.
    """
    slow = slowing(50.0, 0.0, 10.0, S_RAMP)
    assert slow.until == pytest.approx(0.6, rel=1e-5)
    assert [slow.expected(time) for time in (0.2, 0.4, 0.6)] == pytest.approx([40.0, 20.0, 10.0])


def test_an_acceleration_is_taken_back_first() -> None:
    """100 counts/s² fall to zero in 0.2 s, adding 10 counts/s; 60 to 10 takes 0.7 s."""
    slow = slowing(50.0, 100.0, 10.0, S_RAMP)
    assert (slow.came, slow.eased) == pytest.approx((60.0, 0.2), rel=1e-5)
    assert slow.until == pytest.approx(0.9, rel=1e-5)
    assert [slow.expected(time) for time in (0.2, 0.4)] == pytest.approx([60.0, 50.0])


def test_a_deceleration_that_is_under_way_serves() -> None:
    """It is 100 already: 30 counts/s in 0.3 s, and the last 10 in the final 0.2 s."""
    slow = slowing(50.0, -100.0, 10.0, S_RAMP)
    assert slow.until == pytest.approx(0.5, rel=1e-5)
    assert slow.expected(0.3) == pytest.approx(20.0)


PAIR = Law((100.0, 80.0), (400.0, 200.0))
# The velocity and the acceleration, the law, and the sections of the ramp to 10: their initial accelerations, the
# changes and the times. At a rate of 80 and a jerk of 200 the deceleration rises in 0.4 s.
SECTIONS: dict[str, tuple[float, float, Law, tuple[tuple[float, float, float], ...]]] = {
    "a trapezoid": (50.0, 0.0, Law((100.0, 80.0)), ((-80.0, 0.0, 0.5),)),
    "32 in the flanks, 8 at the rate": (
        50.0, 0.0, PAIR, ((0.0, -80.0, 0.4), (-80.0, 0.0, 0.1), (-80.0, 80.0, 0.4)),
    ),
    "speeding up by 2 first, at the jerk of that": (
        48.0, 40.0, PAIR, ((40.0, -40.0, 0.1), (0.0, -80.0, 0.4), (-80.0, 0.0, 0.1), (-80.0, 80.0, 0.4)),
    ),
    "too little for the rate: 40² / 200": (
        18.0, 0.0, PAIR, ((0.0, -40.0, 0.2), (-40.0, 0.0, 0.0), (-40.0, 40.0, 0.2)),
    ),
    "braking already": (50.0, -40.0, PAIR, ((-40.0, -40.0, 0.2), (-80.0, 0.0, 0.15), (-80.0, 80.0, 0.4))),
    "braking just enough: 40² / (2 * 200)": (
        14.0, -40.0, PAIR, ((-40.0, 0.0, 0.0), (-40.0, 0.0, 0.0), (-40.0, 40.0, 0.2)),
    ),
    "braking too hard for the rest": (13.0, -40.0, PAIR, ((-40.0, 40.0, 0.2),)),
    "braking above the rate": (
        50.0, -100.0, PAIR, ((-100.0, 20.0, 0.1), (-80.0, 0.0, 0.1875), (-80.0, 80.0, 0.4)),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", SECTIONS)
def test_the_sections_of_a_ramp_to_a_lower_speed(name: str) -> None:
    v0, a0, by, sections = SECTIONS[name]
    came = v0 + 0.5 * max(a0, 0.0) ** 2 / 400.0
    assert _stretches(v0, a0, came, 10.0, by) == tuple(pytest.approx(each, abs=1e-12) for each in sections)


def test_the_speed_along_a_ramp_to_a_lower_speed() -> None:
    """From 50: 9 in 0.1 s, 15 at the rate in 0.1875 s, 16 in 0.4 s, first 12 of it."""
    slow = slowing(50.0, -100.0, 10.0, PAIR)
    times = (0.0, 0.1, 0.2, 0.2875, 0.4875, 0.6875, 9.0)
    assert [slow.expected(time) for time in times] == pytest.approx(
        [50.0, 41.0, 33.0, 26.0, 14.0, 10.0, 10.0]
    )
    assert (slow.came, slow.until, slow.eased) == pytest.approx((50.0, 0.6875, 0.5), rel=2e-6)
    assert [slow.bound(time) for time in (0.0, 0.68, 0.69)] == [50.0, 50.0, 10.0]


# The velocity and the acceleration, the law, the later begin of the ramp; and the peak, until when it exceeds 10,
# and until when its acceleration is excused.
SLOWED: dict[str, tuple[float, float, Law, float, tuple[float, float, float], int]] = {
    "slow enough": (10.0, 0.0, PAIR, 0.0, (10.0, 0.0, 0.0), 0),
    "slow enough, braking": (10.0, -20.0, PAIR, 0.0, (10.0, 0.0, 0.1), 0),
    "too fast as it speeds up: by 0.5": (10.0, 20.0, PAIR, 0.0, (10.5, 0.05 + 0.1, 0.1), 4),
    "a ramp that begins later": (50.0, 0.0, Law((100.0, 80.0)), 0.25, (50.0, 0.75, 0.0), 0),
    "a shaped ramp, which may lead to rest": (
        50.0, 0.0, Law((100.0, 80.0), stretch=2.0), 0.0, (50.0, 1.25, 0.0), 0,
    ),
    "an acceleration that a law without jerk does not limit": (
        50.0, -70.0, Law((100.0, 80.0)), 0.0, (50.0, 0.5, 0.0), 1,
    ),
    "20 in the other direction: 100² / 400 - 5": (
        5.0, -100.0, PAIR, 0.0, (20.0, 0.5 + 2.0 * (10.0 / 200.0) ** 0.5, 0.5), 0,
    ),
    "10 in the other direction, and through rest": (
        15.0, -100.0, PAIR, 0.0, (15.0, 0.5 + 2.0 * (10.0 / 200.0) ** 0.5 + 2.0 * (10.0 / 400.0) ** 0.5, 0.5), 1,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", SLOWED)
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_how_long_a_motion_may_exceed_its_speed(name: str, sign: float) -> None:
    """20 is eased in 0.05 s at 400, in 0.1 s at 200; 0.5 takes 2 sqrt(0.5 / 200) s."""
    v0, a0, by, extra, expected, sections = SLOWED[name]
    slow = slowing(sign * v0, sign * a0, 10.0, by, extra)
    assert (slow.v0, slow.speed) == (v0, 10.0)
    assert (slow.came, slow.until, slow.eased) == pytest.approx(expected, rel=2e-6, abs=2e-9)
    assert len(slow.stretches) == sections


def test_segments_are_cut_where_the_excuses_end() -> None:
    """The acceleration is excused for 0.25 s, the speed for 0.5 s."""
    slow = Slowing(50.0, 10.0, 50.0, 0.5, 0.25, ())
    piece = (0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    cuts = {
        (0.0, 1.0): [(0.0, 0.25), (0.25, 0.25), (0.5, 0.5)],
        (0.25, 0.75): [(0.25, 0.25), (0.5, 0.5)],
        (0.375, 0.125): [(0.375, 0.125)],
        (0.0, 0.25): [(0.0, 0.25)],
        (0.5, 0.5): [(0.5, 0.5)],
    }
    found = {each: [(cut.begin, cut.length) for cut in slow.cuts([Span(*each, piece)])] for each in cuts}
    assert found == cuts
    assert [slow.expected(time) for time in (0.0, 0.5, 0.75)] == [50.0, 10.0, 10.0]


SETTINGS = "SPEED(0) = 50 : ACCEL(0) = 100 : DECEL(0) = 100 : FEEDRATEMODE(0) = 2\n"
SMOOTH = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 500 : DECELJERK(0) = 500\n"
MOTIONS = {
    "move": "MOVER(0) = 200 : GO(0)\nWAIT 1500\n{lower}\nPAUSE IDLE(0)\n",
    "jog": "JOG(0) = 50\nWAIT 1500\n{lower}\nWAIT 2000\nSTOP(0)\nPAUSE IDLE(0)\n",
    "path": "VECTORR(0, 1) = 200, 0 : GO(0)\nWAIT 1500\n{lower}\nPAUSE IDLE(0)\n",
    "move that is set again and again": (
        "MOVER(0) = 200 : GO(0)\nWAIT 1500\nDim i As Integer\nFor i = 1 To 40\n  {lower}\n  WAIT 5\n"
        "  {lower}.001\n  WAIT 5\nNext\nSTOP(0)\nPAUSE IDLE(0)\n"
    ),
}  # fmt: skip
LOWER = [
    (motion, word)
    for motion in MOTIONS
    for word in ("SPEED(0) = 10", "FEEDRATEOVERRIDE(0) = 20", "MAXSPEED(0) = 10", "JOG(0) = 10")
    if (motion == "jog") == (word[:3] == "JOG") or (motion, word[:3]) == ("jog", "MAX")
]


def proved(program: str, name: str = "slow.mnt") -> Run:
    result = run(Source(name, program), machine={"controller.instruction_time": 1e-9}, prove=True)
    assert (result.status, result.diagnostics) == ("ended", [])
    return result


def found(result: Run) -> list[str]:
    return [each.message for each in result.proof().violations]


@pytest.fixture
def careless(monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """Return a function that makes planners ignore a lower speed."""

    def move(
        shape: str, start: float, target: float, speed: float, accel: float, decel: float, v0: float = 0.0, *more: float
    ) -> Profile:  # fmt: skip
        return plan(shape, start, target, max(speed, abs(v0)), accel, decel, v0, *more)

    def velocity(shape: str, start: float, v0: float, v1: float, *more: float) -> Profile:
        return plan_velocity(shape, start, v0, v1 if not v1 or v1 > v0 else v0, *more)

    def course(
        stretches: list[tuple[float, Pace]], start: float, v0: float, a0: float = 0.0
    ) -> Profile | None:
        faster = []
        for length, pace in stretches:
            most = max(pace.speed, v0)
            rest = (pace.accel, pace.decel, pace.ramp, pace.accel_jerk, pace.decel_jerk)
            faster.append((length, Pace(pace.shape, most, *rest)))
        return plan_course(faster, start, v0, a0)

    def forge() -> None:
        monkeypatch.setattr("motionlang.planners.plan", move)
        monkeypatch.setattr("motionlang.controller.motion.jog.plan_velocity", velocity)
        monkeypatch.setattr("motionlang.controller.moves.course.plan_course", course)

    return forge


@pytest.mark.parametrize("settings", [SETTINGS, SMOOTH + SETTINGS], ids=["trapezoid", "S-ramp"])
@pytest.mark.parametrize(("motion", "lower"), LOWER)
def test_a_planner_that_ignores_a_lower_speed_is_found(
    motion: str, lower: str, settings: str, careless: Callable[[], None]
) -> None:
    program = settings + MOTIONS[motion].format(lower=lower)
    honest = proved(program)
    assert found(honest) == []
    careless()
    forged = proved(program)
    assert found(forged) != []
    a, b = (result.controller.axes[0].velocity(2.5) for result in (honest, forged))
    if len(MOTIONS[motion]) < 90:
        assert (a, b) == pytest.approx((10.0, 50.0))


def test_velocity_mode_that_ignores_a_lower_velocity_is_found(careless: Callable[[], None]) -> None:
    program = "1MN\n1VM,1SV5000,1SA10000,1DS10000,1GO,WA2,1SV1000,WA2,1ST,1WS0\n"
    assert found(proved(program, "slow.mcl")) == []
    careless()
    assert any(
        "it reaches 5000 counts/s, commanded 1000" in each for each in found(proved(program, "slow.mcl"))
    )


def test_a_stop_on_a_path_that_goes_on_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    program = SETTINGS + "VECTORR(0, 1) = 200, 0 : GO(0)\nWAIT 1500\nSTOP(0)\nPAUSE IDLE(0)\n"
    result = proved(program)
    assert found(result) == []
    assert result.time == pytest.approx(2.0, abs=1e-4)
    monkeypatch.setattr(
        "motionlang.controller.moves.course.Course.braking",
        lambda self, time, decel=None, first=0: self.profile.after(time),
    )
    assert any("the path speed reaches 50, above" in each for each in found(proved(program)))
