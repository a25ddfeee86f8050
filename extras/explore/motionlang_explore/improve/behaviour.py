"""The behaviour that no edit may change: each task and each handler does the same things in the same order.

Its moves with their ends, its outputs and its prints are compared, up to the last whole cycle of the shorter run.
Figures in prints may differ, and so may the rest of a homing or of a stopped motion. Two things bind tasks that read
what others set to these, and each task to its own moves:

    overlap   an output or the begin of a move that never came while an axis moved must not come while it moves
    place     the other axes are where they were at the begin and the end of each move, at each output and print. An act
              of a task that reads what the task of a move sets is bound to its place there, and every act to an axis
              that an input follows, unless it answers an input that follows no axis, or comes as long after such an
              answer. An axis that jogs binds only an act that comes at the same place in every cycle

A value that a host reads may change all the time, and is no act.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from math import inf

from motionlang.kernel import Run
from motionlang.kernel.log import GRAVE
from motionlang_explore.improve.acts import LATE, OrderedAct, Place, acts_of, polls_of
from motionlang_explore.improve.tasks import Tasks

# An act by its task, line and text.
ActKey = tuple[str, int, str]
# Positions are equal within this, user units.
SAME = 1e-6
# A statement is late by no more, s.
EXACT = 1e-4


class Behaviour:
    """The behaviour of a run, whose cycles begin at `starts`.

    `status` is the one at the end of the program, if the run is only the beginning of it. Without `starts` no act is
    known to come at the same place in every cycle.
    """

    def __init__(self, run: Run, tasks: Tasks, starts: Sequence[float] | None, status: str = "") -> None:
        has_cycles, starts = starts is not None, starts or ()
        self._tasks, self._starts, self._status = tasks, starts, run.status
        self._statuses = {run.status, status or run.status}
        # What goes on at the time limit may end before it if it is faster.
        self._may_end = "until" in self._statuses
        # True if the last cycle may be cut anywhere: by the end of the run, or by an input at a fixed time.
        self._is_cut = run.status != "ended" or any(
            each > min(starts, default=0.0) for each in _fixed_times(run)
        )
        self._ends, self._grave = _ends(run), _grave(run)
        self._acts = acts_of(run, tasks)
        self._answers = sorted(_answer_times(run))
        # The axes that inputs follow, so that what answers one is bound to its axis.
        self._watched = {each["axis"] for each in _inputs(run) if "axis" in each}
        self._polls = polls_of(run, tasks, self._acts)
        # By task, line and text: the axes that move as it comes, and its places by cycle.
        self._overlaps: dict[ActKey, set[tuple[int, bool]]] = {}
        # How often the same act came before in its cycle.
        self._numbers: dict[tuple[ActKey, float], int] = {}
        cycles: dict[ActKey, list[list[OrderedAct]]] = {}
        whole = max(len(starts) - 1, 1)
        for task, acts in self._acts.items():
            for act in acts:
                key = task, act.line, act.text
                self._overlaps.setdefault(key, set()).update(act.moving)
                at = bisect_right(starts, act.time) - 1 if len(starts) > 1 else 0
                if 0 <= at < whole:
                    some = cycles.setdefault(key, [[] for _ in range(whole)])[at]
                    self._numbers[key, act.time] = len(some)
                    some.append(act)
        is_steady = {key: has_cycles and len(set(map(len, each))) == 1 for key, each in cycles.items()}
        self._steady = {key: each for key, each in cycles.items() if is_steady[key]}

    def difference(self, run: Run, starts: Sequence[float]) -> str:
        """Return what another run does differently; "" if nothing that matters."""
        is_over = self._may_end and run.status in ("ended", "stopped") and len(starts) >= len(self._starts)
        if run.status not in self._statuses and not is_over:
            errors = [each.message for each in run.diagnostics if each.severity == "error"]
            return errors[0] if errors else f"the run {run.status}, not {self._status}"
        if _grave(run) != self._grave:
            return "a limit, a fault or a clamp comes or goes"
        own_until = until = inf
        if self._is_cut or run.status != "ended" or len(starts) != len(self._starts):
            common = min(len(starts), len(self._starts))
            own_until, until = ((each[common - 1] if common else inf) for each in (self._starts, starts))
        others = acts_of(run, self._tasks)
        for key, was, is_, is_answer in self._pairs(others, own_until, until):
            reason = self._changed(key, was, is_) or self._elsewhere(key, was, is_, is_answer)
            if reason:
                return reason
        is_whole = run.status == self._status == "ended" and until == inf
        if is_whole and len(self._acts.get("program", [])) != len(others.get("program", [])):
            return "the number of outputs, prints and moves of the program"
        return "the final positions" if is_whole and not self._is_at_rest(run) else ""

    def elsewhere(self, run: Run) -> str:
        """Return which axis is elsewhere at an act that answers no input, in another run; "" if none."""
        diverged = set()
        for key, was, is_, is_answer in self._pairs(acts_of(run, self._tasks)):
            if self._changed(key, was, is_):
                diverged.add(key[0])
            reason = "" if is_answer or key[0] in diverged else self._elsewhere(key, was, is_, is_answer)
            if reason:
                return reason
        return ""

    def _pairs(
        self, others: Mapping[str, Sequence[OrderedAct]], own_until: float = inf, until: float = inf
    ) -> Iterator[tuple[ActKey, OrderedAct, OrderedAct, bool]]:
        """Yield each act with the one in its place, and true if it answers an input."""
        for task, acts in self._acts.items():
            answered: tuple[OrderedAct, OrderedAct] | None = None
            for was, is_ in zip(acts, others.get(task, ()), strict=False):
                if was.time >= own_until or is_.time >= until:
                    break
                is_answer = self._is_answer(was, is_, answered)
                answered = (was, is_) if is_answer else None
                yield (task, was.line, was.text), was, is_, is_answer

    def _changed(self, key: ActKey, was: OrderedAct, is_: OrderedAct) -> str:
        """Return how an act differs from the one in its place; "" if it does not."""
        if (was.line, was.text) != (is_.line, is_.text):
            where = "" if key[0] == "program" else f" of {key[0]}"
            return f"the order of outputs and prints{where}: {is_.text} in place of {was.text}"
        if was.end is not None and is_.end is not None and abs(was.end - is_.end) > SAME:
            return f"the move of line {was.line} no longer ends at {round(was.end, 6) + 0.0:.6g}"
        return ""

    def _elsewhere(self, key: ActKey, was: OrderedAct, is_: OrderedAct, is_answer: bool) -> str:
        """Return which axis is elsewhere at an act, or at the end of a move; "" if none."""
        task, line, text = key
        what = f"line {line}: {text}", f"line {line}: the end of {text}"
        # A run may end before a move.
        are_over = was.end is not None and is_.end is not None
        mine, others = (
            {at: place for at, place in act.moving.items() if are_over or not at[1]} for act in (was, is_)
        )
        for at, place in others.items():
            mover = self._tasks.at(place.line)
            is_bound = key in self._steady and (
                self._tasks.reads(task, mover) or self._tasks.reads(mover, task)
            )
            never = at not in self._overlaps[key] and (task == mover or is_bound)
            is_new = at not in mine and task == mover and place.left < inf
            if (never or is_new) and not self._is_same(key, None, place, EXACT):
                return f"{what[at[1]]} while axis {at[0]} moves"
        for at, place in mine.items():
            mover = self._tasks.at(place.line)
            depends = self._tasks.reads(task, mover) or at[0] in self._watched
            is_bound = task == mover or (depends and not is_answer)
            places = self._places(key, was, at) if is_bound else []
            if not places and is_bound and place.left < inf:
                places = [place]
            other = others.get(at)
            if places and not any(self._is_same(key, other, each, EXACT) for each in places):
                where = f"{round(place.distance, 6) + 0.0:.6g} uu of the move of line {place.line}"
                return f"{what[at[1]]} no longer at {where}"
        return ""

    def _places(self, key: ActKey, act: OrderedAct, at: tuple[int, bool]) -> list[Place]:
        """Return how far an axis is at an act in each cycle, none if that is not the same place."""
        cycles = self._steady.get(key, [])
        number = self._numbers.get((key, act.time), 0)
        places = [place for each in cycles if (place := each[number].moving.get(at)) is not None]
        is_same = all(self._is_same(key, each, places[0], LATE) for each in places)
        return places if is_same and len(places) == len(cycles) else []

    def _is_answer(
        self, was: OrderedAct, is_: OrderedAct, answered: tuple[OrderedAct, OrderedAct] | None
    ) -> bool:
        """True if an act answers an input that follows no axis, or comes as long after such an act in both runs."""
        at = bisect_right(self._answers, was.time) - 1
        if at >= 0 and was.time - self._answers[at] < LATE:
            return True
        if answered is None:
            return False
        before, after = answered
        return abs((was.time - before.time) - (is_.time - after.time)) < LATE

    def _is_same(self, key: ActKey, one: Place | None, other: Place, late: float) -> bool:
        """True if places are as near as the time between two looks allows; None is the begin or the end of a move."""
        late += self._polls.get(key[:2], 0.0)
        if one is None:
            return min(abs(other.distance), other.left) <= SAME + late * other.speed
        is_near = abs(one.distance - other.distance) <= SAME + late * max(one.speed, other.speed)
        return is_near and one.line == other.line

    def _is_at_rest(self, run: Run) -> bool:
        return all(abs(end - self._ends.get(axis, end)) <= SAME for axis, end in _ends(run).items())


def _inputs(run: Run) -> list[dict[str, object]]:
    return run.machine.settings.get("input", [])  # type: ignore[return-value]


def _fixed_times(run: Run) -> Iterator[float]:
    """Yield the times at which inputs change by the clock alone."""
    yield from (
        at for each in _inputs(run) if isinstance(at := each.get("at"), (int, float)) and "asked" not in each
    )


def _answer_times(run: Run) -> Iterator[float]:
    """Yield the times at which inputs change that follow outputs or the clock, not an axis."""
    by_axis = {each["channel"] for each in _inputs(run) if "axis" in each}
    yield from (each.time for each in run.machine.log.inputs if each.channel not in by_axis)


def _ends(run: Run) -> dict[int, float]:
    axes = run.controller.axes.values()
    moved = {move.axis for move in run.machine.log.moves}
    return {a.index: a.scale.position_to_user(a.position(run.time)) for a in axes if a.index in moved}


def _grave(run: Run) -> list[str]:
    return sorted({f"{each.kind} {each.axis}" for each in run.machine.log.events if each.kind in GRAVE})
