"""Every motion, every cause of a limit, every mode: where the axis comes to rest.

The expected position follows from the same program without the limit. When the limit becomes true, the axis is at p
with the velocity v, on a path whose speed is s. Then it comes to rest at

* p for a crash stop, with or without switching the drive off;
* p + v s / 2d for a stop at the rate d, and on an arc as much further along it;
* its end without the limit, if the mode ignores it or only reports it.
"""

from __future__ import annotations

from functools import cache
from math import acos, cos, hypot

import pytest

from motionlang import Run, run
from motionlang.kernel import Source
from tests.cases import cases, one_in

DECEL, ERROR_DECEL, RADIUS = 200.0, 400.0, 30.0
END = 6.0
HEAD = """\
Dim c(5) As Float = 4, 10, 10, -10, -10
Dim s(3) As Float = 2, 40, 0
SPEED(0, 1) = 50; : ACCEL(0, 1) = 100; : DECEL(0, 1) = 200; : ERRORDECEL(0, 1) = 400; : MOVEBUFFERSIZE(0, 1) = 9;
MASTERCHANNEL(0) = 1
"""
HANDLER = "End\nEvent ONERROR\nEnd Event\n"
MOTOR: dict[str, object] = {
    "axis.0.plant.amplifier": "current", "axis.0.servo.proportional": 0.02, "axis.0.servo.derivative": 0.5,
}  # fmt: skip
# The statements of each motion, and when it is fast, ms.
MOTIONS: dict[str, tuple[str, int]] = {
    "move": ("MOVEA(0) = 80 : GO(0)", 1000),
    "buffered": ("MOVER(0) = 20 : MOVER(0) = 20 : MOVER(0) = 20 : GO(0)", 300),
    "jog": ("JOG(0) = 20", 1000),
    "path": ("VECTORA(0, 1) = 60, 80 : GO(0)", 1000),
    "path of another axis": ("VECTORA(1, 0) = 80, 60 : GO(1)", 1000),
    "contour": ("CONTOURMODE(0) = 1 : VECTORA(0, 1) = 60, 80 : VECTORA(0, 1) = 90, 120 : GO(0)", 1000),
    "arc": ("CIRCLER(0, 1) = 30, 0, 180 : GO(0)", 1000),
    "slave": ("FOLLOW(0) = 1 : JOG(1) = 20", 1000),
    "cam": ("CAMTABLE(0, c) : MASTERDISTANCE(0) = 10 : CAM(0) = 0 : GO(0) : JOG(1) = 10", 900),
    "shear": ("MASTERDISTANCE(0) = 100 : FLY(0) = 100 : GO(0) : JOG(1) = 20", 1000),
    "offset": ("FOLLOW(0) = 1 : OFFSET(0) = 60 : GO(0)", 1000),
}
MODES = {0: "ignore", 1: "crash stop", 2: "crash stop, drive off", 3: "stop", 5: "report"}
# What the program does when the motion is fast, after which settings, and when the input comes, s.
CAUSES: dict[str, tuple[str, str, float | None]] = {
    "met": ("SOFTLIMITFORWARD(0) = {position} : SOFTLIMITMODE(0) = {mode}", "", None),
    "placed behind": ("SOFTLIMITMODE(0) = {mode}", "SOFTLIMITFORWARD(0) = POS(0) - 1", None),
    "mode": ("SOFTLIMITFORWARD(0) = 1 : SOFTLIMITMODE(0) = 0", "SOFTLIMITMODE(0) = {mode}", None),
    "mode of a switch": ("LIMITMODE(0) = 0", "LIMITMODE(0) = {mode}", 0.0),
    "switch": ("LIMITMODE(0) = {mode}", "", 1.0),
    "error input": ("ERRORINPUTMODE(0) = {mode}", "", 1.0),
    "mode of the error input": ("ERRORINPUTMODE(0) = 0", "ERRORINPUTMODE(0) = {mode}", 0.0),
}


def ran(
    name: str, before: str, then: str, channel: int = 0, at: float | None = None, motor: bool = False
) -> Run:
    """Return the run of a motion with settings before it and statements when it is fast."""
    statements, moment = MOTIONS[name]
    wired = f"{'ERRORINPUT' if channel == 2 else 'LIMITFORWARDINPUT'}(0) = {channel}\n" if channel else ""
    text = f"{HEAD}{before}\n{wired}{statements}\nWAIT {moment}\n{then}\nWAIT 9000\n{HANDLER}"
    machine: dict[str, object] = {"controller.instruction_time": 1e-9, **(MOTOR if motor else {})}
    if at is not None:
        machine["input"] = [{"channel": channel, "at": at * moment / 1000}]
    result = run(Source("a.mnt", text), machine=machine, until=END)
    assert [each.message for each in result.diagnostics if each.severity == "error"] == []
    return result


