"""No input ends the server or uses unlimited resources, nor does a silent host."""

from __future__ import annotations

import random
import socket
import sys

import pytest

from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import Limits
from motionlang.kernel import Machine
from motionlang.kernel.mccl import table
from tests.hosts.serve.conftest import Board, Serve


@pytest.fixture(params=["lockstep", "real"])
def board(request: pytest.FixtureRequest, serve: Serve) -> Board:
    return serve(clock=request.param)


def test_a_line_whose_host_is_gone_has_ten_seconds(serve: Serve) -> None:
    """Here it has 0.05 s: a closed connection soon frees its slot and the board."""
    board = serve(clock="real", limits=Limits(linger=0.05))
    first, second = board.connect(), board.connect()
    first.send(b"AL@20,AA1,AR20,RP\r")
    first.socket.shutdown(socket.SHUT_WR)
    assert first.all() == b""
    counted = second.ask(b"TR20")
    assert second.ask(b"WA0.02,TR20") == counted


def test_a_host_that_never_reads_holds_up_only_itself(serve: Serve) -> None:
    board = serve(clock="real", limits=Limits(outbox=4096))
    first, second = board.connect(), board.connect()
    first.send(b"HE,RP\r")
    for _ in range(200):
        second.ask(b"1TP")
    host = board.server.hosts[0]
    assert len(host._outbox) < 200_000
    assert first.until(b"\n")
    assert second.ask(b"1TP") == b"01 0\n>"


def test_a_host_that_sends_without_end_is_read_no_further(serve: Serve) -> None:
    board = serve(limits=Limits(inbox=8192, chunk=4096))
    first, second = board.connect(), board.connect()
    first.socket.settimeout(0.2)
    with pytest.raises(TimeoutError):
        first.send(b"WN40\r" + b"1TP\r" * 10_000_000)
    assert second.ask(b"1TP") == b"01 0\n>"
    assert len(board.server.hosts[0]._inbox) <= 8192 + 4096


def test_programs_without_end_do_not_keep_others_waiting(board: Board) -> None:
    """Foreground and background loops, with the maximum number of tasks of the board."""
    board.connect().send(b"AA1,RP\r")
    assert board.connect().ask(b"MD1,AA1,RP") == b"\n>"
    other = board.connect()
    answers = other.ask(b"GT1," * 40 + b"TE")
    assert answers == b"?-1\n>"
    for _ in range(20):
        assert other.ask(b"1TP") == b"01 0\n>"
    assert other.ask(b"RT") == b"\n>"


def test_no_command_reaches_the_file_system() -> None:
    """No command, plain or with a text, opens, creates or removes a file."""
    console = Console(Machine(first_axis=1))
    port = console.open(echo=False)
    lines = [row.example for row in table()] + [f'{row.name}"../../etc/passwd"' for row in table()]
    watched = ("open", "os.", "subprocess.", "shutil.", "socket.", "import", "exec", "compile")
    seen: list[tuple[str, object]] = []
    watching = False

    def audit(event: str, arguments: tuple[object, ...]) -> None:
        if watching and event.startswith(watched):
            seen.append((event, arguments))

    sys.addaudithook(audit)
    for again in (False, True):  # the first round imports the commands' modules
        watching = again
        answered = 0
        for line in lines:
            port.feed(line.encode() + b"\r")
            console.settle(console.now + 100.0)
            answered += not port.busy
            port.feed(b"\x1b")
        assert answered > len(lines) * 0.9
    watching = False
    assert seen == []


@pytest.mark.parametrize("seed", range(4))
def test_hosts_at_random(board: Board, seed: int) -> None:
    """Partial lines, control characters, noise, broken connections."""
    rng = random.Random(seed)
    pieces = [row.example.encode() for row in table()]
    pieces += [
        b"\r",
        b"\r\n",
        b"\x1b",
        b" ",
        b"\x02",
        b"\x13",
        b"\x11",
        b"\x08",
        b",",
        b"@",
        b'"',
        b"RP\r",
        b"GT1\r",
    ]
    for _ in range(12):
        wire = board.connect()
        for _ in range(rng.randrange(1, 30)):
            wire.send(rng.choice(pieces) if rng.random() < 0.9 else rng.randbytes(3))
        if rng.random() < 0.5:
            wire.break_off()
    last = board.connect()
    last.send(b"\x1bRT\rEF\r\x1b")
    assert b"?" not in last.ask(b"TE") or last.ask(b"1TP")
    assert board.complaints == []
