"""The waits of a Mint program; a wait yields only if another task acts meanwhile.

If no other task acts, the time passes within the statement.
"""

from __future__ import annotations

from sys import _getframe

from motionlang.controller.clock import INFINITY
from motionlang.controller.faults import Rejected
from motionlang.lang.statement_time import EXACT, UNITS, units
from motionlang.lang.waits import Condition, Delay, Wait, next_tick

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from motionlang.controller.clock import Clock
    from motionlang.controller.controller import Controller
    from motionlang.lang.dependencies import Dependencies
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.statement_time import StatementTime
    from motionlang.mint.runtime.errors import Errors
    from motionlang.mint.runtime.task import MintTask

    # The statement after a wait that is over, and its horizon, or None if the task gives way.
    Continuation = tuple[float, float] | None
    Resting = Callable[..., Continuation]
    # The common data of all records of a source offset: task, offset, callers, and the time of a statement.
    Site = tuple[str, int, tuple[int, ...], float]

# More seconds than rounding can cause.
MIN_WAIT = 1e-9
# After this many waits, check if some can be packed. Python caches integers of that size.
MANY = 256
# The statement after a wait, and its horizon, if nothing else will happen.
UNBOUNDED = 0.0, INFINITY
NAN = INFINITY - INFINITY
# The milliseconds of the longest wait that is computed in whole units. The seconds of a longer one may round
# to another unit.
MAX_WAIT = 1e6


class Waits:
    """The waits that `Environment` offers; `at` is the source offset of a statement."""

    acts: int
    dependencies: Dependencies
    clock: Clock
    fired: int
    machine: Machine
    settled: Callable[[int], bool] | None
    statements: StatementTime
    task: MintTask
    wait: Wait
    _ends: dict[tuple[int, ...], Callable[[], float]]
    _rests: Rests | None
    # The errors, if the program has a handler or reads them: they belong to no waiting statement.
    _errors: Errors | None
    _waited: Callable[[tuple[object, ...]], None]

    if TYPE_CHECKING:

        @property
        def controller(self) -> Controller: ...

    def rest_at(self, at: int, milliseconds: float | None, own: bool) -> Resting:
        """Return the function for a WAIT at a source offset.

        It returns the statement after the wait and its horizon. If the task must yield, it sets `wait` and returns
        None. `milliseconds` is the length if it is a literal; otherwise the length is an argument of the function.
        `own` is true if the statement is in the body of a task itself, and so has no callers.
        """
        if self._rests is None:
            self._rests = Rests(self)
        return self._rests.rest_at(at, milliseconds, own)

    def tick(self, t: float) -> Wait:
        """Return the wait for the next tick of the profiler."""
        self.acts += 1
        now = self.statements.leave(t)
        return Delay(self.clock, now, next_tick(now))

    def space_wait(self, t: float, axes: tuple[int, ...]) -> Wait:
        """Return the wait of a move until the buffers of all its axes have space."""
        room = self.controller.room
        names = ", ".join(map(str, axes))
        buffers = f"move buffers of axes {names}" if len(axes) > 1 else f"move buffer of axis {names}"
        self.controller.log.note(self.clock.now, "buffer full", axes[0], text=f"space in the {buffers}")
        return Wait(
            self.statements.leave(t),
            lambda: all(room(axis) > 0 for axis in axes),
            lambda: INFINITY,
            f"for space in the {buffers}",
            "axis",
            axes,
        )

    @property
    def pause(self) -> Callable[..., tuple[float, float] | None]:
        """The function for PAUSE.

        It returns the statement after the wait and its horizon. If another task acts in the meantime, it sets `wait`
        and returns None.
        """
        environment, machine, statements, ends = self, self.machine, self.statements, self._ends
        cost, waited = statements.cost, self._waited

        def pause(
            t: float,
            ready: Callable[[], object],
            why: str,
            at: int,
            axes: tuple[int, ...] = (),
            ignores_data: bool = False,
        ) -> tuple[float, float] | None:
            """Wait for a condition.

            `axes` are given if the condition only tests that these are at rest. `ignores_data`: no data of the program
            can end the wait.
            """
            environment.acts += 1
            task, scheduler = environment.task, machine.scheduler
            statements.count = t
            statements.reached = since = statements.base + t * cost
            callers = () if _getframe(1) is task.frame else task.callers()
            noted = environment._errors is not None
            if axes and environment.settled is None and scheduler is not None and not noted:
                end = ends.get(axes) or environment.end_of_moves(axes)
                if len(scheduler.tasks) > 1:
                    moment = end()
                    if moment < scheduler.next_slice:
                        reach = scheduler.passes_among_others(since, moment, True)
                        if reach:
                            waited((task.name, at, since, moment, "condition", (), why, callers))
                            task.noticed(environment)
                            return statements.go_on(moment, reach)
                    environment.wait = Rest(environment, since, end, ready, why, (at, callers))
                    return None
                if scheduler.comes_to_rest(since, end):
                    return environment._log_passed(since, "condition", why, at, callers)
            environment.wait = wait = environment._condition(ready, since, why, ignores_data or bool(axes))
            if noted or scheduler is None or not scheduler.passes(wait):
                return None
            return environment._log_passed(wait.since, wait.cause, why, at, callers)

        return pause

    def end_of_moves(self, axes: tuple[int, ...]) -> Callable[[], float]:
        """Return a cached function that computes when the axes will be at rest."""
        found = self._ends[axes] = self.controller.end_of_moves(axes)
        return found

    def _condition(
        self, ready: Callable[[], object], since: float, why: str, ignores_data: bool
    ) -> Condition:
        """Return the wait of the running task for a condition."""
        task = self.task

        def test() -> object:
            self.task = task  # the condition may read the TIME of this task
            return ready()

        return Condition(self.dependencies, test, since, why, ignores_data)

    def _log_passed(
        self, since: float, cause: str, why: str, at: int, callers: tuple[int, ...]
    ) -> tuple[float, float]:
        """Log a wait during which the task did not yield.

        Returns the next statement and its horizon.
        """
        clock, statements, task, scheduler = self.clock, self.statements, self.task, self.machine.scheduler
        assert scheduler is not None
        now, horizon = clock.now, clock.horizon
        self._waited((task.name, at, since, now, cause, (), why, callers))
        if self.fired != clock.fired:
            task.noticed(self)
        t = statements.count
        if now != statements.reached:
            statements.base = now
            t = 0.0
        return t, statements.limit(horizon if horizon < scheduler.until else scheduler.until)


