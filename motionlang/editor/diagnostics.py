"""The diagnostics of a text: those of `check`, and those of a machine file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.errors import ProgramError
from motionlang.lang.foreign import one_sentence
from motionlang.lang.machine.axes import missing_axes
from motionlang.lang.machine.file import read_machine
from motionlang.lang.machine.machine import DEFAULT_AXES

if TYPE_CHECKING:
    from motionlang.editor.page import Page
    from motionlang.errors import Diagnostic
    from motionlang.lang.dialect import Dialect
    from motionlang.source import Source


def findings(page: Page, known: dict[object, object] | None = None) -> list[Diagnostic]:
    """Return the diagnostics of a program, as `check` reports them.

    `known` is as in `Dialect.check`.
    """
    found = page.language.check(page.source, page.settings, known)
    return one_sentence(page.language, page.source, found)


def settings_of(machine: Source, language: Dialect | None) -> tuple[dict[str, object], list[Diagnostic]]:
    """Return the settings of a machine file and its diagnostics.

    The settings are empty if there is a diagnostic. Axes are checked if the language is known.
    """
    try:
        settings = read_machine(machine)
    except ProgramError as error:
        return {}, error.diagnostics
    if language is None:
        return settings, []
    axes = settings.get("controller.axes", DEFAULT_AXES)
    assert isinstance(axes, int)
    wrong = missing_axes(settings, axes, language.first_axis)
    return ({}, wrong) if wrong else (settings, [])
