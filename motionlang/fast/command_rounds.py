"""Skipping of rounds when the joint state of polling MCCL tasks recurs.

Replaces: executing every command of background watches while two or more tasks can run. The tasks then
alternate command by command.

Hook: `Accelerators.rounds`; `Poll.again` of mccl/runtime/poll.py calls it at each jump back while another task
can run.

Gain: 10² to 10⁴ times for two or more watches (`mccl_2_watches` and `mccl_field_two_counts` of
benchmarks/cliffs.py).

Equality is tested by: tests/fast/test_command_rounds.py.

Idea. Suppose that the joint state recurs, and since its last occurrence no task has had an effect, none has waited for
a time and no event has happened. Then the next round is like the last one, until an event, the end of another task's
wait, or a time at which a value that they read changes. The state of a task is its line, its position in the line, the
macros that called the line, its repeats and its own registers. Everything else changes only by an effect.

The time of each command is the time of the one before plus its duration, a sum that is rounded. `advanced` computes
it for many commands: while a number keeps its exponent, adding the same duration changes it by the same amount. A
rounding tie may alternate, so two successive amounts are compared.

Counters. A task whose innermost loop counts a register (`command_counters.py`) has an effect in every iteration.
If the counters explain all effects of a round and no other loop uses their registers, each round advances them by the
same amount, until one of their comparisons changes. While a task counts, all tasks that can run must stay in one loop
and enter no line.
"""

from __future__ import annotations

from math import frexp, fsum, ldexp

from motionlang.controller.clock import INFINITY
from motionlang.fast.command_counters import counters_of
from motionlang.fast.loop_counters import counted
from motionlang.lang.dependencies import CLOSE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.fast.command_counters import Loop, TaskCounter
    from motionlang.lang.dependencies import Note
    from motionlang.mccl.runtime.board import Board
    from motionlang.mccl.runtime.task import CommandTask

    # How often a state was met, and when it was last, with the effects and the values of the counts by then.
    Met = tuple[int, float, int, list[float]]

# The state must be met so often: then every loop has found out since when only an event can end it. The next
# event makes that invalid, so up to there two are enough.
MEETINGS = 3
# More states are dropped, and after so many jumps of others another task is the one to compare by.
MAX_STATES = 2000
# Time slices are at least this long, s. A command that takes less ends within its own.
SHORTEST_SLICE = 5e-4


