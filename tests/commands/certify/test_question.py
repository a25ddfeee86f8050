"""The extremes of a motion, by hand arithmetic and by samples; the certificate."""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, inf, pi, radians, sin
from pathlib import Path
from types import MappingProxyType, SimpleNamespace
from typing import Any

import pytest

from motionlang import certify, run
from motionlang.commands.certify import CertifiedLimit, least_margin, omissions, violations
from motionlang.commands.quantities import values_of
from motionlang.kernel import Run, Source, settings_next_to

SCRIPTS = Path(__file__).parents[3] / "scripts"
SET = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 500 : "
# The motion, and the lowest and highest position, speed, acceleration and jerk, user units and seconds.
MOTIONS: dict[str, tuple[str, tuple[float, float, float, float, float]]] = {
    "nothing": ("OUTX(1) = 1", (0, 0, 0, 0, 0)),
    "a trapezoid": ("MOVEA(0) = 40 : GO(0) : PAUSE IDLE(0)", (0, 40, 100, 1000, inf)),
    "there and beyond": ("MOVEA(0) = 9 : GO(0) : MOVEA(0) = -30 : GO(0) : PAUSE IDLE(0)", (-30, 9, 100, 1000, inf)),
    "a triangle": ("MOVEA(0) = 7.5 : GO(0) : PAUSE IDLE(0)", (0, 7.5, (15000 / 3) ** 0.5, 1000, inf)),
    "one that is cut off at once": ("JOG(0) = 80 : WAIT(500) : CANCEL(0)", (0, 80 * 0.5 - 3.2, 80, inf, inf)),
    "a jog that is on its way at the end": ("JOG(0) = 80", (0, 80 * 2.0 - 3.2, 80, 1000, inf)),
    "one that must turn": (
        "MOVEA(0) = 40 : GO(0) : PAUSE POS(0) > 20 : MOVEA(0) = 0 : STOP(0) : PAUSE IDLE(0) : GO(0) : PAUSE IDLE(0)",
        (0, 30, 100, 1000, inf),
    ),
}  # fmt: skip


# Limits that nothing reaches.
WIDE = {"position": [-1e12, 1e12], "speed": 1e12, "acceleration": 1e12, "jerk": 1e15}


def extremes(
    program: str | Path,
    axis: int = 0,
    until: float | None = None,
    machine: Mapping[str, Any] = MappingProxyType({}),
) -> tuple[dict[str, CertifiedLimit], Run]:
    """Return what an axis reaches, by the name of the limit, and the run."""
    source = Source.read(program) if isinstance(program, Path) else Source("m.mnt", program)
    settings = (settings_next_to(program) if isinstance(program, Path) else {}) | dict(machine)
    result = run(
        source, machine=settings | {f"axis.{axis}.limits.{k}": v for k, v in WIDE.items()}, until=until
    )
    return {line.name: line for line in certify(result) if line.axis == axis}, result


@pytest.mark.parametrize("motion", MOTIONS)
def test_the_extremes_of_a_motion(motion: str) -> None:
    program, expected = MOTIONS[motion]
    found, _ = extremes(SET + program, until=2.0)
    assert [each.reached for each in found.values()] == pytest.approx(list(expected), abs=3e-3)


def test_a_sinusoidal_ramp_has_its_crest_in_its_middle() -> None:
    limits = {f"axis.1.limits.{name}": 1e9 for name in ("acceleration", "jerk")}
    result = run(Source("s.mcl", "1MN,1PS,1SV100,1SA500,1DS500\n1MR1000,1WS0\n"), machine=limits)
    acceleration, jerk = certify(result)
    length = pi / 2 * 100 / 500  # of a sinusoidal ramp whose crest is the acceleration
    assert acceleration.reached == pytest.approx(500)
    assert acceleration.time == pytest.approx(result.moves[0].start_time + length / 2)
    assert jerk.reached == pytest.approx(500 * pi / length)


