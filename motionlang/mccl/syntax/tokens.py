"""The tokens of a text for highlighting.

Their kinds are axis, command, number, register, text, comment, separator and unknown.
"""

from __future__ import annotations

from motionlang.mccl.keywords import table
from motionlang.mccl.syntax.parser import spans, without_comment

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

_DIGITS = "0123456789"


def tokens(text: str) -> Iterator[tuple[str, str, int]]:
    """Return kind, text and offset of each token; together they are all of `text`."""
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
    count = 0
    while count < len(text) and text[count] in _DIGITS:
        count += 1
    if count:
        yield "axis", text[:count], start
    name = text[count : count + 2]
    if name:
        known = table().get(name)
        kind = "unknown" if known is None else "command" if known.simulated else "not-simulated"
        yield kind, name, start + count
    rest = text[count + 2 :]
    if rest:
        kind = "text" if rest[0] == '"' else "register" if rest[0] == "@" else "number"
        yield kind, rest, start + count + 2
