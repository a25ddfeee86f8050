"""`motionlang check --fix`: unambiguous corrections, and no other change."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from motionlang.kernel import Diagnostic
from motionlang.kernel.files import replacing

_MARK = "\ufeff"
# More fixes than a file can need; each pass makes all that one check reports.
MAX_PASSES = 1_000


class Unfixable(ValueError):
    """A file that stays as it is; the message says why."""


class Fixed(NamedTuple):
    """One correction in a file: its position, and the text before and after."""

    line: int
    column: int
    code: str
    before: str
    after: str

    def __str__(self) -> str:
        return f"{self.line}:{self.column}: fixed[{self.code}]: {self.before} -> {self.after}"


def fix(
    path: str,
    found: Sequence[Diagnostic],
    check: Callable[[str], Sequence[Diagnostic]],
    then: Callable[[str], Sequence[Diagnostic]] = lambda text: (),
) -> list[Fixed]:
    """Write the fixes of diagnostics to their file, and return them.

    `check(text)` returns the diagnostics of a text. A check stops after a number of errors, so fixing and checking
    repeat until no fix is left, and then again with the diagnostics that `then` finds in the fixed text. The file is
    written once; line endings and the encoding do not change. Raises Unfixable for a file in UTF-16 or with lone
    carriage returns, and OSError if the file cannot be read or written.
    """
    if not any(each.fix for each in found):
        return []
    with open(path, "rb") as file:
        data = file.read()
    encoding = "utf-8"
    try:
        text = data.decode(encoding)
    except UnicodeDecodeError:
        if b"\0" in data:
            raise Unfixable("it is in UTF-16") from None
        encoding = "latin-1"
        text = data.decode(encoding)
    mark = _MARK if text.startswith(_MARK) else ""
    text = text.removeprefix(mark)
    if "\r" in text.replace("\r\n", ""):
        raise Unfixable("some of its lines end with a carriage return alone")
    fixed: list[Fixed] = []
    left = found
    for again in (check, then):
        for _ in range(MAX_PASSES):
            text, made, left = fix_once(text, left, again)
            if not made:
                break
            fixed += made
        left = then(text)
    with replacing(path, only_copy=True) as out:
        out.write((mark + text).encode(encoding))
    return fixed


def fix_once(
    text: str, found: Sequence[Diagnostic], check: Callable[[str], Sequence[Diagnostic]]
) -> tuple[str, list[Fixed], Sequence[Diagnostic]]:
    """Return the text with all fixes that cause no new warning in their lines, these fixes, and what is left."""
    wanted = list(found)
    while True:
        fixed, made = _fixed(text, wanted)
        if not made:
            return text, [], found
        left = check(fixed)
        before = {(each.line, each.code, each.message) for each in found}
        worse: dict[int, list[int]] = {}
        for each in left:
            if each.severity == "warning" and (each.line, each.code, each.message) not in before:
                worse.setdefault(each.line, []).append(each.column)
        dropped = {at for line, columns in worse.items() for at in _causes(made, line, columns)}
        if not dropped or fixed.count("\n") != text.count("\n"):
            return fixed, made, left
        wanted = [each for each in wanted if (each.line, each.column) not in dropped]


def _causes(made: Sequence[Fixed], line: int, columns: Sequence[int]) -> list[tuple[int, int]]:
    """Return the positions of the fixes of a line at whose new texts there are new warnings; without any, of all."""
    own, found, shift = [each for each in made if each.line == line], [], 0
    for each in own:
        begin = each.column + shift
        shift += len(each.after) - len(each.before)
        if any(begin <= column < begin + len(each.after) for column in columns):
            found.append(each)
    return [(line, each.column) for each in found or own]


def _fixed(text: str, found: Sequence[Diagnostic]) -> tuple[str, list[Fixed]]:
    """Return a text with the fixes that change it applied, and these; the later of two overlaps."""
    wanted = [each for each in found if each.fix and each.line and each.column]
    lines = text.split("\n")
    made: list[Fixed] = []
    for each in sorted(wanted, key=lambda one: (one.line, one.column), reverse=True):
        line, begin = lines[each.line - 1], each.column - 1
        end = begin + each.length
        if made and made[-1].line == each.line and made[-1].column - 1 < end:
            continue
        new = each.fix.replace("\n", "\r\n") if line.endswith("\r") else each.fix
        if new == line[begin:end]:
            continue
        made.append(Fixed(each.line, each.column, each.code, line[begin:end], new.strip()))
        lines[each.line - 1] = line[:begin] + new + line[end:]
    return "\n".join(lines), made[::-1]