@pytest.mark.parametrize(
    ("name", "axis"),
    [("pick-and-place", 0), ("cam-lift", 1), ("laser-contour", 0), ("laser-contour", 1), ("winder", 0)],
)
def test_nothing_that_is_sampled_lies_beyond(name: str, axis: int) -> None:
    """The trace computes the samples by other code than that of the extremes."""
    found, result = extremes(SCRIPTS / "mint" / f"{name}.mnt", axis)
    low, high, *others = (each.reached or 0.0 for each in found.values())
    bounds = {
        "position": (low, high),
        "velocity": (-others[0], others[0]),
        "acceleration": (-others[1], others[1]),
    }
    assert high > low
    for chunk in result.trace.chunks(min(1000.0, 1e5 / result.time), (axis,), result.time, tuple(bounds)):
        for quantity, (least, most) in bounds.items():
            values = chunk.get(axis, quantity)
            slack = 1e-6 * max(1.0, abs(least), abs(most)) if most < inf else 0.0
            assert least - slack <= values.min(), quantity
            assert values.max() <= most + slack, quantity


@pytest.mark.parametrize("axis", [0, 1])
def test_lines_and_arcs_that_join_have_no_infinite_acceleration(axis: int) -> None:
    """At speed 50, arcs of radius 10 need 250 of lateral acceleration, the ramps 500."""
    found, _ = extremes(SCRIPTS / "mint" / "laser-contour.mnt", axis)
    assert found["acceleration"].reached == pytest.approx(500.0, rel=1e-4)
    assert found["jerk"].reached == inf  # a trapezoid has its acceleration at once


@pytest.mark.parametrize("axis", [0, 1])
def test_the_extremes_of_an_arc_are_between_the_ends_of_its_pieces(axis: int) -> None:
    """At 20 along a circle of radius 10 an axis has 20 at each crossing, and 40 across it; the ramps add at most 1."""
    found, _ = extremes(
        "SPEED(0) = 20 : ACCEL(0) = 1 : DECEL(0) = 1\nCIRCLER(0, 1) = 10, 0, 9000\nGO(0)\n", axis
    )
    assert found["speed"].reached == pytest.approx(20.0, rel=1e-6)
    assert found["acceleration"].reached == pytest.approx(40.0, rel=1e-3)
    low, high = ((0.0, 20.0), (-10.0, 10.0))[axis]
    assert found["lowest position"].reached == pytest.approx(low, abs=1e-6)
    assert found["highest position"].reached == pytest.approx(high, abs=1e-6)


