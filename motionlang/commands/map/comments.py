"""Names of channels, axes and registers in the comments of a program.

Old programs list their channels at the head, in one of a few forms:

    REM IN 0 product eye   IN 1 label gap eye          ; in 1 bar in gripper  2 gripper closed
    REM OUT 0 clamp 1 spindle 2 coolant                 ' inputs  1 lock pin out   2 lock pin in

A name is what follows a number up to the next number that could be one of a list, a sign that ends a list, two blanks,
or a word such as IN with a number, in capitals if the first one of the comment is. A line without a word such as IN
continues the line above it. The caller keeps only the names of numbers that the program uses, because a comment may be
about anything.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from motionlang.kernel import Dialect, Source

# The words that begin a list, and what it names.
_WORDS = {
    "input": "in(?:put)?s?x?|di|din",
    "output": "out(?:put)?s?x?|do|dout",
    "analogue input": "adc|ai|ain|analogue? in(?:put)?s?",
    "analogue output": "dac|ao|aout|analogue? out(?:put)?s?",
    "axis": "ax(?:is|es)",
    "register": "r(?:eg(?:ister)?s?)?",
    "comms element": "comms",
    "network data": "net ?data",
}
_KIND = "|".join(f"(?P<{kind.replace(' ', '_')}>{words})" for kind, words in reversed(_WORDS.items()))
# A word that begins a list, with its first number: "IN 0", "in1", "out 33".
_BEGIN = re.compile(rf"(?:^|(?<=\s)|(?<=[,;|.]))(?:{_KIND})[ .:#=(]*(?=\d)", re.IGNORECASE)
_ITEM = re.compile(
    r"(?<![\w.])(?P<number>\d{1,3})\)?(?P<sign>\s*[-=:]\s*(?:\d+\s+)?|\s+)(?P<name>[A-Za-z].*)", re.DOTALL
)
_UNIT = "(?:mm|s|ms|counts?|steps?|rpm|deg|degrees|revs?|turns?|percent|kHz|Hz|V|A)"
# Where the name ends: at the next number of the list, at two blanks, or at a sign.
_END = re.compile(
    rf"\s{{2,}}|[,;|*]|\s+(?=\d[\d.]*\s+{_UNIT}\b)|\s+(?=\d{{1,3}}\s+(?!{_UNIT}\b)[A-Za-z])|\s+(?=\d{{1,3}}\s*=)|\.\s",
    re.IGNORECASE,
)
_MARKS = re.compile(r"^\s*(?:REM\b|['/;*]+)[\s*]*", re.IGNORECASE)
# "X = 0" and "X=0": a letter for an axis.
_LETTER = re.compile(r"\b([A-Z])\s*=\s*(\d)\b")
_UNITS = re.compile(rf"^{_UNIT}\b", re.IGNORECASE)
MAX_NAME = 28


@dataclass(eq=False, slots=True)
class Named:
    """The name of a channel or an axis in a comment, and its line."""

    kind: str
    number: int
    name: str
    line: int


def named(comments: Iterable[tuple[int, str]]) -> list[Named]:
    """Return the names in comments, each given with its line, in the order of the text."""
    found: list[Named] = []
    kind, last = "", 0
    for line, comment in comments:
        text = without_marks(comment)
        if line != last + 1:
            kind = ""
        last = line
        begins = list(_beginnings(text))
        if not begins and not re.match(r"\s*\d", text):
            kind = ""
            found += (Named("axis", int(number), letter, line) for letter, number in _LETTER.findall(text))
            continue
        pieces = [
            (
                kind or ("axis" if re.match(r"\s*\d\s*=", text) else ""),
                text[: begins[0].start()] if begins else text,
            )
        ]
        for k, begin in enumerate(begins):
            end = begins[k + 1].start() if k + 1 < len(begins) else len(text)
            kind = _kind(begin)
            pieces.append((kind, text[begin.end() : end]))
        for of, piece in pieces:
            if of:
                found += (Named(of, number, name, line) for number, name in _items(piece))
    return found


def comments_of(source: Source, language: Dialect) -> tuple[list[tuple[int, str]], dict[int, str]]:
    """Return the comments with a line of their own, and those behind code, with their lines."""
    own: list[tuple[int, str]] = []
    behind: dict[int, str] = {}
    for kind, text, at in language.tokens(source.text):
        if kind != "comment":
            continue
        line, column = source.location(at)
        if source.line(line)[: column - 1].strip():
            behind[line] = text
        else:
            own.append((line, text))
    return own, behind


def without_marks(comment: str) -> str:
    """Return the text of a comment."""
    return _MARKS.sub("", comment).strip()


def _beginnings(text: str) -> Iterator[re.Match[str]]:
    """Yield the words that begin a list; in the middle of a text they look like the one at its start."""
    is_list = is_upper = False
    for match in _BEGIN.finditer(text):
        starts = not match.start() or re.search(r"\s\s$|[,;|.]\s?$", text[: match.start()])
        if starts or (is_list and match[0][0].isupper() == is_upper and "  " not in match[0]):
            yield match
        if not match.start():
            is_list, is_upper = True, match[0][0].isupper()


def _kind(match: re.Match[str]) -> str:
    return next(kind for kind in _WORDS if match.group(kind.replace(" ", "_")))


def _items(text: str) -> Iterator[tuple[int, str]]:
    """Yield numbers and names of a list.

    In a list without equal signs, `1 = automatic` explains a value of the item before it, and so does `00 = none`.
    """
    has_signs: bool | None = None
    while (match := _ITEM.search(text)) is not None:
        rest, is_equal = match["name"], "=" in match["sign"]
        end = _END.search(rest)
        name = (rest[: end.start()] if end else rest).strip(" .*")
        if not re.search(r"\w ?[-+]$", name) or (end is not None and rest[end.end() :][:1].isdigit()):
            name = name.rstrip(" -")  # "jog -" has its sign
        if "(" in name and ")" not in name:
            name = name.partition("(")[0].rstrip()
        has_signs = is_equal if has_signs is None else has_signs
        is_value = (is_equal and not has_signs) or re.match(r"0\d", match["number"])
        if name and not _UNITS.match(name) and not is_value:
            yield int(match["number"]), name[:MAX_NAME]
        bracket = rest.find(")") + 1 if "(" in rest[: len(name) + 2] and "(" not in name else len(name)
        text = rest[max(bracket, len(name)) :]
