"""Homing with the home switch and index marks of the machine file."""

from __future__ import annotations

from math import inf, sqrt

import pytest

from motionlang import run
from motionlang.kernel import Controller, Source
from motionlang.kernel.controller.faults import SOFT_LIMIT_FORWARD, SOFT_LIMIT_REVERSE
from motionlang.kernel.controller.io.wiring import World
from motionlang.kernel.controller.triggers.homing import Homing, next_index
from tests.cases import cases

# The machine's own zero is 20 counts below its position; the switch is active from -4 to 1, marks every 10.
SETTINGS = {"axis.0.start": 20.0, "axis.0.home_switch": [-4.0, 1.0], "axis.0.index_every": 10.0}


def machine(settings: dict[str, object] | None = None) -> Controller:
    c = Controller(1)
    for name, value in (("speed", 8.0), ("accel", 16.0), ("decel", 16.0)):
        c.configure(0, name, value)
    World(c, SETTINGS if settings is None else settings)
    return c


def where(c: Controller) -> float:
    """Return the position on the machine's own scale."""
    return c.position(0) - c.axes[0].datum + 20.0


def test_homing_on_the_switch_puts_zero_on_its_edge() -> None:
    c = machine()
    homing = Homing(c, 0, -1, 8.0, 0.8, 0.8)
    c.clock.advance(60.0)
    assert (homing.found, homing.state) == (True, "done")
    # Left at 0.8 counts/s, the axis stops v²/2a = 0.02 beyond the edge at 1.0.
    assert c.position(0) == pytest.approx(0.02)
    assert where(c) == pytest.approx(1.02)


def test_homing_on_switch_and_index_puts_zero_on_the_mark() -> None:
    c = machine()
    Homing(c, 0, -1, 8.0, 0.8, 0.4, index=True)
    c.clock.advance(60.0)
    assert where(c) == pytest.approx(10.005)
    assert c.position(0) == pytest.approx(0.005)


def test_homing_on_the_index_alone() -> None:
    c = machine()
    Homing(c, 0, +1, 4.0, 4.0, 4.0, switch="index", datum=100.0)
    c.clock.advance(60.0)
    assert where(c) == pytest.approx(30.5)
    assert c.position(0) == pytest.approx(100.5)


def test_an_axis_at_rest_on_the_switch_backs_off_at_once() -> None:
    c = machine({"axis.0.start": 0.0, "axis.0.home_switch": [-4.0, 1.0]})
    Homing(c, 0, -1, 8.0, 0.8, 0.8)
    c.clock.advance(60.0)
    assert c.position(0) == pytest.approx(0.02)
    assert all(move.profile is not None and move.profile.distance >= 0 for move in c.log.moves)


def test_a_stop_that_overruns_the_whole_switch_comes_back_to_it() -> None:
    c = machine({"axis.0.start": 20.0, "axis.0.home_switch": [0.5, 1.0]})
    homing = Homing(c, 0, -1, 8.0, 0.8, 0.8)
    c.clock.advance(60.0)
    assert homing.found
    assert where(c) == pytest.approx(1.02)


def test_a_fault_ends_the_homing() -> None:
    c = machine()
    homing = Homing(c, 0, -1, 8.0, 0.8, 0.8)
    c.clock.advance(0.5)
    c.fault(0, 2, "off")
    assert (homing.found, homing.state) == (False, "done")


def test_without_a_switch_the_search_never_ends() -> None:
    c = machine({})
    homing = Homing(c, 0, -1, 8.0, 0.8, 0.8)
    c.clock.advance(1000.0)
    assert homing.state == "search"
    assert c.idle_time(0) == float("inf")


def test_index_marks_are_where_the_machine_has_them() -> None:
    c = machine()
    assert next_index(c, 0, +1) == 10.0
    assert next_index(c, 0, -1) == -10.0
    c.define_position(0, 1000.0)
    assert next_index(c, 0, +1) == 10.0


