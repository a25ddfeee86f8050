"""Motion that begins above its speed: the required deceleration, and bad planners."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from motionlang import run
from motionlang.analysis.proof.slowing import slowing
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
    result = run(
        Source(name, program), machine={"controller.instruction_time": 1e-9}, cache=False, prove=True
    )
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
