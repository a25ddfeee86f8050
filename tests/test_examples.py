"""The examples for Python: each prints what the comments of its `print` lines say."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from runpy import run_path

import pytest

from motionlang.extras import NAMES

ROOT = Path(__file__).parent.parent
EXAMPLES = sorted((ROOT / "examples").glob("*.py"))
# These call functions of a distribution of the folder extras, which tests them.
OTHERS = [
    path for path in EXAMPLES if re.search(rf"motionlang\.({'|'.join(NAMES)})\(", path.read_text("utf-8"))
]
SHOWN = re.compile(r"^ *print\(.*\)  # (.*)$", re.MULTILINE)


def test_they_are_numbered_without_a_gap() -> None:
    assert [path.name[:3] for path in EXAMPLES] == [f"{n:02}_" for n in range(1, len(EXAMPLES) + 1)]


@pytest.fixture
def lines_of(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Callable[[Path], list[str]]:
    """Return a function that runs an example, and returns the lines that it prints."""

    def run(path: Path) -> list[str]:
        monkeypatch.chdir(tmp_path)
        monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path))
        run_path(str(path), run_name="__main__")
        return capsys.readouterr().out.splitlines()

    return run


@pytest.mark.parametrize(
    "path", [path for path in EXAMPLES if path not in OTHERS], ids=lambda path: path.stem
)
def test_an_example_prints_its_comments(path: Path, lines_of: Callable[[Path], list[str]]) -> None:
    assert lines_of(path) == SHOWN.findall(path.read_text(encoding="utf-8"))


def test_an_example_is_a_script(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, str(EXAMPLES[0])],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        encoding="utf-8",
        env={"PYTHONUTF8": "1", "PYTHONPATH": str(ROOT), "MOTIONLANG_CACHE": str(tmp_path)},
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == SHOWN.findall(EXAMPLES[0].read_text(encoding="utf-8"))