def test_an_offset_is_gone_to_from_the_datum() -> None:
    c = machine()
    c.define_position(0, 500.0)
    homing = Homing(c, 0, -1, 8.0, 0.8, 0.8, offset=-0.5, datum=3.0)
    c.clock.advance(60.0)
    assert homing.before == pytest.approx(500.0 - 19.0)
    assert c.position(0) == pytest.approx(2.5)
    assert (homing.state, c.is_idle(0)) == ("done", True)


def test_homing_on_a_limit_switch_is_no_error() -> None:
    c = machine({"axis.0.start": 20.0, "axis.0.travel": [0.0, 50.0]})
    ended: list[bool] = []
    Homing(c, 0, -1, 8.0, 0.8, 0.8, switch="limit", ended=lambda homing: ended.append(homing.found))
    c.clock.advance(60.0)
    assert c.position(0) == pytest.approx(0.02)
    assert (ended, c.faults(0)) == ([True], 0)
    c.jog(0, -1.0)
    c.clock.advance(90.0)
    assert c.faults(0) != 0  # and an error again afterwards


@pytest.mark.parametrize("command", ["JOG(0) = 2", "SPEEDREF(0) = 2", "JOG(1) = 2 : FOLLOW(0) = 1"])
def test_another_motion_ends_the_homing_at_once(command: str) -> None:
    """It passes the mark at 10 at 2/s and goes on.

    No datum is set, and nothing stops it.
    """
    program = f"""\
JOG(1) = 2 : MASTERSOURCE(0) = _msPOS : MASTERCHANNEL(0) = 1
HOMESPEED(0) = 4 : HOME(0) = _hmPOSITIVE_INDEX : WAIT = 500
{command}
PRINT HOMEPHASE(0); " "; HOMESTATUS(0)
WAIT = 10000
PRINT HOMEPHASE(0); " "; HOMESTATUS(0); " "; VEL(0)
"""
    result = run(Source("a.mnt", program), machine={"axis.0.index_every": 10.0}, until=10.6)
    assert result.output == ["0 0", "0 0 2.0000"]
    assert result.controller.position(0) > 20.0


def test_a_step_that_is_refused_is_an_error_of_the_program() -> None:
    """The switch at -20 is reached at 2000/s, after 20 ms at 10⁵/s².

    The axis rests another 20 ms later. It would back off there, but its brake has been set by hand.
    """
    program = """\
HOME(0) = _hmNEGATIVE_SWITCH : MOTORBRAKE(0) = 1
WAIT = 500
PRINT HOMEPHASE(0); " "; IDLE(0); " "; POS(0)
End
Event ONERROR
  PRINT ERRORSTRING(ERRCODE); " at "; TIME
  ERRORCLEAR(_egALL, 0)
End Event
"""
    machine = {"axis.0.home_switch": [-30.0, -20.0], "controller.instruction_time": 1e-9}
    result = run(Source("a.mnt", program), machine=machine, until=10.0)
    assert result.output == ["motor brake on at 40", "0 1 -40.0000"]


def test_a_homing_has_its_own_rates_and_leaves_those_of_the_axis_alone() -> None:
    """At HOMEACCEL 20, a speed of 10 is reached in 0.5 s.

    At HOMEDECEL 40 it is left in 0.25 s after the mark at 10. The return over 1.25, at a creep speed of 1, has ramps
    of 0.05 s and 0.025 s. The jog that follows has the ACCEL that was written during the homing.
    """
    program = """\
SPEED(0) = 10 : ACCEL(0) = 100 : DECEL(0) = 50
HOMESPEED(0) = 10 : HOMEACCEL(0) = 20 : HOMEDECEL(0) = 40
HOME(0) = _hmPOSITIVE_INDEX
PRINT ACCEL(0); " "; DECEL(0)
ACCEL(0) = 400
PAUSE IDLE(0)
PRINT TIME; " "; ACCEL(0); " "; DECEL(0)
JOG(0) = 40 : WAIT = 100 : PRINT VEL(0)
"""
    machine = {"axis.0.index_every": 10.0, "controller.instruction_time": 1e-9}
    result = run(Source("a.mnt", program), machine=machine, until=10.0)
    there = 0.5 + (10.0 - 2.5) / 10.0 + 0.25
    back = 1.25 + 0.5 * (0.05 + 0.025)
    assert result.output == ["100.0000 50.0000", f"{int(1000 * (there + back))} 400.0000 50.0000", "40.0000"]
    assert [move["duration"] for move in result.report["moves"][:2]] == pytest.approx([there, back])


