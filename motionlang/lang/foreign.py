"""A file in the other language: one sentence that says so, instead of a mistake for each of its lines."""

from __future__ import annotations

from motionlang.errors import Diagnostic
from motionlang.lang.dialect import dialect, dialects
from motionlang.source import Source

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.lang.dialect import Dialect

# The least share of wrong lines in a file that is looked at as one in another language, and how many lines must be
# wrong in this language for each that is wrong in the other.
_WRONG = 1 / 3
_TIMES = 4
# As far as this many wrong lines the other language is asked: it tells no more than a hundred mistakes.
_ASKED = 80


def one_sentence(language: Dialect, source: Source, found: Sequence[Diagnostic]) -> list[Diagnostic]:
    """The diagnostics of a file in `language`, or the one that says in which language it is."""
    wrong = _wrong_lines(found)
    if not wrong:
        return list(found)
    # What stands behind the last mistake that is told has not been looked at.
    lines = len([line for line in source.text.split("\n")[: max(wrong)] if line.strip()])
    if len(wrong) < _WRONG * lines:
        return list(found)
    begin = _begin(source, wrong)
    for name in dialects():
        other = dialect(name)
        if other is language:
            continue
        if len(_wrong_lines(other.check(begin))) * _TIMES <= min(len(wrong), _ASKED):
            lost = f"{len(wrong)} of its first {lines} lines make no sense in {language.title}"
            message = f"this is {other.title}, not {language.title}: {lost}"
            hint = f"--dialect {other.name} takes it, and so does a name that ends with {other.suffixes[0]}"
            return [Diagnostic("language", message, hint=hint)]
    return list(found)


def _begin(source: Source, wrong: set[int]) -> Source:
    """The program as far as the last of the wrong lines that the other language is asked about."""
    if len(wrong) <= _ASKED:
        return source
    last = sorted(wrong)[_ASKED - 1]
    return Source(source.name, "\n".join(source.text.split("\n")[:last]))


def _wrong_lines(found: Sequence[Diagnostic]) -> set[int]:
    return {each.line for each in found if each.severity == "error" and each.line}
