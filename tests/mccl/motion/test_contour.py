"""Contour paths are exactly on their geometry, at the vector velocity."""

from __future__ import annotations

from itertools import pairwise
from math import hypot, pi
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang import Run
from motionlang.mccl.motion.contour import Contour
from tests.cases import cases
from tests.mccl.conftest import Runner

HEAD = "1MN,2MN,1CM1,2CM1,1VV20000,1VA200000,1VD200000\n"


def state(run: Run, time: float) -> tuple[float, float, float, float]:
    """Return position and velocity of both axes: x, y, vx, vy."""
    a, b = (run.controller.axes[axis].at(time) for axis in (1, 2))
    return a.position, b.position, a.velocity, b.velocity


@pytest.mark.parametrize("shape", ["1PT", "1PS", "1PS0.2", "1PP"])
def test_a_full_circle_stays_on_the_circle(shape: str, mccl: Runner) -> None:
    result = mccl(f"{HEAD}{shape}\n1CP2,1CR10000,2CR0,1MR0,2MR0\n1WS,1TP,2TP")
    assert result.output == ["01 0", "02 0"]
    begin = result.controller.log.moves[0].start_time
    for k in range(401):
        x, y, vx, vy = state(result, begin + (result.time - begin) * k / 400)
        assert hypot(x - 10000, y) == pytest.approx(10000, abs=2e-4)
        assert hypot(vx, vy) <= 20000.5
    middle = state(result, begin + (result.time - begin) / 2)
    assert hypot(*middle[2:]) == pytest.approx(20000, rel=1e-6)


def test_paths_that_join_smoothly_are_run_through(mccl: Runner) -> None:
    """100 000, a half circle of radius 50 000 and 100 000: one ramp up, one down."""
    text = f"{HEAD}1CP1,1MA100000,2MA0\n1CP3,1CA100000,2CA50000,1MA100000,2MA100000\n1CP1,1MA0,2MA100000\n1WS,1TX"
    result = mccl(text)
    assert result.output == ["01 3"]
    assert [(move.axis, move.line, move.ended) for move in result.controller.log.moves] == [
        (axis, line, "") for line in (2, 3, 4) for axis in (1, 2)
    ]
    length = 200000 + 50000 * pi
    duration = sum(move.profile.duration for move in result.controller.log.moves[::2])  # type: ignore[misc, union-attr]
    assert duration == pytest.approx(length / 20000 + 0.1, rel=1e-9)
    for time in (2.0, 6.0, 9.0, 12.0):
        assert hypot(*state(result, time)[2:]) == pytest.approx(20000, rel=1e-6)


def test_at_a_corner_the_axes_come_to_rest(mccl: Runner) -> None:
    result = mccl(f"{HEAD}1CP1,1MA10000,2MA0\n1CP1,1MA10000,2MA10000\n1WS")
    first, second = (move for move in result.controller.log.moves if move.axis == 1)
    assert first.profile.duration == pytest.approx(0.6)  # type: ignore[union-attr]
    assert second.start_time == pytest.approx(first.start_time + 0.6, abs=1e-9)
    assert state(result, second.start_time)[2:] == (0.0, 0.0)


def test_stop_stays_on_the_path_and_forgets_the_rest(mccl: Runner) -> None:
    result = mccl(f"{HEAD}1CP1,1MA30000,2MA40000\n1CP1,1MA0,2MA0\nWA1,1ST,1WS,1TP,2TP")
    # 20000 counts/s: 0.95 s of travel less the ramp, and 1000 counts to stop.
    x, y = (int(line.split()[1]) for line in result.output)
    assert hypot(x, y) == pytest.approx(20000 * 1.00001 - 1000 + 1000, abs=2)
    assert y * 3 == pytest.approx(x * 4, abs=4)
    assert {move.ended for move in result.controller.log.moves} == {"stop"}


# Paths that do not have the same axes run one after another, each from rest to rest.
APART = "1CP1,1MR1000,1CP1,2MR1000,1CP1,1MR1000,"


