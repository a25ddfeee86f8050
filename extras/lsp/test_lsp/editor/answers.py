"""What an editor shows of generated programs, as texts, which `tests/generated/results.txt` has the digests of."""

from __future__ import annotations

from collections.abc import Iterator

from motionlang.kernel import Source, dialect, read_machine
from motionlang_lsp.editor import navigation
from motionlang_lsp.editor.completion import complete
from motionlang_lsp.editor.diagnostics import findings
from motionlang_lsp.editor.fixes import fixes
from motionlang_lsp.editor.formatting import format
from motionlang_lsp.editor.hover import hover
from motionlang_lsp.editor.machine_file import complete_machine_file, hover_machine_file
from motionlang_lsp.editor.page import Page
from motionlang_lsp.editor.signature import signature
from motionlang_lsp.editor.tokens import tokens
from tests.generated.draw import Draw
from tests.generated.motion import Generated


def answers(program: Generated, text: str) -> str:
    """Return the answers to an editor's requests, for a text on the machine of a program."""
    settings = read_machine(Source("a.machine.toml", program.machine_file))
    page = Page(Source(program.name, text), dialect(program.language), settings)
    return "".join(f"{line}\n" for line in _answers(page, Draw(program.seed)))


def _answers(page: Page, draw: Draw) -> Iterator[object]:
    """Yield the answers to an editor's requests, some of them at random positions."""
    found = findings(page)
    for each in found:
        yield each.line, each.column, each.length, each.code, each.message, each.hint
        yield from (_fields(fix) for fix in fixes(page, each))
    yield from (_fields(symbol) for symbol in navigation.symbols(page))
    yield navigation.folds(page)
    laid_out = page.text
    for edit in reversed(format(page, "    ")):
        begin, end = edit.span
        laid_out = laid_out[:begin] + edit.text + laid_out[end:]
    yield from laid_out.split("\n")
    yield list(tokens(page))
    for _ in range(8):
        offset = draw.randrange(len(page.text) + 1)
        yield (
            offset,
            navigation.definition(page, offset),
            navigation.references(page, offset, draw.chance(0.5)),
        )
        yield _fields(hover(page, offset)), _fields(signature(page, offset))
        try:
            yield [_fields(edit) for edit in navigation.rename(page, offset, "feed")]
        except navigation.RenameRefused as reason:
            yield str(reason)
        if draw.chance(0.15):
            yield [_fields(item) for item in complete(page, offset)]


def machine_file_answers(text: str, draw: Draw) -> str:
    """Return what an editor shows at six positions of a machine file."""
    source, found = Source("a.machine.toml", text), []
    for _ in range(6):
        offset = draw.randrange(len(text) + 1)
        shown = _fields(hover_machine_file(source, offset)), _fields(complete_machine_file(source, offset))
        found.append(f"{offset} {shown}\n")
    return "".join(found)


def _fields(value: object) -> object:
    """Return a record as a tuple of its fields; nested records become tuples, too."""
    if isinstance(value, list):
        return [_fields(each) for each in value]
    slots = getattr(type(value), "__slots__", None)
    return value if slots is None else tuple(_fields(getattr(value, name)) for name in sorted(slots))
