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
from motionlang.kernel.lang.steps import BACK, CALL, ENTER, GO, Steps, Uses

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
    first: int = 0

    def is_linear(self, variable: int) -> bool:
        """True if a variable is only added and compared."""
        return self.nonlinear is not None and variable not in self.nonlinear

    def is_only_copied(self, copy: Copy) -> bool:
        """True if no iteration uses what a step has stored for more than tests."""
        return (
            copy.variable in self.overwritten
            and copy.variable not in self.used_after[copy.step + 1 - self.first]
        )

    def is_set_first(self, copy: Copy) -> bool:
        """True if an iteration that has carried out the step of a copy has not read the variable before."""
        before = self.uses[: max(copy.step + 1 - self.first, 0)]
        return bool(before) and not any(
            use is None or copy.variable in use.reads | use.parts for use in before
        )

    def clocks(
        self, notes: Iterable[Note], overwritten: frozenset[int], ticks: object, milliseconds: float
    ) -> set[int]:
        """Return the variables that an iteration only sets to a clock, and only compares with that clock.

        The iteration of so many `milliseconds` has read `notes`. The difference is no larger, so no test of it turns
        whose level lies beyond.
        """
        found: defaultdict[int, set[tuple[Any, ...]]] = defaultdict(set)
        steps: defaultdict[int, set[int]] = defaultdict(set)
        for mark, about in notes:
            if isinstance(mark, Copy) and mark.is_whole and about[0] == ticks:
                found[mark.variable].add((about[2], about[1]))
                steps[mark.variable].add(mark.step)
            elif isinstance(mark, Span):
                is_far = isinstance(mark.level, int | float) and not 0 <= mark.level <= milliseconds + 2
                found[mark.variable].add(about[:2] if is_far else ())
        for step, use in enumerate(self.uses, self.first):
            for variable in found:
                if use and (
                    variable in use.reads - use.spans
                    or (variable in use.sets | use.parts) is not (step in steps[variable])
                ):
                    found[variable].add(())
        is_one = {each for each, clocks in found.items() if len(clocks) == 1 and () not in clocks}
        return is_one & overwritten


UNKNOWN = IterationUses()


@dataclass(slots=True, eq=False)
class Copy:
    """A dependency of a reading that a step stores in a variable: it concerns only those who use the variable."""

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
    """Return what the steps from `first` to the jump back at `last` do with variables."""
    uses = steps.uses[first : last + 1]
    inside = list(enumerate(steps[first:last], first))
    if None in uses or any(
        step.kind in (CALL, ENTER) or (step.kind in (BACK, GO) and step.to <= pc) for pc, step in inside
    ):
        return UNKNOWN
    live = _backward(steps, first, last, False, lambda use, after: (after - use.sets) | use.reads)
    used = _backward(
        steps, first, last, False, lambda use, after: (after - use.sets) | (use.reads - use.tests)
    )
    nonlinear = _backward(
        steps,
        first,
        last,
        True,
        lambda use, after: (after - use.sets) | use.nonlinear | (use.reads if use.sets & after else NONE),
    )
    overwritten = NONE.union(*(each.sets for each in uses if each)) - live[0]
    return IterationUses(overwritten, NONE.union(*nonlinear), [*used, NONE], uses, first)


def _backward(
    steps: Steps,
    first: int,
    last: int,
    goes_on: bool,
    before: Callable[[Uses, frozenset[int]], frozenset[int]],
) -> list[frozenset[int]]:
    """Return a set of variables for each step of a loop: `before` of its uses and the sets of those that follow it.

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
            uses = steps.uses[first + k]
            assert uses is not None
            new = before(uses, NONE.union(*(found[each] for each in following[k])))
            changed |= new != found[k]
            found[k] = new
    return found
