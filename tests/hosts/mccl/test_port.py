"""The board's ASCII interface, where a session of `sessions_mccl.txt` cannot show it: limits, and inside."""

from __future__ import annotations

import cProfile
import gc

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.hosts.mccl.console import Console
from motionlang.hosts.mccl.port import Port
from motionlang.kernel import Machine, Source
from tests.cases import examples


def board(model: str = "multiflex", echo: bool | None = False) -> tuple[Console, Port]:
    """Return a console with one open port that has sent its first prompt."""
    console = Console(Machine({"controller.model": model}, first_axis=1))
    port = console.open(echo)
    port.take()
    return console, port


def ask(console: Console, port: Port, sent: bytes) -> bytes:
    """Send bytes, run the board until it has answered, and return the answer."""
    assert port.feed(sent) == len(sent)
    console.settle()
    return port.take()


def test_other_characters_wait_until_the_port_is_idle() -> None:
    console, port = board()
    port.feed(b"WA1\r")
    taken = port.feed(b"1TP," * 2000)
    assert taken == 4096


def test_too_long_a_line() -> None:
    console, port = board()
    assert ask(console, port, b"1TP," * 300 + b"\r") == b"?4\n>"
    assert ask(console, port, b"1TP\r") == b"01 0\n>"


def test_a_host_that_does_not_read_holds_the_board_up_and_not_the_memory() -> None:
    console, port = board()
    port.feed(b"HE,RP\r")
    console.run(60.0)
    assert len(port.take()) < 200_000
    assert port.busy


@settings(max_examples=examples(150))
@given(st.lists(st.binary(max_size=40), max_size=8))
def test_any_characters(sent: list[bytes]) -> None:
    console, port = board(echo=None)
    for piece in sent:
        port.feed(piece)
        console.run(console.now + 0.01)
        port.take()
    port.feed(b"\x1b\x1b")
    console.run(console.now + 1.0)
    port.feed(b"\x11\x1b")
    port.take()
    assert b"01 0" in ask(console, port, b"RT\r1TP\r") or not port.board.prompt


def test_a_port_that_waits_for_a_key_is_not_working() -> None:
    """Time does not advance while the board waits for a host."""
    console, port = board()
    ask(console, port, b"MD1,WA1,RP\r")
    ask(console, port, b"GT1\r")
    port.feed(b"\x02WA1,TR0\r")
    began = console.now
    assert console.settle()
    assert (port.busy, port.working) == (True, False)
    assert console.now < began + 0.1


def test_a_board_works_as_long_as_a_file_is_downloaded() -> None:
    console, _ = board()
    printed: list[str] = []
    console.download(Source("home.mcl", "WA0.5\n1TP\n"), printed.append, lambda _: None)
    console.run(console.now + 0.1)
    assert console.working
    assert console.settle()
    assert not console.working
    assert "".join(printed) == "01 0\n"


def test_what_background_tasks_say_to_a_host_that_does_not_read_is_lost_in_the_end() -> None:
    console, port = board()
    ask(console, port, b"MD1,HE,RP\r")
    ask(console, port, b"GT1\r")
    console.run(console.now + 0.05)
    assert 500_000 < len(port.take()) < 600_000
    console.close(port)
    console.run(console.now + 0.01)
    assert port.take() == b""


def test_an_error_of_our_own_costs_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    console, port = board()
    other = console.open(echo=False)
    other.take()
    monkeypatch.setattr("motionlang.hosts.mccl.port.PortTask.gate", lambda task: 1 / 0)
    port.feed(b"1TP\r")
    other.feed(b"1TP\r")
    with pytest.raises(ZeroDivisionError) as trouble:
        console.settle()
    monkeypatch.undo()
    console.drop_broken(trouble.value)
    assert console.settle()
    assert port.take() == b"?3\n>"
    assert other.take() == b"01 0\n>"
    assert ask(console, port, b"1TP\r") == b"01 0\n>"


@pytest.mark.parametrize(
    "lines",
    [
        [b"1TP\r", b"1MR5,1WS\r", b"1TP\r"],
        [b"1T", b"P\r", b"\n", b"1TP\r\n", b"\r"],
        [b"1TP\r2TP\r", b"1TP\x08\x08\x08TR0\r", b"\x1b1TP\r"],
        [b"XF65,XN66\r", b"1TP,NA\r", b"B1TP\r"],
        [b"XF0\r", b"1TP\r", b"EN\r", b"1TP\r"],
        [b"1TP," * 100 + b"\r", b"\t1TP\r", "1TP\N{DEGREE SIGN}\r".encode("latin-1")],
        [b"1MR100000,1WS0\r", b"1TP\r", b" 1TP\r"],
    ],
)
@pytest.mark.parametrize("echo", [True, False])
def test_a_line_at_once_is_the_same_as_its_characters(lines: list[bytes], echo: bool) -> None:
    whole, single = board(echo=echo), board(echo=echo)
    for line in lines:
        for code in line:
            assert single[1].feed(bytes([code])) == 1
        single[0].settle()
        assert ask(*whole, line) == single[1].take()
        assert whole[0].now == single[0].now


