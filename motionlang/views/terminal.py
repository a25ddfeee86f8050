"""Capabilities of an output stream: colours, width, and the cells of a text."""

from __future__ import annotations

import os
from collections.abc import Callable
from re import split, sub
from typing import TextIO

WIDTH = 100
PIPED_WIDTH = 160
# The styles of the views, as rich names them.
STYLES = {
    "error": "bold red",
    "warning": "bold yellow",
    "note": "bold cyan",
    "location": "blue",
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
    """True if output to `stream` should be coloured.

    This depends on NO_COLOR, FORCE_COLOR, TERM, and whether it is a terminal.
    """
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return os.environ.get("TERM") != "dumb" and is_terminal(stream)


def is_terminal(stream: TextIO) -> bool:
    """True if `stream` is a terminal; False if it is closed."""
    try:
        return stream.isatty()
    except ValueError:
        return False


def draws(stream: TextIO) -> bool:
    """True if the encoding of `stream` has line-drawing characters and braille dots."""
    return (getattr(stream, "encoding", None) or "").lower().replace("-", "").startswith("utf")


def width_of(stream: TextIO) -> int:
    """Return the number of columns of the terminal behind `stream`.

    Without a terminal this is `COLUMNS`, or 100.
    """
    named = os.environ.get("COLUMNS", "")
    if named.isdigit() and int(named) > 0:
        return int(named)
    try:
        return os.get_terminal_size(stream.fileno()).columns or WIDTH
    except (OSError, ValueError, AttributeError):
        return WIDTH


def table_width(stream: TextIO) -> int:
    """Return the number of columns for a table.

    This is the width of the terminal, and in a pipe enough for all columns.
    """
    return width_of(stream) if is_terminal(stream) else PIPED_WIDTH


def styled(text: str, style: str, colour: bool) -> str:
    """Return `text` in one of the styles.

    Without colour, or for an unknown style, the text is unchanged.
    """
    if not (colour and text and style in STYLES):
        return text
    from rich.color import ColorSystem
    from rich.style import Style

    return Style.parse(STYLES[style]).render(text, color_system=ColorSystem.STANDARD)


def cells(text: str) -> int:
    """Return the number of columns that `text` takes up on a terminal."""
    if text.translate(_ASCII).isascii():
        return len(text)
    from rich.cells import cell_len

    return cell_len(text)


def printable(text: str) -> str:
    """Return `text` with control and invisible characters replaced by their pictures."""
    return text if text.isascii() and text.isprintable() else "".join(map(_picture, text))


def shower(stream: TextIO) -> Callable[[str], object]:
    """Return the function that writes a program's output to `stream`.

    On a terminal the output is made harmless. A file or a pipe has no screen: the sequences of CLS and LOCATE end a
    begun line there.
    """
    if is_terminal(stream):
        return lambda text: stream.write(harmless(text))
    is_begun = has_moved = False

    def write(text: str) -> None:
        nonlocal is_begun, has_moved
        for number, part in enumerate(_between_screens(text) if "\x1b" in text else [text]):
            has_moved = has_moved or number > 0
            if part:
                stream.write(f"\n{part}" if has_moved and is_begun else part)
                is_begun, has_moved = not part.endswith("\n"), False

    return write


def _between_screens(text: str) -> list[str]:
    return split(_SCREEN, text)


def harmless(text: str) -> str:
    """Return a program's output with unsafe escape sequences replaced by pictures.

    The sequences of Mint's CLS and LOCATE are preserved, and so are bell, backspace, tab and carriage return.
    """
    if text.isascii() and text.isprintable():
        return text

    return sub(_POWERS, lambda found: _picture(found[0]), text)


def plain(text: str) -> str:
    """Return `text` for an encoding without line-drawing characters."""
    return text.translate(_ASCII)


# The sequences of CLS and LOCATE.
_SCREEN = r"\x1b\[(?:2J|H|\d+;\d+H)"
# Control characters of seven and eight bits, and all escape sequences except those that clear the screen or
# position the cursor.
_POWERS = r"\x1b(?!\[(?:2J|H|\d+;\d+H))|[\x00-\x06\x0b\x0c\x0e-\x1a\x1c-\x1f\x7f-\x9f]"
_ASCII = str.maketrans({"─": "-", "│": "|", "├": "|", "└": "`", "·": "-", "…": "...", "²": "2", "→": "->"})


def _picture(character: str) -> str:
    if character.isprintable():
        return character
    code = ord(character)
    if code < 0x20:
        return chr(0x2400 + code)
    return "\u2421" if code == 0x7F else "\ufffd"
