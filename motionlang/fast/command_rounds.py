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

from math import frexp, ldexp

from motionlang.lang.task import CLOSE, INFINITY

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.dependencies import Note
    from motionlang.mccl.runtime.board import Board
    from motionlang.mccl.runtime.task import CommandTask

# The state must be met this often: by then every loop has found out if anything can end it.
MEETINGS = 3
# More states are dropped.
MAX_STATES = 2000
# Time slices are at least this long, s. A command that takes less ends within its own.
SHORTEST_SLICE = 5e-4


class CommandRounds:
    """The joint states of a board's tasks since the last effect other than a count."""

    def __init__(self, board: Board) -> None:
        self._board = board
        self._since: tuple[object, ...] = ()
        self._read: set[Note] = set()
        # How often a state was met, and when it was last.
        self._met: dict[tuple[object, ...], tuple[int, float]] = {}

    def jumped(self, task: CommandTask) -> None:
        """Skip rounds, if possible, when a task jumps back."""
        board = self._board
        scheduler, clock = board.machine.scheduler, board.controller.clock
        since = board.effects, board.waited, clock.fired, clock.made, len(board.tasks)
        if since != self._since or len(self._met) > MAX_STATES:
            self._since, self._met, self._read = since, {}, set()
            for each in board.tasks:
                each.poll.dependencies.read = self._read
            return
        now = task.base + task.count * task.cost
        key = task.name, *map(_state, board.tasks)
        times, before = self._met.get(key, (0, now))
        self._met[key] = times + 1, now
        if (
            times + 1 < MEETINGS
            or scheduler is None
            or not scheduler.by_itself
            or task.cost >= SHORTEST_SLICE
        ):
            return
        waits = [each.wait for each in board.tasks if each.wait is not None]
        if any(each.poll.dependencies.read is not self._read for each in board.tasks):
            return  # too many different readings
        if any(wait.ready() for wait in waits):
            return
        changes = [until(*about) for until, about in self._read]
        until = min(clock.next_time(), scheduler.until, *changes, *(wait.due() for wait in waits))
        if until == INFINITY:
            return
        rounds = int((until - CLOSE - now) / (now - before)) - 1
        if rounds > 0:
            time = advanced(now, task.cost, rounds * round((now - before) / task.cost))
            self._share(task, time - now, len(board.tasks) - len(waits))
            task.base, task.count = time, 0
            self._met.clear()

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
    calls = [(id(line), pc, *repeats.items()) for line, pc, repeats in task.calls]
    place = id(task.line), task.pc, task.paid, id(task.wait), id(task.then), id(task.path_open)
    return *place, *task.repeats.items(), *calls, *map(_exact, task.registers)


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
