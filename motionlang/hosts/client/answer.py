"""Parsing of answers: lines, without prompt and echo."""

from __future__ import annotations

import re

# The first question of a client, whose echo is not an answer, and the answer to ESC.
VERSION_QUERY, CANCELLED = "VE", "?-7"
_PROMPT = re.compile(rb"[\r\n]>")
_LAST = re.compile(rb"([^\r\n>][^\r\n]*)(?:\r\n|\r|\n)>")
_CODE = re.compile(r"\?\s*([+-]?\d+)\s*")
_END = re.compile(r"\r\n|\r|\n")


def end_of(data: bytes | bytearray, searched: int = 0) -> int:
    """Return the end of a complete answer of a board with a prompt; 0 if incomplete.

    The end is after the first prompt that follows a line end. The first `searched` bytes contain none.
    """
    match = _PROMPT.search(data, max(0, searched - 1))
    return match.end() if match else 0


def cancelled_in(data: bytes | bytearray) -> bool:
    """Return True if a board without a prompt has answered an ESC.

    An idle board sends an empty line.
    """
    *lines, _ = _END.split(data.decode("latin-1"))
    return CANCELLED in lines or "" in lines


def version_in(data: bytes) -> tuple[str, int]:
    """Return the line before a prompt and the end of that prompt, 0 without a prompt.

    An answer to ESC does not count.
    """
    for match in _LAST.finditer(data):
        line = match[1].decode("latin-1")
        if line not in (VERSION_QUERY, CANCELLED):
            return line, match.end()
    return "", 0


def lines_of(data: bytes | bytearray, sent: str = "") -> list[str]:
    """Return the lines of an answer, without empty lines, prompts and the echo."""
    found = [line.removeprefix(">") for line in _END.split(data.decode("latin-1"))]
    found = [line for line in found if line]
    if sent in found:
        found.remove(sent)
    return found


def code_of(line: str) -> int | None:
    """Return the code of an error line, or None for any other line."""
    match = _CODE.fullmatch(line)
    return int(match[1]) if match else None


def number_of(line: str) -> float | int:
    """Return the number at the end of a report, such as 1234 of `01 1234`.

    Raises ValueError if there is none.
    """
    text = line.rpartition(" ")[2]
    try:
        return int(text)
    except ValueError:
        return float(text)
