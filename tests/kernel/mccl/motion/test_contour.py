"""Contour paths are exactly on their geometry, at the vector velocity."""

from __future__ import annotations

from itertools import pairwise
from math import hypot

import pytest

from motionlang import Run
from motionlang.kernel import Source
from tests.cases import cases
from tests.mccl_runs import Runner
from tests.proof import prove, run

HEAD = "1MN,2MN,1CM1,2CM1,1VV20000,1VA200000,1VD200000\n"


def state(run: Run, time: float) -> tuple[float, float, float, float]:
    """Return position and velocity of both axes: x, y, vx, vy."""
    a, b = (run.controller.axes[axis].at(time) for axis in (1, 2))
    return a.position, b.position, a.velocity, b.velocity


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


def test_paths_whose_directions_differ_by_the_rounding_of_their_ends_are_run_through(mccl: Runner) -> None:
    """The second path continues 3001, 997 by half of it, rounded to whole counts."""
    result = run(Source("test.mcl", f"{HEAD}1CP1,1MA3001,2MA997\n1CP1,1MA4502,2MA1496\n1WS,1TX"))
    assert result.output == ["01 2"]
    assert prove(result).violations == []
    first, second = (move for move in result.controller.log.moves if move.axis == 1)
    assert first.profile is not None
    assert first.profile.end_velocity > 1000.0


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
