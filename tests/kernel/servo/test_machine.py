"""The machine file's sections for motors: errors with their lines, and conflicts."""

from __future__ import annotations

import pytest

from motionlang.kernel import ProgramError, Source, read_machine
from motionlang.views.diagnostics import render_all

MISTAKES = [
    (
        "[axis.0.plant]\nresistence = 1.0\n",
        """\
error[machine-file]: there is no key axis.0.plant.resistence
 --> m.toml:2:1
  |
2 | resistence = 1.0
  | ^^^^^^^^^^
  hint: did you mean resistance?
""",
    ),
    (
        "[axis.0.plant]\ninertia = -1.0\n",
        """\
error[machine-file]: axis.0.plant.inertia must be greater than zero, not -1.0
 --> m.toml:2:1
  |
2 | inertia = -1.0
  | ^^^^^^^
  hint: inertia of the motor, kg m²
""",
    ),
    (
        '[axis.3.servo]\nlimit_style = "soft"\n',
        """\
error[machine-file]: axis.3.servo.limit_style must be "sum" or "term", not 'soft'
 --> m.toml:2:1
  |
2 | limit_style = "soft"
  | ^^^^^^^^^^^
  hint: sum: the sum stops at the limit; term: the sum winds up beyond it
""",
    ),
    (
        "# a load that swings\n\n[axis.1.plant]\nresonance = 40.0\n",
        """\
error[machine-file]: a resonance needs a load inertia to swing against the motor
 --> m.toml:3:1
  |
3 | [axis.1.plant]
  | ^^^^^^^^^^^^^^
  hint: docs/machine-file.md explains every key
""",
    ),
    (
        "[axis.1.servo]\nservo_rate = 1500.0\n",
        """\
error[machine-file]: the servo rate must be a multiple of the trajectory rate, not 1.5 times it
 --> m.toml:1:1
  |
1 | [axis.1.servo]
  | ^^^^^^^^^^^^^^
  hint: docs/machine-file.md explains every key
""",
    ),
    (
        "[axis.2.plnt]\ninertia = 1e-5\n",
        """\
error[machine-file]: there is no key axis.2.plnt.inertia
 --> m.toml:2:1
  |
2 | inertia = 1e-5
  | ^^^^^^^
  hint: did you mean axis.N.plant.inertia?
""",
    ),
]


@pytest.mark.parametrize(("text", "message"), MISTAKES, ids=lambda text: text.split("\n")[-2][:30])
def test_a_mistake_is_reported_with_its_line(text: str, message: str) -> None:
    source = Source("m.toml", text)
    with pytest.raises(ProgramError) as caught:
        read_machine(source)
    assert render_all(caught.value.diagnostics, source, name="m.toml") == message


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
