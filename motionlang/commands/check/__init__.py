"""The mistakes of a program, found without a run: the command check."""

from collections.abc import Mapping

from motionlang.commands.check import mint
from motionlang.commands.check.mccl.check import check as check_mccl
from motionlang.kernel import Diagnostic, Dialect, Source

_LINTERS = {"mint": mint.check, "mccl": check_mccl}


def check(
    source: Source, language: Dialect, settings: Mapping[str, object] | None = None
) -> list[Diagnostic]:
    """Return all errors of a program and, if it has none, all warnings, without those that a comment silences.

    `settings` are those of the machine file.
    """
    return _LINTERS[language.name](source, settings or {})
