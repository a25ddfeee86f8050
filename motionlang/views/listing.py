"""A listing: the lines of a program, each followed by its generated code."""

from __future__ import annotations

import io
import tokenize
from textwrap import wrap
from typing import TYPE_CHECKING

from motionlang.lang.highlight import pieces
from motionlang.views.terminal import cells, printable, styled

if TYPE_CHECKING:
    from collections.abc import Iterator

    from motionlang.lang.dialect import Dialect
    from motionlang.lang.listing import Listing
    from motionlang.source import Source

WIDTH = 80
_BREAK = " \\"
# The styles of the tokens of a program's line, by kind.
_STYLES = {"move": "word", "keyword": "word", "not-simulated": "warning", "comment": "dim"}


def render_listing(dialect: Dialect, source: Source, listing: Listing, *, colour: bool) -> Iterator[str]:
    """Return the lines of a listing.

    The output for Python code, including the comments, can still be executed.
    """
    for text in listing.head.splitlines():
        yield styled(f"# {text}".rstrip(), "dim", colour) + "\n"
    before = 0
    for position, (number, code, remark) in enumerate(listing.lines):
        if position == 0 or code.startswith(" def "):
            yield "\n"
            before = 0
        if number != before and dialect.has_code(source.line(number)):
            yield _program_line(dialect, source, number, colour)
        before = number
        indent = " " * (len(code) - len(code.lstrip()))
        if remark and cells(code) + len(remark) + 4 <= WIDTH:
            yield f"{code}  {styled(f'# {remark}', 'dim', colour)}\n"
            continue
        for text in wrap(remark, WIDTH - len(indent) - 2):
            yield f"{indent}{styled(f'# {text}', 'dim', colour)}\n"
        yield (_wrapped(code, indent) if listing.is_python else code) + "\n"


def _program_line(dialect: Dialect, source: Source, number: int, colour: bool) -> str:
    text = printable(source.line(number).expandtabs().rstrip())
    marked = "".join(styled(piece, _STYLES.get(kind, ""), colour) for _, kind, piece in pieces(dialect, text))
    return styled(f"# {number:>3}  ", "bold", colour) + marked + "\n"


def _wrapped(code: str, indent: str) -> str:
    """Return a line of Python, broken with backslashes if it exceeds 80 columns.

    It is broken at blanks between tokens.
    """
    if len(code) <= WIDTH:
        return code
    starts, before, room = [0], 0, WIDTH - len(_BREAK)
    for blank in [*_blanks(code), len(code)]:
        if blank - starts[-1] > room and before > starts[-1]:
            starts.append(before + 1)
            room = WIDTH - len(_BREAK) - len(indent) - 4
        before = blank
    ends = [start - 1 for start in starts[1:]]
    lines = [code[start:end] for start, end in zip(starts, [*ends, None], strict=True)]
    return f"{_BREAK}\n{indent}    ".join(lines)


def _blanks(code: str) -> Iterator[int]:
    """Return the offsets of the blanks between two tokens of a line of Python."""
    text = code.lstrip()
    shift, ended = len(code) - len(text), 0
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.start[0] == 1 and token.start[1] > ended > 0:
            yield shift + ended
        ended = token.end[1]
