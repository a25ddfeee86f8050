"""`motionlang profiles`: TN1069's comparison, exact and as printed."""

from __future__ import annotations

import json

import pytest

from tests.cli.programs import Cell

TABLE = """\
TN1069: one move in four profiles
A = 100000 counts/s², V = 40000 counts/s, S = 40000 counts; 1000 cycles a second

                                       trapezoidal   sinusoidal  trapezoidal 0.1    parabolic
───────────────────────────────────────────────────────────────────────────────────────────────────────────
T_A             acceleration time              400  628.3185307      444.4444444          800  cycles
S_A             acceleration distance         8000  12566.37061      8888.888889  21333.33333  counts
S_V             slew distance                24000  14867.25877      22222.22222         none  counts
T_V             slew time                      600  371.6814693      555.5555556         none  cycles
peak            peak velocity                   40           40               40  38.72983346  counts/cycle
the whole move  duration                      1400  1628.318531      1444.444444  1549.193338  cycles
"""


def test_the_exact_table(cell: Cell) -> None:
    assert cell("profiles").out == TABLE


def test_as_printed_beside_it_with_every_erratum(cell: Cell) -> None:
    lines = cell("profiles", "--as-printed").out.splitlines()
    printed = [line.split()[2:] for line in lines if line.strip().startswith("as printed")]
    assert printed == [
        ["400", "628", "444", "800"],
        ["8000", "12560", "8880", "10667"],
        ["24000", "14880", "22240", "18667"],
        ["600", "372", "556", "467"],
    ]
    assert [line[:2] for line in lines if line[:1].isdigit()] == ["1.", "2.", "3.", "4.", "5."]


def test_json_has_full_precision(cell: Cell) -> None:
    document = json.loads(cell("profiles", "--json").out)
    rows = {row["name"]: row for row in document["rows"]}
    assert rows["T_A"]["exact"][1] == pytest.approx(628.3185307179587, rel=1e-12)
    assert rows["S_V"]["exact"][3] is None
    assert rows["peak"]["printed"] is None
    assert len(document["errata"]) == 5
