"""Values of what has more than two levels: keys, analogue inputs, numbers of a host; and inputs that form a code.

An unusual value is played. A number knows of which readings it was worked out (`motionlang.kernel.traced`), plain,
shifted or scaled, as in `k = k - 48 : IF k = 1` or `ADC(0) * 3 > set - 5`. Each comparison then says at which value its
sides are equal, and a value on each side of it is tried.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import chain, pairwise
from math import fsum, inf, isfinite
from typing import TYPE_CHECKING, Any

from motionlang.kernel.traced import Form, form_of, is_traced, plain
from motionlang_explore.exploration.changes import WHOLE, Change, Channel
from motionlang_explore.exploration.recorder import Comparison

if TYPE_CHECKING:
    from motionlang_explore.exploration.trials import Trial

# An unusual key, level, number and answer.
KEY, LEVEL, NUMBER, ANSWER = "~", 41.0, 7771, "7771"
# Answers that a person tries, and how many times the last number of a wide range is the first one.
USUAL_ANSWERS, WIDE = ("10", "1", "100", "0.5"), 100.0
_RANGE = re.compile(r"(\d+(?:\.\d+)?)\s*(?:to|-|\.\.)\s*(\d+(?:\.\d+)?)", re.IGNORECASE)
ENTER = "\r"
# A number that a person types where a key is compared with Enter.
TYPED = "5{Enter}"
# What a person tries.
USUAL: dict[str, Sequence[float | str]] = {
    "key": (*"1234567890", ENTER),
    "analogue": (50.0,),
    "comms": (10.0,),
    "netdata": (10,),
    "modbus.register": (10,),
}
# A level is tried so far from where a comparison turns, percent.
STEP = 2.0
# So many values are tried of one channel.
MAX_VALUES = 24
# Of a statement that compares with a counter, so many are tried.
COUNTED = 3
# An input comes so often at most.
MAX_TIMES = 50


def probe_of(channel: Channel, question: str = "") -> Change:
    """Return an unusual change of a channel with more than two levels; `question` is that of an answer."""
    table, number = channel
    unusual: dict[str, float | str] = {"key": KEY, "analogue": LEVEL, "answer": ANSWER}
    unusual |= dict.fromkeys(WHOLE, NUMBER)
    return Change(table, number, unusual.get(table, float(NUMBER)), question)


def first_write(channel: Channel) -> Change:
    """Return the change of a number of a host to 1."""
    table, number = channel
    return Change(table, number, 1 if table in WHOLE else 1.0)


def is_probe(change: Change) -> bool:
    """True if the value of a change is an unusual one."""
    return change.table != "input" and change.value in (KEY, LEVEL, NUMBER, ANSWER)


def is_number(change: Change) -> bool:
    """True if the text of an answer is a number."""
    return str(change.value).replace(".", "", 1).isdecimal()


def solved(probe: Change, trial: Trial) -> list[Change]:
    """Return the values of a channel at which comparisons turn, from the trial with an unusual one."""
    probe = _as_read(probe, trial)
    roots = dict.fromkeys(_roots(probe, trial))
    ordered = sorted(roots)
    found = dict.fromkeys(chain.from_iterable(_near(probe, each, ordered) for each in roots))
    changes = [change for value in found if (change := _change(probe, value)) is not None]
    changes += [probe._replace(value=text) for text in _words(probe, trial)]
    if found or probe.table == "key":
        typed = (TYPED,) if probe.table == "key" and ord(ENTER) in found else ()
        changes += [probe._replace(value=each) for each in (*typed, *USUAL.get(probe.table, ()))]
    return list(dict.fromkeys(changes))[:MAX_VALUES]


def _roots(probe: Change, trial: Trial) -> Iterator[float]:
    """Yield the values of a channel at which comparisons turn, the first ones of a statement that counts."""
    for sides in trial.comparisons.values():
        roots = list(dict.fromkeys(_turns(probe, sides)))
        yield from roots[:COUNTED] if _is_counted(roots) else roots


def _turns(probe: Change, sides: Iterable[tuple[Any, Any]]) -> Iterator[float]:
    """Yield the values at which the comparisons of a statement turn; that of the other side if no sum leads there."""
    value = _number(probe)
    for left, right in sides:
        for (table, number, read), factor in _difference(left, right).items():
            if table == probe.table and (number == probe.number or table == "answer") and read == value:
                margin = plain(left) - plain(right)
                other = right if is_traced(left) else left
                yield value - margin / factor if isfinite(factor) else float(plain(other))


def _as_read(probe: Change, trial: Trial) -> Change:
    """Return an unusual change of a number as the program reads it: as a float, if it does so with its bits."""
    sides = chain.from_iterable(chain.from_iterable(trial.comparisons.values()))
    reads = (read for side in sides for read in form_of(side))
    floats = (value for *channel, value in reads if (*channel,) == probe.channel and isinstance(value, float))
    return probe._replace(value=next(floats, probe.value)) if probe.table == "netdata" else probe


def _difference(left: Any, right: Any) -> Form:
    """Return the form of the left side of a comparison minus the right one, empty if no reading takes part."""
    return form_of(left - right) if is_traced(left) or is_traced(right) else {}


def levels(trial: Trial, tables: Collection[str] = ("analogue",)) -> Iterator[Change]:
    """Yield the levels, and numbers, at and beside which the comparisons of a trial turn, whatever was read.

    Of a statement with several it is the last one, the first one if it counts.
    """
    for sides in trial.comparisons.values():
        found = [dict(_zeros(*pair, tables)) for pair in sides]
        for read in found[-1]:
            roots = list(dict.fromkeys(each[read] for each in found if read in each))
            root = roots[0 if _is_counted(roots) else -1]
            below = () if read.table in ("analogue", "key") else (root - 1.0,)
            for level in (*below, *_near(read, root, ())):
                change = _change(read, level)
                yield from () if change is None else (change,)


def _zeros(left: Any, right: Any, tables: Collection[str]) -> Iterator[tuple[Change, float]]:
    """Yield what a comparison has read, with the value at which it turns."""
    for (table, number, value), factor in _difference(left, right).items():
        if table in tables and isfinite(factor):
            yield Change(table, number, value), value - (plain(left) - plain(right)) / factor


def _is_counted(roots: Sequence[float]) -> bool:
    """True if each value at which a statement turns is as far from the one before."""
    return len(roots) > 2 and len({after - before for before, after in pairwise(roots)}) == 1


def codes(trial: Trial, read: Collection[Channel]) -> list[tuple[Change, ...]]:
    """Return the changes of several inputs that let a bank have the code with which it is compared."""
    found = dict.fromkeys(_flips(*each[-1]) for each in trial.comparisons.values())
    return [each for each in found if len(each) > 1 and {one.channel for one in each}.issubset(read)]


def _flips(left: Any, right: Any) -> tuple[Change, ...]:
    """Return the inputs of which two sides are sums that have to change for the sides to be equal, none if none do.

    Each weighs twice as much as the one before, so the lowest bit of what is left says if it has to change.
    """
    form = _difference(left, right)
    if not form or not all(table == "input" and isfinite(k) for (table, _, _), k in form.items()):
        return ()
    lacks, changes = plain(right) - plain(left), list[Change]()
    for (table, number, level), factor in sorted(form.items(), key=lambda each: abs(each[1])):
        if round(lacks / factor) % 2:
            lacks -= factor * (1.0 - 2.0 * level)
            changes.append(Change(table, number, 1.0 - level))
    return () if lacks else tuple(sorted(changes))


def periods(trial: Trial, number: int) -> Iterator[float]:
    """Yield the periods of an input with which comparisons of the way between two of its marks turn.

    Both places are readings of one encoder, which turns at a constant speed.
    """
    edges = [
        at
        for time, each in trial.timeline
        if each.channel == ("input", number)
        for at, level in each.levels(time)
        if level
    ]
    for left, right in (each[-1] for each in trial.comparisons.values() if len(edges) > 1):
        form = _difference(left, right)
        if len(form) == 2 and len({each[:2] for each in form}) == 1 and not fsum(form.values()):
            (_, _, first), (_, _, last) = sorted(form)
            way = last - (plain(left) - plain(right)) / form[max(form)] - first
            made = [(edges[-1] - edges[-2]) * way * (1.0 + side) / (last - first) for side in (0.02, -0.02)]
            yield from (float(f"{each:.3g}") for each in made if each > 0.0)


def turning_at(a: float, b: float, one: Trial, other: Trial) -> list[float]:
    """Return the values of something at which comparisons turn, from the trials with two other values of it."""
    roots: dict[float, None] = {}
    for at, margins in _margins(one).items():
        for m, n in zip(margins, _margins(other).get(at, []), strict=False):
            slope = (n - m) / (b - a)
            if slope and isfinite(slope):
                roots[a - m / slope] = None
    return list(roots)


def counts(trials: Sequence[Trial]) -> list[int]:
    """Return how often an input must come for comparisons to turn that count it, from trials with 1, 2 … times.

    What counts it differs by the same from each trial to the next one.
    """
    if len(trials) < 2:
        return []
    first, *others = map(_margins, trials)
    found: dict[int, None] = {}
    for at, margins in first.items():
        rows = [margins, *(other.get(at, []) for other in others)]
        # One after the other, and the last ones, since a loop that waits compares more often for more pulses.
        for known in dict.fromkeys((*zip(*rows, strict=False), tuple(chain(*(row[-1:] for row in rows))))):
            steps = {after - before for before, after in pairwise(known)}
            if len(known) < len(trials) or len(steps) > 1 or 0.0 in steps:
                continue
            root = 1 - known[0] / steps.pop()
            if root.is_integer():
                found |= dict.fromkeys((int(root), int(root) + 1))
    return [each for each in found if 1 < each <= MAX_TIMES]


def _margins(trial: Trial) -> dict[Comparison, list[float]]:
    """Return left side minus right side of the comparisons of numbers."""
    return {
        at: [
            float(left) - float(right)
            for left, right in sides
            if isinstance(left, (int, float)) and isinstance(right, (int, float))
        ]
        for at, sides in trial.comparisons.items()
    }


def _words(change: Change, trial: Trial) -> dict[str, None]:
    """Return the texts with which the text of a change was compared."""
    sides = [pair for pairs in trial.comparisons.values() for pair in pairs]
    found = (
        right if left == change.value else left for left, right in sides if change.value in (left, right)
    )
    return dict.fromkeys(each for each in found if isinstance(each, str) and each)


def usual_answers(printed: str) -> list[str]:
    """Return the answers that a person tries: within the ranges that the program prints, and usual ones."""
    ranges = [_within(float(low), float(high)) for low, high in _RANGE.findall(printed)]
    return list(dict.fromkeys((*ranges, *USUAL_ANSWERS)))


def _within(low: float, high: float) -> str:
    """Return the middle of a range, an integer if one is in it; of a wide one a usual answer."""
    if high > WIDE * max(low, 1.0):
        return next((each for each in USUAL_ANSWERS if low <= float(each) <= high), f"{low:.10g}")
    middle = (low + high) / 2
    return f"{int(middle) if int(middle) >= low else middle:.10g}"


def printed_for(trial: Trial, question: str) -> str:
    """Return what a program has printed since its last answer, but for the questions: a range in another is its own.

    The digits of an echo would continue a range such as `3 to 8`.
    """
    asked = [each for each in trial.waits if each.cause == "operator"]
    answered = max((each.until for each in asked if each.until < inf), default=0.0)
    questions = {each.at for each in asked}
    lines = [each.text for each in trial.prints if each.time >= answered and each.at not in questions]
    return "\n".join((*lines, question))


def _number(change: Change) -> float:
    if change.table == "answer":
        return float(change.value)
    return float(ord(change.value)) if isinstance(change.value, str) else change.value


def _near(change: Change, root: float, roots: Sequence[float]) -> tuple[float, ...]:
    """Return a root, or the next usual value on each side of it; of a level not beyond the middle to the next root."""
    if change.table == "analogue":
        k = bisect_left(roots, root)
        below, above = (*roots[max(k - 1, 0) : k], -inf)[0], (*roots[k + 1 : k + 2], inf)[0]
        up, down = (above - root) / 2, (root - below) / 2
        return tuple(
            round(root + each, 1 if abs(each) == STEP else 3) for each in (min(up, STEP), -min(down, STEP))
        )
    if not float(root).is_integer():
        return round(root + 0.5), round(root - 0.5)
    return (root,) if change.table in ("key", "answer") else (root, root + 1.0)


def _change(change: Change, value: float) -> Change | None:
    """Return a change to a value, None if there is no such key or level."""
    if change.table == "answer":
        return change._replace(value=f"{value:.10g}")
    if change.table == "key":
        known = value == ord(ENTER) or 32 <= value < 127
        return change._replace(value=chr(int(value))) if known and value == int(value) else None
    if change.table in WHOLE and isinstance(change.value, int):
        return change._replace(value=int(value)) if value == int(value) else None
    if change.table == "analogue" and not 0.0 <= value <= 100.0:
        return None
    return change._replace(value=value)
