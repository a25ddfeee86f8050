"""Proofs of runs so long that there is more motion than is stored."""

from __future__ import annotations

import pytest

from motionlang.kernel import Source
from tests.proof import checks, expected_motion, prove, run

REPEATED = """Dim i As Integer
For i = 1 To 60
  MOVER(0) = 1 : GO(0)
  PAUSE IDLE(0)
Next
VECTORR(0, 1) = 3, 4
GO(0)
PAUSE IDLE(0)
For i = 1 To 60
  MOVER(0) = 1 : GO(0)
  PAUSE IDLE(0)
Next
PRINT POS(0)
"""


@pytest.mark.parametrize(("most", "is_proved"), [(9, True), (8, False)])
def test_equal_motion_counts_once_and_a_run_with_more_goes_on_and_is_not_proved(
    most: int, is_proved: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Four orders count as fifty each, and 240 that equal an earlier one as one each: 440, of 450 or 400."""
    for module in (expected_motion, checks):
        monkeypatch.setattr(module, "MAX_PROFILES", most)
    result = run(Source("long.mnt", REPEATED))
    assert result.output == ["123.0000"]
    words = f"nothing was verified: the run has more than {most} profiles of motion, the limit of a proof"
    assert [each.message for each in prove(result).violations] == ([] if is_proved else [words])
