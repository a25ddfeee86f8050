"""Errors on standard error: diagnostics, and reasons for not running."""

from __future__ import annotations

import os
import sys

from motionlang.source import STDIN, STDIN_NAME, name_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import TextIO

    from motionlang.cli.options import Options
    from motionlang.errors import Diagnostic
    from motionlang.source import Source


def unreadable(file: str, error: OSError) -> Diagnostic:
    """Return the diagnostic of a file that cannot be read."""
    from motionlang.errors import Diagnostic
    from motionlang.files import reason

    return Diagnostic("file", f"{file} cannot be read: {reason(error)}")


def unwritten(file: str, error: OSError) -> Diagnostic:
    """Return the diagnostic of a file that cannot be written."""
    from motionlang.errors import Diagnostic
    from motionlang.files import reason

    return Diagnostic("file", f"{file} cannot be written: {reason(error)}")


def no_dialect(file: str) -> Diagnostic:
    """Return the diagnostic of a file whose extension does not identify its language."""
    from motionlang.errors import Diagnostic

    name = "standard input" if file == STDIN else file
    suffix = os.path.splitext(file)[1]
    what = f"no language has the extension {suffix}" if suffix else "it has no extension"
    if file == STDIN:
        what = "it has no name"
    hint = "add --dialect mint or --dialect mccl; .mnt, .mntx and .prg are Mint, .mcl and .mccl are MCCL"
    return Diagnostic("file", f"unknown language of {name}: {what}", hint=hint)


def complain(
    diagnostics: Sequence[Diagnostic], source: Source | None, file: str, out: TextIO | None = None
) -> None:
    """Print diagnostics after all output so far, by default on standard error."""
    if not diagnostics:
        return
    from motionlang.views.diagnostics import render_all
    from motionlang.views.terminal import wants_colour, width_of

    sys.stdout.flush()
    name = STDIN_NAME if file == STDIN else file
    out = out or sys.stderr
    colour, width = wants_colour(out), width_of(out)
    out.write(render_all(diagnostics, source, name=name, colour=colour, width=width))
    out.flush()


def refuse(
    options: Options,
    diagnostics: Sequence[Diagnostic],
    source: Source | None,
    status: int,
    outcome: str = "fault",
) -> int:
    """Report why nothing was run, also in JSON if requested."""
    if options.report == "json":
        from motionlang.report import failure

        sys.stdout.write(failure(name_of(options.file), options.dialect or "", diagnostics, outcome))
    complain(diagnostics, source, source.name if source is not None else options.file)
    return status