# Mint's rates for an overshoot of 1: a search at 60 that stops with 1800.
MINT = "SPEED(0) = 500 : ACCEL(0) = 1800 : DECEL(0) = 1800 : HOMESPEED(0) = 60\n"
HOME = "HOME(0) = _hmNEGATIVE_SWITCH : PAUSE IDLE(0)\n"
TO_90 = "MOVEA(0) = 90 : GO(0) : PAUSE IDLE(0)\n"
MCCL = "1MN,1SA1800,1DS1800\n"
FIND = "1VM,1DI1,1SV60,1GO,1FE{},1ST,1WS,1PM,1SV500\n"
# The machine's home switch is on below -25; the language, the program, its lowest and highest position.
ZEROS: dict[str, tuple[str, str, tuple[float, float]]] = {
    "a new zero": ("mnt", f"{MINT}{TO_90}POS(0) = 0\n{TO_90}", (0, 180)),
    "DH": ("mcl", f"{MCCL}1SV500,1MA90,1WS\n1DH0,1MA90,1WS\n", (0, 180)),
    "a new zero in motion": ("mnt", f"{MINT}MOVEA(0) = 90 : GO(0) : WAIT = 100\nPOS(0) = 0\nPAUSE IDLE(0)", (0, 90)),
    "a new zero, taken back": ("mnt", f"{MINT}POS(0) = 50\n{TO_90}POS(0) = 40\n", (0, 40)),
    "the search of a homing": ("mnt", f"{MINT}{HOME}{TO_90}", (-1, 90)),
    "the search of FE": ("mcl", f"{MCCL}{FIND.format(0)}1MA90,1WS\n", (-1, 90)),
    "FE that gives another position": ("mcl", f"{MCCL}{FIND.format(-25)}1MA90,1WS\n", (-26, 90)),
    "HOMEREFPOS": ("mnt", f"{MINT}HOMEREFPOS(0) = -25\n{HOME}{TO_90}", (-26, 90)),
    "a new zero after the homing": ("mnt", f"{MINT}{HOME}POS(0) = 10\n{TO_90}", (-1, 80)),
    "a homing between two moves": ("mnt", f"{MINT}MOVEA(0) = 60 : GO(0) : PAUSE IDLE(0)\n{HOME}{TO_90}", (-1, 90)),
    "the last of two homings": ("mnt", f"{MINT}{HOME}{TO_90}HOMEREFPOS(0) = 5\n{HOME}", (4, 95)),
    "a homing that the run cuts off": ("mnt", f"{MINT}{TO_90}HOMESPEED(0) = 1\n{HOME}", (0, 90)),
    "another scale": ("mnt", f"{MINT}{TO_90}POS(0) = 0\nSCALE(0) = 2\n", (0, 90)),
    "UO": ("mcl", f"1UO100,{MCCL}1SV500,1MA90,1WS\n", (0, 190)),
    "UO before FE": ("mcl", f"{MCCL}1UO100\n{FIND.format(0)}1MA90,1WS\n", (-1, 90)),
    "POSWRAP": ("mnt", f"{MINT}POSWRAP(0) = 60\n{TO_90}MOVER(0) = 90 : GO(0) : PAUSE IDLE(0)\n", (0, 180)),
    "POSROLLOVER": ("mnt", f"{MINT}POSWRAP(0) = 60\n{TO_90}POSROLLOVER(0) = 0\nMOVER(0) = 90 : GO(0)\n", (0, 180)),
    "ENCODERWRAP": ("mnt", f"{MINT}ENCODERWRAP(0) = 60\n{TO_90}ENCODER(0) = 0\n{TO_90}", (0, 90)),
    "RT": ("mcl", f"{MCCL}1SV500,1MA90,1WS\n1RT,{MCCL}1SV500,1MA90,1WS\n", (0, 180)),
}  # fmt: skip


@pytest.mark.parametrize("what", ZEROS)
def test_positions_count_from_the_zero_of_the_last_homing(what: str) -> None:
    suffix, program, (low, high) = ZEROS[what]
    axis = 1 if suffix == "mcl" else 0
    machine = {
        f"axis.{axis}.home_switch": [-60.0, -25.0],
        f"axis.{axis}.limits.position": [low - 0.01, high + 0.01],
        "run.until": 60.0,
    }
    result = run(Source(f"m.{suffix}", program), machine=machine)
    lowest, highest = certify(result)
    assert (lowest.reached, highest.reached) == pytest.approx((low, high), abs=3e-3)
    assert (lowest.verdict, highest.verdict) == ("within", "within")


@pytest.mark.parametrize("turn", [1, 89])
def test_an_extreme_next_to_an_end_of_an_arc_is_found(turn: int) -> None:
    """An arc of 90 degrees is along axis 0 after 1 of them, or 89."""
    before, after = radians(turn), radians(90 - turn)
    lines = [(cos(before), -sin(before)), (sin(before), cos(before))]
    vectors = [f"VECTORR(0, 1) = {50 * x}, {50 * y}\n" for x, y in lines]
    centre = f"CIRCLER(0, 1) = {10 * sin(before)}, {10 * cos(before)}, 90\n"
    found, result = extremes(
        f"MOVEBUFFERSIZE(0, 1) = 9;\nSPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100\nCONTOURMODE(0) = 1\n"
        f"{vectors[0]}{centre}{vectors[1]}GO(0)\n"
    )
    assert found["speed"].reached == pytest.approx(20.0, rel=1e-6)
    start = result.moves[2].start_time
    assert found["speed"].time == pytest.approx(start + before * 10.0 / 20.0, abs=1e-3)
    assert after + before == pytest.approx(pi / 2)


