"""The outputs, prints and moves of each task of a run in the order of time, with the moves in progress."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Mapping, Sequence
from math import inf
from typing import NamedTuple

from motionlang.comparison.texts import without_figures
from motionlang.kernel import Run
from motionlang.kernel.log import CONTINUED, LoggedMove, Waited
from motionlang_explore.improve.tasks import Tasks

# A task that others share the processor with is late by so much, s.
LATE = 2e-3
# So many cycles of a program are run in a trial, if their period is that of the whole run.
CYCLES = 3


class Place(NamedTuple):
    """How far a move has come: its line, the distance, what is left of it, and the speed, user units.

    An endless move, or one that is cut off, has an infinite distance left.
    """

    line: int
    distance: float
    left: float
    speed: float


class OrderedAct(NamedTuple):
    """An output, a print or the begin of a move, with the moves in progress by axis.

    `end` is that of a move, None if it does not count or is not known; `moving` also has the moves of other axes in
    progress then, with True behind the axis.
    """

    time: float
    line: int
    text: str
    moving: dict[tuple[int, bool], Place]
    end: float | None = None


def acts_of(run: Run, tasks: Tasks) -> dict[str, list[OrderedAct]]:
    """Return what each task does, in the order of time."""
    log, lines = run.machine.log, {-1: 0}
    homes = run.dialect.table().homes
    # The moves of each axis, with their begins and the positions from which their distances count.
    spans: dict[int, list[tuple[float, LoggedMove, float]]] = {}
    found: list[tuple[float, int, int, str, LoggedMove | None]] = []
    continued: set[int] = set()
    for move in log.moves:
        if move.profile is None:
            continue
        is_over = move.start_time + move.profile.duration <= run.time and not move.ended
        is_first = move.axis not in continued
        if not homes(move.command):
            some = spans.setdefault(move.axis, [])
            some.append(
                (move.start_time, move, move.to_user(move.profile.start) if is_first else some[-1][2])
            )
        if is_first:
            whole = move if is_over and not homes(move.command) else None
            found.append((move.start_time, 0, move.line, f"{move.command} of axis {move.axis}", whole))
        (continued.add if move.ended == CONTINUED else continued.discard)(move.axis)
    happened = [(each.time, 1, each.at, f"output {each.channel} = {each.value}") for each in log.outputs]
    happened += [
        (each.time, 1, each.at, f"analogue output {each.channel} = {each.value:.6g}")
        for each in log.analogue_outputs
    ]
    # What a host reads may change all the time; the outputs of a node are like the others.
    happened += [
        (each.time, 1, each.at, f"{each.target} = {each.value:.6g}") for each in log.writes if each.is_output
    ]
    happened += [(each.time, 2, each.at, repr(without_figures(each.text))) for each in log.prints]
    for time, kind, at, text in happened:
        if at not in lines:
            lines[at] = run.dialect.locate(run.source, at)[0]
        found.append((time, kind, lines[at], text, None))
    acts: dict[str, list[OrderedAct]] = {}
    for time, _, line, text, whole in sorted(found, key=lambda each: each[:2]):
        mine = acts.setdefault(tasks.at(line), [])
        # A homing has as many phases as it needs.
        if not (mine and homes(text.partition(" ")[0]) and mine[-1].text == text):
            moving = {(axis, False): place for axis, place in _moving(spans, time)}
            end = None
            if whole is not None and whole.profile is not None:
                end, over = whole.to_user(whole.profile.end), time + whole.profile.duration
                moving |= {(n, True): each for n, each in _moving(spans, over) if n != whole.axis}
            mine.append(OrderedAct(time, line, text, moving, end))
    return acts


def _moving(
    spans: Mapping[int, Sequence[tuple[float, LoggedMove, float]]], time: float
) -> Iterator[tuple[int, Place]]:
    for axis, moves in sorted(spans.items()):
        at = bisect_right(moves, time, key=lambda each: each[0]) - 1
        begin, move, origin = moves[max(at, 0)]
        profile = move.profile
        if profile is not None and begin < time < begin + profile.duration:
            state = profile.state(time - begin)
            is_cut = profile.duration == inf or move.ended not in ("", CONTINUED)
            left = inf if is_cut else move.size_to_user(profile.end - state.position)
            distance = move.to_user(state.position) - origin
            yield axis, Place(move.line, distance, left, move.size_to_user(state.velocity))


def polls_of(
    run: Run, tasks: Tasks, acts: Mapping[str, Sequence[OrderedAct]]
) -> dict[tuple[str, int], float]:
    """Return the time between two looks of a task that polls, by the line of the act that the loop leads to."""
    times = {task: [each.time for each in mine] for task, mine in acts.items()}
    last: dict[str, Waited] = {}
    owners: dict[int, str] = {}
    found: dict[tuple[str, int], float] = {}
    for wait in run.machine.log.waits:
        if wait.cause != "time":
            continue
        if wait.at not in owners:
            owners[wait.at] = tasks.at(run.dialect.locate(run.source, wait.at)[0])
        task = owners[wait.at]
        before, last[task] = last.get(task), wait
        k = bisect_left(times.get(task, []), wait.until)
        is_repeated = before is not None and before.at == wait.at and wait.since - before.until < LATE
        is_last = k < len(times.get(task, [])) and times[task][k] < wait.until + LATE
        if before is not None and is_repeated and is_last:
            found[task, acts[task][k].line] = wait.until - before.until
    return found
