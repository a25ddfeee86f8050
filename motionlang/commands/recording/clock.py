"""The times of a recording in seconds: units, epochs, dates, times of day.

A column of numbers has the unit of its name or of the row below it. Without one, numbers that are the nanoseconds to
seconds since 1970, or the days of a spreadsheet, are known by their size, and others by their length against that of
the run: a recording of 2380 belongs to a run of 2.3 s if it counts milliseconds.

A column of text has dates, times of day, or both, in the forms of ISO 8601 and of the world's spreadsheets. Times of
day go on over midnight, and a clock that jumps by an hour between two rows does so for summer time. Dates and epochs
count from the first row.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from datetime import UTC, date, datetime
from math import inf, log10, nan
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.commands.recording.values import numbers

Array = NDArray[np.float64]

# The seconds of a unit.
SECONDS = {
    **dict.fromkeys(("s", "sec", "secs", "second", "seconds", "sekunden"), 1.0),
    **dict.fromkeys(("ms", "msec", "millis", "milliseconds", "millisekunden"), 1e-3),
    **dict.fromkeys(("us", "µs", "μs", "usec", "micros", "microseconds"), 1e-6),
    **dict.fromkeys(("ns", "nsec", "nanos", "nanoseconds"), 1e-9),
    **dict.fromkeys(("min", "minutes"), 60.0),
    **dict.fromkeys(("h", "hours"), 3600.0),
    **dict.fromkeys(("d", "days"), 86400.0),
}
NAMES = {1.0: "s", 1e-3: "ms", 1e-6: "µs", 1e-9: "ns", 86400.0: "days"}
DAY, HOUR = 86400.0, 3600.0
# Seconds since 1970 between these, which a recording of less than so many seconds has, are dates.
EPOCH, LONGEST = (6e8, 4e9), 1e6
# Days of a spreadsheet, from 1954 to 2119, and the largest step of them from row to row.
SHEET, SHEET_STEP = (20_000.0, 80_000.0), 1e-4
SHEET_ZERO = date(1899, 12, 30)
# Without a unit, times that are so many times as long as the run are in a smaller unit.
LONGER = 1000.0**0.5
# A recording so near to a power of 1000 times the length of the run may have another unit.
NEAR = 1.5
# Rows take at most so many usual steps each, but for pauses.
SPAN_STEPS = 3.0
# Whole numbers that step by so much count no seconds: evenly, or not.
EVEN_STEP, UNEVEN_STEP, EVEN = 5.0, 100.0, 1.5
# An hour of summer time is exact but for so many usual steps, and this, s; it shows in more rows than these.
SUMMER_STEPS, SUMMER, MIN_SUMMER = 3.0, 1.0, 10

_DATE = re.compile(r"(\d{1,4})[-/.](\d{1,2}|[A-Za-z]{3})[-/.](\d{1,4})\.?")
_TIME = re.compile(
    r"(\d{1,3}):(\d{1,2})(?::(\d{1,2}))?(?:([.,:])(\d{1,9}))?(?:\s*([ap])\.?m\.?)?", re.IGNORECASE
)
_MONTHS = {
    name: k
    for k, name in enumerate(
        ["jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec"], 1
    )
}
_MONTHS |= {"mai": 5, "okt": 10, "dez": 12}


class ClockTimes(NamedTuple):
    """Seconds of the rows, NaN where there are none, since 1970 if they are a `date`, since midnight if a `day`.

    `doubt` says why the unit may be wrong, with its factor and the one to try, and `changes` what the clock did, each
    with the row.
    """

    seconds: Array
    kind: Literal["", "date", "day"] = ""
    doubt: tuple[str, float, float] | None = None
    changes: tuple[tuple[str, int], ...] = ()

    def begin(self, seconds: float) -> str:
        """Return the date or the time of day of a second; "" if times are plain numbers."""
        if not self.kind or not 0.0 <= seconds < EPOCH[1]:
            return ""
        moment = datetime.fromtimestamp(seconds, UTC)
        return f"{moment:%Y-%m-%d %H:%M:%S}" if self.kind == "date" else f"{moment:%H:%M:%S}"


def is_clock_time(cell: str) -> bool:
    """True if a text has a date or a time of day."""
    return (":" in cell[1:] and "day" in _parts(cell)) or _DATE.fullmatch(cell) is not None


def is_date(cell: str) -> bool:
    """True if a text has a date and no time of day."""
    return _DATE.fullmatch(cell) is not None


def clock(cells: Sequence[str], unit: str, factor: float | None, length: float | None) -> ClockTimes:
    """Return the seconds of a column of times.

    Without a factor and a unit, numbers are in the unit that fits the length of the run.
    """
    values = numbers(cells)
    filled = len([cell for cell in cells if cell])
    if 2 * int(np.isfinite(values).sum()) >= filled:
        return _of_numbers(values, unit, factor, length)
    found = _of_texts(cells)
    return found if factor is None else found._replace(seconds=found.seconds * factor)


# ------------------------------------------------------------------------------------------ numbers


def _of_numbers(values: Array, unit: str, factor: float | None, length: float | None) -> ClockTimes:
    known = values[np.isfinite(values)]
    scale = factor if factor is not None else SECONDS.get(unit.lower())
    if len(known) < 2:
        return ClockTimes(values * (scale or 1.0))
    middle = float(np.median(known))
    # A few wrong cells, or a pause, do not make a recording long.
    low, high = np.quantile(known, (0.02, 0.98))
    different = np.unique(known)
    step = float(np.median(np.diff(different))) if len(different) > 1 else 0.0
    span = min(float(high - low) / 0.96, SPAN_STEPS * step * len(different))
    doubt = None
    if scale is None:
        scale = _epoch_unit(middle, span)
        if scale is not None and scale != 1.0:
            doubt = "the times are large numbers without a unit", scale, scale
    if scale is None and _is_sheet(known, middle, span, length):
        begin = datetime.combine(SHEET_ZERO, datetime.min.time(), UTC).timestamp()
        return ClockTimes(begin + values * DAY, "date")
    if scale is None:
        scale, text = _scale_by_length(known, span, length)
        doubt = (text, scale, scale) if text else None
    elif factor is None and length and span:
        thousands = round(log10(span * scale / length) / 3.0)
        times = span * scale / length / 1000.0**thousands
        if thousands and 1.0 / NEAR < times < NEAR:
            size = f"{1000.0 ** abs(thousands):.0f} times as {'long' if thousands > 0 else 'short'}"
            doubt = f"the times are {size} as the run", scale, scale / 1000.0**thousands
    is_date = EPOCH[0] < middle * scale < EPOCH[1] and span * scale < LONGEST
    return ClockTimes(values * scale, "date" if is_date else "", doubt)


def _epoch_unit(middle: float, span: float) -> float | None:
    for scale in (1.0, 1e-3, 1e-6, 1e-9):
        if EPOCH[0] < middle * scale < EPOCH[1]:
            return scale if span * scale < LONGEST else None
    return None


def _is_sheet(known: Array, middle: float, span: float, length: float | None) -> bool:
    """True if numbers are days since 1899."""
    steps = np.abs(np.diff(known))
    step = float(np.median(steps[steps > 0.0])) if (steps > 0.0).any() else inf
    if not SHEET[0] < middle < SHEET[1] or step > SHEET_STEP:
        return False
    return not length or abs(log10(span * DAY / length)) < abs(log10(span / length))


def _scale_by_length(known: Array, span: float, length: float | None) -> tuple[float, str]:
    """Return the seconds of a unit that nothing names, and why it is not the second."""
    if length:
        times = span / length
        if times < LONGER:
            return 1.0, ""
        scale = 1000.0 ** -min(3, round(log10(times) / 3.0))
        return scale, f"the times have no unit, and are {float(f'{times:.2g}'):g} times as long as the run"
    steps = np.abs(np.diff(np.unique(known)))
    if not len(steps) or (known != np.round(known)).any():
        return 1.0, ""
    step, (low, high) = float(np.median(steps)), np.quantile(steps, (0.1, 0.9))
    if step < (EVEN_STEP if high <= EVEN * low else UNEVEN_STEP):
        return 1.0, ""
    scale = 1e-3 if step < 2e3 else 1e-6 if step < 2e6 else 1e-9
    return scale, f"the times have no unit, and are whole numbers {step:g} apart"


# ------------------------------------------------------------------------------------------ texts


def _of_texts(cells: Sequence[str]) -> ClockTimes:
    day_first = _is_day_first(cells)
    seconds = np.array([_seconds(cell, day_first) for cell in cells], dtype=np.float64)
    if not np.isfinite(seconds).any():
        return ClockTimes(seconds)
    rows = np.flatnonzero(np.isfinite(seconds))
    has_date = any("date" in _parts(cells[k]) for k in rows[:3])
    is_local = not any(_has_zone(cells[k]) for k in rows[:3])
    changes: list[tuple[str, int]] = []
    if not has_date:
        steps = np.diff(seconds[rows])
        turns = np.where(np.abs(steps) > DAY / 2, -np.sign(steps), 0.0)
        if turns.any() and seconds[rows].max() < DAY:
            seconds[rows] += DAY * np.append(0.0, np.cumsum(turns))
            changes.append(("the time of day goes over midnight", int(rows[1:][turns != 0.0][0])))
    if is_local and len(rows) > MIN_SUMMER:
        steps = np.diff(seconds[rows])
        usual = float(np.median(np.abs(steps)))
        near = np.abs(np.abs(steps) - HOUR) <= SUMMER_STEPS * usual + SUMMER
        if near.sum() == 1:
            at = int(np.flatnonzero(near)[0])
            seconds[rows[at + 1 :]] -= HOUR * np.sign(steps[at])
            where = "back" if steps[at] < 0.0 else "forward"
            changes.append((f"the clock is put {where} by an hour, as for summer time", int(rows[at + 1])))
    return ClockTimes(seconds, "date" if has_date else "day", changes=tuple(changes))


def _parts(cell: str) -> dict[str, str]:
    """Return the "date" and the "day" (its time) in a text, those that it has."""
    cell = cell.strip().replace("T", " ")
    found = _TIME.search(cell)
    if found is None:
        return {}
    before = cell[: found.start()].strip(" ,;")
    made = {"day": found[0]}
    if _DATE.fullmatch(before):
        made["date"] = before
    elif before:
        return {}
    return made


def _has_zone(cell: str) -> bool:
    try:
        return datetime.fromisoformat(cell).tzinfo is not None
    except ValueError:
        return False


def _seconds(cell: str, day_first: bool) -> float:
    """Return the seconds of a date since 1970, or of a time since midnight; NaN if a text has neither."""
    try:
        made = datetime.fromisoformat(cell)
    except ValueError:
        return _in_figures(cell, day_first)
    if made.tzinfo is None:
        made = made.replace(tzinfo=UTC)
    return (made - datetime(1970, 1, 1, tzinfo=UTC)).total_seconds()


def _in_figures(cell: str, day_first: bool) -> float:
    parts = _parts(cell)
    found = _TIME.fullmatch(parts.get("day", ""))
    if found is None:
        return nan
    first, second, third, sign, fraction, half = found.groups()
    rest = 0.0 if fraction is None else int(fraction) / (1000.0 if sign == ":" else 10.0 ** len(fraction))
    if third is None and fraction is not None:
        seconds = 60.0 * int(first) + int(second) + rest  # minutes and seconds
    else:
        hours = int(first) % 12 + 12 * (half in "pP") if half else int(first)
        seconds = HOUR * hours + 60.0 * int(second) + int(third or 0) + rest
    if "date" not in parts:
        return seconds
    day = _day(parts["date"], day_first)
    return nan if day is None else DAY * day + seconds


def _day(text: str, day_first: bool) -> int | None:
    """Return the days of a date since 1970."""
    found = _DATE.fullmatch(text)
    assert found is not None
    first, second, third = found.groups()
    if second.isalpha():
        year, month, day = third, str(_MONTHS.get(second.lower(), 0)), first
    elif len(first) > 2:
        year, month, day = first, second, third
    else:
        year, (day, month) = third, (first, second) if day_first else (second, first)
    try:
        return date(int(year) + (2000 if len(year) <= 2 else 0), int(month), int(day)).toordinal() - EPOCH_DAY
    except ValueError:
        return None


EPOCH_DAY = date(1970, 1, 1).toordinal()


def _is_day_first(cells: Sequence[str]) -> bool:
    """True if the day comes before the month in dates that do not begin with the year."""
    dates = [text for cell in cells if (text := _parts(cell).get("date", "")) and "/" in text]
    pairs = [
        tuple(int(each) for each in text.split("/")[:2]) for text in dates if text.replace("/", "").isdigit()
    ]
    firsts, seconds = {pair[0] for pair in pairs}, {pair[1] for pair in pairs}
    if not pairs or max(firsts) > 12:
        return True
    if max(seconds) > 12 or any(cell.rstrip(". ").lower().endswith("m") for cell in cells[:3]):
        return False
    return len(firsts) > len(seconds)
