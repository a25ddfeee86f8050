"""The mark of an auxiliary encoder counts as passed within rounding."""

from __future__ import annotations

import pytest

from motionlang.kernel.mccl.keywords.motion_auxiliary import _passed


@pytest.mark.parametrize(
    ("start", "here", "expected"),
    [
        (0.0, 400.0 - 2e-6, False), (0.0, 400.0 - 0.5e-6, True), (0.0, 400.0, True), (0.0, 401.0, True),
        (900.0, 400.0 + 2e-6, False), (900.0, 400.0 + 0.5e-6, True), (900.0, 400.0, True), (900.0, 399.0, True),
    ],
)  # fmt: skip
def test_a_mark_is_passed_from_either_side(start: float, here: float, expected: bool) -> None:
    """The mark is at 400 counts; a millionth of a count is rounding."""
    assert _passed(start, 400.0, here) is expected
