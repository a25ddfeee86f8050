"""Which transitions of a program a run takes, how often, and when.

An `Observer` wraps the functions of the steps that enter a state or choose a branch, so that the run is the same to the
last digit. It follows each call of each task: from a state, the branches on the way identify the transition that has
been taken (`Transition.branches`). Iterations that the rule of loops skips repeat what was counted in the last one.

A transition that is not in the diagram is counted in `strays`, which a test expects to be empty.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from motionlang.commands.map.states import Branches, Diagrams, State, Transition
from motionlang.kernel import Machine, Steps
from motionlang.kernel.lang import GO, StepTask, Values

# As many events are remembered for iterations that are skipped.
MAX_EVENTS = 200_000


@dataclass(eq=False, slots=True)
class Taken:
    """How often a transition was taken, when first and last, and how long after its source was entered, s."""

    count: int = 0
    first: float = 0.0
    last: float = 0.0
    shortest: float = 0.0
    longest: float = 0.0
    total: float = 0.0

    def add(self, time: float, lasted: float) -> None:
        """Count a transition at a time."""
        if not self.count:
            self.first, self.shortest, self.longest = time, lasted, lasted
        self.count += 1
        self.last, self.total = time, self.total + lasted
        self.shortest, self.longest = min(self.shortest, lasted), max(self.longest, lasted)


@dataclass(eq=False, slots=True)
class _Frame:
    """A call of a unit: the state that it is in since a time, and the branches since then.

    The state is None after a failed statement. `has_jumped` is True until the first state of a unit that another unit
    has jumped into.
    """

    task: StepTask
    depth: int
    owner: int
    state: State | None
    since: float
    branches: list[tuple[tuple[str, int], int]] = field(default_factory=list)
    has_jumped: bool = False


class Observed:
    """Counts the transitions of a run, as its observer."""

    def __init__(self, diagrams: Diagrams) -> None:
        self.diagrams = diagrams
        self.taken: dict[Transition, Taken] = {}
        # Transitions that no diagram has: source and target.
        self.strays: list[tuple[str, str]] = []
        # How often the program went on at each state after a failed statement.
        self.recovered: dict[State, int] = {}
        # The units that have run, by number, each after the number of its caller, -1 for none.
        self.calls: set[tuple[int, int]] = set()
        self._roots = {
            k for k, each in enumerate(diagrams.diagrams) if each.unit.kind in ("program", "task", "event")
        }
        self._starts = [each.states[0] for each in diagrams.diagrams]
        self._known: dict[tuple[int, Branches], list[Transition]] = {}
        for diagram in diagrams.diagrams:
            for each in diagram.transitions:
                self._known.setdefault((id(each.source), each.branches), []).append(each)
        self._frames: dict[StepTask, list[_Frame]] = {}
        # Tasks in which a statement has failed before the first state.
        self._lost: set[StepTask] = set()
        self._events: list[Transition] = []
        self._dropped = 0
        self.machine: Machine | None = None

    def attach(self, machine: Machine) -> None:
        """Watch a run that is about to begin on a machine."""
        self.machine = machine

    def ended(self) -> None:
        """Count the end of a program whose last step is none of its own: a file ends with its last line."""
        for frames in self._frames.values():
            for frame in frames:
                if frame.owner == 0 and frame.state is not None:
                    found = self._known.get((id(frame.state), tuple(frame.branches)), [])
                    if any(each.target.kind == "end" for each in found):
                        self._take(frame, found[0].target, frame.task.machine.clock.now)

    # ------------------------------------------------------------------------------------------ as an observer

    @property
    def seen(self) -> int:
        return self._dropped + len(self._events)

    def written(self, steps: Steps) -> None:
        """Let the steps at which states are entered and branches chosen report that."""
        for index, step in enumerate(steps):
            key = steps.name, index
            state = self.diagrams.states.get(key)
            do = step.do
            if key in self.diagrams.branches:
                do = self._choosing(key, step.kind, do)
            if state is not None:
                do = self._entering(key, state, do)
            if do is not step.do:
                steps[index] = step._replace(do=do)

    def skipped(self, first: int, end: int, times: int) -> None:
        for each in self._events[max(0, first - self._dropped) : max(0, end - self._dropped)]:
            self.taken[each].count += times

    def failed(self, task: StepTask) -> None:
        """Forget where a task is, unless a unit around it is still followed."""
        if not any(frame.owner in self._roots for frame in self._frames.get(task, ())):
            self._lost.add(task)
        for frame in self._frames.get(task, ()):
            if frame.depth >= len(task.calls):
                frame.state = None
                frame.branches.clear()

    # ----------------------------------------------------------------------------------------------- following

    def _entering(self, key: tuple[str, int], state: State, do: Any) -> Callable[[Values], Any]:
        def enter(values: Values) -> Any:
            self._enter(key, state)
            return None if do is None else do(values)

        return enter

    def _choosing(self, key: tuple[str, int], kind: int, do: Any) -> Callable[[Values], Any]:
        choices = self.diagrams.branches[key]

        def choose(values: Values) -> Any:
            found = do(values)
            chosen = choices.index(found) if kind == GO else 0 if found else 1
            frame = self._frame(key)
            if frame is not None:
                frame.branches.append((key, chosen))
            return found

        return choose

    def _frame(self, key: tuple[str, int]) -> _Frame | None:
        """Return the call that the running task is in at a point."""
        task, owner = self._task, self.diagrams.owners.get(key)
        if task is None or owner is None:
            return None
        frames = self._frames.setdefault(task, [])
        depth = len(task.calls)
        while frames and frames[-1].depth > depth:
            frames.pop()
        here = [k for k, frame in enumerate(frames) if frame.depth == depth]
        same = [k for k in here if frames[k].owner == owner]
        if same:
            del frames[same[-1] + 1 :]
            return frames[-1]
        now = task.machine.clock.now
        self.calls.add((frames[-1].owner if frames else -1, owner))
        is_lost = task in self._lost and owner in self._roots
        if is_lost:
            self._lost.discard(task)
        frames.append(_Frame(task, depth, owner, None if is_lost else self._starts[owner], now))
        left = frames[here[-1]] if here else None
        if left is not None and left.state is not None and self._jumps(left):
            self._take(left, None, now)
            left.state = None
            left.branches.clear()
            frames[-1].has_jumped = True
        return frames[-1]

    @property
    def _task(self) -> StepTask | None:
        """The running task."""
        scheduler = self.machine.scheduler if self.machine is not None else None
        task = scheduler.current if scheduler is not None else None
        return task if isinstance(task, StepTask) else None

    def _enter(self, key: tuple[str, int], state: State) -> None:
        frame = self._frame(key)
        if frame is None:
            return
        assert self.machine is not None
        now = self.machine.clock.now
        if frame.state is state and not frame.branches and not self._loops(state):
            return  # its step is done again
        if frame.state is None:
            self.recovered[state] = self.recovered.get(state, 0) + 1
        elif frame.has_jumped and (id(frame.state), tuple(frame.branches)) not in self._known:
            pass  # it has been entered in the middle
        else:
            self._take(frame, state, now)
        frame.state, frame.since = state, now
        frame.branches.clear()
        frame.has_jumped = False
        if state.kind in ("return", "end"):
            self._frames[frame.task].remove(frame)

    def _jumps(self, frame: _Frame) -> bool:
        """True if the transition of a call leads into another unit; a macro that another one calls returns to it."""
        found = self._known.get((id(frame.state), tuple(frame.branches)), ())
        return any(each.target.kind == "jump" for each in found)

    def _loops(self, state: State) -> bool:
        return any(each.target is state for each in self._known.get((id(state), ()), ()))

    def _take(self, frame: _Frame, target: State | None, now: float) -> None:
        """Count the transition that a call has taken; no target is a jump into another unit."""
        if frame.state is None:
            return
        found = self._known.get((id(frame.state), tuple(frame.branches)), [])
        fitting = [
            each
            for each in found
            if (each.target is target if target is not None else each.target.kind == "jump")
        ]
        if not fitting:
            self.strays.append((frame.state.id, "jump" if target is None else target.id))
            return
        made = self.taken.setdefault(fitting[0], Taken())
        made.add(now, now - frame.since)
        self._events.append(fitting[0])
        if len(self._events) > MAX_EVENTS:
            half = MAX_EVENTS // 2
            self._dropped += half
            del self._events[:half]
