"""The waits of a Mint program: where nobody else acts meanwhile they pass under their statement."""

from __future__ import annotations

from sys import _getframe

from motionlang.controller.faults import Refusal
from motionlang.lang.attention import Condition, next_tick
from motionlang.lang.statement_time import EXACT, UNITS, units
from motionlang.lang.task import Delay, Wait

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Generator
    from typing import Any

    from motionlang.controller.clock import Clock
    from motionlang.controller.controller import Controller
    from motionlang.lang.attention import Attention
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.statement_time import StatementTime
    from motionlang.mint.runtime.environment import Environment
    from motionlang.mint.runtime.errors import Errors
    from motionlang.mint.runtime.task import MintTask

INFINITY = float("inf")
# Seconds that are more than rounding.
SHORTEST = 1e-9
# After so many waits it is looked whether some are to be packed.
MANY = 1024


class Waits:
    """What `Environment` offers statements that wait; a statement stands at a place `at` of the program."""

    acts: int
    attention: Attention
    clock: Clock
    fired: int
    machine: Machine
    settled: Callable[[int], bool] | None
    statements: StatementTime
    task: MintTask
    wait: Wait
    _ends: dict[tuple[int, ...], Callable[[], float]]
    # Where the program notes what goes wrong, as it has a handler for it or asks: that is no statement's that waits.
    _errors: Errors | None
    _waited: Callable[[tuple[object, ...]], None]

    if TYPE_CHECKING:

        @property
        def controller(self) -> Controller: ...

    @property
    def rest(self) -> Callable[[float, float, int], tuple[float, float] | None]:
        """`WAIT` at a place: the statement after it, and its horizon; nothing where others act meanwhile: `wait`.

        Where nothing can happen meanwhile the time is added and the wait written down, which is all there is to it.
        """
        environment, machine, clock, statements = self, self.machine, self.clock, self.statements
        waits, cost = machine.log.waits, statements.cost
        append: Callable[[Any], object] = waits.append
        # The end of the last wait, and what that is in whole units; how many more are written until some are packed.
        known, known_units, left = 0.0, 0.0, MANY

        def rest(t: float, milliseconds: float, at: int) -> tuple[float, float] | None:
            nonlocal known, known_units, left
            base, passed, seconds = statements.base, t * cost, milliseconds / 1000.0
            if base != known:
                known, known_units = base, float(units(base))
            # As a float is rounded where it has no places left behind the point.
            end_units = known_units + ((passed + seconds) * UNITS + EXACT - EXACT)
            end, task = end_units / UNITS, environment.task
            callers = () if _getframe(1) is task.frame else task.callers()
            scheduler = machine.scheduler
            if end_units < EXACT and seconds >= SHORTEST and scheduler is not None:
                if not scheduler.several:
                    horizon = (statements.until - end) / cost - 1.0  # one less, whatever rounding makes of it
                    if horizon >= 1.0:
                        append((task.name, at, base + passed, end, "time", (), "", callers))
                        statements.base = known = clock.now = end
                        known_units = end_units
                        left -= 1
                        if not left:
                            left = MANY
                            waits.trim()
                        return 0.0, horizon
                elif end < scheduler.next_turn and task.look is None and task.in_vain is None:
                    reach = scheduler.passes_in_turn(base + passed, end, False)
                    if reach:
                        waits.add((task.name, at, base + passed, end, "time", (), "", callers))
                        known, known_units = end, end_units
                        return statements.go_on(end, reach)
            elif not 0 <= milliseconds < INFINITY:
                raise Refusal("range", f"WAIT cannot be {milliseconds:g}", "a wait lasts 0 ms or longer")
            else:  # so late that whole units are no floats of their own, or so short
                end = (units(base) + round((passed + seconds) * UNITS)) / UNITS
            statements.count, statements.reached = t, base + passed
            wait = task.delay
            if wait is None:
                task.delay = wait = Delay(clock, base + passed, end, (at, callers))
            else:
                wait.since, wait.ends, wait.place = base + passed, end, (at, callers)
            environment.wait = wait
            if scheduler is None or scheduler.several or environment._errors is not None:
                return None
            return (
                environment._gone_on(wait.since, "time", "", at, callers) if scheduler.passes(wait) else None
            )

        return rest

    def tick(self, t: float) -> Wait:
        """Wait for the next tick of the profiler."""
        self.acts += 1
        now = self.statements.leave(t)
        return Delay(self.clock, now, next_tick(now))

    def room(self, t: float, axes: tuple[int, ...]) -> Wait:
        """A move waits for room in the buffers of all its axes."""
        room = self.controller.room
        names = ", ".join(map(str, axes))
        buffers = f"move buffers of axes {names}" if len(axes) > 1 else f"move buffer of axis {names}"
        self.controller.log.note(self.clock.now, "buffer full", axes[0], text=f"room in the {buffers}")
        return Wait(
            self.statements.leave(t),
            lambda: all(room(axis) > 0 for axis in axes),
            lambda: INFINITY,
            f"for room in the {buffers}",
            "axis",
            axes,
        )

    @property
    def pause(self) -> Callable[..., tuple[float, float] | None]:
        """`PAUSE` at a place: as `rest`; nothing where another task acts meanwhile: `wait`."""
        environment, machine, statements, ends = self, self.machine, self.statements, self._ends
        cost, waited = statements.cost, self._waited

        def pause(
            t: float, ready: Callable[[], object], why: str, at: int, axes: tuple[int, ...] = ()
        ) -> tuple[float, float] | None:
            """`axes` are those of a condition that asks for nothing but that they are at rest."""
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
                    if moment < scheduler.next_turn:
                        reach = scheduler.passes_in_turn(since, moment, True)
                        if reach:
                            waited((task.name, at, since, moment, "condition", (), why, callers))
                            task.noticed(environment)
                            return statements.go_on(moment, reach)
                    environment.wait = Rest(environment, since, end, ready, why, (at, callers))
                    return None
                if scheduler.comes_to_rest(since, end):
                    return environment._gone_on(since, "condition", why, at, callers)
            environment.wait = wait = environment._condition(ready, since, why)
            if noted or scheduler is None or not scheduler.passes(wait):
                return None
            return environment._gone_on(wait.since, wait.cause, why, at, callers)

        return pause

    def end_of_moves(self, axes: tuple[int, ...]) -> Callable[[], float]:
        """The reader of when axes will be at rest, which is kept."""
        found = self._ends[axes] = self.controller.end_of_moves(axes)
        return found

    def _condition(self, ready: Callable[[], object], since: float, why: str) -> Wait:
        """The wait of the running task for a condition."""
        task = self.task

        def test() -> object:
            self.task = task  # whose TIME the condition may read
            return ready()

        return Condition(self.attention, test, since, why)

    def _gone_on(
        self, since: float, cause: str, why: str, at: int, callers: tuple[int, ...]
    ) -> tuple[float, float]:
        """A wait is over that passed under the statement at a place: the next one, and its horizon."""
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


