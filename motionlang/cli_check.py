"""`motionlang check`: every mistake of every file, nothing run."""

from __future__ import annotations

import json
import sys
from typing import TYPE_CHECKING

from motionlang.cli_run import complain, no_dialect, read_source, unreadable
from motionlang.execution import dialect, dialect_of
from motionlang.views.diagnostics import tally

if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.errors import Diagnostic
    from motionlang.source import Source

SCHEMA = "motionlang.check/1"


def check_command(files: Sequence[str], dialect_name: str | None, as_json: bool) -> int:
    """Check files; diagnostics go to standard error, a line a file to standard output; 1 if any has an error."""
    rows: list[dict[str, object]] = []
    wrong = False
    for file in files:
        language, source, diagnostics = _check(file, dialect_name)
        wrong = wrong or any(each.severity == "error" for each in diagnostics)
        complain(diagnostics, source, file)
        found = [each.as_dict() for each in diagnostics]
        rows.append({"program": file, "dialect": language, "diagnostics": found})
        if not as_json:
            sys.stdout.write(f"{file}: {tally(diagnostics) or 'no mistakes'}\n")
    if as_json:
        sys.stdout.write(json.dumps({"schema": SCHEMA, "files": rows}, indent=1) + "\n")
    return 1 if wrong else 0


def _check(file: str, name: str | None) -> tuple[str, Source | None, list[Diagnostic]]:
    language = dialect(name) if name is not None else dialect_of(file)
    if language is None:
        return "", None, [no_dialect(file)]
    try:
        source = read_source(file)
    except OSError as error:
        return language.name, None, [unreadable(file, error)]
    return language.name, source, language.check(source)
