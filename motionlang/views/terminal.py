"""What a stream can show: colours, width, and the cells that a text takes up."""

from __future__ import annotations

import os

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import TextIO

WIDTH = 100
PIPED_WIDTH = 160
# What the views' few names of styles mean to rich.
STYLES = {
    "error": "bold red",
    "warning": "bold yellow",
    "note": "bold cyan",
    "place": "blue",
    "bold": "bold",
    "dim": "dim",
    "word": "cyan",
    "chart": "green",
    "accel": "green",
    "slew": "blue",
    "decel": "yellow",
    "stop": "red",
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


def table_width(stream: TextIO) -> int:
    """The columns that a table may have: those of the terminal; through a pipe so many that none is left out."""
    return width_of(stream) if is_terminal(stream) else PIPED_WIDTH


def styled(text: str, style: str, colour: bool) -> str:
    """`text` in one of the styles; as it is without colour, or where there is no such style."""
    if not (colour and text and style in STYLES):
        return text
    from rich.color import ColorSystem
    from rich.style import Style

    return Style.parse(STYLES[style]).render(text, color_system=ColorSystem.STANDARD)


def cells(text: str) -> int:
    """How many columns `text` takes up on a terminal."""
    if text.translate(_ASCII).isascii():
        return len(text)
    from rich.cells import cell_len

    return cell_len(text)


def printable(text: str) -> str:
    """`text` with every character that a terminal would obey, or hide, shown as a picture of itself."""
    return text if text.isascii() and text.isprintable() else "".join(map(_picture, text))


def shower(stream: TextIO) -> Callable[[str], object]:
    """What writes a program's output to `stream`: on a terminal harmless, into a file or a pipe as it is."""
    if not is_terminal(stream):
        return stream.write
    return lambda text: stream.write(harmless(text))


def harmless(text: str) -> str:
    """A program's output without the power over a terminal that escape sequences have, each as a picture of itself.

    What Mint's CLS and LOCATE write is obeyed, and so are the bell, backspace, tabulator and carriage return.
    """
    if text.isascii() and text.isprintable():
        return text
    from re import sub

    return sub(_POWERS, lambda found: _picture(found[0]), text)


def plain(text: str) -> str:
    """`text` for an encoding that has no lines to draw with."""
    return text.translate(_ASCII)


# Control characters of seven and of eight bits; of the sequences only those that clear the screen or place the cursor.
_POWERS = r"\x1b(?!\[(?:2J|H|\d+;\d+H))|[\x00-\x06\x0b\x0c\x0e-\x1a\x1c-\x1f\x7f-\x9f]"
_ASCII = str.maketrans({"─": "-", "│": "|", "├": "|", "└": "`", "·": "-", "…": "...", "²": "2"})


def _picture(character: str) -> str:
    if character.isprintable():
        return character
    code = ord(character)
    if code < 0x20:
        return chr(0x2400 + code)
    return "\u2421" if code == 0x7F else "\ufffd"
