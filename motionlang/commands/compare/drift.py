"""The rate of a recording's clock against that of the run, by strokes that both have.

Nothing but the clock and the drive changes the time between two positions within a stroke. `init` asks the strokes
alone, since what its machine waits for is not known yet. `compare` asks the rests between them, too: a slower drive
does not make them longer.
"""

from __future__ import annotations

from collections.abc import Sequence
from statistics import median

import numpy as np

from motionlang.commands.compare.alignment import Signal
from motionlang.commands.compare.strokes import Matched

# The clock is measured between these shares of the travel of a stroke, in so many strokes of so many rows at least. It
# differs by so many standard deviations.
PASSED, MIN_PASSED, MIN_ROWS = (0.25, 0.75), 6, 12
CERTAIN = 4.0
# A clock differs by at least this share. What differs by more than the second share is the motion.
CLOCK, MAX_CLOCK = 4e-4, 0.02
# Strokes and what lies between their starts agree if their rates differ by less than this share of the drift.
AGREE = 1 / 3


def clock_rate(times: Sequence[tuple[float, float]]) -> float | None:
    """Return how many seconds a recording counts for one of the run, None if that is not certain.

    `times` are those between two positions of the same stroke, in the run and in the recording.
    """
    if len(times) < MIN_PASSED:
        return None
    usual = median(theirs / mine for mine, theirs in times)
    rest = CERTAIN * median(abs(theirs - usual * mine) for mine, theirs in times) + 1e-9
    mine, theirs = np.array([each for each in times if abs(each[1] - usual * each[0]) <= rest]).T
    ratio = float(theirs.sum() / mine.sum())
    error = float(np.sqrt(np.square(theirs - ratio * mine).sum()) / mine.sum())
    return ratio if max(CLOCK, CERTAIN * error) < abs(ratio - 1.0) < MAX_CLOCK else None


def clock_text(rate: float) -> str:
    """Return the sentence about a clock that counts so many seconds for one of the run."""
    text = f"{100.0 * abs(rate - 1.0):.1g} % {'fast' if rate > 1.0 else 'slow'}"
    return f"the clock of the recording is {text}; its times are corrected"


def drift(found: Sequence[Signal], matches: Sequence[Matched | None]) -> float | None:
    """Return the rate of the clock of a recording by its strokes and by the rests between them; None if it is right."""
    passed: list[tuple[float, float]] = []
    starts: list[tuple[float, float]] = []
    for signal, matched in zip(found, matches, strict=True):
        if matched is None:
            continue
        least = MIN_ROWS * float(np.median(np.diff(signal.times)))
        first = matched.pairs[0]
        for pair in matched.pairs:
            starts.append((pair.run.begin - first.run.begin, pair.recorded.begin - first.recorded.begin))
            mine, theirs = (
                each.reached(PASSED[1], at_end=False) - each.reached(PASSED[0], at_end=False)
                for each in (pair.run, pair.recorded)
            )
            if not matched.has_other_travel(pair) and min(mine, theirs) > least:
                passed.append((mine, theirs))
    rate = clock_rate(passed)
    if rate is None:
        return None
    mine, theirs = np.array(starts).T
    between = float(mine @ theirs / (mine @ mine)) if mine.any() else 1.0
    return rate if abs(between - rate) < AGREE * abs(rate - 1.0) else None
