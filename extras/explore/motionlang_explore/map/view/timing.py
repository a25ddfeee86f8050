"""One cycle of a machine as a timing diagram: inputs, outputs, velocities, and what each task waits for."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice, pairwise
from math import fsum

from motionlang.kernel import Axis, Run
from motionlang.kernel.tracks import axes_of
from motionlang.views.figure import COLOURS, Curve, Figure, Lane, Panel
from motionlang.views.lanes import ChannelLane as Channel
from motionlang.views.lanes import lanes
from motionlang.views.terminal import cells, styled
from motionlang_explore.map.behaviour import CAUSES, MachineBehaviour
from motionlang_explore.map.program_map import ProgramMap

# Waits that are read, and points of a curve.
MAX_WAITS = 20_000
POINTS = 600
# An axis that is slower is at standstill, uu/s.
STANDING = 1e-6
# The longest name of a lane in text, and the cells of one that is on or off.
MAX_NAME = 28
ON, OFF = "█", "·"


def timing(made: ProgramMap) -> Figure | None:
    """Return the figure of one cycle of a machine; None if it was not played, or nothing moved."""
    behaviour = made.behaviour
    if (
        behaviour is None
        or not len(behaviour.run.machine.log.moves)
        or behaviour.span[1] <= behaviour.span[0]
    ):
        return None
    run, (begin, end) = behaviour.run, behaviour.span
    panels = [
        Panel(lanes=_channels(made, behaviour), title="inputs and outputs"),
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
    what = "one run" if run.cycle is None else "one cycle"
    return Figure(
        [[_from_zero(panel, begin, end)] for panel in shown],
        x_label="time from the begin (s)",
        title=f"{what} of {made.source.name}",
        subtitle=f"{begin:.3f} to {end:.3f} s, {end - begin:.3f} s",
    )


def drawn(made: ProgramMap, width: int, colour: bool) -> Iterator[str]:
    """Yield one cycle as lines of text: a row for each axis that moves, each output and each input that changes."""
    behaviour = made.behaviour
    if behaviour is None or behaviour.span[1] <= behaviour.span[0]:
        return
    begin, end = behaviour.span
    rows = [
        Lane(_title(made, axis), spans)
        for axis in axes_of(behaviour.run.controller)
        if (spans := _moving(behaviour.run.controller.axes[axis], begin, end))
    ]
    rows += [
        each for each in _channels(made, behaviour) if 0.0 < fsum(b - a for a, b in each.spans) < end - begin
    ]
    if not rows:
        return
    names = [each.name if cells(each.name) <= MAX_NAME else f"{each.name[: MAX_NAME - 1]}…" for each in rows]
    most = max(map(cells, names))
    columns = max(10, min(width, 100) - most - 2)
    for name, row in zip(names, rows, strict=True):
        marks = [OFF] * columns
        for a, b in row.spans:
            first = int((a - begin) / (end - begin) * columns)
            last = max(first + 1, round((b - begin) / (end - begin) * columns))
            marks[first:last] = ON * (min(last, columns) - first)
        yield f"{name}{' ' * (most - cells(name))}  {styled(''.join(marks), 'cyan', colour)}"


def _title(made: ProgramMap, axis: int) -> str:
    return next((each.title for each in made.axes if each.axis == axis), f"axis {axis}")


def _channels(made: ProgramMap, behaviour: MachineBehaviour) -> list[Lane]:
    """Return the digital channels by their names, without those that are off all the time and not in the program."""
    found = (
        _named(made, each, behaviour.span) for each in lanes(behaviour.run.controller) if each.is_digital
    )
    return [each for each in found if each is not None]


def _named(made: ProgramMap, lane: Channel, span: tuple[float, float]) -> Lane | None:
    title = f"{lane.group.removesuffix('s')} {lane.number}"
    known = next((each for each in made.channels if each.title == title), None)
    spans = _within(lane.spans(span[1]), *span)
    if known is None and not spans:
        return None
    return Lane(known.known_as if known is not None else title, spans)


def _within(spans: Sequence[tuple[float, float]], begin: float, end: float) -> list[tuple[float, float]]:
    return [(max(a, begin), min(b, end)) for a, b in spans if b > begin and a < end]


def _velocity(axis: Axis, begin: float, end: float) -> tuple[list[float], list[float]]:
    """Return times, s, and the velocities of an axis, uu/s."""
    starts, profiles = axis.starts, axis.profiles
    times, values = [], []
    for k in range(POINTS + 1):
        time = begin + (end - begin) * k / POINTS
        index = axis.index_at(time)
        moving = index >= 0 and time - starts[index] <= profiles[index].duration
        times.append(time)
        values.append(
            profiles[index].velocity(time - starts[index]) / axis.scale_at(time)[0] if moving else 0.0
        )
    return times, values


def _moving(axis: Axis, begin: float, end: float) -> list[tuple[float, float]]:
    times, values = _velocity(axis, begin, end)
    return [(a, b) for (a, b), value in zip(pairwise(times), values, strict=False) if abs(value) > STANDING]


def _waits(made: ProgramMap, run: Run, begin: float, end: float) -> list[Lane]:
    """Return a lane for each task and each cause of its waits; the text says what a condition is about."""
    found: dict[tuple[str, str], list[tuple[float, float]]] = {}
    for wait in islice(run.machine.log.waits, MAX_WAITS):
        if wait.until > begin and wait.since < end:
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
