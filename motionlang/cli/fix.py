"""`motionlang check --fix`: what can only have been meant one way is written so, and nothing else of a file changes."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from motionlang.files import replacing

if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.errors import Diagnostic

_MARK = "\ufeff"


class Fixed(NamedTuple):
    """One place of a file that was written otherwise: where it stood, and what stood and stands there."""

    line: int
    column: int
    code: str
    before: str
    after: str

    def __str__(self) -> str:
        return f"{self.line}:{self.column}: fixed[{self.code}]: {self.before} -> {self.after}"


def fix(path: str, found: Sequence[Diagnostic]) -> list[Fixed]:
    """Write the fixes of some diagnostics into their file, and say which. OSError where it cannot be read or written.

    Line ends stay as they are. A file that is not UTF-8 is left alone.
    """
    wanted = [each for each in found if each.fix and each.line and each.column]
    if not wanted:
        return []
    with open(path, "rb") as file:
        data = file.read()
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError:
        return []
    mark = _MARK if text.startswith(_MARK) else ""
    lines = text.removeprefix(mark).split("\n")
    if any("\r" in line[:-1] for line in lines):
        return []  # lines that end with a lone carriage return are counted otherwise
    made: list[Fixed] = []
    for each in sorted(wanted, key=lambda one: (one.line, one.column), reverse=True):
        line, begin = lines[each.line - 1], each.column - 1
        end = begin + each.length
        made.append(Fixed(each.line, each.column, each.code, line[begin:end], each.fix))
        lines[each.line - 1] = line[:begin] + each.fix + line[end:]
    with replacing(path, only_copy=True) as out:
        out.write((mark + "\n".join(lines)).encode())
    return made[::-1]