@cache
def free(name: str) -> Run:
    """Return the motion without a limit."""
    return ran(name, "", "")


def rest(name: str, time: float, rate: float) -> float:
    """Return where the axis comes to rest if it is stopped at a time; at once for the rate 0."""
    axes = free(name).controller.axes
    position, speeds = axes[0].position(time), [axes[k].velocity(time) for k in (0, 1)]
    speed = hypot(*speeds) if name in ("path", "path of another axis", "contour", "arc") else abs(speeds[0])
    if not rate:
        return position
    if name == "arc":
        return RADIUS * (1.0 - cos(acos(1.0 - position / RADIUS) + speed**2 / (2.0 * rate) / RADIUS))
    return position + speeds[0] * speed / (2.0 * rate)


def passes(name: str, position: float) -> float:
    """Return when the motion passes a position."""
    axis, low, high = free(name).controller.axes[0], 0.0, MOTIONS[name][1] / 1000.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if axis.position(middle) > position else (middle, high)
    return high


def check(name: str, cause: str, mode: int, motor: bool = False) -> None:
    before, then, at = CAUSES[cause]
    moment = MOTIONS[name][1] / 1000.0
    position = 0.9 * free(name).controller.axes[0].position(moment)
    values = {"position": repr(position), "mode": mode}
    channel = 2 if "error" in cause else 1
    result = ran(name, before.format(**values), then.format(**values), channel, at, motor)
    axis = result.controller.axes[0]
    acts = MODES[mode] not in ("ignore", "report")
    time = passes(name, position) if cause == "met" else moment
    rate = ERROR_DECEL if MODES[mode] == "stop" else 0.0
    expected = rest(name, time, rate) if acts else free(name).controller.axes[0].position(END)
    # A motor is checked once per servo period.
    slack = 1e-3 * abs(free(name).controller.axes[0].velocity(time)) if motor and cause == "met" else 0.0
    assert axis.position(END) == pytest.approx(expected, abs=2e-3 + slack), (cause, mode)
    assert (axis.velocity(END) == 0.0) or not acts, (cause, mode)
    assert bool(result.controller.faults(0)) is (mode != 0), (cause, mode)
    assert result.controller.is_enabled(0) is (mode != 2), (cause, mode)


@pytest.mark.parametrize("name", MOTIONS)
def test_a_limit_holds_every_motion(name: str) -> None:
    for cause in CAUSES:
        for mode in MODES:
            check(name, cause, mode)


@pytest.mark.parametrize("name", one_in(3, list(MOTIONS)))
def test_a_limit_holds_a_motor(name: str) -> None:
    """The simulation of a motor takes ten times as long: each cause has one mode."""
    for number, cause in enumerate(CAUSES):
        check(name, cause, (1, 2, 3)[(number + list(MOTIONS).index(name)) % 3], motor=True)


@cases(
    "statement, rate, ended",
    [("STOP(0)", DECEL, "stop"), ("CANCEL(0)", 0.0, "cancel"), ("DRIVEENABLE(0) = 0", 0.0, "cancel")],
)
def test_a_statement_ends_a_motion_and_all_that_waits_behind_it(
    statement: str, rate: float, ended: str
) -> None:
    for name, (_, moment) in MOTIONS.items():
        result = ran(name, "", statement)
        assert result.controller.position(0) == pytest.approx(rest(name, moment / 1000, rate), abs=2e-3), name
        assert (result.controller.velocity(0), result.controller.is_idle(0)) == (0.0, True), name
        assert next(move for move in reversed(result.machine.log.moves) if move.axis == 0).ended == ended, (
            name
        )


def test_a_suspension_holds_and_lets_go() -> None:
    """A cam and a shear refuse it; the others stop at DECEL and go on to the same end or velocity."""
    for name, (_, moment) in MOTIONS.items():
        if name in ("cam", "shear"):
            continue
        held = ran(name, "", "SUSPEND(0) = 1").controller
        assert held.position(0) == pytest.approx(rest(name, moment / 1000, DECEL), abs=2e-3), name
        assert (held.velocity(0), held.is_idle(0)) == (0.0, False), name
        released = ran(name, "", "SUSPEND(0) = 1 : WAIT 500 : SUSPEND(0) = 0").controller
        whole = free(name).controller
        assert released.velocity(0) == pytest.approx(whole.velocity(0), abs=1e-6), name
        if whole.is_idle(0):
            assert released.position(0) == pytest.approx(whole.position(0), abs=1e-6), name
