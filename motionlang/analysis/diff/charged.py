"""What each line of a program has of the difference in time of two runs, along their critical chains."""

from __future__ import annotations

import re

from motionlang.analysis.cycle.profile import TimeProfile
from motionlang.analysis.diff.align import aligned
from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.result import Run

_FIGURES = re.compile(r"\d[\d.]*")
# Seconds that are rounding.
NOTHING = 1e-9


@record
class Charge:
    """By how many `seconds` more a run waited for a line, by its number in the `old` and the `new` program.

    None where only one of them has it; 0 for what stands on no line.
    """

    old: int | None
    new: int | None
    seconds: float


def _words(line: object) -> str:
    return str(line).strip()


def charged(old: Run, new: Run) -> list[Charge]:
    """The lines that the new run waited for longer or shorter, the largest first: together that is its difference."""
    text, other_text = (run.source.text.split("\n") for run in (old, new))
    was, is_ = ({share.line: share.seconds for share in TimeProfile(run).lines()} for run in (old, new))
    found = [Charge(0, 0, is_.get(0, 0.0) - was.get(0, 0.0))]
    for i, j in aligned(text, other_text, _words, lambda line: _FIGURES.sub("", _words(line)), lambda _: 0):
        before, now = None if i is None else i + 1, None if j is None else j + 1
        seconds = is_.get(now or -1, 0.0) - was.get(before or -1, 0.0)
        found.append(Charge(before, now, seconds))
    return sorted(
        (each for each in found if abs(each.seconds) > NOTHING),
        key=lambda each: (-round(abs(each.seconds), 9), each.new or 0, each.old or 0),
    )
