"""The cycle of a machine: the times between the occurrences of something that a run repeats.

    cycle(12)            a move that line 12 starts; without one, a wait, an output or a printed line of line 12;
                         axes that start together start once
    cycle(output 3)      output 3 is switched on
    cycle(print placed)  a line with this text is printed

Without a further word it is the median of these times; `.least`, `.most` and `.count` are the others.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise
from statistics import median

from motionlang.kernel import Run

FORM = re.compile(r"cycle\((?:(\d{1,9})|output +(\d{1,4})|print +([^()]+))\)(?:\.(median|least|most|count))?")
# What a line can do twice, by the stream of the log, the most telling first.
STATEMENTS = ("moves", "waits", "outputs", "analogue_outputs", "prints")
# The figures of a printed text, and how many names a note has.
_FIGURES, MAX_NAMES = re.compile(r"[-+]?\d"), 12
HELP = "cycle(LINE), cycle(output N) or cycle(print TEXT), with .least, .most or .count"


def cycle_of(run: Run, name: str) -> float | int | None:
    """Return the cycle of a run by its name; None if nothing occurs twice. Raise ValueError for another form."""
    form = FORM.fullmatch(name)
    if form is None:
        raise ValueError(f"{name} is no cycle; write {HELP}")
    line, output, text, figure = form.groups()
    times = _times(run, line, output, text)
    periods = [after - before for before, after in pairwise(times)]
    if figure == "count":
        return len(periods)
    if not periods:
        return None
    return {"least": min, "most": max}.get(figure, median)(periods)


def cycles_of(run: Run) -> list[str]:
    """Return the names of the cycles that a run has, by line, output and text."""
    log = run.machine.log
    lines = sorted({line for name in STATEMENTS for line, _ in _occurrences(run, name)})
    names = [f"cycle({line})" for line in lines if line]
    names += [f"cycle(output {channel})" for channel in sorted({each.channel for each in log.outputs})]
    texts = (_FIGURES.split(each.text)[0].strip() for each in log.prints)
    names += [f"cycle(print {text})" for text in dict.fromkeys(texts) if text]
    return [name for name in names if FORM.fullmatch(name) and cycle_of(run, name) is not None]


def no_cycle_notes(run: Run, values: Mapping[str, object]) -> list[str]:
    """Return a note for the cycles among some quantities that have no value: which others have one."""
    lacking = [name for name, value in values.items() if value is None and FORM.fullmatch(name)]
    if not lacking:
        return []
    found = cycles_of(run)
    shown = ", ".join(found[:MAX_NAMES]) + (
        f" and {len(found) - MAX_NAMES} more" if len(found) > MAX_NAMES else ""
    )
    there = f"these have one: {shown}" if found else "no line, output or text occurs twice"
    return [f"{' and '.join(lacking)} {'has' if len(lacking) == 1 else 'have'} no value; {there}"]


def _times(run: Run, line: str | None, output: str | None, text: str | None) -> list[float]:
    log = run.machine.log
    if output is not None:
        return [each.time for each in log.outputs if each.channel == int(output) and each.value]
    if text is not None:
        return [each.time for each in log.prints if text.strip() in each.text]
    number = int(line or 0)
    found = (
        list(dict.fromkeys(time for at, time in _occurrences(run, name) if at == number))
        for name in STATEMENTS
    )
    return next((times for times in found if times), [])


def _occurrences(run: Run, name: str) -> Iterator[tuple[int, float]]:
    """Yield line and time of each record of a stream of the log."""
    log = run.machine.log
    if name == "moves":
        yield from ((move.line, move.start_time) for move in log.moves)
        return
    records: Iterable[tuple[int, float]]
    if name == "waits":
        records = ((wait.at, wait.since) for wait in log.waits.written())
    else:
        records = ((each.at, each.time) for each in getattr(log, name))
    lines = {-1: 0}
    for at, time in records:
        if at not in lines:
            lines[at] = run.dialect.locate(run.source, at)[0]
        yield lines[at], time
