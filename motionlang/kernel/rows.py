"""Rows as a polars or pandas table.

Both libraries are the user's: they are imported on use, and no extra installs them.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from motionlang.kernel.tools import need


class RowTable:
    """Base of classes whose rows can be converted to a table."""

    __slots__ = ()
    # The types of columns that every table of the class has, also without rows.
    types: ClassVar[Mapping[str, type]] = {}

    def columns(self) -> dict[str, list[Any]]:
        """Return the columns by name, of equal length; a missing value is None."""
        raise NotImplementedError

    def to_polars(self) -> Any:
        """Return a `polars.DataFrame`; MissingExtra, an ImportError, if polars is missing."""
        need("to_polars", "polars")
        import polars

        return polars.DataFrame(self.columns(), schema_overrides=self.types, strict=False)

    def to_pandas(self) -> Any:
        """Return a `pandas.DataFrame`; MissingExtra, an ImportError, if pandas is missing."""
        need("to_pandas", "pandas")
        import pandas

        numbers = {name: kind for name, kind in self.types.items() if kind is not str}
        return pandas.DataFrame(self.columns()).astype(numbers)


def transposed(rows: list[dict[str, Any]], names: tuple[str, ...] = ()) -> dict[str, list[Any]]:
    """Return rows as columns.

    Columns in `names` come first, then others in order of appearance. A column with integers and floats contains only
    floats.
    """
    found = dict.fromkeys(names)
    for row in rows:
        found.update(dict.fromkeys(row))
    return {name: _of_one_type([row.get(name) for row in rows]) for name in found}


def _of_one_type(values: list[Any]) -> list[Any]:
    kinds = {type(value) for value in values} - {type(None)}
    if kinds == {int, float}:
        return [None if value is None else float(value) for value in values]
    return values
