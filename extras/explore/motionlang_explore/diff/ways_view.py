"""Two programs compared in all ways, as text and as data."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby

from motionlang.commands.channels import channels_of
from motionlang.comparison.acts import WITHIN
from motionlang.kernel import dialect
from motionlang.kernel.tools import count_of, lines_words, ranges
from motionlang.views.differences import difference_words, later_words
from motionlang.views.table import Column, Document, Table
from motionlang.views.terminal import printable
from motionlang_explore.diff.ways import (
    MAX_TIMES,
    TIMES,
    CycleTime,
    FoundDifference,
    Way,
    WaysCompared,
)
from motionlang_explore.exploration import Change, Exploration, Timeline

# So many steps of a way, and rows of what may only be a consequence, are shown.
MAX_STEPS, MAX_ROWS = 8, 10

# The names of the inputs of a program, by number.
Names = Mapping[int, str]


def input_names(one: Exploration) -> dict[int, str]:
    """Return the names of the inputs of a program."""
    used = channels_of(one.program, dialect(one.program.language))
    return {int(each.number): each.name for each in used if each.kind == "input" and each.number.isdecimal()}


def ways_text(found: WaysCompared, names: Names, most: int = MAX_ROWS) -> str:
    """Return what two programs do differently: a sentence, then each difference, then what differs in time."""
    lines = [summary(found), *unproved(found)]
    lines += [f"{way_words(each.way, names)}: {found_words(each)}" for each in found.differences]
    if found.behind:
        lines.append("only behind another difference, and possibly its consequence:")
        lines += [f"  {way_words(each.way, names)}: {found_words(each)}" for each in found.behind[:most]]
        lines += _more(found.behind, most)
    if found.cycles or found.later:
        lines.append("only the time differs:")
        lines += [f"  {_cycle(each)}" for each in found.cycles]
        lines += [
            f"  {way_words(each.way, names)}: {later_words(each.later, each.times)}"
            for each in found.later[:most]
        ]
        lines += _more(found.later, most)
    return "\n".join(lines) + "\n"


def _more(some: Sequence[object], most: int) -> list[str]:
    return [f"  and {len(some) - most} more; --all lists them"] if len(some) > most else []


def summary(found: WaysCompared) -> str:
    """Return how many ways were played, how many differ, and what none has reached."""
    parts = [f"{found.untouched} the same by their text"] if found.untouched else []
    parts += [f"{found.equal} played in both the same"] if found.equal else []
    parts = parts or ["0 the same"]
    parts += [f"{found.differ} {_verb(found.differ, 'differ')}"] if found.differ else []
    parts += [f"{found.timed} {_verb(found.timed, 'differ')} in time alone"] if found.timed else []
    parts += [
        f"{count} {_verb(count, 'exist')} only in {side}" for side, count in found.only.items() if count
    ]
    limits = f"cycles {TIMES} to {MAX_TIMES} times, times to {1000 * WITHIN:.10g} ms"
    text = f"{count_of(found.count, 'way')} ({limits}): {', '.join(parts)}"
    for words, lines in (("not reached", found.unreached), ("reached only in part", found.partial)):
        a, b = (lines[side] for side in "AB")
        where = f"{words} in either" if a == b else words
        text += f"; {where}: {_of_sides(lines)}" if a or b else ""
    return text


def not_compared(found: WaysCompared, explored: str = "AB") -> str:
    """Return what was not compared: changed lines that no way carries out, and what was left; "" if nothing was."""
    lines = _of_sides(found.uncompared)
    parts = [lines] if lines else []
    parts += [count_of(len(found.left), "way")] if found.left else []
    parts += [
        f"what the exploration of {side} had not found (--seconds 60 plays on)"
        for side, one in (("A", found.a), ("B", found.b))
        if side in explored and not one.is_whole
    ]
    return ", ".join(parts)


def unproved(found: WaysCompared) -> Iterator[str]:
    """Yield why what was played cannot tell of a change: what was left out, and what has not shown."""
    left = not_compared(found)
    if left:
        yield f"not compared: {left}"
    for outcome in (True, False):
        missing = {
            side: [line for line, each in conditions.items() if each is outcome]
            for side, conditions in found.one_sided.items()
        }
        if any(missing.values()):
            yield f"never {str(outcome).lower()}: {_of_sides(missing)}"
    if any(found.hidden.values()):
        yield f"{_of_sides(found.hidden)} changed, and nothing that was played depends on it"


def _of_sides(lines: Mapping[str, Sequence[int]]) -> str:
    """Return lines of both programs, such as "line 4" or "line 4 of A, lines 5, 6 of B"."""
    a, b = (lines.get(side, ()) for side in "AB")
    if a == b:
        return lines_words(a)
    return ", ".join(f"{lines_words(each)} of {side}" for side, each in (("A", a), ("B", b)) if each)


def _verb(count: int, verb: str) -> str:
    return f"{verb}s" if count == 1 else verb


def way_words(way: Way, names: Names) -> str:
    """Return a way as an operator follows it: "start; part on; clamp closed on"."""
    if way.world is not None:
        return way.words
    steps = [_step(changes, names) for changes in _steps(way.timeline)]
    shown = (
        steps
        if len(steps) <= MAX_STEPS
        else [*steps[: MAX_STEPS - 1], f"{len(steps) - MAX_STEPS + 1} more steps"]
    )
    apart = f" ({way.pace:.10g} s apart)" if way.pace else ""
    return "; ".join(["start", *shown]) + apart


def _steps(timeline: Timeline) -> Iterator[Sequence[Change]]:
    for _, group in groupby(timeline, key=lambda each: each[0]):
        yield [change for _, change in group]


def _step(changes: Sequence[Change], names: Names) -> str:
    return " and ".join(_change(each, names) for each in changes)


def _change(change: Change, names: Names) -> str:
    name = names.get(change.number, "") if change.table == "input" else ""
    text = str(change)
    return text.replace(change.subject, f"{change.subject} ({name})") if name else printable(text)


def found_words(found: FoundDifference) -> str:
    """Return what differs in a way, and in how many."""
    return difference_words(found.difference, found.times, "ways", *found.timelines)


def _cycle(each: CycleTime) -> str:
    assert each.way.cycle is not None
    lines = lines_words(each.way.cycle.work)
    percent = 100.0 * (each.b - each.a) / each.a
    return f"the cycle of {lines}: {each.a:.4g} → {each.b:.4g} s, {each.b - each.a:+.4f} s ({percent:+.2g} %)"


def ways_document(found: WaysCompared, names: Names) -> Document:
    """Return the comparison as data."""
    differences = [
        {
            "way": way_words(each.way, names),
            "a": [str(act) for act in each.difference.a],
            "b": [str(act) for act in each.difference.b],
            "text": found_words(each),
            "ways": each.times,
            "behind": k >= len(found.differences),
        }
        for k, each in enumerate([*found.differences, *found.behind])
    ]
    later = [
        {
            "way": way_words(each.way, names),
            "act": str(each.later.act),
            "line": each.later.act.line,
            "seconds": each.later.seconds,
            "lasts": each.later.lasts,
            "ways": each.times,
        }
        for each in found.later
    ]
    cycles = [
        {"lines": ranges(each.way.cycle.work) if each.way.cycle else "", "old": each.a, "new": each.b}
        for each in found.cycles
    ]
    tables = [
        Table("differences", list(map(Column, ("way", "a", "b", "text", "ways", "behind"))), differences),
        Table("cycles", list(map(Column, ("lines", "old", "new"))), cycles),
        Table("later", list(map(Column, ("way", "act", "line", "seconds", "lasts", "ways"))), later),
    ]
    values = {
        "equal": found.same,
        "summary": summary(found),
        "not_compared": "; ".join(unproved(found)),
        "ways": found.count,
        "untouched": found.untouched,
        "same": found.equal,
        "differ": found.differ,
        "timed": found.timed,
        "only_a": found.only["A"],
        "only_b": found.only["B"],
    }
    return Document(tables, values)