def test_a_longer_line_takes_no_more_calls() -> None:
    """With a function call per character, 20 more would take 60 calls."""
    console, port = board()

    def calls(sent: bytes) -> int:
        profile = cProfile.Profile()
        ask(console, port, sent)
        gc.disable()  # whose calls would count
        try:
            profile.runcall(ask, console, port, sent)
        finally:
            gc.enable()
        return sum(entry.callcount for entry in profile.getstats())

    assert calls(b"NO" + b" " * 20 + b"\r") < calls(b"NO \r") + 10


def test_the_wait_between_two_lines_has_no_line() -> None:
    console, port = board()
    ask(console, port, b"MD5,1TP\r")
    for sent in (b"MC5\r", b"1WA0.1\r", b"1ZZ\r"):
        ask(console, port, sent)
        wait = port.task.wait
        assert wait is not None
        assert wait.cause == "host"
        assert port.task.stack == (0,)


def test_entries_end_with_a_carriage_return_or_a_line_feed() -> None:
    """A line feed behind a carriage return ends nothing."""
    _, port = board()
    assert port.next_piece(bytearray(b"1TP\r2TP\r"), True) == (b"1TP\r", True)
    assert port.next_piece(bytearray(b"\n2TP\r"), True) == (b"\n", False)
    assert port.next_piece(bytearray(b"2TP\n\n"), True) == (b"2TP\n", True)
    assert port.next_piece(bytearray(b"\n"), True) == (b"\n", True)
    assert port.next_piece(bytearray(b"\r"), True) == (b"\r", True)
    assert port.next_piece(bytearray(b"1T"), True) == (b"1T", False)
    assert port.next_piece(bytearray(b"\n"), True) == (b"\n", True)
    assert port.next_piece(bytearray(b""), True) == (b"", False)
    assert port.next_piece(bytearray(b"1TP\r"), True) == (b"1TP\r", True)
    assert port.next_piece(bytearray(b"2\nTP\r"), True) == (b"2\n", True)


def test_what_a_busy_port_accepts() -> None:
    """ESC, and at the beginning the control characters and blanks.

    One key while it single-steps.
    """
    console, port = board()
    assert port.accepts(b"1TP\r")
    waiting = bytearray(b"1TP\r\x1b2TP\r\x1b3TP\r")
    port.next_piece(waiting, True)
    assert waiting == b"1TP\r\x1b2TP\r\x1b3TP\r"
    port.feed(b"WA9\r")
    console.run(1.0)
    assert not port.accepts(b"1TP\r")
    assert port.accepts(b"1TP\r\x1b")
    port.next_piece(waiting, True)
    assert waiting == b"\x1b3TP\r"
    del waiting[0]
    port.next_piece(waiting, True)
    assert waiting == b"3TP\r"
    assert port.next_piece(bytearray(b"\x02\x11\x13 1TP\r"), True) == (b"\x02\x11\x13 ", False)
    assert port.next_piece(bytearray(b"1 "), True) == (b"", False)
    assert port.next_piece(bytearray(b"  "), True) == (b"  ", False)
    assert port.next_piece(bytearray(b"\x1b\x1b"), True) == (b"\x1b", False)
    port.feed(b"\x02")
    assert port.next_piece(bytearray(b"xy"), True) == (b"x", False)


def test_unread_output_suspends_the_port_from_65536_characters_on() -> None:
    _, port = board()
    port.send("x" * 65535)
    assert not port.full
    port.send("x")
    assert port.full
    port.take()
    assert not port.full


def test_output_is_lost_from_half_a_million_characters_on() -> None:
    _, port = board()
    port.send("x" * (8 * 65536 - 1))
    port.send("yz")
    port.send("lost")
    assert port.take()[-3:] == b"xyz"


def test_a_line_of_4096_characters_waits_and_no_more() -> None:
    console, port = board()
    port.feed(b"WA1\r")
    assert port.feed(b"x" * 4095) == 4095
    assert port.feed(b"xyz") == 1
    assert port.feed(b"\x1b") == 1
    assert port.feed(b"1TP\r") == 4
    console.settle()
    assert port.take().endswith(b"?-7\n>01 0\n>")


def test_a_blank_before_a_line_does_not_pause_an_idle_port() -> None:
    console, port = board()
    assert ask(console, port, b" 1TP\r") == b"01 0\n>"
    assert not port.task.paused
