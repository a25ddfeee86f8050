"""The pages on PMC's and ABB's notes: `python -m tests.cli.notes` updates output."""

from __future__ import annotations

import contextlib
import io
import re
import shlex
import tempfile
from math import cos, pi, sin, sqrt
from typing import TYPE_CHECKING

from motionlang.cli import main
from tests.lab.copley.docs import BLOCK, ROOT, blocks
from tests.lab.notes.examples import printed

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
        return printed(*words)
    assert program == "motionlang", command
    out, err = (io.TextIOWrapper(io.BytesIO(), encoding="utf-8", write_through=True) for _ in range(2))
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), contextlib.suppress(SystemExit):
        main(words)
    return "".join(stream.buffer.getvalue().decode() for stream in (out, err))


def rewritten(text: str) -> str:
    """Return the page with all outputs replaced by the present ones."""

    def fresh(match: re.Match[str]) -> str:
        ((pairs),) = blocks(match[0])
        return "```console\n" + "".join(f"$ {command}\n{answer(command)}" for command, _ in pairs) + "```"

    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        return BLOCK.sub(fresh, text)


if __name__ == "__main__":
    for page in PAGES.values():
        page.write_text(rewritten(page.read_text(encoding="utf-8")), encoding="utf-8")
