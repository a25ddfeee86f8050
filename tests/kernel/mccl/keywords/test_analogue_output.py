"""OA: an analogue output ends at 10 V."""

from __future__ import annotations

from tests.cases import cases
from tests.mccl_runs import Runner


@cases(
    "volts, percent",
    [("10", 100.0), ("12", 100.0), ("-10", -100.0), ("-12", -100.0), ("9.9", 99.0), ("-9.9", -99.0), ("0", 0.0),
     ("10.05", 100.0)],
)  # fmt: skip
def test_an_analogue_output_ends_at_ten_volts(volts: str, percent: float, mccl: Runner) -> None:
    assert mccl(f"AL{volts},OA1").controller.analogue_outputs[1] == percent
