"""A wait as written to the log, for bulk readers that need no record objects."""

from __future__ import annotations

# The fields of a `Waited`. A wait for a time is shorter, because programs have millions: the constants of
# its source position (task, position, callers, duration of a statement), the time from which the task counts
# its statements, how many it had executed, and the end.
CompleteWait = tuple[str, int, float, float, str, tuple[int, ...], str, tuple[int, ...]]
Short = tuple[tuple[str, int, tuple[int, ...], float], float, float, float]


def whole(wait: CompleteWait | Short) -> CompleteWait:
    """Return a stored wait with all of its fields."""
    if len(wait) == 8:
        return wait
    (task, at, callers, cost), base, count, until = wait
    return task, at, base + count * cost, until, "time", (), "", callers
