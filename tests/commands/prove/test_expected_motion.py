"""The orders that a run records for its proof, one line for each profile.

Statements take next to no time here, so the times are those of the WAITs. A line has the time, the kind and source
line of the order, and what is unusual of its settings (`orders.py`).
"""

from __future__ import annotations

from math import inf
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.prove import expected_motion as module
from motionlang.commands.prove.expected_motion import ExpectedMotion
from motionlang.commands.prove.order import Order
from motionlang.kernel import Controller
from motionlang.kernel.controller import Stopping
from tests.commands.prove.orders import orders_of, recorded, short
from tests.kernel.tracks.test_figures import machine

SETTINGS = "SPEED(0, 1) = 50, 40 : ACCEL(0, 1) = 500, 500 : DECEL(0, 1) = 250, 250\n"
PATH_0 = "path=members=0/1 scales=1/1 begun=9e-09 nth=0 relative=False line=30/0 entry="
PATH_1 = "path=members=0/1 scales=1/1 begun=0.55 nth=1 relative=False line=30/40 entry="
PATHS_AT_9 = "path=members=0/1 scales=1/1 begun=9e-09 nth=0 relative=True line=30/0"
ARC = "path=members=0/1 scales=1/1 begun=0.856667 nth=1 relative=True centre=0/10 angle=90"
AHEAD = "leads_on=True"
SCALED = (
    "path:4 speed=0.5 rates=5/2.5 path=members=0/1 scales=100/100 begun=8e-09 nth=0 relative=True line=3000/4000 "
    "most=6000/inf most_accel=inf/60000 most_decel=inf/30000"
)
BLENDED_ARC = "path=members=0/1 scales=1/1 begun=0.55 nth=1 relative=False centre=30/20 angle=90"
CAM = "TableCam:5 rates=500/250 tie=master=0 curve=35 table=0/10/20/30/0/10/30/35/linear"
PROGRAMS: dict[str, tuple[str, dict[int, list[str]]]] = {
    "a move whose speed and zero change, and a stop whose rate does not": (
        "MOVER(0) = 10 : GO(0)\nPAUSE IDLE(0)\nMOVER(0) = 100 : GO(0)\nWAIT(500)\nSPEED(0) = 20\nWAIT(100)\n"
        "POS(0) = 7\nWAIT(100)\nSTOP(0)\nWAIT(10)\nDECEL(0) = 100\nWAIT(500)\n",
        {
            0: [
                "0.000 rest:0",
                "0.000 move:2 speed=50 rates=500/250",
                "0.350 rest:0",
                "0.350 move:4 speed=50 rates=500/250",
                "0.850 move:4 speed=20 rates=500/250",
                "0.950 move:4 speed=20 rates=500/250 datum=-29.25",
                "1.050 stop:4 rates=500/250 datum=-29.25",
                "1.130 rest:0 datum=-29.25",
            ]
        },
    ),
    "an override of a half and of 0": (
        "FEEDRATEMODE(0) = 2\nMOVER(0) = 100 : GO(0)\nWAIT(500)\nFEEDRATEOVERRIDE(0) = 50\nWAIT(100)\n"
        "FEEDRATEOVERRIDE(0) = 0\nWAIT(400)\nFEEDRATEOVERRIDE(0) = 100\nWAIT(100)\n",
        {
            0: [
                "0.000 rest:0",
                "0.000 move:3 speed=50 rates=500/250",
                "0.500 move:3 speed=25 rates=500/250",
                "0.600 stop:3 rates=500/250",
                "1.000 move:3 speed=50 rates=500/250",
                "2.600 rest:0",
            ]
        },
    ),
    "limits of an axis in both directions": (
        "MAXSPEED(0) = 30 : MAXACCEL(0) = 300 : MAXDECEL(0) = 200\nMOVER(0) = 100 : GO(0)\nWAIT(500)\n"
        "MAXSPEED(0) = 25\nWAIT(100)\nJOG(0) = 60\nWAIT(200)\nJOG(0) = -60\nWAIT(10)\nCANCEL(0)\n",
        {
            0: [
                "0.000 rest:0",
                "0.000 move:3 speed=30 rates=300/200",
                "0.500 move:3 speed=25 rates=300/200",
                "0.600 jog:7 speed=25 rates=300/200 goal=25",
                "0.800 jog:9 speed=25 rates=300/200 goal=-25",
                "0.810 rest:0",
            ]
        },
    ),
    "a move that is suspended": (
        "MOVER(0) = 100 : GO(0)\nWAIT(100)\nSUSPEND(0) = 1\nWAIT(300)\nSUSPEND(0) = 0\nWAIT(100)\n",
        {
            0: [
                "0.000 rest:0",
                "0.000 move:2 speed=50 rates=500/250",
                "0.100 stop:2 rates=500/250",
                "0.400 move:2 speed=50 rates=500/250",
                "2.400 rest:0",
            ]
        },
    ),
    "a follower whose ratio changes, and its stop": (
        "MASTERSOURCE(0) = _msPOS : MASTERCHANNEL(0) = 1\nFOLLOW(0) = 2\nJOG(1) = 10\nWAIT(300)\n"
        "FOLLOW(0) = 3\nWAIT(300)\nSTOP(0)\nWAIT(100)\n",
        {
            0: [
                "0.000 rest:0",
                "0.000 Gear:3 rates=500/250 tie=master=1 ratio=2 locked=0",
                "0.000 Gear:3 rates=500/250 tie=master=1 ratio=2 locked=0",
                "0.300 Gear:3 rates=500/250 tie=master=1 ratio=3 locked=0",
                "0.600 stop:3 rates=500/250",
                "0.720 rest:0",
            ],
            1: ["0.000 rest:0", "0.000 jog:4 speed=10 rates=500/250 goal=10"],
        },
    ),
    "a jerk-limited move": (
        "PROFILEMODE(0) = 1 : ACCELJERK(0) = 5000 : DECELJERK(0) = 4000\nMOVER(0) = 100 : GO(0)\nWAIT(300)\n",
        {
            0: [
                "0.000 rest:0",
                "0.000 move:3 speed=50 rates=500/250 jerks=5000/4000 shape=scurve",
                "2.231 rest:0",
            ]
        },
    ),
    "contoured paths, and a stop on the arc before the last one": (
        "MOVEBUFFERSIZE(0) = 10 : MOVEBUFFERSIZE(1) = 10\nCONTOURMODE(0) = 1\nVECTORR(0, 1) = 30, 0\n"
        "CIRCLER(0, 1) = 0, 10, 90\nVECTORR(0, 1) = 0, 5\nGO(0)\nWAIT(300)\nSPEED(0) = 30\nWAIT(600)\n"
        "STOP(0)\nPAUSE IDLE(0)\n",
        {
            axis: [
                "0.000 rest:0",
                f"0.000 path:4 speed=50 rates=500/250 {PATHS_AT_9} entry={axis}",
                f"0.300 path:4 speed=30 rates=500/250 {PATHS_AT_9} entry={axis}",
                f"0.857 path:5 speed=30 rates=500/250 {ARC} entry={axis + 2}",
                f"0.900 path:5 speed=30 rates=500/250 {ARC} comes_to_rest=True {AHEAD} entry={axis + 2}",
                "1.020 rest:0",
            ]
            for axis in (0, 1)
        },
    ),
    "a suspended path of axes with 100 counts per unit, whose limits differ": (
        "SCALE(0, 1) = 100, 100\nMAXSPEED(0) = 60 : MAXACCEL(1) = 600 : MAXDECEL(1) = 300\n"
        "VECTORR(0, 1) = 30, 40 : GO(0)\nWAIT(300)\nSUSPEND(0) = 1\nWAIT(300)\nCANCEL(0)\n",
        {
            1: [
                "0.000 rest:0",
                f"0.000 {SCALED} entry=1",
                f"0.300 {SCALED} comes_to_rest=True entry=1",
                "0.600 rest:0",
            ]
        },
    ),
    "a cam, and a stop after its last cycle": (
        "Dim c(5) As Float = 3, 10, 20, 5\nMASTERCHANNEL(1) = 0 : MASTERDISTANCE(1) = 10\nCAMTABLE(1, c, NULL)\n"
        "CAM(1) = 0\nGO(1)\nJOG(0) = 50\nWAIT(700)\nSTOP(1)\nWAIT(500)\n",
        {1: ["0.000 rest:0", f"0.000 {CAM}", f"0.000 {CAM}", "0.650 stop:5 rates=500/250", "0.750 rest:0"]},
    ),
    "a stop while a line is blended with an arc": (
        "MOVEBUFFERSIZE(0) = 10 : MOVEBUFFERSIZE(1) = 10\nBLENDMODE(0) = 1 : BLENDDISTANCE(0) = 5\n"
        "VECTORA(0, 1) = 30, 0\nCIRCLEA(0, 1) = 30, 20, 90\nGO(0)\nWAIT(560)\nSTOP(0)\nPAUSE IDLE(0)\n",
        {
            0: [
                "0.000 rest:0",
                f"0.000 path:4 speed=50 rates=500/250 {PATH_0}0",
                f"0.550 path:5 speed=50 rates=500/250 {BLENDED_ARC} entry=2 "
                f"tails=(path:4 speed=50 rates=500/250 {PATH_0}0)",
                f"0.560 path:5 speed=50 rates=500/250 {BLENDED_ARC} comes_to_rest=True entry=2 "
                f"tails=(path:4 speed=50 rates=500/250 {PATH_0[:-7]} comes_to_rest=True entry=0)",
                "0.750 rest:0",
            ]
        },
    ),
    "two blended paths whose rate changes": (
        "MOVEBUFFERSIZE(0) = 10 : MOVEBUFFERSIZE(1) = 10\nBLENDMODE(0) = 1 : BLENDDISTANCE(0) = 5\n"
        "VECTORA(0, 1) = 30, 0\nVECTORA(0, 1) = 30, 40\nGO(0)\nWAIT(400)\nACCEL(0) = 200\nPAUSE IDLE(0)\n",
        {
            0: [
                "0.000 rest:0",
                f"0.000 path:4 speed=50 rates=500/250 {PATH_0}0",
                f"0.400 path:4 speed=50 rates=200/250 {PATH_0}0",
                f"0.550 path:5 speed=50 rates=200/250 {PATH_1}2 tails=(path:4 speed=50 rates=200/250 {PATH_0}0)",
                "1.575 rest:0",
            ],
            1: [
                "0.000 rest:0",
                f"0.000 path:4 speed=50 rates=500/250 {PATH_0}1",
                f"0.400 path:4 speed=50 rates=200/250 {PATH_0}1",
                f"0.550 path:5 speed=50 rates=200/250 {PATH_1}3",
                "1.575 rest:0",
            ],
        },
    ),
}


