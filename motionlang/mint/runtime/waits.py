"""The waits of a Mint program: where nobody else acts meanwhile they pass under their statement."""

from __future__ import annotations

from sys import _getframe

from motionlang.controller.faults import Refusal
from motionlang.lang.attention import Condition, next_tick
from motionlang.lang.task import Delay, Wait

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Mapping

    from motionlang.controller.clock import Clock
    from motionlang.controller.controller import Controller
    from motionlang.lang.attention import Attention
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.statement_time import StatementTime
    from motionlang.mint.runtime.environment import Environment
    from motionlang.mint.runtime.errors import Errors
    from motionlang.mint.runtime.task import MintTask

INFINITY = float("inf")


class Waits:
    """What `Environment` offers statements that wait; a statement stands at a place `at` of the program."""

    acts: int
    attention: Attention
    blocks: Mapping[str, object]
    clock: Clock
    fired: int
    machine: Machine
    settled: Callable[[int], bool] | None
    statements: StatementTime
    task: MintTask
    wait: Wait
    _errors: Errors | None
    _waited: Callable[[tuple[object, ...]], None]

    if TYPE_CHECKING:

        @property
        def controller(self) -> Controller: ...

    @property
    def rest(self) -> Callable[[float, float, int], tuple[float, float] | None]:
        """`WAIT` at a place: the statement after it, and its horizon; nothing where others act meanwhile: `wait`."""
        machine, clock, statements, waited = self.machine, self.clock, self.statements, self._waited
        cost, pass_by = statements.cost, statements.pass_by

        def rest(t: float, milliseconds: float, at: int) -> tuple[float, float] | None:
            if not 0 <= milliseconds < INFINITY:
                raise Refusal("range", f"WAIT cannot be {milliseconds:g}", "a wait lasts 0 ms or longer")
            scheduler = machine.scheduler
            alone = scheduler is not None and scheduler.by_itself and len(scheduler.tasks) == 1
            if alone:
                since = statements.base + t * cost
                found = pass_by(t, milliseconds / 1000.0)
                if found is not None:
                    clock.now = end = statements.base
                    task = self.task
                    callers = () if _getframe(2).f_code is task.resumes else task.callers()
                    waited((task.name, at, since, end, "time", (), "", callers))
                    return found
            end = statements.rest(t, milliseconds / 1000.0)
            task = self.task
            callers = () if _getframe(2).f_code is task.resumes else task.callers()
            wait = self.wait = Delay(clock, statements.reached, end, (at, callers))
            if alone and not self._notes_errors and scheduler.passes(wait):  # type: ignore[union-attr]
                return self._gone_on(wait.since, "time", "", at)
            return None

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

    def pause(
        self, t: float, ready: Callable[[], object], why: str, at: int, axes: tuple[int, ...] = ()
    ) -> tuple[float, float] | None:
        """`PAUSE` at a place: as `rest`; nothing where another task acts meanwhile: `wait`.

        `axes` are those of a condition that asks for nothing but that they are at rest.
        """
        self.acts += 1
        task, scheduler = self.task, self.machine.scheduler
        noted, statements = self._notes_errors, self.statements
        statements.count = t
        statements.reached = since = statements.base + t * statements.cost
        if axes and self.settled is None and scheduler is not None and not noted:
            if len(scheduler.tasks) > 1:
                callers = () if _getframe(2).f_code is task.resumes else task.callers()
                self.wait = Rest(self, since, axes, ready, why, (at, callers))
                return None
            if scheduler.comes_to_rest(since, self.controller, axes):
                return self._gone_on(since, "condition", why, at)

        def test() -> object:
            self.task = task  # whose TIME the condition may read
            return ready()

        wait = self.wait = Condition(self.attention, test, since, why)
        if noted:
            return None  # what goes wrong meanwhile is not this statement's
        if scheduler is None or not scheduler.passes(wait):
            return None
        return self._gone_on(wait.since, wait.cause, why, at)

    @property
    def _notes_errors(self) -> bool:
        """Whether what goes wrong meanwhile is noted by the program, as not that of the statement that waits."""
        return self._errors is not None or "event onerror" in self.blocks

    def _gone_on(self, since: float, cause: str, why: str, at: int) -> tuple[float, float]:
        """A wait is over that passed under the statement at a place: the next one, and its horizon."""
        clock, statements, task, scheduler = self.clock, self.statements, self.task, self.machine.scheduler
        assert scheduler is not None
        now, horizon = clock.now, clock.horizon
        self._waited((task.name, at, since, now, cause, (), why, task.callers(3)))
        if self.fired != clock.fired:
            task.noticed(self)
        t = statements.count
        if now != statements.reached:
            statements.base = now
            t = 0.0
        return t, statements.limit(horizon if horizon < scheduler.until else scheduler.until)


class Rest(Wait):
    """The wait until axes are at rest, of which events tell; where the program wants them settled, too, it is asked."""

    __slots__ = ("_asked", "_axes", "_end_of_moves", "_environment", "_test", "place")

    cause = "condition"
    what = ()
    ends = None

    def __init__(
        self,
        environment: Waits,
        since: float,
        axes: tuple[int, ...],
        test: Callable[[], object],
        why: str,
        place: tuple[int, tuple[int, ...]],
    ) -> None:
        self.since, self.why, self._environment, self._axes, self._test = since, why, environment, axes, test
        self.place = place
        self._end_of_moves = environment.controller.end_of_moves
        self._asked: Wait | None = None

    def ready(self) -> bool:
        environment = self._environment
        if environment.settled is not None:
            return self._condition().ready()
        return environment.controller.end_of_moves(self._axes) < 0.0

    def due(self) -> float:
        return INFINITY if self._environment.settled is None else self._condition().due()

    def expected(self) -> float:
        return self._end_of_moves(self._axes) if self._environment.settled is None else -1.0

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
