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


def test_the_soft_plc_sends_escapes_first(board: Board) -> None:
    wire = board.connect()
    for _ in range(3):
        wire.send(b"\x1b")
    wire.expect(b"\n>\n>\n>")
    assert wire.ask(b"1TP") == b"01 0\n>"


def test_escape_behind_more_than_the_board_takes(board: Board) -> None:
    wire = board.connect()
    wire.send(b"WN40\r" + b"1TP\r" * 5000)
    wire.send(b"\x1b")
    wire.expect(b"?-7\n>")
    assert wire.ask(b"2TP") == b"02 0\n>"


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
