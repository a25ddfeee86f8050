"""Lines of a terminal: a text without line feeds costs only what it adds."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.controller.clock import Clock
from motionlang.lang.machine.terminal import LineBuffer, Terminal
from motionlang.log.log import Log

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


def test_a_display_without_line_feeds_is_linear() -> None:
    """Appending 2000 texts of 10 characters one by one would copy 20 million of them."""
    terminal = Terminal(Clock(), Log().prints)
    Fragment.copied = 0
    for _ in range(2000):
        terminal.write(Fragment("0123456789"))
    assert Fragment.copied == 0
    terminal.close()
    assert terminal.lines == ["0123456789" * 2000]
