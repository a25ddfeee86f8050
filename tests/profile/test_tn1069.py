"""PMC TN1069: the worked example, exact and as printed."""

from __future__ import annotations

import pytest

from motionlang.profile import tn1069
from motionlang.profile.verify import verify

EXACT = {
    "T_A": (400, 628.3185307, 444.4444444, 800),
    "S_A": (8000, 12566.37061, 8888.888889, 21333.33333),
    "S_V": (24000, 14867.25877, 22222.22222, None),
    "T_V": (600, 371.6814693, 555.5555556, None),
    "the whole move": (1400, 1628.318531, 1444.444444, 1549.193338),
}


@pytest.mark.parametrize("name", EXACT)
def test_the_table_is_exact(name: str) -> None:
    row = next(row for row in tn1069.comparison() if row.name == name)
    for exact, expected in zip(row.exact, EXACT[name], strict=True):
        assert exact == (expected if expected is None else pytest.approx(expected, rel=1e-9))


def test_the_printed_table_is_kept_beside_it() -> None:
    printed = {row.name: row.printed for row in tn1069.comparison() if row.printed}
    assert printed == tn1069.PRINTED
    assert printed["S_A"] == (8000, 12560, 8880, 10667)


def test_the_parabolic_move_is_too_short_for_its_speed() -> None:
    parabolic = tn1069.profiles()[3]
    assert [phase.name for phase in parabolic.phases] == ["accel", "decel"]
    assert parabolic.peak_speed == pytest.approx(38729.83346, rel=1e-9)
    assert parabolic.phases[0].duration == pytest.approx(0.7745966692, rel=1e-9)


def test_every_column_keeps_its_limits() -> None:
    for profile in tn1069.profiles():
        assert verify(profile, speed=40e3, accel=100e3, decel=100e3, end=40e3) == []


@pytest.mark.parametrize(("column", "peak"), [(0, 1.0), (1, 1.0), (2, 1.0), (3, 1.0)])
def test_the_peak_acceleration_is_the_one_asked_for(column: int, peak: float) -> None:
    assert tn1069.profiles()[column].peak_acceleration == pytest.approx(peak * 100e3, rel=1e-12)


def test_the_errata_are_told() -> None:
    assert len(tn1069.ERRATA) == 5