@pytest.mark.parametrize("name", PROGRAMS)
def test_the_orders_of_a_program(name: str) -> None:
    text, expected = PROGRAMS[name]
    found = recorded(SETTINGS + text)
    assert {number: orders_of(found, number) for number in expected} == expected


def test_a_jog_that_is_changed_before_it_is_planned_again() -> None:
    """A new zero is no new order, and ACCEL acts from the next JOG on."""
    text = (
        "JOG(0) = 20\nWAIT(200)\nPOS(0) = 3\nWAIT(100)\nJOG(0) = -30\nWAIT(500)\nACCEL(0) = 100\nWAIT(50)\n"
    )
    found = recorded(SETTINGS + text + "JOG(0) = 45\nWAIT(20)\nCANCEL(0)\n")
    assert orders_of(found, 0) == [
        "0.000 rest:0",
        "0.000 jog:2 speed=20 rates=500/250 goal=20",
        "0.200 jog:2 speed=20 rates=500/250 goal=20 datum=-0.6",
        "0.300 jog:6 speed=30 rates=500/250 goal=-30 datum=-0.6",
        "0.850 jog:10 speed=45 rates=100/250 goal=45 datum=-0.6",
        "0.870 rest:0 datum=-0.6",
    ]
    ((key, order),) = found.unheeded.items()
    assert key == pytest.approx((0, 0.8))
    assert short(order) == "jog:6 speed=30 rates=100/250 goal=-30"
    ((key, word),) = found.standstills.items()
    assert key == pytest.approx((0, 0.87))
    assert (word, found.stopped(0, 0.8, 0.9)) == ("cancel", [(key[1], "cancel")])
    assert sorted(found.begun[0]) == pytest.approx([0.0, 0.3, 0.85], abs=1e-6)


