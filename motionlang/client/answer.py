"""What came back: lines, without prompt and echo."""

from __future__ import annotations

import re

PROMPT = b">"
CANCELLED = "?-7"
_CODE = re.compile(r"\?\s*([+-]?\d+)\s*")
_END = re.compile(r"\r\n|\r|\n")


def is_whole(data: bytes) -> bool:
    """Whether a board with a prompt has said all: a line end, and the prompt behind it."""
    return data[-1:] == PROMPT and data[-2:-1] in (b"\n", b"\r")


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
