"""The options of a sweep, from a command line or `pick.sweep.toml`.

The file is next to `pick.mnt`.
"""

from __future__ import annotations

import os
from collections.abc import Mapping

from motionlang.analysis.quantities import quantity
from motionlang.analysis.sweeps.expression import Expression
from motionlang.analysis.sweeps.job import MACHINE, SCENARIO
from motionlang.analysis.sweeps.space import Dimension, Drawn, Grid, Space, dimension, read_value
from motionlang.errors import Diagnostic, ProgramError, nearest, shown
from motionlang.lang.machine.file import read_machine, read_toml
from motionlang.source import Source

SUFFIX = ".sweep.toml"
# The keys of the file, and their types.
KEYS = {
    "vary": "a table of names: rate = \"500:5000:10\", gain = [1, 2, 4]",
    "machines": "a folder of machine files, each a variant",
    "scenarios": "a folder of scenarios, each a variant",
    "keep": "a list of quantities to record: [\"time\", \"peak.0\"]",
    "random": "the size of a random sample",
    "latin": "the size of a Latin hypercube sample",
    "seed": "a whole number, the seed of the sample",
    "until": "the machine time at which a variant ends, s",
    "minimise": "an expression to minimise",
    "maximise": "an expression to maximise",
    "where": "an expression that must be true for the best variant",
    "pareto": "two or more expressions to minimise, separated by commas",
    "certify": "true if a variant fails when it exceeds a limit of the machine",
    "prove": "true to verify the motion of every variant",
}  # fmt: skip
_TEXTS, _COUNTS = ("machines", "scenarios", "minimise", "maximise", "where", "pareto"), ("random", "latin")


class Description:
    """The options by the keys of the file; keys that are not given have defaults."""

    def __init__(self) -> None:
        self.dimensions: list[Dimension] = []
        self.keep: list[str] = []
        self.machines: str | None = None
        self.scenarios: str | None = None
        self.random: int | None = None
        self.latin: int | None = None
        self.seed = 0
        self.until: float | None = None
        self.minimise: str | None = None
        self.maximise: str | None = None
        self.where: str | None = None
        self.pareto: str | None = None
        self.prove = False
        self.certify = False

    def space(self, worlds: Mapping[str, Mapping[str, object]]) -> Space:
        """Return the variants; ValueError if there are none, or too many."""
        whole = [Dimension(kind, sorted(some)) for kind, some in worlds.items()]
        dimensions = [*whole, *self.dimensions]
        if not dimensions:
            raise ValueError(
                "nothing to vary: give --vary NAME=FIRST:LAST:COUNT, --machines DIR or --scenarios DIR"
            )
        if self.random is not None and self.latin is not None:
            raise ValueError("use either a random or a Latin hypercube sample, not both")
        count = self.latin if self.random is None else self.random
        if count is None:
            return Grid(dimensions)
        return Drawn(dimensions, count, self.seed, self.latin is not None)

    def worlds(self) -> dict[str, dict[str, dict[str, object]]]:
        """Return the settings of the machine files and scenarios by name.

        Raises OSError, ValueError, ProgramError.
        """
        found = {}
        for kind, folder in ((MACHINE, self.machines), (SCENARIO, self.scenarios)):
            if folder is not None:
                found[kind] = {
                    name: settings_of(path, kind == SCENARIO) for name, path in machine_files(folder)
                }
        return found

    def expressions(self) -> dict[str, Expression]:
        """Return the expressions over rows, by "minimise", "maximise" and "where".

        Raises ValueError if an expression is invalid.
        """
        texts = {"minimise": self.minimise, "maximise": self.maximise, "where": self.where}
        return {name: Expression(text) for name, text in texts.items() if text is not None}

    def costs(self) -> list[Expression]:
        """Return the expressions of the Pareto front."""
        if self.pareto is None:
            return []
        found = [Expression(each) for each in self.pareto.split(",")]
        if len(found) < 2:
            raise ValueError("a Pareto front needs two or more quantities, such as time,peak.0")
        return found


