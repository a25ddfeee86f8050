"""The cycle of a machine: the times between the occurrences of something that a run repeats.

    cycle(12)            a move that line 12 starts; without one, a wait that begins there
    cycle(output 3)      output 3 is switched on
    cycle(print placed)  a line with this text is printed

Without a further word it is the median of these times; `.least`, `.most` and `.count` are the others.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise
from statistics import median

from motionlang.kernel.result import Run

FORM = re.compile(r"cycle\((?:(\d{1,9})|output +(\d{1,4})|print +([^()]+))\)(?:\.(median|least|most|count))?")
HELP = "cycle(LINE), cycle(output N) or cycle(print TEXT), with .least, .most or .count"


def cycle_of(run: Run, name: str) -> float | int | None:
    """Return the cycle of a run by its name; None if nothing occurs twice. Raise ValueError for another form."""
    form = FORM.fullmatch(name)
    if form is None:
        raise ValueError(f"{name} is no cycle; write {HELP}")
    line, output, text, figure = form.groups()
    times = list(_times(run, line, output, text))
    periods = [after - before for before, after in pairwise(times)]
    if figure == "count":
        return len(periods)
    if not periods:
        return None
    return {"least": min, "most": max}.get(figure, median)(periods)


def _times(run: Run, line: str | None, output: str | None, text: str | None) -> Iterator[float]:
    log = run.machine.log
    if output is not None:
        yield from (each.time for each in log.outputs if each.channel == int(output) and each.value)
    elif text is not None:
        yield from (each.time for each in log.prints if text.strip() in each.text)
    else:
        starts = [each.start_time for each in log.moves if each.line == int(line or 0)]
        yield from starts or _waits(run, int(line or 0))


def _waits(run: Run, line: int) -> Iterator[float]:
    lines: dict[int, int] = {}
    for wait in run.machine.log.waits.written():
        if wait.at not in lines:
            lines[wait.at] = run.dialect.locate(run.source, wait.at)[0]
        if lines[wait.at] == line:
            yield wait.since
