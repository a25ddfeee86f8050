"""Comments of lines, found without a parser: a client that only sends lines needs none."""

from __future__ import annotations

import re

# A line up to its comment, which is group 1: a `;` outside a text in quotes, or a `#` with which a line begins.
COMMENT = re.compile(r'^(?>[ \t]*+(?=#)|(?:[^;"\n]++|"[^"\n]*+"?)*+)(?=([;#][^\n]*+))', re.ASCII)


def without_comment(line: str) -> str:
    """Return the line without its comment, as a downloader sends it."""
    comment = COMMENT.match(line)
    return line if comment is None else line[: comment.end()]