@pytest.mark.parametrize("wait", ["1WS", "1WT", "1SN,1NS,1WS", "1WA0.1,1WS", 'LU"STATUS",1RL@0,IC3,JR-3,NO'])
def test_an_axis_whose_path_waits_has_not_stopped(mccl: Runner, wait: str) -> None:
    """Axis 1 is at rest while axis 2 moves, but its target is 2000."""
    result = mccl(f"{HEAD}{APART}{wait},1TP,2TP,1TX")
    assert result.output == ["01 2000", "02 1000", "01 3"]


def test_the_target_is_the_end_of_the_path_that_waits(mccl: Runner) -> None:
    """Bit 3 of the status word is clear: 4098 is motor on and amplifier on."""
    result = mccl(f"{HEAD}{APART}1TT,2TT,2TO,2TS,2WS,2TO,2TS,1WS,1TT,1TS")
    assert result.output == [
        "01 2000",
        "02 1000",
        "02 0",
        "02 4098",
        "02 1000",
        "02 4110",
        "01 2000",
        "01 4110",
    ]


@pytest.mark.parametrize(
    "paths", ["1CP1,1MR1000,1CP1,1MR1000,1CP1,1MR-1000", "1CP1,1MR1500,RP1,1CP1,1MR-2000"]
)
def test_the_target_is_the_end_of_the_last_path(mccl: Runner, paths: str) -> None:
    """The axis is at target within 100 of it, on its last path only."""
    start = f"{HEAD}1DB100,{paths},1TT,"
    for wait in ("1WT,", 'LU"STATUS",1RL@0,IC2,JR-3,NO,'):
        run = mccl(f"{start}{wait}1TO,1TX,1WS,1TT,1TP")
        assert run.output == ["01 1000", "01 1100", "01 2", "01 1000", "01 1000"]


@pytest.mark.parametrize("wait", ["3WS", "3WT", "4WS", 'LU"STATUS",4RL@0,IC3,JR-3,NO'])
def test_a_slave_waits_for_the_paths_of_its_master(mccl: Runner, wait: str) -> None:
    """Axis 3 follows axis 1 at a ratio of 2, and axis 4 follows axis 3 at -1."""
    gears = "3MN,4MN,3SS2,3SM1,4SS-1,4SM3\n"
    run = mccl(f"{gears}{HEAD}{APART}3TT,4TT,{wait},1TP,3TP,4TP,3TT,4TT")
    assert run.output == ["03 4000", "04 -4000", "01 2000", "03 4000", "04 -4000", "03 4000", "04 -4000"]


@pytest.mark.parametrize("axis", [1, 2, 3])
def test_stop_of_an_axis_that_waits_or_controls_stops_the_contour(mccl: Runner, axis: int) -> None:
    """After 0.1 s at 100000 counts/s² axis 3 is at 500, and needs as much to stop."""
    paths = "1CP1,3MR10000,1CP1,2MR1000,"
    result = mccl(f"{HEAD}3MN,3CM1,1VA100000,1VD100000,{paths}WA0.1,{axis}ST,3TT,1WS,2WS,3WS,1TP,2TP,3TP,1TX")
    assert [int(line.split()[1]) for line in result.output] == [
        pytest.approx(1000, abs=5),
        0,
        0,
        pytest.approx(1000, abs=5),
        0,
    ]


@pytest.mark.parametrize("axis", [1, 2, 3])
def test_abort_of_an_axis_that_waits_or_controls_aborts_the_contour(mccl: Runner, axis: int) -> None:
    paths = "1CP1,3MR10000,1CP1,2MR1000,"
    result = mccl(f"{HEAD}3MN,3CM1,1VA100000,1VD100000,{paths}WA0.1,{axis}AB,3TV,3TP,1WS,2WS,3WS,2TP,3TP,1TX")
    assert result.output == ["03 0", "03 500", "02 0", "03 500", "01 0"]


