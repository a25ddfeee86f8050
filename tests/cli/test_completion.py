"""Shell completion matches the parser."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.programs import Cell

pytest.importorskip("shtab")


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_every_command_and_its_options_are_there(shell: str, cell: Cell) -> None:
    ran = cell("completion", shell)
    assert (ran.status, ran.err) == (0, "")
    assert [
        word for word in ("check", "verify", "serve", "evidence", "sarif", "retract") if word not in ran.out
    ] == ["retract"]


@pytest.mark.skipif(shutil.which("bash") is None, reason="there is no bash")
def test_bash_completes_an_option(cell: Cell, tmp_path: Path) -> None:
    script = tmp_path / "completion.bash"
    script.write_text(cell("completion", "bash").out, encoding="utf-8")
    lines = f"""source {script}
COMP_WORDS=(motionlang check --for) COMP_CWORD=2
$(complete -p motionlang | sed 's/.*-F //; s/ .*//')
echo "${{COMPREPLY[@]}}"
"""
    ran = subprocess.run(["bash", "-c", lines], capture_output=True, text=True, check=True)
    assert ran.stdout == "--format\n"


def test_without_shtab_it_says_what_is_missing(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "shtab", None)
    ran = cell("completion", "bash")
    assert (ran.status, ran.out) == (1, "")
    assert "needs shtab" in ran.err
