"""The protocols of real clients of a board, as bytes on a socket."""

from __future__ import annotations

import socket

import pytest

from tests.hosts.serve.conftest import Board, Serve, Wire


class MxError(Exception):
    """The error that a line `?code` raises."""


def mx_command(wire: Wire, command: str) -> str:
    """Send a command like MX's beam-line driver and return the line that it reads.

    The driver sends the command and CR, reads one line, drops a leading prompt, and raises `?code`. The real driver
    blocks if no line comes, and reads past the end of its buffer if the line is empty.
    """
    assert len(command) < 255
    wire.send(command.encode() + b"\r")
    line = wire.until(b"\n").decode()
    if line[0] == ">":
        line = line[1:]
    if line[-1] == "\n":
        line = line[:-1].removesuffix("\r")
    if line[:1] == "?":
        raise MxError(int(line[1:]))
    return line


@pytest.fixture(params=["lockstep", "real"])
def board(request: pytest.FixtureRequest, serve: Serve) -> Board:
    return serve(clock=request.param, factor=20.0)


def test_mx(board: Board) -> None:
    wire = Wire(board.address)
    board.wires.append(wire)
    assert mx_command(wire, "1SA70000.000000") == ""
    assert mx_command(wire, "1SV20000.000000") == ""
    assert mx_command(wire, "1MN") == ""
    assert mx_command(wire, "1MR1000") == ""
    assert mx_command(wire, "1WS0.1") == ""
    assert mx_command(wire, "1TP") == "01 1000"
    with pytest.raises(MxError, match=r"^1$"):
        mx_command(wire, "1XX")
    with pytest.raises(MxError, match=r"^-1$"):
        mx_command(wire, "1SV-5")
    assert mx_command(wire, "1TP") == "01 1000"


def test_mx_finds_home_by_a_macro_in_the_background(board: Board) -> None:
    """The answer to `GT1,TR0` must be the number of the task.

    The host then polls the status.
    """
    wire = board.connect()
    mx_command(wire, "MD1,1MN,1MR2000,1WS,AL1,AR20")
    assert mx_command(wire, "GT1,TR0") == "1"
    while mx_command(wire, "TR20") != "1":
        pass
    assert mx_command(wire, "1TP") == "01 2000"


def test_the_self_test(board: Board) -> None:
    """`TC1`, a read for the value, and a second read for the prompt."""
    wire = board.connect()
    wire.send(b"TC1\r")
    assert wire.until(b"\n") == b"01 0\n"
    wire.expect(b">")


def test_the_soft_plc_sends_escapes_first(board: Board) -> None:
    wire = board.connect()
    for _ in range(3):
        wire.send(b"\x1b")
    wire.expect(b"\n>\n>\n>")
    assert wire.ask(b"1TP") == b"01 0\n>"


def test_escape_ends_a_wait(board: Board) -> None:
    """It may come during the wait or before the wait has begun."""
    wire = board.connect()
    wire.send(b"1MN,1VM,1GO,WN40,1TP\r")
    wire.send(b"\x1b")
    wire.expect(b"?-7\n>")
    assert wire.ask(b"1ST,1WS,TE") == b"-7\n>"


def test_escape_behind_more_than_the_board_takes(board: Board) -> None:
    wire = board.connect()
    wire.send(b"WN40\r" + b"1TP\r" * 5000)
    wire.send(b"\x1b")
    wire.expect(b"?-7\n>")
    assert wire.ask(b"2TP") == b"02 0\n>"


def test_a_blank_pauses_and_goes_on(board: Board) -> None:
    """Another host sees a counting line stop between two blanks."""
    wire, other = board.connect(), board.connect()

    def count() -> int:
        return int(other.ask(b"TR20").split()[0])

    wire.send(b"AL@20,AA1,AR20,WA0.01,RP\r")
    while count() < 3:
        pass
    wire.send(b" ")
    while (paused_at := count()) != int(other.ask(b"WA0.05,TR20").split()[0]):
        pass
    wire.send(b" ")
    wire.send(b"\x1b")
    wire.expect(b"?-7\n>")
    assert paused_at >= 3


def test_line_ends(board: Board) -> None:
    wire = board.connect()
    for line in (b"1TP\r", b"1TP\n", b"1TP\r\n"):
        wire.send(line)
        wire.expect(b"01 0\n>")
    wire.send(b"\r")
    wire.expect(b"\n>")


def test_lines_sent_ahead_are_answered_in_order(board: Board) -> None:
    wire = board.connect()
    wire.send(b"".join(b"AL%d,TR0\r" % k for k in range(2000)))
    wire.expect(b"".join(b"%d\n>" % k for k in range(2000)))


def test_a_host_that_ends_its_side_is_answered(board: Board) -> None:
    """As with `printf ... | nc -N`: complete lines are executed, a partial one is not."""
    wire = board.connect()
    wire.send(b"1MN,1MR500,1WS,1TP\r2TP\r3M")
    wire.socket.shutdown(socket.SHUT_WR)
    assert wire.all() == b"01 500\n>02 0\n>"


def test_hosts_share_the_board(board: Board) -> None:
    first, second = board.connect(), board.connect()
    assert first.ask(b"1MN,1MR300,1WS,AL5,AR20,AL6,AR1") == b"\n>"
    assert second.ask(b"1TP,TR20,TR1") == b"01 300\n5\n0\n>"


@pytest.mark.parametrize(
    ("model", "answer"),
    [("multiflex", b">01 0\n>"), ("dcx-at200", b">01 0\r>"), ("dcx-pc100", b"01 0\r")],
)
def test_models_talk_as_they_do(serve: Serve, model: str, answer: bytes) -> None:
    wire = Wire(serve(model).address)
    wire.send(b"1TP\r")
    wire.expect(answer)
    wire.socket.close()
