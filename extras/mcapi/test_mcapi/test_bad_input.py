"""Bad input: each row has its error code, and the board continues."""

from __future__ import annotations

import math
import socket

import pytest

import motionlang_mcapi as mc
from motionlang.hosts.serve import Limits
from motionlang_mcapi import Mcapi, McapiException
from test_mcapi.conftest import Serve, opened


def code(host: Mcapi, name: str, *arguments: object) -> int:
    """Return the error code with which the board answers a call."""
    found, _ = host._calls.call(name, host.Handle(), arguments)  # type: ignore[arg-type]
    return found


@pytest.mark.parametrize(
    ("name", "arguments", "wanted"),
    [
        ("MCGetPositionEx", (99, 1), mc.MCERR_AXIS_NUMBER),
        ("MCMoveAbsolute", (99, 1.0), mc.MCERR_AXIS_NUMBER),
        ("MCEnableGearing", (1, 99, 1.0, 1), mc.MCERR_AXIS_NUMBER),
        ("MCGetPositionEx", (0, 1), mc.MCERR_ALL_AXES),
        ("MCFindIndex", (0, 0.0), mc.MCERR_ALL_AXES),
        ("MCGetPositionEx", (1, None), mc.MCERR_RANGE),
        ("MCSetScale", (1, None), mc.MCERR_RANGE),
        ("pmclookupvar", (None, 1), mc.MCERR_RANGE),
        ("MCMoveAbsolute", (1, math.nan), mc.MCERR_RANGE),
        ("MCMoveAbsolute", (1, math.inf), mc.MCERR_RANGE),
        ("MCMoveAbsolute", (1, 1e300), mc.MCERR_RANGE),
        ("MCSetScale", (1, 6, 1.0, 0.0, 1.0, math.nan, 0.0, 1.0), mc.MCERR_RANGE),
        ("MCSetVelocity", (1, -5.0), mc.MCERR_RANGE),
        ("MCTranslateErrorEx", (15, 1, 0), mc.MCERR_RANGE),
        ("MCTranslateErrorEx", (15, 1, 5), mc.MCERR_RANGE),
        ("MCBlockEnd", (1,), mc.MCERR_BLOCK_MODE),
        ("MCRepeat", (2,), mc.MCERR_BLOCK_MODE),
        ("MCSetProfile", (1, 3), mc.MCERR_CONSTANT),
        ("MCGetRegister", (9999, 1, 2), mc.MCERR_RANGE),
        ("MCMacroCall", (7,), mc.MCERR_RANGE),
        ("MCConfigureCompare", (1, 0, 0, 0.0, 0, 0.0), mc.MCERR_NOTSUPPORTED),
        ("pmclookupvar", ("NONE", 1), mc.MCERR_NOT_FOUND),
        ("MCReopen", (0,), mc.MCERR_UNSUPPORTED_MODE),
    ],
)
def test_the_code_of_a_mistake(
    host: Mcapi, name: str, arguments: tuple[object, ...], wanted: int, capsys: pytest.CaptureFixture[str]
) -> None:
    """The code is the result and the handle's last error, which is cleared when read."""
    assert code(host, name, *arguments) == wanted
    if name != "MCTranslateErrorEx":
        assert host.GetError() == wanted
    assert host.GetError() == 0
    assert host.GetPositionEx(1) == 0.0


def test_the_handle_of_another_host(serve: Serve) -> None:
    """A handle belongs to one host process, over any of its connections."""
    board = serve()
    first, thread, foreign = board.connect(), board.connect(), board.connect()
    assert first.ask('Session 1 "a"') == "0"
    assert thread.ask('Session 1 "a"') == "0"
    assert first.ask("MCOpen 0 2 -") == "1"
    assert thread.ask("MCGetPositionEx 1 1 +") == "0 0.0"
    assert foreign.ask("MCGetPositionEx 1 1 +") == "13"


