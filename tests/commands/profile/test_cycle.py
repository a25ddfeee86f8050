"""The time profile: every second of a run is charged exactly once, to its cause."""

from __future__ import annotations

from math import fsum
from pathlib import Path
from typing import Any

import pytest

from motionlang import profile, run
from motionlang.cli import main
from motionlang.kernel import Source

# X takes 1.1 s, Z half a second, and waits for X; then a dwell, a sub that is called twice, and an input at 3
# s.
PROGRAM = """\
SPEED(0, 1) = 100;
ACCEL(0, 1) = 1000;
DECEL(0, 1) = 1000;
MOVER(0, 1) = 100, 40 : GO(0, 1)
PAUSE IDLE(0) And IDLE(1)
WAIT(250)
Press
Press
PAUSE INX(3)
End

Sub Press()
  Stroke 10
  Stroke -10
End Sub

Sub Stroke(ByVal way As Float)
  MOVER(1) = way : GO(1)
  PAUSE IDLE(1)
End Sub
"""
WORLD = {"input": [{"channel": 3, "at": 3.0, "value": 1}]}


def profiled(text: str, name: str = "cycle.mnt", **options: object) -> Any:
    return profile(run(Source(name, text), **options))  # type: ignore[arg-type]


def by_name(shares: Any) -> dict[str, float]:
    return {share.name: share.seconds for share in shares}


def life(task: Any) -> float:
    return fsum((*task.waiting.values(), task.computing, task.ready))


def test_the_chain_goes_through_what_the_end_waited_for() -> None:
    made = profiled(PROGRAM, machine=WORLD)
    kinds = by_name(made.kinds())
    assert kinds["travel of axis 0"] == pytest.approx(1.1)
    # A stroke of 10 at 100 with 1000 takes 0.2 s; there are four.
    assert kinds["travel of axis 1"] == pytest.approx(0.8)
    assert kinds["dwell"] == pytest.approx(0.25)
    assert kinds["waiting for an input"] == pytest.approx(3.0 - 1.1 - 0.8 - 0.25, abs=1e-3)
    assert [link.cause for link in made.links if link.axes == (0,)] == [
        "accelerating",
        "at speed",
        "decelerating",
    ]
    (first, *_) = made.lines()
    assert first.line == 4
    assert first.seconds == pytest.approx(1.1)
    assert {18, 6, 9} <= {share.line for share in made.lines()}


def test_a_sub_has_its_own_time_and_that_of_what_it_called() -> None:
    shares = {share.name: share for share in profiled(PROGRAM, machine=WORLD).subs()}
    assert shares["Stroke"].seconds == pytest.approx(0.8, abs=1e-3)
    assert shares["Press"].seconds < 1e-3
    assert shares["Press"].total == pytest.approx(0.8, abs=1e-3)
    assert shares["the program"].total == pytest.approx(3.0, abs=1e-3)


def test_a_dwell_in_a_sub_knows_who_called_it() -> None:
    made = profiled("Rest\nEnd\nSub Rest()\n  Nap 100\nEnd Sub\nSub Nap(ByVal ms)\n  WAIT(ms)\nEnd Sub\n")
    (link,) = [each for each in made.links if each.cause == "dwell"]
    assert (link.position.line, link.position.sub, link.position.callers) == (7, "Nap", (1, 4))


def test_an_axis_that_could_have_been_slower_is_reported() -> None:
    """Z arrives after 0.5 s, X after 1.1 s."""
    (slack,) = profiled(PROGRAM, machine=WORLD).slacks()
    assert (slack.axis, slack.other) == (1, 0)
    assert slack.seconds == pytest.approx(0.6)


def test_moves_that_the_buffer_starts_are_followed_to_the_one_that_a_task_started() -> None:
    made = profiled(
        "SPEED(0) = 50\nMOVEBUFFERSIZE(0) = 5\nMOVER(0) = 5\nMOVER(0) = 10\nMOVER(0) = 20\nGO(0)\nPAUSE IDLE(0)\n"
    )
    assert [share.line for share in made.lines()][:3] == [5, 4, 3]
    assert by_name(made.kinds())["travel of axis 0"] == pytest.approx(made.run.time, abs=1e-3)


def test_motion_that_goes_on_after_the_program_is_part_of_the_run() -> None:
    made = profiled("SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 100 : GO(0)\n")
    assert by_name(made.kinds())["travel of axis 0"] == pytest.approx(1.1, abs=1e-4)
    assert made.tasks[0].life < 1e-3


def test_paths_count_once() -> None:
    made = profiled("SPEED(0) = 50\nVECTORR(0, 1) = 30, 40\nGO(0)\nPAUSE IDLE(0)\n")
    assert by_name(made.kinds())["travel of axes 0, 1"] == pytest.approx(made.run.time, abs=1e-3)


def test_tasks_have_their_own_times() -> None:
    """One task waits for 10 ms at a time, the other one computes for a second.

    The times reported for each add up to the time from its start to its end.
    """
    made = profiled(
        "Run slow\nDim i As Integer\nFor i = 1 To 20000\nNext\nEnd\n"
        "Task slow\n  While 1\n    WAIT(10)\n  End While\nEnd Task\n"
    )
    parent, slow = made.tasks
    assert parent.computing > 0.1
    assert slow.waiting["time"] > 0.1
    assert slow.computing < 0.1 * parent.computing


