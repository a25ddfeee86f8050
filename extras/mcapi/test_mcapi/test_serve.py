"""`motionlang mcapi serve` on the command line."""

from __future__ import annotations

import re
import socket
from pathlib import Path

import pytest

from motionlang.cli import main
from motionlang.hosts.serve import Server

TAKEN = "error[address]: cannot listen on 127.0.0.1:PORT: address already in use\n"


def test_the_output_of_a_server_without_hosts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(Server, "run", lambda self: None)
    Path("macros.mcl").write_text("1MN\n", encoding="utf-8")
    assert main(["mcapi", "serve", "macros.mcl", "--port", "0", "--tcp", "0"]) == 0
    assert re.sub(r"1:\d+", "1:PORT", capsys.readouterr().out) == (
        "MultiFlex PCI 1000 series, 8 axes, in real time; Ctrl-C ends it\nlistening on 127.0.0.1:PORT\n"
        "listening on 127.0.0.1:PORT for MCAPI\nserved 0 hosts; machine time 0.000 s\n"
    )


@pytest.mark.parametrize("line", ["--port {}", "--port 0 --tcp {}"])
def test_a_port_that_is_taken(line: str, capsys: pytest.CaptureFixture[str]) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        assert main(["mcapi", "serve", *line.format(port).split()]) == 1
    assert capsys.readouterr() == ("", TAKEN.replace("PORT", str(port)))


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("", "no address for hosts: give --port HOST:PORT"),
        ("--tcp 0", "no address for hosts: give --port HOST:PORT"),
        ("--port x", "argument --port: 'x' is not HOST:PORT with a port from 0"),
        ("a.mnt --port 0", "mcapi serves an MCCL board; motionlang serve has the line of a Mint program"),
        (
            "--lang mint --port 0",
            "mcapi serves an MCCL board; motionlang serve has the line of a Mint program",
        ),
    ],
)
def test_a_wrong_command_line(line: str, message: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(["mcapi", "serve", *line.split()])
    assert end.value.code == 2
    assert capsys.readouterr().err.startswith(f"motionlang mcapi serve: error: {message}")