def test_a_homing_with_rates_of_its_own_needs_none_of_the_axis() -> None:
    """It ends on the mark at 10 although ACCEL and DECEL are 0."""
    rates = "ACCEL(0) = 0 : DECEL(0) = 0 : HOMESPEED(0) = 10 : HOMEACCEL(0) = 20 : HOMEDECEL(0) = 40\n"
    program = rates + "HOME(0) = _hmPOSITIVE_INDEX : PAUSE IDLE(0) : PRINT HOMESTATUS(0); POS(0)\n"
    result = run(Source("a.mnt", program), machine={"axis.0.index_every": 10.0}, until=10.0)
    assert result.output == ["10.0000"]


def test_rest_is_not_notified_before_the_end() -> None:
    c = machine()
    idle: list[float] = []
    c.listeners.append(
        lambda what, axis: idle.append(c.clock.now) if what == "idle" and c.is_idle(axis) else None
    )
    Homing(c, 0, -1, 8.0, 0.8, 0.8)
    c.clock.advance(60.0)
    assert len(idle) == 1


@cases(
    "position, origin, up, down",
    [
        # Marks 10 counts apart through the origin; on a mark the next one is meant.
        (0.0, 0.0, 10.0, -10.0), (3.0, 0.0, 10.0, 0.0), (-3.0, 0.0, 0.0, -10.0), (9.999, 0.0, 10.0, 0.0),
        (10.0, 0.0, 20.0, 0.0), (0.0, 4.0, 4.0, -6.0), (4.0, 4.0, 14.0, -6.0), (5.0, 4.0, 14.0, 4.0),
        (0.0, -4.0, 6.0, -4.0),
    ],
)  # fmt: skip
def test_the_next_index_mark_in_each_direction(
    position: float, origin: float, up: float, down: float
) -> None:
    """They are machine positions, which a new zero of the program does not move."""
    for every, counts in ((10.0, 1.0), (2.5, 4.0), (-2.5, 4.0)):
        c = machine({})
        a = c.axes[0]
        c.set_scale(0, counts)
        a.index_every, a.index_origin = every, origin
        c.move_to(0, position)
        c.clock.advance(9.0)
        for _ in range(2):
            assert (next_index(c, 0, 1), next_index(c, 0, -1)) == (up, down)
            c.define_position(0, 77.0)
    assert (next_index(machine({}), 0, 1), next_index(machine({}), 0, -1)) == (inf, -inf)


