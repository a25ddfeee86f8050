"""Lines of a terminal: a text without line feeds costs only what it adds."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller import Clock
from motionlang.kernel.lang import Terminal
from motionlang.kernel.lang.machine.terminal import LineBuffer
from motionlang.kernel.log import Log

if TYPE_CHECKING:
    from typing import Self


class Fragment(str):
    """A text that counts the characters copied when it is appended to another text."""

    __slots__ = ()
    copied = 0

    def __radd__(self, before: str) -> Self:
        Fragment.copied += len(before) + len(self)
        return type(self)(f"{before}{self}")


def test_fragments_are_split_at_line_feeds() -> None:
    buffer = LineBuffer()
    assert buffer.completed("a") == []
    assert buffer.completed("b\n\nc") == ["ab", ""]
    assert (buffer.unfinished, len(buffer)) == ("c", 1)
    assert buffer.completed("\n") == ["c"]
    assert (buffer.unfinished, len(buffer)) == ("", 0)


def test_a_row_that_shows_a_text_is_not_written_again() -> None:
    shown: list[str] = []
    terminal = Terminal(Clock(), Log().prints, shown.append)
    written = [
        terminal.write_on_row(row, text) for row, text in [(1, "a"), (2, "b"), (1, "a"), (2, "b"), (2, "c")]
    ]
    assert written == [True, True, False, False, True]
    assert shown == ["\x1b[1;1Ha", "\x1b[2;1Hb", "\x1b[2;1Hc"]


def test_print_continues_where_the_cursor_of_the_last_row_is() -> None:
    """A row's text that was not shown again is written before the next text.

    After that, no row is known to be on the screen.
    """
    shown: list[str] = []
    terminal = Terminal(Clock(), Log().prints, shown.append)
    for row, text in [(1, "a"), (2, "b"), (1, "a")]:
        terminal.write_on_row(row, text)
    terminal.write("!\n")
    assert shown[2:] == ["\x1b[1;1Ha!\n"]
    assert terminal.write_on_row(2, "b")
    terminal.aside("[terminal 2] here\n")
    assert terminal.write_on_row(2, "b")


def test_a_text_that_may_reach_other_rows_is_always_written() -> None:
    terminal = Terminal(Clock(), Log().prints)
    for row, text in [(1, "a" * 81), (25, "a"), (1, "a\nb"), (1, "\x1b[2J")]:
        assert terminal.write_on_row(row, text)
        assert terminal.write_on_row(row, text)
    assert (terminal.write_on_row(0, "a"), terminal.write_on_row(1, "a")) == (True, False)


def test_hosts_see_every_text() -> None:
    terminal = Terminal(Clock(), Log().prints)
    terminal.repeats = True
    assert terminal.write_on_row(1, "a")
    assert terminal.write_on_row(1, "a")


def test_a_display_without_line_feeds_is_linear() -> None:
    """Appending 2000 texts of 10 characters one by one would copy 20 million of them."""
    terminal = Terminal(Clock(), Log().prints)
    Fragment.copied = 0
    for _ in range(2000):
        terminal.write(Fragment("0123456789"))
    assert Fragment.copied == 0
    terminal.close()
    assert terminal.lines == ["0123456789" * 2000]
