"""Decide if a run is good: it has no error, and no limit, following error or fault that was not allowed.

`--allow` accepts kinds of these events.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import TYPE_CHECKING

from motionlang.kernel.controller.faults import HOMING
from motionlang.kernel.errors import Diagnostic

if TYPE_CHECKING:
    from motionlang.kernel.result import Run

# The names of `--allow`: the events that are then ignored.
ALLOWED = {
    "limit": ("limit",),
    "soft-limit": ("soft limit",),
    "following-error": ("following error",),
    "fault": ("fault", "abort", "e-stop"),
}
# The axes of each event, by its line, its kind, its time with the reason, and the name of `--allow`.
Found = dict[tuple[int, str, str, str], list[int | None]]
# Faults that are ignored if the program handles them; others always count.
_HANDLED = ALLOWED["fault"]


def allowed(names: Iterable[str]) -> frozenset[str]:
    """Return the names of events to accept; ValueError for an unknown one."""
    given = frozenset(names)
    if given == {"all"}:
        return frozenset(ALLOWED)
    unknown = sorted(given - ALLOWED.keys())
    if unknown:
        raise ValueError(
            f"{unknown[0]!r} is no event that a run can accept: choose from {', '.join(ALLOWED)} or all"
        )
    return given


def failures(run: Run, allowed: Collection[str] = ()) -> list[Diagnostic]:
    """Return why a run is not good: its errors, and its events that are not allowed."""
    errors = [each for each in run.diagnostics if each.severity == "error"]
    return errors + failed_events(run, allowed)


def failed_events(run: Run, allowed: Collection[str] = ()) -> list[Diagnostic]:
    """Return an error for the first event of each kind and axis that is not allowed.

    It names each axis that has the event at that time.
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
        why = f" ({text})" if text else ""
        found.setdefault((line, kind, f"at {time:.6g} s{why}", name), []).append(axis)
    return [
        Diagnostic(
            "beyond-limit",
            f"{kind} on {'axes' if len(axes) > 1 else 'axis'} {', '.join(map(str, axes))} {when}",
            line,
            hint=f"--allow {name} accepts it",
        )
        for (line, kind, when, name), axes in _without_idle(found, run).items()
    ]


def located(failure: Diagnostic, run: Run) -> str:
    """Return a failure as a sentence, with its program and its line."""
    line = f":{failure.line}" if failure.line else ""  # no line before the first statement
    return f"{run.source.name}{line}: {failure.message}"


def _without_idle(found: Found, run: Run) -> Found:
    """Return the events without the axes that ABORT has stopped and that never moved, if others moved."""
    aborts = [key for key in found if key[1] == "abort"]
    if not aborts:
        return found
    moved = {move.axis for move in run.machine.log.moves}
    if moved.isdisjoint(axis for key in aborts for axis in found[key]):
        return found
    rest: Found = {key: [axis for axis in found[key] if axis in moved] for key in aborts}
    return {key: axes for key, axes in {**found, **rest}.items() if axes}
