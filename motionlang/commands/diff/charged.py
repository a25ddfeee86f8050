"""The time difference between two runs by program line, along the critical paths."""

from __future__ import annotations

import re
from dataclasses import dataclass

from motionlang.commands.profile.profile import TimeProfile
from motionlang.comparison.align import aligned
from motionlang.kernel import Run

_FIGURES = re.compile(r"\d[\d.]*")
# Seconds that are rounding.
NOTHING = 1e-9


@dataclass(eq=False, slots=True)
class Charge:
    """How many `seconds` longer the new run waited for a line.

    `old` and `new` are the line's numbers in the two programs: None if only the other program has the line, 0
    for time that belongs to no line. `text` is the line.
    """

    old: int | None
    new: int | None
    seconds: float
    text: str = ""


def _words(line: object) -> str:
    return str(line).strip()


def charged(old: Run, new: Run, cycles: tuple[float, float] | None = None) -> list[Charge]:
    """Return the lines that the new run waited for longer or shorter, largest first.

    Their seconds add up to the time difference of the runs, or, with the periods of their `cycles`, to about that of
    these.
    """
    shares = (1.0, 1.0) if cycles is None else (cycles[0] / old.time, cycles[1] / new.time)
    text, other_text = (run.source.text.split("\n") for run in (old, new))
    was, is_ = (
        {each.line: share * each.seconds for each in TimeProfile(run).lines()}
        for run, share in zip((old, new), shares, strict=True)
    )
    found = [Charge(0, 0, is_.get(0, 0.0) - was.get(0, 0.0))]
    for i, j in aligned(text, other_text, _words, lambda line: _FIGURES.sub("", _words(line)), lambda _: 0):
        before, now = None if i is None else i + 1, None if j is None else j + 1
        seconds = is_.get(now or -1, 0.0) - was.get(before or -1, 0.0)
        line = text[i] if i is not None and j is None else "" if j is None else other_text[j]
        found.append(Charge(before, now, seconds, _words(line)))
    return sorted(
        (each for each in found if abs(each.seconds) > NOTHING),
        key=lambda each: (-round(abs(each.seconds), 9), each.new or 0, each.old or 0),
    )
