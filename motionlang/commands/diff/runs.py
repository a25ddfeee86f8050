"""Two runs compared in their own world: what their tasks do, as in all ways, and where the time goes."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING, Any

from motionlang.commands.diff.charged import Charge, charged
from motionlang.commands.diff.literals import ChangedLiteral, changed_literals
from motionlang.comparison.acts import (
    WORLD,
    ActDifference,
    ComparedAct,
    Later,
    PlayedWay,
    acts_of,
    compared,
    occurred,
    places_of,
    status_of,
)
from motionlang.comparison.tolerance import Tolerance
from motionlang.kernel import Run
from motionlang.views.differences import difference_words, grouped_words
from motionlang.views.table import Column, Document, Table

if TYPE_CHECKING:  # which needs numpy
    from motionlang.commands.diff.motion import Divergence

# So many differences of a kind are shown, and so many lines that have another time.
MAX_LINES, MAX_CHARGED = 12, 4
# A line that takes no longer than this, s, is not shown.
SHOWN = 5e-5


@dataclass
class RunsCompared:
    """The differences of two runs.

    `times` are those of A and B, `periods` those of their cycles if both are endless and have one, s. `charges` are the
    lines that take another time, `apart` is where the positions differ, None if they do not, and `literals` are the
    numbers that differ in the text.
    """

    times: tuple[float, float]
    periods: tuple[float, float] | None
    differences: list[ActDifference]
    later: list[Later]
    apart: Divergence | None
    literals: list[ChangedLiteral]
    charges: list[Charge]

    @property
    def same(self) -> bool:
        """True if the tasks do the same at the same times, and the axes are at the same places."""
        return not (self.differences or self.later or self.apart)


def way_of(run: Run) -> PlayedWay:
    """Return what the tasks of a run do, with its events, as in a played way."""
    acts: dict[str, list[ComparedAct]] = defaultdict(list)
    owners = {} if run.program is None else run.program.structure.owners(with_handlers=True)

    def line(at: int) -> int:
        return run.dialect.locate(run.source, at)[0] if at >= 0 else 0

    found = [*acts_of(run, line), *_events(run, line)]
    for each in sorted(found, key=lambda act: act.begin):
        acts[owners.get(each.line, WORLD)].append(each)
    status = status_of(run, run.status)
    until = run.time if run.status == "until" else inf
    return PlayedWay(
        dict(acts), status, run.time, until, places_of(run), [], 0.0, frozenset(), frozenset(), {}
    )


def _events(run: Run, line: Any) -> Iterator[ComparedAct]:
    for each in run.machine.log.events:
        yield occurred(each.time, each.ordered or line(each.at), each.axis, each.kind)


def compared_runs(a: Run, b: Run, tolerance: Tolerance | None = None) -> RunsCompared:
    """Compare two runs, exactly or within a tolerance."""
    from motionlang.commands.diff.motion import divergence

    tolerance = tolerance or Tolerance()
    found = compared(way_of(a), way_of(b), tolerance)
    cycles = a.cycle, b.cycle
    periods = None if cycles[0] is None or cycles[1] is None else (cycles[0].period, cycles[1].period)
    apart = divergence(a, b, tolerance.size("position"))
    warned = [
        ActDifference((), (), ("none", each) if k else (each, "none"))
        for k, (one, other) in enumerate(((a, b), (b, a)))
        for each in dict.fromkeys(_warnings(one))
        if each not in _warnings(other)
    ]
    differences = [*found.differences, *warned]
    is_same = not (differences or found.later or apart)
    is_endless = a.status == b.status == "until"
    ran = a.program is not None and b.program is not None
    charges = [] if is_same or not ran else charged(a, b, periods if is_endless else None)
    return RunsCompared(
        (a.time, b.time),
        periods if is_endless else None,
        differences,
        list(found.later),
        apart,
        changed_literals(a, b),
        charges,
    )


def _warnings(run: Run) -> list[str]:
    return [f"{each.severity}[{each.code}]: {each.message}" for each in run.diagnostics]


def runs_text(found: RunsCompared, most: int = MAX_LINES) -> str:
    """Return the comparison as text: the numbers that differ, the time, and what the tasks do."""
    lines = _first((_literal(each) for each in found.literals), most)
    if found.same:
        return "\n".join([*lines, "no difference"]) + "\n"
    name, (a, b) = ("time", found.times) if found.periods is None else ("cycle", found.periods)
    if a != b:
        count = 1 if found.periods is not None else MAX_CHARGED if most == MAX_LINES else most
        shares = [each for each in found.charges[:count] if abs(each.seconds) >= SHOWN]
        where = ", ".join(f"{_location(each)} {each.seconds:+.4f} s" for each in shares)
        change = f"{b - a:+.4f}" if abs(b - a) >= SHOWN else f"{b - a:+.2g}"
        lines.append(f"{name} {a:.6g} → {b:.6g} s, {change} s{f': {where}' if where else ''}")
    words = grouped_words(found.differences, found.later)
    lines += _first(words, most)
    if found.apart is not None:
        far = found.apart
        lines.append(
            f"the positions differ from {far.time:.6g} s on, at most by {far.max_difference:.6g} uu: axis {far.axis} "
            f"at {far.max_difference_at:.6g} s"
        )
    return "\n".join(lines) + "\n"


def _first(lines: Iterable[str], most: int) -> list[str]:
    shown = list(lines)
    left = len(shown) - most
    return shown[:most] + ([f"and {left} more; --all lists them"] if left > 0 else [])


def _literal(each: ChangedLiteral) -> str:
    return f"{each.address}: {each.old} → {each.new}" + (
        f", was {each.old_address}" if each.old_address else ""
    )


def _location(charge: Charge) -> str:
    old, new = charge.old, charge.new
    if old == new:
        return f"line {new}" if new else "no line"
    if old is None:
        return f"line {new} (new)"
    return f"line {old} (missing)" if new is None else f"line {old} (now {new})"


def runs_document(found: RunsCompared) -> Document:
    """Return the comparison as data."""
    rows: list[Mapping[str, object]] = [
        {
            "a": [str(act) for act in each.a] or list(each.end or ())[:1],
            "b": [str(act) for act in each.b] or list(each.end or ())[1:],
            "time": None if each.begin == inf else each.begin,
            "text": difference_words(each),
        }
        for each in found.differences
    ]
    later = [
        {"act": str(each.act), "line": each.act.line, "seconds": each.seconds, "lasts": each.lasts}
        for each in found.later
    ]
    tables = [
        Table("differences", list(map(Column, ("a", "b", "time", "text"))), rows),
        Table("later", list(map(Column, ("act", "line", "seconds", "lasts"))), later),
        Table("literals", list(map(Column, ("address", "old_address", "old", "new"))), found.literals),
        Table("time_by_line", list(map(Column, ("old", "new", "seconds"))), found.charges),
        Table(
            "positions",
            list(map(Column, ("time", "axis", "max_difference", "max_difference_at"))),
            [found.apart] if found.apart else [],
        ),
    ]
    periods = found.periods or (None, None)
    values = {
        "equal": found.same,
        "old_time": found.times[0],
        "new_time": found.times[1],
        "old_cycle": periods[0],
        "new_cycle": periods[1],
    }
    return Document(tables, values)
