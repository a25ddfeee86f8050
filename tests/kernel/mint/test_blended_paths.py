"""Blended paths of Mint: the report has their ends, by commands or with the run.

At 0.5 s the first path has covered 4.5 at a speed of 10, and the second one begins. At 0.55 s they have
covered 5 and 0.125; the speed of the second one is 5. With rates of 100 they stop within 0.5 and 0.125, in
0.1 and 0.05 s.
"""

from __future__ import annotations

from itertools import pairwise

import pytest

from motionlang.kernel import Run, Source
from motionlang.kernel.report import build
from tests.cases import examples
from tests.kernel.mint.blend_programs import program
from tests.proof import prove, run

PATHS = """SPEED(0) = 10 : ACCEL(0) = 100 : DECEL(0) = 100 : ERRORDECEL(0) = 200
VECTOR{how}(0, 1) = 100, 0
VECTOR{how}(0, 1) = {x}, 100
GO(0)
WAIT = 500
BLEND(0)
WAIT = 50
"""
# The rest of the first path and of the second one at a rate: distances and seconds.
AT_ONCE = (0.0, 0.0, 0.0, 0.0)
AT_DECEL = (0.5, 0.1, 0.125, 0.05)
AT_ERRORDECEL = (0.25, 0.05, 0.0625, 0.025)
ENDS = {
    "CANCEL(0)": ("cancel", AT_ONCE),
    "CANCEL(1)": ("cancel", AT_ONCE),
    "RESET(1) : POS(1) = 0.125": ("cancel", AT_ONCE),
    "ABORT": ("fault", AT_ONCE),
    "DRIVEENABLE(0) = 0": ("cancel", AT_ONCE),
    "DRIVEENABLE(1) = 0": ("cancel", AT_ONCE),
    "STOP(0) : WAIT = 500": ("stop", AT_DECEL),
    "STOP(1) : WAIT = 500": ("stop", AT_DECEL),
    "SOFTLIMITMODE(0) = 1 : SOFTLIMITFORWARD(0) = 4 : WAIT = 500": ("fault", AT_ONCE),
    "SOFTLIMITMODE(1) = 3 : SOFTLIMITFORWARD(1) = 0.1 : WAIT = 500": ("fault", AT_ERRORDECEL),
    "SUSPEND(0) = 1 : WAIT = 500": ("end-of-run", (0.5, 0.5, 0.125, 0.5)),
    "SUSPEND(0) = 1 : WAIT = 400 : CANCEL(0)": ("cancel", (0.5, 0.4, 0.125, 0.4)),
    "SUSPEND(0) = 1 : WAIT = 400 : STOP(0)": ("stop", (0.5, 0.4, 0.125, 0.4)),
    "PRINT 1 / IDLE(0)": ("end-of-run", AT_ONCE),
}


def proved(text: str, until: float = 100.0) -> Run:
    machine = {"controller.instruction_time": 1e-9}
    result = run(Source("blend.mnt", text), machine=machine, until=until)
    assert [each.message for each in prove(result).violations] == []
    return result


def rows(result: Run) -> list[tuple[float, float, float, float]]:
    """Return start, end and duration of each path: axis 0, then axis 1."""
    moves: list[dict[str, float]] = build(result)["moves"]  # type: ignore[assignment]
    return [
        (first["start"], first["end"], second["start"], second["end"])
        for first, second in zip(moves[::2], moves[1::2], strict=True)
    ]


@pytest.mark.parametrize("how", ["A", "R"])
@pytest.mark.parametrize("end", ENDS)
def test_end_of_a_blend_is_reported_for_both_paths(end: str, how: str) -> None:
    ended, (first, first_time, second, second_time) = ENDS[end]
    result = proved(PATHS.format(how=how, x=100 if how == "A" else 0) + end, until=1.05)
    moves = build(result)["moves"]
    x, y = 5.0 + first, 0.125 + second
    assert rows(result) == [
        pytest.approx((0.0, x, 0.0, 0.0), abs=1e-6),
        pytest.approx((x, x, 0.0, y), abs=1e-6),
    ]
    seconds = [0.55 + first_time] * 2 + [0.05 + second_time] * 2
    assert [move["duration"] for move in moves] == pytest.approx(seconds, abs=1e-6)
    assert [move["ended"] for move in moves] == [ended] * 4
    axes = result.controller.axes
    assert [axes[k].position(result.time) for k in (0, 1)] == pytest.approx([x, y], abs=1e-6)


