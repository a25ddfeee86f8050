"""Registers that a polling MCCL loop counts: how many iterations may be skipped.

Replaces: running every iteration of a polling loop in which a register counts, as RA40,AA1,AR40 does. Iterations are
skipped only while all comparisons with the register give the same result.

Hook: `Accelerators.registers`; `Poll.again` of mccl/runtime/poll.py calls `advanced` at a jump back if a register
has changed since the last one.

Gain: 10² to 10³ times (`mccl_status_counted` and `mccl_watch_counts` of benchmarks/cliffs.py).

Equality is tested by: tests/fast/test_command_counters.py, with generated loops.

A register counts if a loop recalls it, adds or subtracts a whole number and stores it again, in three commands that
no condition governs, and uses it nowhere else. Until the accumulator is set again, its value may only be compared
with numbers. If each counter has advanced by its step, and the iteration had as many effects as there are counters,
it had no other effect.
"""

from __future__ import annotations

from motionlang.fast.loop_counters import counted
from motionlang.mccl.resolve.command import NUMBER, REGISTER
from motionlang.mccl.runtime.poll import COMPARES, CONDITIONS, JUMPS, LEAVES, NEUTRAL, SETS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.resolve.line import Line
    from motionlang.mccl.runtime.task import CommandTask

    # A register, what an iteration adds to it, the numbers with which it is compared, and if it is still in the
    # accumulator at the end.
    Counter = tuple[int, int, tuple[float, ...], bool]

_STEPS = {"add": 1, "subtract": -1}


class CountedRegisters:
    """The counters of a task's innermost loop, and their values at its last jump back."""

    def __init__(self, task: CommandTask) -> None:
        self._task = task
        self._known: dict[tuple[int, int, int], tuple[Line, tuple[Counter, ...]]] = {}
        self._values: list[float | int] = []

    def advanced(self, effects: int) -> tuple[Counter, ...]:
        """Return the counters of the iteration that ends here, or ().

        The result is () unless they explain all `effects` of the iteration. `effects` is negative if the last jump
        back was that of another loop.
        """
        counters = self._counters()
        if not counters:
            return ()
        before, self._values = self._values, [self._task.register(number) for number, *_ in counters]
        if effects != len(counters) or len(before) != len(counters):
            return ()
        steps = (step for _, step, *_ in counters)
        counts = all(n + step == m for n, step, m in zip(before, steps, self._values, strict=True))
        return counters if counts and all(isinstance(m, int) for m in self._values) else ()

    def most(self, counters: Sequence[Counter]) -> float:
        """Return how many iterations may follow before the result of a comparison changes."""
        steps, levels = [step for _, step, *_ in counters], [each for _, _, each, _ in counters]
        return counted(self._values, steps, levels)

    def count(self, counters: Sequence[Counter], iterations: int) -> None:
        """Advance the counters by a number of iterations."""
        task = self._task
        for number, step, _, is_left in counters:
            task.set_register(number, task.register(number) + step * iterations)
            if is_left:
                task.registers[0] = task.register(number)
        self._values = [task.register(number) for number, *_ in counters]

    def leaves_accumulator(self, counters: Sequence[Counter]) -> bool:
        """True if the accumulator has the value of a counter at the end of an iteration."""
        return any(is_left for *_, is_left in counters)

    def _counters(self) -> tuple[Counter, ...]:
        """Return the counters of the loop that the task is about to repeat."""
        task = self._task
        assert task.line is not None
        key = id(task.line), task.pc, task.here
        found = self._known.get(key)
        if found is None:
            governs: int = task.board.assumptions.get("mccl.skipped", 2)  # type: ignore[assignment]
            commands = task.line.commands[task.pc : task.here + 1]
            found = self._known[key] = task.line, tuple(_counters_in(commands, governs))
        return found[1]


def _counters_in(commands: Sequence[Command], governs: int) -> list[Counter]:
    """Return the counters of a loop."""
    verbs = [each.row.verb if each.row is not None else "" for each in commands]
    if (LEAVES | JUMPS).intersection(verbs[:-1]):
        return []
    made: list[Counter] = []
    for k in range(len(verbs) - 2):
        if verbs[k] != "recall" or verbs[k + 1] not in _STEPS or verbs[k + 2] != "store":
            continue
        first, step, last = (commands[k + j] for j in range(3))
        if (
            {first.kind, step.kind, last.kind} != {NUMBER}
            or first.value != last.value
            or not isinstance(step.value, int)
        ):
            return []
        if CONDITIONS.intersection(verbs[max(0, k - governs) : k]):
            return []
        uses = [
            verb
            for each, verb in zip(commands, verbs, strict=True)
            if each.value == first.value and (each.kind == REGISTER or verb in ("recall", "store"))
        ]
        found = _levels(commands, verbs, k + 3, governs)
        if first.value in (0, None) or len(uses) != 2 or found is None:
            return []
        made.append((int(first.value), _STEPS[verbs[k + 1]] * step.value, *found))
    return made if all(step for _, step, *_ in made) else []


def _levels(
    commands: Sequence[Command], verbs: Sequence[str], first: int, governs: int
) -> tuple[tuple[float, ...], bool] | None:
    """Return the numbers compared with the accumulator from command `first` on.

    The second item is true if the loop ends before the accumulator is set again. None if its value may be used for
    anything else.
    """
    levels: list[float] = []
    for k in [*range(first, len(verbs)), *range(first - 3)]:
        if verbs[k] in SETS and not CONDITIONS.intersection(verbs[max(0, k - governs) : k]):
            return tuple(levels), k < first
        if verbs[k] in COMPARES and commands[k].kind == NUMBER:
            levels.append(float(commands[k].value))
        elif verbs[k] not in NEUTRAL and commands[k].pure:
            return None
    return tuple(levels), True
