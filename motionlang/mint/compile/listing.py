"""List the generated Python of a program, with the program line of each line."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from motionlang.lang.listing import Listing

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from motionlang.mint.runtime.code_units import Code

HEAD = """\
Mint is compiled to Python. Below each line of the program is what it became.

t           number of the statement, the program's measure of time
H           number of the statement at which an event or another task is due
yield       let that event or task run
T(2.0)      pay for 2 statements and set the clock; true if something is due
k0, k1 ...  operations, named beside the code; a write, load or do takes what
            it pays for first, and is true if it has to be put off
E, P        the environment of the run; print"""
# A string, in which nothing is searched, or the name of an operation.
_OPERATION = re.compile(r"""'(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*"|\b(k\d+)\b""")
_OF_KEYWORDS = frozenset(("read", "write", "load", "do", "rewrite", "redo", "copy"))
# The other kinds of spec, with the prefix of their names. The first two are Python names of `mint/runtime`.
_OTHERS = {"env": "Environment.", "fn": "functions.", "show": "text of ", "using": "USING of "}


def listing(code: Code, line_of: Mapping[int, int]) -> Listing:
    """Return the lines of freshly compiled code.

    `line_of` maps source offsets to program lines.
    """
    found = [(0, f" {text}", "") for text in code.first_text.splitlines()]
    for unit in code.units:
        # `Unit.compile` puts two lines before the text, and lines count from 1.
        for number, text in enumerate(unit.text.split("\n"), unit.before + 3):
            notes = ", ".join(_operations(text, code.specs))
            found.append((line_of[code.offsets[number]], text, notes))
    return Listing(HEAD, found, is_python=True)


def _operations(text: str, specs: Sequence[tuple[object, ...]]) -> Iterator[str]:
    """Yield the operations that a line of code calls, such as `k3 read IDLE(0)`."""
    for name in dict.fromkeys(filter(None, _OPERATION.findall(text))):
        yield f"{name} {_described(*specs[int(name[1:])])}"


def _described(how: object, *details: object) -> str:
    """Describe an operation: of a keyword, with its axes, or of the run-time library."""
    if how in _OF_KEYWORDS:
        keyword, *where = details
        axes = where[0] if where and isinstance(where[0], tuple) else where
        return f"{how} {keyword}({', '.join(map(str, axes))})" if axes else f"{how} {keyword}"
    if how == "loop":
        return "loop skipping"
    if how == "wait":
        return "wait" if details[1] is None else f"wait {details[1]} ms"
    return f"{_OTHERS[str(how)]}{details[0]}"
