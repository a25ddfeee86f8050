"""Programs of every keyword: motion, mixed with varied examples of the rows.

Each row of the vocabulary has an example that runs. A program takes some of them, changes their axes and
their values within the range of the row, and puts them between the actions of a motion program. An example
that declares or defines something ends its program, as two of them might define the same name.
"""

from __future__ import annotations

import re
from functools import cache

from motionlang.kernel import Keyword
from tests.generated.draw import Draw, table
from tests.generated.mccl_motion import ACTIONS as MCCL_ACTIONS
from tests.generated.mccl_motion import McclProgram
from tests.generated.mint_motion import ACTIONS as MINT_ACTIONS
from tests.generated.mint_motion import AXES, MintProgram

_DECLARES = re.compile(
    r"(?im)^\s*(dim|const|define|sub|task|event|function|type|end|goto|gosub)\b|\bdim\b|:$|^\w+:"
)
_SETTING = re.compile(r"^(\w+)\((\d)\) = (-?[\d.]+)$")
_WORD = {"mint": re.compile(r"[A-Za-z_]\w*"), "mccl": re.compile(r"[A-Z]{2}")}
_TEXT = re.compile(r"\"[^\"]*\"|'.*")
# Names that the programs of motion declare.
_TAKEN = re.compile(r"\b(rise|ways|small|speeds|spans|k|faults)\b")

_MOTOR: dict[str, object] = {
    "kind": "brushless", "resistance": 1.2, "inductance": 2e-3, "torque_constant": 0.06, "inertia": 3e-5,
    "coulomb": 0.01, "amplifier_gain": 6.0,
}  # fmt: skip

# Simulated keywords that no program has, with the reason.
NEVER: dict[str, dict[str, str]] = {
    "mint": {
        "Controller": "told as not simulated where it is used: no source says what a variable of the type does"
    },
    "mccl": {},
}


@cache
def _spelled(language: str) -> dict[str, str]:
    """Return the row name for each spelling of a keyword, in lower case."""
    rows = table(language).values()
    return {spelling.lower(): row.name for row in rows for spelling in (row.name, row.short) if spelling}


def words(language: str, text: str) -> set[str]:
    """Return the row names of all keywords in a program."""
    found = _WORD[language].findall(_TEXT.sub("", text))
    return {_spelled(language)[word.lower()] for word in found if word.lower() in _spelled(language)}


def simulated(language: str) -> set[str]:
    """Return the names of the simulated rows."""
    return {row.name for row in table(language).values() if row.simulated}


@cache
def examples(language: str) -> tuple[Keyword, ...]:
    """Return the simulated rows that have an example."""
    return tuple(row for row in table(language).values() if row.simulated and row.example)


@cache
def _readable() -> tuple[str, ...]:
    rows = table("mint").values()
    return tuple(row.name for row in rows if row.simulated and row.index == "axis" and "R" in row.access)


def _example(row: Keyword) -> list[str]:
    """Return the lines of an example.

    A loop that counts i up to 3 gets `i = 0` before it: it would not end if an earlier example left 4 in i.
    """
    lines = row.example.split("\n")
    return ["i = 0", *lines] if "i = i + 1" in row.example else lines


def surroundings(draw: Draw, language: str) -> dict[str, object]:
    """Return a machine with changing inputs, an operator, and sometimes a motor."""
    machine: dict[str, object] = {}
    if draw.chance(0.5):
        machine["input"] = [
            {"channel": draw.randrange(8), "at": draw.real(0.0, 3.0), "for": draw.real(0.01, 2.0)}
            for _ in range(draw.randrange(1, 5))
        ]
    if draw.chance(0.5):
        machine["answer"] = [{"text": str(draw.randrange(100))} for _ in range(draw.randrange(1, 4))]
    if draw.chance(0.1):
        plant = f"axis.{0 if language == 'mint' else 1}.plant"
        machine |= {f"{plant}.{name}": value for name, value in _MOTOR.items()}
    return machine


class MintWords(MintProgram):
    """A Mint motion program with examples in between."""

    actions = MINT_ACTIONS | {"word": 60, "query": 15}

    def _word(self) -> list[str]:
        row = self._row(declares=False)
        axis = str(self.draw.choice(AXES))
        lines = _example(row)
        if row.index == "axis" and not re.search(r"\(\d, ?\d|\([1-9]\)", row.example):
            lines = [line.replace("(0)", f"({axis})") for line in lines]
        return [self._varied(line) for line in lines]

    def _row(self, declares: bool) -> Keyword:
        rows = [row for row in examples("mint") if bool(_DECLARES.search(row.example)) == declares]
        return self.draw.choice(rows)

    def _varied(self, line: str) -> str:
        """Return the line, mostly with another value of its setting."""
        found = _SETTING.match(line)
        row = table("mint").get(found[1]) if found is not None else None
        if found is None or row is None or self.draw.chance(0.3):
            return line
        return self._write(row.name, int(found[2]))

    def _query(self) -> list[str]:
        names = [self.draw.choice(_readable()) for _ in range(self.draw.randrange(1, 4))]
        return ["PRINT " + ', " ", '.join(f"{name}({self._axis()})" for name in names)]

    def _end(self) -> None:
        if self.draw.chance(0.6):
            super()._end()
            return
        self.lines += [_TAKEN.sub(r"\1_", line) for line in _example(self._row(declares=True))]


class McclWords(McclProgram):
    """An MCCL motion program with examples in between."""

    actions = MCCL_ACTIONS | {"word": 90}

    def _action(self) -> list[str]:
        kind = self.draw.pick(self.actions)
        if kind != "word":
            commands: list[str] = getattr(self, f"_{kind}")()
            return commands
        row = self.draw.choice(examples("mccl"))
        axis = str(self._axis())
        example = row.example
        if row.index != "none" and "2" not in example:
            example = re.sub(r"\b1(?=[A-Z]{2})", axis, example)
        return [example]
