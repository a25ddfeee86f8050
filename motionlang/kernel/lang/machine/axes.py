"""Check that the axes in a machine file exist on its controller."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from motionlang.kernel.errors import Diagnostic


def missing_axes(settings: Mapping[str, object], axes: int, first: int) -> list[Diagnostic]:
    """Return a diagnostic for each key and entry whose axis does not exist.

    The axes are numbered from `first`; there are `axes` of them.
    """
    hint = f"the axes are {first} to {first + axes - 1}; controller.axes sets their number"
    return [
        Diagnostic("machine-file", f"{where}: there is no axis {axis}", hint=hint)
        for where, axis in dict.fromkeys(_named(settings))
        if not first <= axis < first + axes
    ]


def _named(settings: Mapping[str, object]) -> Iterator[tuple[str, int]]:
    """Yield the axes that the settings name, each with its key or table."""
    for key, value in settings.items():
        components = key.split(".")
        if components[0] == "axis" and len(components) > 2:
            yield f"axis.{components[1]}", int(components[1])
        elif isinstance(value, list):
            for entry in value:
                if isinstance(entry, dict) and isinstance(entry.get("axis"), int):
                    yield f"[[{key}]]", entry["axis"]
