"""The table of conditions of a board: motions, causes of limits, modes of LM.

The expected rest position is computed by hand from the same motion without the limit. When the limit becomes
true, the axis is at p with the velocity v. Then it comes to rest at

* p if the motor is switched off or the stop is abrupt (LM 0 and 1, 4 for soft limits, and the amplifier
  input);
* p + v² / 2d if the stop is smooth (LM 2 and 8). There d is DS, or in a contour VD along the path;
* its end without the limit, if the limit does not apply to the motion.
"""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import pytest

from motionlang import Run
from tests.cases import one_in
from tests.mccl_runs import Runner

FINE = {"controller.instruction_time": 1e-9}
MOTOR = {f"axis.{axis}.plant.amplifier": "current" for axis in (1, 2)}
GAINS = ",1SG0.02,1SD0.5,2SG0.02,2SD0.5"
END, MOMENT = 8.0, 1.0
RATE = 100_000.0  # DS, VD
HEAD = "MN,SV20000,SA100000,DS100000,1VV20000,1VA100000,1VD100000,SE0"
# The start of the motion of axis 1 forward, the command that reverses it, the channel of the limit being that
# of axis 1.
KINDS: dict[str, tuple[str, str]] = {
    "position": ("1MR90000", "1MA-20000"),
    "velocity": ("1VM,1DI0,1GO", "1DI1,1GO"),
    "contour": ("1CM1,2CM1,1CP1,1MA60000,2MA80000", ""),
    "contour of another axis": ("1CM2,2CM2,2VV20000,2VA100000,2VD100000,2CP1,1MA60000,2MA80000", ""),
    "gear": ("1SM2,2VM,2DI0,2GO", "2DI1,2GO"),
}
ALONG = {"contour": 0.6, "contour of another axis": 0.6}
HARD = {"off": 0, "abort": 1, "stop": 2}
SOFT = {"off": 0, "abort": 4, "stop": 8}
CAUSES = ("met", "already active", "turned into", "placed", "mode", "enabled", "renamed", "input")
PLUS, MINUS, FAULT = 18, 19, 20  # the channels of axis 1


def cells() -> list[tuple[str, str, bool]]:
    return [(kind, cause, motor) for kind in KINDS for cause in CAUSES for motor in (False, True)]


def program(kind: str, cause: str, action: str, limited: bool) -> tuple[str, dict[str, object], int]:
    """Return a program in which `cause` makes the limit true, its inputs, and a shift.

    The shift is that of the zero, counts.
    """
    begin, reversal = KINDS[kind]
    hard, soft = HARD[action], SOFT[action]
    before, then, shift = "NO", "NO", 0
    inputs: list[dict[str, object]] = []
    if cause == "met":
        before = f"1LM{soft},1HL9000,1LL-900000,1LN12"
    elif cause == "already active":
        before, inputs = f"1LM{hard},1LN1", [{"channel": PLUS, "at": 0.0}]
    elif cause == "turned into":
        before, then, inputs = f"1LM{hard},1LN2", reversal, [{"channel": MINUS, "at": 0.0}]
    elif cause == "placed":
        before, then = f"1LM{soft},1HL900000,1LL-900000,1LN12", "1HL5000"
    elif cause == "mode":  # the switch is always closed, and its polarity is inverted
        before, then = f"1LM{128 + hard},1LN1", f"1LM{hard}"
        inputs = [{"channel": PLUS, "at": 0.0}]
    elif cause == "enabled":
        before, then, inputs = f"1LM{hard}", "1LN1", [{"channel": PLUS, "at": 0.5}]
    elif cause == "renamed":
        before, then, shift = f"1LM{soft},1HL300000,1LL-900000,1LN12", "1DH500000", 500000
    else:
        before, inputs = f"1LM{hard},1LN1", [{"channel": PLUS, "at": MOMENT}]
    if not limited:
        before, inputs = "NO", []
        then = then if cause in ("turned into", "renamed") else "NO"
    return f"{HEAD}\n{before}\n{begin}\nWA{MOMENT},{then},WA{END}", {"input": inputs}, shift


# Motions without a limit, by program and motor: they depend neither on the action nor on most causes.
FREE: dict[tuple[str, bool], Run] = {}