class Rest(Wait):
    """The wait until axes are at rest, of which events tell; where the program wants them settled, too, it is asked."""

    __slots__ = ("_asked", "_end", "_environment", "_test", "place")

    cause = "condition"
    what = ()
    ends = None

    def __init__(
        self,
        environment: Waits,
        since: float,
        end: Callable[[], float],
        test: Callable[[], object],
        why: str,
        place: tuple[int, tuple[int, ...]],
    ) -> None:
        self.since, self.why, self._environment, self._test = since, why, environment, test
        self.place, self._end = place, end
        self._asked: Wait | None = None

    def ready(self) -> bool:
        if self._environment.settled is not None:
            return self._condition().ready()
        return self._end() < 0.0

    def due(self) -> float:
        return INFINITY if self._environment.settled is None else self._condition().due()

    def expected(self) -> float:
        return self._end() if self._environment.settled is None else -1.0

    def _condition(self) -> Wait:
        if self._asked is None:
            self._asked = Condition(self._environment.attention, self._test, self.since, self.why)
        return self._asked


class Refused:
    """What has become of a move behind `H = load(…) or (yield from refused)`: it answers with the horizon.

    No move was refused where the horizon is 0.
    """

    __slots__ = ("_environment",)

    def __init__(self, environment: Environment) -> None:
        self._environment = environment

    def __iter__(self) -> Generator[Wait, tuple[float, float], float]:
        environment = self._environment
        if environment._refused is None:
            return 0.0
        assert environment.time_cells is not None
        _, horizon = yield from environment.load(environment.time_cells[0].cell_contents)
        return horizon
