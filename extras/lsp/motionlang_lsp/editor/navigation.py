"""Definitions, references, renaming, symbols and folding ranges of a text."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from motionlang.kernel.lang import Span
from motionlang_lsp.editor.fixes import SpanEdit
from motionlang_lsp.editor.page import Page

# The kinds of blocks that are symbols, and those of definitions outside them that are.
_NAMED = frozenset(("sub", "function", "task", "event", "type", "macro", "startup"))
_LISTED = frozenset(("constant", "define", "variable", "label", "member"))


class RenameRefused(Exception):
    """A name cannot be changed; the message has the reason."""


@dataclass(eq=False, slots=True)
class OutlineEntry:
    """An entry of the outline.

    `span` is its whole text, `at` its name, and `inner` the entries that it contains.
    """

    name: str
    kind: str
    detail: str
    span: Span
    at: Span
    inner: list[OutlineEntry]


def definition(page: Page, offset: int) -> Span | None:
    """Return the span of the name in its declaration."""
    found = page.names.at(offset)
    return None if found is None else found[0].span


def references(page: Page, offset: int, declaration: bool = True) -> list[Span]:
    """Return all uses of the name at an offset, with or without its declaration."""
    found = page.names.at(offset)
    if found is None:
        return []
    return [span for span in found[0].uses if declaration or span != found[0].span]


def renamed_span(page: Page, offset: int) -> tuple[Span, str]:
    """Return span and text of the name at an offset; raise Refused if it is fixed."""
    found = page.names.at(offset)
    if found is None:
        word = page.keyword(offset)
        raise RenameRefused("there is no name here" if word is None else f"{word[0].name} is a keyword")
    if found[0].fixed:
        raise RenameRefused(found[0].fixed)
    return found[1], page.text[found[1][0] : found[1][1]]


def rename(page: Page, offset: int, name: str) -> list[SpanEdit]:
    """Return the edits that rename all uses of the name at an offset.

    Raises Refused with the reason if the meaning of the program would change.
    """
    renamed_span(page, offset)
    if not page.names.complete:
        raise RenameRefused("the text has lines that cannot be read; correct them first")
    found = page.names.at(offset)
    assert found is not None
    problem = page.names.problem(found[0], name)
    if problem:
        raise RenameRefused(problem)
    return [SpanEdit(span, name) for span in found[0].uses]


def symbols(page: Page) -> list[OutlineEntry]:
    """Return the outline of a program: named blocks and declarations."""
    top: list[OutlineEntry] = []
    opened: list[OutlineEntry] = []

    def add(symbol: OutlineEntry) -> None:
        while opened and opened[-1].span[1] < symbol.span[1]:
            opened.pop()
        (opened[-1].inner if opened else top).append(symbol)
        opened.append(symbol)

    for symbol in sorted(_symbols(page), key=lambda each: each.span[0]):
        add(symbol)
    return top


def _symbols(page: Page) -> Iterator[OutlineEntry]:
    details = {each.span: each for each in page.names.definitions if each.span is not None}
    for block in page.names.blocks:
        if block.kind in _NAMED:
            own = details.get(block.at)
            name = block.name or block.kind.capitalize()
            detail = ", ".join(own.parameters) if own is not None else ""
            yield OutlineEntry(name, block.kind, detail, block.span, block.at, [])
    for each in page.names.definitions:
        if each.kind in _LISTED and each.span is not None:
            yield OutlineEntry(each.name, each.kind, each.type, each.span, each.span, [])


def folds(page: Page) -> list[tuple[int, int, bool]]:
    """Return the first and last line of each block and comment, counted from 1.

    The third value is True for a comment.
    """
    position_of = page.source.location
    found = []
    for block in page.names.blocks:
        first, last = position_of(block.span[0])[0], position_of(block.span[1])[0]
        found.append((first, last - 1, False))  # the closing line stays visible
    begin = 0
    for number, line in enumerate([*page.text.split("\n"), ""], 1):
        is_comment = bool(line.strip()) and not page.language.has_code(line)
        if is_comment:
            begin = begin or number
            continue
        if begin:
            found.append((begin, number - 1, True))
        begin = 0
    return sorted(each for each in found if each[1] > each[0])
