"""`motionlang pvt` with the interface of the command line, in this process."""

from __future__ import annotations

import contextlib
import io
from dataclasses import dataclass

from motionlang.cli.parser import Parser
from motionlang.cli.pvt import add_parser


@dataclass(frozen=True, slots=True)
class Answer:
    """Exit status, standard output and standard error."""

    status: int
    out: str
    err: str


def pvt(*words: str) -> Answer:
    """Run `motionlang pvt` with these arguments."""
    parser = Parser(prog="motionlang")
    add_parser(parser.add_subparsers(), "moves for drives")
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            args = parser.parse_args(["pvt", *words])
            status = int(args.command(args))
        except SystemExit as leaving:
            status = int(leaving.code or 0)
    return Answer(status, out.getvalue(), err.getvalue())
