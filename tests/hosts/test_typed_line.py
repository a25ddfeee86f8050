"""Characters typed at a terminal: their echo, and the line they make."""

from __future__ import annotations

from motionlang.hosts.typed_line import TypedLine
from tests.cases import cases


@cases(
    "typed, echo, line",
    [
        ("JOG", "JOG", ("JOG", 0)),
        ("JOGGED", "JOGGED", ("JOGG", 2)),
        ("JO\bX", "JO\b \bX", ("JX", 0)),
        ("JO\x7fX", "JO\b \bX", ("JX", 0)),
        ("\bX", "X", ("X", 0)),
        ("J\tX", "J\tX", ("J\tX", 0)),
        ("J\x07 \x1fX", "J X", ("J X", 0)),
        ("J\r\n", "J\n", ("J", 0)),
        ("J\n\n", "J\n\n", ("J", 0)),
        ("J\rX\n", "J\nX\n", ("JX", 0)),
    ],
)
def test_the_echo_and_the_line(typed: str, echo: str, line: tuple[str, int]) -> None:
    """The line has room for 4 characters; an LF behind a CR ends no second line."""
    terminal = TypedLine(4)
    assert "".join(terminal.type(ord(each)) for each in typed) == echo
    assert terminal.take() == line
    assert terminal.take() == ("", 0)


@cases(
    "line, taken",
    [
        (b"OG\r", True),
        (b"OGG\r", True),
        (b"OGGS\r", False),
        (b"OG", False),
        (b"O\tG\r", False),
        (b"\r", True),
    ],
)
def test_a_whole_line_at_once(line: bytes, taken: bool) -> None:
    """One character has been typed, and there is room for 4."""
    terminal = TypedLine(4)
    terminal.type(ord("J"))
    assert terminal.enter(line) is taken
    assert terminal.after_cr is taken
    assert terminal.take() == ("J" + line.decode()[:-1] if taken else "J", 0)
