"""What a stream can show: colours, width, and the cells that a text takes up."""

from __future__ import annotations

import os

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TextIO

WIDTH = 100
# SGR numbers of the few styles that plain text output uses.
_STYLES = {
    "error": "1;31",
    "warning": "1;33",
    "note": "1;36",
    "place": "34",
    "bold": "1",
    "dim": "2",
    "word": "36",
    "chart": "32",
    "accel": "32",
    "slew": "34",
    "decel": "33",
    "stop": "31",
}


def wants_colour(stream: TextIO) -> bool:
    """Whether to colour what is written to `stream`: NO_COLOR, FORCE_COLOR, TERM and whether a person sees it."""
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return os.environ.get("TERM") != "dumb" and is_terminal(stream)


def is_terminal(stream: TextIO) -> bool:
    """Whether a person reads what is written to `stream`; False for one that is closed."""
    try:
        return stream.isatty()
    except ValueError:
        return False


def draws(stream: TextIO) -> bool:
    """Whether the encoding of `stream` has lines and braille dots in it."""
    return (getattr(stream, "encoding", None) or "").lower().replace("-", "").startswith("utf")


def width_of(stream: TextIO) -> int:
    """The columns of the terminal behind `stream`; `COLUMNS`, or 100, where there is none."""
    named = os.environ.get("COLUMNS", "")
    if named.isdigit() and int(named) > 0:
        return int(named)
    try:
        return os.get_terminal_size(stream.fileno()).columns or WIDTH
    except (OSError, ValueError, AttributeError):
        return WIDTH


def styled(text: str, style: str, colour: bool) -> str:
    """`text` in one of the styles; as it is without colour, or where there is no such style."""
    return f"\x1b[{_STYLES[style]}m{text}\x1b[0m" if colour and text and style in _STYLES else text


def cells(text: str) -> int:
    """How many columns `text` takes up on a terminal."""
    return len(text) if text.isascii() else sum(map(_cells_of, text))


def printable(text: str) -> str:
    """`text` with every character that a terminal would obey, or hide, shown as a picture of itself."""
    return text if text.isascii() and text.isprintable() else "".join(map(_picture, text))


def plain(text: str) -> str:
    """`text` for an encoding that has no lines to draw with."""
    return text.translate(_ASCII)


_ASCII = str.maketrans({"─": "-", "│": "|", "├": "|", "└": "`", "·": "-", "…": "...", "²": "2"})


def _cells_of(character: str) -> int:
    from unicodedata import category, east_asian_width

    if category(character) in ("Mn", "Me", "Cf"):
        return 0
    return 2 if east_asian_width(character) in ("W", "F") else 1


def _picture(character: str) -> str:
    if character.isprintable():
        return character
    code = ord(character)
    if code < 0x20:
        return chr(0x2400 + code)
    return "\u2421" if code == 0x7F else "\ufffd"
