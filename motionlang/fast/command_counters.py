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

from collections.abc import Sequence

from motionlang.fast.loop_counters import counted
from motionlang.mccl.resolve.command import NUMBER, REGISTER, Command
from motionlang.mccl.resolve.line import Line
from motionlang.mccl.runtime.loop_tests import COMPARES, CONDITIONS, JUMPS, LEAVES, NEUTRAL, SETS
from motionlang.mccl.runtime.task import PRIVATE, CommandTask
from motionlang.record import record

# A loop: a line, and the first and the last command of the loop in it.
Loop = tuple[Line, int, int]

_STEPS = {"add": 1, "subtract": -1}


@record
class Counter:
    """A register that a loop counts.

    Each iteration adds `step` to it and compares it with `levels`. If `is_left`, its value is still in the accumulator
    at the end of the iteration.
    """

    register: int
    step: int
    levels: tuple[float, ...]
    is_left: bool


@record
class TaskCounter:
    """A counter of one of several tasks; `is_first` marks the first one of its task."""

    task: CommandTask
    counter: Counter
    is_first: bool


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
        before, self._values = self._values, [self._task.register(each.register) for each in counters]
        if effects != len(counters) or len(before) != len(counters):
            return ()
        counts = all(n + each.step == m for n, each, m in zip(before, counters, self._values, strict=True))
        return counters if counts and all(isinstance(m, int) for m in self._values) else ()

    def most(self, counters: Sequence[Counter]) -> float:
        """Return how many iterations may follow before the result of a comparison changes."""
        return counted(self._values, [each.step for each in counters], [each.levels for each in counters])

    def count(self, counters: Sequence[Counter], iterations: int) -> None:
        """Advance the counters by a number of iterations."""
        task = self._task
        for each in counters:
            task.set_register(each.register, task.register(each.register) + each.step * iterations)
            if each.is_left:
                task.registers[0] = task.register(each.register)
        self._values = [task.register(each.register) for each in counters]

    def leaves_accumulator(self, counters: Sequence[Counter]) -> bool:
        """True if the accumulator has the value of a counter at the end of an iteration."""
        return any(each.is_left for each in counters)

    def _counters(self) -> tuple[Counter, ...]:
        """Return the counters of the loop that the task is about to repeat."""
        task = self._task
        assert task.line is not None
        key = id(task.line), task.pc, task.here
        found = self._known.get(key)
        if found is None:
            found = self._known[key] = task.line, tuple(_counters_in(*_commands(task, (task.line, *key[1:]))))
        return found[1]


def counters_of(running: Sequence[tuple[CommandTask, Loop | None]]) -> list[TaskCounter]:
    """Return the registers that tasks count while each stays in its loop.

    The result is empty if a task has no loop, may leave its loop by a macro, or uses a register that another task
    counts.
    """
    found: list[TaskCounter] = []
    bodies: list[tuple[CommandTask, Sequence[Command]]] = []
    for task, loop in running:
        if loop is None or loop[0] is not task.line:
            return []
        commands, governs = _commands(task, loop)
        if LEAVES.intersection([each.row.verb for each in commands if each.row is not None]):
            return []
        counters = _counters_in(commands, governs)
        found += [TaskCounter(task, each, not k) for k, each in enumerate(counters)]
        bodies.append((task, commands))
    for one in found:
        number = one.counter.register
        others = [commands for task, commands in bodies if task is not one.task]
        if number >= PRIVATE and any(uses_register(each, number) for body in others for each in body):
            return []
    return found


def _commands(task: CommandTask, loop: Loop) -> tuple[Sequence[Command], int]:
    """Return the commands of a loop, and how many commands a condition governs."""
    line, first, last = loop
    return line.commands[first : last + 1], task.board.assumptions.get("mccl.skipped", 2)  # type: ignore[return-value]


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
        uses = [uses_register(each, int(first.value)) for each in commands].count(True)
        found = _levels(commands, verbs, k + 3, governs)
        if first.value in (0, None) or uses != 2 or found is None:
            return []
        made.append(Counter(int(first.value), _STEPS[verbs[k + 1]] * step.value, *found))
    return made if all(each.step for each in made) else []


def uses_register(command: Command, number: int) -> bool:
    """True if a command may read or write a register; RA@ and AR@ may use any."""
    accesses = command.row is not None and command.row.verb in ("recall", "store")
    if command.kind == REGISTER:
        return accesses or command.value == number
    return accesses and command.value == number


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