class CommandRounds:
    """The joint states of a board's tasks since the last effect other than a count."""

    def __init__(self, board: Board) -> None:
        self._board = board
        self._since: tuple[object, ...] = ()
        self._effects = 0
        self._read: set[Note] = set()
        # The innermost loop of each task that has jumped back: its line and its first and last command.
        self._loops: dict[str, Loop] = {}
        # The tasks that may run, with these loops, and what they count.
        self._running: list[tuple[CommandTask, Loop | None]] = []
        self._counters: list[TaskCounter] = []
        # The first task that has jumped back, by whose jumps states are compared, and the number of jumps of others.
        self._by: CommandTask | None = None
        self._others = 0
        self._met: dict[tuple[object, ...], Met] = {}

    def jumped(self, task: CommandTask) -> None:
        """Skip rounds, if possible, when a task jumps back."""
        board = self._board
        scheduler, clock = board.machine.scheduler, board.controller.clock
        assert task.line is not None
        loop = task.line, task.pc, task.here
        is_new, self._loops[task.name] = loop != self._loops.get(task.name), loop
        since = board.waited, clock.fired, clock.made, len(board.tasks)
        if (
            since != self._since
            or (is_new and self._counters)
            or (board.effects != self._effects and not self._counters)
            or len(self._met) > MAX_STATES
        ):
            self._begin(since)
            return
        self._effects = board.effects
        if task is not self._by:
            self._others += 1
            if self._by is not None and self._others < MAX_STATES:
                return
            self._by, self._others = task, 0
        now = task.base + task.count * task.cost
        values = self._values()
        times, before, effects, counted_before = self._met.get(key := self._key(task), (0, now, 0, values))
        self._met[key] = times + 1, now, board.effects, values
        if not times or scheduler is None or not scheduler.by_itself or task.cost >= SHORTEST_SLICE:
            return
        waits = [each.wait for each in board.tasks if each.wait is not None]
        if any(each.poll.dependencies.read is not self._read for each in board.tasks):
            return  # too many different readings
        if any(wait.ready() for wait in waits):
            return
        changes = [until(*about) for until, about in self._read]
        until = min(clock.next_time(), scheduler.until, *changes, *(wait.due() for wait in waits))
        if until == INFINITY or until - CLOSE <= now or (times + 1 < MEETINGS and until < clock.next_time()):
            return
        steps = [n - m for n, m in zip(values, counted_before, strict=True)]
        rounds = int(min((until - CLOSE - now) / (now - before), self._most(steps, board.effects - effects)))
        commands = round((now - before) / task.cost)
        # The last bits of very many sums may add up to a round.
        while (time := advanced(now, task.cost, rounds * commands)) > until - CLOSE:
            rounds -= 1
        if rounds > 0:
            self._share(task, time - now, len(board.tasks) - len(waits))
            self._count(steps, rounds)
            task.base, task.count = time, 0
            self._met.clear()

    def _begin(self, since: tuple[object, ...]) -> None:
        """Drop all states stored so far, and begin a search."""
        board = self._board
        self._since, self._effects, self._met, self._read = since, board.effects, {}, set()
        self._by, self._others = None, 0
        for each in board.tasks:
            each.poll.dependencies.read = self._read
        running = [(each, self._loops.get(each.name)) for each in board.tasks if each.wait is None]
        if running != self._running:
            self._running = running
            self._counters = counters_of(running)

    def _key(self, task: CommandTask) -> tuple[object, ...]:
        """Return the joint state that determines the next commands, without the counters."""
        tasks = self._board.tasks
        if not self._counters:
            return task.name, *map(_state, tasks)
        counting = {each.task for each in self._counters}
        return task.name, *[
            (*(_control_state if each in counting else _state)(each), each.loop_log.entered) for each in tasks
        ]

    def _values(self) -> list[float]:
        """Return the values of the counters, then the accumulators of their tasks."""
        values = [each.task.register(each.counter.register) for each in self._counters]
        return values + [task.registers[0] for task in self._counting()]

    def _counting(self) -> list[CommandTask]:
        return [each.task for each in self._counters if each.is_first]

    def _most(self, steps: Sequence[float], effects: int) -> float:
        """Return how many rounds with these steps may follow before a comparison changes.

        0 if the steps do not explain `effects`.
        """
        if not effects:
            return 0 if any(steps) else INFINITY
        values, counters = self._values(), self._counters
        counts = [step // each.counter.step for step, each in zip(steps, counters, strict=False)]
        if fsum(counts) != effects or any(not isinstance(each, int) for each in values[: len(counters)]):
            return 0
        return counted(values, steps, [each.counter.levels for each in counters])

    def _count(self, steps: Sequence[float], rounds: int) -> None:
        """Advance the counters and the accumulators by `rounds` times their `steps`."""
        registers = [(each.task, each.counter.register) for each in self._counters]
        registers += [(task, 0) for task in self._counting()]
        for (task, number), step in zip(registers, steps, strict=True):
            if step:
                task.set_register(number, task.register(number) + step * rounds)
        self._effects = self._board.effects

    def _share(self, task: CommandTask, seconds: float, running: int) -> None:
        """Distribute the computing time of skipped rounds over the running tasks.

        The scheduler attributes all of it to `task`.
        """
        taken = self._board.machine.log.slices.seconds
        for each in self._board.tasks:
            if each.wait is None and each is not task:
                taken[each.name] = taken.get(each.name, 0.0) + seconds / running
        taken[task.name] = taken.get(task.name, 0.0) - seconds * (running - 1) / running


def _state(task: CommandTask) -> tuple[object, ...]:
    """Return the state that determines a task's next commands as long as nothing acts."""
    return *_control_state(task), *map(_exact, task.registers)


def _control_state(task: CommandTask) -> tuple[object, ...]:
    """Return the state that determines a task's next commands, without its registers."""
    calls = [(id(line), pc, *repeats.items()) for line, pc, repeats in task.calls]
    own = id(task.line), task.pc, task.paid, id(task.wait), id(task.then), id(task.path_open)
    return *own, *task.repeats.items(), *calls


def _exact(value: float) -> tuple[type, float]:
    return value.__class__, value


def advanced(time: float, step: float, count: int) -> float:
    """Return `time` after adding `step` `count` times, with rounding each time."""
    while count > 0:
        after = time + step
        if after == time:
            return time
        amount, again = after - time, after + step - after
        limit = ldexp(1.0, frexp(time)[1])  # the next power of two
        many = min(count, int((limit - time) / amount) - 2) if amount == again and time > 0.0 else 0
        if many > 1:
            time += many * amount
            count -= many
        else:
            time = after
            count -= 1
    return time
