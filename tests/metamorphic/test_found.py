"""Errors found by random jobs: the smallest program for each, with its figures."""

from __future__ import annotations

import pytest

from motionlang.kernel import Run, Source
from tests.proof import prove, run

H = "SPEED(0) = 50 : ACCEL(0) = 100 : DECEL(0) = 200\n"
END = "PAUSE IDLE(0)\nPAUSE IDLE(1)\nPAUSE IDLE(2)\n"


def proved(program: str) -> Run:
    machine = {"controller.instruction_time": 1e-9}
    result = run(Source("found.mnt", program), machine=machine, until=100.0)
    assert [each.message for each in result.diagnostics] == []
    assert [each.message for each in prove(result).violations] == []
    return result


def ends(result: Run, *positions: float) -> None:
    axes = result.controller.axes
    assert [axes[k].position(result.time) for k in range(len(positions))] == pytest.approx(
        positions, abs=1e-6
    )


def test_a_stop_does_not_come_too_fast_into_an_arc_that_is_braked_on_less_hard() -> None:
    """The stop begins 6.1 before an arc on which MAXDECEL allows only 14.

    At 200 it takes 6.25; at 14 it would enter the arc at 48.
    """
    paths = (
        "CONTOURMODE(0) = 1 : MAXDECEL(1) = 20 : MAXACCEL(1) = 20\nVECTORR(0, 1) = 30, 0\n"
        "CIRCLER(0, 1) = 0, 5, 3000\nGO(0)\n"
    )
    result = proved(H + paths + "WAIT 728\nSTOP(0)\n" + END)
    assert result.controller.axes[0].velocity(0.85) < 30.0


def test_a_short_arc_keeps_the_acceleration_of_the_axis_that_only_turns_on_it() -> None:
    """Up to 30 degrees the first axis hardly moves; its acceleration is centripetal."""
    arc = "SPEED(0) = 50 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMAXACCEL(0) = 60\nCIRCLER(0, 1) = -10, 0, 30\nGO(0)\n"
    result = proved(arc + END)
    # Each of the accelerations may have a share of 1 / (1 + cos 30°) of 60, the worst being at 30 degrees.
    share = 60.0 / (1.0 + 0.75**0.5)
    peak = max(abs(result.controller.axes[1].velocity(0.001 * k)) for k in range(round(1000 * result.time)))
    assert (share * 10.0) ** 0.5 * 0.866 <= peak <= (share * 10.0) ** 0.5


def test_a_slave_that_turns_round_to_its_ratio_slows_down_at_decel_and_speeds_up_at_accel() -> None:
    """From -20 to 20 it takes 0.1 s at 200 and 0.4 s at 50."""
    rates = (
        "ACCEL(1) = 50 : DECEL(1) = 200 : SPEED(1) = 50\nMASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0\n"
    )
    program = H + rates + "JOG(0) = 20\nWAIT 500\nJOG(1) = -20\nWAIT 500\nFOLLOWMODE(1) = 1 : FOLLOW(1) = 1\n"
    result = proved(program + "WAIT 499\nPRINT VEL(1) < 20\nWAIT 2\nPRINT VEL(1)\n")
    assert result.output == ["1", "20.0000"]


RAMP = (
    "SPEED(0) = 80 : ACCEL(0) = 400 : DECEL(0) = 250\n"
    "PROFILEMODE(0) = 1 : ACCELJERK(0) = 4000 : DECELJERK(0) = 1500\n"
)
S_CURVE = (
    "SPEED(0) = 20 : ACCEL(0) = 50 : DECEL(0) = 50 : FEEDRATEMODE(0) = 2\n"
    "PROFILEMODE(0) = 1 : ACCELJERK(0) = 400 : DECELJERK(0) = 400\n"
)


@pytest.mark.parametrize("word", ["STOP(0)", "SUSPEND(0) = 1"])
def test_an_s_ramp_that_is_left_fades_at_the_jerk_of_its_own_side(word: str) -> None:
    """0.08 s at a jerk of 4000 lead to the position 0.3413, speed 12.8 and rate 320.

    The rate is zero after 0.08 s, and two ramps at 1500 stop the speed of 25.6.
    """
    result = proved(f"{RAMP}MOVER(0) = 500 : GO(0)\nWAIT 80\n{word}\nWAIT 900\n")
    faded = 0.3413333 + 12.8 * 0.08 + 320 * 0.08**2 / 2 - 4000 * 0.08**3 / 6
    ends(result, faded + 25.6 * (25.6 / 1500) ** 0.5)


@pytest.mark.parametrize("word", ["STOP(0)", "SUSPEND(0) = 1", "FEEDRATEOVERRIDE(0) = 0"])
def test_a_path_that_is_left_in_its_s_ramp_fades_likewise(word: str) -> None:
    """At 0.35 s the rate is 50, which it has reached in 0.125 s.

    It falls to zero in 0.125 s, and then the stop begins.
    """
    mode = "FEEDRATEMODE(0) = 2\n" if "OVERRIDE" in word else ""
    result = proved(
        f"{S_CURVE}{mode}VECTORR(0, 1) = 40, 0 : GO(0)\nWAIT 350\n{word.split(' : ')[-1]}\nWAIT 1500\n"
    )
    ends(result, 8.3125)


def test_a_flying_shear_that_ends_under_an_s_ramp_stops_the_same_whenever_it_began() -> None:
    """The stop begins with the exact acceleration just before the end.

    The master's position has no influence on it.
    """
    jerks = (
        "PROFILEMODE(1) = 1 : ACCELJERK(1) = 7000 : DECELJERK(1) = 6000 : ACCEL(1) = 440 : DECEL(1) = 230\n"
    )
    tie = "MASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0\nMASTERDISTANCE(1) = 36 : FLY(1) = 21 : GO(1)\n"
    jog = "JOG(0) = 55 : PAUSE IDLE(1)\nSTOP(0)\nPAUSE IDLE(0)\n"
    took, begun = [], []
    for wait in range(1, 1000, 97):
        result = proved(f"WAIT {wait}\n" + H + jerks + tie + jog)
        axis = result.controller.axes[1]
        took.append(result.time - wait * 1e-3)
        begun.append(next(p for p in axis.profiles if p.shape == "scurve").at(0.0).acceleration)
    assert took == pytest.approx([took[0]] * len(took), abs=1e-7)
    # 21/36 on average, from 0 to 42/36: at its end 42/36² times the square of the master's velocity of 55.
    assert begun == pytest.approx([42.0 / 36.0**2 * 55.0**2] * len(begun), rel=1e-6)
