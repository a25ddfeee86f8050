"""A wait as it is written to the log, for readers of many that need no records."""

from __future__ import annotations

# The fields of a `Waited`. A wait for a time is shorter, because programs have millions: the constants of
# its source position (task, position, callers, duration of a statement), the time from which the task counts
# its statements, how many it had executed, and the end.
CompleteWait = tuple[str, int, float, float, str, tuple[int, ...], str, tuple[int, ...]]
Short = tuple[tuple[str, int, tuple[int, ...], float], float, float, float]


def whole(wait: CompleteWait | Short) -> CompleteWait:
    """Return all fields of a wait."""
    if len(wait) == 8:
        return wait
    (task, at, callers, cost), base, count, until = wait
    return task, at, base + count * cost, until, "time", (), "", callers
