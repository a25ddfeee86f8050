"""Completion: keywords, names of the program and blocks, with snippets.

Only the line of the cursor is examined, and the names of the page may come from a text that is a few keystrokes
older.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from motionlang.kernel import Keyword
from motionlang.kernel.lang import Definition, Names
from motionlang_lsp.editor.page import Page

_WORD = re.compile(r"[A-Za-z_]\w*$")
# A command of MCCL with the number of its axis, and the parameter that follows it.
_COMMAND = re.compile(r"(?:^|[,;\s])\d*([A-Za-z]{0,2})$")
_PARAMETER = re.compile(r"(?:^|[,;\s])\d*([A-Za-z]{2})(@?)(\d*)$")
# Words of Mint after which one kind of name follows.
_AFTER = (
    (re.compile(r"\bgo(?:to|sub)\s+#?\w*$", re.IGNORECASE), ("label",)),
    (re.compile(r"\brun\s+\w*$", re.IGNORECASE), ("task",)),
    (re.compile(r"\bas\s+\w*$", re.IGNORECASE), ("type",)),
    (re.compile(r"[\w)\]]\.\w*$"), ("member",)),
)
_TYPES = ("Integer", "Float", "String", "Time", "Semaphore")
# The blocks of Mint. `$1` is where typing goes on, `$0` where it ends.
BLOCKS = {
    "If": "If ${1:condition} Then\n\t$0\nEnd If",
    "For": "For ${1:i} = ${2:1} To ${3:10}\n\t$0\nNext",
    "While": "While ${1:condition}\n\t$0\nEnd While",
    "Repeat": "Repeat\n\t$0\nUntil ${1:condition}",
    "Loop": "Loop\n\t$0\nEnd Loop",
    "Select": "Select Case ${1:value}\nCase ${2:1}\n\t$0\nEnd Select",
    "Sub": "Sub ${1:name}()\n\t$0\nEnd Sub",
    "Function": "Function ${1:name}() As ${2:Float}\n\t$1 = $0\nEnd Function",
    "Task": "Task ${1:name}\n\t$0\nEnd Task",
    "Event": "Event ${1:IN0}\n\t$0\nEnd Event",
}
# The start of a statement: nothing before it on its line but a colon, or what a one-line If has.
_STATEMENT = re.compile(r"(?:^|:|\bthen\b|\belse\b)[ \t]*\w*$", re.IGNORECASE)


@dataclass(eq=False, slots=True)
class Item:
    """One proposal: `text` replaces the span from `start` to the cursor.

    `kind` is a kind of name (`kernel/lang/names.py`), the kind of a keyword's row, or "block". `snippet` is the same
    text with cursor stops, "" if it has none. Items with a lower `rank` come first.
    """

    label: str
    kind: str
    detail: str
    help: str
    start: int
    text: str
    snippet: str
    rank: int


def complete(page: Page, offset: int) -> list[Item]:
    """Return the proposals for the text before an offset.

    There are none in a comment or a string.
    """
    start, end = page.line_of(offset)
    before, after = page.text[start:offset], page.text[offset:end]
    if page.is_prose(offset):
        return []
    if page.language.name == "mccl":
        return list(_commands(page, before, offset, page.names))
    return list(_words(page, before, after, offset, page.names))


def _words(page: Page, before: str, after: str, offset: int, names: Names) -> Iterator[Item]:
    match = _WORD.search(before)
    begun = match[0] if match is not None else ""
    start = offset - len(begun)
    if before[: len(before) - len(begun)].endswith(tuple("0123456789")):
        return  # the end of a number
    kinds = next((kinds for pattern, kinds in _AFTER if pattern.search(before)), None)
    yield from _names(names.visible(offset), begun, start, kinds)
    if kinds is not None:
        if "type" in kinds:
            yield from (
                Item(each, "type", "", "", start, each, "", 1)
                for each in _TYPES
                if each.lower().startswith(begun.lower())
            )
        return
    is_statement = _STATEMENT.search(before) is not None
    is_open = not after[:1].isalnum() and after[:1] not in tuple("([._")
    for name, text in BLOCKS.items():
        if is_statement and is_open and name.lower().startswith(begun.lower()):
            yield Item(name, "block", "block", "", start, _spelt(name, begun), text, 1)
    for row in _rows(page.language.table(), begun):
        name = _spelt(row.name, begun)
        snippet = _call(row, name, is_statement) if is_open else ""
        yield Item(
            row.name, row.kind, _detail(row), row.help, start, name, snippet, 2 if row.simulated else 3
        )


def _names(
    definitions: Iterable[Definition], begun: str, start: int, kinds: tuple[str, ...] | None
) -> Iterator[Item]:
    seen: set[str] = set()
    for each in definitions:
        key = each.name.lower()
        fits = (
            each.kind in kinds if kinds is not None else each.kind not in ("label", "member", "event", "type")
        )
        if not fits or key in seen or not key.startswith(begun.lower()):
            continue
        seen.add(key)
        stops = ", ".join(
            f"${{{i}:{_plain(each.parameters[i - 1])}}}" for i in range(1, len(each.parameters) + 1)
        )
        snippet = f"{each.name}({stops})" if each.parameters else ""
        yield Item(each.name, each.kind, each.text, "", start, each.name, snippet, 0)


def _commands(page: Page, before: str, offset: int, names: Names) -> Iterator[Item]:
    parameter = _PARAMETER.search(before)
    row = page.language.table().get(parameter[1]) if parameter is not None else None
    if parameter is not None and row is not None:
        kind = "register" if parameter[2] else "macro" if row.function in page.language.jumps else ""
        start = offset - len(parameter[3])
        for each in names.definitions:
            if each.kind == kind and each.name.startswith(parameter[3]):
                yield Item(each.name, kind, each.text, "", start, each.name, "", 0)
        return
    command = _COMMAND.search(before)
    if command is None:
        return
    begun = command[1]
    for row in _rows(page.language.table(), begun):
        name = _spelt(row.name, begun)
        text = f'{name}"${{1:text}}"' if row.unit == "text" else f"{name}${{1:n}}"
        snippet = text if row.access == "W" else ""
        rank = 2 if row.simulated else 3
        yield Item(row.name, row.kind, _detail(row), row.help, offset - len(begun), name, snippet, rank)


def _rows(table: Iterable[Keyword], begun: str) -> Iterator[Keyword]:
    upper = begun.upper()
    return (
        row
        for row in table
        if row.name.upper().startswith(upper) or (row.short and row.short.upper() == upper)
    )


def _call(row: Keyword, name: str, is_statement: bool) -> str:
    """Return the snippet of a keyword with its brackets.

    It ends with `=` if the keyword takes a value there.
    """
    text = name
    if row.index not in ("none", ""):
        text += f"(${{1:{'0' if row.index in ('axis', 'axes') else row.index}}})"
    elif row.kind == "function":
        text += "($1)"
    if is_statement and "W" in row.access:
        return f"{text} = $0"
    return text if text != name else ""


def _detail(row: Keyword) -> str:
    unit = f", {row.unit}" if row.unit else ""
    return f"{row.kind}{unit}" if row.simulated else f"{row.kind}, {row.caveat}"


def _plain(parameter: str) -> str:
    return parameter.removeprefix("ByRef ").partition(" ")[0].removesuffix("()")


def _spelt(name: str, begun: str) -> str:
    """Return a name in the case that the user types; both languages accept any case."""
    return name.lower() if begun and begun.islower() else name
