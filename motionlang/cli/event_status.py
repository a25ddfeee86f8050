"""What of a run that went to its end makes its exit status 1 all the same: limits, following errors, faults.

`--allow` takes kinds of them off.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.result import Run

# What `--allow` names: the events that are then no matter.
ALLOWED = {
    "limit": ("limit",),
    "soft-limit": ("soft limit",),
    "following-error": ("following error",),
    "fault": ("fault", "abort", "e-stop"),
}
# Faults that are nothing where the program handles them: others are something in any case.
_HANDLED = ALLOWED["fault"]


def complaints(run: Run, allowed: frozenset[str]) -> list[str]:
    """A sentence for each kind of event and axis that is not allowed: the first of them, with its line."""
    from motionlang.controller.triggers.events import HOMING

    # The last handler that was entered, by None, and where the faults of each axis were last cleared.
    handled: dict[int | None, int] = {}
    for place, event in enumerate(run.machine.log.events):
        if event.kind == "handler":
            handled[None] = place
        elif event.kind == "cleared":
            handled[event.axis] = place
    kinds = {kind for name, kinds in ALLOWED.items() if name not in allowed for kind in kinds}
    found: dict[tuple[str, int | None], str] = {}
    for place, event in enumerate(run.machine.log.events):
        about = event.kind, event.axis
        if event.kind not in kinds or about in found or event.text == HOMING:
            continue
        if event.kind in _HANDLED and max(handled.get(None, -1), handled.get(event.axis, -1)) > place:
            continue
        line = event.ordered or run.dialect.locate(run.source, event.at)[0]
        name = next(name for name, kinds in ALLOWED.items() if event.kind in kinds)
        what = f"{event.kind} on axis {event.axis} at {event.time:.6g} s"
        found[about] = f"{run.source.name}:{line}: {what} ({event.text}); --allow {name} accepts it"
    return list(found.values())
