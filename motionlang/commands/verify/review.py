"""The question of `motionlang verify --review`."""

from __future__ import annotations

import sys

HELP = """\
y  write the golden files
n  leave the golden files as they are
q  quit, and leave all others as they are, too
"""


class NoAnswer(Exception):
    """Standard input has ended or is missing, so no golden file is written."""


def ask(question: str) -> str:
    """Ask for "y", "n" or "q" on a terminal or a pipe; "?" explains them.

    Raises `NoAnswer` if neither provides an answer.
    """
    while True:
        sys.stdout.write(f"{question} [y,n,q,?] ")
        sys.stdout.flush()
        try:
            line = sys.stdin.readline() if sys.stdin is not None else ""
        except (OSError, ValueError):
            line = ""
        if not line:
            sys.stdout.write("\n")
            raise NoAnswer
        if not sys.stdin.isatty():
            sys.stdout.write(line if line.endswith("\n") else f"{line}\n")  # what a terminal would show
        answer = line.strip().lower()[:1]
        if answer and answer in "ynq":
            return answer
        sys.stdout.write(HELP)
