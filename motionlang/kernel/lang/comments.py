"""Names of channels, axes and registers in the comments of a program.

Old programs list their channels at the head, in one of a few forms:

    REM IN 0 product eye   IN 1 label gap eye          ; in 1 bar in gripper  2 gripper closed
    REM OUT 0 clamp 1 spindle 2 coolant                 ' inputs  1 lock pin out   2 lock pin in

    ' IN  0 ram at bottom       OUT 0 press clutch      ' Inputs          Outputs
    '     1 ram at top              1 lubricate         '  0 nest full     0 clamp

A list begins at a word such as IN with a number, in capitals if the first one of the comment is, or below a heading,
which is a line of such words alone. The word governs the numbers up to the next one, each with or without a mark
before it (`in: #4 lid, #5 tray`). A line without a word continues the list above it. Lists of several kinds in one line
are columns: a number belongs to the list whose word or number is above it. The numbers of a list ascend; one that does
not explains a value (`IN 4 state, 0 idle`).

A name is what follows a number up to the next item, a sign that ends it, a bracket, two blanks or a number with a unit.
An item begins behind two blanks or a sign. A number behind one blank may be part of a name (`3 nest 1 bottle`), so it
begins an item only if the list counts on with it. A number whose list is uncertain gets no name, and neither does one
with a sentence. The caller keeps only the names of numbers that the program uses, because a comment may be about
anything.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import groupby, pairwise, repeat, zip_longest
from textwrap import shorten

from motionlang.kernel.lang.dialect import Dialect
from motionlang.kernel.source import Source

# Devices of a list: "valves: 3 clamp". In the middle of a text they begin none.
_SENSORS = "sensors|switches|buttons|contacts|reeds"
_ACTUATORS = "valves|solenoids|cylinders|lamps|lights"
_DRIVES = "motors?|drives?|servos?"
# E, A and S begin a list in brackets, or before a number or a colon; as capitals also before a blank and a number.
_ALONE = r"(?:(?<=[(\[])|(?=.[\d:])|(?-i:(?=[EAS] \d)))"
# The words that begin a list, and what it names; a channel may be an input or an output.
_WORDS = {
    "input": r"d?i|i/?p'?s?|(?:d|dig(?:ital)? )?in(?:p(?:ut)?)?s?x?"
    rf"|{_ALONE}e|eing(?:ang|änge)?|ent(?:r(?:[ée]es?|adas?)?)?|ing(?:r(?:ess[oi])?|ang(?:en)?)?|{_SENSORS}",
    "output": r"d?[oq]|[uy](?=\d)|ot|o/?p'?s?|(?:d|dig(?:ital)? )?out(?:p(?:ut)?)?s?x?|rly|relays?"
    rf"|{_ALONE}s|ausg(?:ang|änge)?|sor(?:t(?:ies?)?)?|sal(?:idas?)?|sa[ií]das?|usc(?:it[ae])?"
    rf"|uit(?=[ .]?\d)|uitg(?:ang(?:en)?)?|{_ACTUATORS}",
    "channel": r"c(?=\d)|ch(?:an(?:nel)?)?s?|can(?=[ .]?\d)|kanaa?l|canale?|voies?|d?i/o|dio",
    "analogue input": rf"a/?dc?|ai|ai?n|ana|{_ALONE}a|anal[oó]gi(?:c[ao]|que)s?|analog(?:ue)?(?: in(?:put)?s?)?"
    r"|(?:canale|ingress[oi]|entradas?|entr[ée]es?) anal[oó]gi(?:qu|c)[aeio]s?|analogeing(?:ang|änge)",
    "analogue output": "dac|ao|aout|analog(?:ue)? out(?:put)?s?",
    "axis": rf"ax(?:is|es?)?|achsen?|ejes?|eixos?|ass[ei]|assen|as(?=[ .]?\d)|{_DRIVES}",
    # X0 is an input, or an axis where another word names the input with this number.
    "X": r"x(?=\d)",
    "encoder": "enc(?:oder)?s?",
    "register": "r(?:eg(?:ister|istre|istro)?s?)?|registri",
    "comms element": "comms",
    "network data": r"net(?: ?data)?|n(?=\d)",
}
_KIND = "|".join(f"(?P<{kind.replace(' ', '_')}>{words})" for kind, words in reversed(_WORDS.items()))
# Marks and words that may be between the word of a list and its number.
_BETWEEN = r"(?:[][ .:#=()|_>-]|ch|bit|are|used|list)"
# A word of a heading, which has only such words: "Inputs", "OUTPUTS:", "Inputs (24 V)", "--- input list ---".
_HEADING = re.compile(
    rf"[(\[]?(?:{_KIND})(?:\s?\([^()]*\))?{_BETWEEN}*?(?=\s\s|\s*[-=*]*\s*$|\s?[-=*]{{2}})", re.IGNORECASE
)
# A name before its word and number: "carriage = axis 0", "datum switch of the saddle on i/p 8".
_REVERSED = re.compile(
    rf"\s*(?P<name>[A-Z]|[A-Za-z][\w ]+?)(?:\s*=\s*|(?<=\w) on )(?:{_KIND})[ .#]*(?P<number>\d{{1,3}})\.?\s*"
    r"(?:\([^()]*\)\s*)?",
    re.IGNORECASE,
)
_UNIT = (
    r"(?:mm|s|ms|cts|sec(?:ond)?s?|minutes|days|weeks|months|years|times|x(?= ?\d)|counts|steps?|rpm|deg|degrees"
    "|revs?|turns?|percent|kHz|Hz|V|A|%)"
)
# Where an item begins: two blanks or a sign. A colon is one before a word only.
_BEGIN = r"(?P<wide>^\s*|(?<!\s)\s\s+)|[,;|*]\s*|[./]\s|[.:]\s?(?!bit )(?=[^\W\d]|[(\[]\D)"
# What is before the word of a list there, as in "(I)", "air valves:" and "analog AN0", and what it is not in a text.
_FIRST = (
    r"(?:[(\[](?=[\w/ ]+[)\]]))?(?:\w+ (?=\w+ ?:))??"
    rf"(?:(?:{'|'.join(_WORDS.values())})\s+(?=[a-z]{{1,3}}\d))??"
)
_LATER = f"(?!{_SENSORS}|{_ACTUATORS}|{_DRIVES})"
# Before a gap a number without a word or a mark is the end of a name, as in "cup at place 1".
_LAST = r"(?(starts)|(?!\d+\s\s))"
# A number behind a word, a mark or neither, with the sign and the letter behind it: "IN 0 -", "OUT(0) =", "#4".
_ITEM = re.compile(
    rf"(?:(?P<starts>{_BEGIN})|\s)(?P<item>)"
    rf"(?:(?(starts){_FIRST}|{_LATER})(?:{_KIND})(?(starts){_BETWEEN}*|[.:#=(]* ?)|(?:[#(\[]|bit )?{_LAST})"
    r"(?P<number>\d{1,3})"
    rf"[)\]]?(?:\s*(?P<equal>=)\s*|\s*(?:[-:|/]|\.+)\s*|\s+(?!{_UNIT}(?!\w))|(?!\d))(?P<name>[\"']?[^\W\d_])?",
    re.IGNORECASE,
)
# A range of numbers, "8..11", "DI8..DI11", "8-11", or a list that counts on, "8,9,10".
_RANGE = re.compile(
    r"(?<![\d.,-])(\d{1,3})(?:\s?(?:\.\.+|-)\s?[A-Za-z/]{0,5}\d{1,3}|(?:,\s?\d{1,3})+)(?=\s[A-Za-z])"
)
# Where the name ends: at two blanks, a sign, a bracket, a number with a unit, a range, or the value of a number.
_END = re.compile(
    rf"\s{{2,}}|[,;|*(]|\s\[|(?<=\w\w)(?:\.(?:\s|$)|:(?=\s*(?:\d|$)))|\s-\s+(?=\w)|(?:\s+[ie]n)?\s+(?=\d[\d.]*\s*{_UNIT}(?!\w))"
    r"|(?:\s+[ie]n)?\s+(?:mm|deg|rpm|%)(?=\s*(?:[,;.]|\s\s|$))"
    r"|\s+(?=\d{1,3}(?:\s*=|-\d))",
    re.IGNORECASE,
)
# Words at the begin of a sentence, and those that only a sentence has: it is no name. "Cup is down" is a sensor's.
_SENTENCE = re.compile(
    r"(?:and|as|at|by|for|from|has|if|of|only|or|to|until|wait|when|while|with)\b|.*\b(?:are|be|let|must|was)\b"
    r"|ax(?:is)? ?\d"
    r"|(?!\w.*\sis\s\w+$).*\bis\b",
    re.IGNORECASE,
)
_MARKS = re.compile(r"^\s*(?:REM\b|['/;*]+)[\s*|]*", re.IGNORECASE)
# A text in brackets, in which no item begins; `COMMS(3)` and `(I) 1` have none.
_BRACKETS = re.compile(rf"\((?!\s*\d+\s*\)|(?<!\w \()(?:{_KIND})\))[^()]*\)", re.IGNORECASE)
# "X = 0", "X=0" and "X axis = 0": a letter for an axis.
_LETTER = re.compile(r"(?<![-\d]\d )\b([A-Z])(?: [Aa]xis| AXIS)?\s*=\s*(\d)\b")
# A channel that is an output: "CH 9 OUT vibrator", "CH9 red lamp (out)".
_OUT = re.compile(r"(?:^|\()out(?:put)?\b\)?\s*", re.IGNORECASE)
# A remark that may be a name has at most three words; a number before it, none of a level, is that of the channel.
_REMARK = re.compile(r"(?:([2-9]|\d\d+) ?= ?)?([A-Za-z][\w/.-]*(?: [\w/.-]+){0,2})")
MAX_NAME = 40
# A list of channels without a word has so many items at least.
LONG_LIST = 8
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
class _Item:
    """A number at column `at` of a line, and the column at which the text behind it begins.

    `end` is the column of the next item that is certain. `kind` is that of the word before the number, which is at
    column `start`; without a word it is empty. A word or two blanks begin a cell of a table. A number behind one blank
    `is_loose`: it may be part of a name. Of a range, such as 8..11, `last` is its end.
    """

    line: int
    text: str
    start: int
    at: int
    begin: int
    number: int
    last: int
    kind: str
    begins_cell: bool
    is_loose: bool
    has_equal: bool
    end: int = 0


# An item with its kind and its name.
_NamedItem = tuple[_Item, str, str]


@dataclass(eq=False, slots=True)
class _List:
    """A list of items of one kind; `column` is that of its last cell."""

    kind: str
    items: list[_Item] = field(default_factory=list)
    column: int = -1

    def is_continued_by(self, item: _Item) -> bool:
        return bool(self.items) and item.number == self.items[-1].last + 1


@dataclass(eq=False, slots=True)
class _Column:
    """The columns of a line from a word to its number, and the list below them."""

    start: int
    end: int
    below: _List


class _Lists:
    """The lists of comments, read line by line; `columns` are those of the last line with words."""

    def __init__(self, has_one_series: bool) -> None:
        self._has_one_series = has_one_series
        self.all: list[_List] = []
        self.columns: list[_Column] = []
        self._last: _List | None = None  # the one at the end of the last line if that has words

    def head(self, words: Iterable[re.Match[str]]) -> None:
        """Begin the lists below a heading."""
        self.columns = [_Column(each.start(), each.end(), self._new(_kind(each))) for each in words]
        self._last = None

    def add(self, items: Sequence[_Item]) -> None:
        """Add the items of a line to their lists; those whose list is uncertain are left out."""
        cells = [each for each in items if each.begins_cell]
        if any(each.kind for each in cells):
            lists = iter(self._with_words(cells))
        elif self.columns:
            lists = iter(self._below(cells))
        elif self._has_one_series and len(cells) > 1 and items[0].number == 1 and not items[0].has_equal:
            self.columns = [_Column(0, len(items[0].text), self._new(""))]
            lists = repeat(self.columns[0].below)
        else:
            lists = repeat(self._new("axis") if items[0].has_equal else None)
        current = None
        for item in items:
            current = next(lists) if item.begins_cell else current
            if current is not None:
                current.items.append(item)
                current.column = item.at if item.begins_cell else current.column

    def _with_words(self, cells: Sequence[_Item]) -> list[_List | None]:
        """Return the lists of a line with words; its columns are new unless it repeats the words of those above."""
        found: list[_List | None] = []
        current: _List | None = None
        is_repeated = True
        for cell in cells:
            above = self._list_above(cell) if self._has_kinds or current is None else None
            known = (each for each in (above, current) if each is not None and each.kind == cell.kind)
            if cell.kind:
                same = next(known, None)
                is_repeated &= same is not None
                current = same or self._new(cell.kind)
            is_uncertain = not cell.kind and current and above and above.kind != current.kind
            found.append(None if is_uncertain else current or above)
        if not is_repeated:
            placed = zip(cells, found, strict=True)
            self.columns = [_Column(cell.start, cell.at, each) for cell, each in placed if each is not None]
        self._last = current
        return found

    def _below(self, cells: Sequence[_Item]) -> list[_List | None]:
        """Return the lists of a line without words.

        If it counts on from the end of a line with words, it may continue its text and have no columns.
        """
        above = [self._list_above(each) for each in cells]
        kinds = {each.kind for each in above if each is not None}
        if len(kinds) == 1 and self._may_continue_text(cells[0], above[0]):
            self.columns = []
            return [None] * len(cells)
        self._last = None
        return above

    def _may_continue_text(self, cell: _Item, above: _List | None) -> bool:
        last = self._last
        if last is None or above is None or above.kind == last.kind:
            return False
        return last.is_continued_by(cell) and not above.is_continued_by(cell)

    @property
    def _has_kinds(self) -> bool:
        return len({each.below.kind for each in self.columns}) > 1

    def _list_above(self, cell: _Item) -> _List | None:
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
    lists = _Lists(language.has_one_series)
    found: list[tuple[int, int, Named]] = []
    last = 0
    for line, comment in comments_of(source, language)[0]:
        text = _MARKS.sub(lambda marks: " " * len(marks[0]), comment.expandtabs()).rstrip()
        if line != last + 1:
            lists.columns = []
        last = line
        if words := _heading(text):
            lists.head(words)
        elif items := _items(line, text, {each.below.column for each in lists.columns}):
            lists.add(items)
        elif not any(each.below.items for each in lists.columns) and not re.search(r"\w", text):
            continue  # a rule below a heading
        elif lists.columns and len(text) - len(text.lstrip()) > max(each.end for each in lists.columns):
            continue  # the text of the item above goes on
        else:
            lists.columns = []
            found += (
                (line, at, Named(kind, number, name, line)) for at, kind, number, name in _reversed(text)
            )
    named = [one for each in _in_its_language(lists.all) for one in _named(each, language.has_one_series)]
    found += (
        (item.line, item.at, Named(kind, number, text, item.line))
        for item, kind, text in _without_values(named)
        for number in range(item.number, item.last + 1)
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


def remarks(source: Source, language: Dialect) -> dict[int, tuple[str, str]]:
    """Return the comments behind code that may be names, by line: nouns of a few words, with a number or ""."""
    shown = {line: without_marks(text) for line, text in comments_of(source, language)[1].items()}
    found = ((line, _REMARK.fullmatch(text)) for line, text in shown.items())
    return {
        line: (match[1] or "", match[2])
        for line, match in found
        if match is not None and not _SENTENCE.match(match[2])
    }


def without_marks(comment: str) -> str:
    """Return the text of a comment."""
    return _MARKS.sub("", comment).strip()


def _heading(text: str) -> list[re.Match[str]]:
    """Return the words of a heading, none if the line has anything else."""
    words = list(_HEADING.finditer(text))
    return words if words and not _HEADING.sub("", text).strip(" -=*") else []


def _items(line: int, text: str, filled: Collection[int]) -> list[_Item]:
    """Return the items of a line that has words or begins with a number; below a column one blank is enough.

    In the middle of a text the words look like the one at its start.
    """
    outside = _BRACKETS.sub(lambda brackets: "(" * len(brackets[0]), text)
    ranges = {each.start(): _last(each) for each in _RANGE.finditer(outside)}
    outside = _RANGE.sub(lambda one: one[1].ljust(len(one[0])) if _last(one) else one[0], outside)
    found: list[_Item] = []
    style: bool | None = None
    for match in _ITEM.finditer(outside):
        kind, at = _kind(match), match.start("number")
        start = match.start("item")
        is_upper = outside[start:at].isupper()
        if not (kind or match["name"]) or (kind and match["starts"] is None and is_upper != style):
            continue
        style = is_upper if kind and not found else style
        begins_cell = bool(kind) or match["wide"] is not None or at in filled
        is_loose = not begins_cell and match["starts"] is None
        begin = match.start("name") if match["name"] else len(text)
        number, has_equal = int(match["number"]), match["equal"] is not None
        last = ranges.get(at) or number
        found.append(
            _Item(line, text, start, at, begin, number, last, kind, begins_cell, is_loose, has_equal)
        )
    before = outside[: found[0].start if found else 0].strip()
    is_sentence = _SENTENCE.match(before) and not before.endswith(":")
    if before and (is_sentence or not any(each.kind for each in found)):
        return []
    end = len(text)
    for item in reversed(found):
        item.end, end = end, end if item.is_loose else item.start
    return found


def _last(match: re.Match[str]) -> int:
    """Return the last number of a range or of a list that counts on, 0 for anything else."""
    numbers = [int(each) for each in re.findall(r"\d+", match[0])]
    counts_on = numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    return numbers[-1] if numbers[0] < numbers[-1] and (counts_on or "," not in match[0]) else 0


def _kind(match: re.Match[str]) -> str:
    return next((kind for kind in _WORDS if match.group(kind.replace(" ", "_"))), "")


def _reversed(text: str) -> Iterator[tuple[int, str, int, str]]:
    """Yield offsets, kinds, numbers and names of items whose name comes first."""
    for at, part in enumerate(re.split(r"\s\s+|[,;]", text)):
        match = _REVERSED.fullmatch(part)
        if match is not None and not _SENTENCE.match(match["name"]):
            yield at, _kind(match), int(match["number"]), match["name"]
    yield from ((each.start(), "axis", int(each[2]), each[1]) for each in _LETTER.finditer(text))


def _named(one: _List, has_one_series: bool) -> Iterator[_NamedItem]:
    """Yield the items of a list with their kinds and names.

    A list has equal signs if its last word has one. Without them `1 = automatic` explains a value of the item before
    it. A number that does not ascend begins such an explanation, which ends at the next cell that ascends. With equal
    signs, a number in a cell counts on. Where inputs and outputs have one series, a list without a word that is long
    is one of channels, and a number behind a gap may be that of an output.
    """
    items = _certain(one.items)
    if not one.kind and len(items) < LONG_LIST:
        return
    has_equals = bool(items) and items[0].has_equal
    last = first = line = -1
    explains = has_gap = False
    for item, following in zip_longest(items, items[1:]):
        has_equals = item.has_equal if item.kind else has_equals
        if item.has_equal > has_equals:
            continue
        before = last if item.line == line else first
        is_next = (
            item.number == before + 1 if item.has_equal and not item.begins_cell else item.number > before
        )
        explains = not item.kind and (not is_next or (explains and not item.begins_cell))
        if explains:
            continue
        first = first if item.line == line else item.number
        has_gap = not item.kind and (has_gap or item.number > last + 1 > 0)
        line, last = item.line, item.last
        end = following.start if following is not None and following.is_loose else item.end
        text, kind = item.text[item.begin : end], one.kind or "channel"
        if has_one_series and has_gap and kind == "input":
            kind = "channel"
        if kind == "channel" and _OUT.search(text):
            kind, text = "output", _OUT.sub("", text)
        name = _name(text)
        if name and not _SENTENCE.match(name):
            yield item, kind, shorten(name, MAX_NAME, placeholder="")


def _in_its_language(lists: Iterable[_List]) -> list[_List]:
    """Tell outputs by their letter: E0 has A0 beside it in German (Ausgang), and S0 in French (sortie)."""
    letters = {
        each: one.text[one.start : one.at].strip(" .:#=()[]").upper() if one.kind else ""
        for each in lists
        for one in each.items[:1]
    }
    inputs = {item.number for each in letters if each.kind in ("input", "channel") for item in each.items}
    for each in (one for one in letters if one.kind == "X"):
        each.kind = "input" if inputs.isdisjoint(item.number for item in each.items) else "axis"
    if "E" not in letters.values():
        return [each for each, letter in letters.items() if letter != "S"]
    for each, letter in letters.items():
        if letter == ("S" if "S" in letters.values() else "A"):
            each.kind = "output"
    return list(letters)


def _without_values(named: Iterable[_NamedItem]) -> Iterator[_NamedItem]:
    """Leave out numbers without a word if a word names one of them elsewhere: they are values of the item before."""
    named = list(named)
    certain = {(kind, item.number) for item, kind, _ in named if item.kind}
    for (_, has_word), run in groupby(named, key=lambda one: (one[0].line, bool(one[0].kind))):
        items = list(run)
        if has_word or not any((kind, item.number) in certain for item, kind, _ in items):
            yield from items


def _certain(items: Sequence[_Item]) -> list[_Item]:
    """Return the items of a list without the numbers that are part of a name.

    A loose number begins an item if the list counts on with it up to the next one that is certain; behind the last of
    these, if it does so everywhere before. A list that has counted to its third number may leave out some later on.
    """
    found: list[_Item] = []
    is_style = True
    for begin, end in pairwise([*(k for k, each in enumerate(items) if not each.is_loose), len(items)]):
        numbers = [each.number for each in items[begin : end + 1]]
        steps = [number - before for before, number in pairwise(numbers)]
        counts_on = all(step == 1 for step in steps) or (steps[:2] == [1, 1] and min(steps) > 0)
        is_style &= counts_on and end - begin > 1
        found += items[begin : end if is_style or (counts_on and end < len(items)) else begin + 1]
    return found


def _name(text: str) -> str:
    end = _END.search(text)
    name = (text[: end.start()] if end else text).strip(" .:*").removesuffix(" /").removesuffix(" and")
    if not re.search(r"\w ?[-+]$", name) or (end is not None and text[end.end() :][:1].isdigit()):
        name = name.rstrip(" -")  # "jog -" has its sign
    return name
