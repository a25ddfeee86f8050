"""Output of a server never blocks: excess text is dropped and counted."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import TextIO

import pytest

from motionlang.hosts.commands import output_queue
from motionlang.hosts.commands.output_queue import CAPACITY, OutputQueue, dropped, never_waiting

LINE = "x" * 99 + "\n"


class Pipe:
    """A pipe with an output queue in front of it, and its reading end."""

    def __init__(self) -> None:
        read, write = os.pipe()
        self.reader = os.fdopen(read, encoding="utf-8")
        self.writer = os.fdopen(write, "w", encoding="utf-8")
        self.queue = OutputQueue(self.writer, "standard error")

    def fill(self) -> int:
        """Write numbered lines until one is dropped; return the number written before."""
        for number in range(10 * CAPACITY):
            self.queue.write(f"{number}\n")
            if self.queue.dropped:
                return number
        raise AssertionError("nothing was dropped")

    def close(self) -> None:
        self.reader.close()
        self.queue.close()
        self.writer.close()


@pytest.fixture
def pipe() -> Iterator[Pipe]:
    made = Pipe()
    yield made
    made.close()


def test_lines_come_in_order(pipe: Pipe) -> None:
    for number in range(3):
        pipe.queue.write(f"{number}\n")
    assert [pipe.reader.readline() for _ in range(3)] == ["0\n", "1\n", "2\n"]


def test_a_gap_is_reported_where_it_is(pipe: Pipe) -> None:
    """Without a reader, only `CAPACITY` and the pipe's buffer are stored."""
    written = pipe.fill()
    for number in range(7):  # there may be space for some by now, but the gap continues until it is reported
        pipe.queue.write(f"lost {number}\n")
    assert pipe.queue.dropped == 8
    assert [pipe.reader.readline() for _ in range(written)] == [f"{number}\n" for number in range(written)]
    note = "motionlang: 8 lines of standard error dropped, because it was not read\n"
    assert pipe.reader.readline() == note
    pipe.queue.write("there is room again\n")
    assert pipe.reader.readline() == "there is room again\n"
    assert dropped([pipe.queue]) == "; 8 lines of standard error dropped"


def test_a_gap_in_the_output_is_reported_on_standard_error() -> None:
    notes, out = Pipe(), Pipe()
    out.queue = OutputQueue(out.writer, "standard output", notes.queue)
    try:
        written = out.fill()
        for _ in range(written):
            out.reader.readline()
        assert (
            notes.reader.readline()
            == "motionlang: 1 line of standard output dropped, because it was not read\n"
        )
        out.queue.write("next\n")
        assert out.reader.readline() == "next\n"
    finally:
        out.close()
        notes.close()


def test_the_end_does_not_wait_for_a_reader(pipe: Pipe, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(output_queue, "FAREWELL", 0.0)
    pipe.fill()
    pipe.queue.close()


def test_a_reader_that_has_gone_is_no_error(pipe: Pipe) -> None:
    pipe.reader.close()
    for _ in range(2 * CAPACITY // len(LINE)):
        pipe.queue.write(LINE)
    pipe.queue.close()


def test_files_are_written_to_directly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, pipe: Pipe) -> None:
    """No line for a regular file may be lost, and writing to a file does not block."""
    with open(tmp_path / "out.txt", "w", encoding="utf-8") as file:
        monkeypatch.setattr("sys.stdout", file)
        monkeypatch.setattr("sys.stderr", pipe.writer)
        with never_waiting() as queues:
            import sys

            replaced: tuple[TextIO, TextIO] = sys.stdout, sys.stderr
            assert replaced[0] is file
            assert [queue.name for queue in queues] == ["standard error"]
            replaced[1].write("here\n")
        assert (sys.stdout, sys.stderr) == (file, pipe.writer)
    assert pipe.reader.readline() == "here\n"


def test_a_letter_that_the_encoding_lacks_is_shown_by_its_number() -> None:
    read, write = os.pipe()
    with (
        os.fdopen(read) as reader,
        os.fdopen(write, "w", encoding="ascii", errors="backslashreplace") as writer,
    ):
        queue = OutputQueue(writer, "standard error")
        queue.write("5 µm\n")
        assert re.fullmatch(r"5 \\xb5m\n", reader.readline())
