"""Conversion between user units and counts, for a length, speed, rate and jerk."""

from __future__ import annotations

import pytest

from motionlang.kernel.controller.scale import Scale

# 4 counts per unit, and minutes; the same with separate units for speeds, 10 counts, and for rates and jerks,
# 20.
PLAIN = {"uu": 8.0, "uu/s": 8.0 / 60.0, "uu/s2": 8.0 / 60.0**2, "uu/s3": 8.0 / 60.0**3, "ms": 2.0}
OWN = {"uu": 8.0, "uu/s": 20.0 / 60.0, "uu/s2": 40.0 / 60.0**2, "uu/s3": 40.0 / 60.0**3, "ms": 2.0}


@pytest.mark.parametrize(("own", "expected"), [((None, None), PLAIN), ((10.0, 20.0), OWN)])
def test_each_unit_has_its_power_of_the_time(
    own: tuple[float | None, float | None], expected: dict[str, float]
) -> None:
    scale = Scale(4.0, 60.0, 100.0)
    scale.set_units(*own)
    for unit, counts in expected.items():
        assert scale.to_counts(2.0, unit) == pytest.approx(counts), unit
        assert scale.to_user(counts, unit) == pytest.approx(2.0), unit
    assert scale.position_to_counts(2.0) == 108.0
    assert scale.position_to_user(108.0) == 2.0
