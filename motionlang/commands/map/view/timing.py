"""One cycle of a run as a timing diagram: inputs, outputs, velocities, and what each task waits for.

The cycle is the longest one that the run repeats: of all statements at which a task waited more than once, the one
whose waits are furthest apart. The diagram shows the last whole period but one, so that the first ones, which may
include homing, do not count.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from itertools import islice, pairwise
from statistics import median

from motionlang.commands.map.program_map import ProgramMap
from motionlang.commands.map.view.words import CAUSES
from motionlang.kernel import Axis, Run, WholeTrack
from motionlang.kernel.log import Waited
from motionlang.kernel.tracks import axes_of
from motionlang.views.figure import COLOURS, Curve, Figure, Lane, Panel
from motionlang.views.lanes import Lane as Channel
from motionlang.views.lanes import lanes

# Waits that are read to find the cycle, and points of a curve.
MAX_WAITS = 20_000
POINTS = 600
_PREFIXES = {"in": "input", "out": "output"}


def cycle(run: Run) -> tuple[float, float] | None:
    """Return begin and end of a period of a run, s; None if it repeats nothing."""
    begun: dict[tuple[str, int, tuple[int, ...]], list[float]] = {}
    for wait in islice(run.machine.log.waits, MAX_WAITS):
        begun.setdefault((wait.task, wait.at, wait.callers), []).append(wait.since)
    periods = {key: [b - a for a, b in pairwise(times)] for key, times in begun.items() if len(times) > 1}
    if not periods:
        return None
    longest = max(periods, key=lambda key: (median(periods[key]), -begun[key][0]))
    times = begun[longest]
    last = len(times) - 1 if len(times) < 4 else len(times) - 2
    return times[last - 1], times[last]


def timing(made: ProgramMap) -> Figure | None:
    """Return the figure of one cycle of the run of a map; None if the run repeats nothing."""
    run = made.run
    span = cycle(run) if run is not None else None
    if run is None or span is None or span[1] <= span[0]:
        return None
    begin, end = span
    channels = [_named(made, each, span) for each in lanes(run.controller) if each.is_digital]
    panels = [
        Panel(lanes=[each for each in channels if each is not None], title="inputs and outputs"),
        *(
            Panel(
                [Curve(*_velocity(run.controller.axes[axis], begin, end), COLOURS[k % len(COLOURS)])],
                label="velocity",
                unit="uu/s",
                title=_title(made, axis),
                height=70.0,
                has_zero=True,
            )
            for k, axis in enumerate(axes_of(run.controller))
        ),
        Panel(lanes=_waits(made, run, begin, end), title="waits of the tasks"),
    ]
    shown = [panel for panel in panels if panel.lanes or panel.curves]
    return Figure(
        [[_from_zero(panel, begin, end)] for panel in shown],
        x_label="time from the begin of the cycle (s)",
        title=f"one cycle of {made.source.name}",
        subtitle=f"{begin:.3f} to {end:.3f} s, {end - begin:.3f} s",
    )


def _title(made: ProgramMap, axis: int) -> str:
    return next((each.title for each in made.axes if each.axis == axis), f"axis {axis}")


def _named(made: ProgramMap, lane: Channel, span: tuple[float, float]) -> Lane | None:
    """Return a channel by its name in the program; None if it is off all the time and the program does not use it."""
    prefix = lane.name.rstrip("0123456789")
    number = lane.name[len(prefix) :]
    kind = _PREFIXES.get(prefix, prefix)
    known = next((each for each in made.channels if (each.kind, each.number) == (kind, number)), None)
    spans = _within(lane.spans(span[1]), *span)
    if known is None and not spans:
        return None
    return Lane(known.known_as if known is not None else f"{kind} {number}", spans)


def _within(spans: Sequence[tuple[float, float]], begin: float, end: float) -> list[tuple[float, float]]:
    return [(max(a, begin), min(b, end)) for a, b in spans if b > begin and a < end]


def _velocity(axis: Axis, begin: float, end: float) -> tuple[list[float], list[float]]:
    """Return times, s, and the velocities of an axis, uu/s."""
    starts, profiles = WholeTrack(axis).between(begin, end)
    scale = axis.scale.counts or 1.0
    times, values = [], []
    for k in range(POINTS + 1):
        time = begin + (end - begin) * k / POINTS
        index = bisect_right(starts, time) - 1
        moving = index >= 0 and time - starts[index] <= profiles[index].duration
        times.append(time)
        values.append(profiles[index].velocity(time - starts[index]) / scale if moving else 0.0)
    return times, values


def _waits(made: ProgramMap, run: Run, begin: float, end: float) -> list[Lane]:
    """Return a lane for each task and each cause of its waits; the text says what a condition is about."""
    found: dict[tuple[str, str], list[tuple[float, float]]] = {}
    waits: list[Waited] = [wait for wait in islice(run.machine.log.waits, MAX_WAITS) if wait.until > begin]
    for wait in waits:
        if wait.since < end:
            statement = made.structure.statements.get(wait.at)
            known = statement.waits if statement is not None and wait.cause == "condition" else ""
            found.setdefault((wait.task, known or wait.cause), []).append((wait.since, wait.until))
    several = len({task for task, _ in found}) > 1
    return [
        Lane(
            f"{task} waits for {CAUSES[cause]}" if several else f"waits for {CAUSES[cause]}",
            _within(spans, begin, end),
        )
        for (task, cause), spans in sorted(found.items())
    ]


def _from_zero(panel: Panel, begin: float, end: float) -> Panel:
    """Return a panel whose time is that from the begin of the cycle."""
    moved = [Lane(each.name, [(a - begin, b - begin) for a, b in each.spans]) for each in panel.lanes]
    curves = [
        Curve([time - begin for time in each.x], each.y, each.colour, each.name) for each in panel.curves
    ]
    return Panel(
        curves,
        label=panel.label,
        unit=panel.unit,
        title=panel.title,
        height=panel.height,
        lanes=moved,
        x_limits=(0.0, end - begin),
        has_zero=panel.has_zero,
    )
