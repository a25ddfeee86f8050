"""The generated code of a program, as lines to read."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    # The line of the program, 0 for none; its code; a remark on the code, "" for none.
    CodeLine = tuple[int, str, str]


class Listing:
    """The generated code: `head` explains the `lines`; `is_python` if they are Python."""

    __slots__ = ("head", "is_python", "lines")

    def __init__(self, head: str, lines: Sequence[CodeLine], *, is_python: bool) -> None:
        self.head, self.lines, self.is_python = head, lines, is_python
