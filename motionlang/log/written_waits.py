"""A wait in the log as it is written: apart from what it is read as, for who goes through many and makes no records."""

from __future__ import annotations

# The fields of a `Waited`; and as a wait for a time is written, of which programs have millions: what does not change
# at its place (task, place, callers, what a statement costs), the moment from which the task counts its statements, how
# many it had carried out, and the end.
Whole = tuple[str, int, float, float, str, tuple[int, ...], str, tuple[int, ...]]
Short = tuple[tuple[str, int, tuple[int, ...], float], float, float, float]


def whole(wait: Whole | Short) -> Whole:
    """All fields of a wait."""
    if len(wait) == 8:
        return wait
    (task, at, callers, cost), base, count, until = wait
    return task, at, base + count * cost, until, "time", (), "", callers
