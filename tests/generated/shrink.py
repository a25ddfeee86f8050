"""The smallest program that still has a finding: statements are left out as long as the same one is found."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial

from tests.generated.checks import findings
from tests.generated.motion import Generated

# What stands between statements of a line.
_BETWEEN = {"mint": " : ", "mccl": ","}
_FIGURE = re.compile(r"-?\d[\d.e+-]*")


def kind_of(finding: str) -> str:
    """A finding without its figures: what stays the same as the program becomes smaller."""
    return _FIGURE.sub("", finding)


def shrunk(program: Generated) -> Generated:
    """The program with lines, settings of the machine and statements of a line left out, one after the other.

    The program itself if nothing is found in it.
    """
    kinds = {kind_of(each) for each in findings(program)}
    if not kinds:
        return program

    def is_found(smaller: Generated) -> bool:
        return any(kind_of(each) in kinds for each in findings(smaller))

    def with_lines(lines: list[str]) -> Generated:
        return program._replace(text="\n".join(lines) + "\n")

    def with_line(number: int, parts: list[str]) -> Generated:
        lines = program.text.splitlines()
        return with_lines([*lines[:number], between.join(parts), *lines[number + 1 :]])

    between, before = _BETWEEN[program.language], None
    while program != before:
        before = program
        program = with_lines(_least(program.text.splitlines(), lambda lines: is_found(with_lines(lines))))
        for number, line in enumerate(program.text.splitlines()):
            enough = partial(lambda number, parts: is_found(with_line(number, parts)), number)
            program = with_line(number, _least(line.split(between), enough))
        for key in program.machine:
            smaller = program._replace(machine={k: v for k, v in program.machine.items() if k != key})
            program = smaller if is_found(smaller) else program
    return program


def _least(parts: list[str], is_enough: Callable[[list[str]], bool]) -> list[str]:
    """Parts of which none can be left out: halves are tried first, then quarters and so on."""
    size = len(parts)
    while size := size // 2:
        first = 0
        while first < len(parts):
            fewer = parts[:first] + parts[first + size :]
            if is_enough(fewer):
                parts = fewer
            else:
                first += size
    return parts
