"""`motionlang verify --review`: accept changes of a program one by one.

The accepted changes are written to the golden files.
"""

from __future__ import annotations

import json
import os
import sys

from motionlang.commands.diff.accept import AcceptedChange, changes, merged
from motionlang.commands.diff.golden import golden_files, write
from motionlang.commands.diff.reports import checked, difference
from motionlang.commands.diff.view import change_lines
from motionlang.kernel import Run
from motionlang.kernel.report import rendered, text
from motionlang.views.terminal import draws, plain

HELP = """\
y  accept this change into the golden files
n  reject this change
a  accept this change and the rest of this program
d  reject this change and the rest of this program
q  quit and reject this change and all others
"""


class NoAnswer(Exception):
    """Standard input has ended or is missing, so no change is accepted."""


class Quit(Exception):
    """The user has quit."""


def ask(question: str, keys: str) -> str:
    """Ask for one of the `keys` on a terminal or a pipe; "?" explains them.

    Raises `NoAnswer` if neither provides an answer.
    """
    while True:
        sys.stdout.write(f"{question} [{','.join(keys)},?] ")
        sys.stdout.flush()
        try:
            line = sys.stdin.readline() if sys.stdin is not None else ""
        except (OSError, ValueError):
            line = ""
        if not line:
            sys.stdout.write("\n")
            raise NoAnswer
        if not _is_terminal():
            sys.stdout.write(line if line.endswith("\n") else f"{line}\n")  # what a terminal would show
        answer = line.strip().lower()[:1]
        if answer and answer in keys:
            return answer
        sys.stdout.write("".join(each + "\n" for each in HELP.splitlines() if each[0] in keys))


def _is_terminal() -> bool:
    return sys.stdin is not None and sys.stdin.isatty()


def review(program: str, result: Run) -> bool:
    """Ask about each change between golden files and run, and write accepted ones.

    Returns True if the golden files then match the run. Both files are written, or neither. Without an answer, and
    after Ctrl-C, they do not change; `Quit` is raised after the accepted changes have been written. An OSError
    names the file.
    """
    report, printed = golden_files(program)
    new = json.loads(text(result, whole=False))
    name = os.path.basename(report)
    try:
        with open(report, encoding="utf-8") as file:
            old = checked(json.load(file))
        found = difference(old, new)
    except FileNotFoundError:
        return _whole(program, result, f"{name} does not exist. Write it?")
    except ValueError:
        return _whole(program, result, f"{name} is not a report. Overwrite it?")
    all_of_them = changes(found)
    if not all_of_them:  # printed output is stored twice, and only the other one differs
        other = os.path.basename(printed)
        return _whole(program, result, f"the printed output differs from {other}. Accept it?")
    accepted, ends = _ask_each(program, all_of_them, found)
    whole = len(accepted) == len(all_of_them)
    if accepted:
        content = text(result, whole=False) if whole else rendered(merged(old, new, found, accepted))
        write(program, content, result.output if whole else json.loads(content)["output"])
    if ends:
        raise Quit
    return whole


def _whole(program: str, result: Run, question: str) -> bool:
    """Ask whether to rewrite the golden files from the run; True if rewritten."""
    answer = ask(f"{program}: {question}", "ynq")
    if answer == "q":
        raise Quit
    if answer == "y":
        write(program, text(result, whole=False), result.output)
    return answer == "y"


def _ask_each(
    program: str, all_of_them: list[AcceptedChange], found: object
) -> tuple[list[AcceptedChange], bool]:
    """Return the accepted changes, and True if the user has quit."""
    accepted: list[AcceptedChange] = []
    for number, change in enumerate(all_of_them):
        lines = "\n".join(f"  {line}" for line in change_lines(found, change))  # type: ignore[arg-type]
        sys.stdout.write((lines if draws(sys.stdout) else plain(lines)) + "\n")
        answer = ask(f"{program}: accept change {number + 1} of {len(all_of_them)}?", "ynadq")
        if answer == "a":
            return accepted + all_of_them[number:], False
        if answer in "dq":
            return accepted, answer == "q"
        if answer == "y":
            accepted.append(change)
    return accepted, False
