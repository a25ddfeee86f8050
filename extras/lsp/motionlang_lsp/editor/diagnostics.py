"""The diagnostics of a text: those of `check`, and those of a machine file."""

from __future__ import annotations

from motionlang.commands.check import check
from motionlang.kernel import (
    DEFAULT_AXES,
    Diagnostic,
    Dialect,
    ProgramError,
    Source,
    missing_axes,
    read_machine,
)
from motionlang.kernel.lang import IN_EDITOR, one_sentence
from motionlang_lsp.editor.page import Page

# The character in place of one that could not be decoded.
_UNKNOWN = "\ufffd"


def findings(page: Page) -> list[Diagnostic]:
    """Return the diagnostics of a program, as `check` reports them."""
    found = check(page.program)
    return decoded(page.source, one_sentence(page.language, page.source, found, IN_EDITOR))


def decoded(source: Source, found: list[Diagnostic], code: str = "syntax") -> list[Diagnostic]:
    """Add one diagnostic for all characters that an editor could not decode.

    An editor that opens a file in the wrong encoding replaces such characters by U+FFFD.
    """
    first = source.text.find(_UNKNOWN)
    if first < 0:
        return found
    count = source.text.count(_UNKNOWN)
    many = "1 character has" if count == 1 else f"{count} characters have"
    line, column = source.location(first)
    wrong = Diagnostic(
        code,
        f"{many} been lost: the editor has opened this file in a wrong encoding",
        line,
        column,
        hint="open it again in its own encoding, such as Windows-1252 for an old file; saving it now loses them",
    )
    others = [each for each in found if source.line(each.line)[each.column - 1 : each.column] != _UNKNOWN]
    return [wrong, *others]


def settings_of(machine: Source, language: Dialect | None) -> tuple[dict[str, object], list[Diagnostic]]:
    """Return the settings of a machine file and its diagnostics.

    The settings are empty if there is a diagnostic. Axes are checked if the language is known.
    """
    try:
        settings = read_machine(machine, language=language)
    except ProgramError as error:
        return {}, error.diagnostics
    if language is None:
        return settings, []
    axes = settings.get("controller.axes", DEFAULT_AXES)
    assert isinstance(axes, int)
    wrong = missing_axes(settings, axes, language.first_axis)
    return ({}, wrong) if wrong else (settings, [])
