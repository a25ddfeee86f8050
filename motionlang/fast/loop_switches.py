"""Polling loops that switch outputs and return to the same levels.

Replaces: running every iteration of such a loop, for example OUTX(1) = 1 : OUTX(1) = 0.

Hook: `Accelerators.switches`; `Site.check` of mint/runtime/loop_skipping.py calls `skip` if an iteration has only
switched outputs.

Gain: 10³ to 10⁴ times (`watch_outputs_toggle` of benchmarks/cliffs.py).

Equality is tested by: tests/fast/test_loop_switches.py, with generated loops.

If variables and outputs are the same after some iterations as before them, these iterations repeat until one of
their readings changes. There may be several: OUTX(1) = Not OUTX(1) has a period of two. The changes of the outputs are
in the log: those of one period become a template (`log/repeated.py`). This is done only for the sole running task, in
a loop that never waits, whose times all count from one base.
"""

from __future__ import annotations

from motionlang.controller.clock import INFINITY
from motionlang.fast.loop_counters import counted
from motionlang.log.repeated import rows_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.mint.runtime.environment import Environment
    from motionlang.mint.runtime.loop_skipping import Counters, Start, State

# Periods of more iterations, or with more changes, are not found.
MAX_PERIOD, MAX_ROWS = 8, 64


class LoopSwitches:
    """The latest iterations of one loop that switches outputs, up to `MAX_PERIOD`.

    For each it stores the outputs and the lengths of the log at its beginning.
    """

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._begun: list[tuple[Start, int, tuple[tuple[int, float], ...], list[int]]] = []

    def restart(self) -> None:
        """Discard all iterations."""
        self._begun.clear()

    def begin(self, start: Start, follows: bool) -> None:
        """Record the start of an iteration; `follows` is true if it succeeds the last one."""
        environment = self._environment
        alone = self._is_alone()
        if not (follows and alone) or len(self._begun) >= MAX_PERIOD:
            self._begun.clear()
        if not alone:
            return
        lengths = list(map(len, environment.machine.log.streams()))
        values = environment.controller.outputs.values
        self._begun.append((start, environment.switches, values, lengths))

    def skip(
        self,
        t: float,
        start: Start,
        state: State,
        counters: Counters,
        levels: Sequence[Sequence[float]],
        carries: bool,
    ) -> tuple[float, float, Counters] | None:
        """Skip repetitions of the iterations before statement `t`.

        None if they may not repeat. If they do, the result is that of `Site.skip` for the end of the last repetition.
        """
        environment, begun = self._environment, self._begun
        if (
            not begun
            or begun[-1][0] is not start
            or environment.controller.outputs.listeners
            or environment.statements.base != start[3]
            or environment.resumed != start[5]
            or not self._is_alone()
        ):
            return None
        for begin, switches, outputs, lengths in reversed(begun):
            before = begin[0]
            if environment.acts - before[0] != environment.switches - switches:  # type: ignore[operator]
                return None
            if before[1:] == state[1:] and outputs == environment.controller.outputs.values:
                return self._repeated(t, begin, lengths, counters, levels, carries)
        if len(begun) == MAX_PERIOD:
            return None
        statements = environment.statements
        return t, statements.limit(statements.until), counters

    def _is_alone(self) -> bool:
        """True if no other task or handler can run before this one waits."""
        scheduler = self._environment.machine.scheduler
        assert scheduler is not None
        return len(scheduler.tasks) == 1 and not scheduler.interrupts and scheduler.by_itself

    def _repeated(
        self,
        t: float,
        start: Start,
        lengths: list[int],
        counters: Counters,
        levels: Sequence[Sequence[float]],
        carries: bool,
    ) -> tuple[float, float, Counters] | None:
        """Skip repetitions of the period from `start` to statement `t`; None if none fits."""
        environment = self._environment
        statements, log = environment.statements, environment.machine.log
        _, began_with, since, base, began, _, notes, first = start
        rows = None
        for stream, length in zip(log.streams(), lengths, strict=True):
            if stream is log.outputs:
                rows = rows_of(stream[length:], 0, base, statements.cost)
            elif len(stream) != length:
                return None
        until = min(statements.until, environment.dependencies.stable_until(notes, first, began))
        if not rows or len(rows) > MAX_ROWS or until <= statements.at(t) or until == INFINITY:
            return None
        steps = [n - m for n, m in zip(counters, began_with, strict=True)]
        most = counted(counters, steps, levels) if any(steps) else INFINITY
        times = int(min(statements.periods(base, since, t, until) - carries, most))
        if times > 0:
            lasts = t - since
            again = [(tick, tuple([n + lasts for n in counts]), rest) for tick, counts, rest in rows]
            log.outputs.repeat((again, times, 0, lasts), (base, 0, 0.0, statements.cost))
            statements.leave(t)
            t = statements.repeat(base, since, times)
            counters = tuple([n + times * step for n, step in zip(counters, steps, strict=True)])
        self._begun.clear()
        return t, statements.limit(statements.until), counters