class Rests:
    """Makes the functions of WAIT statements.

    If nothing can happen in the meantime, such a function only adds the time and logs the wait. All of
    them share the end of the last wait, in seconds (`known`) and in whole units (`known_units`).
    """

    __slots__ = ("_cost_units", "_environment", "_left", "_tail", "known", "known_units")

    def __init__(self, environment: Waits) -> None:
        self._environment = environment
        self._tail: list[Any] = environment.machine.log.waits.tail
        self._cost_units = _whole(environment.statements.cost * UNITS)
        self.known, self.known_units = -1.0, 0.0
        # The number of waits of computed length until some are packed.
        self._left = MANY

    def rest_at(self, at: int, milliseconds: float | None, own: bool) -> Resting:
        """Return the function for a WAIT; see `Waits.rest_at`."""
        if (
            own
            and milliseconds is not None
            and milliseconds / 1000.0 >= MIN_WAIT
            and milliseconds <= MAX_WAIT
        ):
            wait_units = _whole(milliseconds * (UNITS / 1000.0))
            if wait_units and self._cost_units:
                return self._literal(at, self._cost_units, wait_units)
        return self._computed(at, milliseconds, own)

    def _literal(self, at: int, cost_units: float, wait_units: float) -> Resting:
        """Return the function for a WAIT with a literal length.

        All its times are whole units, which are exact as floats.
        """
        environment = self._environment
        clock = environment.clock
        statements = environment.statements
        waits, tail, cost = environment.machine.log.waits, self._tail, statements.cost
        site: Site | None = None
        units_here = NAN  # until its task is known
        # The time of the next check if some can be packed, at the earliest after this many of these waits.
        next_check, seldom = 0.0, MANY * wait_units / UNITS

        def rest(t: float) -> Continuation:
            nonlocal next_check, site, units_here
            base = statements.base
            if base is not self.known:
                self.known, self.known_units = base, _units(base)
            end_units = self.known_units + t * cost_units + units_here
            end = end_units / UNITS
            if end < statements.free:
                tail.append((site, base, t, end))
                statements.base = self.known = clock.now = end
                self.known_units = end_units
                if end > next_check:
                    next_check = end + seldom
                    waits.trim()
                until = statements.until
                return UNBOUNDED if until == INFINITY else (0.0, (until - end) / cost - 1.0)
            if site is None:
                site, units_here = (environment.task.name, at, (), cost), wait_units
                return rest(t)
            if end_units < EXACT:
                return self._pass_among_others(t, site, end, end_units)
            return self._yield_to_others(t, site, (units(base) + int(t * cost_units + wait_units)) / UNITS)

        return rest

    def _computed(self, at: int, given: float | None, own: bool) -> Resting:
        """Return the function for a WAIT of any length, in a task or in a sub."""
        environment = self._environment
        clock = environment.clock
        statements = environment.statements
        waits, tail, cost = environment.machine.log.waits, self._tail, statements.cost
        site: Site | None = None

        def rest(t: float, milliseconds: float = given or 0.0) -> Continuation:
            nonlocal site
            base = statements.base
            if base is not self.known:
                self.known, self.known_units = base, _units(base)
            seconds = milliseconds / 1000.0
            # Rounded as a float is when it has no digits left after the point.
            end_units = self.known_units + ((t * cost + seconds) * UNITS + EXACT - EXACT)
            task = environment.task
            callers = () if own or _getframe(1) is task.frame else task.callers()
            if site is None or site[2] != callers or site[0] is not task.name:
                site = task.name, at, callers, cost
            if seconds >= MIN_WAIT:
                end = end_units / UNITS
                if end < statements.free:
                    tail.append((site, base, t, end))
                    statements.base = self.known = clock.now = end
                    self.known_units = end_units
                    self._left -= 1
                    if not self._left:
                        self._left = MANY
                        waits.trim()
                    until = statements.until
                    return UNBOUNDED if until == INFINITY else (0.0, (until - end) / cost - 1.0)
                if end_units < EXACT:
                    return self._pass_among_others(t, site, end, end_units)
            if not 0 <= milliseconds < INFINITY:
                raise Rejected("range", f"WAIT cannot be {milliseconds:.10g}", "a wait lasts 0 ms or longer")
            # Too late for whole units to be distinct floats, or too short.
            return self._yield_to_others(t, site, (units(base) + round((t * cost + seconds) * UNITS)) / UNITS)

        return rest

    def _pass_among_others(self, t: float, site: Site, end: float, end_units: float) -> Continuation:
        """Let other tasks act; continue within the statement if this task acts next."""
        environment = self._environment
        statements, task, scheduler = environment.statements, environment.task, environment.machine.scheduler
        if scheduler is not None and end < scheduler.next_slice and task.poll_check is None:
            base = statements.base
            reach = scheduler.passes_among_others(base + t * statements.cost, end, False)
            if reach:
                environment.machine.log.waits.add((site, base, t, end))
                self.known, self.known_units = end, end_units
                return statements.go_on(end, reach)
        return self._yield_to_others(t, site, end)

    def _yield_to_others(self, t: float, site: Site, end: float) -> Continuation:
        """Let events happen within the statement, or yield to other tasks."""
        environment = self._environment
        statements = environment.statements
        clock = environment.clock
        scheduler = environment.machine.scheduler
        since = statements.base + t * statements.cost
        statements.count, statements.reached = t, since
        task, (_, at, callers, _) = environment.task, site
        wait = task.delay
        if wait is None:
            task.delay = wait = Delay(clock, since, end, (at, callers))
        else:
            wait.since, wait.ends, wait.location = since, end, (at, callers)
        environment.wait = wait
        if scheduler is None or not statements.alone or environment._errors is not None:
            return None
        return (
            environment._log_passed(wait.since, "time", "", at, callers) if scheduler.passes(wait) else None
        )