@pytest.mark.parametrize("second", ["1CP1,1MR500", "1CP1,2MR500,1CP1,1MR500", "1CP1,1MR500,2MR0"])
def test_a_path_that_is_commanded_after_go_waits_for_the_next_one(mccl: Runner, second: str) -> None:
    """It waits, also if the path before it runs at that time; NS lets it start."""
    for release in ("1GO", "1NS"):
        run = mccl(f"{HEAD}1SN,1CP1,1MR1000,1GO,{second},1TT,1WS,WA1,1TP,1TX,{release},1TT,1WS,1TP")
        assert run.output == ["01 1000", "01 1000", "01 1", "01 1500", "01 1500"]


def test_a_wait_goes_on_to_paths_that_another_task_commands(mccl: Runner) -> None:
    text = "MD1,WA0.05,1CP1,2MR500,1CP1,1MR500\n1MN,2MN,1CM1,2CM1,GT1,1CP1,1MR1000,1WS,1TP,2TP"
    assert mccl(text).output == ["01 1500", "02 500"]


@pytest.mark.parametrize("path", ["1CP1,2MR0", "1SN,1CP1,2MR0,1GO,1CP1,1MR500"])
def test_a_path_starts_where_the_axis_is_after_it_left_the_contour(mccl: Runner, path: str) -> None:
    run = mccl(f"{HEAD}{path},2PM,2MA300,2WS,2CM1,1CP1,2MR100,1GO,1WS,2WS,2TP")
    assert run.output == ["02 400"]


@pytest.mark.parametrize("wait", [0.45 + k * 0.0043 for k in range(34)])
def test_a_path_given_while_another_one_stops_waits_until_it_rests(mccl: Runner, wait: float) -> None:
    """The stop may end at the end of its path, which rounding must not decide."""
    result = mccl(f"{HEAD}1CP1,1MA10000,2MA0\nWA{wait},1ST,1CP1,1MA20000,2MA0\n1WS,1TX,1TP")
    first, second = (move for move in result.controller.log.moves if move.axis == 1)
    assert first.profile is not None
    assert (first.ended, first.profile.end_velocity) == ("stop", 0.0)
    assert second.start_time == pytest.approx(first.start_time + first.profile.duration, abs=1e-9)
    whole = first.profile.end == 10000.0
    assert whole is (wait > 0.4999)
    assert result.output == ["01 2" if whole else "01 1", "01 20000"]


@pytest.mark.parametrize("shape", ["1PS", "1PS0.2", "1PP"])
@pytest.mark.parametrize("wait", [0.55, 0.6])
def test_a_stop_never_runs_beyond_the_end_of_the_paths(mccl: Runner, shape: str, wait: float) -> None:
    result = mccl(f"{HEAD}{shape}\n1CP1,1MA10000,2MA0\nWA{wait},1ST\n1WS")
    (move,) = (move for move in result.controller.log.moves if move.axis == 1)
    assert move.profile is not None
    assert 9990.0 < move.profile.end <= 10000.0


@pytest.mark.parametrize("command", ["1ST", "1VO0.3"])
@pytest.mark.parametrize("wait", [0.0, 0.02, 0.137, 0.4])
def test_an_arc_that_is_stopped_or_slowed_stays_on_the_circle(
    mccl: Runner, command: str, wait: float
) -> None:
    """That is true at any time, including between two of the cubics of the arc."""
    result = mccl(f"{HEAD}1CP3,1CR-5000,2CR0,1EA180\nWA{wait},{command}\n1WS")
    assert result.diagnostics == []
    for k in range(200):
        x, y, vx, vy = state(result, result.time * k / 200)
        assert hypot(x + 5000, y) == pytest.approx(5000, abs=1e-3)
        assert (x + 5000) * vx + y * vy == pytest.approx(0.0, abs=5000 * 20000 * 1e-5)