def observed() -> tuple[Controller, ExpectedMotion]:
    """Return an axis with 50 counts/s, 500 counts/s² up and 250 down, observed."""
    controller = machine()
    found = controller.motion_listener = ExpectedMotion(controller)
    return controller, found


def test_stops_between_two_times() -> None:
    controller, found = observed()
    a = controller.axes[0]
    controller.move_to(0, 1000.0)
    for time, word in ((1.0, "stop"), (2.0, "fault"), (2.0, "stop"), (3.0, "stop")):
        controller.clock.advance(time)
        found.stop(a, word)
    for first, last, count in (
        (0.0, 9.0, 4),
        (1.0, 2.0, 3),
        (2.0, 2.0, 2),
        (1.1, 1.9, 0),
        (2.1, 3.0, 1),
        (3.1, 9.0, 0),
    ):
        assert len(found.stopped(0, first, last)) == count
    assert found.stopped(0, 1.5, 2.5) == [(2.0, "fault"), (2.0, "stop")]
    assert [found.was_stopped(0, "fault", time) for time in (1.9, 2.0, 2.1)] == [False, True, True]
    assert found.was_stopped(0, "stop", 1.0)
    assert not found.was_stopped(0, "cancel", 9.0)


def test_the_scales_of_a_time() -> None:
    """A scale is noted with the first profile that has it."""
    controller, found = observed()
    for time, counts in ((1.0, 1.0), (2.0, 1.0), (3.0, 10.0), (4.0, 20.0), (4.0, 30.0)):
        controller.clock.advance(time)
        controller.set_scale(0, counts, zero=5.0)
        controller.define_position(0, counts)
    times = (0.5, 1.0, 2.5, 3.0, 3.5, 4.0, 9.0)
    assert [{counts for counts, _ in found.scale(0, time)} for time in times] == [
        *(set[float](), {1.0}, {1.0}, {10.0}, {10.0}, {20.0, 30.0}, {30.0}),
    ]
    assert {zero for _, zero in found.scale(0, 9.0)} == {5.0}


