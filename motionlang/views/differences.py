"""Differences of what two programs do, in words."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from motionlang.comparison.acts import ActDifference, ComparedAct, Later
from motionlang.views.terminal import printable

# So many acts of a difference are shown.
MAX_ACTS = 3

# Changes of the world, each with its time, s.
Changes = Sequence[tuple[float, object]]


def difference_words(
    difference: ActDifference,
    times: int = 1,
    what: str = "ways",
    in_a: Changes = (),
    in_b: Changes = (),
) -> str:
    """Return what A does and what B does, and when, counted from the last change of each.

    It is in so many ways, or so many `times` in one run.
    """
    if difference.end is not None:
        return f"A: {difference.end[0]}, B: {difference.end[1]}{_aside((), times, what)}"
    sides = (("A", difference.a, in_a), ("B", difference.b, in_b))
    is_place = list(map(str, difference.a)) == list(map(str, difference.b))
    a, b = (f"{side} {_acts(acts, timeline, is_place)}" for side, acts, timeline in sides)
    lines = [f"line {acts[0].line} of {side}" for side, acts, _ in sides if acts and acts[0].line]
    return f"{a}, {b}{_aside(lines, times, what)}"


def _aside(lines: Sequence[str], times: int, what: str) -> str:
    often = f"{times} times" if what == "times" else f"in {times} {what}"
    parts = [*lines, *([often] if times > 1 else [])]
    return f" ({', '.join(parts)})" if parts else ""


def _acts(acts: Sequence[ComparedAct], timeline: Changes, has_places: bool) -> str:
    if not acts:
        return "does not"
    shown = [(printable(str(each)), each.place if has_places else "") for each in acts[:MAX_ACTS]]
    text = ", then ".join(f"{act} at {place}" if place else act for act, place in shown)
    rest = f" and {len(acts) - MAX_ACTS} more" if len(acts) > MAX_ACTS else ""
    return f"{text}{rest} {_when(acts[0].begin, timeline)}"


def _when(time: float, timeline: Changes) -> str:
    last = max((each for each, _ in timeline if each <= time), default=0.0)
    return f"after {time - last:.2f} s"


def later_words(later: Later, times: int = 1, what: str = "ways") -> str:
    """Return what comes later, or takes longer: in so many ways, or so many `times` in one run."""
    if later.lasts:
        word = "longer" if later.seconds > 0.0 else "shorter"
        words = f"takes {_seconds(later.seconds)} s {word} in B"
    else:
        words = f"comes {_seconds(later.seconds)} s {'later' if later.seconds > 0.0 else 'earlier'} in B"
    lines = [f"line {later.act.line} of A"] if later.act.line else []
    return f"{printable(str(later.act))} {words}{_aside(lines, times, what)}"


def _seconds(value: float) -> str:
    """Return a time with three decimals, a shorter one with three digits."""
    return f"{abs(value):.3f}" if abs(value) >= 1e-3 else f"{abs(value):.3g}"


def grouped_words(differences: Iterable[ActDifference], later: Iterable[Later]) -> list[str]:
    """Return the differences of two runs, those that share their lines and subjects once, with how often."""
    groups: dict[object, list[ActDifference]] = {}
    for each in differences:
        groups.setdefault(each.key, []).append(each)
    laters: dict[object, list[Later]] = {}
    for late in later:
        laters.setdefault((late.act.line, late.act.subject, late.lasts), []).append(late)
    words = [difference_words(some[0], len(some), "times") for some in groups.values()]
    return words + [later_words(every[0], len(every), "times") for every in laters.values()]
