"""The parameters of the call around the cursor."""

from __future__ import annotations

from dataclasses import dataclass

from motionlang.commands.evidence.keyword_facts import INDEX, UNITS
from motionlang_lsp.editor.page import Page

_OPENING, _CLOSING = ("(", "["), (")", "]")


@dataclass(eq=False, slots=True)
class Signature:
    """The text of a call.

    `active` is the index of the parameter at the cursor, -1 if there is none.
    """

    text: str
    help: str
    parameters: list[str]
    active: int


def signature(page: Page, offset: int) -> Signature | None:
    """Return the signature of the innermost open bracket before an offset."""
    start, _ = page.line_of(offset)
    if page.is_prose(offset):
        return None
    opened: list[tuple[str, int]] = []
    before = ""
    for kind, piece, _ in page.language.tokens(page.text[start:offset]):
        if piece in _OPENING:
            opened.append((before, 0))
        elif piece in _CLOSING and opened:
            opened.pop()
        elif piece == "," and opened:
            opened[-1] = opened[-1][0], opened[-1][1] + 1
        before = piece if kind in ("word", "not-simulated") else ""
    if not opened or not opened[-1][0]:
        return None
    name, number = opened[-1]
    own = next((each for each in page.names.visible(offset) if each.name.lower() == name.lower()), None)
    if own is not None:
        if own.kind not in ("sub", "function"):
            return None
        parameters = list(own.parameters)
        return Signature(own.text, "", parameters, number if number < len(parameters) else -1)
    row = page.language.table().get(name)
    if row is None or not INDEX.get(row.index, row.index):
        return None
    what = row.index
    value = f" = {UNITS.get(row.unit, row.unit) or 'value'}" if "W" in row.access else ""
    return Signature(
        f"{row.name}({what}){value}", row.help, [what], 0 if number == 0 or what == "axes" else -1
    )
