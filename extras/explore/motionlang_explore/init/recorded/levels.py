"""The level of an analogue input in a recording: constant, in steps, or the recording itself as a table."""

from __future__ import annotations

import numpy as np

from motionlang_explore.exploration import Entry
from motionlang_explore.identification.positions import Series

# A level changes by more than so many percent, or so many times the noise.
LEAST, NOISE = 1.0, 6.0
# More steps are a table, which has so many rows at most.
MAX_STEPS, MAX_ROWS = 20, 200


def levels_of(number: int, series: Series) -> list[tuple[Entry, str]]:
    """Return the entries of an analogue input, each with its comment."""
    noise = float(np.median(np.abs(np.diff(series.values))))
    steps = _steps(series, max(LEAST, NOISE * noise))
    if len(steps) > MAX_STEPS:
        stride = -(-len(series.times) // MAX_ROWS)
        rows = [*zip(series.times.tolist(), series.values.tolist(), strict=True)][::stride]
        texts = [f"the recording, a row every {stride} of its own", *[""] * (len(rows) - 1)]
    else:
        rows = steps
        texts = ["constant" if len(steps) == 1 else "in steps", *[""] * (len(steps) - 1)]
    return [
        ({"channel": number, "value": round(value, 2), "at": round(time, 3) if k else 0.0}, text)
        for k, ((time, value), text) in enumerate(zip(rows, texts, strict=True))
    ]


def _steps(series: Series, tolerance: float) -> list[tuple[float, float]]:
    """Return where the level changes, and the mean level from there on."""
    found: list[tuple[float, float]] = []
    first = 0
    values = series.values
    level, count = float(values[0]), 1
    for k in range(1, len(values)):
        later = values[k : k + 2]
        if abs(later - level).min() > tolerance:
            found.append((_before(series, first), float(np.median(values[first:k]))))
            first, level, count = k, float(values[k]), 1
        elif abs(values[k] - level) <= tolerance:
            count += 1
            level += (float(values[k]) - level) / count
    return [*found, (_before(series, first), float(np.median(values[first:])))]


def _before(series: Series, row: int) -> float:
    """Return the time of the row before: a level is there when the program sees it, which may be in the same row."""
    return float(series.times[max(row - 1, 0)])