@pytest.mark.parametrize(
    ("path", "end"),
    [
        ("1CP3,1CA0,2CA10000,1MA10009,2MA10000", (10009, 10000)),
        ("1CP2,1CA5000,2CA0,1MA9996,2MA0", (9996, 0)),
        ("1CP3,1CA0,2CA10000,1MA10,2MA-5", (10, -5)),  # half a thousandth of the radius, at the very start
        ("1CP3,1CA-10000,2CA0,1MA-10000,2MA-10003", (-10000, -10003)),  # three quarters of a circle
    ],
)
def test_an_arc_that_misses_its_end_a_little_goes_through_it(
    path: str, end: tuple[int, int], mccl: Runner
) -> None:
    """By the proof it is one circle at the vector velocity, without a jump."""
    result = mccl(f"{HEAD}{path}\n1WS,1TP,2TP", prove=True)
    assert result.output == [f"01 {end[0]}", f"02 {end[1]}"]
    assert result.proof().violations == []
    begin = result.controller.log.moves[0].start_time
    times = [begin + (result.time - begin) * k / 2000 for k in range(2001)]
    distances = [hypot(b[0] - a[0], b[1] - a[1]) for a, b in pairwise([state(result, t) for t in times])]
    assert max(distances) <= 20000 * (result.time - begin) / 2000 * (1 + 1e-9)


@pytest.mark.parametrize("path", ["1CP3,1CA0,2CA10000,1MA10011,2MA10000", "1CP2,1CA5000,2CA0,1MA-1,2MA0"])
def test_an_arc_that_misses_its_end_by_much_or_after_a_whole_turn_is_refused(path: str, mccl: Runner) -> None:
    result = mccl(f"{HEAD}{path}\n1TP")
    assert result.output == ["?-1", "01 0"]
    assert "from the centre" in result.diagnostics[0].message


def test_paths_whose_directions_differ_by_the_rounding_of_their_ends_are_run_through(mccl: Runner) -> None:
    """The second path continues 3001, 997 by half of it, rounded to whole counts."""
    result = mccl(f"{HEAD}1CP1,1MA3001,2MA997\n1CP1,1MA4502,2MA1496\n1WS,1TX", prove=True)
    assert result.output == ["01 2"]
    assert result.proof().violations == []
    first, second = (move for move in result.controller.log.moves if move.axis == 1)
    assert first.profile is not None
    assert first.profile.end_velocity > 1000.0


def test_the_override_acts_on_the_path_under_way(mccl: Runner) -> None:
    result = mccl(f"{HEAD}1CP1,1MA60000,2MA80000\nWA1,1VO0.5\n1WS,1TP,2TP")
    assert result.output == ["01 60000", "02 80000"]
    assert hypot(*state(result, 2.0)[2:]) == pytest.approx(10000, rel=1e-9)


def test_a_scaled_contour_is_measured_in_its_own_units(mccl: Runner) -> None:
    """Axis 2 has twice the counts per millimetre; the path is a circle in millimetres."""
    text = "1US100,2US200,1MN,2MN,1CM1,2CM1,1VV50,1VA500,1VD500\n1CP2,1CR40,2CR0,1MR0,2MR0\n1WS"
    result = mccl(text)
    begin, end = result.controller.log.moves[0].start_time, result.time
    for k in range(101):
        x, y, _, _ = state(result, begin + (end - begin) * k / 100)
        assert hypot(x / 100 - 40, y / 200) == pytest.approx(40, abs=2e-6)


def test_a_fault_of_one_axis_stops_the_others(mccl: Runner) -> None:
    machine = {"fault": [{"axis": 2, "kind": "following-error", "at": 0.3}]}
    result = mccl(f"{HEAD}1CP1,1MA30000,2MA40000\n1WS,1TV,2TV", machine=machine)
    assert result.output == ["01 0", "02 0"]
    assert result.time < 0.31