@pytest.mark.parametrize(("until", "acceleration"), [(2.25, 50.0), (2.5, 100.0)])
def test_a_piece_that_begins_as_the_run_ends_does_not_count(until: float, acceleration: float) -> None:
    """Of 25 in 1 s, 62.5 in 1.25 s and 12.5 in 0.5 s, the last ramp has -100."""
    program = "SPEED(0) = 50 : ACCEL(0) = 50 : DECEL(0) = 100\nMOVER(0) = 100 : GO(0)\nWAIT = 5000\n"
    found, _ = extremes(program, until=until, machine={"controller.instruction_time": 1e-9})
    assert found["acceleration"].reached == acceleration


def test_the_time_of_the_first_jump_counts() -> None:
    """The acceleration jumps as the axis begins, the velocity at 1 s and at 2 s."""
    jog = "JOG(0) = 80 : WAIT = 1000 : CANCEL(0)\n"
    found, _ = extremes(SET + jog + jog, machine={"controller.instruction_time": 1e-9})
    assert (found["acceleration"].reached, found["jerk"].reached) == (inf, inf)
    assert found["acceleration"].time == pytest.approx(1.0, abs=1e-6)
    assert found["jerk"].time == pytest.approx(0.0, abs=1e-6)


def test_an_axis_that_did_not_move_has_its_extremes_at_power_up() -> None:
    found, _ = extremes("WAIT = 100\n")
    assert [(each.reached, each.time, each.line) for each in found.values()] == [(0.0, 0.0, 0)] * 5


def test_the_peaks_of_a_motor_are_those_of_its_trace() -> None:
    """The servo has 1000 samples a second; an error counts in user units."""
    plant = {
        "kind": "brushless",
        "resistance": 1.2,
        "inductance": 2e-3,
        "torque_constant": 0.06,
        "inertia": 3e-5,
    }
    machine = {f"axis.0.plant.{name}": value for name, value in plant.items()}
    limits = {"axis.0.limits.torque": 1.0, "axis.0.limits.following_error": 5.0}
    text = "SCALE(0) = 100\nSPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100\nMOVER(0) = 10 : GO(0) : PAUSE IDLE(0)\n"
    result = run(Source("m.mnt", text), machine=machine | limits)
    torque, error = certify(result)
    for line, quantity in ((torque, "torque"), (error, "following error")):
        samples = result.trace.sample(8000.0, [0], None, [quantity])
        values = abs(samples.get(0, quantity))
        assert line.reached == pytest.approx(values.max(), rel=1e-2)
        assert line.time == pytest.approx(samples.time[values.argmax()], abs=2e-3)
        assert line.verdict == "within"
    torques = result.trace.sample(1000.0, [0], None, ["torque"]).get(0, "torque")
    mean = values_of(result, ["rms_torque.0"])["rms_torque.0"]
    assert mean == pytest.approx(float((torques**2).mean() ** 0.5), rel=1e-2)
    still = run(Source("still.mnt", ""), machine=machine)
    assert values_of(still, ["rms_torque.0", "time"]) == {"rms_torque.0": 0.0, "time": 0.0}


def moved(limits: Mapping[str, object]) -> Run:
    settings = {f"axis.0.limits.{name}": value for name, value in limits.items()}
    return run(Source("m.mnt", SET + "\nMOVEA(0) = 40\nGO(0) : PAUSE IDLE(0)"), machine=settings)


def certified(limits: Mapping[str, object]) -> list[CertifiedLimit]:
    return certify(moved(limits))