def test_no_board_listens() -> None:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        host = Mcapi(f"127.0.0.1:{free.getsockname()[1]}")
        assert host.Open(0, mc.MC_OPEN_BINARY) == -mc.MCERR_SOCKET


def test_calls_over_one_connection(serve: Serve) -> None:
    """Each host opens its own."""
    board = serve()
    host, other = Mcapi(board.name), Mcapi(board.name)
    assert code(host, "MCGetPositionEx", 1, 1) == mc.MCERR_SOCKET
    assert (host.Open(0, mc.MC_OPEN_BINARY), other.Open(0, mc.MC_OPEN_BINARY)) == (1, 1)
    host.SetPosition(1, 7.0)
    assert (host.GetPositionEx(1), other.GetPositionEx(1)) == (7.0, 7.0)
    host.Close()
    assert host.Open(0, mc.MC_OPEN_BINARY) == 1
    assert host.GetPositionEx(1) == 7.0
    for each in (host, other):
        each._calls.close()


def test_a_server_that_ends(serve: Serve) -> None:
    """Every call then returns 32, until another server is opened."""
    board = serve()
    host = Mcapi(board.name)
    assert host.Open(0, mc.MC_OPEN_BINARY) == 1
    board.end()
    for _ in range(2):
        with pytest.raises(McapiException) as caught:
            host.GetPositionEx(1)
        assert caught.value.code == mc.MCERR_SOCKET
    assert host.IsStopped(1, 60.0) == 0
    assert host.pmclock(0) == mc.MCERR_SOCKET
    assert host.Open(0, mc.MC_OPEN_BINARY) == -mc.MCERR_SOCKET


def test_a_host_that_is_gone_in_a_block(serve: Serve) -> None:
    """The block of a host that disconnects is discarded."""
    board = serve()
    gone = board.connect()
    gone.ask("MCOpen 0 2 -")
    gone.ask("MCEnableAxis 1 1 1")
    assert gone.ask("MCBlockBegin 1 0 0") == "0"
    assert gone.ask("MCMoveAbsolute 1 1 5000.0") == "0"
    other = board.connect()
    other.ask("MCOpen 0 2 -")
    assert other.ask("MCBlockBegin 1 0 0") == "26"
    gone.socket.shutdown(socket.SHUT_WR)
    assert gone.answer() == "closed"
    assert other.ask("MCBlockBegin 1 0 0") == "0"
    assert other.ask("MCBlockEnd 1 +") == "0 0"
    assert other.ask("MCBlockEnd 1 +") == "26"
    assert other.ask("MCGetTargetEx 1 1 +") == "0 0.0"


def test_a_host_that_is_gone_in_a_wait(serve: Serve) -> None:
    """A wait of an hour ends 0.05 s after its host is gone; the next host is served."""
    board = serve(clock="real", limits=Limits(linger=0.05))
    gone, other = board.connect(), board.connect()
    for line in (gone, other):
        assert line.ask("MCOpen 0 2 -") == "1"
    gone.send("MCWait 1 3600.0")
    gone.socket.close()
    board.lines.remove(gone)
    assert other.ask("MCGetPositionEx 1 1 +") == "0 0.0"


