"""Slack between axes that began together."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import fsum

from motionlang.commands.profile.motions import Motions
from motionlang.commands.profile.tasks import Wait


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
    for moves in motions.together():
        last = next(move for move in moves if move.end == moves[-1].end)
        if not waited.isdisjoint((int(last.end * 1000.0), int(last.end * 1000.0) + 1)):
            for move in moves:
                if move is not last:
                    found[move.axes[0], last.axes[0]].append(last.end - move.end)
    rows = [Slack(axis, other, fsum(times)) for (axis, other), times in found.items() if any(times)]
    return sorted(rows, key=lambda row: (-row.seconds, row.axis, row.other))
