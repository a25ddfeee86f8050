"""`motionlang pvt` with the interface of the command line, in this process."""

from __future__ import annotations

import contextlib
import io
from dataclasses import dataclass

from motionlang.cli import main


@dataclass(frozen=True, slots=True)
class Answer:
    """Exit status, standard output and standard error."""

    status: int
    out: str
    err: str


def pvt(*words: str) -> Answer:
    """Run `motionlang pvt` with these arguments."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            status = main(["pvt", *words])
        except SystemExit as leaving:
            status = int(leaving.code or 0)
    return Answer(status, out.getvalue(), err.getvalue())
