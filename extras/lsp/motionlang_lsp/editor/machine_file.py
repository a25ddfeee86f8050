"""Completion and hover in a machine file, from the table of its keys."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from motionlang.kernel import Source, dialect, dialects
from motionlang.kernel.lang import CHOICES, KEYS, REQUIRED, TABLES, generic
from motionlang.kernel.servo import KEYS as SERVO_KEYS
from motionlang_lsp.editor.completion import Item
from motionlang_lsp.editor.hover import Hover

_HEADER = re.compile(r"\s*(\[\[?)\s*([^\]]*?)\s*\]")
_KEY = re.compile(r"""\s*([\w.\-"' ]*?)\s*=""")
_TYPED = re.compile(r"[\w.]*$")
# A longer choice, such as that of a model, is left to the completion of its value.
_MAX_SHOWN = 8
# What a value of each kind is, in words.
_KINDS = {
    "text": "a text", "count": "a whole number of at least 1", "number": "a number", "flag": "true or false",
    "positive": "a positive number", "percentage": "a percentage, -100 to 100",
    "level": "0 or 1", "time": "a time in seconds", "pair": "two numbers in brackets",
    "channel": "the number of a channel", "port": "a port, 1 to 8", "node": "a node, 0 to 255", "bus": "a bus, 1 or 2",
}  # fmt: skip


@dataclass(eq=False, slots=True)
class _Row:
    """A key of a section; `choices` are its values if they are limited."""

    name: str
    kind: str
    help: str
    choices: tuple[object, ...]

    @property
    def detail(self) -> str:
        if self.choices and len(self.choices) <= _MAX_SHOWN:
            return f"one of {', '.join(map(str, self.choices))}"
        return _KINDS.get(self.kind, "")


def complete_machine_file(source: Source, offset: int) -> list[Item]:
    """Return the sections, keys or values that can follow the text before an offset."""
    before = source.text[:offset].rpartition("\n")[2]
    if _code(before) != before:
        return []
    header = re.match(r"\s*(\[\[?)([\w.]*)$", before)
    if header is not None:
        return list(_headers(header[1], header[2], offset))
    section, is_table = _section(source, offset)
    value = _KEY.match(before)
    if value is not None:
        row = _row(section, is_table, value[1].strip())
        return [] if row is None else list(_values(row, before[value.end() :], offset))
    typed = _TYPED.search(before)
    assert typed is not None  # it may be empty
    if before[: typed.start()].strip():
        return []
    return list(_keys(_rows(section, is_table), typed[0], offset))


def _keys(rows: Iterable[_Row], typed: str, offset: int) -> Iterator[Item]:
    number = re.match(r"axis\.(\d+)", typed)
    axis = number[1] if number is not None else "0"
    for row in rows:
        name = row.name.replace("axis.N.", f"axis.{axis}.")
        if name.startswith(typed) and not name.rpartition(".")[2].isupper():  # KEYWORD stands for any
            yield Item(name, "setting", row.detail, row.help, offset - len(typed), f"{name} = ", "", 0)


def hover_machine_file(source: Source, offset: int) -> Hover | None:
    """Return the meaning, unit and default of the key in the line of an offset."""
    before = source.text[:offset].rpartition("\n")[2]
    start = offset - len(before)
    line = before + source.text[offset:].partition("\n")[0]
    key = _KEY.match(_code(line))
    if key is None or offset > start + key.end(1):
        return None
    section, is_table = _section(source, offset)
    row = _row(section, is_table, key[1].strip())
    if row is None:
        return None
    name = f"[[{section}]] {row.name}" if is_table else ".".join(filter(None, (section, key[1].strip())))
    required = " · required" if is_table and row.name in REQUIRED[section] else ""
    about = f" · {row.detail}" if row.detail else ""
    return Hover(f"**{name}**{about}{required}\n\n{row.help}", (start + key.start(1), start + key.end(1)))


def _code(line: str) -> str:
    found = re.match(r"""(?:[^#"']|"[^"]*"?|'[^']*'?)*""", line)
    return "" if found is None else found[0]


def _section(source: Source, offset: int) -> tuple[str, bool]:
    """Return the section header above an offset, and True if it heads a list entry."""
    for line in reversed(source.text[:offset].split("\n")[:-1]):
        header = _HEADER.match(_code(line))
        if header is not None:
            return header[2], header[1] == "[["
    return "", False


def _row(section: str, is_table: bool, key: str) -> _Row | None:
    rows = _rows(section, True) if is_table else _all()
    wanted = key if is_table or not section else f"{section}.{key}"
    return next((row for row in rows if row.name == generic(wanted)), None)


def _rows(section: str, is_table: bool) -> Iterator[_Row]:
    if is_table:
        for name, (kind, help) in TABLES.get(section, {}).items():
            yield _Row(name, kind, help, CHOICES.get(kind, ()))
        return
    # `axis.3.` is spelt `axis.N.` in the tables if a key follows.
    begin = generic(f"{section}.x")[:-1] if section else ""
    for row in _all():
        if row.name.startswith(begin):
            yield _Row(row.name[len(begin) :], row.kind, row.help, row.choices)


def _all() -> Iterator[_Row]:
    """Yield all plain keys, and those of a simulated motor with their defaults."""
    for name, (kind, help) in KEYS.items():
        models = [each for language in dialects() for each in dialect(language).models()]
        choices = tuple(models) if name == "controller.model" else CHOICES.get(kind, ())
        yield _Row(name, kind, help, choices)
    for name, key in SERVO_KEYS.items():
        default = str(key.default).lower() if key.kind == "flag" else f"{key.default}"
        choices = key.choices or CHOICES.get(key.kind, ())
        yield _Row(name, key.kind, f"{key.help} Default {default}.", choices)


def _headers(opening: str, typed: str, offset: int) -> Iterator[Item]:
    if opening == "[[":
        for name in TABLES:
            if name.startswith(typed):
                yield Item(f"[[{name}]]", "type", "entries", "", offset - len(typed), f"{name}]]", "", 0)
        return
    number = re.match(r"axis\.(\d+)", typed)
    axis = number[1] if number is not None else "0"
    sections = dict.fromkeys(row.name.rpartition(".")[0].replace(".N", f".{axis}") for row in _all())
    for name in sections:
        if name.startswith(typed):
            yield Item(f"[{name}]", "type", "", "", offset - len(typed), f"{name}]", "", 0)


def _values(row: _Row, typed: str, offset: int) -> Iterator[Item]:
    """Yield the values of a choice; texts get quotation marks."""
    begun = typed.strip().lstrip('"')
    start = offset - len(typed.lstrip())
    for each in row.choices:
        if str(each).startswith(begun):
            plain = not isinstance(each, str) or each in CHOICES["flag"]
            yield Item(str(each), "constant", "", "", start, str(each) if plain else f'"{each}"', "", 0)