@pytest.mark.parametrize(
    ("rates", "limits", "offset", "end"),
    [
        # 0.5 s up to 4, 9 at 4, 0.25 s to rest at 0.5; 0.5 more is a triangle with a peak of 4/sqrt(3).
        ((8.0, None), {}, 1.0, 0.5 + 2.25 + 0.25 + 4.0 / sqrt(3.0) * (1 / 8 + 1 / 16)),
        # 0.25 s up, 9.5 at 4, 0.5 s to rest at 1; 1 more is a triangle with a peak of sqrt(32 / 3).
        ((None, 8.0), {}, 2.0, 0.25 + 2.375 + 0.5 + sqrt(32.0 / 3.0) * (1 / 8 + 1 / 16)),
        # At 2 and 4 every ramp takes 0.5 s over 0.5: 9.5 at 2 up to the mark, and 0.5 at 2 after it.
        ((8.0, 8.0), {"max_speed": 2.0, "max_accel": 4.0, "max_decel": 4.0}, 2.0, 0.5 + 4.75 + 0.5 + 1.25),
    ],
)
def test_a_homing_goes_to_its_offset_at_its_own_rates_and_within_the_limits(
    rates: tuple[float | None, float | None], limits: dict[str, float], offset: float, end: float
) -> None:
    """The mark at 30 is 10 counts ahead; the rates of the axis are 16."""
    c = machine()
    for name, value in limits.items():
        c.configure(0, name, value)
    Homing(c, 0, +1, 4.0, 4.0, 4.0, switch="index", offset=offset, rates=rates)
    idle: list[float] = []
    c.listeners.append(
        lambda what, axis: idle.append(c.clock.now) if what == "idle" and c.is_idle(axis) else None
    )
    c.clock.advance(60.0)
    assert idle == [pytest.approx(end)]
    assert c.position(0) == pytest.approx(offset)
    assert [move.command for move in c.log.moves] == ["HOME", "HOME"]


AWAY = "axis 0 homes away from its {} and never reaches it"


@pytest.mark.parametrize(
    ("settings", "direction", "what", "provided", "reason"),
    [
        (SETTINGS, -1, "home", True, ""),
        (SETTINGS, 1, "home", True, AWAY.format("switch")),
        ({}, -1, "home", True, AWAY.format("switch")),
        ({}, -1, "home", False, "axis 0 homes towards a switch that does not exist"),
        ({}, -1, "limit", True, AWAY.format("limit switch")),
        ({}, -1, "limit", False, "axis 0 homes towards a limit switch that does not exist"),
        ({"axis.0.travel": [-50.0, 50.0]}, -1, "limit", True, ""),
        ({"axis.0.travel": [-50.0, 50.0]}, 1, "home", True, ""),
        ({}, 1, "index", True, "axis 0 homes and never reaches an index mark"),
        ({}, 1, "index", False, "axis 0 homes and never reaches an index mark"),
        (SETTINGS, 1, "index", True, ""),
    ],
)
def test_the_reason_why_a_homing_never_ends(
    settings: dict[str, object], direction: int, what: str, provided: bool, reason: str
) -> None:
    """Two software limits, which do not act during a homing, make no difference."""
    c = machine(settings)
    for sign, bit in ((1, SOFT_LIMIT_FORWARD), (-1, SOFT_LIMIT_REVERSE)):
        soft = c.add_limit(0, sign, bit, "stop")
        soft.set_position(sign * 500.0)
    homing = Homing(c, 0, direction, 8.0, 0.8, 0.8, switch=what, provided=provided)
    c.clock.advance(0.1)
    assert homing.endless_motion == reason
    c.suspend(0)
    assert homing.endless_motion == ""
    c.resume(0)
    assert homing.endless_motion == reason
    homing.cancel()
    assert homing.endless_motion == ""


def test_the_reason_why_a_homing_never_leaves_its_switch() -> None:
    """The switch was closed by hand, so the axis never leaves it."""
    c = machine({})
    c.set_home_switch(0, True)
    homing = Homing(c, 0, -1, 8.0, 0.8, 0.8, provided=False)
    assert homing.endless_motion == "axis 0 backs off its switch and never leaves it"
    c.clock.advance(1.0)
    assert c.velocity(0) == pytest.approx(0.8)
    c.set_home_switch(0, False)
    assert homing.endless_motion == ""


def test_the_reason_why_a_homing_never_returns_to_its_switch() -> None:
    """The switch opened during the stop, so the axis is past it."""
    c = machine({})
    homing = Homing(c, 0, -1, 8.0, 0.8, 0.8)
    c.clock.advance(1.0)
    c.set_home_switch(0, True)
    c.set_home_switch(0, False)
    c.clock.advance(10.0)
    assert homing.state == "back-off"
    assert homing.endless_motion == "axis 0 ran past its switch while stopping and does not meet it again"
