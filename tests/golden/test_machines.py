"""The end times of the gallery's machines, compared with hand arithmetic.

They are calculated by the formulas in each header. Statements take ten microseconds each, so a run is
slightly longer than its moves. The times are those of the golden reports, which another test compares with the runs.
"""

from __future__ import annotations

import json
from math import pi, sqrt
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).parents[2] / "scripts" / "mint"
STATEMENTS = 3e-3


def there(distance: float, speed: float, rate: float) -> float:
    """Return the duration of a move from rest to rest."""
    return distance / speed + speed / rate if distance >= speed**2 / rate else 2.0 * sqrt(distance / rate)


# The end of each program, or of the action in the comment.
OVER: dict[str, float] = {
    "pick-and-place": 3 * (4 * there(50, 500, 5000) + 2 * 0.08 + 2 * there(300, 800, 4000)),
    "indexing-table": 8 * (there(45, 180, 900) + 0.3),
    "filler": 4 * (there(120, 400, 2000) + 0.25) + (100 + 150 + 200 + 50) / 250,
    "batch-counter": 2.5 + 0.1 + 2 * there(150, 600, 6000),
    "light-curtain": 2.5 + there(200, 200, 1000),
    "shift-report": 2 * sum(there(d, 300, 3000) for d in (120, 30, 12, 240)),
    "legacy-drill": sum(there(d, 400, 2000) for d in (20, 40, 80, 140))
    + 3 * (there(15, 25, 500) + there(15, 250, 500)),
    "palletiser": 2 * 2 * sum(there(d, 600, 3000) for d in (200, 400, 600, 350, 400, 600))
    + 6 * 2 * (there(200, 300, 3000) + there(100, 300, 3000)),
    "fault-recovery": 1.45 + 1.0 + there(300, 100, 500) + there(500, 250, 500),
    "roll-feed": 12 * there(60, 300, 6000) + there(20, 300, 6000),
    "lift": 1.2 + 1.3 + 0.4 + 0.2,
    "tool-changer": 2 * there(90, 120, 480) + there(150, 120, 480) + there(180, 120, 480),
    "bag-maker": sum(there(d, 400, 4000) + 0.08 for d in (201, 201, 199.5, 203)),
    "wire-winder": there(82, 5, 10),
    "laser-contour": 2 * (240 + 20 * pi) / 50 + 8 * 0.1 + 0.1,
    "glue-bead": 2 * there(120, 80, 800) + 3 * there(60, 80, 800) + 0.2,
    "thread-milling": there(3 * sqrt((16 * pi) ** 2 + 1.5**2), 20, 200)
    + 2 * there(8, 20, 200)
    + there(10, 100, 1000)
    + there(5.5, 100, 1000),
    "rotary-table": 45 / 20 + 0.1 + 0.2 + 1.01 + 5 + 0.02 + there(0.02, 2, 100)
    + there(90, 180, 720) + 2 * there(120, 180, 720) + there(240, 180, 720),
    "flying-shear": 0.2 + 4 * 2.5 + 0.2,
    "labeller": 0.2 + (955 - 20) / 200 + there(60, 200, 2000) + 0.2,
    "punch-trigger": 1.4 + there(25, 500, 10000),
    "spray-arm": 3 * 2.0,
}  # fmt: skip


@pytest.mark.parametrize("name", OVER)
def test_the_machine_is_done_when_it_should_be(name: str) -> None:
    report = json.loads((SCRIPTS / f"{name}.golden.json").read_text(encoding="utf-8"))
    assert report["status"] == "ended"
    assert OVER[name] <= report["time"] + 1e-9
    assert report["time"] == pytest.approx(OVER[name], abs=STATEMENTS)
