"""HCP frames: bytes computed by hand, and everything that NAK answers."""

from __future__ import annotations

import random

import pytest

from tests.cases import cases
from tests.hosts.mint.lines import Line, answer_frame, read_frame, write_frame

ACK, NAK = "\x06", "\x15"


def test_a_write_frame_byte_by_byte() -> None:
    """The checksum of 0, 5, 1, 2, ETX is 0x30 ^ 0x35 ^ 0x31 ^ 0x32 ^ 0x03 = 0x05."""
    assert write_frame(5, "12") == b"\x0400\x020512\x03\x05"


def test_a_read_frame_and_its_answer_byte_by_byte() -> None:
    """The checksum of 0, 5, 7, ETX is 0x30 ^ 0x35 ^ 0x37 ^ 0x03 = 0x31."""
    assert read_frame(5) == b"\x0400\x0205\x05"
    assert answer_frame(5, "7") == b"\x02057\x031"


def test_an_element_that_is_written_can_be_read() -> None:
    line = Line()
    assert line.ask(write_frame(1, "2.5")) == ACK
    assert line.ask(read_frame(1)) == answer_frame(1, "2.5000").decode()
    assert line.ask(write_frame(99, "   -7 ")) == ACK  # blanks, as Pascal pads numbers
    assert line.ask(read_frame(99)) == answer_frame(99, "-7.0000").decode()
    assert line.ask(write_frame(99, "2" + " " * 39)) == ACK  # the longest text
    assert line.ask(read_frame(99)) == answer_frame(99, "2.0000").decode()


@cases("text, value", [("1.", "1.0000"), (".5", "0.5000"), ("+2e2", "200.0000"), ("e5", None), (".", None)])
def test_the_forms_of_a_number(text: str, value: str | None) -> None:
    line = Line()
    assert line.ask(write_frame(1, text)) == (NAK if value is None else ACK)
    assert line.ask(read_frame(1)) == answer_frame(1, value or "0.0000").decode()


@pytest.mark.parametrize("frame", [write_frame(1, "2.5"), read_frame(1)], ids=["write", "read"])
def test_a_frame_that_comes_byte_by_byte_is_answered_at_its_end(frame: bytes) -> None:
    line = Line()
    answers = [line.ask(frame[k : k + 1]) for k in range(len(frame))]
    assert answers == [""] * (len(frame) - 1) + [Line().ask(frame)]


@pytest.mark.parametrize(
    "frame",
    [
        write_frame(1, "2.5")[:-1] + b"!",  # a wrong sum
        write_frame(0, "1"),
        read_frame(0),
        write_frame(1, "two"),
        write_frame(1, ""),
        write_frame(1, "1,2"),
        write_frame(1, "nan"),
        write_frame(1, "1_0"),
        write_frame(1, "3.4028235678e38"),  # no 32-bit number
        write_frame(1, "0" * 41),
        write_frame(1, "0" * 1000),
        b"\x0400\x02A1\x05",
        b"\x0400\x02\x03\x03",
        b"\x0400\x0201\r",
        b"\x0400\x020\r",
        b"\x0400\x02\r",
    ],
)
def test_what_is_no_write_and_no_read_is_answered_with_nak(frame: bytes) -> None:
    line = Line()
    assert line.ask(frame) == NAK
    assert line.ask(read_frame(1)) == answer_frame(1, "0.0000").decode()


def test_frames_for_another_card_get_no_answer_and_change_nothing() -> None:
    line = Line()
    assert line.ask(write_frame(1, "5", card=3) + read_frame(1, card=12)) == ""
    assert line.ask(read_frame(1)) == answer_frame(1, "0.0000").decode()


def test_a_frame_that_is_cut_off_does_not_swallow_the_next_one() -> None:
    line = Line()
    assert line.ask(b"\x0400\x020112" + write_frame(2, "3")) == ACK
    assert line.ask(b"\x0400" + b"Print 6 * 7\r") == "42\nP>"
    assert line.ask(b"\x0400\x020112\x05") == "Break\nP>"


def test_any_bytes_leave_a_line_that_works() -> None:
    random_bytes = random.Random(33)
    line = Line("Loop\n  Wait = 1\nEnd Loop")
    for _ in range(300):
        line.send(random_bytes.randbytes(40))
        line.run(0.001)
    line.send(b"\r\x04\x05")
    assert line.ask(b"\x05").endswith("Break\nP>")
    assert line.ask(b"Print 1 + 1\r") == "2\nP>"


@cases(
    "data, length",
    [
        (b"\x04", 0),
        (b"\x0400\x02", 0),
        (b"\x0400\x0201", 0),
        (b"\x0400\x020112", 0),
        (b"\x0400\x0201 7", 0),
        (b"\x0400\x05", 4),
        (b"\x0400\x0201\x05", 7),
        (b"\x0400\x0201\x05P", 7),
        (b"\x0400\x02012\x03", 0),
        (b"\x0400\x02012\x03\x31", 9),
        (b"\x0400\x02012\x03\x31P", 9),
        (b"\x0400\x0201\r", 0),
        (b"\x0400\x0201\rP", 8),
    ],
)
def test_the_first_entry_of_what_a_host_sends_is_a_frame(data: bytes, length: int) -> None:
    """A read ends with ENQ; a write ends with the checksum that follows ETX.

    Any other control character ends a frame like ETX.
    """
    entry = Line().port.next_piece(bytearray(data), True)
    assert entry == ((data[:length], True) if length else (data, False))
