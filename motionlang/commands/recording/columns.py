"""The meaning of the columns of a recording: by their names, as a trace or a logger gives them, or by `--map`."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from typing import NamedTuple

from motionlang.commands.recording.clock import is_clock_time, is_date
from motionlang.commands.recording.table import RecordedTable, bare, is_time_name
from motionlang.kernel import ProgramError
from motionlang.kernel.tools import nearest
from motionlang.kernel.tracks import MOTOR, UNITS

# A recorded motor's position is compared with its commanded position.
QUANTITIES = (*UNITS, "actual")
# What a machine has in a recording of its inputs and outputs.
CHANNELS = ("input", "output", "analogue", "position")
# The names that a logger gives to channels, with a number.
_CHANNELS = {
    "input": re.compile(r"(?:d?in|inx|input|di|e)[ _.]?(\d{1,3})", re.IGNORECASE),
    "output": re.compile(r"(?:d?out|outx|output|do|a)[ _.]?(\d{1,3})", re.IGNORECASE),
    "analogue": re.compile(r"(?:ain|adc|ai|analogue)[ _.]?(\d{1,3})", re.IGNORECASE),
}


class Mapped(NamedTuple):
    """The meaning of a column: `target` "time", "position.0" or "input.3", and a `factor`.

    The factor converts the numbers of the column to seconds or user units.
    """

    target: str
    column: str
    factor: float | None


def mapped(text: str) -> Mapped:
    """Return the column that is assigned to a quantity: WHAT=COLUMN or WHAT=COLUMN*FACTOR; raise ValueError."""
    what, equals, column = text.partition("=")
    name, star, factor = column.rpartition("*")
    if not equals or not column:
        raise ValueError(f"{text!r} is not WHAT=COLUMN, such as position.0=PosAct")
    if not star:
        return Mapped(what.strip(), column.strip(), None)
    try:
        return Mapped(what.strip(), name.strip(), float(factor))
    except ValueError:
        raise ValueError(f"{text!r}: {factor!r} is not a number to multiply by") from None


def find(table: RecordedTable, name: str) -> str:
    """Return the column with a name or a number.

    Case is ignored, and the unit in a name may be omitted. Numbers count from 1. Raises ProgramError, with the
    alternatives, if there is no such column or several have the name.
    """
    names = list(table.columns)
    plain = {column.strip().lower(): column for column in names}
    wanted = name.strip().lower()
    if wanted in plain:
        twice = next((k for k, each in enumerate(names, 1) if each == f"{plain[wanted]} ({k})"), 0)
        if twice:
            hint = f"choose one by its number: --map {name}={names.index(plain[wanted]) + 1} or --map {name}={twice}"
            raise ProgramError.of("recording", f"{table.name}: {name} is the name of two columns", hint=hint)
        return plain[wanted]
    without = {bare(column): column for column in reversed(names)}
    if wanted in without:
        return without[wanted]
    if wanted.isdecimal() and 1 <= int(wanted) <= len(names):
        return names[int(wanted) - 1]
    near = nearest(name, names)
    hint = f"did you mean {near}? " if near else ""
    raise ProgramError.of(
        "recording", f"{table.name} has no column {name!r}", hint=f"{hint}its columns are {', '.join(names)}"
    )


def time_columns(table: RecordedTable, wanted: str | None) -> list[str]:
    """Return the column of times, the requested one or one like a time, behind that of its days if it has one."""
    texts = {name: next((cell for cell in cells if cell), "") for name, cells in table.columns.items()}
    if wanted is not None:
        found = find(table, wanted)
    else:
        named = [name for name in texts if is_time_name(name)]
        clocks = [name for name, text in texts.items() if is_clock_time(text) and not is_date(text)]
        candidates = [*named, *clocks]
        if not candidates:
            raise ProgramError.of(
                "recording",
                f"{table.name} has no column named time",
                hint=f"choose one with --map time=NAME; its columns are {', '.join(texts)}",
            )
        found = candidates[0]
    days = [name for name, text in texts.items() if name != found and is_date(text)]
    return [*days[:1], found] if ":" in texts[found] and not _has_date(texts[found]) else [found]


def _has_date(text: str) -> bool:
    return any(sign in text[: text.find(":")] for sign in "-/.")


def assigned(table: RecordedTable, mapping: Sequence[Mapped], kinds: Collection[str]) -> dict[str, Mapped]:
    """Return the columns with a meaning of some kinds by their targets: those of a mapping, and those named so."""
    given = {each.target: each for each in mapping if each.target != "time"}
    named = {each.target: each for each in _named(table.columns, kinds)}
    return named | given


def _named(columns: Iterable[str], kinds: Collection[str]) -> Iterator[Mapped]:
    """Yield the columns that are named like those of a trace, like what they can be assigned to, or as loggers do.

    The measured position precedes the commanded one.
    """
    made: dict[str, Mapped] = {}
    suffixes = {f"{name}_{unit}": name for name, (_, unit) in (UNITS | MOTOR).items() if name in QUANTITIES}
    for column in columns:
        name = bare(column)
        quantity, _, axis = name.partition(".")  # position.0
        if quantity not in QUANTITIES:
            first, _, rest = column.strip().lower().partition("_")  # axis0_position_uu
            quantity, axis = suffixes.get(rest, ""), first.removeprefix("axis") if first[:4] == "axis" else ""
        kind = "position" if quantity == "actual" else quantity
        if axis.isdecimal() and kind in kinds:
            target = f"{kind}.{int(axis)}"
            if quantity == "actual" or target not in made:
                made[target] = Mapped(target, column, None)
        for each, pattern in _CHANNELS.items():
            found = pattern.fullmatch(name)
            if found is not None and each in kinds:
                made[f"{each}.{int(found[1])}"] = Mapped(f"{each}.{int(found[1])}", column, None)
    yield from made.values()
