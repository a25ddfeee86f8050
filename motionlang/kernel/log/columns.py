"""Columns: a field of many records, in typed arrays.

    Floats   array of doubles                                            a time
    Values   doubles, and for each what it is: a float, an integer,      a channel's value, a line, a cause
             or the number of another value in `Words`
    Texts    UTF-8 and where each text ends                              a printed line
    Numbers  doubles and where each tuple ends                           the numbers of a profile

Values other than numbers are few in a run and occur in many records: names, causes, descriptions, tuples of axes. Each
is stored once.
"""

from __future__ import annotations

from array import array
from collections.abc import Sequence
from typing import Any

# What a double of `Values` is; from `_WORDS` on it is the number of a word.
_FLOAT, _INT, _WORDS = 0, 1, 2
# Larger integers are not exact as doubles.
_EXACT = 2**53


class Words:
    """Values other than numbers, by number; elements at the same place of two tuples have the same type."""

    def __init__(self) -> None:
        self.values: list[Any] = []
        self._numbers: dict[tuple[type, Any], int] = {}

    def number(self, value: Any) -> int:
        """Return the number of a value."""
        key = value.__class__, value
        found = self._numbers.get(key)
        if found is None:
            found = self._numbers[key] = len(self.values)
            self.values.append(value)
        return found


class Floats:
    """A column of floats."""

    __slots__ = ("_numbers", "append")

    def __init__(self, words: Words) -> None:
        self._numbers = array("d")
        self.append = self._numbers.append

    @property
    def arrays(self) -> tuple[array[Any], ...]:
        """The arrays of the column."""
        return (self._numbers,)

    def read(self, first: int, past: int) -> Sequence[Any]:
        """Return some of the values."""
        return self._numbers[first:past]

    def cut(self, count: int) -> None:
        """Drop all but the first values."""
        del self._numbers[count:]


class Values:
    """A column of numbers, texts, tuples and the like."""

    __slots__ = ("_kinds", "_numbers", "_words")

    def __init__(self, words: Words) -> None:
        self._words = words
        self._numbers, self._kinds = array("d"), array("i")

    @property
    def arrays(self) -> tuple[array[Any], ...]:
        """The arrays of the column."""
        return self._numbers, self._kinds

    def append(self, value: object) -> None:
        kind, number = _FLOAT, 0.0
        if value.__class__ is float:
            number = value
        elif value.__class__ is int and -_EXACT < value < _EXACT:
            kind, number = _INT, value
        else:
            kind = _WORDS + self._words.number(value)
        self._numbers.append(number)
        self._kinds.append(kind)

    def read(self, first: int, past: int) -> Sequence[Any]:
        """Return some of the values."""
        words = self._words.values
        return [
            number if kind == _FLOAT else int(number) if kind == _INT else words[kind - _WORDS]
            for number, kind in zip(self._numbers[first:past], self._kinds[first:past], strict=True)
        ]

    def cut(self, count: int) -> None:
        """Drop all but the first values."""
        del self._numbers[count:], self._kinds[count:]


class _Sequences:
    """A column of sequences, which are joined; `_ends` is where each ends."""

    __slots__ = ("_ends", "_items")

    def __init__(self, items: str) -> None:
        self._items: array[Any] = array(items)
        self._ends = array("q")

    @property
    def arrays(self) -> tuple[array[Any], ...]:
        """The arrays of the column."""
        return self._items, self._ends

    def _append(self, items: Any) -> None:
        self._items.extend(items)
        self._ends.append(len(self._items))

    def _read(self, first: int, past: int) -> list[array[Any]]:
        ends = self._ends[first:past]
        begins = [self._ends[first - 1] if first else 0, *ends[:-1]]
        return [self._items[begin:end] for begin, end in zip(begins, ends, strict=False)]

    def cut(self, count: int) -> None:
        """Drop all but the first values."""
        del self._ends[count:]
        del self._items[self._ends[-1] if count else 0 :]


class ColumnOfTexts(_Sequences):
    """A column of texts, most of which differ."""

    __slots__ = ()

    def __init__(self, words: Words) -> None:
        super().__init__("B")

    def append(self, text: str) -> None:
        self._append(text.encode("utf-8", "surrogatepass"))

    def read(self, first: int, past: int) -> Sequence[Any]:
        """Return some of the texts."""
        return [each.tobytes().decode("utf-8", "surrogatepass") for each in self._read(first, past)]


class Numbers(_Sequences):
    """A column of tuples of floats."""

    __slots__ = ()

    def __init__(self, words: Words) -> None:
        super().__init__("d")

    def append(self, numbers: Sequence[float]) -> None:
        """Append a tuple."""
        self._append(numbers)

    def read(self, first: int, past: int) -> Sequence[Any]:
        """Return some of the tuples."""
        return list(map(tuple, self._read(first, past)))


Column = Floats | Values | ColumnOfTexts | Numbers


def layout(kind: Any) -> tuple[type[Column], ...]:
    """Return the columns of a `NamedTuple`: for each field the one that it is annotated with.

    Without one, a float has `Floats`, anything else `Values`.
    """
    return tuple(
        each.__metadata__[0] if hasattr(each, "__metadata__") else Floats if each is float else Values
        for each in kind.__annotations__.values()
    )
