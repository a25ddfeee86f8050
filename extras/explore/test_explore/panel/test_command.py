"""How the panel is started: what it refuses before it serves."""

from __future__ import annotations

import socket
from pathlib import Path

import pytest

from motionlang.cli import main


def test_a_program_with_an_error_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "wrong.mnt"
    path.write_text("SPED(0) = 5\n", encoding="utf-8")
    assert main(["panel", str(path)]) == 1
    assert (
        capsys.readouterr().err
        == f"""\
error[unknown-word]: SPED is unknown
 --> {path}:1:1
  |
1 | SPED(0) = 5
  | ^^^^
  hint: did you mean SPEED?
"""
    )


def test_a_port_in_use_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "wait.mnt"
    path.write_text("Pause INX(1)\n", encoding="utf-8")
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        assert main(["panel", str(path), "--port", str(port)]) == 1
    text = capsys.readouterr().err
    assert f"error[address]: port {port} cannot be used: address already in use" in text
    assert "leave out --port" in text


@pytest.mark.parametrize(
    ("arguments", "status", "words"),
    [
        (["-"], 2, "panel reads a file"),
        (["none.mnt"], 1, "none.mnt"),
        (["none.mnt", "--port", "70000"], 2, "a port from 0 to 65535"),
    ],
)
def test_what_cannot_be_served_is_refused(
    arguments: list[str], status: int, words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    try:
        found = main(["panel", *arguments])
    except SystemExit as error:
        found = int(str(error.code))
    assert found == status
    assert words in capsys.readouterr().err
