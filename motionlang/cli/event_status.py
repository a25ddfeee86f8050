"""Events that make a completed run exit with 1: limits, following errors, faults.

`--allow` accepts kinds of them.
"""

from __future__ import annotations

from motionlang.kernel import Run
from motionlang.kernel.controller import HOMING

# The names of `--allow`: the events that are then ignored.
ALLOWED = {
    "limit": ("limit",),
    "soft-limit": ("soft limit",),
    "following-error": ("following error",),
    "fault": ("fault", "abort", "e-stop"),
}
# The axes of each message, by what is before and after them.
Found = dict[tuple[str, str], list[int | None]]
# Faults that are ignored if the program handles them; others always count.
_HANDLED = ALLOWED["fault"]


def complaints(run: Run, allowed: frozenset[str]) -> list[str]:
    """Return messages for the first event of each kind and axis that is not allowed.

    A message names file and line, and each axis that has the event at that time.
    """
    # The last handler that was entered, by None, and where the faults of each axis were last cleared.
    handled: dict[int | None, int] = {}
    # As plain tuples: importing the record type takes as long as starting an empty Python.
    events = list(run.machine.log.events)
    for index, (_, kind, axis, *_) in enumerate(events):
        if kind == "handler":
            handled[None] = index
        elif kind == "cleared":
            handled[axis] = index
    kinds = {kind for name, kinds in ALLOWED.items() if name not in allowed for kind in kinds}
    seen: set[tuple[str, int | None]] = set()
    found: Found = {}
    for index, (time, kind, axis, _, _, at, ordered, text) in enumerate(events):
        if kind not in kinds or (kind, axis) in seen or text == HOMING:
            continue
        if kind in _HANDLED and max(handled.get(None, -1), handled.get(axis, -1)) > index:
            continue
        seen.add((kind, axis))
        line = ordered or (run.dialect.locate(run.source, at)[0] if at >= 0 else 0)
        name = next(name for name, kinds in ALLOWED.items() if kind in kinds)
        where = f"{run.source.name}:{line}" if line else run.source.name  # no line before the first statement
        why = f" ({text})" if text else ""
        after = f"at {time:.6g} s{why}; --allow {name} accepts it"
        found.setdefault((f"{where}: {kind}", after), []).append(axis)
    return [
        f"{before} on {'axes' if len(axes) > 1 else 'axis'} {', '.join(map(str, axes))} {after}"
        for (before, after), axes in _without_idle(found, run).items()
    ]


def _without_idle(found: Found, run: Run) -> Found:
    """Return the messages without the axes that ABORT has stopped and that never moved, if others moved."""
    aborts = [key for key in found if key[0].endswith(": abort")]
    if not aborts:
        return found
    moved = {move.axis for move in run.machine.log.moves}
    if moved.isdisjoint(axis for key in aborts for axis in found[key]):
        return found
    rest: Found = {key: [axis for axis in found[key] if axis in moved] for key in aborts}
    return {key: axes for key, axes in {**found, **rest}.items() if axes}