@pytest.mark.parametrize("then", ["1VO0.5", "1CP1,1MR20000,2MR20000", "NO"])
def test_a_new_zero_in_a_running_path_shifts_the_path_with_it(then: str, mccl: Runner) -> None:
    """The end of the path stays at the same physical position with any new zero."""
    start = f"{HEAD}1CP1,1MA20000,2MA20000\nWA0.5\n"
    plain = mccl(f"{start}1VO1\n{then}\n1WS,1TP,2TP")
    shifted = mccl(f"{start}1TP,1DH500000\n{then}\n1WS,1TP,2TP")
    assert shifted.diagnostics == []
    here, x, y = (int(line.split()[1]) for line in shifted.output)
    end = int(plain.output[0].split()[1])
    assert x == pytest.approx(end + 500000 - here, abs=1)
    assert y == end
    times = [shifted.time * k / 400 for k in range(401)]
    speeds = [hypot(*state(shifted, time)[2:]) for time in times]
    assert max(speeds) <= 20000.5


def test_paths_that_wait_shift_with_a_new_zero(mccl: Runner) -> None:
    result = mccl(f"{HEAD}1SN,1CP1,1MA20000,2MA0\n1CP3,1CA20000,2CA5000,1EA90\n1DH-7000,1GO,1WS,1TP,2TP")
    assert result.output == ["01 13000", "02 10000"]


def test_a_helix_that_waits_shifts_with_a_new_zero_of_its_rise(mccl: Runner) -> None:
    waiting = "1SN,1CP1,1MA20000,2MA0,3MA0\n1CP3,1CA20000,2CA5000,3MA8000,1EA90\n"
    result = mccl(f"3MN,3CM1,{HEAD}{waiting}3DH-7000,1GO,1WS,1TP,2TP,3TP")
    assert result.output == ["01 20000", "02 10000", "03 1000"]


def test_an_arc_whose_axes_are_given_a_new_zero_stays_a_circle(mccl: Runner) -> None:
    result = mccl(f"{HEAD}1CP3,1CR-5000,2CR0,1EA180\nWA0.3,1DH0,2DH0,1VO0.4,1WS")
    moves = result.controller.log.moves
    assert result.diagnostics == []
    assert moves[0].profile is not None
    assert moves[1].profile is not None
    # The log keeps the coordinates in which the path began.
    for k in range(200):
        x, y = (
            move.profile.position(move.profile.duration * k / 200)  # type: ignore[union-attr]
            for move in moves[:2]
        )
        assert hypot(x + 5000, y) == pytest.approx(5000, abs=1e-3)


def test_units_that_change_in_a_running_path_leave_it_where_it_is(mccl: Runner) -> None:
    result = mccl(f"{HEAD}1CP1,1MA20000,2MA20000\nWA0.5,1US100,1MN,1VO0.5\n1WS,1TP,2TP")
    assert result.output == ["01 200.000000", "02 20000"]


@pytest.mark.parametrize("leave", ["1MF,1MN", "1AB", "1PM,1MA500,1WS,1CM1", "1RT,1MN,1CM1"])
def test_paths_that_wait_are_forgotten_when_an_axis_leaves(leave: str, mccl: Runner) -> None:
    result = mccl(f"{HEAD}1SN,1CP1,1MA20000,2MA0\n{leave},1TP,1GO,1WS,1TP")
    assert result.output[0] == result.output[1]


@pytest.mark.parametrize("shape", ["1PT", "1PS", "1PS0.2", "1PP"])
def test_an_arc_is_exact(shape: str, mccl: Runner) -> None:
    result = mccl(f"{HEAD}{shape}\n1CP2,1CR10000,2CR0,1MR0,2MR0\nWA1,1ST,1WS")
    for k in range(401):
        x, y, vx, vy = state(result, result.time * k / 400)
        assert hypot(x - 10000, y) == pytest.approx(10000, abs=1e-7)
        assert (x - 10000) * vx + y * vy == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize("path", [True, False], ids=["contour", "move"])
