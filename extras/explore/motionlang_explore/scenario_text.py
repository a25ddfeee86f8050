"""Scenarios as they are written: a comment, settings, tables, and what is expected, one line each."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Mapping
from textwrap import wrap

from motionlang.commands.scenarios import scenario_folder
from motionlang.kernel import Run
from motionlang.kernel.failures import failures
from motionlang.kernel.files import create
from motionlang_explore.exploration import Entry

# The width of a comment, and the tolerance of a position, uu.
WIDTH, WITHIN = 98, 0.001


def scenario_text(about: str, settings: Mapping[str, object], expected: Iterable[Entry]) -> str:
    """Return the text of a scenario: settings in the order of their keys, then tables."""
    tables: dict[str, object] = {key: value for key, value in settings.items() if _is_table(value)}
    parts = [*(f"# {line}\n" for line in wrap(about, WIDTH)), "\n"]
    parts += [f"{key} = {toml_value(settings[key])}\n" for key in sorted(settings.keys() - tables)]
    if entries := [*expected]:
        tables["expect"] = entries
    for table, rows in tables.items():
        assert isinstance(rows, list)
        if table != "netdata":  # a whole number there is an integer, a float has a point
            rows = map(_typed, rows)
        parts += [f"\n{table} = [\n", *(f"  {inline(row)},\n" for row in rows), "]\n"]
    return "".join(parts)


def write_scenario(program: str, names: Iterable[str], text: str) -> str:
    """Write a scenario of a program by the first of the names that is free; return its path.

    Raises OSError if the file cannot be written.
    """
    folder = scenario_folder(program)
    os.makedirs(folder, exist_ok=True)
    paths = (os.path.join(folder, f"{name}.toml") for name in names)
    path = next(path for path in paths if not os.path.lexists(path))
    create(path, text.encode())
    return path


def error_codes(run: Run) -> list[str]:
    """Return the codes of the errors of a run, and of its events that are not allowed, each once."""
    return list(dict.fromkeys(each.code for each in failures(run)))


def positions(run: Run, axes: Iterable[int]) -> Iterator[Entry]:
    """Yield where axes are at the end of a run, as expectations, except those that still move."""
    for number in axes:
        axis = run.controller.axes[number]
        if axis.is_still:
            position = round(axis.scale.position_to_user(axis.actual_position), 4)
            yield {"axis": number, "position": position, "within": WITHIN}


def inline(entry: Entry) -> str:
    """Return an entry as an inline table of TOML."""
    return f"{{ {', '.join(f'{key} = {toml_value(value)}' for key, value in entry.items())} }}"


def toml_value(value: object) -> str:
    if isinstance(value, list):
        return f"[{', '.join(map(toml_value, value))}]"
    text = json.dumps(value, ensure_ascii=False)  # the numbers, truth values and texts of TOML
    return text.replace("\x7f", "\\u007f")


def _is_table(value: object) -> bool:
    return isinstance(value, list) and any(isinstance(each, Mapping) for each in value)


def _typed(entry: Entry) -> Entry:
    value = entry.get("value")
    return {**entry, "value": int(value)} if isinstance(value, float) and value.is_integer() else entry
