"""The tokens of a text for highlighting.

Their kinds are axis, command, number, register, text, comment, separator and unknown.
"""

from __future__ import annotations

from collections.abc import Iterator

from motionlang.mccl.keywords import table
from motionlang.mccl.syntax.parser import head, spans, without_comment
from motionlang.mccl.syntax.tables import BEGINS

_DIGITS = "0123456789"
# The kind of an argument, by the character with which it begins.
_ARGUMENTS = {BEGINS["TEXT"]: "text", BEGINS["REGISTER"]: "register"}


def tokens(text: str) -> Iterator[tuple[str, str, int]]:
    """Yield kind, text and offset of each token; together they make up all of `text`."""
    start = 0
    for line in text.splitlines(keepends=True):
        body = line.rstrip("\r\n")
        code = without_comment(body)
        yield from _line(code, start)
        if len(code) < len(body):
            yield "comment", body[len(code) :], start + len(code)
        if len(body) < len(line):
            yield "separator", line[len(body) :], start + len(body)
        start += len(line)


def _line(code: str, start: int) -> Iterator[tuple[str, str, int]]:
    end = 0
    for first, last in spans(code):
        yield from _separators(code[end:first], start + end)
        yield from _command(code[first:last], start + first)
        end = last
    yield from _separators(code[end:], start + end)


def _separators(text: str, start: int) -> Iterator[tuple[str, str, int]]:
    for at, each in enumerate(text, start):
        yield "separator", each, at


def _command(text: str, start: int) -> Iterator[tuple[str, str, int]]:
    axis, name = head(text)
    if not axis and not name:
        count = len(text) - len(text.lstrip(_DIGITS))
        axis, name = text[:count], text[count : count + 2]
    if axis:
        yield "axis", axis, start
    if name:
        known = table().get(name)
        kind = "unknown" if known is None else "command" if known.simulated else "not-simulated"
        yield kind, name, start + len(axis)
    begin = len(axis) + len(name)
    if begin < len(text):
        yield _ARGUMENTS.get(text[begin], "number"), text[begin:], start + begin