def settings_of(path: str, is_layer: bool) -> dict[str, object]:
    """Return the settings of a machine file or a scenario; ProgramError if invalid.

    They include the name of the file.
    """
    try:
        settings = read_machine(Source.read(path), is_layer=is_layer)
        settings.pop("expect", None)  # of a world itself, not of its variants
        return settings
    except ProgramError as error:
        for each in error.diagnostics:
            each.message = (
                f"{os.path.basename(path)}, line {each.line}: {each.message}" if each.line else each.message
            )
        raise


def machine_files(folder: str) -> list[tuple[str, str]]:
    """Return names and paths of the machine files of a folder, in order.

    Raises ValueError if there are none.
    """
    found = []
    for file in sorted(os.listdir(folder)):
        if file.endswith(".toml") and not file.endswith(SUFFIX):
            found.append((file.removesuffix(".toml").removesuffix(".machine"), os.path.join(folder, file)))
    if not found:
        raise ValueError(f"no machine files in {folder}: they end in .toml")
    return found


def read_description(path: str) -> Description:
    """Return the description in a file.

    Raises OSError if it cannot be read, and ProgramError with all of its errors.
    """
    source = Source.read(path)
    tree = read_toml(source)
    found, mistakes = Description(), []

    def wrong(key: str, message: str, hint: str) -> None:
        line = next(
            (n for n, text in enumerate(source.text.split("\n"), 1) if text.strip(" [").startswith(key)), 0
        )
        mistakes.append(Diagnostic("machine-file", message, line, 1 if line else 0, hint=hint))

    for key, value in tree.items():
        problem = _take(found, key, value, os.path.dirname(path))
        if problem is not None:
            wrong(key, *problem)
    if mistakes:
        raise ProgramError(mistakes)
    return found


def _take(found: Description, key: str, value: object, folder: str) -> tuple[str, str] | None:
    """Store a key; return an error and a hint, or None."""
    if key not in KEYS:
        near = nearest(key, KEYS)
        return (
            f"there is no key {key}",
            f"did you mean {near}?" if near else f"the keys are {', '.join(KEYS)}",
        )
    wrong = f"{key} is {KEYS[key]}, not {shown(value)}", "docs/sweep.md has an example"
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    if key == "vary":
        if not isinstance(value, dict):
            return wrong
        try:
            found.dimensions = [_dimension(name, given) for name, given in _flat(value)]
        except ValueError as error:
            return str(error), wrong[1]
    elif key == "keep":
        if not isinstance(value, list) or not all(isinstance(each, str) for each in value):
            return wrong
        try:
            for each in value:
                quantity(each)
        except ValueError as error:
            return str(error), wrong[1]
        found.keep = value
    elif key in _TEXTS:
        if not isinstance(value, str):
            return wrong
        setattr(found, key, os.path.join(folder, value) if key in ("machines", "scenarios") else value)
    elif key in ("prove", "certify"):
        if not isinstance(value, bool):
            return wrong
        setattr(found, key, value)
    elif key == "until":
        if not number or not 0 <= value < 1e300:  # type: ignore[operator]
            return wrong
        found.until = float(value)  # type: ignore[arg-type]
    elif not isinstance(value, int) or isinstance(value, bool) or (key in _COUNTS and value < 1):
        return wrong
    else:
        setattr(found, key, value)
    return None


def _flat(tree: Mapping[str, object], prefix: str = "") -> list[tuple[str, object]]:
    """Return the varied names and their values; keys may contain dots or be tables."""
    out: list[tuple[str, object]] = []
    for key, value in tree.items():
        out += _flat(value, f"{prefix}{key}.") if isinstance(value, dict) else [(prefix + key, value)]
    return out


def _dimension(name: str, given: object) -> Dimension:
    if isinstance(given, list) and given:
        return Dimension(name, [each if not isinstance(each, str) else read_value(each) for each in given])
    if isinstance(given, bool):
        return Dimension(name, [given])
    if isinstance(given, (str, int, float)):
        return dimension(f"{name}={given}")
    raise ValueError(f'{name} is varied over a list or a range such as "500:5000:10", not {shown(given)}')
