"""The machine file's sections for motors: errors with their lines, and conflicts."""

from __future__ import annotations

import pytest

from motionlang.kernel import ProgramError, Source, read_machine


def test_every_mistake_of_a_section_is_reported_at_once() -> None:
    source = Source("m.toml", '[axis.0.plant]\nkind = "ac"\ninertia = 0\nquantised = 1\ncolour = "red"\n')
    with pytest.raises(ProgramError) as caught:
        read_machine(source)
    assert [each.line for each in caught.value.diagnostics] == [2, 3, 4, 5]


def test_dotted_and_inline_tables_are_sections_too() -> None:
    wanted = {"axis.0.plant.inertia": 1e-5, "axis.0.plant.kind": "dc"}
    for text in (
        'axis.0.plant = { inertia = 1e-5, kind = "dc" }',
        'axis.0.plant.inertia = 1e-5\naxis.0.plant.kind = "dc"',
        '[axis]\n[axis.0]\n[axis.0.plant]\ninertia = 1e-5\nkind = "dc"',
    ):
        assert read_machine(Source("m.toml", text)) == wanted


@pytest.mark.parametrize("key", ["start", "servo.proportional"])
def test_a_run_without_a_plant_does_not_import_numpy(key: str) -> None:
    import subprocess
    import sys

    machine = {"axis.0.travel": [-5.0, 500.0], f"axis.0.{key}": 0.1}
    script = (
        "import sys, motionlang\nfrom motionlang.kernel.source import Source\n"
        f"run = motionlang.run(Source('x', 'KPROP(0) = 2\\nMOVER(0) = 5 : GO(0)\\nPAUSE IDLE(0)\\nPRINT POS(0)'), "
        f"dialect='mint', machine={machine!r})\n"
        "assert run.output == ['5.0000'], run.output\n"
        "print('numpy' in sys.modules)"
    )
    made = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True, timeout=60
    )
    assert made.stdout == "False\n"
