"""The lines that describe the difference of two reports.

The reports are written by hand.
"""

from __future__ import annotations

import json
from typing import Any

import pytest

from tests.cli.programs import Cell
from tests.commands.diff.test_fields import event, move, report


def lines(cell: Cell, old: dict[str, Any], new: dict[str, Any]) -> list[str]:
    """Return what `motionlang diff` prints of two reports."""
    for name, made in (("old.json", old), ("new.json", new)):
        cell.write(name, json.dumps(made))
    shown: list[str] = cell("diff", "old.json", "new.json").out.splitlines()
    return [] if shown == ["no difference"] else shown


@pytest.mark.parametrize(
    ("old", "new", "wanted"),
    [
        (
            report(move()),
            report(move(duration=1.5)),
            "line 1: MOVER of axis 0, 1 move: duration 1 → 1.5 s, +0.500000 s in motion",
        ),
        (
            report(move(), move(begin=1.0)),
            report(move(duration=1.5), move(begin=1.5, duration=1.5)),
            "line 1: MOVER of axis 0, 2 moves: duration 1 → 1.5 s, +1.000000 s in motion together",
        ),
        (
            report(move(), move(begin=1.0)),
            report(move(), move(begin=1.25)),
            "line 1: MOVER of axis 0, 1 move: +0.250000 s before it",
        ),
        (
            report(move(1), move(2, begin=1.0, distance=3.0)),
            report(move(1), move(9, begin=1.0, distance=3.0, peak_speed=5.0)),
            "line 2, now 9: MOVER of axis 0, 1 move: peak speed none → 5 uu/s",
        ),
        (
            report(move(axis=0), move(axis=1)),
            report(move(axis=0, start=1.0, end=2.0), move(axis=1, start=1.0, end=3.0)),
            "line 1: MOVER of axes 0, 1, 1 move each: start none → 1 uu, "
            "axis 0 end none → 2 uu, axis 1 end none → 3 uu",
        ),
        (
            report(move(peak_speed=5.0, distance=1.0)),
            report(move(peak_speed=6.0, distance=1.0 + 1e-7)),
            "line 1: MOVER of axis 0, 1 move: distance 1 → 1.0000001 uu, peak speed 5 → 6 uu/s",
        ),
        (report(), report(move(3)), "new: line 3: MOVER of axis 0 by 10 uu at 0.000000 s"),
        (
            report(move(3, distance=None)),
            report(),
            "missing: line 3: MOVER of axis 0 by none uu at 0.000000 s",
        ),
        (report(output=["a"]), report(output=["a", "b"]), "new: printed line 2, 'b'"),
        (report(output=["a", "b"]), report(output=["b"]), "missing: printed line 1, 'a'"),
        (report(output=["a 1"]), report(output=["a 2"]), "printed line 1: 'a 1' → 'a 2'"),
        (
            report(events=[event(line=7, text="speed")]),
            report(events=[]),
            "missing: event clamp of axis 0, line 7, speed, at 1.000000 s",
        ),
        (report(), report(events=[event(axis=None)]), "new: event clamp, at 1.000000 s"),
        (
            report(events=[event()]),
            report(events=[event(1.25, value=6.0, limit=None)]),
            "event clamp of axis 0, at 1.000000 s: value 5 → 6, limit 4 → none, +0.250000 s",
        ),
    ],
)
def test_the_line_of_a_difference(old: dict[str, Any], new: dict[str, Any], wanted: str, cell: Cell) -> None:
    found = [
        line
        for line in lines(cell, old, new)
        if not line.startswith(("time: ", "the motion first", "moves: "))
    ]
    assert found == [wanted]


def test_the_end_of_a_run(cell: Cell) -> None:
    found = lines(cell, report(move()), report(move(), time=5.5))
    assert found[-1] == "the run ends +0.500000 s after its last motion"


def test_where_motion_differs_first(cell: Cell) -> None:
    assert lines(cell, report(move(begin=2.0)), report(move(begin=2.0, duration=2.0)))[-1] == (
        "the motion first differs at 2.000000 s, on axis 0"
    )
    assert lines(cell, report(move(commanded_speed=5.0)), report(move(commanded_speed=6.0)))[-1] == (
        "only the commanded speed differs, the motion does not"
    )
    assert lines(cell, report(move()), report(move())) == []
