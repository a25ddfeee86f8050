"""Reduction of a program with a finding, by removing statements."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial

from tests.generated.checks import findings
from tests.generated.motion import Generated

# The separator of statements on a line.
_BETWEEN = {"mint": " : ", "mccl": ","}
_FIGURE = re.compile(r"-?\d[\d.e+-]*")


def kind_of(finding: str) -> str:
    """Return a finding without its figures, since they change as the program shrinks."""
    return _FIGURE.sub("", finding)


def shrunk(program: Generated) -> Generated:
    """Return the smallest program found by removing lines, statements and settings.

    The settings are those of the machine. A program without a finding is returned unchanged.
    """
    kinds = {kind_of(each) for each in findings(program)}
    if not kinds:
        return program

    def is_found(smaller: Generated) -> bool:
        return any(kind_of(each) in kinds for each in findings(smaller))

    def with_lines(lines: list[str]) -> Generated:
        return program._replace(text="\n".join(lines) + "\n")

    def with_line(number: int, items: list[str]) -> Generated:
        lines = program.text.splitlines()
        return with_lines([*lines[:number], between.join(items), *lines[number + 1 :]])

    between, before = _BETWEEN[program.language], None
    while program != before:
        before = program
        program = with_lines(_least(program.text.splitlines(), lambda lines: is_found(with_lines(lines))))
        for number, line in enumerate(program.text.splitlines()):
            enough = partial(lambda number, items: is_found(with_line(number, items)), number)
            program = with_line(number, _least(line.split(between), enough))
        for key in program.machine:
            smaller = program._replace(machine={k: v for k, v in program.machine.items() if k != key})
            program = smaller if is_found(smaller) else program
    return program


def _least(items: list[str], is_enough: Callable[[list[str]], bool]) -> list[str]:
    """Return a minimal list that `is_enough`: remove halves, then quarters and so on."""
    size = len(items)
    while size := size // 2:
        first = 0
        while first < len(items):
            fewer = items[:first] + items[first + size :]
            if is_enough(fewer):
                items = fewer
            else:
                first += size
    return items