def test_an_axis_that_a_path_does_not_move_goes_no_distance() -> None:
    """The second path moves only axis 1, whatever rounding does to the sum on axis 0."""
    result = run(Source("blend.mnt", PATHS.format(how="R", x=0) + "CANCEL(0)"), machine={})
    moves: list[dict[str, float]] = build(result)["moves"]  # type: ignore[assignment]
    assert [move["end"] - move["start"] for move in moves if move["axis"] == 0][1:] == [0.0]
    assert [move["distance"] for move in moves if move["axis"] == 0][1:] == [0.0]


def test_the_end_of_the_run_cuts_both_paths() -> None:
    """At 0.6 s the paths have covered 5.5 and 0.5."""
    result = proved(PATHS.format(how="R", x=0) + "PAUSE IDLE(0)", until=0.6)
    assert rows(result) == [pytest.approx((0.0, 5.5, 0.0, 0.0)), pytest.approx((5.5, 5.5, 0.0, 0.5))]
    moves = build(result)["moves"]
    assert [move["ended"] for move in moves] == ["end-of-run"] * 4


@pytest.mark.parametrize(
    ("mode", "cancelled", "begins"),
    [
        ("BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 10", 2000, 3.05),
        ("BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 10", 3600, 3.6),
        ("CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 0", 2000, 4.05),
    ],
)
def test_a_path_follows_on_when_the_one_between_is_cancelled(
    mode: str, cancelled: int, begins: float
) -> None:
    """The first path of 40 is at 30 after 0.1 s for 0.5 and 2.95 s for 29.5.

    At full speed it is at its end 1 s later.
    """
    result = proved(
        f"SPEED(0) = 10 : ACCEL(0) = 100 : DECEL(0) = 100 : MOVEBUFFERSIZE(1) = 3 : {mode}\n"
        "VECTORR(0, 1) = 40, 0\nCIRCLER(1, 2) = -8, 3, 92\nVECTORR(0, 1) = 40, 0\nGO(0)\n"
        f"WAIT = {cancelled}\nCANCEL(2)\nPAUSE IDLE(0)\n"
    )
    moves: list[dict[str, float]] = build(result)["moves"]  # type: ignore[assignment]
    assert [move["start_time"] for move in moves if move["axis"] == 0] == pytest.approx(
        [0.0, begins], abs=1e-6
    )
    assert result.time == pytest.approx(begins + 4.1 - 0.05 * ("CONTOURMODE" in mode), abs=1e-6)


def consistent(seed: int) -> None:
    """Check that a random program is proved, with at most two paths at a time.

    Its report and its axes must agree.
    """
    result = proved(program(seed), until=30.0)
    moves: list[dict[str, float]] = build(result)["moves"]  # type: ignore[assignment]
    assert all(move["start_time"] + move["duration"] <= result.time + 1e-9 for move in moves)
    for axis in (0, 1):
        mine = [move for move in moves if move["axis"] == axis]
        for before, after in pairwise(mine):
            assert after["start"] == pytest.approx(before["end"], abs=1e-9), (seed, after["line"])
        for first, _, third in zip(mine, mine[1:], mine[2:], strict=False):
            assert first["start_time"] + first["duration"] <= third["start_time"] + 1e-9, (
                seed,
                third["line"],
            )
        a = result.controller.axes[axis]
        at = a.scale.position_to_user(a.position(result.time))
        assert mine[-1]["end"] == pytest.approx(at, abs=1e-9), seed


def test_random_blends_are_consistent() -> None:
    for seed in range(examples(60)):
        consistent(seed)


@pytest.mark.parametrize("seed", [787, 829, 1132, 1515])
def test_a_path_waits_for_the_longest_of_those_that_are_blended(seed: int) -> None:
    """The path directly before ends while the path before that is still in motion.

    By rounding, its end is slightly later.
    """
    consistent(seed)


@pytest.mark.long
def test_many_random_blends_are_consistent() -> None:
    for seed in range(60, 5000):
        consistent(seed)
