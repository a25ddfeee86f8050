"""The proof of a run: rejected forgeries, named exceptions, and listed results."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from motionlang import run
from motionlang.commands.prove.checks import prove
from motionlang.commands.prove.expected_motion import ExpectedMotion
from motionlang.commands.prove.order import Order
from motionlang.commands.prove.proof import proof as proof_of
from motionlang.kernel import Axis, Run, Source
from motionlang.kernel.planners import Profile, hold, plan
from motionlang.kernel.report import moves
from motionlang.kernel.tracks import Recorded, Samples

FINE = {"controller.instruction_time": 1e-9}
MOVE = "SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 50\nMOVER(0) = 100\nGO(0)\nPAUSE IDLE(0)\n"
JERKS = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 400 : DECELJERK(0) = 400\n"


def proved(program: str) -> Run:
    result = run(Source("move.mnt", program), machine=FINE, prove=True)
    assert result.diagnostics == []
    return result


def found(result: Run) -> list[str]:
    return [f"{each.line}: {each.message}" for each in proof_of(result).violations]


def put(a: Axis, made: Callable[[Profile], Profile]) -> None:
    """Replace the first moving profile of an axis by a forged one."""
    i = next(k for k, each in enumerate(a.profiles) if each.shape != "hold")
    a.profiles[i] = made(a.profiles[i])


FORGED: dict[str, tuple[Callable[[Profile], Profile], str]] = {
    "a jump": (lambda p: p.shifted(1.0), "the position jumps by 1 counts"),
    "too fast": (lambda _: plan("trapezoid", 0.0, 100.0, 25.0, 100.0, 50.0), "the speed reaches 25 counts"),
    "too hard": (lambda _: plan("trapezoid", 0.0, 100.0, 20.0, 130.0, 50.0), "the acceleration reaches 130"),
    "brakes too hard": (
        lambda _: plan("trapezoid", 0.0, 100.0, 20.0, 100.0, 70.0),
        "the deceleration reaches 70",
    ),
    "elsewhere": (lambda _: plan("trapezoid", 0.0, 101.0, 20.0, 100.0, 50.0), "the position jumps by"),
    "not at all": (lambda _: hold(0.0).cut(5.3), "the log has it at"),
}


def test_a_sound_run_is_proved() -> None:
    proof = proof_of(proved(MOVE))
    assert proof.holds
    assert proof.counts == {"moves": 1, "profiles": 1, "joins": 2, "paths": 0}
    assert {name: round(share, 6) for name, share in proof.worst.items()} == {
        "speed": 1.0, "acceleration": 1.0, "deceleration": 1.0,
    }  # fmt: skip


@pytest.mark.parametrize("name", FORGED)
def test_what_is_forged_is_found(name: str) -> None:
    forge, message = FORGED[name]
    result = proved(MOVE)
    put(result.controller.axes[0], forge)
    assert any(message in each for each in found(result)), found(result)


def test_a_jerk_beyond_the_one_in_force_is_found() -> None:
    result = proved(JERKS + MOVE)
    assert found(result) == []
    put(
        result.controller.axes[0],
        lambda _: plan("scurve", 0.0, 100.0, 20.0, 100.0, 50.0, 0.0, 0.0, 900.0, 400.0),
    )
    assert any("the jerk reaches 900" in each for each in found(result))


def test_a_log_that_ends_elsewhere_is_found() -> None:
    result = proved(MOVE)
    result.controller.log.moves[0].target += 1.0
    assert found(result) == ["2: axis 0 from 0.000000 s: it ends at 100, commanded 101"]


def test_a_move_that_ends_as_the_run_does_is_asked_where() -> None:
    (whole,) = proved(MOVE).controller.log.moves
    assert whole.profile is not None
    end = whole.start_time + whole.profile.duration
    result = run(Source("move.mnt", MOVE), machine=FINE, prove=True, until=end)
    assert found(result) == []
    result.controller.log.moves[0].target += 1.0
    assert found(result) == ["2: axis 0 from 0.000000 s: it ends at 100, commanded 101"]


def test_a_move_in_no_time_is_found() -> None:
    result = proved(MOVE)
    result.controller.log.moves[0].profile = Profile("trapezoid", 0.0, 100.0, 0.0, (0.0, 0.0, 0.0, 0.0))
    assert any("100 counts in no time" in each for each in found(result))


ORDERED = {
    "MOVER(0) = 100 : GO(0)\nWAIT 500\nCANCEL(0)\n": "an immediate stop: cancelled, disabled, or at a limit",
    "MOVER(0) = 100 : GO(0)\nWAIT 500\nPOS(0) = 7\nPAUSE IDLE(0)\n": "a position set to a new value",
    "CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 10\nVECTORR(0, 1) = 50, 0\nVECTORR(0, 1) = 50, 5\nGO(0)\n"
    "PAUSE IDLE(0)\n": "a kink within CONTOURANGLE",
}


@pytest.mark.parametrize("program", ORDERED)
def test_what_is_ordered_has_its_name(program: str) -> None:
    proof = proof_of(proved("SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100\n" + program))
    assert proof.holds
    assert list(proof.exceptions) == [ORDERED[program]]


def test_a_position_is_given_a_new_value_at_the_moment_at_which_a_move_is_cut_off() -> None:
    """The end of the move, its start plus its duration, is late by one rounding."""
    program = "WA0.1\n1MN,1SV20000,1MA5000\nWA0.125,1RT\n"
    result = run(Source("reset.mcl", program), machine={}, prove=True)
    (move,) = result.controller.log.moves
    assert move.profile is not None
    assert move.start_time + move.profile.duration > result.controller.axes[1].starts[-1]
    assert found(result) == []


# Paths with several paces, and a stop on one: each violated a bound once.
PACES = (
    # A path shorter than the ramp to its speed: 420.5 uu/s² without a forward pass.
    "FEEDRATEMODE(0) = 1 : CONTOURMODE(0) = 1 : ACCEL(0) = 90 : DECEL(0) = 60\nSPEED(0) = 29\nVECTORR(0, 1) = 1, 0\n"
    "SPEED(0) = 30\nVECTORR(0, 1) = 100, 0\nGO(0)\nPAUSE IDLE(0)\n",
    "SPEED(0) = 40 : ACCEL(0) = 300 : DECEL(0) = 500 : MAXACCEL(0) = 60 : MAXDECEL(0) = 60\n"
    "CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 5\nVECTORR(0, 1) = 5, 0\nVECTORR(0, 1) = 40, 0.001\nGO(0)\n"
    "PAUSE IDLE(0)\n",
    # A stop in the middle of an S-ramp.
    "SPEED(0) = 20 : ACCEL(0) = 50 : DECEL(0) = 50 : PROFILEMODE(0) = 1 : ACCELJERK(0) = 400 : DECELJERK(0) = 400\n"
    "VECTORR(0, 1) = 40, 0 : GO(0)\nWAIT 350\nSTOP(0)\nPAUSE IDLE(0)\n",
)  # fmt: skip


# An acceleration that builds up at once, because its time is 0: it jumps as ordered.
AT_ONCE = "SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 80 : PROFILEMODE(0) = 1\n"
JUMPS = (
    "ACCELJERKTIME(0) = 0 : DECELJERKTIME(0) = 0\nVECTORR(0, 1) = 30, 40 : GO(0)\nPAUSE IDLE(0)\n",
    "ACCELJERKTIME(0) = 200 : DECELJERKTIME(0) = 200\nBLENDMODE(0) = 1 : BLENDDISTANCE(0) = 3\n"
    "VECTORR(0, 1) = 14, -11 : VECTORR(0, 1) = 9, 17 : GO(0)\nACCELJERKTIME(0) = 0\nPAUSE IDLE(0)\n",
    "ACCELJERKTIME(0) = 50 : DECELJERKTIME(0) = 0\nJOG(0) = 6\nWAIT = 800\nSTOP(0)\nPAUSE IDLE(0)\n",
    "ACCELJERKTIME(0) = 50 : DECELJERKTIME(0) = 0\nMOVER(0) = 40 : GO(0)\nWAIT = 800\nSUSPEND(0) = 1\nWAIT = 300\n"
    "SUSPEND(0) = 0\nPAUSE IDLE(0)\n",
)  # fmt: skip


@pytest.mark.parametrize("program", JUMPS)
def test_an_acceleration_without_a_jerk_time_jumps_as_ordered(program: str) -> None:
    assert found(proved(AT_ONCE + program)) == []


@pytest.mark.parametrize(
    "paths", ["VECTORR(0, 1) = 30, 40", "VECTORR(0, 1) = 12, 16 : VECTORR(0, 1) = 16, 12"]
)
def test_a_path_resumed_by_another_shape_completes_its_stop_by_the_first_one(paths: str) -> None:
    """A trapezoidal stop takes 0.2 s; SRAMP applies from the standstill on."""
    begin = f"SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100\n{paths} : GO(0)\nWAIT = 500\n"
    assert found(proved(begin + "SUSPEND(0) = 1\nSRAMP(0) = 100\nSUSPEND(0) = 0\nPAUSE IDLE(0)\n")) == []


# Settings written while a path stops, or shortly before its end, that apply later.
LATER = (
    # The stop of SUSPEND continues while the next path is blended onto the resumed one, whose jerk is lower.
    "SPEED(0) = 55.34 : ACCEL(0) = 927.064 : DECEL(0) = 773.824\n"
    "PROFILEMODE(0) = 1 : ACCELJERK(0) = 1778.643 : DECELJERK(0) = 17973.371\nSRAMP(0) = 50\n"
    "BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 7.345\n"
    "VECTORR(0, 1) = 6.246, 1.472 : VECTORR(0, 1) = -15.15, -16.104 : GO(0)\nPAUSE Abs(VEL(1)) > 11.37\n"
    "SUSPEND(0) = 1\nACCELJERK(0) = 16599.76\nSUSPEND(0) = 0\nPAUSE IDLE(0)\n",
    # The stop of SUSPEND keeps its jerk, 18 000; the path resumed before its end has one of 5000.
    "PROFILEMODE(0) = 1 : ACCELJERK(0) = 17000 : DECELJERK(0) = 18000\n"
    "VECTORR(0, 1) = -5, 13 : VECTORR(0, 1) = 18, 15 : GO(0)\nPAUSE Abs(VEL(0)) > 6\nSUSPEND(0) = 1\n"
    "DECEL(0) = 500\nPAUSE Abs(VEL(1)) < 2\nFEEDRATEMODE(0) = 3 : FEEDRATEOVERRIDE(0) = 50\n"
    "DECELJERKTIME(0) = 100\nSUSPEND(0) = 0\nFEEDRATEOVERRIDE(0) = 100\nPAUSE IDLE(0)\n",
    # A trapezoid from the middle of a blend of S-ramps on.
    "SPEED(0) = 42.312 : ACCEL(0) = 734.893 : DECEL(0) = 1263.721\n"
    "SPEED(1) = 25.621 : ACCEL(1) = 1016.099 : DECEL(1) = 1396.940\n"
    "SRAMP(0) = 100\n"
    "ACCELTIME(0) = 100 : DECELTIME(0) = 300\n"
    "PROFILEMODE(1) = 1 : ACCELJERKTIME(1) = 1 : DECELJERKTIME(1) = 50\n"
    "PROFILEMODE(1) = 1 : ACCELJERK(1) = 5872.115 : DECELJERK(1) = 2451.792\n"
    "BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 4.841\n"
    "VECTORR(0, 1) = -4.121, 1.165 : VECTORR(0, 1) = -12.750, -8.609 : GO(0)\n"
    "WAIT = 367\n"
    "SRAMP(0) = 0\n"
    "MAXSPEED(0) = 14.679\n"
    "PAUSE IDLE(0)\n",
)  # fmt: skip


@pytest.mark.parametrize("program", LATER)
def test_settings_apply_from_the_end_of_a_stop_or_of_a_profile(program: str) -> None:
    assert found(proved(program)) == []


def test_a_path_without_room_to_slow_down_keeps_the_speed_of_its_plan_in_a_blend() -> None:
    """SPEED becomes 43.7 shortly before the end: two S-ramps have no room there."""
    program = (
        "SPEED(0) = 45.1 : ACCEL(0) = 688 : DECEL(0) = 1195 : PROFILEMODE(0) = 1\n"
        "ACCELJERK(0) = 13900 : DECELJERK(0) = 8200 : BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 3.4\n"
        "VECTORR(0, 1) = 6.7, -13.1 : VECTORR(0, 1) = -10.4, 18.5 : GO(0)\nWAIT = 290\nSPEED(0) = 43.7\n"
        "PAUSE IDLE(0)\n"
    )
    assert found(proved(program)) == []


def test_a_blend_that_is_cancelled_while_it_stops_is_checked_by_the_jerk_of_its_stop() -> None:
    """The jerk of the stop is 20 000; that of the ramps before it was 2000."""
    program = (
        "SPEED(0) = 20 : ACCEL(0) = 200 : DECEL(0) = 200 : PROFILEMODE(0) = 1\n"
        "ACCELJERKTIME(0) = 10 : DECELJERKTIME(0) = 100\nBLENDMODE(0) = 1 : BLENDDISTANCE(0) = 4\n"
        "VECTORR(0, 1) = 1, -8 : VECTORR(0, 1) = -9, 16 : GO(0)\nDECELJERKTIME(0) = 10\n"
        "PAUSE Abs(VEL(1)) > 6\nPAUSE Abs(VEL(1)) < 0.01\nSTOP(0)\nWAIT = 2\nCANCEL(0)\n"
    )
    assert found(proved(program)) == []


@pytest.mark.parametrize("program", PACES)
def test_paths_of_other_paces_and_stops_on_them_keep_every_bound(program: str) -> None:
    assert found(proved(program)) == []


def test_a_run_without_expected_motion_cannot_be_proved() -> None:
    result = run(Source("move.mnt", MOVE))
    with pytest.raises(ValueError, match="prove=True"):
        proof_of(result)


# Orders that are forged afterwards, and that the motion then violates.
ARC = "MAXACCEL(1) = 40\nCIRCLER(0, 1) = -10, 0, 300\nGO(0)\nPAUSE IDLE(0)\n"
LINE = "VECTORR(0, 1) = 30, 40\nGO(0)\nPAUSE IDLE(0)\n"
SLAVE = "MASTERSOURCE(1) = _msPOS : FOLLOW(1) = 0.5\nJOG(0) = 20\nWAIT 1000\nSTOP(0)\nPAUSE IDLE(0)\n"
CAM = (
    "Dim rise(3) As Float = 2, 5, 9\nMASTERSOURCE(1) = _msPOS : MASTERDISTANCE(1) = 10\nCAMTABLE(1, rise)\n"
    "CAM(1) = 0 : GO(1) : JOG(0) = 20\nWAIT 2000\nSTOP(0)\nPAUSE IDLE(0)\n"
)
SPLINE = (
    "Dim way(5) As Float = 4, 5, 10, 10, 5\nSPLINETABLE(0, way)\nSPLINETIME(0) = 500\nSPLINE(0) = 0\nGO(0)\n"
    "PAUSE IDLE(0)\n"
)
FLY = (
    "MASTERSOURCE(1) = _msPOS : MASTERDISTANCE(1) = 10\nMOVEBUFFERSIZE(1) = 5\nFLY(1) = 5 : FLY(1) = 10 : FLY(1) = 5\n"
    "GO(1) : JOG(0) = 20\nWAIT 2000\nSTOP(0)\nPAUSE IDLE(0)\n"
)
REFERENCE = "SPEEDREF(0) = 20\nWAIT 9000\nSPEEDREF(0) = 0\nWAIT 9000\n"
BLENDED = (
    "BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 2\n"
    "VECTORR(0, 1) = 20, 0\nVECTORR(0, 1) = 0, 20\nGO(0)\nPAUSE IDLE(0)\n"
)
CONTOUR = "CONTOURMODE(0) = 1\nVECTORR(0, 1) = 30, 0\nVECTORR(0, 1) = 20, 0\nGO(0)\nPAUSE IDLE(0)\n"
SUSPENDED = (
    "VECTORR(0, 1) = 30, 40\nGO(0)\nWAIT = 1000\nSUSPEND(0) = 1\nWAIT = 500\nSUSPEND(0) = 0\nPAUSE IDLE(0)\n"
)
SLOWED = "VECTORR(0, 1) = 30, 40\nGO(0)\nWAIT = 1000\nSPEED(0) = 10\nPAUSE IDLE(0)\n"
SLOWER = "FEEDRATEMODE(0) = 0\nMOVER(0) = 100 : GO(0)\nWAIT 1000\nSPEED(0) = 10\nPAUSE IDLE(0)\n"
RATES = "SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100\n"
Forge = Callable[[Order], Order]


def path_of(order: Order, **other: object) -> Order:
    return order if order.path is None else order._replace(path=order.path._replace(**other))  # type: ignore[arg-type]


def tie_of(order: Order, **other: object) -> Order:
    return order if order.tie is None else order._replace(tie=order.tie._replace(**other))  # type: ignore[arg-type]


def stops(order: Order) -> bool:
    return order.path is not None and order.path.comes_to_rest


def off(order: Order, position: float, value: float, kind: str) -> Order:
    """Return an order that is tied to a table with one segment."""
    return tie_of(order, table=((0.0, position), (0.0, value), kind))


BROKEN: dict[str, tuple[str, Forge, list[str]]] = {
    "a path that goes elsewhere": (
        LINE,
        lambda o: path_of(o, line=(30.0, 41.0)),
        [
            "2: path from 0.000000 s: it is 0.135343 off the commanded path",
            "2: axis 1 from 0.000000 s: its path ends at 40, commanded 41",
        ],
    ),
    "a path too long": (
        LINE,
        lambda o: path_of(o, line=(33.0, 44.0)),
        [
            "2: axis 0 from 0.000000 s: its path ends at 30, commanded 33",
            "2: axis 1 from 0.000000 s: its path ends at 40, commanded 44",
        ],
    ),
    "another radius": (
        ARC,
        lambda o: path_of(o, centre=(-10.5, 0.0)),
        [
            "3: path from 0.000000 s: it is 0.337448 off the commanded path",
            "3: axis 0 from 0.000000 s: its path ends at -5, commanded -5.25",
            "3: axis 1 from 0.000000 s: its path ends at -8.66025, commanded -9.09327",
        ],
    ),
    "an angle": (
        ARC,
        lambda o: path_of(o, angle=301.0),
        [
            "3: axis 0 from 0.000000 s: its path ends at -5, commanded -4.84962",
            "3: axis 1 from 0.000000 s: its path ends at -8.66025, commanded -8.57167",
        ],
    ),
    "a path too fast": (
        LINE,
        lambda o: o._replace(speed=19.9),
        [
            "2: path from 0.000000 s: the path speed reaches 20, above 19.9",
        ],
    ),
    "a slow path too fast": (
        "SPEED(0) = 0.5\nVECTORR(0, 1) = 0.3, 0.4\nGO(0)\nPAUSE IDLE(0)\n",
        lambda o: o._replace(speed=0.4),
        [
            "3: path from 0.000000 s: the path speed reaches 0.5, above 0.4",
        ],
    ),
    "a path too hard": (
        LINE,
        lambda o: o._replace(rates=(99.0, 100.0)),
        [
            "2: path from 0.000000 s: the path acceleration reaches 100, above 99",
        ],
    ),
    "too hard for one of its axes": (
        ARC,
        lambda o: path_of(o, most_accel=(1e9, 35.0)),
        [
            "3: path from 0.000000 s: the rate on paths of axis 1 reaches 38.382, above 35",
        ],
    ),
    "too fast for one of its axes": (
        LINE,
        lambda o: path_of(o, most=(1e9, 15.0)),
        [
            "2: path from 0.000000 s: the speed on paths of axis 1 reaches 16, above 15",
        ],
    ),
    "the jerk of a path": (
        JERKS + LINE,
        lambda o: o._replace(jerks=(300.0, 399.0)),
        [
            "3: path from 0.000000 s: the path jerk reaches 400, above 399",
        ],
    ),
    "a cam beside its table": (
        CAM,
        lambda o: off(o, 10.0, 2.1, "linear"),
        [
            "5: axis 1 from 0.000000 s: its curve has 5 at 10 of its master, commanded 2.1",
            "5: axis 1 from 0.000000 s: its curve has 5 at 10 of its master, commanded 2.1",
            "5: axis 1 from 0.000000 s: at 0.070000 s it is at 0.1225, its master requires 0.0529",
        ],
    ),
    "a cam of another length": (
        CAM,
        lambda o: off(o, 9.0, 4.5, "linear"),
        [
            "5: axis 1 from 0.000000 s: its curve rises by 14, commanded 4.5",
            "5: axis 1 from 0.000000 s: its curve is 20 long, commanded 9",
            "5: axis 1 from 0.000000 s: its curve rises by 14, commanded 4.5",
            "5: axis 1 from 0.000000 s: its curve is 20 long, commanded 9",
            "5: axis 1 from 0.000000 s: at 0.625000 s it is at 5.45, its master requires 5.25",
        ],
    ),
    "a segment beside its distance": (
        FLY,
        lambda o: off(o, 10.0, 6.0, "even"),
        [
            "4: axis 1 from 0.000000 s: its curve has 5 at 10 of its master, commanded 6",
            "4: axis 1 from 0.000000 s: its curve has 5 at 10 of its master, commanded 6",
            "4: axis 1 from 0.600000 s: its curve has 10 at 10 of its master, commanded 6",
            "4: axis 1 from 1.100000 s: its curve has 5 at 10 of its master, commanded 6",
        ],
    ),
    "a segment that begins at another ratio": (
        FLY,
        lambda o: tie_of(o, table=None) if o.tie and o.tie.table and o.tie.table[1][1] == 5.0 else o,
        [
            "4: axis 1 from 0.600000 s: its segment begins at a ratio of 1, expected 0",
        ],
    ),
    "a spline beside its points": (
        SPLINE,
        lambda o: o._replace(points=([0.0, 5.0, 15.1, 25.0, 30.0], *o.points[1:])) if o.points else o,
        [
            "5: axis 0 from 0.000000 s: point 2 is 15.1 at 20 counts/s, it is at 15 at 20 counts/s",
        ],
    ),
    "a spline at other velocities": (
        SPLINE,
        lambda o: o._replace(points=(o.points[0], [1.0] * 5, o.points[2])) if o.points else o,
        [
            "5: axis 0 from 0.000000 s: point 0 is 0 at 1 counts/s, it is at 0 at 0 counts/s",
        ],
    ),
    "a speed reference too hard": (
        REFERENCE,
        lambda o: o._replace(rates=(90.0, 90.0)) if o.slopes else o,
        [
            "2: axis 0 from 0.000000 s: the rate of a reference reaches 100 counts, above 90",
            "2: axis 0 from 9.000000 s: the rate of a reference reaches 100 counts, above 90",
        ],
    ),
    "another ratio": (
        SLAVE,
        lambda o: tie_of(o, ratio=0.51),
        [
            "2: axis 1 from 0.000000 s: at 0.070000 s it is at 0.1225, its master requires 0.1249",
            "2: axis 1 from 1.000000 s: at 1.070000 s it is at 9.5775, its master requires 9.5871",
        ],
    ),
    "another place on a cam": (
        CAM,
        lambda o: tie_of(o, origin=0.5),
        [
            "5: axis 1 from 0.000000 s: at 0.625000 s it is at 5.45, its master requires 5.25",
        ],
    ),
    # 20 counts/s at a jerk of 400 need an acceleration of (20 * 400) ** 0.5 = 89.4.
    "a smooth path that brakes too hard": (
        JERKS + LINE,
        lambda o: o._replace(rates=(90.0, 80.0)),
        ["3: path from 0.000000 s: the path deceleration reaches 89.4427, above 80"],
    ),
    "a path with an S-ramp that is too hard": (
        "SRAMP(0) = 100\n" + LINE,
        lambda o: o._replace(rates=(90.0, 80.0)),
        [
            "3: path from 0.000000 s: the path acceleration reaches 100, above 90",
            "3: path from 0.000000 s: the path deceleration reaches 100, above 80",
        ],
    ),
    # The second path begins at 1 s, 2 units before the end of the first one.
    "blended paths too fast": (
        BLENDED,
        lambda o: o._replace(speed=19.0),
        [
            "3: path from 0.000000 s: the path speed reaches 20, above 19",
            "4: path from 1.000000 s: the path speed reaches 20, above 19",
        ],
    ),
    "blended paths too hard": (
        BLENDED,
        lambda o: o._replace(rates=(90.0, 80.0)),
        [
            "3: path from 0.000000 s: the path acceleration reaches 100, above 90",
            "4: path from 1.000000 s: the path acceleration reaches 100, above 90",
            "4: path from 1.000000 s: the path deceleration reaches 100, above 80",
        ],
    ),
    # The line to (20, 1) is 20.025 long; at 18 of its 20 along axis 0 a tenth of that is left.
    "a blended path that goes elsewhere": (
        BLENDED,
        lambda o: path_of(o, line=(20.0, 1.0)) if o.path and o.path.line == (20.0, 0.0) else o,
        [
            "3: path from 0.000000 s: it is 0.199501 off the commanded path",
            "3: axis 1 from 0.000000 s: its path ends at 0, commanded 1",
        ],
    ),
    "the second path of a contour too fast": (
        CONTOUR,
        lambda o: o._replace(speed=19.0) if o.path and o.path.line == (20.0, 0.0) else o,
        ["4: path from 1.600000 s: the path speed reaches 20, above 19"],
    ),
    "a stop of a path too hard": (
        "VECTORR(0, 1) = 30, 40\nGO(0)\nWAIT = 1000\nSTOP(0)\nPAUSE IDLE(0)\n",
        lambda o: o._replace(rates=(100.0, 50.0)) if stops(o) else o,
        ["2: path from 1.000000 s: the path deceleration reaches 100, above 50"],
    ),
    "a resumed path too fast": (
        SUSPENDED,
        lambda o: o if stops(o) else o._replace(speed=19.0),
        [
            "2: path from 0.000000 s: the path speed reaches 20, above 19",
            "2: path from 1.500000 s: the path speed reaches 20, above 19",
        ],
    ),
    "a path that is made slower, too fast": (
        SLOWED,
        lambda o: o._replace(speed=9.0) if o.speed == 10.0 else o,
        ["2: path from 1.000000 s: the path speed reaches 10, above 9"],
    ),
    "a path that is made slower too hard": (
        SLOWED,
        lambda o: o._replace(rates=(100.0, 50.0)) if o.speed == 10.0 else o,
        ["2: path from 1.000000 s: the path deceleration reaches 100, above 50"],
    ),
}


@pytest.mark.parametrize("name", BROKEN)
def test_an_order_that_the_motion_breaks_is_found(name: str) -> None:
    program, forge, expected = BROKEN[name]
    result = proved(RATES + program)
    assert found(result) == []
    orders = ExpectedMotion.of_run(result).of
    for axis, records in orders.items():
        orders[axis] = [forge(order) for order in records]
    assert found(result) == expected


def test_a_report_and_a_trace_that_differ_are_found() -> None:
    result = proved(MOVE)
    (row,), recorded = list(moves(result)), Recorded(result.controller)
    expected_motion = ExpectedMotion.of_run(result)
    samples = result.trace.sample(10.0)

    def violations(report: dict[str, object], trace: Samples = samples) -> list[str]:
        return [
            each.message for each in prove(recorded, expected_motion, result.time, [report], trace).violations
        ]

    assert violations(row) == []
    assert violations({**row, "end": 101.0}) == [
        "axis 0 from 0.000000 s: the report has it at 101 at 5.300000 s, the track at 100"
    ]
    assert violations({**row, "peak_speed": 20.1}) == [
        "axis 0 from 0.000000 s: the report has a peak of 20.1, the track 20"
    ]
    assert "the report has it at 7" in violations({**row, "start_time": 7.0})[0]
    times, positions, *others = samples.data
    forged = Samples(samples.columns, (times, positions + 0.01 * (times > 2.05), *others))
    assert violations(row, forged) == ["axis 0 at 2.100000 s: the trace has it at 40.01, the track at 40"]


def test_more_motion_than_is_stored_is_not_proved_and_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """A run with the maximum number of profiles is proved.

    With one profile more, nothing is recorded, and the run continues.
    """
    monkeypatch.setattr("motionlang.commands.prove.expected_motion.MANY_EQUAL", 1)
    program = (
        "Dim i As Integer\nFor i = 1 To 4\n  MOVER(0) = 1 : GO(0)\n  PAUSE IDLE(0)\nNext\nPRINT POS(0)\n"
    )
    whole = run(Source("move.mnt", program), prove=True)
    orders = ExpectedMotion.of_run(whole).of
    count = sum(map(len, orders.values())) - len(orders)
    for most, expected in (
        (count, []),
        (count - 1, [f"0: nothing was verified: the run has more than {count - 1} profiles"]),
    ):
        monkeypatch.setattr("motionlang.commands.prove.expected_motion.MAX_PROFILES", most)
        monkeypatch.setattr("motionlang.commands.prove.checks.MAX_PROFILES", most)
        ran = run(Source("move.mnt", program), prove=True)
        assert ran.output == whole.output == ["4.0000"]
        assert [each.partition(" of motion")[0] for each in found(ran)] == expected
        assert ran.report == whole.report
        recorded = ExpectedMotion.of_run(ran)
        assert (recorded.is_full, bool(recorded.of)) == (bool(expected), not expected)


@pytest.mark.parametrize(("speed", "entries"), [("10", 1), ("10 * i", 60)])
def test_equal_expected_moves_are_stored_once(
    speed: str, entries: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of sixty equal moves with their rests, fifty share two profiles.

    If each has another speed, there are too many profiles.
    """
    iteration = f"SPEED(0) = {speed}\n  MOVER(0) = 1 : GO(0)\n  PAUSE IDLE(0)\n"
    program = f"Dim i As Integer\nFor i = 1 To 60\n  {iteration}Next\n"
    monkeypatch.setattr("motionlang.commands.prove.expected_motion.MAX_PROFILES", 62)
    expected = ExpectedMotion.of_run(proved(program))
    assert (expected.is_full, len({id(each) for each in expected.of[0]})) == (False, 1 + entries)
    monkeypatch.setattr("motionlang.commands.prove.expected_motion.MAX_PROFILES", 4)
    full = ExpectedMotion.of_run(proved(program))
    assert full.is_full == (entries > 1)


