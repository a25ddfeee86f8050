"""Skip iterations of polling loops at run time, many at once if all are the same.

An iteration that did nothing and left every variable unchanged repeats until something happens: the next
event, or the time at which one of its readings changes by itself. All whole iterations that fit before
that are paid for at once. While other tasks can run, the skip ends with the task's time slice. If no other
task can run, and the task has done nothing since that might let one continue, it extends to the time at which the
first of them may continue.

Exponential back-off: after a failed check the loop runs unchecked for 1, 2, 4, … iterations. Its readings
record no dependencies in that time.
"""

from __future__ import annotations

from motionlang.controller.clock import INFINITY
from motionlang.controller.faults import Rejected

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from motionlang.lang.dependencies import Note
    from motionlang.mint.runtime.environment import Environment

    State = tuple[object, ...]
    Counters = tuple[float, ...]
    # The start of an iteration: the state left by the one before, the counters, its statement, the base of
    # these, its time, the number of times that others had run, the dependencies, and how many of them there
    # were.
    Start = tuple[State, Counters, float, float, float, int, list[Note], int]
    # The statement and horizon at which the loop continues, the start of that iteration, the number of
    # unchecked iterations (or the statement up to which they run), and the counters.
    Checked = tuple[float, float, Start | None, float, Counters]

# The maximum number of unchecked iterations, more if arrays must be compared. They are counted in floats
# because Python caches no integers of that size.
MAX_BACK_OFF = 4096.0
# A loop with longer iterations, s, monitors or displays something, and may go on without a change.
WATCH = 0.03
# The number of statements assumed for an iteration if iterations are not counted.
STATEMENTS = 4.0