@pytest.mark.parametrize("shape", ["1PS", "1PS0.2"])
@pytest.mark.parametrize("wait", [0.03, 0.08, 0.12, 0.5])
def test_a_stop_out_of_a_shaped_ramp_does_not_jump(shape: str, wait: float, path: bool, mccl: Runner) -> None:
    """The acceleration of 200000 counts/s² takes at least 0.002 s to rise or fall."""
    move = "1CP1,1MR100000,2MR0" if path else "1PM,1SV20000,1SA200000,1SD200000,1MR100000"
    result = mccl(f"1MN,2MN\n{HEAD if path else ''}{shape}\n{move}\nWA{wait},1ST,1WS")
    axis = result.controller.axes[1]
    bends = [axis.at(result.time * k / 4000).acceleration for k in range(4000)]
    assert max(abs(b - a) for a, b in pairwise(bends)) <= 200_000.0 * (result.time / 4000) / 0.002
    assert axis.at(result.time).velocity == 0.0


def test_a_path_that_goes_somewhere_has_a_length(mccl: Runner) -> None:
    result = mccl(f"{HEAD}1CP0,1CD0,1MR10\n1CP0,1CD0,1MR0\n1WS,1TP,1TX")
    assert result.output == ["?-1", "01 0", "01 1"]


def test_a_user_defined_path_that_has_a_length_and_leads_nowhere_takes_its_time(mccl: Runner) -> None:
    """10000 at 20000 counts/s with ramps of 0.1 s: 0.5 s + 0.1 s, both axes at rest."""
    result = mccl(f"{HEAD}1CP0,1CD10000,1MR0,2MR0\n1WS,1TP,1TX", prove=True)
    assert result.output == ["01 0", "01 1"]
    assert result.time == pytest.approx(0.6, abs=1e-3)


def test_an_arc_described_while_a_path_stops_begins_where_it_rests(mccl: Runner) -> None:
    """The path stops from 20000 counts/s within 1000 counts of ST.

    The arc ends a quarter of a revolution from where it starts.
    """
    result = mccl(f"{HEAD}1CP1,1MA90000,2MA0\nWA1,1ST,1CP3,1CR0,2CR500,1ER90\n1WS,1TP,2TP", prove=True)
    x, y = (int(line.split()[1]) for line in result.output)
    assert x == pytest.approx(20500, abs=2)
    assert y == 500
    assert result.proof().violations == []


def test_a_path_cannot_begin_where_an_axis_runs_on_for_ever(mccl: Runner) -> None:
    result = mccl(f"{HEAD}3MN,2SM3,3VM,3DI0,3GO,1CP1,1MA500,2MA500", until=1.0)
    assert result.output == ["?-2"]
    assert "axis 2 is jogging: no contour path can start from there" in result.diagnostics[0].message


@cases(
    "between, is_run_through",
    [("NO", True), ("1VV20000", True), ("1VV10000", False), ("1VA100000", False), ("1VD100000", False), ("1PS", False),
     ("1VO0.5", True)],
)  # fmt: skip
def test_paths_with_other_vector_settings_are_not_joined(
    between: str, is_run_through: bool, mccl: Runner
) -> None:
    """The second path goes on in the same direction; VO applies to both."""
    result = mccl(f"{HEAD}1CP1,1MA10000,2MA0\n{between}\n1CP1,1MA20000,2MA0\n1WS,1TP")
    assert result.output == ["01 20000"]
    first = result.controller.log.moves[0].profile
    assert first is not None
    assert (first.end_velocity > 0.0) is is_run_through


@cases(
    "then, end",
    [
        # After 0.5 s at 20000 counts/s less 1000 for the ramp; 1000 counts to stop.
        ("1ST,1WS", 10000.0), ("1AB", 9000.0), ("1MF", 9000.0), ("1VO0.5,1WS", 30000.0), ("1WS", 30000.0),
    ],
)  # fmt: skip
def test_a_contour_of_one_axis(then: str, end: float, mccl: Runner) -> None:
    result = mccl(f"1MN,1CM1,1VV20000,1VA200000,1VD200000\n1CP1,1MA30000\nWA0.5,{then},1TP")
    assert int(result.output[0].split()[1]) == pytest.approx(end, abs=3)


