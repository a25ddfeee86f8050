"""A recording as signals over seconds, with all that was left out of it and why."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from shlex import quote
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.commands.recording.clock import NAMES, ClockTimes, clock
from motionlang.commands.recording.columns import Mapped, assigned, find, time_columns
from motionlang.commands.recording.order import ordered
from motionlang.commands.recording.table import RecordedTable, warning
from motionlang.commands.recording.values import numbers
from motionlang.kernel import Diagnostic, ProgramError, Source
from motionlang.kernel.tools import count_of
from motionlang.views.formatting import grouped

Array = NDArray[np.float64]

# A time step this many times the usual one is a gap.
GAP = 3.5
# A recording has a row only where something changes if at most this share of its rows repeats the row before, and if
# the long steps between rows (upper tenth) are so many times the short ones (lower tenth): the first where rows may
# repeat the levels of all channels, the second where they do not either. So many rows show it.
REPEATS, UNEVEN, UNEVEN_LEVELS, MIN_EVENTS = 0.1, 3.0, 1.5, 6
# The resolution of the times of events, s.
MIN_STEP = 1e-4
# A column with fewer numbers has nothing to compare.
MIN_NUMBERS = 3


class RecordedSignal(NamedTuple):
    """The measured values of a target such as "position.0" or "input.3" at `times` (s), without NaN.

    A factor of `--map` is not applied to a digital channel, where a negative one inverts it.
    """

    target: str
    column: str
    times: Array
    values: Array
    factor: float | None

    @property
    def scaled(self) -> Array:
        """The values in user units."""
        return self.values if self.factor is None else self.values * self.factor


class Recording(NamedTuple):
    """The content of a recording: signals by target, the usual `step` between rows in s, and where rows are missing.

    `sentence` says what was read, `remarks` what was left out. The rows are `events` if there is one only where
    something changes; their step is then the shortest one.
    """

    name: str
    source: Source | None
    times: Array
    step: float
    gaps: tuple[tuple[float, float], ...]
    events: bool
    signals: dict[str, RecordedSignal]
    sentence: str
    remarks: tuple[Diagnostic, ...]


def read_recording(
    table: RecordedTable,
    mapping: Sequence[Mapped] = (),
    kinds: Collection[str] = (),
    *,
    length: float | None = None,
    checked: Callable[[str], object] = bool,
) -> Recording:
    """Return the signals of some kinds in a table; raise ProgramError if it has none.

    `length` is that of the run, in s, which decides about times without a unit. `checked` raises ProgramError for a
    target that is wrong.
    """
    targets = assigned(table, mapping, kinds)
    for target in targets:
        checked(target)
    given = next((each for each in mapping if each.target == "time"), None)
    names = time_columns(table, given.column if given else None)
    cells = table.columns[names[-1]]
    if len(names) > 1:
        cells = [f"{day} {time}" for day, time in zip(table.columns[names[0]], cells, strict=True)]
    found = clock(cells, table.units.get(names[-1], ""), given.factor if given else None, length)
    remarks = [*table.remarks, *_clock_remarks(found, names[-1], table)]
    remarks += _left_out(
        found.seconds, cells, table, f"{names[-1]}: {{}} not a time", "their rows are left out"
    )
    texts = list(table.columns.values())
    order = ordered(found.seconds, table.lines, lambda a, b: all(column[a] == column[b] for column in texts))
    remarks += order.remarks
    if len(order.rows) < 3 or not order.times[-1] > order.times[0]:
        raise ProgramError.of(
            "recording",
            f"{table.name} has fewer than three rows with a time",
            hint=f"{names[-1]} is its time; choose another column with --map time=NAME",
        )
    rows, times = order.rows, order.times
    begin = found.begin(float(times[0]))
    if found.kind:
        times = times - times[0]
    signals: dict[str, RecordedSignal] = {}
    for target, each in targets.items():
        column = find(table, each.column)
        values = numbers(table.columns[column])[rows]
        good = np.isfinite(values)
        if good.sum() >= MIN_NUMBERS:
            signals[target] = RecordedSignal(target, column, times[good], values[good], each.factor)
        elif any(given.target == target for given in mapping):
            raise ProgramError.of("recording", f"{column} has fewer than three numbers that can be compared")
        else:
            remarks.append(warning(f"{column} has fewer than three numbers, and is left out"))
    events = _are_events(signals, times)
    for column in dict.fromkeys(each.column for each in signals.values()):
        # In a row of an event, an empty cell is a channel that has not changed.
        cells = [cell or "0" for cell in table.columns[column]] if events else table.columns[column]
        values = np.where(np.isfinite(found.seconds), numbers(cells), 0.0)
        remarks += _left_out(values, cells, table, f"{column}: {{}} not a number", "they are left out")
    steps = np.diff(times)
    step = max(float(steps.min()), MIN_STEP) if events else float(np.median(steps))
    wide = np.flatnonzero(steps > GAP * step) if not events else np.zeros(0, dtype=np.int64)
    gaps = tuple((float(times[k]), float(times[k + 1])) for k in wide)
    used = {*names, *(each.column for each in signals.values())}
    sentence = _sentence(table, begin, rows, times, step, gaps, events, used)
    return Recording(table.name, table.source, times, step, gaps, events, signals, sentence, tuple(remarks))


def _left_out(
    values: Array, cells: Sequence[str], table: RecordedTable, text: str, hint: str
) -> list[Diagnostic]:
    """Return the warning of cells that have no value, with the first one."""
    wrong = np.flatnonzero(~np.isfinite(values))
    if not len(wrong):
        return []
    first = cells[wrong[0]]
    count = f"{count_of(len(wrong), 'value')} of {len(values)}"
    message = f"{text.format(count)}, the first is {repr(first[:40]) if first else 'nothing'}"
    return [warning(message, int(table.lines[wrong[0]]), hint)]


def _clock_remarks(found: ClockTimes, name: str, table: RecordedTable) -> list[Diagnostic]:
    remarks = [warning(text, int(table.lines[row])) for text, row in found.changes]
    if found.doubt is not None:
        text, scale, other = found.doubt
        mapping = f"time={name}*{other:g}"
        mapping = quote(mapping) if " " in name else mapping
        hint = f"if this is wrong, give the seconds of its unit: --map {mapping}"
        remarks.append(warning(f"{name}: {text}; taken as {NAMES[scale]}", hint=hint))
    return remarks


def _are_events(signals: dict[str, RecordedSignal], times: Array) -> bool:
    """True if a recording has a row only where something changes."""
    if len(times) < MIN_EVENTS:
        return False
    columns = [_held(each, times) for each in signals.values()]
    levels = [each for each in columns if len(np.unique(each)) == 2]
    if not levels:
        return False
    low, high = np.quantile(np.diff(times), (0.1, 0.9))
    least = UNEVEN_LEVELS if _repeats(levels) <= REPEATS else UNEVEN
    return bool(_repeats(columns) <= REPEATS and high >= least * low)


def _repeats(columns: Sequence[Array]) -> float:
    """Return the share of the rows that have the values of the row before."""
    return float(np.logical_and.reduce([np.diff(each) == 0.0 for each in columns]).mean())


def _held(signal: RecordedSignal, times: Array) -> Array:
    """Return a value for each row: where there is none, that of the row before."""
    return signal.values[np.clip(np.searchsorted(signal.times, times, "right") - 1, 0, None)]


def _sentence(
    table: RecordedTable,
    begin: str,
    rows: NDArray[np.int64],
    times: Array,
    step: float,
    gaps: Sequence[tuple[float, float]],
    events: bool,
    used: set[str],
) -> str:
    parts = [
        f"{grouped(len(rows))} of {grouped(len(table.lines))} rows",
        f"{_time(times[0])} to {_time(times[-1])} s" + (f" from {begin}" if begin else ""),
        "a row only where something changes" if events else f"every {step:.3g} s",
    ]
    if gaps:
        since, until = max(gaps, key=lambda gap: gap[1] - gap[0])
        parts.append(f"{count_of(len(gaps), 'gap')} ({until - since:.3g} s at {_time(since)} s)")
    parts.append(f"{count_of(len(used), 'column')} used of {len(table.columns)}")
    return f"{table.name}: {', '.join(parts)}"


def _time(seconds: float) -> str:
    return f"{round(float(seconds), 3) + 0.0:.12g}"
