"""Programs with errors of any kind give a diagnostic, never a traceback or a hang."""

from __future__ import annotations

import re
from pathlib import Path
from random import Random

import pytest

from motionlang import run
from motionlang.kernel import Source
from motionlang.kernel.mint import table
from tests.cases import examples

PROGRAMS = [
    path.read_text()
    for folder in ("spec", "errors")
    for path in sorted((Path(__file__).parents[3] / folder / "mint").glob("*.mnt"))
]
_PIECES = re.compile(r"\w+|\"[^\"\n]*\"|\n|[^\w\s]|[ \t]+")


_NUMBERS = ("0", "1", "-1", "3", "2.5", "2147483647", "1e308", "9")
_OPERATORS = ("+", "-", "*", "/", "\\", "=", "<", "&", "^")


def kind_of(piece: str) -> str:
    """Return the kind of a token; it is mostly replaced by tokens of the same kind."""
    if piece[0].isdigit():
        return "number"
    if piece[0].isalpha():
        return "control" if piece.lower() in _CONTROL else "name"
    return "operator" if piece in "+-*/&^<" else ""


_CONTROL = {row.name.lower() for row in table() if row.group == "language"}


def mutated(random: Random) -> str:
    """Return a program of the manual with names, numbers and operators exchanged.

    Sometimes a token is dropped or added.
    """
    pieces = _PIECES.findall(random.choice(PROGRAMS))
    names = [
        p for p in _PIECES.findall(random.choice(PROGRAMS)) if p[0].isalpha() and p.lower() not in _CONTROL
    ]
    for _ in range(random.randint(1, 6)):
        at = random.randrange(len(pieces))
        kind = kind_of(pieces[at])
        if kind == "number":
            pieces[at] = random.choice((*_NUMBERS, *names))
        elif kind == "name":
            pieces[at] = random.choice((*names, "3", '"text"'))
        elif kind == "operator":
            pieces[at] = random.choice(_OPERATORS)
        elif random.random() < 0.1:
            del pieces[at]
        elif random.random() < 0.1:
            pieces.insert(at, pieces[random.randrange(len(pieces))])
    return "".join(pieces)


def survive(seed: int) -> None:
    text = mutated(Random(seed))
    result = run(Source("a.mnt", text), until=0.5)
    assert result.status in ("ended", "until", "fault"), text


@pytest.mark.parametrize("start", range(0, 400, 50))
def test_mutated_programs_are_answered(start: int) -> None:
    for seed in range(start, start + examples(50)):
        survive(seed)


@pytest.mark.long
def test_many_mutated_programs_are_answered() -> None:
    for seed in range(1000, 21_000):
        survive(seed)
