"""Writing the current value of a setting or command changes no motion.

Machine programs write JOG, SPEED or FEEDRATEOVERRIDE in every iteration of a loop, whether or not a button
changed.
"""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from motionlang import run
from motionlang.kernel import Run, Source
from tests.cases import cases

RATES = "SPEED(0, 1) = 100; : ACCEL(0, 1) = 200; : DECEL(0, 1) = 300;\n"
S_RAMP = RATES + "PROFILEMODE(0, 1) = 1; : ACCELJERK(0, 1) = 900; : DECELJERK(0, 1) = 700;\n"
MOVE = "FEEDRATEMODE(0) = 2 : FEEDRATEOVERRIDE(0) = 80\nMOVER(0) = 100 : GO(0)\n"
FOLLOW = "MASTERCHANNEL(1) = 0 : FOLLOWMODE(1) = 1 : JOG(0) = 90\n"
TIMES = "SPEED(0) = 100 : ACCELTIME(0) = 500 : DECELTIME(0) = 400\n"
# The command that starts the axis, and the one that is repeated.
CASES = {
    "JOG": ("JOG(0) = 100\n", "JOG(0) = 100"),
    "JOG reverse": ("JOG(0) = -100\n", "JOG(0) = -100"),
    "JOG to rest": ("JOG(0) = 100\nWAIT = 700\nJOG(0) = 0\n", "JOG(0) = 0"),
    "JOG above MAXSPEED": ("MAXSPEED(0) = 60\nJOG(0) = 100\n", "JOG(0) = 100"),
    "SPEED": (MOVE, "SPEED(0) = 100"),
    "FEEDRATE": (MOVE, "FEEDRATE(0) = 100"),
    "ACCEL": (MOVE, "ACCEL(0) = 200 : DECEL(0) = 300"),
    "ACCELTIME": (TIMES + MOVE, "ACCELTIME(0) = 500 : DECELTIME(0) = 400"),
    "FEEDRATEOVERRIDE": (MOVE, "FEEDRATEOVERRIDE(0) = 80"),
    "FEEDRATEOVERRIDE 0": (MOVE + "WAIT = 200\nFEEDRATEOVERRIDE(0) = 0\n", "FEEDRATEOVERRIDE(0) = 0"),
    "FEEDRATEMODE": (MOVE, "FEEDRATEMODE(0) = 2"),
    "INCA": ("INCA(0) = 100\n", "INCA(0) = 100"),
    "INCR 0": ("INCA(0) = 100\n", "INCR(0) = 0"),
    "SUSPEND": (MOVE + "WAIT = 200\nSUSPEND(0) = 1\n", "SUSPEND(0) = 1"),
    "STOP": (MOVE + "WAIT = 200\nSTOP(0)\n", "STOP(0)"),
    "a path": ("VECTORR(0, 1) = 60, 80 : GO(0)\n", "SPEED(0) = 100 : ACCEL(0) = 200"),
    "FOLLOW": (FOLLOW + "FOLLOW(1) = 0.5\n", "FOLLOW(1) = 0.5"),
    "FOLLOWDENOM": (FOLLOW + "FOLLOWDENOM(1) = 4\nFOLLOW(1) = 2\n", "FOLLOWDENOM(1) = 4"),
    "AUXENCODERSPEED": (
        "AUXENCODERMODE(0) = 8 : AUXENCODERSPEED(0) = 50 : MASTERSOURCE(0) = _msAUXENCODER\nFOLLOW(0) = 1\n",
        "AUXENCODERMODE(0) = 8 : AUXENCODERSPEED(0) = 50",
    ),
    "DRIVEENABLE": (MOVE, "DRIVEENABLE(0) = 1"),
    "GO": (MOVE, "GO(0)"),
    "ramps": (MOVE, "ACCELJERK(0) = ACCELJERK(0) : PROFILEMODE(0) = PROFILEMODE(0) : ERRORDECEL(0) = 100000"),
    "limits": ("MAXSPEED(0) = 90 : MAXACCEL(0) = 150\n" + MOVE, "MAXSPEED(0) = 90 : MAXACCEL(0) = 150"),
    "scale": ("SCALEFACTOR(0) = 4\n" + MOVE, "SCALEFACTOR(0) = 4 : POSWRAP(0) = 0"),
    "modes": (MOVE, "STOPMODE(0) = 0 : IDLEMODE(0) = 0 : LIMITMODE(0) = 1 : TRIGGERMODE(0) = 1"),
    "POS at rest": ("POS(0) = 5\n", "POS(0) = 5"),
    "POS in motion": (MOVE + "WAIT = 200\n", "POS(0) = POS(0)"),
    "HTA": ("HTACHANNEL(0) = 1 : HTAKPROP(0) = 1\nHTA(0) = 20\n", "HTA(0) = 20 : HTAKPROP(0) = 1"),
}


def track(text: str) -> tuple[Run, Sequence[object]]:
    result = run(Source("a.mnt", text), until=4.0)
    assert [each.message for each in result.diagnostics] == []
    made = [
        (start, profile.knots, profile.pieces)
        for number in (0, 1)
        for start, profile in zip(
            result.controller.axes[number].starts, result.controller.axes[number].profiles, strict=True
        )
    ]
    return result, made


@pytest.mark.parametrize("ramps", [RATES, S_RAMP], ids=["trapezoid", "s-ramp"])
@pytest.mark.parametrize("case", CASES)
def test_what_is_in_force_already_changes_nothing(case: str, ramps: str) -> None:
    motion, again = CASES[case]
    once, before = track(ramps + motion)
    often, after = track(ramps + motion + f"For i = 1 To 40\n{again}\nWAIT = 23.7\nNext")
    assert after == before
    assert len(often.controller.log.moves) == len(once.controller.log.moves)


@cases(
    ("motion", "other"),
    [
        ("JOG(0) = 100\n", "JOG(0) = 101"),
        ("JOG(0) = 100\n", "ACCEL(0) = 500 : JOG(0) = 100"),
        ("JOG(0) = 100\n", "MAXSPEED(0) = 50 : JOG(0) = 100"),
        (MOVE, "SPEED(0) = 90"),
        (MOVE, "FEEDRATEMODE(0) = 0"),
        (FOLLOW + "FOLLOW(1) = 0.5\n", "FOLLOW(1) = 0.25"),
    ],
)
def test_another_value_does(motion: str, other: str) -> None:
    assert track(RATES + motion + f"WAIT = 50\n{other}")[1] != track(RATES + motion + "WAIT = 50")[1]
