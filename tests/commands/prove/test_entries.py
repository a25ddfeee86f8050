"""Ends of log entries: the proof rejects late ones, and axes at other positions."""

from __future__ import annotations

import pytest

from motionlang import prove, run
from motionlang.commands.prove.expected_motion import ExpectedMotion
from motionlang.commands.prove.proof import proof
from motionlang.kernel import Run, Source
from motionlang.kernel.planners import hold
from motionlang.kernel.report import moves

SETTINGS = "SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100\n"
MOVE = SETTINGS + "MOVER(0) = 100 : GO(0)\nPAUSE IDLE(0)\n"


def proved(program: str, until: float | None = None) -> Run:
    machine = {"controller.instruction_time": 1e-9}
    return run(Source("ends.mnt", program), machine=machine, prove=True, until=until)


def found(result: Run) -> list[str]:
    return [each.message for each in proof(result, views=False).violations]


@pytest.mark.parametrize(
    "program",
    [
        MOVE,
        SETTINGS + "JOG(0) = 20\nWAIT 500\n",
        SETTINGS + "JOG(0) = 20\nWAIT 500\nSTOP(0)\nWAIT 100\n",
        SETTINGS + "MOVER(0) = 100 : GO(0)\nWAIT 500\nPOS(0) = 7\nWAIT 500\n",
        SETTINGS + "MOVER(0) = 100 : GO(0)\nPAUSE IDLE(0)\nPOS(0) = 7\n",
        SETTINGS + "VECTORR(0, 1) = 30, 40 : GO(0)\nWAIT 500\nCANCEL(0)\n",
    ],
)
def test_what_is_under_way_as_the_run_ends_is_no_violation(program: str) -> None:
    assert found(proved(program)) == found(proved(program, until=0.55)) == []


def test_an_entry_that_ends_after_the_run_is_found() -> None:
    """The axis is cancelled after 0.5 s, but its entry ends at 5.2 s."""
    result = proved(SETTINGS + "MOVER(0) = 100 : GO(0)\nWAIT 500\nCANCEL(0)\n")
    assert found(result) == []
    whole = proved(MOVE).controller.log.moves[0].profile
    result.controller.log.moves[0].profile = whole
    assert found(result)[-1] == "axis 0 from 0.000000 s: its entry ends at 5.2 s, the run at 0.5 s"


def test_a_report_that_has_a_move_end_after_the_run_is_found() -> None:
    result = proved(MOVE, until=2.0)
    (row,) = moves(result)
    assert (row["duration"], prove(result).violations) == (pytest.approx(2.0), [])
    from motionlang.commands.prove.checker import Proof
    from motionlang.commands.prove.checker import Run as Ran
    from motionlang.commands.prove.outputs import check_report
    from motionlang.kernel.tracks import Recorded

    recorded, proof = Recorded(result.controller), Proof()
    check_report(
        proof,
        Ran(recorded.axes, recorded.moves, ExpectedMotion.of_run(result), 2.0),
        [{**row, "duration": 5.2}],
    )
    assert [each.message for each in proof.violations] == [
        "axis 0 from 0.000000 s: the report has it end at 5.2 s, the run at 2 s"
    ]


def test_an_axis_that_stands_elsewhere_than_its_last_entry_ends_is_found() -> None:
    result = proved(MOVE)
    result.controller.axes[0].profiles[-1] = hold(101.0)
    assert "axis 0 from 0.000000 s: the last entry ends at 100, the axis is at 101" in found(result)


def test_an_entry_that_runs_on_while_its_axis_slows_down_is_found() -> None:
    """The axis stops at 0.5 s and has 10 counts/s at the end; the entry still has 20."""
    result = proved(SETTINGS + "MOVER(0) = 100 : GO(0)\nWAIT 500\nSTOP(0)\nWAIT 100\n", until=0.6)
    assert found(result) == []
    result.controller.log.moves[0].profile = proved(MOVE).controller.log.moves[0].profile
    assert any("20 counts/s at the end of the run, the axis at 10" in each for each in found(result))
