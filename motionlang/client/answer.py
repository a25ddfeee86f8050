"""What came back: lines, without prompt and echo."""

from __future__ import annotations

import re

# What a client asks first, which is no answer when it is echoed, and what ESC is answered.
ASKED, CANCELLED = "VE", "?-7"
_PROMPT = re.compile(rb"[\r\n]>")
_LAST = re.compile(rb"([^\r\n>][^\r\n]*)(?:\r\n|\r|\n)>")
_CODE = re.compile(r"\?\s*([+-]?\d+)\s*")
_END = re.compile(r"\r\n|\r|\n")


def end_of(data: bytes) -> int:
    """Where a board with a prompt has said all: behind the first prompt that follows a line end; 0 if it has not."""
    match = _PROMPT.search(data)
    return match.end() if match else 0


def version_in(data: bytes) -> tuple[str, int]:
    """The line before a prompt, if it is no answer to ESC, and where that prompt ends; 0 where there is none."""
    for match in _LAST.finditer(data):
        line = match[1].decode("latin-1")
        if line not in (ASKED, CANCELLED):
            return line, match.end()
    return "", 0


def lines_of(data: bytes, sent: str = "") -> list[str]:
    """The lines of an answer; empty ones say nothing, prompts and the echo of what was sent are no answer."""
    found = [line.removeprefix(">") for line in _END.split(data.decode("latin-1"))]
    found = [line for line in found if line]
    if sent in found:
        found.remove(sent)
    return found


def code_of(line: str) -> int | None:
    """The code of an error line, None for any other."""
    match = _CODE.fullmatch(line)
    return int(match[1]) if match else None


def number_of(line: str) -> float | int:
    """The number at the end of a report: 1234 of `01 1234`. ValueError where there is none."""
    text = line.rpartition(" ")[2]
    try:
        return int(text)
    except ValueError:
        return float(text)
