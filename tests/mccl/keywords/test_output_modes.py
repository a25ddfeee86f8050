"""OM: every mode is stored and reported; unsimulated modes give a diagnostic.

The diagnostic comes if the axis has a simulated motor.
"""

from __future__ import annotations

from tests.cases import cases
from tests.mccl.conftest import Runner


@cases(
    ("mode", "is_simulated"),
    [(0, True), (1, False), (2, True), (3, False), (4, False), (0x8000, False), (0xC000, True)],
)
def test_a_mode_is_stored(mode: int, is_simulated: bool, mccl: Runner) -> None:
    machine = {"axis.1.plant.amplifier": "voltage"}
    result = mccl(f'1OM{mode},LU"OUTPUTMODE",1RL@0,TR0\n', machine=machine)
    assert [int(line) for line in result.output] == [mode]
    assert [each.code for each in result.diagnostics] == ([] if is_simulated else ["not-simulated"])


@cases("mode", [5, 0x7FFF, 0x8001, 0xC001, 0xBFFF])
def test_there_is_no_other_mode(mode: int, mccl: Runner) -> None:
    (found,) = mccl(f"1OM{mode}\n").diagnostics
    assert found.severity == "error"
