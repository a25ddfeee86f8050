"""Programs for the tests of the command line, which runs in this process."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from motionlang.cli import main
from motionlang.cli.commands import build_parser

# AN00115's ball screw in MCCL: 1200 counts/mm, 250 mm/s, 1250 mm/s², 200 mm.
BALLSCREW = "1US1200\n1MN,1PM,1PT\n1SV250,1SA1250,1DS1250\n1MR200,1WS0\n1TP\n"
WRONG = "1MN\n1XX3\n2MR10\n"
# Seconds of real time for a process to end: a loaded machine may stall, and normally no test waits.
MAX_SECONDS = 300
JOG = "1MN,1VM,1SV100,1GO\n"

# A move whose rate and length are constants.
STROKE = """\
Const rate = 1000
Const length = 100
SPEED(0) = 200 : ACCEL(0) = rate : DECEL(0) = rate
MOVER(0) = length : GO(0) : PAUSE IDLE(0)
PRINT "there"
"""

# The parser of a command, which parsing does not change. Building one takes 2 ms.
parser_of = cache(build_parser)


class Outcome:
    """The output of a command, and its exit status."""

    def __init__(self, status: int, out: str, err: str) -> None:
        self.status, self.out, self.err = status, out, err


class Cell:
    """A folder with programs, in which commands are run."""

    def __init__(self, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
        self.folder, self._capsys = folder, capsys

    def write(self, name: str, text: str | bytes) -> Path:
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def __call__(self, *arguments: str) -> Outcome:
        try:
            status = main(arguments)
        except SystemExit as end:
            status = int(end.code or 0)
        out, err = self._capsys.readouterr()
        return Outcome(status, out, err)


def all_parsers(parser: argparse.ArgumentParser) -> Iterator[argparse.ArgumentParser]:
    """Yield a parser and those of its commands."""
    yield parser
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for each in action.choices.values():
                yield from all_parsers(each)


ALL = list(all_parsers(build_parser("*")))