def test_a_certificate_says_when_and_on_which_line_and_what_is_left() -> None:
    low, high, speed, accel = certified({"position": [-1.0, 30.0], "speed": 100.0, "acceleration": 1250.0})
    assert [line.verdict for line in (low, high, speed, accel)] == ["within", "exceeded", "within", "within"]
    assert [low.margin, high.margin, speed.margin, accel.margin] == pytest.approx([1.0, -10.0, 0.0, 0.2])
    assert [speed.line, speed.reached, speed.time] == pytest.approx([2, 100.0, 0.1], abs=1e-4)
    assert least_margin([low, high, speed, accel]) == pytest.approx(-1 / 3)


def test_what_prevents_signing_is_reported() -> None:
    for limits, expected in (
        ({"speed": 99.0}, "the speed of axis 0 reaches 100 uu/s at 0.1000"),
        ({"torque": 1.0}, "the torque of axis 0 cannot be certified: no motor is simulated"),
        ({"jerk": 1e9}, "the jerk of axis 0 is infinite at 0.0000"),
        ({}, "nothing to certify: the machine has no limits"),
    ):
        result = moved(limits)
        (found,) = violations(result, certify(result) if limits else [], str)
        assert found.message.startswith(expected)
        assert found.code == "beyond-limit"
    result = moved({"speed": 100.0, "acceleration": 1000.0, "position": [0.0, 40.0]})
    assert violations(result, certify(result), str) == []


GO_THERE = "MOVER(0) = 50 : GO(0) : PAUSE IDLE(0)\n"
TO_AND_FRO = f"Loop\n{GO_THERE}MOVER(0) = -50 : GO(0) : PAUSE IDLE(0)\nWAIT = 200\nEnd Loop\n"
# The program, when its run is cut off, and what its certificate does not cover; only the speed of axis 0 has a limit.
UNCOVERED: dict[str, tuple[str, float | None, list[str]]] = {
    "an axis without limits": (f"{GO_THERE}JOG(1) = 10\nWAIT = 9\nSTOP(1)\n", None, ["axis 1 moved and has no limits"]),
    "an axis without limits that rests": (f"{GO_THERE}POS(1) = 10\n", None, []),
    "a follower without limits": (
        f"FOLLOW(1) = 1\n{GO_THERE}FOLLOW(1) = 0\n", None, ["axis 1 moved and has no limits"]),
    "a cut move": (GO_THERE, 0.2, ["the run was cut off at 0.2 s, while axis 0 was moving"]),
    "a move that a pause follows": (
        f"{GO_THERE}WAIT = 500\n{GO_THERE}", 0.8, ["the run was cut off at 0.8 s, before the program ended"]),
    "the first cycle": (TO_AND_FRO, 0.2, ["the run was cut off at 0.2 s, while axis 0 was moving"]),
    "the last of many cycles": (TO_AND_FRO, 20.3, []),
    "a move that is no part of the cycle": (
        f"Run Far\n{TO_AND_FRO}Task Far\nMOVER(1) = 1e6 : GO(1)\nEnd Task\n", 20.3, [
            "axis 1 moved and has no limits", "the run was cut off at 20.3 s, while axis 1 was moving"]),
    "a jog at its speed": ("JOG(0) = 50\n", 20.0, []),
    "a jog that accelerates": ("JOG(0) = 50\n", 0.01, ["the run was cut off at 0.01 s, while axis 0 was moving"]),
    "a hang": (f"{GO_THERE}While POS(0) < 51\nWAIT = 10\nEnd While\n", None, ["the run hangs at line 3"]),
    "an error": (f"{GO_THERE}PRINT 1 / (POS(0) - 50)\n", None, ["the run failed at 0.65005 s"]),
    "a loop that has served its events": (f"{GO_THERE}Loop\nEnd Loop\nEvent IN1\n{GO_THERE}End Event\n", 9.0, []),
}  # fmt: skip


