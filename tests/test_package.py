"""The package for users: metadata, wheel and source distribution, all run."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path

import pytest

from motionlang import __version__
from motionlang._wheel import without_links

ROOT = Path(__file__).parent.parent


def run(command: list[str], folder: Path, **environment: str) -> str:
    """Return the output of a command; if it fails, show its message."""
    ran = subprocess.run(
        command, cwd=folder, env=os.environ | environment, capture_output=True, text=True, check=False
    )
    assert ran.returncode == 0, ran.stdout + ran.stderr
    return ran.stdout


@pytest.mark.slow
@pytest.mark.parametrize("number", [0, 1], ids=["sdist", "wheel"])
def test_it_can_be_installed_and_run(number: int, built: tuple[Path, Path], tmp_path: Path) -> None:
    """Only the wheel is installed: a run needs no library except for terminal output."""
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    alone = ["--no-deps", "--no-index", "--no-build-isolation", "--no-compile", "--target", "site"]
    run([*pip, *alone, str(built[number])], tmp_path)
    shutil.copy(ROOT / "scripts" / "mint" / "ballscrew.mnt", tmp_path)
    command = [sys.executable, "-m", "motionlang", "run", "ballscrew.mnt", "--format", "json"]
    site = str(tmp_path / "site")
    assert json.loads(run(command, tmp_path, PYTHONPATH=site))["axes"][0]["position"] == 200.0
    where = [sys.executable, "-c", "import motionlang; print(motionlang.__file__)"]
    assert run(where, tmp_path, PYTHONPATH=site).startswith(site)


@pytest.mark.slow
def test_it_runs_from_a_zip_file(built: tuple[Path, Path], tmp_path: Path) -> None:
    shutil.copy(ROOT / "scripts" / "mint" / "ballscrew.mnt", tmp_path)
    command = [sys.executable, "-m", "motionlang"]
    zipped = {"PYTHONPATH": str(built[1])}
    assert run([*command, "help", "SPEED"], tmp_path, **zipped).startswith("SPEED · Mint setting")
    assert "200.0000 mm" in run([*command, "run", "ballscrew.mnt"], tmp_path, **zipped)


@pytest.mark.slow
def test_an_index_would_take_it(built: tuple[Path, Path], tmp_path: Path) -> None:
    pytest.importorskip("twine")
    run([sys.executable, "-m", "twine", "check", "--strict", *map(str, built)], tmp_path)


@pytest.mark.slow
def test_the_wheel_has_what_belongs_there(built: tuple[Path, Path], tmp_path: Path) -> None:
    pytest.importorskip("check_wheel_contents")
    run([sys.executable, "-m", "check_wheel_contents", str(built[1])], tmp_path)


@pytest.mark.slow
def test_the_licence_is_in_both(built: tuple[Path, Path]) -> None:
    text = (ROOT / "LICENSE").read_bytes()
    assert text.startswith(b"MIT License")
    with zipfile.ZipFile(built[1]) as wheel:
        (name,) = (each for each in wheel.namelist() if each.endswith("/licenses/LICENSE"))
        assert wheel.read(name) == text
        assert "motionlang/py.typed" in wheel.namelist()
    with tarfile.open(built[0]) as sdist:
        found = sdist.extractfile(f"motionlang-{__version__}/LICENSE")
        assert found is not None
        assert found.read() == text


@pytest.mark.slow
def test_the_source_distribution_is_whole(built: tuple[Path, Path]) -> None:
    """It has everything that README mentions: the gallery, the pages and the tests."""
    with tarfile.open(built[0]) as sdist:
        names = {name.partition("/")[2] for name in sdist.getnames()}
    assert {"CHANGELOG.md", "CITATION.cff", "CONTRIBUTING.md", "SECURITY.md", "README.md"} <= names
    for folder in (
        "benchmarks",
        "docs",
        "examples",
        "extras",
        "grammars",
        "motionlang",
        "scripts",
        "tests",
        "tools",
    ):
        here = {
            path.relative_to(ROOT).as_posix()
            for path in (ROOT / folder).rglob("*")
            if path.is_file()
            and "__pycache__" not in path.parts
            and path.suffix not in (".pyc", ".table")
            and path.parent.suffix != ".egg-info"
        }
        assert here <= names, sorted(here - names)[:5]


def test_the_description_links_to_nothing_that_an_index_lacks(built: tuple[Path, Path]) -> None:
    with zipfile.ZipFile(built[1]) as wheel:
        metadata = wheel.read(next(n for n in wheel.namelist() if n.endswith("/METADATA"))).decode()
    assert "the command line (`docs/commands/README.md`)" in metadata
    assert "](docs" not in metadata


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("[docs/commands/README.md](docs/commands/README.md)", "`docs/commands/README.md`"),
        ("[a page](docs/commands/run.md#errors)", "a page (`docs/commands/run.md`)"),
        ("![a move](docs/move.png)\n\nA move", "A move"),
        ("[there](https://example.org/a)", "[there](https://example.org/a)"),
    ],
)
def test_links_become_names(text: str, shown: str) -> None:
    assert without_links(text) == shown


def test_the_matrix_is_what_the_package_says() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    versions = [each.rpartition(" ")[2] for each in project["classifiers"] if ":: 3." in each]
    matrix = (ROOT / ".github" / "workflows" / "ci.yml").read_text(encoding="utf-8")
    assert f"python: {json.dumps(versions)}" in matrix
    assert project["requires-python"] == f">={versions[0]}"
