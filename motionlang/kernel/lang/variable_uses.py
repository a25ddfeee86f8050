"""Analysis of the variables of a loop of steps, once for each loop; `loops.py` uses it.

The facts are those of an analysis of liveness, backward through the steps (`Uses`):

    overwritten   every iteration sets the variable before it reads it, so no iteration depends on it
    linear        its value is only added, subtracted and compared, directly or after it has been copied
    used          the value that a step stores in it is used for more than tests

A reading that is only stored in a variable that nothing uses may change without changing the loop (`Copy`). So may that
of a clock that is stored in a variable which is only compared with the clock (`Span`), as in `TIME - t0 > 500`: within
an iteration both move together, so the difference is smaller than the time that an iteration takes.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from motionlang.kernel.lang.change_times import Note
from motionlang.kernel.lang.steps import CALL, ENTER, GO, RETURN, Steps, Uses

NONE: frozenset[int] = frozenset()


@dataclass(slots=True)
class IterationUses:
    """The use of variables in an iteration that stays within the steps of its loop."""

    # Every iteration sets these before it reads them.
    overwritten: frozenset[int] = NONE
    # These are somewhere used for more than sums and comparisons; None if that is not known.
    nonlinear: frozenset[int] | None = None
    # By the index of a step: the variables whose values are then used for more than tests.
    used_after: Sequence[frozenset[int]] = ()
    uses: Sequence[Uses | None] = ()
    # These are set to more than readings, or read in more than tests that say what they read.
    otherwise: frozenset[int] = NONE
    # Its steps and the first one, and whether it calls others.
    steps: Steps | None = None
    first: int = 0
    calls: bool = False

    def is_linear(self, variable: int) -> bool:
        """True if a variable is only added and compared."""
        return self.nonlinear is not None and variable not in self.nonlinear

    def is_only_copied(self, copy: Copy) -> bool:
        """True if no iteration uses what a step has stored for more than tests."""
        return (
            copy.variable in self.overwritten
            and self._has(copy)
            and copy.variable not in self.used_after[copy.step + 1 - self.first]
        )

    def set_first(self, notes: Iterable[Note]) -> frozenset[int]:
        """Return the variables that the iteration with some notes has set to a reading before it used them."""
        firsts: dict[int, object] = {}
        for mark, _ in notes:
            if isinstance(mark, Copy | Span):
                firsts.setdefault(mark.variable, mark)
        return frozenset(
            variable
            for variable, mark in firsts.items()
            if isinstance(mark, Copy)
            and (self._is_only_taken(variable) or (self._has(mark) and self._precedes(mark)))
        )

    def _has(self, copy: Copy) -> bool:
        return copy.steps is self.steps and 0 <= copy.step - self.first < len(self.uses)

    def _precedes(self, copy: Copy) -> bool:
        """True if no step before that of a copy reads the variable."""
        before = self.uses[: copy.step + 1 - self.first]
        return not any(use is None or copy.variable in use.reads | use.parts for use in before)

    def _is_only_taken(self, variable: int) -> bool:
        """True if a variable is only set to readings, and only read in tests that say what they read."""
        return variable not in self.otherwise and (variable >= 0 or not self.calls)

    def clocks(
        self, notes: Iterable[Note], overwritten: frozenset[int], ticks: object, milliseconds: float
    ) -> set[int]:
        """Return the variables that an iteration only sets to a clock, and only compares with that clock.

        The iteration of so many `milliseconds` has read `notes`. The difference is no larger, so no test of it turns
        whose level lies beyond.
        """
        found: defaultdict[int, set[tuple[Any, ...]]] = defaultdict(set)
        for mark, about in notes:
            if isinstance(mark, Copy):
                found[mark.variable].add((about[2], about[1]) if mark.is_whole and about[0] == ticks else ())
            elif isinstance(mark, Span):
                is_far = isinstance(mark.level, int | float) and not 0 <= mark.level <= milliseconds + 2
                found[mark.variable].add(about[:2] if is_far else ())
        is_one = {each for each, clocks in found.items() if len(clocks) == 1 and () not in clocks}
        return {each for each in is_one & overwritten if self._is_only_taken(each)}


UNKNOWN = IterationUses()


@dataclass(slots=True, eq=False)
class Copy:
    """A dependency of a reading that a step stores in a variable: it concerns only those who use the variable."""

    steps: Steps
    step: int
    variable: int
    # True if it stores the reading itself, and no sum.
    is_whole: bool = False

    def __call__(self, until: Callable[..., float], *about: Any) -> float:
        return until(*about)


@dataclass(frozen=True, slots=True)
class Span:
    """A dependency of a clock minus a variable, compared with a level."""

    variable: int
    level: object

    def __call__(self, until: Callable[..., float], *about: Any) -> float:
        return until(*about)


def body_of(steps: Steps, first: int, last: int) -> IterationUses:
    """Return what the steps from `first` to the jump back at `last` do with variables.

    An iteration goes on forward, so it has carried out no loop within it.
    """
    inside = list(enumerate(steps[first:last], first))
    uses = [_of_call(steps, pc) if step.kind == CALL else steps.uses[pc] for pc, step in inside]
    uses.append(steps.uses[last])
    known = [each for each in uses if each is not None]
    if len(known) < len(uses) or any(
        step.kind == ENTER or (step.kind == GO and step.to < 0) for _, step in inside
    ):
        return UNKNOWN
    live = _backward(steps, known, first, last, False, lambda use, after: (after - use.sets) | use.reads)
    used = _backward(
        steps, known, first, last, False, lambda use, after: (after - use.sets) | (use.reads - use.tests)
    )
    nonlinear = _backward(
        steps,
        known,
        first,
        last,
        True,
        lambda use, after: (after - use.sets) | use.nonlinear | (use.reads if use.sets & after else NONE),
    )
    overwritten = NONE.union(*(each.sets for each in known)) - live[0]
    return IterationUses(
        overwritten,
        NONE.union(*nonlinear),
        [*used, NONE],
        uses,
        NONE.union(*map(_otherwise, known)),
        steps,
        first,
        any(step.kind == CALL for _, step in inside),
    )


def _otherwise(use: Uses) -> frozenset[int]:
    return (use.reads - use.spans) | (use.sets - use.copies) | use.parts


def _of_call(steps: Steps, pc: int) -> Uses | None:
    """Return what a call may do with the variables of its caller, None if that is unknown."""
    known: list[Uses | None] = [steps.uses[pc]]
    seen: set[tuple[str, int]] = set()
    waiting = [(steps, pc)]
    while waiting:
        caller, at = waiting.pop()
        called, entry = caller.called.get(at, (caller, 0))
        if called is caller and not entry:
            return None  # it calls itself, or what is known only at run time
        points = [entry]
        while points:
            k = points.pop()
            step = called[k]
            if (called.name, k) in seen:
                continue
            seen.add((called.name, k))
            if step.kind == ENTER or (step.kind == GO and step.to < 0):
                return None
            if step.kind == CALL:
                waiting.append((called, k))
            if step.kind != RETURN or step.do is not None:
                use = called.uses[k]
                known.append(use if called is steps or use is None else _shared(use))
            points += called.following(k)
    if None in known:
        return None
    found = [each for each in known if each is not None]
    reads = NONE.union(*(each.reads for each in found))
    sets = NONE.union(*(each.sets for each in found))
    nonlinear = reads if sets else NONE.union(*(each.nonlinear for each in found))
    otherwise = NONE.union(*map(_otherwise, found))
    return Uses(reads, nonlinear=nonlinear, spans=reads - otherwise, parts=otherwise - reads)


def _shared(use: Uses) -> Uses:
    """Return what a step does with the variables that do not belong to a call."""
    return Uses(*(frozenset(n for n in each if n >= 0) for each in use))


def _backward(
    steps: Steps,
    uses: Sequence[Uses],
    first: int,
    last: int,
    goes_on: bool,
    before: Callable[[Uses, frozenset[int]], frozenset[int]],
) -> list[frozenset[int]]:
    """Return a set of variables for each step of a loop: `before` of what it uses and the sets of those that follow it.

    `goes_on`: the first step follows the jump back.
    """
    found = [NONE] * (last - first + 1)
    following = [
        [each - first for each in steps.following(pc) if first <= each <= last] for pc in range(first, last)
    ]
    following.append([0] if goes_on else [])
    changed = True
    while changed:
        changed = False
        for k in reversed(range(len(found))):
            new = before(uses[k], NONE.union(*(found[each] for each in following[k])))
            changed |= new != found[k]
            found[k] = new
    return found
