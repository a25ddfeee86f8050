"""Cycle time of paths: the phases of a path are charged to its line.

At 10 units/s with rates of 100 units/s² a path of 10 units takes 1.1 s: 0.1 s to speed up and 0.1 s to slow
down, over 0.5 units each.
"""

from __future__ import annotations

import pytest

from motionlang import profile, run
from motionlang.kernel import Source

RATES = "SPEED(0) = 10 : ACCEL(0) = 100 : DECEL(0) = 100\n"
IDLE = "PAUSE IDLE(0) And IDLE(1)"


def links(program: str) -> list[tuple[str, int, float]]:
    """Return cause, line and duration of each link in order of time.

    Statements take practically no time here, and nothing but motion is charged.
    """
    machine = {"controller.instruction_time": 1e-9}
    made = profile(run(Source("path.mnt", RATES + program), machine=machine))
    found = [(link.cause, link.position.line, link.duration) for link in made.links if link.duration > 1e-6]
    assert sum(seconds for *_, seconds in found) == pytest.approx(made.run.time, abs=1e-6)
    return found


def expected(*rows: tuple[str, int, float]) -> list[tuple[str, int, object]]:
    return [(cause, line, pytest.approx(seconds, abs=1e-6)) for cause, line, seconds in rows]


@pytest.mark.parametrize(("x", "y"), [(10, 0), (0, 10), (6, 8)])
def test_the_phases_of_a_path_are_those_of_an_axis_that_moves(x: int, y: int) -> None:
    assert links(f"VECTORR(0, 1) = {x}, {y}\nGO(0)\n{IDLE}") == expected(
        ("accelerating", 2, 0.1), ("at speed", 2, 0.9), ("decelerating", 2, 0.1)
    )