def _units(moment: float) -> float:
    """Return a time in whole units, as a float that is exact up to `EXACT`."""
    nearest = moment * UNITS + EXACT - EXACT
    return nearest if nearest / UNITS == moment else float(units(moment))


def _whole(amount: float) -> float:
    """Return an amount of units if it is an integer up to rounding, else 0."""
    nearest = float(round(amount))
    return nearest if abs(amount - nearest) < 1e-6 else 0.0


class Rest(Wait):
    """A wait until axes are at rest, which events report.

    If the program also requires settled axes, the condition is tested instead.
    """

    __slots__ = ("_built", "_end", "_environment", "_test", "location")

    cause = "condition"
    what = ()
    ends = None
    ignores_data = True

    def __init__(
        self,
        environment: Waits,
        since: float,
        end: Callable[[], float],
        test: Callable[[], object],
        why: str,
        location: tuple[int, tuple[int, ...]],
    ) -> None:
        self.since, self.why, self._environment, self._test = since, why, environment, test
        self.location, self._end = location, end
        self._built: Wait | None = None

    def ready(self) -> bool:
        if self._environment.settled is not None:
            return self._condition().ready()
        return self._end() < 0.0

    def due(self) -> float:
        return INFINITY if self._environment.settled is None else self._condition().due()

    def expected(self) -> float:
        return self._end() if self._environment.settled is None else -1.0

    def _condition(self) -> Wait:
        if self._built is None:
            self._built = Condition(self._environment.dependencies, self._test, self.since, self.why)
        return self._built