@pytest.mark.parametrize(("most", "is_full"), [(102, False), (101, True)])
def test_so_many_profiles_are_recorded(most: int, is_full: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two new orders count as fifty each, and two standstills as one each."""
    monkeypatch.setattr(module, "MAX_PROFILES", most / 50)
    controller, found = observed()
    controller.move_to(0, 10.0, line=1)
    controller.clock.advance(1.0)
    if not is_full:
        assert [short(order) for order in found.of[0]] == [
            "rest:0",
            "move:1 speed=50 rates=500/250",
            "rest:0",
        ]
    controller.move_to(0, 20.0, line=2)
    controller.clock.advance(2.0)
    assert found.is_full is is_full
    assert (controller.motion_listener is not found) is is_full
    everything: list[Any] = [found.of, found.data, found.begun, found.stops, found.standstills]
    if is_full:
        assert not any(everything)
    else:
        assert found.begun[0] == {0.0, 1.0}
        assert found.of[0][2] is found.of[0][4] is module.REST
        assert len(found.of[0]) == len(found.data[0]) == 5


@pytest.mark.parametrize("cut", [0, 1, 2])
def test_orders_without_a_profile_are_dropped(cut: int) -> None:
    controller, found = observed()
    controller.move_to(0, 10.0)
    controller.clock.advance(1.0)
    if cut:
        found.of[0].append(Order("move", 9))
    if cut > 1:
        found.data[0] += [0.0, 0.0]
    assert not found.was_cut
    found.finish_updates()
    assert found.was_cut
    assert len(found.of[0]) == len(found.data[0]) == 3


def test_a_jog_of_another_velocity_that_is_not_adopted() -> None:
    """An axis jogs at -20, and its limit is 40 in both directions."""
    controller, found = observed()
    a = controller.axes[0]
    found.jogs(a, 30.0)  # at rest
    controller.move_to(0, 10.0)
    found.jogs(a, 30.0)  # in a move
    assert found.unheeded == {}
    controller.clock.advance(1.0)
    controller.jog(0, -20.0, line=4)
    controller.clock.advance(2.0)
    a.max_speed = 40.0
    found.jogs(a, -20.0)
    assert found.unheeded == {}
    for velocity, goal in ((30.0, 30.0), (-30.0, -30.0), (50.0, 40.0), (-50.0, -40.0)):
        found.jogs(a, velocity)
        ((key, order),) = found.unheeded.items()
        assert (key, order.goal, order.speed, order.rates) == ((0, 2.0), goal, abs(goal), (500.0, 250.0))


def test_a_ratio_that_is_not_adopted() -> None:
    controller = Controller(2)
    found = controller.motion_listener = ExpectedMotion(controller)
    a = controller.axes[0]
    found.gears(a, 3.0)  # it has no master
    controller.jog(1, 20.0)
    controller.gear(0, 1, 2.0)
    controller.clock.advance(1.0)
    for ratio in (3.0, -3.0):
        found.gears(a, ratio)
        ((key, order),) = found.unheeded.items()
        assert order.tie is not None
        assert (key, order.tie.ratio, order.tie.master) == ((0, 1.0), ratio, controller.axes[1])
    found.gears(a, 2.0)
    assert found.unheeded == {}


def test_settings_that_do_not_replace_a_profile() -> None:
    """A speed of 0 holds a move, which is recorded as a stop."""
    controller, found = observed()
    a = controller.axes[0]
    found.heed(a)  # at rest
    controller.move_to(0, 1000.0, line=3)
    assert a.move is not None
    a.move.speed = None  # that of the axis
    controller.clock.advance(1.0)
    found.heed(a)
    assert found.unheeded == {}
    a.speed = 0.5
    found.heed(a)
    ((key, order),) = found.unheeded.items()
    assert (key, short(order)) == ((0, 1.0), "move:3 speed=0.5 rates=500/250")
    a.speed = 50.0
    found.heed(a)
    assert found.unheeded == {}
    a.speed = 0.0
    found.heed(a)
    assert [order.kind for order in found.unheeded.values()] == ["stop"]
    found.unheeded.clear()
    a.speed = 50.0
    controller.stop(0)
    controller.configure(0, "decel", 100.0)
    found.heed(a)
    assert [order.kind for order in found.unheeded.values()] == []


@pytest.mark.parametrize(
    ("ordered", "direction", "table"),
    [
        (None, 1, None),
        (((0.0, 10.0), (0.0, 5.0), "linear"), 1, ((0.0, 10.0), (0.0, 5.0), "linear")),
        (((0.0, 10.0), (0.0, 5.0), "even"), 1, ((0.0, 10.0), (0.0, 5.0), "even")),
        (((0.0, -10.0), (0.0, 5.0), "even"), -1, ((0.0, 10.0), (0.0, 5.0), "even")),
        (((0.0, 0.5), (0.0, 5.0), "even"), 1, ((0.0, 0.5), (0.0, 5.0), "even")),
    ],
)
def test_the_distance_of_an_even_table_has_a_sign(ordered: Any, direction: int, table: Any) -> None:
    action: Any = SimpleNamespace(master="master", curve="curve", origin=7.0, direction=1, ordered=ordered)
    tie = module._tie(action)
    expected: Any = ("master", 0.0, inf, "curve", 7.0, direction, table, False)
    assert tie == expected


@pytest.mark.parametrize(
    ("speed", "rates", "found"),
    [
        (None, None, (500.0, 250.0)),
        (20.0, None, (200.0, 100.0)),
        (20.0, (7.0, None), (7.0, 100.0)),
        (None, (None, 3.0), (500.0, 3.0)),
        (None, (7.0, 3.0), (7.0, 3.0)),
    ],
)
def test_a_move_has_its_own_rates_or_those_of_its_speed(
    speed: float | None, rates: Any, found: tuple[float, float]
) -> None:
    """An axis at 50 counts/s takes 0.1 s up and 0.2 s down, at any speed."""
    a: Any = SimpleNamespace(speed=50.0, rates=lambda speed: (10.0 * speed, 5.0 * speed))
    move: Any = SimpleNamespace(speed=speed, rates=rates)
    assert module._rates(a, move) == found


@pytest.mark.parametrize(
    ("rate", "hard", "ended", "decel"),
    [
        (0.0, False, "stop", 200.0),
        (70.0, False, "stop", 70.0),
        (70.0, True, "stop", 70.0),
        (0.0, True, "stop", 200.0),
        (0.0, True, "fault", 900.0),
    ],
)
def test_the_rate_of_a_stop(rate: float, hard: bool, ended: str, decel: float) -> None:
    """A hard stop has the rate 900 of errors, which only a fault exempts from 200."""
    move: Any = SimpleNamespace(
        action=Stopping(hard, rate), speed=20.0, rates=None, overridden=True, ended=ended
    )
    a: Any = SimpleNamespace(
        speed=50.0, max_accel=150.0, max_decel=200.0, error_decel=900.0, shape="trapezoid", override=0.5,
        rates=lambda speed: (10.0 * speed, 15.0 * speed),
    )  # fmt: skip
    assert module._bounds(a, move) == (10.0, (150.0, decel), (inf, inf))
    move.overridden = False
    assert module._bounds(a, move)[0] == 20.0
