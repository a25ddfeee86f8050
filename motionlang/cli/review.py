"""`motionlang verify --review`: the changes of a program one by one, and golden files that have the accepted ones."""

from __future__ import annotations

import json
import os
import sys
from typing import TYPE_CHECKING

from motionlang.analysis.diff.accept import changes, merged
from motionlang.analysis.diff.reports import checked, difference
from motionlang.cli.golden import golden_files, write
from motionlang.report import rendered, text
from motionlang.views.diff import change_lines
from motionlang.views.terminal import draws, plain

if TYPE_CHECKING:
    from motionlang.analysis.diff.accept import Change
    from motionlang.result import Run

HELP = """\
y  accept this change: the golden files will have it
n  leave it as it was
a  accept this one and all that follow in this program
d  leave this one and all that follow in this program
q  quit: this one and all that follow stay as they were
"""


class NobodyAnswers(Exception):
    """Standard input is at its end, or there is none: nobody says what is accepted."""


class Quit(Exception):
    """Whoever was asked has had enough."""


def ask(question: str, keys: str) -> str:
    """One of the `keys`, from a terminal or a pipe, else `NobodyAnswers`; "?" tells what they mean."""
    while True:
        sys.stdout.write(f"{question} [{','.join(keys)},?] ")
        sys.stdout.flush()
        try:
            line = sys.stdin.readline() if sys.stdin is not None else ""
        except (OSError, ValueError):
            line = ""
        if not line:
            sys.stdout.write("\n")
            raise NobodyAnswers
        if not _is_terminal():
            sys.stdout.write(line if line.endswith("\n") else f"{line}\n")  # what a terminal would show
        answer = line.strip().lower()[:1]
        if answer and answer in keys:
            return answer
        sys.stdout.write("".join(each + "\n" for each in HELP.splitlines() if each[0] in keys))


def _is_terminal() -> bool:
    return sys.stdin is not None and sys.stdin.isatty()


def review(program: str, result: Run) -> bool:
    """Ask of each change between the golden files of a program and its run, and write those that are accepted.

    Whether the golden files are as the run is now. Both files are written, or neither: where nobody answers, and at
    Ctrl-C, they stay as they were; `Quit` comes after what was accepted has been written. OSError names a file.
    """
    report, printed = golden_files(program)
    new = json.loads(text(result, whole=False))
    name = os.path.basename(report)
    try:
        with open(report, encoding="utf-8") as file:
            old = checked(json.load(file))
        found = difference(old, new)
    except FileNotFoundError:
        return _whole(program, result, f"there is no {name} yet. Write it?")
    except ValueError:
        return _whole(program, result, f"{name} is no report of which changes could be told. Write it anew?")
    all_of_them = changes(found)
    if not all_of_them:  # what was printed is kept twice, and only the other one is otherwise
        other = os.path.basename(printed)
        return _whole(program, result, f"what is printed is not that of {other}. Accept it?")
    accepted, ends = _asked(program, all_of_them, found)
    whole = len(accepted) == len(all_of_them)
    if accepted:
        content = text(result, whole=False) if whole else rendered(merged(old, new, found, accepted))
        write(program, content, result.output if whole else json.loads(content)["output"])
    if ends:
        raise Quit
    return whole


def _whole(program: str, result: Run, question: str) -> bool:
    """Ask whether the golden files are written as the run is."""
    answer = ask(f"{program}: {question}", "ynq")
    if answer == "q":
        raise Quit
    if answer == "y":
        write(program, text(result, whole=False), result.output)
    return answer == "y"


def _asked(program: str, all_of_them: list[Change], found: object) -> tuple[list[Change], bool]:
    """The changes that are accepted, and whether there is to be an end."""
    accepted: list[Change] = []
    for number, change in enumerate(all_of_them):
        lines = "\n".join(f"  {line}" for line in change_lines(found, change))  # type: ignore[arg-type]
        sys.stdout.write((lines if draws(sys.stdout) else plain(lines).replace("→", "->")) + "\n")
        answer = ask(f"{program}: accept change {number + 1} of {len(all_of_them)}?", "ynadq")
        if answer == "a":
            return accepted + all_of_them[number:], False
        if answer in "dq":
            return accepted, answer == "q"
        if answer == "y":
            accepted.append(change)
    return accepted, False
