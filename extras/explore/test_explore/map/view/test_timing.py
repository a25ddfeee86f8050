"""The timing diagram of one cycle of a machine."""

from __future__ import annotations

from typing import Any

import pytest

import motionlang
from motionlang.kernel import Source
from motionlang_explore.map.view.timing import timing

# A cycle of 0.3 s of motion, 0.2 s with output 3 on, and a wait for the part, which comes 0.3 s after output 3.
PROGRAM = """\
' OUT 3 clamp   IN 1 part
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
WAIT = 3000
Loop
  MOVER(0) = 20 : GO(0)
  PAUSE IDLE(0)
  OUTX(3) = 1
  WAIT = 200
  PAUSE INX(1)
  OUTX(3) = 0
  PAUSE INX(1) = 0
End Loop
"""


def played(text: str) -> Any:
    return motionlang.map(Source("a.mnt", text), machine={})


def test_the_diagram_has_channels_velocities_and_waits() -> None:
    figure = timing(played(PROGRAM))
    assert figure is not None
    assert figure.title == "one cycle of a.mnt"
    panels = [row[0] for row in figure.rows]
    assert [panel.title for panel in panels] == ["inputs and outputs", "axis 0", "waits of the tasks"]
    assert [lane.name for lane in panels[0].lanes] == ["input 1 (part)", "output 3 (clamp)"]
    (on,) = panels[0].lanes[1].spans
    assert on[1] - on[0] == pytest.approx(0.3, abs=1e-3)
    assert max(panels[1].curves[0].y) == pytest.approx(100.0, abs=0.5)
    waits = {lane.name: sum(b - a for a, b in lane.spans) for lane in panels[2].lanes}
    assert waits == {
        "waits for motion": pytest.approx(0.3, abs=1e-3),
        "waits for a time": pytest.approx(0.2, abs=1e-3),
        "waits for an input": pytest.approx(0.4, abs=1e-3),
    }


def test_a_machine_that_does_not_move_has_no_diagram() -> None:
    assert timing(played("WAIT = 10\nWAIT = 10\n")) is None


@pytest.mark.slow
def test_the_waits_of_several_tasks_have_their_names() -> None:
    text = "Run T1\nLoop\n  MOVER(0) = 5 : GO(0)\n  PAUSE IDLE(0)\nEnd Loop\n"
    figure = timing(played(f"{text}Task T1\n  Loop\n    WAIT(20)\n  End Loop\nEnd Task\n"))
    assert figure is not None
    assert [lane.name for lane in figure.rows[-1][0].lanes] == [
        "ParentTask waits for motion",
        "t1 waits for a time",
    ]