def test_the_proof_of_a_long_run_reads_what_is_packed(monkeypatch: pytest.MonkeyPatch) -> None:
    """The log has packed moves and profiles, including a path."""
    monkeypatch.setattr("motionlang.kernel.log.log.FIRST_CHECK", 4)
    monkeypatch.setattr("motionlang.kernel.log.log.MAX_PROFILES", 40)
    monkeypatch.setattr("motionlang.kernel.log.log.LEFT_PROFILES", 4)
    monkeypatch.setattr("motionlang.kernel.tracks.trace.PROFILES", 8)
    move = "MOVER(0) = 1 : GO(0)\n  PAUSE IDLE(0)\n"
    loop = f"For i = 1 To 60\n  {move}Next\n"
    path = "VECTORR(0, 1) = 3, 4\nGO(0)\nPAUSE IDLE(0)\n"
    result = proved(f"Dim i As Integer\n{RATES}{loop}{path}{loop}")
    proof = proof_of(result)
    assert result.controller.axes[0].older is not None
    assert (proof.violations, proof.counts["moves"], proof.counts["paths"]) == ([], 122, 1)
    (row, *rows) = list(moves(result))
    expected_motion, recorded = ExpectedMotion.of_run(result), Recorded(result.controller)
    violations = prove(recorded, expected_motion, result.time, rows).violations
    assert [each.message for each in violations] == ["the report has 121 moves, the log 122"]
    violations = prove(recorded, expected_motion, result.time, [{**row, "line": 99}, *rows]).violations
    assert [each.message for each in violations] == [
        "axis 0 from 0.000000 s: the report has it at 5e-09 s, line 99"
    ]


def test_a_path_of_axes_with_scales_and_limits_is_proved() -> None:
    program = (
        "SCALE(0) = 4 : SCALE(1) = 4 : MAXSPEED(0) = 10 : SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100\n"
        "VECTORR(0, 1) = 50, 0\nGO(0)\nPAUSE IDLE(0)\n"
    )
    proof = proof_of(proved(program))
    assert (proof.holds, proof.counts["paths"]) == (True, 1)


@pytest.mark.parametrize("motion", ["1MR5000", "1PS0.1,1MR5000", "1VM,1GO"])
def test_settings_that_come_in_motion_say_nothing_of_what_goes_on_at_a_new_zero(motion: str) -> None:
    """New settings apply to an MCCL axis at its next command; a new zero is none."""
    program = f"1MN,1SV5000,1SA100000,1DS100000\n{motion},WA0.01\n1SA2.5,1DS2.5\n1DH100\nWA0.01,1AB,1WS\n"
    result = run(Source("zero.mcl", program), prove=True)
    assert (result.status, found(result)) == ("ended", [])
