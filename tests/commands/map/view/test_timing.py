"""The timing diagram of one cycle of a run."""

from __future__ import annotations

from typing import Any

import pytest

import motionlang
from motionlang.commands.map.view.timing import cycle, timing
from motionlang.kernel import Source

# Home, then a cycle of 0.3 s of motion, 0.2 s with output 3 on, and a wait for the part of 0.5 s.
PROGRAM = """\
' OUT 3 clamp   IN 1 part
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
WAIT = 3000
Loop
  MOVER(0) = 20 : GO(0)
  PAUSE IDLE(0)
  OUTX(3) = 1
  WAIT = 200
  OUTX(3) = 0
  PAUSE INX(1)
End Loop
"""
MACHINE: dict[str, object] = {"input": [{"channel": 1, "at": 4.0, "for": 0.1, "every": 1.0}]}


def observed(text: str, machine: dict[str, object], until: float = 8.0) -> Any:
    return motionlang.map(Source("a.mnt", text), machine=machine, run=True, until=until)


def test_a_cycle_is_the_time_between_two_equal_waits() -> None:
    """The part comes once a second."""
    made = observed(PROGRAM, MACHINE)
    assert made.run is not None
    span = cycle(made.run)
    assert span is not None
    assert span[1] - span[0] == pytest.approx(1.0, abs=1e-4)


def test_the_diagram_has_channels_velocities_and_waits() -> None:
    figure = timing(observed(PROGRAM, MACHINE))
    assert figure is not None
    panels = [row[0] for row in figure.rows]
    assert [panel.title for panel in panels] == ["inputs and outputs", "axis 0", "waits of the tasks"]
    assert [lane.name for lane in panels[0].lanes] == ["input 1 (part)", "output 3 (clamp)"]
    (on,) = panels[0].lanes[1].spans
    assert on[1] - on[0] == pytest.approx(0.2, abs=1e-3)
    assert max(panels[1].curves[0].y) == pytest.approx(100.0, abs=0.5)
    waits = {lane.name: sum(b - a for a, b in lane.spans) for lane in panels[2].lanes}
    assert waits == {
        "waits for motion": pytest.approx(0.3, abs=1e-3),
        "waits for a time": pytest.approx(0.2, abs=1e-3),
        "waits for an input": pytest.approx(0.5, abs=1e-3),
    }


def test_a_run_that_repeats_nothing_has_no_diagram() -> None:
    assert timing(observed("WAIT = 10\nWAIT = 10\n", {})) is None


def test_the_waits_of_several_tasks_have_their_names() -> None:
    text = "Run T1\nLoop\n  WAIT(50)\nEnd Loop\nTask T1\n  Loop\n    WAIT(20)\n  End Loop\nEnd Task\n"
    figure = timing(observed(text, {}, 1.0))
    assert figure is not None
    assert [lane.name for lane in figure.rows[-1][0].lanes] == [
        "ParentTask waits for a time",
        "t1 waits for a time",
    ]
