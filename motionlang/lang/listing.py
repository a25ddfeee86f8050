"""The generated code of a program, as lines to read."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.record import record

# The line of the program, 0 for none; its code; a remark on the code, "" for none.
CodeLine = tuple[int, str, str]


@record
class Listing:
    """The generated code: `head` explains the `lines`; `is_python` if they are Python."""

    head: str
    lines: Sequence[CodeLine]
    is_python: bool