def test_a_task_computes_while_it_is_alone() -> None:
    """An iteration takes 20 µs: 50 000 before the other task starts, then 1 000.

    The other task computes for 0.1 s, so both need twice as long at that time.
    """
    parent, other = profiled(
        "Dim n As Integer, k As Integer\nFor n = 1 To 50000\n  k = n\nNext\nRun Other\n"
        "For n = 1 To 1000\n  k = n\nNext\nWAIT(1000)\nEnd\n"
        "Task Other\n  Dim m As Integer, i As Integer\n  For m = 1 To 5000\n    i = m\n  Next\nEnd Task\n"
    ).tasks
    assert parent.computing == pytest.approx(1.02, abs=1e-4)
    assert [parent.ready, other.ready] == pytest.approx([0.02, 0.02], abs=2e-3)
    assert other.computing == pytest.approx(0.1, abs=1e-4)


def test_the_life_of_a_task_is_from_each_start_to_its_end() -> None:
    """It runs for 0.3 s, until it is ended in its WAIT, and 0.7 s later for 0.2 s."""
    parent, brief = profiled(
        "Dim n As Integer\nRun Brief\nWAIT(300)\nEnd Brief\nWAIT(700)\nRun Brief\nWAIT(500)\nEnd\n"
        "Task Brief\n  n = n + 1\n  If n = 1 Then WAIT(1000) Else WAIT(200)\nEnd Task\n"
    ).tasks
    assert parent.waiting["time"] == pytest.approx(1.5, abs=1e-9)
    assert [brief.begin, brief.end] == pytest.approx([0.0, 1.2], abs=1e-3)
    assert brief.life == pytest.approx(0.5, abs=1e-3)
    assert brief.waiting["time"] == pytest.approx(0.5, abs=1e-3)
    assert brief.ready < 1e-4


def test_a_handler_is_never_ready() -> None:
    """It is called every 10 ms for a second, and computes for one statement of 10 µs."""
    *_, handler = profiled(
        "Dim n As Integer\nTIMEREVENT = 10\nRun Other\nWAIT(1000)\nEnd\n"
        "Task Other\n  PAUSE INX(5)\nEnd Task\nEvent TIMER\n  n = n + 1\nEnd Event\n"
    ).tasks
    assert (handler.name, handler.ready, handler.waiting) == ("timer", 0.0, {})
    assert handler.life == handler.computing == pytest.approx(100 * 10e-6, abs=2e-5)


def test_a_task_may_wait_for_a_move_that_began_before_it() -> None:
    """The path goes from the second move to the task, from its wait to the first move.

    That began at 4 ms, and the task 2 ms later; each move takes 0.2 s, and each statement 1 ms.
    """
    made = profiled(
        "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 10 : GO(0)\nRun Other\n"
        "WAIT = 250\nPAUSE IDLE(0)\nEnd\nTask Other\n  PAUSE IDLE(0)\n  MOVER(0) = 10 : GO(0)\nEnd Task\n",
        machine={"controller.instruction_time": 0.001},
    )
    times = [(round(link.begin, 6), round(link.end, 6)) for link in made.links]
    assert times[:2] == [(0.0, 0.004), (0.004, 0.104)]
    assert [b for _, b in times[:-1]] == [a for a, _ in times[1:]]
    assert made.seconds == pytest.approx(made.run.time) == pytest.approx(0.407)


def test_a_run_that_is_cut_short_waits_to_its_end() -> None:
    made = profiled("WAIT(100)\nPAUSE INX(3)\n", until=2.0, machine=WORLD)
    assert by_name(made.kinds()) == {
        "waiting for a condition": pytest.approx(1.9, abs=1e-3),
        "dwell": pytest.approx(0.1, abs=1e-3),
        "computing": pytest.approx(0.0, abs=1e-3),
    }


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "cycle.mnt").write_text(PROGRAM)
    (tmp_path / "cycle.machine.toml").write_text("[[input]]\nchannel = 3\nat = 3.0\n")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_budget_is_a_check(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with (folder / "cycle.machine.toml").open("a") as file:
        file.write("[budget]\ntime = 2.9\nmotion = 2\ndwell = 0.2\n")
    assert main(["run", "cycle.mnt", "--format", "none"]) == 1
    reported = capsys.readouterr().err
    assert "the run took 3.0" in reported
    assert "dwell took 0.25" in reported
    assert "cycle.mnt:6" in reported
    assert "motion took" not in reported


def test_a_task_lives_from_its_start_to_its_end() -> None:
    """Three tasks begin at 50 ms: one waits 100 ms, one computes, one waits to 0.3 s.

    The program ends then, too.
    A statement takes 10 µs: 2000 iterations take 20 ms, and waits are up to 2 ms late, because the tasks share time.
    """
    made = profiled(
        "WAIT(50)\nRun brief\nRun quick\nRun patient\nWAIT(250)\nEnd\n"
        "Task brief\n  WAIT(100)\nEnd Task\n"
        "Task quick\n  Dim i As Integer\n  For i = 1 To 2000\n  Next\nEnd Task\n"
        "Task patient\n  WAIT(20)\n  PAUSE INX(3)\nEnd Task\n"
    )
    found = {task.name: (task.begin, task.end, task.waiting) for task in made.tasks}
    expected = {
        "ParentTask": (0.0, 0.3, {"time": 0.3}),
        "brief": (0.05, 0.15, {"time": 0.1}),
        "quick": (0.05, 0.07, {}),
        "patient": (0.05, 0.3, {"time": 0.02, "input": 0.23}),
    }
    assert list(found) == list(expected)
    for name, (begin, end, waiting) in expected.items():
        assert found[name][:2] == pytest.approx((begin, end), abs=2e-3), name
        assert found[name][2] == pytest.approx(waiting, abs=2e-3), name
    computing = {"ParentTask": 0.0, "brief": 0.0, "quick": 0.02, "patient": 0.0}
    assert {task.name: task.computing for task in made.tasks} == pytest.approx(computing, abs=1e-3)
    assert all(life(task) == pytest.approx(task.end - task.begin) for task in made.tasks)
