"""Names of channels, axes and registers in the comments of a program.

Old programs list their channels at the head, in one of a few forms:

    REM IN 0 product eye   IN 1 label gap eye          ; in 1 bar in gripper  2 gripper closed
    REM OUT 0 clamp 1 spindle 2 coolant                 ' inputs  1 lock pin out   2 lock pin in

    ' IN  0 ram at bottom       OUT 0 press clutch      ' Inputs          Outputs
    '     1 ram at top              1 lubricate         '  0 nest full     0 clamp

A list begins at a word such as IN with a number, in capitals if the first one of the comment is, or below a heading,
which is a line of such words alone. A line without a word continues the list above it. Lists of several kinds in one
line are columns: a number belongs to the list whose word or number is above it.

A name is what follows a number up to the next item, a sign that ends it, two blanks or a number with a unit. An item
begins behind two blanks or a sign. A number behind one blank may be part of a name (`3 nest 1 bottle`), so it begins an
item only if the list counts on with it. A number whose list is uncertain gets no name. The caller keeps only the names
of numbers that the program uses, because a comment may be about anything.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from motionlang.kernel.lang.dialect import Dialect
from motionlang.kernel.source import Source

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
# A word of a heading, which has only such words: "Inputs", "OUTPUTS:", "Inputs (24 V)".
_HEADING = re.compile(rf"(?:{_KIND})(?:\s?\([^()]*\))?\s?:?(?=\s\s|\s*$)", re.IGNORECASE)
_ITEM = re.compile(
    r"(?P<number>\d{1,3})\)?(?P<sign>\s*[-=:]\s*(?:\d+\s+)?|\s+)(?P<name>[A-Za-z].*)", re.DOTALL
)
_UNIT = "(?:mm|s|ms|counts?|steps?|rpm|deg|degrees|revs?|turns?|percent|kHz|Hz|V|A)"
_NUMBER = rf"(?=\d{{1,3}}(?:\s*[-=:]|\s+(?!{_UNIT}\b)[A-Za-z]))"
# Where an item begins behind two blanks, behind a sign, and perhaps behind one blank.
_WIDE = re.compile(rf"(?<=\s\s){_NUMBER}", re.IGNORECASE)
_SIGN = re.compile(r"(?:[,;|*]\s*|\.\s)(?=\d{1,3}\b)")
_BLANK = re.compile(rf"(?<=\S\s)(?=\d{{1,3}}\s+(?!{_UNIT}\b)[A-Za-z])", re.IGNORECASE)
# Where the name ends: at two blanks, a sign, a number with a unit, or the value of a number.
_END = re.compile(
    rf"\s{{2,}}|[,;|*]|[.:](?:\s|$)|\s+(?=\d[\d.]*\s+{_UNIT}\b)|\s+(?=\d{{1,3}}\s*=)", re.IGNORECASE
)
_MARKS = re.compile(r"^\s*(?:REM\b|['/;*]+)[\s*]*", re.IGNORECASE)
# A text in brackets, in which no item begins; `COMMS(3)` is none.
_BRACKETS = re.compile(r"\((?!\s*\d+\s*\))[^()]*\)")
# "X = 0" and "X=0": a letter for an axis.
_LETTER = re.compile(r"\b([A-Z])\s*=\s*(\d)\b")
_UNITS = re.compile(rf"^{_UNIT}\b", re.IGNORECASE)
MAX_NAME = 28
# How far from its column a number may be, in characters.
REACH = 3


@dataclass(eq=False, slots=True)
class Named:
    """The name of a channel or an axis in a comment, and its line."""

    kind: str
    number: int
    name: str
    line: int


@dataclass(eq=False, slots=True)
class _Cell:
    """A text that begins with a number, at column `at` of a line.

    `kind` is that of the word before it, which is at column `start`; without a word it is empty.
    """

    line: int
    start: int
    at: int
    text: str
    kind: str = ""

    @property
    def number(self) -> int:
        return _leading(self.text)


@dataclass(eq=False, slots=True)
class _List:
    """A list of items of one kind, in cells."""

    kind: str
    cells: list[_Cell] = field(default_factory=list)

    def is_continued_by(self, cell: _Cell) -> bool:
        return bool(self.cells) and cell.number == self.cells[-1].number + 1


@dataclass(eq=False, slots=True)
class _Column:
    """The columns of a line from a word to its number, and the list below them."""

    start: int
    end: int
    below: _List


class _Lists:
    """The lists of comments, read line by line; `columns` are those of the last line with words."""

    def __init__(self) -> None:
        self.all: list[_List] = []
        self.columns: list[_Column] = []
        self._last: _List | None = None  # the one at the end of the last line if that has words

    def head(self, words: Iterable[re.Match[str]]) -> None:
        """Begin the lists below a heading."""
        self.columns = [_Column(each.start(), each.end(), self._new(_kind(each))) for each in words]
        self._last = None

    def add(self, cells: Sequence[_Cell]) -> None:
        """Add the cells of a line to their lists; those whose list is uncertain are left out."""
        if any(each.kind for each in cells):
            self._add_with_words(cells)
        elif self.columns:
            self._add_below(cells)
        elif re.match(r"\d\s*=", cells[0].text):
            self._new("axis").cells += cells

    def _add_with_words(self, cells: Sequence[_Cell]) -> None:
        """Add a line with words; its columns are new unless it repeats the words of those above."""
        columns: list[_Column] = []
        current: _List | None = None
        is_repeated = True
        for cell in cells:
            above = self._list_above(cell) if self._has_kinds or not (cell.kind or current) else None
            if cell.kind and above is not None and above.kind == cell.kind:
                current = above
            elif cell.kind:
                current, is_repeated = self._new(cell.kind), False
            elif current is not None and above is not None and above.kind != current.kind:
                continue
            chosen = current or above
            if chosen is not None:
                chosen.cells.append(cell)
                columns.append(_Column(cell.start, cell.at, chosen))
        if not is_repeated:
            self.columns = columns
        self._last = current

    def _add_below(self, cells: Sequence[_Cell]) -> None:
        """Add a line without words.

        If it counts on from the end of a line with words, it may continue its text and have no columns.
        """
        above = [self._list_above(each) for each in cells]
        kinds = {each.kind for each in above if each is not None}
        if len(kinds) == 1 and self._may_continue_text(cells[0], above[0]):
            self.columns = []
            return
        self._last = None
        for cell, each in zip(cells, above, strict=True):
            if each is not None:
                each.cells.append(cell)

    def _may_continue_text(self, cell: _Cell, above: _List | None) -> bool:
        last = self._last
        if last is None or above is None or above.kind == last.kind:
            return False
        return last.is_continued_by(cell) and not above.is_continued_by(cell)

    @property
    def _has_kinds(self) -> bool:
        return len({each.below.kind for each in self.columns}) > 1

    def _list_above(self, cell: _Cell) -> _List | None:
        """Return the list whose columns are above a cell, None if it is uncertain."""
        if not self._has_kinds:
            return self.columns[-1].below if self.columns else None
        far = [(max(each.start - cell.at, cell.at - each.end, 0), each.below) for each in self.columns]
        nearest = min(distance for distance, _ in far)
        if nearest > REACH:
            return None
        found = [below for distance, below in far if distance <= (REACH if nearest else 0)]
        return found[-1] if len({each.kind for each in found}) == 1 else None

    def _new(self, kind: str) -> _List:
        self.all.append(_List(kind))
        return self.all[-1]


def names_in_comments(source: Source, language: Dialect) -> list[Named]:
    """Return the names that the comments of a program list, also those of channels that it does not use, in order."""
    lists = _Lists()
    found: list[tuple[int, int, Named]] = []
    last = 0
    for line, comment in comments_of(source, language)[0]:
        text = _MARKS.sub(lambda marks: " " * len(marks[0]), comment.expandtabs()).rstrip()
        if line != last + 1:
            lists.columns = []
        last = line
        if words := _heading(text):
            lists.head(words)
        elif cells := _cells(line, text, lists.columns):
            lists.add(cells)
        elif not any(each.below.cells for each in lists.columns) and not re.search(r"\w", text):
            continue  # a rule below a heading
        else:
            lists.columns = []
            found += (
                (line, each.start(), Named("axis", int(each[2]), each[1], line))
                for each in _LETTER.finditer(text)
            )
    for each in lists.all:
        found += (
            (cell.line, cell.at, Named(each.kind, number, name, cell.line))
            for cell, number, name in _items(each.cells)
        )
    return [each for *_, each in sorted(found, key=lambda each: each[:2])]


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


def _heading(text: str) -> list[re.Match[str]]:
    """Return the words of a heading, none if the line has anything else."""
    words = list(_HEADING.finditer(text))
    return words if words and not _HEADING.sub("", text).strip() else []


def _cells(line: int, text: str, columns: Iterable[_Column]) -> list[_Cell]:
    """Return the cells of a line that has words or begins with a number.

    Below a column a number begins a cell even if the one before it leaves only one blank.
    """
    outside = _BRACKETS.sub(lambda brackets: "(" * len(brackets[0]), text)
    begins = {each.end(): each for each in _beginnings(outside)}
    first = re.match(r"\s*(?=\d)", outside)
    if not begins and first is None:
        return []
    numbers = {each.end() for each in _WIDE.finditer(outside)} | ({first.end()} if first else set())
    filled = {each.below.cells[-1].at for each in columns if each.below.cells}
    numbers |= filled & {each.end() for each in _BLANK.finditer(outside)}
    starts = sorted(numbers | begins.keys())
    ends = sorted({*numbers, *(each.start() for each in begins.values()), len(text)})
    return [
        _Cell(
            line,
            begins[at].start() if at in begins else at,
            at,
            text[at : next(end for end in ends if end > at)],
            _kind(begins[at]) if at in begins else "",
        )
        for at in starts
    ]


def _beginnings(text: str) -> Iterator[re.Match[str]]:
    """Yield the words that begin a list; in the middle of a text they look like the one at its start."""
    is_list = is_upper = False
    for match in _BEGIN.finditer(text):
        before = text[: match.start()]
        starts = not before.strip() or re.search(r"\s\s$|[,;|.]\s?$", before)
        if starts or (is_list and match[0][0].isupper() == is_upper and "  " not in match[0]):
            yield match
        if not before.strip():
            is_list, is_upper = True, match[0][0].isupper()


def _kind(match: re.Match[str]) -> str:
    return next(kind for kind in _WORDS if match.group(kind.replace(" ", "_")))


def _leading(text: str) -> int:
    digits = re.match(r"\d+", text)
    return int(digits[0]) if digits else 0


def _items(cells: Sequence[_Cell]) -> Iterator[tuple[_Cell, int, str]]:
    """Yield numbers and names of a list.

    In a list without equal signs, `1 = automatic` explains a value of the item before it, and so does `00 = none`.
    """
    parts = [(cell, part) for cell in cells for part in _split(cell.text, _SIGN)]
    split = _split_at_blanks([part for _, part in parts])
    parts = [(cell, item) for (cell, _), items in zip(parts, split, strict=True) for item in items]
    has_signs = bool(parts) and re.match(r"\d+\)?\s*=", parts[0][1]) is not None
    for cell, part in parts:
        match = _ITEM.match(part)
        if match is None or ("=" in match["sign"] and not has_signs) or re.match(r"0\d", match["number"]):
            continue
        name = _name(match["name"])
        if name and not _UNITS.match(name):
            yield cell, int(match["number"]), name[:MAX_NAME]


def _split(text: str, at: re.Pattern[str]) -> list[str]:
    """Split a text where items begin, outside brackets."""
    outside = _BRACKETS.sub(lambda brackets: "(" * len(brackets[0]), text)
    places = [0, *(each.end() for each in at.finditer(outside)), len(text)]
    return [text[begin:end] for begin, end in pairwise(places)]


def _split_at_blanks(parts: Sequence[str]) -> Iterator[list[str]]:
    """Split the parts of a list at the numbers behind one blank with which it counts on up to its next part.

    In the last part they begin items if those of all parts before do.
    """
    is_style = True
    for k, part in enumerate(parts):
        split = _split(part, _BLANK)
        numbers = [_leading(each) for each in (*split, *parts[k + 1 : k + 2])]
        counts_on = all(number == before + 1 for before, number in pairwise(numbers))
        is_style &= counts_on and len(split) > 1
        yield split if is_style or (counts_on and k + 1 < len(parts)) else [part]


def _name(text: str) -> str:
    """Return the name at the start of a text."""
    end = _END.search(text)
    name = (text[: end.start()] if end else text).strip(" .*")
    if not re.search(r"\w ?[-+]$", name) or (end is not None and text[end.end() :][:1].isdigit()):
        name = name.rstrip(" -")  # "jog -" has its sign
    return name.partition("(")[0].rstrip() if "(" in name and ")" not in name else name
