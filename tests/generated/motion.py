"""Motion programs of both languages, each from a seed.

`generate(seed)` draws the language, the program and its machine. The program follows the grammar and the
keyword rows, but an axis may still reject a statement at run time, as in any program.
"""

from __future__ import annotations

from typing import NamedTuple

from tests.generated.draw import Draw
from tests.generated.mccl_motion import McclProgram
from tests.generated.mint_motion import MintProgram
from tests.generated.words import McclWords, MintWords, surroundings

# Machine seconds after which a program that has not ended is cut off.
UNTIL = 20.0
# The contents of programs, and their generators, by language: motion alone, or every keyword of a language.
FAMILIES: dict[str, dict[str, type[MintProgram | McclProgram]]] = {
    "motion": {"mint": MintProgram, "mccl": McclProgram},
    "words": {"mint": MintWords, "mccl": McclWords},
}
SUFFIX = {"mint": ".mnt", "mccl": ".mcl"}


class Generated(NamedTuple):
    """A program, its language, and the settings of its machine."""

    seed: int
    language: str
    text: str
    machine: dict[str, object]
    family: str = "motion"

    @property
    def name(self) -> str:
        """Return the file name."""
        return f"{self.family}-{self.seed}{SUFFIX[self.language]}"

    @property
    def machine_file(self) -> str:
        """Return the settings as the text of a machine file."""
        return "".join(f"{key} = {_toml(value)}\n" for key, value in self.machine.items())


def _toml(value: object) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {_toml(each)}" for key, each in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return f'"{value}"' if isinstance(value, str) else f"{value}"


def generate(seed: int, family: str = "motion") -> Generated:
    """Return the program of a seed from one of `FAMILIES`; two thirds are Mint."""
    draw = Draw(seed)
    language = "mccl" if draw.chance(1 / 3) else "mint"
    machine: dict[str, object] = {}
    if draw.chance(0.3):
        machine["controller.instruction_time"] = draw.choice((1e-9, 1e-6, 1e-3))
    if draw.chance(0.3):
        scale = 1.0 if language == "mint" else 10.0
        first = 0 if language == "mint" else 1
        for axis in range(first, first + 3):
            machine[f"axis.{axis}.home_switch"] = [-30.0 * scale, -20.0 * scale]
            machine[f"axis.{axis}.index_every"] = 12.0 * scale
            if draw.chance(0.4):
                machine[f"axis.{axis}.travel"] = [-70.0 * scale, 70.0 * scale]
    if family == "words":
        machine |= surroundings(draw, language)
    return Generated(seed, language, FAMILIES[family][language](draw).text, machine, family)
