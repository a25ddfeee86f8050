"""What a program is turned into, as lines to read."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    # The line of the program, 0 for none; the code that it became; a remark on the code, "" for none.
    CodeLine = tuple[int, str, str]


class Listing:
    """`head` explains the `lines`; `is_python` states whether the code in them is Python."""

    __slots__ = ("head", "is_python", "lines")

    def __init__(self, head: str, lines: Sequence[CodeLine], *, is_python: bool) -> None:
        self.head, self.lines, self.is_python = head, lines, is_python
