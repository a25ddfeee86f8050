"""Slack between axes that began together, in columns because a shift has many."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import compress
from math import fsum
from operator import eq, sub
from typing import TypeVar

from motionlang.commands.profile.motions import Motions
from motionlang.commands.profile.tasks import Wait

T = TypeVar("T")

# The axes of moves that began together, and the ends of each, begin after begin.
Group = tuple[tuple[int, ...], list[list[float]]]


@dataclass(eq=False, slots=True)
class Slack:
    """Slack: how much longer `axis` could take without delaying the cycle.

    It was at rest while `other` still moved.
    """

    axis: int
    other: int
    seconds: float


def slacks(motions: Motions, waits: Mapping[str, Sequence[Wait]]) -> list[Slack]:
    """Return the slacks, the longest first, where a task waited for several axes.

    The axes had begun together, and the task waited for the last one.
    """
    waited: set[int] = set()  # in milliseconds
    for mine in waits.values():
        waited.update([int(wait[3] * 1000.0) for wait in mine if wait[4] != "time"])
    found: dict[tuple[int, int], list[float]] = defaultdict(list)
    for axes, ends in _together(motions):
        for last, columns in _by_last(ends, waited):
            for number, axis in enumerate(axes):
                if number != last:
                    found[axis, axes[last]] += map(sub, columns[last], columns[number])
    rows = [Slack(axis, other, fsum(times)) for (axis, other), times in found.items() if any(times)]
    return sorted(rows, key=lambda row: (-row.seconds, row.axis, row.other))


def _together(motions: Motions) -> Iterator[Group]:
    """Yield the moves that began together on one line, grouped by their set of axes."""
    cuts, ends, axes, lines = motions.together()
    for width, firsts in _by_width(cuts):
        by_line = _columns(lines, firsts, width)
        by_axis = _columns(axes, firsts, width)
        if all(map(by_line[0].__eq__, by_line)) and all(each.count(each[0]) == len(each) for each in by_axis):
            yield tuple(each[0] for each in by_axis), _columns(ends, firsts, width)
        else:
            yield from _one_by_one(firsts, width, ends, axes, lines)


def _by_width(cuts: Sequence[int]) -> Iterator[tuple[int, Sequence[int]]]:
    """Yield the groups by size, without those of size 1."""
    if isinstance(cuts, range):
        if cuts.step > 1:
            yield cuts.step, cuts[:-1]
        return
    widths = list(map(sub, cuts[1:], cuts))
    for width in set(widths) - {1}:
        yield width, list(compress(cuts, map(width.__eq__, widths)))


def _columns(values: Sequence[T], firsts: Sequence[int], width: int) -> list[list[T]]:
    """Return the values at each of `firsts`, then at the next index of each, etc."""
    begin, end = firsts[0], firsts[-1]
    step = firsts[1] - begin if len(firsts) > 1 else width
    each = range(begin, end + 1, step)
    if firsts == each or (len(firsts) == len(each) and firsts == list(each)):  # as in most cycles
        return [list(values[begin + k : end + k + 1 : step]) for k in range(width)]
    return [[values[first + k] for first in firsts] for k in range(width)]


def _one_by_one(
    firsts: Iterable[int], width: int, ends: Sequence[float], axes: Sequence[int], lines: Sequence[int]
) -> Iterator[Group]:
    """Yield moves that began together, possibly on several lines or with varying axes."""
    found: dict[tuple[int, ...], list[tuple[float, ...]]] = defaultdict(list)
    for first in firsts:
        members = range(first, first + width)
        for line in dict.fromkeys(lines[first : first + width]):
            mine = [each for each in members if lines[each] == line]
            if len(mine) > 1:
                found[tuple(map(axes.__getitem__, mine))].append(tuple(map(ends.__getitem__, mine)))
    for group, rows in found.items():
        yield group, list(map(list, zip(*rows, strict=True)))


def _by_last(ends: list[list[float]], waited: set[int]) -> Iterator[tuple[int, list[list[float]]]]:
    """Yield the axis that ended last and the ends of all, if a task waited for it.

    If several axes ended last, the first of them is taken.
    """
    last = list(map(max, *ends))
    millis = [int(each * 1000.0) for each in last]
    if not waited.issuperset(millis):
        is_waited = [each in waited or each + 1 in waited for each in millis]
        last, ends = list(compress(last, is_waited)), [list(compress(column, is_waited)) for column in ends]
    for number, column in enumerate(ends):
        if column == last:
            yield number, ends  # always the same one
            return
        if any(map(eq, column, last)):
            break
    found: dict[int, list[tuple[float, ...]]] = defaultdict(list)
    for row in zip(*ends, strict=True):
        found[row.index(max(row))].append(row)
    for number, rows in found.items():
        yield number, list(map(list, zip(*rows, strict=True)))
