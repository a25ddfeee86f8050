"""The mistakes of a program, found without a run: the command check."""

from collections.abc import Mapping
from importlib import import_module

from motionlang.kernel import Diagnostic, Dialect, Source

# The module of each language, which is imported for its programs only.
_LINTERS = {"mint": "mint", "mccl": "mccl.check"}


def check(
    source: Source, language: Dialect, settings: Mapping[str, object] | None = None
) -> list[Diagnostic]:
    """Return all errors of a program and, if it has none, all warnings, without those that a comment silences.

    `settings` are those of the machine file.
    """
    linter = import_module(f"{__name__}.{_LINTERS[language.name]}")
    found: list[Diagnostic] = linter.check(source, settings or {})
    return found
