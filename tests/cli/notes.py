"""The formulas of the pages on PMC's and ABB's notes, and the output of commands."""

from __future__ import annotations

import contextlib
import io
import re
import shlex
from math import cos, pi, sin, sqrt
from typing import TYPE_CHECKING

from motionlang.cli import main
from tests.lab.notes.examples import ROOT, printed

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

PAGES = {name: ROOT / "docs" / name for name in ("tn1069.md", "an00115.md")}
NUMBER = re.compile(r"^\|.*\| `(.+)` \| (-?[0-9.]+) \|$", re.MULTILINE)


def integral(of: Callable[[float], float], end: float, steps: int = 20_000) -> float:
    """Return the integral of a function from 0 to `end`, by the midpoint rule."""
    width = end / steps
    return width * sum(of((k + 0.5) * width) for k in range(steps))


NAMES = {"pi": pi, "sin": sin, "cos": cos, "sqrt": sqrt, "integral": integral}


def numbers(text: str) -> Iterator[tuple[str, str]]:
    """Yield each formula, with the note's figures inserted, and its printed result."""
    yield from NUMBER.findall(text)


def worked_out(formula: str) -> float:
    return float(eval(formula, dict(NAMES)))  # a line of our own pages


def answer(command: str) -> str:
    """Return the output of a command, standard error after standard output."""
    program, *words = shlex.split(command)
    if program == "python":
        return printed(words[1].rpartition(".")[2], *words[2:])
    assert program == "motionlang", command
    out, err = (io.TextIOWrapper(io.BytesIO(), encoding="utf-8", write_through=True) for _ in range(2))
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), contextlib.suppress(SystemExit):
        main(words)
    return "".join(stream.buffer.getvalue().decode() for stream in (out, err))
