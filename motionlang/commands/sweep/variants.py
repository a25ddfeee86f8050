"""The options of a sweep: what varies, what is recorded and what is looked for.

They are also the keys of `pick.sweep.toml` next to `pick.mnt`.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, Self

from motionlang.cli.command import Command, WrongOption, flag, option
from motionlang.cli.option_groups import accepted_events
from motionlang.cli.readers import COUNT, integer, machine_time
from motionlang.commands.quantities import quantity_names
from motionlang.commands.sweep import KEEP
from motionlang.commands.sweep.expression import QuantityExpression
from motionlang.commands.sweep.job import MACHINE, SCENARIO
from motionlang.commands.sweep.space import Dimension, Drawn, Grid, Space, dimension
from motionlang.commands.sweep.worlds import SUFFIX, machine_files, settings_of
from motionlang.kernel import Diagnostic, ProgramError, Source
from motionlang.kernel.lang import read_toml

# Keys of which one on the command line replaces all of the file.
TOGETHER = (("vary", "machines", "scenarios"), ("random", "latin"), ("minimise", "maximise", "pareto"))


def costs(text: str) -> list[QuantityExpression]:
    """Return the expressions of a Pareto front, separated by commas."""
    found = [QuantityExpression(each) for each in text.split(",")]
    if len(found) < 2:
        raise ValueError("a Pareto front needs two or more quantities, such as time,peak.0")
    return found


@dataclass
class Variants(Command):
    """The variants of a program, their results, and which of them is best."""

    title: ClassVar[str] = "variants"
    vary: list[Dimension] = option(
        "NAME=VALUES",
        "vary a name of the program, or a key of the machine file by its dotted name: FIRST:LAST:COUNT or A,B,C; may "
        "be repeated, and each combination is a variant",
        read=dimension,
        many=True,
    )
    machines: str | None = option("DIR", "run on every machine file of a folder instead of the program's")
    scenarios: str | None = option(
        "DIR", "run in every scenario of a folder, each overlaid on the machine file"
    )
    random: int | None = option("N", "run a random sample of N variants", read=COUNT)
    latin: int | None = option("N", "run a Latin hypercube sample of N variants", read=COUNT)
    seed: int = option("S", "the seed of the sample (0)", read=integer, default=0)
    keep: tuple[str, ...] = option(
        "NAMES",
        "quantities to record, separated by commas (time); see the list below",
        read=quantity_names,
        default=KEEP,
    )
    until: float | None = option("S", "end every run after S seconds of machine time", read=machine_time)
    certify: bool = flag("a variant fails if it exceeds a limit of the machine file")
    allow: frozenset[str] = accepted_events()
    minimise: QuantityExpression | None = option(
        "EXPR", "find the variant with the smallest value", read=QuantityExpression
    )
    maximise: QuantityExpression | None = option(
        "EXPR", "find the variant with the largest value", read=QuantityExpression
    )
    where: QuantityExpression | None = option(
        "EXPR", "consider only variants for which this is true", read=QuantityExpression
    )
    pareto: list[QuantityExpression] | None = option(
        "A,B", "find the Pareto front of these quantities", read=costs
    )

    @classmethod
    def of_file(cls, path: str) -> Self:
        """Return the options in a file; OSError if it cannot be read, ProgramError with all its errors."""
        made = cls()
        made.read_file(path)
        return made

    def read_file(self, path: str) -> None:
        """Take the options that were not given from a file; its errors are those of `of_file`."""
        source = Source.read(path)
        tree = read_toml(source)
        keys = Variants.keys(Variants.title)
        for group in TOGETHER:
            if not self.typed.isdisjoint(group):
                tree = {key: value for key, value in tree.items() if key not in group}
        before = {name: getattr(self, name) for name in ("machines", "scenarios")}
        wrong = [
            Diagnostic("machine-file", why, *_place(source, key), hint="docs/sweep.md has an example")
            for key, why in self.take(tree, keys)
        ]
        if wrong:
            raise ProgramError(wrong)
        for name, value in before.items():
            if value is None and getattr(self, name) is not None:
                setattr(self, name, os.path.join(os.path.dirname(path), getattr(self, name)))

    def read_file_of(self, program: str) -> None:
        """Take the options that were not given from the file next to a program, if there is one."""
        path = os.path.splitext(program)[0] + SUFFIX
        if os.path.isfile(path):
            self.read_file(path)

    def worlds(self) -> dict[str, dict[str, dict[str, object]]]:
        """Return the settings of the machine files and scenarios by name; OSError, ValueError, ProgramError."""
        folders = ((MACHINE, self.machines), (SCENARIO, self.scenarios))
        return {
            kind: {name: settings_of(path, kind == SCENARIO) for name, path in machine_files(folder)}
            for kind, folder in folders
            if folder is not None
        }

    def space(self, worlds: Mapping[str, Mapping[str, object]]) -> Space:
        """Return the variants; ValueError if there are none, or too many."""
        dimensions = [*(Dimension(kind, sorted(some)) for kind, some in worlds.items()), *self.vary]
        if not dimensions:
            raise ValueError(
                "nothing to vary: give --vary NAME=FIRST:LAST:COUNT, --machines DIR or --scenarios DIR"
            )
        if self.random is not None and self.latin is not None:
            raise WrongOption("use either a random or a Latin hypercube sample, not both")
        count = self.latin if self.random is None else self.random
        if count is None:
            return Grid(dimensions)
        return Drawn(dimensions, count, self.seed, self.latin is not None)

    @property
    def wanted(self) -> QuantityExpression | None:
        """The expression to minimise or maximise."""
        return self.minimise or self.maximise


def _place(source: Source, key: str) -> tuple[int, int]:
    """Return line and column of a key, 0 and 0 if it is not found."""
    lines = enumerate(source.text.split("\n"), 1)
    line = next((number for number, text in lines if text.strip(" [").startswith(key)), 0)
    return line, 1 if line else 0