@pytest.mark.parametrize("what", UNCOVERED)
def test_a_certificate_says_what_it_does_not_cover(what: str) -> None:
    program, until, expected = UNCOVERED[what]
    result = run(Source("m.mnt", f"{SET}\n{program}"), machine={"axis.0.limits.speed": 100.0}, until=until)
    lines = certify(result)
    assert omissions(result, lines) == expected
    # A run that failed has its own error.
    found = [each.message for each in violations(result, lines, lambda axis: f"limits of {axis}")]
    assert found == ([] if result.status == "fault" else expected)


def test_a_jog_that_goes_on_has_no_extreme_of_position() -> None:
    result = run(
        Source("m.mnt", f"{SET}\nJOG(0) = 50\n"), machine={"axis.0.limits.position": [-1, 1e9]}, until=20.0
    )
    assert omissions(result, certify(result)) == ["the run was cut off at 20 s, while axis 0 was moving"]


def at(value: float, time: float) -> Any:
    """Return an extreme and its time."""
    return SimpleNamespace(value=value, time=time)


# The limit, its value, the value reached, the margin and the verdict. A position may be exceeded by a
# billionth of its limit, or of 1 if that is more; any other figure by a billionth of its limit.
MARGINS: dict[str, tuple[str, float, float, float, str]] = {
    "above the lowest position": ("lowest position", -4.0, -1.0, 3.0, "within"),
    "below the lowest position": ("lowest position", -4.0, -6.0, -2.0, "exceeded"),
    "below the highest position": ("highest position", 50.0, 20.0, 30.0, "within"),
    "a position beyond by rounding": ("highest position", 1e6, 1e6 + 9e-4, -9e-4, "within"),
    "a position beyond by more": ("highest position", 1e6, 1e6 + 2e-3, -2e-3, "exceeded"),
    "at 0, beyond by rounding": ("lowest position", 0.0, -9e-10, -9e-10, "within"),
    "at 0, beyond by more": ("lowest position", 0.0, -2e-9, -2e-9, "exceeded"),
    "a quarter left": ("speed", 100.0, 75.0, 0.25, "within"),
    "a speed beyond by rounding": ("speed", 0.1, 0.1 * (1.0 + 9e-10), -9e-10, "within"),
    "a speed beyond by more": ("speed", 0.1, 0.1 * (1.0 + 2e-9), -2e-9, "exceeded"),
    "twice the jerk": ("jerk", 10.0, 20.0, -1.0, "exceeded"),
}  # fmt: skip


@pytest.mark.parametrize("name", MARGINS)
def test_the_margin_of_a_limit(name: str) -> None:
    which, limit, reached, margin, verdict = MARGINS[name]
    line = CertifiedLimit(0, which, "", limit, at(reached, 0.5), 3)
    assert line.margin == pytest.approx(margin, rel=1e-6)
    assert line.verdict == verdict
    assert (line.reached, line.time) == (reached, 0.5)


def test_the_least_margin_takes_a_position_relative_to_its_limit() -> None:
    """30 of 50 is 0.6, 3 of 4 is 0.75; without a known limit there is none."""
    high = CertifiedLimit(0, "highest position", "", 50.0, at(20.0, 0.0), 0)
    low = CertifiedLimit(0, "lowest position", "", -4.0, at(-1.0, 0.0), 0)
    speed = CertifiedLimit(0, "speed", "", 10.0, at(3.0, 0.0), 0)
    torque = CertifiedLimit(0, "torque", "", 1.0, None, 0)
    assert (torque.verdict, torque.reached, torque.time) == ("unknown", None, None)
    # Relative to a limit of 0 any distance is large.
    zero = CertifiedLimit(0, "lowest position", "", 0.0, at(0.5, 0.0), 0)
    cases = [[high, low, speed, torque], [low, speed], [low, torque], [torque], [], [zero, speed]]
    assert [least_margin(lines) for lines in cases] == [0.6, 0.7, 0.75, None, None, 0.7]
