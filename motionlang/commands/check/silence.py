"""Common code of the linters: their warnings, and comments that silence them.

`lint: ignore` in a comment silences every warning of its line, `lint: ignore code, code` the listed ones. A
comment on its own line applies to the line below it. Errors cannot be silenced.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from motionlang.kernel import CODES, Diagnostic, Source
from motionlang.kernel.tools import nearest

# Every warning of a linter, with the languages it applies to; `docs/lint.md` has a paragraph for each.
WARNINGS: dict[str, str] = {
    "never-started": "Mint",
    "nothing-loaded": "Mint, MCCL",
    "in-motion": "Mint",
    "exact-position": "Mint, MCCL",
    "scale-in-motion": "Mint",
    "scale-after-speed": "Mint",
    "time-before-speed": "Mint",
    "short-ramp": "Mint",
    "unused-setting": "Mint",
    "blend-distance": "Mint",
    "zero-speed": "Mint",
    "zero-acceleration": "Mint",
    "never-waits": "Mint, MCCL",
    "buffer-overfilled": "Mint",
    "beyond-travel": "Mint",
    "two-tasks": "Mint",
    "endless-wait": "Mint, MCCL",
    "wait-condition": "Mint",
    "endless-loop": "Mint, MCCL",
    "busy-loop": "Mint",
    "constant-condition": "Mint",
    "mixed-operators": "Mint",
    "unreachable": "Mint, MCCL",
    "unused-label": "Mint",
    "unused-variable": "Mint",
    "no-value": "Mint",
    "unused-sub": "Mint",
    "unused-task": "Mint",
    "no-connection": "Mint",
    "not-simulated": "Mint, MCCL",
    "wrong-channel": "MCCL",
    "motor-off": "MCCL",
    "nothing-to-wait-for": "MCCL",
    "still-running": "MCCL",
    "unknown-word": "MCCL",
    "silenced": "Mint, MCCL",
}
_HOST = re.compile(r"lint:\s*host\b", re.IGNORECASE)
_IGNORE = re.compile(r"lint:\s*ignore\b[ \t]*([\w ,-]*)", re.IGNORECASE)


def driven_inputs(settings: Mapping[str, object]) -> set[int] | None:
    """Return the digital inputs driven by a machine file; None without a file.

    Without a file every input may change.
    """
    if all(key.startswith(("controller.", "run.")) for key in settings):
        return None
    found: set[int] = {entry["channel"] for entry in settings.get("input", ())}  # type: ignore[attr-defined]
    return found | {value for key, value in settings.items() if key.endswith("_input")}  # type: ignore[misc]


def has_host(source: Source, comment: re.Pattern[str]) -> bool:
    """True if a comment has `lint: host`.

    A host then reads and writes the global variables of the program.
    """
    if "lint:" not in source.text.lower():
        return False
    found = ((line, comment.search(line)) for line in source.text.split("\n") if "lint:" in line.lower())
    return any(begin is not None and _HOST.search(line, begin.end()) for line, begin in found)


def silence(source: Source, found: Iterable[Diagnostic], comment: re.Pattern[str]) -> list[Diagnostic]:
    """Return the diagnostics without those that a comment silences.

    A comment with an unknown code adds a diagnostic. `comment` matches a line up to the beginning of a
    comment of the language; the comment is its group 1.
    """
    found = list(found)
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
        found += [_unknown(code, number, match.start(1) + 1) for code in sorted(codes - WARNINGS.keys())]
        below = not line[: begin.start(1)].strip()
        ignored.setdefault(number + below, set()).update(codes or {""})
    return [each for each in found if not _is_ignored(each, ignored.get(each.line, set()))]


def _is_ignored(diagnostic: Diagnostic, codes: set[str]) -> bool:
    return diagnostic.severity == "warning" and ("" in codes or diagnostic.code in codes)


def _unknown(code: str, line: int, column: int) -> Diagnostic:
    near = nearest(code, WARNINGS)
    hint = f"did you mean {near}?" if near else "docs/lint.md lists all warnings"
    message = f"there is no warning {code}"
    if code in CODES:
        message, hint = f"{code} is an error and cannot be ignored", ""
    return Diagnostic("silenced", message, line, column, length=len(code), hint=hint, severity="warning")
