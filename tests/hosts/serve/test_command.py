"""`motionlang serve` as a process: output, exit, error messages."""

from __future__ import annotations

import re
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from motionlang.cli import main
from motionlang.client import Client
from tests.cli.programs import MAX_SECONDS

COMMAND = [sys.executable, "-m", "motionlang", "serve"]

# Characters that wait for a reader of the output.
STORED = 1 << 18


@contextmanager
def running(*options: str) -> Iterator[subprocess.Popen[str]]:
    with subprocess.Popen(
        [*COMMAND, *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        try:
            yield process
        finally:
            process.kill()


def line_with(process: subprocess.Popen[str], start: str) -> str:
    """Return the rest of the first output line that begins with `start`."""
    assert process.stdout is not None
    for line in process.stdout:
        if line.startswith(start):
            return line.removeprefix(start).strip()
    raise AssertionError(process.communicate())


@pytest.mark.parametrize("end", [signal.SIGINT, signal.SIGTERM])
def test_a_session(tmp_path: Path, end: signal.Signals) -> None:
    """First a file, with its rejected commands shown; then a host; then a normal exit."""
    macros = tmp_path / "press.mcl"
    macros.write_text("; press\nMD1,1MN,1MR800,1WS,1TP\nMC1\n1QQ\n")
    with running(str(macros), "--tcp", "0", "--log", "--factor", "50", "--set", "R20=7") as process:
        address = line_with(process, "listening on ")
        assert line_with(process, "01 ") == "800"
        with Client.open(address) as board:
            assert board.send("1TP,TR20") == ["01 800", "7"]
        process.send_signal(end)
        out, err = process.communicate(timeout=60)
    assert process.returncode == 0
    assert "served 1 host; machine time " in out
    assert "error[unknown-word]: there is no command QQ (?1: unrecognised command)\n" in err
    assert "press.mcl:4:1\n" in err
    assert "1 < 1TP,TR20\n1 > 01 800\n1 > 7\n" in err
    assert "Traceback" not in err


@pytest.mark.slow
def test_a_log_that_is_not_read_holds_up_no_one(tmp_path: Path) -> None:
    """More is logged than the pipe and the queue can store, but hosts are answered."""
    logged = 2 * (STORED + 65536)
    with running("--tcp", "0", "--log", "--clock", "lockstep") as process:
        with Client.open(line_with(process, "listening on "), timeout=MAX_SECONDS) as board:
            for _ in range(logged // 250):
                board.send(";" + "x" * 249)
            assert board.send("1TP") == ["01 0"]
        process.send_signal(signal.SIGTERM)
        out, _ = process.communicate(timeout=MAX_SECONDS)
    assert process.returncode == 0
    found = re.search(r"^served 1 host; .*; (\d+) lines of standard error dropped$", out, re.MULTILINE)
    assert found, out
    assert int(found[1]) >= logged // 250 // 2


@pytest.mark.parametrize("name", ["a.txt", "a"])
def test_a_file_of_no_language_is_refused(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / name).write_text("1MN\n", encoding="utf-8")
    assert main(["serve", str(tmp_path / name), "--tcp", "0"]) == 2
    assert "add --lang mint or --lang mccl" in capsys.readouterr().err


def test_the_board_is_the_one_that_the_file_is_written_for(tmp_path: Path) -> None:
    """The suffix of the file, as PMC uses it, selects the board unless a setting does."""
    macros = tmp_path / "press.pc1"
    macros.write_text("1TP\n")
    for options, title in [
        ((), "DCX-PC100 modular controller"),
        (("--set", "controller.model=dcx-pci300"), "DCX-PCI300, DSP based modular controller"),
    ]:
        with running(str(macros), "--tcp", "0", *options) as process:
            out = line_with(process, title)
            process.kill()
        assert out.startswith(", 8 axes")


def test_hosts_that_are_connected_at_the_end_get_the_output() -> None:
    with running("--tcp", "0") as process:
        port = int(line_with(process, "listening on ").rpartition(":")[2])
        with socket.create_connection(("127.0.0.1", port), 20) as host:
            host.sendall(b"HE\r")
            reply = host.recv(1) + host.recv(1)
            process.send_signal(signal.SIGTERM)
            while piece := host.recv(65536):
                reply += piece
            assert reply.count(b"\n") > 100
            assert reply.endswith(b"\n>")
        assert process.wait(20) == 0


def test_other_computers_are_let_in_only_when_it_is_said() -> None:
    with running("--tcp", "0.0.0.0:0") as process:
        address = line_with(process, "listening on ")
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
    assert err == (
        f"motionlang serve: warning: any computer that can reach this one can connect to {address}; "
        "there is no password\n"
    )


def test_a_port_that_is_taken(capsys: pytest.CaptureFixture[str]) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        assert main(["serve", "--tcp", "0", "--tcp", str(port)]) == 1
    out, err = capsys.readouterr()
    assert out == ""
    assert err == f"error[address]: cannot listen on 127.0.0.1:{port}: address already in use\n"


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            [],
            "no address for hosts: give --tcp or --modbus with HOST:PORT, or --pty",
        ),
        (["--tcp", "nowhere"], "argument --tcp: 'nowhere' is not HOST:PORT with a port from 0"),
        (["--tcp", "127.0.0.1:70000"], "is not HOST:PORT with a port from 0 (any that is free) to 65535"),
        (["--tcp", "0", "--step", "1"], "--step needs --clock lockstep"),
        (["--tcp", "0", "--clock", "lockstep", "--factor", "2"], "--factor needs --clock real"),
        (["--tcp", "0", "--factor", "-1"], "'-1' is not a factor from"),
        (["--tcp", "0", "--max-hosts", "0"], "'0' is not a number of connections from 1 to 1000"),
        (["--tcp", "0", "--set", "controller.model=pmc9"], "'pmc9' is not a known controller"),
    ],
)
def test_mistakes_on_the_command_line(
    options: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as end:
        main(["serve", *options])
    assert end.value.code == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["gone.mcl"], "error[file]: gone.mcl cannot be read: no such file or directory\n"),
        (["--machine", "gone.toml"], "error[file]: gone.toml cannot be read: no such file or directory\n"),
        (["--set", "controller.model=mintmt"], "error[machine-file]: MCCL has no model mintmt\n"),
        (["--set", "R999=1"], "error[range]: there is no register 999\n"),
        (
            ["--tcp", "no.such.host.invalid:1"],
            "error[address]: cannot listen on no.such.host.invalid:1: ",
        ),
    ],
)
def test_what_cannot_be_served(options: list[str], message: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["serve", "--tcp", "0", *options]) == 1
    assert message in capsys.readouterr().err
