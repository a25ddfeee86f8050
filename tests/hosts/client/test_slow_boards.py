"""Answers of a slow board, which arrive in pieces and late."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from motionlang.client import Client, NoReply

VERSION = b"\nMultiFlex PCI 1000 series\n>"
VERSION_WITHOUT_PROMPT = b"DCX-PC100\r\n"

# Seconds after which a piece arrives, counted from the previous one, or from the line that it answers; and the piece.
Pieces = list[tuple[float, bytes]]


class ScriptedWire:
    """A line whose board answers each `send` with its next pieces, in simulated time."""

    fresh = True

    def __init__(self, *answers: Pieces) -> None:
        self._answers: Iterator[Pieces] = iter(answers)
        self._pieces: Pieces = []
        self._now = self._last = 0.0

    def send(self, data: bytes) -> None:
        pieces = next(self._answers)
        if not self._pieces:
            self._last = self._now
        self._pieces += pieces

    def receive(self, timeout: float) -> bytes:
        due = self._last + self._pieces[0][0] if self._pieces else float("inf")
        if due > self._now + timeout:
            self._now += max(0.0, timeout)
            return b""
        self._now = max(self._now, due)
        self._last = due
        return self._pieces.pop(0)[1]

    def now(self) -> float:
        return self._now

    def close(self) -> None:
        pass


def noise(seconds: float, end: bytes = b"\n") -> Pieces:
    """Return the lines of a background task that prints each 10 ms."""
    return [(0.01, b"02 0" + end)] * round(100 * seconds)


def test_a_line_that_arrives_in_pieces() -> None:
    """The first half of `02 0` arrives before the next line is sent.

    It is one line of output.
    """
    wire = ScriptedWire(
        [(0.0, VERSION)], [(0.0, b"\n>02 0\n02"), (0.1, b" 0\n01 "), (0.1, b"0\n"), (0.1, b">")]
    )
    board = Client(wire)
    assert board.send("1MN") == []
    wire._answers = iter([[]])
    assert board.send("1TP") == ["02 0", "01 0"]
    assert list(board.unasked) == ["02 0"]


def test_the_answer_to_an_escape_arrives_late() -> None:
    """The board answers ESC after 2 s.

    That is longer than the output of a background task is drained.
    """
    wire = ScriptedWire(
        [(0.0, VERSION)],
        noise(0.3),
        [*noise(2.0), (0.0, b"?-7\n>")],
        [*noise(0.1), (0.0, b"01 0\n>")],
    )
    board = Client(wire)
    with pytest.raises(NoReply):
        board.send("WN40", timeout=0.2)
    assert board.send("1TP")[-1] == "01 0"


@pytest.mark.parametrize("late", [b"?-7\r\n", b"\r\n"], ids=["busy", "idle"])
def test_a_late_answer_without_a_prompt(late: bytes) -> None:
    """A board without a prompt answers ESC with `?-7`.

    If it was idle, it sends an empty line.
    """
    wire = ScriptedWire(
        [(0.0, VERSION_WITHOUT_PROMPT)],
        [(0.0, b"")],
        [*noise(2.0, b"\r\n"), (0.0, late)],
        [(0.0, b"01 0\r\n")],
    )
    board = Client(wire)
    assert not board.prompts
    with pytest.raises(NoReply):
        board.send("WN40", timeout=0.2)
    assert board.send("1TP") == ["01 0"]


def test_a_board_that_does_not_answer_an_escape() -> None:
    """The client waits for its time-out once, and then for silence."""
    wire = ScriptedWire([(0.0, VERSION)], [])
    board = Client(wire, timeout=5.0)
    board.escape()
    assert wire.now() == pytest.approx(5.05)