@cases(
    "text, output",
    [
        # VO without a number is 1; the length of 50000 counts at 5000, 10000, 20000 counts/s and a ramp.
        ("1VO0.5,1VO", "01 10000"), ("1VO0.5", "01 5000"), ("VO0.5", "01 5000"), ("1VO10,1VO1", "01 10000"),
        ("1VO11", "?-1"), ("1VO-1", "?-1"),
    ],
)  # fmt: skip
def test_the_override_without_a_number_is_one(text: str, output: str, mccl: Runner) -> None:
    result = mccl(f"1MN,1CM1,1VV10000,1VA1000000,1VD1000000\n{text}\n1CP1,1MA50000,WA1,1TV,1AB")
    assert result.output[0] == output


@cases(
    "text, code",
    [("1CM2\n1CM1", -16), ("1CM2\n1PM\n1CM1", 0), ("1CM1\n1CM1", 0), ("1CM9", -15), ("1CM1\n2CP1", -15), ("1CP1", -15),
     ("1CM2\n1CP1", -15), ("1MR9999,1CM1", -2), ("1CM1.5", -1), ("1CM0", -15)],
)  # fmt: skip
def test_which_axes_join_a_contour(text: str, code: int, mccl: Runner) -> None:
    assert mccl(f"1MN,2MN\n{text}").output == ([f"?{code}"] if code else [])


def test_segments_are_counted_and_paths_of_no_length_are(mccl: Runner) -> None:
    """A path that leads nowhere takes no time; a path that is stopped does not count."""
    result = mccl(f"{HEAD}1CP1,1MR0,2MR0\n1CP1,1MR10,2MR0\n1WS,1TX,1CP1,1MR9999,2MR0\n1ST,1WS,1TX")
    assert result.output == ["01 2", "01 2"]


# The axes of the current paths, if they stop, the shape of one in progress; the axes, length and shape of the next.
FOLLOWS: list[tuple[bool, str | None, tuple[int, ...], float, str, bool]] = [
    (False, None, (1, 2), 5.0, "trapezoid", True),
    (False, None, (1, 2), 5.0, "scurve", True),
    (False, "trapezoid", (1, 2), 5.0, "trapezoid", True),
    (False, "trapezoid", (1, 2), 5.0, "scurve", False),
    (True, None, (1, 2), 5.0, "trapezoid", False),
    (False, None, (2, 1), 5.0, "trapezoid", False),
    (False, None, (1, 2), 0.0, "trapezoid", False),
]


@pytest.mark.parametrize(("stopping", "shape", "axes", "length", "next_shape", "expected"), FOLLOWS)
def test_a_path_may_follow_those_of_the_same_axes(
    stopping: bool, shape: str | None, axes: tuple[int, ...], length: float, next_shape: str, expected: bool
) -> None:
    contour: Any = SimpleNamespace(_stopping=stopping, _members=(1, 2), _in_progress=shape)
    vector: Any = SimpleNamespace(length=length, shape=next_shape)
    assert Contour._may_follow(contour, axes, vector) is expected


@pytest.mark.parametrize(
    ("number", "in_progress", "idle", "goes_on"),
    [
        (1, False, (1, 2), True),
        (1, False, (1,), False),  # the other axis still moves
        (1, True, (1, 2), False),
        (3, False, (1, 2), False),
    ],
)
def test_the_next_paths_begin_when_all_axes_are_at_rest(
    number: int, in_progress: bool, idle: tuple[int, ...], goes_on: bool
) -> None:
    gone: list[bool] = []
    contour: Any = SimpleNamespace(
        _members=(1, 2), _handed=3, _stopping=True, _start=lambda: gone.append(True),
        _in_progress="a path" if in_progress else None,
        _board=SimpleNamespace(controller=SimpleNamespace(is_idle=lambda each: each in idle)),
    )  # fmt: skip
    Contour.rested(contour, number)
    assert gone == [True] * goes_on
    assert (contour._members, contour._handed, contour._stopping) == (
        ((), 0, False) if goes_on else ((1, 2), 3, True)
    )
