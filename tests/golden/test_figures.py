"""Every figure of the worked examples of AN00115 and TN1069, within 1e-9.

The exact values come from independent arithmetic (direct integration), not from this program. The moves are those of
the golden reports, which another test compares with the runs.
"""

from __future__ import annotations

import json
from math import pi, sqrt
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).parent.parent.parent / "scripts"
Figures = list[tuple[str, float, float]]

# Program, axis: peak speed, and per phase its name, its seconds and its distance.
MOVES: dict[str, dict[int, tuple[float, Figures]]] = {
    "mint/an00115-first-move.mnt": {
        0: (8.0, [("accel", 0.5, 2.0), ("slew", 1.0, 8.0), ("decel", 0.5, 2.0)]),
    },
    "mint/an00115-third-rule.mnt": {
        0: (50.0, [("accel", 0.2, 5.0), ("slew", 0.2, 10.0), ("decel", 0.2, 5.0)]),
    },
    "mint/an00115-third-rule-times.mnt": {
        0: (50.0, [("accel", 0.2, 5.0), ("slew", 0.2, 10.0), ("decel", 0.2, 5.0)]),
    },
    "mint/an00115-quarter-rule.mnt": {
        0: (400 / 9, [("accel", 0.15, 10 / 3), ("slew", 0.3, 40 / 3), ("decel", 0.15, 10 / 3)]),
    },
    "mint/ballscrew.mnt": {
        0: (250.0, [("accel", 0.2, 25.0), ("slew", 0.6, 150.0), ("decel", 0.2, 25.0)]),
    },
    "mint/ballscrew-times.mnt": {
        0: (250.0, [("accel", 0.2, 25.0), ("slew", 0.6, 150.0), ("decel", 0.2, 25.0)]),
    },
    "mccl/tn1069.mcl": {
        1: (40_000.0, [("accel", 0.4, 8000.0), ("slew", 0.6, 24_000.0), ("decel", 0.4, 8000.0)]),
        2: (
            40_000.0,
            [
                ("accel", 0.2 * pi, 4000.0 * pi),
                ("slew", 1.0 - 0.2 * pi, 40_000.0 - 8000.0 * pi),
                ("decel", 0.2 * pi, 4000.0 * pi),
            ],
        ),
        3: (
            40_000.0,
            [
                ("accel", 0.4 / 0.9, 8000.0 / 0.9),
                ("slew", 1.0 - 0.4 / 0.9, 40_000.0 - 16_000.0 / 0.9),
                ("decel", 0.4 / 0.9, 8000.0 / 0.9),
            ],
        ),
        4: (
            1000.0 * sqrt(1500.0),
            [("accel", sqrt(0.6), 20_000.0), ("decel", sqrt(0.6), 20_000.0)],
        ),
    },
}


@pytest.mark.parametrize("program", MOVES)
def test_the_documents_figures(program: str) -> None:
    golden = (SCRIPTS / program).with_suffix(".golden.json")
    moves = json.loads(golden.read_text(encoding="utf-8"))["moves"]
    assert {move["axis"] for move in moves} == MOVES[program].keys()
    for move in moves:
        peak, phases = MOVES[program][move["axis"]]
        assert move["peak_speed"] == pytest.approx(peak, rel=1e-9)
        assert move["duration"] == pytest.approx(sum(phase[1] for phase in phases), rel=1e-9)
        assert move["distance"] == pytest.approx(sum(phase[2] for phase in phases), rel=1e-9)
        found = [(phase["name"], phase["duration"], phase["distance"]) for phase in move["phases"]]
        assert [phase[0] for phase in found] == [phase[0] for phase in phases]
        for one, other in zip(found, phases, strict=True):
            assert one[1:] == pytest.approx(other[1:], rel=1e-9)
