"""Commands of other packages: the example of docs/contributing/commands.md, and entry points that are of no use."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from motionlang.cli import main
from tests.built import ROOT

PAGE = (ROOT / "docs" / "contributing" / "commands.md").read_text(encoding="utf-8")
LISTED = "\n  seconds     print how long a program runs\n"


@pytest.mark.slow
def test_the_example_of_the_page_is_installed_and_runs(tmp_path: Path) -> None:
    (project,), (module,) = (re.findall(rf"```{kind}\n(.*?)```", PAGE, re.DOTALL) for kind in ("ini", "py"))
    (tmp_path / "pyproject.toml").write_text(project, encoding="utf-8")
    (tmp_path / "motionlang_seconds.py").write_text(module, encoding="utf-8")
    installed = str(tmp_path / "installed")
    options = ("--quiet", "--no-deps", "--no-build-isolation", "--target", installed)
    subprocess.run([sys.executable, "-m", "pip", "install", *options, "."], cwd=tmp_path, check=True)

    def motionlang(*words: str) -> str:
        return subprocess.check_output(
            [sys.executable, "-m", "motionlang", *words],
            cwd=ROOT, env={**os.environ, "PYTHONPATH": installed}, text=True,
        )  # fmt: skip

    assert motionlang("seconds", "scripts/mint/ballscrew.mnt") == "1.000 s\n"
    assert LISTED in motionlang("--help")
    assert "Print how long a program runs.\n\npositional" in motionlang("help", "seconds")


@pytest.mark.parametrize(
    ("entry", "reason"),
    [
        ("no_such_module:Command", "No module named 'no_such_module'"),
        ("json:no_such_class", "module 'json' has no attribute 'no_such_class'"),
        ("json:loads", "'function' object has no attribute 'add'"),
    ],
)
def test_an_entry_point_without_a_command(
    entry: str,
    reason: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    info = tmp_path / "other-1.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: other\nVersion: 1\n", encoding="utf-8")
    (info / "entry_points.txt").write_text(
        f"[motionlang.commands]\nother = {entry}\nrun = {entry}\n", encoding="utf-8"
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    for line, status in (("other x", 2), ("--help", 0), ("run --help", 0)):
        with pytest.raises(SystemExit) as end:
            main(line.split())
        assert end.value.code == status
    out, err = capsys.readouterr()
    assert err == f"motionlang: error: {entry} for the command other cannot be used: {reason}\n"
    assert "\n  other       a command of other\n" in out


LENGTHS = """\
from dataclasses import dataclass

from motionlang.cli.command import Command

SUMMARIES = {"minutes": "print the minutes of a program"}


@dataclass
class Minutes(Command):
    def run(self) -> int:
        return 0


@dataclass
class Hours(Command):
    def run(self) -> int:
        return 0
"""


@pytest.mark.parametrize(
    ("about", "others"),
    [("Summary: How long programs run.\n", "how long programs run"), ("", "a command of lengths")],
)
def test_several_commands_of_a_package_have_summaries_of_their_own(
    about: str,
    others: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """A command without one has that of its package, or the name of it."""
    (tmp_path / "lengths.py").write_text(LENGTHS, encoding="utf-8")
    info = tmp_path / "lengths-1.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(
        f"Metadata-Version: 2.1\nName: lengths\nVersion: 1\n{about}", encoding="utf-8"
    )
    (info / "entry_points.txt").write_text(
        "[motionlang.commands]\nminutes = lengths:Minutes\nhours = lengths:Hours\n", encoding="utf-8"
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    for line in ("--help", "minutes --help", "hours --help"):
        with pytest.raises(SystemExit) as end:
            main(line.split())
        assert end.value.code == 0
    out = capsys.readouterr().out
    assert f"\n  hours       {others}\n" in out
    assert "\n  minutes     print the minutes of a program\n" in out
    assert "\nPrint the minutes of a program.\n" in out
    assert f"\n{others[0].upper()}{others[1:]}.\n" in out
