"""The variants of a sweep: a grid, random points, a Latin hypercube, or a list.

Variants are created one by one on demand.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from math import inf
from random import Random
from typing import Any

from motionlang.kernel import ProgramError
from motionlang.kernel import read_value as machine_value
from motionlang.kernel.lang import canonical

Value = float | str | bool | list[object]

MAX_VARIANTS = 100_000_000
_RANGE = re.compile(r"([^:,\[\]\"']+):([^:,\[\]\"']+)(?::([^:,\[\]\"']+))?$")


class Dimension:
    """A varied name: a range from `first` to `last` in `count` steps, or `values`.

    `count` is None if the text of the range does not state it; then the range can only be sampled.
    """

    def __init__(
        self,
        name: str,
        values: Sequence[Value] = (),
        *,
        first: float = 0.0,
        last: float = 0.0,
        count: int | None = None,
    ) -> None:
        self.name, self.values, self.first, self.last, self.count = name, tuple(values), first, last, count

    def __len__(self) -> int:
        return len(self.values) if self.values else self.count or 0

    def __getitem__(self, index: int) -> Value:
        """Return the value at a grid index.

        It is an integer if the value and both ends of the range are integers.
        """
        if self.values:
            return self.values[index]
        assert self.count is not None
        if index == 0 or self.count == 1:
            value = self.first
        elif index == self.count - 1:
            value = self.last
        else:
            value = self.first + (self.last - self.first) * index / (self.count - 1)
        return int(value) if self.is_whole and value == int(value) else float(value)

    @property
    def is_whole(self) -> bool:
        """True if both ends are written as integers."""
        return isinstance(self.first, int) and isinstance(self.last, int)

    def at(self, fraction: float) -> Value:
        """Return the value at a fraction of the range, 0 to 1."""
        if self.values:
            return self.values[min(int(fraction * len(self.values)), len(self.values) - 1)]
        return self.first + (self.last - self.first) * fraction


def dimension(text: str) -> Dimension:
    """Parse `name=first:last:count`, `name=first:last` or `name=value,value`.

    Raises ValueError for any other text.
    """
    name, equals, given = (item.strip() for item in text.partition("="))
    if not equals or not name or not given:
        raise ValueError(f"{text!r} is not NAME=FIRST:LAST:COUNT or NAME=VALUE,VALUE")
    name = canonical(name) or name
    found = _RANGE.match(given)
    if found is None:
        return Dimension(name, [read_value(each) for each in _split(given)])
    first, last = _number(found[1]), _number(found[2])
    count = None if found[3] is None else _number(found[3])
    if first is None or last is None or (found[3] is not None and (not isinstance(count, int) or count < 1)):
        raise ValueError(f"{given!r} is not FIRST:LAST:COUNT, such as 500:5000:10")
    return Dimension(name, first=first, last=last, count=count if isinstance(count, int) else None)


def _split(text: str) -> list[str]:
    """Return the values of a list; a comma in brackets or quotes belongs to its value."""
    items = re.findall(r"""(?:\[[^\]]*\]|"[^"]*"|'[^']*'|[^,])+""", text)
    return [item.strip() for item in items if item.strip()]


def _number(text: str) -> float | None:
    try:
        return int(text)
    except ValueError:
        pass
    try:
        value = float(text)
    except ValueError:
        return None
    return value if abs(value) < inf else None


def read_value(text: str) -> Value:
    """Return a value written as in the machine file; other text is a string."""
    try:
        value: Value = machine_value(text)  # type: ignore[assignment]
    except ProgramError:
        number = _number(text)  # such as 1. or 007, which TOML rejects
        return text if number is None else number
    return value


class Space:
    """The variants of a sweep by number: values of its `names`, computed on demand."""

    def __init__(self, names: Iterable[str]) -> None:
        self.names = tuple(names)
        twice = [name for n, name in enumerate(self.names) if name in self.names[:n]]
        if twice:
            raise ValueError(f"{twice[0]} is varied twice")

    def __len__(self) -> int:
        raise NotImplementedError

    def __getitem__(self, index: int) -> tuple[Value, ...]:
        raise NotImplementedError


class Grid(Space):
    """Every combination of the values; the last name changes fastest."""

    def __init__(self, dimensions: Sequence[Dimension]) -> None:
        super().__init__(each.name for each in dimensions)
        self.dimensions = tuple(dimensions)
        self._count = 1
        for each in dimensions:
            if not len(each):
                raise ValueError(
                    f"how many values of {each.name}? A grid needs {each.name}={each.first:.10g}:{each.last:.10g}:COUNT"
                )
            self._count *= len(each)
        if self._count > MAX_VARIANTS:
            raise ValueError(f"{self._count} variants are more than {MAX_VARIANTS}")

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, index: int) -> tuple[Value, ...]:
        values = []
        for each in reversed(self.dimensions):
            index, digit = divmod(index, len(each))
            values.append(each[digit])
        return tuple(reversed(values))


class Drawn(Space):
    """Points sampled from the dimensions; the same for the same seed.

    They are random, or a Latin hypercube. In a Latin hypercube each of `count` equal intervals of each
    dimension has one point, so that a few points cover it well.
    """

    def __init__(self, dimensions: Sequence[Dimension], count: int, seed: int, latin: bool) -> None:
        super().__init__(each.name for each in dimensions)
        if not 1 <= count <= MAX_VARIANTS:
            raise ValueError(f"a sweep has 1 to {MAX_VARIANTS} variants, not {count}")
        self.dimensions, self._count, self._seed = tuple(dimensions), count, seed
        self._permutations: list[list[int]] = []
        for each in dimensions if latin else ():
            order = list(range(count))
            Random(f"{seed} {each.name}").shuffle(order)
            self._permutations.append(order)

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, index: int) -> tuple[Value, ...]:
        draw = Random(f"{self._seed} variant {index}").random
        if not self._permutations:
            return tuple(each.at(draw()) for each in self.dimensions)
        return tuple(
            each.at((order[index] + draw()) / self._count)
            for each, order in zip(self.dimensions, self._permutations, strict=True)
        )


class ListedPoints(Space):
    """A list of points, each with a value for every name."""

    def __init__(self, points: Iterable[Mapping[str, Value]]) -> None:
        self._points = list(points)
        super().__init__(self._points[0] if self._points else ())
        for number, point in enumerate(self._points):
            if point.keys() != set(self.names):
                raise ValueError(f"point {number} differs in names from the first: {', '.join(self.names)}")

    def __len__(self) -> int:
        return len(self._points)

    def __getitem__(self, index: int) -> tuple[Value, ...]:
        return tuple(self._points[index][name] for name in self.names)


def space_of(grid: Space | Mapping[str, object] | Iterable[Mapping[str, Value]]) -> Space:
    """Return the space of a caller's argument: a space, a grid of lists, or points.

    A list may be a text in the form of the command line.
    """
    if isinstance(grid, Space):
        return grid
    named: Any = grid
    if not hasattr(named, "items"):
        return ListedPoints(named)
    dimensions = []
    for name, values in named.items():
        if isinstance(values, str):
            dimensions.append(dimension(f"{name}={values}"))
        elif isinstance(values, (int, float)):
            dimensions.append(Dimension(name, [values]))
        else:
            dimensions.append(Dimension(name, [_plain(each) for each in values]))
            if not len(dimensions[-1]):
                raise ValueError(f"{name} has no values")
    return Grid(dimensions)


def _plain(value: Any) -> Value:
    """Return a number of numpy as Python's own type."""
    plain: Value = value.item() if hasattr(value, "item") else value
    return plain
