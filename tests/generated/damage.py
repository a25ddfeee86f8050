"""Typical mistakes of users, made in a program by a seed, for the checks to find."""

from __future__ import annotations

import re
from collections.abc import Callable

from tests.generated.draw import Draw

# The mistakes of one program.
COUNT = 3
_NAME = re.compile(r"[A-Za-z_]{3,}")
_COMMAND = re.compile(r"(?<![A-Za-z])[A-Z]{2}(?![A-Za-z])")
_NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?")
_AXIS = {"mint": re.compile(r"(?<=\()\d(?=\))"), "mccl": re.compile(r"\d(?=[A-Z]{2})")}
# Statements without a mistake, which make a line longer than a terminal.
_LONG = {"mint": "SPEED(0) = 5 : " * 12, "mccl": "1SV500," * 25}
_BRACKET = re.compile(r"[()\[\]\"]")


def damaged(text: str, language: str, seed: int, count: int = COUNT) -> str:
    """Return a program with `count` mistakes, each on another line."""
    draw = Draw(seed)
    lines = text.split("\n")
    filled = [number for number, line in enumerate(lines) if line.strip()]
    for number in sorted(draw.sample(filled, min(count, len(filled))), reverse=True):
        lines[number : number + 1] = _mistake(draw, lines[number], language)
    return "\n".join(lines)


def _mistake(draw: Draw, line: str, language: str) -> list[str]:
    """Return the lines that replace a line to make a mistake.

    They are the line itself if the mistake needs a number or a name and the line has none.
    """
    name = _NAME if language == "mint" else _COMMAND
    mistakes: tuple[Callable[[], list[str]], ...] = (
        lambda: [_replaced(draw, name, line, _misspelt)],
        lambda: [_replaced(draw, name, line, _misspelt)],
        lambda: [_replaced(draw, _NUMBER, line, lambda number: number + "000000000")],
        lambda: [_replaced(draw, _NUMBER, line, lambda number: "-" + number)],
        lambda: [_replaced(draw, _AXIS[language], line, lambda axis: "9")],
        lambda: [_replaced(draw, _BRACKET, line, lambda bracket: "")],
        lambda: [line[: max(len(line) * 2 // 3, 1)]],
        list,
        lambda: [line, line],
        lambda: [f"{line} {line.strip()}"],
        lambda: [line.replace("=", "", 1)],
        lambda: [line.replace(",", "", 1)],
        lambda: [_LONG[language] + _replaced(draw, name, line, _misspelt)],
        lambda: [_replaced(draw, name, line, _misspelt) + " " + _LONG[language]],
    )
    return draw.choice(mistakes)()


def _replaced(draw: Draw, pattern: re.Pattern[str], line: str, change: Callable[[str], str]) -> str:
    """Return the line with one match of a pattern changed."""
    found = list(pattern.finditer(line))
    if not found:
        return line
    one = draw.choice(found)
    return line[: one.start()] + change(one[0]) + line[one.end() :]


def _misspelt(name: str) -> str:
    """Swap the last two letters, or repeat the last one of equal letters."""
    return name[:-2] + name[-1] + name[-2] if name[-1] != name[-2] else name + name[-1]