def test_a_dialog_is_no_function(serve: Serve) -> None:
    """MCDLG is not there: not on the port, not in the class, and not in the table."""
    line = serve().connect()
    line.send("MCDLG_SaveAxis 1 1 0 +")
    assert line.answer() == "! there is no function 'MCDLG_SaveAxis': the dialogs of MCDLG are not simulated"
    assert line.answer() == "closed"
    assert not hasattr(opened(), "SaveAxis")


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("hello", "there is no function 'hello'"),
        ("x" * 50, f"there is no function {'x' * 40!r}"),
        ("MCStop", "MCStop needs a handle"),
        ("MCStop -", "MCStop needs a handle"),
        ("MCStop 1.0 1", "MCStop needs a handle"),
        ("MCStop one 1", "'one' is not a value"),
        ("MCMoveAbsolute 1 1 1e999", "'1e999' is too large"),
        ('pmcputs 1 "\\q"', "\\q is no escape"),
        ("MCStop 1", "arguments are missing"),
        ("MCStop 1 1 1", "MCStop has 1 arguments, not 2"),
        ("MCStop 1 1.5", "axis is an integer"),
        ('MCMoveAbsolute 1 1 "far"', "position is a number"),
        ("MCMoveAbsolute 1 1 -", "position is a number"),
        ("pmcputs 1 5", "buffer is a text"),
        ("MCSetScale 1 1 1.0 1.0", "scale needs the number of its values"),
        ("MCSetScale 1 1 6 1.0 2.0 3.0 4.0 5.0", "scale needs the number of its values"),
        ("MCSetScale 1 1 -1", "scale needs the number of its values"),
        ("MCSetScale 1 1 7 1.0 2.0 3.0 4.0 5.0 6.0 7.0", "MCSCALE does not have these values"),
        ('MCSetScale 1 1 1 "a"', "MCSCALE does not have these values"),
        ("MCSetScale 1 1 1 1.0 2.0", "MCSetScale has 3 arguments, not 4"),
        ('Session 2 "x"', ""),
        ("Session 1", ""),
        ("MCStop 1 " + "1" * 5000, ""),
        ("\x00\xff\x1b", ""),
        ("x" * 40_000, "a line has at most 32768 characters"),
    ],
)
def test_a_line_that_is_no_call(serve: Serve, line: str, message: str) -> None:
    """The reason is the answer, then the connection is closed; others are unaffected."""
    board = serve()
    other, wrong = board.connect(), board.connect()
    assert other.ask("MCOpen 0 2 -") == "1"
    wrong.send(line)
    found = wrong.answer()
    assert found == f"! {message}" if message else found.startswith("! ")
    assert wrong.answer() == "closed"
    assert other.ask("MCGetPositionEx 1 1 +") == "0 0.0"


def test_a_line_without_an_end(serve: Serve) -> None:
    board = serve()
    endless, other = board.connect(), board.connect()
    endless.socket.sendall(b"x" * 60_000)
    assert endless.answer() == "! a line has at most 32768 characters"
    assert endless.answer() == "closed"
    assert other.ask("MCOpen 0 2 -") == "1"


def test_an_unsupported_function_is_reported_once(serve: Serve) -> None:
    board = serve()
    line = board.connect()
    line.ask("MCOpen 0 2 -")
    assert [line.ask("MCEnableCapture 1 1 5") for _ in range(3)] == ["11"] * 3
    assert board.complaints == [
        "MCEnableCapture is not supported: high-speed capture has no documented way to read what it caught"
    ]


def test_a_block_has_an_end(host: Mcapi) -> None:
    """A host that never ends its block cannot fill the memory."""
    host.BlockBegin(mc.MC_BLOCK_COMPOUND, 0)
    for _ in range(1000):
        host.Stop(1)
    with pytest.raises(McapiException) as caught:
        host.Stop(1)
    assert caught.value.code == mc.MCERR_BLOCK_MODE


def test_twenty_hosts_next_to_a_poll_that_waits(serve: Serve) -> None:
    """MCIsStopped with a time-out blocks no other client; its own answer comes last."""
    board = serve(clock="real")
    waiting, *others = [board.connect() for _ in range(20)]
    for line in (waiting, *others):
        assert line.ask("MCOpen 0 2 -") == "1"
    waiting.ask("MCEnableAxis 1 1 1")
    waiting.ask("MCMoveAbsolute 1 1 2000.0")
    waiting.send("MCIsStopped 1 1 60.0")
    moving = []
    for line in others:
        found = line.ask("MCGetStatus 1 1")
        moving.append(not int(found) >> mc.MC_STAT_TRAJ & 1)
    assert any(moving)
    assert waiting.answer() == "1"
