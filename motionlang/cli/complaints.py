"""Errors on standard error: diagnostics, and reasons for not running."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from errno import ENOENT
from typing import TYPE_CHECKING, TextIO

from motionlang.kernel import STDIN, STDIN_NAME, Diagnostic, Source
from motionlang.kernel.failures import failed_events, failures, located
from motionlang.kernel.files import reason
from motionlang.views.diagnostics import render_all
from motionlang.views.terminal import printable, wants_colour, width_of

if TYPE_CHECKING:
    from motionlang.kernel import Run


def unreadable(file: str, error: OSError) -> Diagnostic:
    """Return the diagnostic of a file that cannot be read."""
    return Diagnostic("file", f"{file} cannot be read: {reason(error)}")


def unwritten(file: str, error: OSError) -> Diagnostic:
    """Return the diagnostic of a file that cannot be written."""
    return Diagnostic("file", f"{file} cannot be written: {reason(error)}")


def no_dialect(file: str) -> Diagnostic:
    """Return the diagnostic of a file whose extension does not identify its language, or that does not exist."""
    if os.path.isdir(file):
        return Diagnostic("file", f"no programs in {file}")
    if file != STDIN and not os.path.lexists(file):
        return unreadable(file, FileNotFoundError(ENOENT, os.strerror(ENOENT)))
    name = "standard input" if file == STDIN else file
    suffix = os.path.splitext(file)[1]
    what = f"no language has the extension {suffix}" if suffix else "it has no extension"
    if file == STDIN:
        what = "it has no name"
    hint = "add --lang mint or --lang mccl; .mnt, .mntx and .prg are Mint, .mcl and .mccl are MCCL"
    return Diagnostic("file", f"unknown language of {name}: {what}", hint=hint)


def complain(
    diagnostics: Sequence[Diagnostic], source: Source | None, file: str, out: TextIO | None = None
) -> None:
    """Print diagnostics after all output so far, by default on standard error."""
    if not diagnostics:
        return

    sys.stdout.flush()
    name = STDIN_NAME if file == STDIN else file
    out = out or sys.stderr
    colour, width = wants_colour(out), width_of(out)
    out.write(render_all(diagnostics, source, name=name, colour=colour, width=width))
    out.flush()


def run_status(run: Run, allowed: frozenset[str]) -> int:
    """Report the events of a run that are not allowed; return its exit status, 0 for a good run."""
    for each in failed_events(run, allowed):
        sys.stderr.write(f"{printable(f'{located(each, run)}; {each.hint}')}\n")
    return 1 if failures(run, allowed) else 0
