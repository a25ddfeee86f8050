"""Polling loops that switch outputs and leave them as they were.

Replaces: running every iteration of such a loop, as OUTX(1) = 1 : OUTX(1) = 0 is.

Hook: `Accelerators.switches`; `Site.turn` of mint/runtime/loop_skipping.py calls `skip` if an iteration has only
switched outputs.

Gain: 10³ to 10⁴ times (`watch_outputs_toggle` of benchmarks/cliffs.py).

Held equal by: tests/fast/test_loop_switches.py, with generated loops.

An iteration after which variables and outputs are as before it repeats until one of its readings changes, like one
that does nothing. The changes of the outputs are in the log: those of one iteration become a template
(`log/repeated.py`). This is done for a task that has the machine for itself, in a loop that never waits, whose times
all count from one base.
"""

from __future__ import annotations

from motionlang.fast.loop_counters import counted
from motionlang.lang.task import INFINITY
from motionlang.log.repeated import rows_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.mint.runtime.environment import Environment
    from motionlang.mint.runtime.loop_skipping import Counters, Look, State

# An iteration with more changes is not skipped.
MAX_ROWS = 64


class LoopSwitches:
    """The outputs and the log at the beginning of an iteration of one loop."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._look: Look | None = None
        self._switches = 0
        self._outputs: tuple[tuple[int, float], ...] = ()
        self._lengths: list[int] = []

    def begin(self, look: Look) -> None:
        """Record the outputs and the lengths of the log as an iteration begins."""
        environment = self._environment
        self._look, self._switches = look, environment.switches
        self._outputs = environment.controller.outputs.values
        self._lengths = list(map(len, environment.machine.log.streams()))

    def skip(
        self,
        t: float,
        look: Look,
        state: State,
        counters: Counters,
        levels: Sequence[Sequence[float]],
        carries: bool,
    ) -> tuple[float, float, Counters] | None:
        """Skip iterations like that before statement `t`; None if it may not repeat.

        Returns the end of the last of them like `Site.skip`.
        """
        environment = self._environment
        statements, scheduler = environment.statements, environment.machine.scheduler
        before, began_with, since, base, began, others, notes, first = look
        assert scheduler is not None
        assert before is not None
        log, outputs = environment.machine.log, environment.controller.outputs
        if (
            self._look is not look
            or before[1:] != state[1:]
            or environment.acts - before[0] != environment.switches - self._switches  # type: ignore[operator]
            or outputs.values != self._outputs
            or outputs.listeners
            or statements.base != base
            or environment.resumed != others
            or len(scheduler.tasks) > 1
            or scheduler.interrupts
            or not scheduler.by_itself
        ):
            return None
        rows = None
        for stream, length in zip(log.streams(), self._lengths, strict=True):
            if stream is log.outputs:
                rows = rows_of(stream[length:], 0, base, statements.cost)
            elif len(stream) != length:
                return None
        until = min(statements.until, environment.dependencies.held(notes, first, began))
        if not rows or len(rows) > MAX_ROWS or until <= statements.at(t) or until == INFINITY:
            return None
        steps = [n - m for n, m in zip(counters, began_with, strict=True)]
        most = counted(counters, steps, levels) if any(steps) else INFINITY
        times = int(min(statements.periods(base, since, t, until) - carries, most))
        if times > 0:
            length = t - since
            again = [(tick, tuple([n + length for n in counts]), rest) for tick, counts, rest in rows]
            log.outputs.repeat((again, times, 0, length), (base, 0, 0.0, statements.cost))
            statements.leave(t)
            t = statements.repeat(base, since, times)
            counters = tuple([n + times * step for n, step in zip(counters, steps, strict=True)])
        return t, statements.limit(statements.until), counters
