"""The entries of a machine file that come by the clock, matched by the piece that they belong to.

An input that a part fails by comes at a second of the machine file. If the program is faster, another part would be in
the machine then. So an entry that comes within the cycles belongs to what precedes it in the program as it is: the
begin or the end of a move, an output or a print of the task that works, or of one that it reads from. In a trial it
comes as long after the same moment. A lamp that blinks beside the work is no such moment.

An entry changes what follows it, and so perhaps the acts before the next entry. A trial is run again until no entry
moves any more; one run for each entry is enough, since what precedes the first entry that is wrong is right.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any

from motionlang.kernel import Run
from motionlang_explore.improve.acts import OrderedAct, acts_of
from motionlang_explore.improve.tasks import Tasks

# Times are equal within this, s.
SAME_TIME = 1e-6


class PieceTimes:
    """The entries by the clock of a run whose cycles begin at `starts`, in task `work`, and what precedes each."""

    def __init__(self, run: Run, tasks: Tasks, starts: Sequence[float], work: str) -> None:
        self._tasks, self._starts, self._settings = tasks, starts, run.machine.settings
        first, last = (starts[0], starts[-1]) if len(starts) > 1 else (0.0, 0.0)
        at = sorted({time for _, _, time in _entries(self._settings) if first < time < last})
        self._acts = acts_of(run, tasks) if at else {}
        ends = _ends(run) if at else {}
        order = sorted(
            moment
            for task, acts in self._acts.items()
            if task == work or tasks.reads(work, task)
            for k, act in enumerate(acts)
            for moment in ((act.time, task, k, False), (_end(act, ends), task, k, True))
        )
        times = [each[0] for each in order]
        # The time of each entry, with the last moment before it: its time, its task, the number of the act there, and
        # true for the end of a move.
        self._before = {time: order[bisect_left(times, time) - 1] for time in at if times and times[0] < time}

    def played(self, play: Callable[[Mapping[str, object]], Run]) -> Run:
        """Return the run of a trial that `play` plays with settings, with each entry at its piece."""
        times: dict[float, float] = {}
        run = play(self._settings)
        for _ in self._before:
            wanted = self._times(run)
            if all(abs(wanted[time] - times.get(time, time)) <= SAME_TIME for time in wanted):
                break
            times = wanted
            run = play(self._at(times))
        return run

    def moved(self, run: Run, name: str) -> Iterator[str]:
        """Yield a remark on each entry that comes at another time in a run, which is called `name`."""
        times = self._times(run)
        for kind, entry, time in _entries(self._settings):
            if abs(times.get(time, time) - time) > 1e-3:
                number = next((entry[key] for key in ("channel", "element", "address") if key in entry), "")
                part = bisect_right(self._starts, time) + self._offset
                yield (
                    f"{kind} {number} at {time:.6g} s belongs to piece {part}: {name} has it at {times[time]:.6g} s"
                )

    @property
    def _offset(self) -> int:
        """How many pieces precede the first start: one if the run works before it."""
        begin = min((acts[0].time for acts in self._acts.values() if acts), default=0.0)
        gaps = [after - before for before, after in pairwise(self._starts)]
        return int(bool(gaps) and self._starts[0] - begin > 0.5 * min(gaps))

    def _times(self, run: Run) -> dict[float, float]:
        """Return the time of each entry in a run: as long after the same act, if there is one."""
        if not self._before:
            return {}
        acts, ends = acts_of(run, self._tasks), _ends(run)
        found, shift = {}, 0.0
        for time, (before, task, k, is_end) in sorted(self._before.items()):
            act = _same(self._acts[task], acts.get(task, ()), k)
            if act is not None:
                shift = (_end(act, ends) if is_end else act.time) - before
            found[time] = time + shift
        return found

    def _at(self, times: Mapping[float, float]) -> Mapping[str, object]:
        """Return the settings with entries at other times."""
        changed = dict(self._settings)
        for name, value in self._settings.items():
            if isinstance(value, list):
                changed[name] = [
                    {**each, "at": times[each["at"]]}
                    if isinstance(each, Mapping) and each.get("at") in times
                    else each
                    for each in value
                ]
        return changed


def _entries(settings: Mapping[str, object]) -> Iterator[tuple[str, Mapping[str, Any], float]]:
    """Yield the entries that come by the clock alone: table, entry and time."""
    for name, value in settings.items():
        for each in value if isinstance(value, list) else ():
            at = each.get("at") if isinstance(each, Mapping) and "asked" not in each else None
            if isinstance(at, (int, float)):
                yield name, each, float(at)


def _ends(run: Run) -> dict[tuple[float, int], float]:
    """Return when moves end, by their begins and lines."""
    found: dict[tuple[float, int], float] = {}
    for move in run.machine.log.moves:
        if move.profile is not None:
            key = move.start_time, move.line
            found[key] = max(found.get(key, 0.0), move.start_time + move.profile.duration)
    return found


def _end(act: OrderedAct, ends: Mapping[tuple[float, int], float]) -> float:
    """Return when the move of an act ends; when the act comes if it is no move."""
    return ends.get((act.time, act.line), act.time)


def _same(acts: Sequence[OrderedAct], others: Sequence[OrderedAct], k: int) -> OrderedAct | None:
    """Return the act with a number in another run, None if another act is there."""
    if k >= len(others) or (acts[k].line, acts[k].text) != (others[k].line, others[k].text):
        return None
    return others[k]
