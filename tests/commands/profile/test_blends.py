"""Cycle time of blended paths: each is charged to its line until the next begins.

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
    made = profile(run(Source("blend.mnt", RATES + program), machine=machine))
    found = [(link.cause, link.position.line, link.duration) for link in made.links if link.duration > 1e-6]
    assert sum(seconds for *_, seconds in found) == pytest.approx(made.run.time, abs=1e-6)
    return found


def expected(*rows: tuple[str, int, float]) -> list[tuple[str, int, object]]:
    return [(cause, line, pytest.approx(seconds, abs=1e-6)) for cause, line, seconds in rows]


@pytest.mark.parametrize("wait", [IDLE, "PAUSE IDLE(0)", "PAUSE POS(0) >= 20"])
def test_each_blended_path_is_charged_to_its_line(wait: str) -> None:
    """Each path begins when the previous one slows down: 1.0 s each, the last 1.1 s."""
    program = (
        "BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 0.5\nMOVEBUFFERSIZE(0, 1) = 9;\n"
        "VECTORR(0, 1) = 10, 0\nVECTORR(0, 1) = 0, 10\nVECTORR(0, 1) = 10, 0\nGO(0)\n"
    )
    assert links(program + wait) == expected(
        ("accelerating", 4, 0.1),
        ("at speed", 4, 0.9),
        ("accelerating", 5, 0.1),
        ("at speed", 5, 0.9),
        ("accelerating", 6, 0.1),
        ("at speed", 6, 0.9),
        ("decelerating", 6, 0.1),
    )


def test_a_second_path_that_ends_first_is_not_waited_for() -> None:
    """The second path, begun at 0.5 s, takes 0.2 s; the first one takes 1.1 s."""
    program = f"VECTORR(0, 1) = 10, 0\nVECTORR(0, 1) = 0, 1\nGO(0)\nWAIT = 500\nBLEND(0)\n{IDLE}"
    assert links(program) == expected(
        ("accelerating", 2, 0.1), ("at speed", 2, 0.9), ("decelerating", 2, 0.1)
    )


def test_blended_paths_that_are_stopped_are_charged_from_the_stop_on() -> None:
    """Stopped at 0.55 s, the first one is at rest at 0.65 s, the second one at 0.6 s."""
    program = (
        "VECTORR(0, 1) = 10, 0\nVECTORR(0, 1) = 0, 10\nGO(0)\nWAIT = 500\nBLEND(0)\nWAIT = 50\nSTOP(0)\n"
    )
    assert links(program + IDLE) == expected(("dwell", 5, 0.5), ("dwell", 7, 0.05), ("stopping", 2, 0.1))


@pytest.mark.parametrize(("x", "y"), [(10, 0), (0, 10), (6, 8)])
def test_the_phases_of_a_path_are_those_of_an_axis_that_moves(x: int, y: int) -> None:
    assert links(f"VECTORR(0, 1) = {x}, {y}\nGO(0)\n{IDLE}") == expected(
        ("accelerating", 2, 0.1), ("at speed", 2, 0.9), ("decelerating", 2, 0.1)
    )