class Site:
    """A loop of the program text.

    - `reads`: the loop has readings, and `read_names` names them.
    - `carries`: the last of the skipped iterations must be executed.
    - `alters`: an iteration may write host memory, or may change a variable that other tasks wait for and restore it.
    - `levels`: the constants that each counter is compared with.
    - `left`: the number of iterations still to run unchecked, in a loop that counts iterations.
    - `due`: the statement up to which iterations run unchecked, in any other loop.

    `_switches` is the accelerator for iterations that switch outputs, and `_switching` the number of successive
    iterations that have done nothing else. It records iterations from the second of them on, because many loops
    switch an output once, when a reading passes a level. `_switched_before` is the number of switched outputs at
    the start of an iteration. `_level` is the time at which a reading may change, as last solved: the iteration in
    which it lies is not skipped.
    """

    def __init__(
        self,
        environment: Environment,
        reads: bool,
        carries: bool,
        alters: bool,
        read_names: str = "",
        levels: Sequence[Sequence[float]] = (),
    ) -> None:
        self._environment, self.reads, self.carries, self.alters = environment, reads, carries, alters
        self.read_names, self._levels = read_names, levels
        self._switches: Any = None
        self._switching = self._switched_before = 0
        self._level = -INFINITY
        self.left = self._due = 0.0
        self._statements = environment.statements
        self._base = self._statements.base

    @property
    def due(self) -> float:
        """The statement of the next check; 0 if the count of statements was restarted."""
        return self._due if self._statements.base is self._base else 0.0

    def check_at(
        self, t: float, horizon: float, start: Start | None, state: State, counters: Counters
    ) -> Checked:
        """Check an iteration like `check`, but return the statement of the next check."""
        t, horizon, start, left, counters = self.check(t, horizon, start, state, counters)
        self._due, self._base = t + STATEMENTS * left, self._statements.base
        return t, horizon, start, self._due, counters

    def check(
        self, t: float, horizon: float, start: Start | None, state: State, counters: Counters
    ) -> Checked:
        """Check an iteration that ends at statement `t`, and skip identical ones.

        The loop continues at the end of the last iteration that is certain to be identical. `state` is the state after
        an iteration, with the count of the program's actions first. The variables in `counters` decide nothing.
        """
        dependencies, statements = self._environment.dependencies, self._environment.statements
        if start is not None:
            if start[0] == state:
                self._switching = 0
                found = self.skip(t, horizon, start, state, counters)
            else:
                found = self._switched(t, horizon, start, state, counters)
            if found is None:
                self._switching = 0
                self._environment.task.poll_check = None
                left, self.left = self.left, 2.0 * self.left or 1.0
                if self.left > MAX_BACK_OFF:
                    elements = sum([len(each) for each in state if isinstance(each, tuple)])
                    self.left = min(self.left, MAX_BACK_OFF + 4 * elements)
                if left and not self._environment.machine.scheduler.is_observed:  # type: ignore[union-attr]
                    dependencies.rest()
                    return t, horizon, None, left, counters
            else:
                self.left = 0.0
                t, horizon, counters = found
        since = t, statements.base, statements.at(t), self._environment.resumed
        follows = start is not None
        self._switched_before = self._environment.switches
        start = state, counters, *since, *dependencies.begin()
        if self._switching > 1:
            self._switches.begin(start, follows)
        return t, horizon, start, 0.0, counters

    def _switched(
        self, t: float, horizon: float, start: Start, state: State, counters: Counters
    ) -> tuple[float, float, Counters] | None:
        """Skip iterations that only switch outputs, if there is an accelerator for them."""
        environment = self._environment
        if self._switching > 1:
            return self._switches.skip(t, start, state, counters, self._levels, self.carries)  # type: ignore[no-any-return]
        make = environment.machine.accelerators.switches
        acted = environment.acts - start[0][0]  # type: ignore[operator]
        if make is None or not 0 < acted == environment.switches - self._switched_before:
            return None
        self._switching += 1
        if self._switching > 1:
            if self._switches is None:
                self._switches = make(environment)
            self._switches.restart()
        return t, horizon, counters

    def skip(
        self, t: float, horizon: float, start: Start, state: State, counters: Counters
    ) -> tuple[float, float, Counters] | None:
        """Skip iterations after one that ended at `t` and was identical to the one before.

        Returns the end of the last identical iteration, None if a reading of this one differed.
        An iteration in which other tasks ran is only remembered.
        """
        environment = self._environment
        statements, task = environment.statements, environment.task
        _, before, since, base, began, others, notes, first = start
        scheduler = environment.machine.scheduler
        assert scheduler is not None
        now, level = statements.at(t), self._level
        if not began < level <= now:
            level = self._level = environment.dependencies.stable_until(notes, first, began)
        if level <= now:
            return None
        several = len(scheduler.tasks) > 1
        # Periods of several tasks do not support counters.
        task.poll_check = None if several and self.carries else (environment.acts, self.reads)
        # A loop that counts may end by itself. The length of an iteration in which other tasks were skipped says
        # nothing, so that of an earlier one decides.
        if not self.reads or counters != before or level != INFINITY:
            task.futile = None
        elif now - began <= WATCH:
            task.futile = environment.acts
        task.last_poll = self.read_names
        if several and not self.reads and not scheduler.reach():
            return None  # a loop that only counts is quicker unchecked than skipped slice by slice
        if environment.resumed != others or (scheduler.is_observed and base != statements.base):
            return t, horizon, counters
        until = statements.until
        if several and now < until:
            environment.clock.now = now
            reach = scheduler.reach()
            if not reach and base != statements.base:
                return t, horizon, counters  # another task can run, so it does during the next WAIT
            if until < reach and not self._may_have_woken(began, scheduler):
                until = reach
        until = min(until, level)
        steps: Counters = ()
        most = INFINITY
        if counters != before:
            steps = tuple([n - m for n, m in zip(counters, before, strict=True)])
            counted = environment.machine.accelerators.counted
            if counted is None:
                return None
            most = counted(counters, steps, self._levels)
        if until == most == INFINITY:
            raise Rejected("never", "the loop polls for something that can no longer happen", "")
        environment.task = task  # the conditions of other tasks may have set another running task
        periods = max(0, int(min(statements.periods(base, since, t, until) - self.carries, most)))
        if periods:
            if base != statements.base:
                environment.machine.log.repeat_waits(task.name, began, now - began, periods)
            statements.leave(t)
            t = statements.repeat(base, since, periods)
            horizon = statements.limit(statements.until)
        if steps:
            counters = tuple([n + periods * step for n, step in zip(counters, steps, strict=True)])
        return t, horizon, counters

    def _may_have_woken(self, began: float, scheduler: Any) -> bool:
        """True if a wait of another task may be over since the waits were last checked.

        They are checked as this task is resumed. `began` is the start of the iteration. An output that nothing is
        wired to ends no wait that ignores the data of the program.
        """
        environment, is_first = self._environment, began > scheduler.began
        if is_first and (
            environment.acts - environment.switches != environment.acts_before
            or environment.controller.outputs.listeners
        ):
            return True
        return (is_first or self.alters) and scheduler.is_watched()
