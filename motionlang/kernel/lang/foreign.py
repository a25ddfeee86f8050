"""Detection of a text in the other language, to report it in a single diagnostic."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.lang.dialect import Dialect, dialect, dialects
from motionlang.kernel.source import Source

# The least share of wrong lines in a file that is checked against the other language, and how many lines must
# be wrong in this language for each that is wrong in the other.
_WRONG = 1 / 3
_TIMES = 4
# The number of wrong lines checked against the other language, which reports at most a hundred errors.
_MAX_CHECKED = 80
# The hints on the command line, at the prompt and in an editor.
IN_COMMAND = "add --lang {name}, or rename the file to {suffix}"
AT_PROMPT = ".{name} switches the prompt to {title}"
IN_EDITOR = "choose {title} as the language, or rename the file to {suffix}"


def one_sentence(
    language: Dialect, source: Source, found: Sequence[Diagnostic], hint: str = IN_COMMAND
) -> list[Diagnostic]:
    """Return the diagnostics of a text, or a single one that names its real language, with a hint."""
    wrong = _wrong_lines(found)
    if not wrong:
        return list(found)
    # The text after the last reported error has not been checked.
    lines = len([line for number, line in source.numbered() if number <= max(wrong) and line.strip()])
    if len(wrong) < _WRONG * lines:
        return list(found)
    begin = _begin(source, wrong)
    for name in dialects():
        other = dialect(name)
        if other is language:
            continue
        if len(_wrong_lines(other.program(begin).errors)) * _TIMES <= min(len(wrong), _MAX_CHECKED):
            message = f"this is {other.title}, not {language.title}"
            if hint != AT_PROMPT:
                message += f": {len(wrong)} of its first {lines} lines are not {language.title}"
            how = hint.format(name=other.name, title=other.title, suffix=other.suffixes[0])
            return [Diagnostic("language", message, hint=how)]
    return list(found)


def _begin(source: Source, wrong: set[int]) -> Source:
    """Return the program up to the last wrong line; this part is checked as the other."""
    if len(wrong) <= _MAX_CHECKED:
        return source
    last = sorted(wrong)[_MAX_CHECKED - 1]
    begin = "\n".join(line for number, line in source.numbered() if number <= last)
    return Source(source.name, begin, source.before)


def _wrong_lines(found: Sequence[Diagnostic]) -> set[int]:
    return {each.line for each in found if each.severity == "error" and each.line}