def go_free(mccl: Runner, kind: str, cause: str, action: str, motor: bool) -> Run:
    """Return the run of a case without its limit, once for equal programs."""
    text, nothing, _ = program(kind, cause, action, limited=False)
    if (text, motor) not in FREE:
        FREE[text, motor] = go(mccl, text, nothing, motor)
    return FREE[text, motor]


def go(mccl: Runner, text: str, machine: dict[str, object], motor: bool) -> Run:
    if motor:
        text = text.replace(HEAD, HEAD + GAINS)
    return mccl(text, machine={**FINE, **machine, **(MOTOR if motor else {})}, until=END)


@cache
def moment(free: Run, cause: str) -> float:
    """Return the time at which the limit becomes true, from the motion without it."""
    a = free.controller.axes[1]
    times = [k * 1e-3 for k in range(int(END * 1e3))]
    if cause == "met":
        low, high = next((s, t) for s, t in pairwise(times) if a.at(t).position >= 9000.0)
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if a.at(middle).position < 9000.0 else (low, middle)
        return high
    if cause == "already active":
        return next(t for t in times if a.at(t + 1e-3).velocity > 0.0)
    if cause == "turned into":
        low, high = next((s, t) for s, t in pairwise(times) if a.at(t).velocity < 0.0 <= a.at(s).velocity)
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if a.at(middle).velocity >= 0.0 else (low, middle)
        return low
    return MOMENT


@pytest.mark.parametrize("cell", one_in(3, cells()))
def test_a_limit_holds(cell: tuple[str, str, bool], mccl: Runner) -> None:
    """One in three has each motion, each cause, and both with and without a motor."""
    kind, cause, motor = cell
    if cause == "turned into" and not KINDS[kind][1]:
        return  # without a reversal
    for action in HARD:
        text, machine, shift = program(kind, cause, action, limited=True)
        result = go(mccl, text, machine, motor)
        free = go_free(mccl, kind, cause, action, motor)
        assert result.controller.has_motor(1) is motor
        time = moment(free, cause)
        before = free.controller.axes[1].at(time if cause != "renamed" else time - 1e-6)
        position, velocity = before.position, before.velocity
        if cause in ("already active", "turned into"):
            velocity = 0.0
            position = 0.0 if cause == "already active" else position
        expected = position
        if action == "stop":
            expected += velocity * abs(velocity) / (2.0 * RATE * ALONG.get(kind, 1.0))
        a = result.controller.axes[1]
        assert a.at(END - 0.01).velocity == 0.0, (action, result.diagnostics)
        slack = 50.0 if motor and cause == "met" else 0.5  # a motor is checked once per servo period
        found = a.at(END - 0.01).position - (shift if cause == "renamed" else 0.0)
        named = before.position if cause == "renamed" else 0.0
        assert found + named == pytest.approx(expected, abs=slack), (action, text)
        assert result.controller.faults(1), action
        assert result.controller.is_enabled(1) is (action != "off"), action


def test_no_motion_and_no_cause_is_left_out() -> None:
    kinds, causes, motors = zip(*cells()[::3], strict=True)
    assert (set(kinds), set(causes), set(motors)) == (set(KINDS), set(CAUSES), {False, True})


@pytest.mark.parametrize("kind", KINDS)
def test_the_amplifier_input_switches_the_motor_off(kind: str, mccl: Runner) -> None:
    """The input turns on, is on when FN enables it, or its polarity changes.

    With FF after FN it has no effect.
    """
    begin, _ = KINDS[kind]
    on = {"input": [{"channel": FAULT, "at": 0.5}]}
    for before, then, inputs, time in (
        ("1FN", "NO", {"input": [{"channel": FAULT, "at": 1.0}]}, MOMENT),
        ("NO", "1FN", on, MOMENT),
        (f"CL{FAULT},1FN", f"CH{FAULT}", {"input": [{"channel": FAULT, "at": 0.0}]}, MOMENT),
        ("1FN,1FF", "NO", on, None),
    ):
        text = f"{HEAD}\n{before}\n{begin}\nWA1,{then},WA{END}"
        result = mccl(text, machine={**FINE, **inputs}, until=END)
        free = mccl(f"{HEAD}\nNO\n{begin}\nWA{END}", machine=FINE, until=END)
        expected = free.controller.axes[1].at(END - 0.01 if time is None else time).position
        assert result.controller.axes[1].at(END - 0.01).position == pytest.approx(expected, abs=0.5), (
            before,
            then,
        )
        assert result.controller.is_enabled(1) is (time is None)
