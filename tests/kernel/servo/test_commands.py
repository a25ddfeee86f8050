"""`motionlang servo`: its JSON, its pictures, and its error messages."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from motionlang.cli import main

SCHEMA = "motionlang/1"


def run_command(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, str, str]:
    """Return exit status, standard output, standard error."""
    try:
        status = main(["servo", *words])
    except SystemExit as ended:
        status = int(ended.code or 0)
    captured = capsys.readouterr()
    return status, captured.out, captured.err


@pytest.mark.parametrize(
    "words",
    [
        ("compare", "--equal", "time"),
        ("step",),
        ("step", "--plant", "coulomb=0.01"),
        ("step", "--plant", "kind=drive", "--plant", "speed_per_volt=5000"),
        ("tune",),
    ],
    ids=" ".join,
)
def test_every_command_speaks_json(words: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    status, out, err = run_command(capsys, *words, "--format", "json")
    assert (status, err) == (0, "")
    assert json.loads(out)["schema"] == SCHEMA


def test_infinite_jerk_is_null(capsys: pytest.CaptureFixture[str]) -> None:
    _, out, _ = run_command(capsys, "compare", "--equal", "acceleration", "--format", "json")
    jerks = {row["shape"]: row["jerk"] for row in json.loads(out)["acceleration"]}
    assert jerks["trapezoid"] is None
    assert jerks["sinusoidal"] == pytest.approx(5e5)


@pytest.fixture
def program(tmp_path: Path) -> Path:
    from motionlang.kernel import Source

    path = tmp_path / "move.mnt"
    path.write_text(
        "SCALE(0) = 100\nSPEED(0) = 200\nACCEL(0) = 2000\nDECEL(0) = 2000\nMOVER(0) = 40\nGO(0)\n"
    )
    assert Source.read(path).text
    return path


def test_a_program_runs_through_the_servo(program: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, out, err = run_command(capsys, "run", str(program), "--window", "2", "--format", "json")
    assert (status, err) == (0, "")
    (axis,) = json.loads(out)["axes"]
    assert axis["axis"] == 0
    assert 0.0 < axis["peak_error"] < 100.0
    assert 0.3 < axis["settled_at"] < 0.6


@pytest.mark.usefixtures("unrendered")
def test_a_program_that_ran_through_the_servo_is_drawn(
    program: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The picture is that of a run, which `tests/views/test_run_figure.py` makes with a servo."""
    file = tmp_path / "move.svg"
    assert run_command(capsys, "run", str(program), "-q", "--plot", str(file)) == (0, "", "")
    assert file.exists()


@pytest.mark.parametrize(
    "words",
    [
        ("compare", "--equal", "time"),
        ("step",),
    ],
    ids=" ".join,
)
def test_every_picture_is_drawn(
    words: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "out.svg"
    status, out, err = run_command(capsys, *words, "--format", "none", "--plot", str(path))
    assert (status, out, err) == (0, "", "")
    drawn = path.read_bytes()
    assert drawn.startswith(b"<svg")
    assert len(drawn) > 4000
    if words == ("step",):
        run_command(capsys, *words, "--format", "none", "--plot", str(path))
        assert path.read_bytes() == drawn, "the same picture has the same bytes"


@pytest.mark.parametrize(
    ("words", "status", "message"),
    [
        (("compare", "--distance", "0"), 2, "argument --distance: '0' is not a number greater than zero"),
        (("compare", "--speed", "nan"), 2, "'nan' is not a number greater than zero"),
        (("compare", "--ramp", "0.7"), 2, "ramp must be"),
        (("step", "--plot", "x.gif"), 2, "--plot writes .png and .svg, not .gif files"),
        (("step", "--plant", "inertia"), 2, "'inertia' is not NAME=VALUE"),
        (("step", "--mint", "KPROP=1", "--mccl", "SG=1"), 2, "give gains of either Mint or MCCL, not both"),
        (("step", "--loop", "proportional=nan"), 2, "proportional must be a finite number"),
        (("compare", "--equal", "jerk"), 2, "is not one of"),
        (("run", "a.mnt", "--until", "-1"), 2, "argument --until: '-1' is not a time in seconds, 0 or more"),
        (("run", "missing.mnt"), 1, "error[file]: missing.mnt cannot be read: no such file or directory"),
        (
            ("step", "--machine", "missing.toml"),
            1,
            "error[file]: missing.toml cannot be read: no such file or directory",
        ),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, tuple) else "",
)
def test_refusals(
    words: tuple[str, ...], status: int, message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    found, out, err = run_command(capsys, *words)
    assert (found, out) == (status, "")
    assert message in err
    assert "Traceback" not in err


def test_a_machine_file_with_a_mistake(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "m.toml"
    for text, message in (
        ("[axis.0.plant\n", "error[machine-file]: "),
        ("axis = 3\n", "m.toml:1"),
        ("[axis.0]\nplant = 3\n", "m.toml:2"),
        ("[axis.0.plant]\ninerta = 1e-5\n", "did you mean inertia?"),
    ):
        path.write_text(text)
        found, out, err = run_command(capsys, "step", "--machine", str(path))
        assert (found, out) == (1, "")
        assert message in err


def test_a_program_that_does_not_run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "bad.mnt"
    path.write_text("MOVER(0) =\n")
    found, out, err = run_command(capsys, "run", str(path))
    assert (found, out) == (1, "")
    assert err.startswith("error[syntax]: expected a value before the end of the line\n --> ")


def test_a_program_takes_settings(program: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ("run", str(program), "--set", "axis.0.plant.resistance=2", "--format", "json")
    status, out, _ = run_command(capsys, *words)
    assert (status, json.loads(out)["plants"]) == (0, [])
