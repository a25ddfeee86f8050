"""Golden files: the expected result of a program, next to it.

`pick.mnt` has its report in `pick.golden.json` and its printed output in `pick.golden.txt`. Texts must be
equal. Numbers may differ by one part in a billion, so that a different mathematical library causes no failure.
"""

from __future__ import annotations

import json
import os
from collections.abc import Sequence

from motionlang.commands.diff.reports import difference
from motionlang.commands.diff.tolerance import EXACT
from motionlang.commands.diff.view import diff_lines
from motionlang.kernel import Run
from motionlang.kernel.files import replacing
from motionlang.kernel.report import text

MAX_DIFFERENCES = 8


def golden_files(program: str) -> tuple[str, str]:
    """Return the paths of a program's golden report and golden printed output."""
    stem = os.path.splitext(program)[0]
    return f"{stem}.golden.json", f"{stem}.golden.txt"


def differences(program: str, result: Run) -> list[str]:
    """Return how a program's run differs from its golden files.

    Raises OSError if one of them cannot be read, ValueError if it is not a report.
    """
    report, printed = golden_files(program)
    with open(report, encoding="utf-8") as file:
        expected = json.load(file)
    found = diff_lines(difference(expected, json.loads(text(result, whole=False))), most=MAX_DIFFERENCES)
    if os.path.exists(printed) or result.output:
        with open(printed, encoding="utf-8", newline="") as file:
            lines = file.read().replace("\r\n", "\n")  # which Git for Windows writes
        if lines != _lines(result.output).replace("\r\n", "\n") and expected.get("output") == result.output:
            found.append(f"the printed output differs from {os.path.basename(printed)}")
    return found


def update(program: str, result: Run) -> bool:
    """Rewrite a program's golden files if the run differs.

    Returns True if they were rewritten. An OSError names the file.
    """
    try:
        if not differences(program, result):
            return False
    except (OSError, ValueError):
        pass  # A file is missing or is not JSON.
    _write(program, text(result, whole=False), result.output)
    return True


def _write(program: str, report: str, output: Sequence[str]) -> None:
    """Write both golden files of a program, or neither; an OSError names the file."""
    path, printed = golden_files(program)
    with replacing(path, only_copy=True) as file:
        file.write(report.encode())
        file.flush()  # it is on the disk before the other one exists
        os.fsync(file.fileno())
        if output:
            with replacing(printed, only_copy=True) as other:
                other.write(_lines(output).encode())
        elif os.path.exists(printed):
            os.remove(printed)


def _lines(output: Sequence[str]) -> str:
    return "".join(line + "\n" for line in output)


def same(expected: object, found: object) -> bool:
    """True if two values are equal, figures within a billionth."""
    return EXACT.same(expected, found)
