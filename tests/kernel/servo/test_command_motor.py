"""The motor of the `servo` commands: named in their output, set by options."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from motionlang.cli import main

EXAMPLE = {"load_inertia": 4e-5, "viscous": 2e-5, "resistance": 1.0}


def plant(capsys: pytest.CaptureFixture[str], *words: str) -> dict[str, object]:
    assert main(["servo", *words, "--format", "json"]) == 0
    found: dict[str, object]
    (found,) = json.loads(capsys.readouterr().out)["plant"]
    return found


@pytest.mark.parametrize("command", ["step", "tune", "compare"])
def test_one_option_changes_one_thing(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    before = plant(capsys, command)
    assert {name: before[name] for name in EXAMPLE} == EXAMPLE
    assert plant(capsys, command, "--plant", "resistance=1.5") == {**before, "resistance": 1.5}


@pytest.mark.parametrize("command", ["step", "tune", "compare"])
def test_the_table_names_the_motor(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["servo", command, "--plant", "coulomb=0.01"]) == 0
    last = capsys.readouterr().out.splitlines()[-1]
    assert last.startswith("motor: load_inertia 4e-05, viscous 2e-05, coulomb 0.01, the rest")


def test_a_drive_has_nothing_of_the_motor(capsys: pytest.CaptureFixture[str]) -> None:
    found = plant(capsys, "step", "--plant", "kind=drive", "--plant", "time_constant=0.003")
    assert found == {"speed_per_volt": 10_000.0, "time_constant": 0.003, "quantised": False}


@pytest.mark.parametrize(
    ("text", "is_quantised"), [("0", False), ("1", True), ("false", False), ("True", True)]
)
def test_a_flag_is_given_in_figures_or_in_words(
    text: str, is_quantised: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    assert plant(capsys, "step", "--plant", f"quantised={text}")["quantised"] is is_quantised


def test_a_bandwidth_leaves_the_motor_of_the_machine_file_unchanged(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "slide.mnt").write_text("MOVER(0) = 100\nGO(0)\nPAUSE IDLE(0)\n")
    (tmp_path / "slide.machine.toml").write_text("[axis.0.plant]\nresistance = 3.0\n")
    program = str(tmp_path / "slide.mnt")
    assert main(["servo", "run", program, "--bandwidth", "40", "--format", "json"]) == 0
    motor = {row["setting"]: row["value"] for row in json.loads(capsys.readouterr().out)["plants"]}
    assert (motor["resistance"], motor["load_inertia"]) == (3.0, 0.0)
    assert main(["servo", "run", program, "--bandwidth", "40"]) == 0
    assert capsys.readouterr().out.splitlines()[-1].startswith("axis 0: motor: resistance 3, the rest")
