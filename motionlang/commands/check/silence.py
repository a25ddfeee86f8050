"""Comments that silence warnings, or that name a host.

`lint: ignore` in a comment silences every warning of its line, `lint: ignore code, code` the listed ones. A
comment on its own line applies to the line below it. Errors cannot be silenced.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from motionlang.commands.check.rules import RULES
from motionlang.kernel import CODES, Diagnostic, Source
from motionlang.kernel.mccl import COMMENT
from motionlang.kernel.tools import nearest

# A line up to the beginning of a comment, which is group 1. An apostrophe inside a string of Mint begins none.
_COMMENTS = {
    "mint": re.compile(r"""^(?:[^'"\n]|"[^"\n]*")*?('|(?<![\w.])rem)""", re.IGNORECASE),
    "mccl": COMMENT,
}
_HOST = re.compile(r"lint:\s*host\b", re.IGNORECASE)
_IGNORE = re.compile(r"lint:\s*ignore\b[ \t]*([\w ,-]*)", re.IGNORECASE)


def has_host(source: Source, language: str) -> bool:
    """True if a comment has `lint: host`.

    A host then reads and writes the global variables, or the registers, of the program.
    """
    if "lint:" not in source.text.lower():
        return False
    found = (
        (line, _COMMENTS[language].search(line))
        for line in source.text.split("\n")
        if "lint:" in line.lower()
    )
    return any(begin is not None and _HOST.search(line, begin.end()) for line, begin in found)


def silence(source: Source, found: Iterable[Diagnostic], language: str) -> list[Diagnostic]:
    """Return the diagnostics without those that a comment silences.

    A comment with an unknown code adds a diagnostic.
    """
    found, comment = list(found), _COMMENTS[language]
    if "lint:" not in source.text.lower():
        return found
    ignored: dict[int, set[str]] = {}
    for number, line in source.numbered():
        if "lint:" not in line.lower():
            continue
        begin = comment.search(line)
        match = _IGNORE.search(line, begin.end()) if begin is not None else None
        if begin is None or match is None:
            continue
        codes = {code for code in re.split(r"[\s,]+", match[1].strip().lower()) if code}
        found += [_unknown(code, number, match.start(1) + 1) for code in sorted(codes - RULES.keys())]
        below = not line[: begin.start(1)].strip()
        ignored.setdefault(number + below, set()).update(codes or {""})
    return [each for each in found if not _is_ignored(each, ignored.get(each.line, set()))]


def _is_ignored(diagnostic: Diagnostic, codes: set[str]) -> bool:
    return diagnostic.severity == "warning" and ("" in codes or diagnostic.code in codes)


def _unknown(code: str, line: int, column: int) -> Diagnostic:
    near = nearest(code, RULES)
    hint = f"did you mean {near}?" if near else "docs/diagnostics.md lists all warnings"
    message = f"there is no warning {code}"
    if code in CODES:
        message, hint = f"{code} is an error and cannot be ignored", ""
    return Diagnostic("silenced", message, line, column, length=len(code), hint=hint, severity="warning")
