"""A task: code that runs until the horizon, or until it must wait.

Both languages implement this interface for the scheduler. A Mint task is a generator made by the compiler; an
MCCL task is a program counter over a tuple of operations.
"""

from __future__ import annotations

from sys import _getframe

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterable, Sequence
    from types import CodeType, FrameType
    from typing import Any, Protocol

    from motionlang.controller.clock import Clock
    from motionlang.controller.controller import Controller
    from motionlang.lang.dependencies import Dependencies
    from motionlang.lang.machine.machine import Machine

    class Shared(Protocol):
        """The state shared by the tasks of a program."""

        dependencies: Dependencies

        def state(self, alive: dict[int, object]) -> tuple[int, int, bytes]:
            """Return two counters of actions that cannot be compared, and the variables."""


INFINITY = float("inf")
# Times that differ by less than this are equal, so that rounding does not decide the order.
ROUNDING = 1e-9
# This close to a solved time, s, a reading is not relied upon: the solution and the reading are rounded.
CLOSE = 1e-7
# A task that lets more time than this, s, pass between two checks is monitoring or displaying something, and
# is not in a futile poll.
WATCH = 0.03
# The first letter of the names of functions in generated code that are a part of another one.
PART = "q"


class Wait:
    """The wait of a task.

    `since`   the time at which the task began to wait
    `ready()` true if it may continue, checked after every event
    `due()`   the earliest time at which `ready` may become true if nothing else happens (infinite if never)
    `why`     a description, for the report of a wait that never ends
    `cause`   the kind of thing that ends it, and `what` its numbers: one of `record.records.CAUSES`
    `ends`    the time at which it certainly ends, if there is one: then the two functions are not called
    `place`   the source position of its statement and those of the calls that led there, if it knows them
    """

    __slots__ = ("cause", "due", "ends", "ready", "since", "what", "why")

    place: tuple[int, tuple[int, ...]] | None = None
    # True if no variable or memory of the program can end it.
    ignores_data = False

    def __init__(
        self,
        since: float,
        ready: Callable[[], bool],
        due: Callable[[], float],
        why: str,
        cause: str = "condition",
        what: tuple[int, ...] = (),
    ) -> None:
        self.since, self.ready, self.due, self.why = since, ready, due, why
        self.cause, self.what = cause, what
        self.ends: float | None = None

    def expected(self) -> float:
        """Return when it ends if only expected events happen; -1 if not known, or over."""
        return -1.0


class Delay(Wait):
    """A wait for a time; its description is made on demand, as programs have millions."""

    __slots__ = ("_clock", "place")

    cause = "time"
    what = ()
    ends: float
    ignores_data = True

    def __init__(
        self, clock: Clock, since: float, time: float, place: tuple[int, tuple[int, ...]] | None = None
    ) -> None:
        self.since, self._clock, self.ends, self.place = since, clock, time, place

    @property
    def length(self) -> float:
        """Its total duration, s, to a nanosecond."""
        return round(self.ends - self.since, 9)

    def move(self, time: float) -> None:
        """Move its end to another time, and its beginning by the same amount."""
        self.since += time - self.ends
        self.ends = time

    def ready(self) -> bool:
        return self._clock.now >= self.ends - ROUNDING

    def due(self) -> float:
        return self.ends

    @property
    def why(self) -> str:  # type: ignore[override]
        return f"for {self.ends - self.since:g} s"


def wait_until(machine: Controller | Machine, since: float, time: float) -> Wait:
    """Return a wait for a time."""
    return Delay(machine.clock, since, time)


def wait_idle(controller: Controller, since: float, axes: Iterable[int]) -> Wait:
    """A wait until all of `axes` are idle, with nothing released in their buffers.

    A follower is idle when its master is.
    """
    waited = tuple(axes)
    return Wait(
        since,
        lambda: all(controller.is_at_standstill(axis) for axis in waited),
        lambda: max((controller.standstill_time(axis) for axis in waited), default=since),
        until_idle(waited),
        "axis",
        waited,
    )


def until_idle(axes: tuple[int, ...]) -> str:
    """Describe a wait until axes are idle."""
    return f"for axis {', '.join(map(str, axes))} to be idle"


class Task:
    """`resume(now, horizon)` runs from `now`; it returns the time reached and a wait.

    `None` for the wait means that the horizon was reached, or, with `done` set, that the task has ended.
    Source positions ("at") are token numbers, which the dialect's `locate` converts to line and column.

    A task that only polls sets `poll_check`: the number of actions so far, and true if it reads anything.
    `in_vain` is the time since which it has polled for something that could not happen before the end of
    the run, and `last_poll` its last reading, as text.
    """

    __slots__ = (
        "busy",
        "done",
        "in_vain",
        "look",
        "looks_at",
        "name",
        "priority",
        "turn",
        "wait",
    )

    def __init__(self, name: str) -> None:
        self.name = name
        # For how long, of its own running time, no other task can observe it: it computes with its own data.
        self.busy = 0.0
        self.look: tuple[int, bool] | None = None
        self.in_vain: float | None = None
        self.looks_at = ""
        self.priority = 0  # among tasks that can run, the one with the highest priority runs
        self.turn = INFINITY  # the longest that it may run, s, while others can
        self.done = False
        self.wait: Wait | None = None

    @property
    def shared(self) -> Shared | None:
        """The state shared by the tasks of its program; None if that cannot be compared."""
        return None

    def state(self, alive: dict[int, object]) -> bytes | None:
        """Return the state that decides the task's future, without wait and shared state.

        Returns None if it cannot be compared. Objects whose identity is part of the state are added to
        `alive`.
        """
        return None

    @property
    def at(self) -> int:
        """The source position of the task."""
        return 0

    @property
    def stack(self) -> tuple[int, ...]:
        """The source position of the task after those of its callers, outermost first."""
        return (self.at,)

    @property
    def standing(self) -> tuple[int, tuple[int, ...]]:
        """Its source position, and those of the calls that led there."""
        *callers, at = self.stack
        return at, tuple(callers)

    @property
    def loops(self) -> Sequence[tuple[int, float, tuple[int, ...]]]:
        """The loops that the task is in, outermost first.

        Each has its source position, its start in s, and the positions of the calls that led there.
        """
        return ()

    def waited(self, wait: Wait, until: float) -> tuple[object, ...]:
        """Return the record of a completed wait, in the form of `record.records.Waited`."""
        at, callers = wait.place or self.standing
        why = "" if wait.cause == "time" else wait.why
        return self.name, at, wait.since, until, wait.cause, wait.what, why, callers

    @property
    def running(self) -> bool:
        """True if a statement of the task is being executed now."""
        return False

    def at_error(self, error: BaseException) -> int:
        """Return the source position at which `error`, raised by `resume`, occurred."""
        return self.at

    def time_at_error(self, error: BaseException) -> float:
        """Return the task's own time when `error` was raised, s; 0 if it is unknown."""
        return 0.0

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        """Run until `horizon`, s, a wait or the end; return the time and the wait, if any."""
        raise NotImplementedError


if TYPE_CHECKING:
    Steps = Generator[float | Wait | tuple[float, float], tuple[float, float], float]


class GeneratorTask(Task):
    """A task based on a generator, which yields times or `Wait`s and returns a time.

    At the horizon it may yield `(time, busy)` instead of a time, where `busy` is how long no other task can
    observe it. `file` is the file name of the generated code and `offsets[n]` the source position of its line
    `n`.
    """

    __slots__ = ("_calls", "_file", "_generator", "_make", "_places")

    # The code of `resume`, below which there is no further code of a program.
    resumes: CodeType

    def __init__(
        self, name: str, make: Callable[[float, float], Steps], file: str, places: Sequence[int]
    ) -> None:
        super().__init__(name)
        self._make = make
        self._file = file
        self._places = places
        self._generator: Steps | None = None
        # The source positions of calls, by the identity of their code and the offset in it.
        self._calls: dict[tuple[int, int], tuple[CodeType, int]] = {}

    @property
    def at(self) -> int:
        """The source position of the innermost sub that the task is in."""
        if getattr(self._generator, "gi_running", False):
            # A running generator does not know its delegate; the frames between here and it do.
            caller: FrameType | None = _getframe(1)
            while caller is not None and caller.f_code.co_filename != self._file:
                caller = caller.f_back
            return self._places[caller.f_lineno] if caller is not None else 0
        return self.stack[-1]

    @property
    def stack(self) -> tuple[int, ...]:
        """The source positions of its subs, innermost last; invalid while it is running."""
        generator: Any = self._generator
        if generator is not None and generator.gi_yieldfrom is None and generator.gi_frame is not None:
            return (self._places[generator.gi_frame.f_lineno],)
        places: list[int] = []
        inner = generator
        while (frame := getattr(inner, "gi_frame", None)) is not None:
            if frame.f_code.co_filename == self._file:
                if frame.f_code.co_name[0] == PART:
                    places.pop()  # its caller is the same function
                places.append(self._places[frame.f_lineno])
            inner = getattr(inner, "gi_yieldfrom", None)
        return tuple(places) or (self._places[0],)

    def callers(self, above: int = 2) -> tuple[int, ...]:
        """Return the stack without the innermost position, for a running task.

        `above` is the number of calls between this one and the program's code.
        """
        if _getframe(above + 1).f_code is self.resumes:
            return ()
        frame: FrameType | None = _getframe(above)
        # A recursion may be a thousand calls deep: only a call that is new costs one of `_place`.
        calls, file, found = self._calls, self._file, []
        while frame is not None:
            caller = frame.f_back
            if caller is None or (code := caller.f_code).co_filename != file:
                break
            if frame.f_code.co_name[0] != PART:
                known = calls.get((id(code), caller.f_lasti))
                found.append(known[1] if known is not None else self._place(caller))
            frame = caller
        return tuple(found[::-1])

    def _place(self, frame: FrameType) -> int:
        """Return the source position of a call, cached.

        To find its line Python counts from the start of its code, which takes as long as a wait.
        """
        code = frame.f_code
        known = self._calls.get((id(code), frame.f_lasti))
        if known is None:
            # The code is stored too, so that its identity is not reused.
            known = self._calls[id(code), frame.f_lasti] = code, self._places[frame.f_lineno]
        return known[1]

    @property
    def running(self) -> bool:
        return bool(getattr(self._generator, "gi_running", False))

    def at_error(self, error: BaseException) -> int:
        """Return the source position of the innermost frame of the program in a traceback."""
        line, traceback = 0, error.__traceback__
        while traceback is not None:
            if traceback.tb_frame.f_code.co_filename == self._file:
                line = traceback.tb_lineno
            traceback = traceback.tb_next
        return self._places[line] if line else self.at

    def time_at_error(self, error: BaseException) -> float:
        """Return the program's time, s, when `error` was raised; 0 if it is unknown."""
        reached, traceback = 0.0, error.__traceback__
        while traceback is not None:
            frame, traceback = traceback.tb_frame, traceback.tb_next
            if frame.f_code.co_filename == self._file:
                reached = max(reached, frame.f_locals.get("t", 0.0))
        return reached

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        """Run to the horizon, a wait or the end; return the time, s, and the wait, if any."""
        self.busy = 0.0
        try:
            if self._generator is None:
                self._generator = self._make(now, horizon)
                out = next(self._generator)
            else:
                out = self._generator.send((now, horizon))
        except StopIteration as stop:
            self.done = True
            return stop.value, None
        if out.__class__ is float:
            return out, None  # type: ignore[return-value,unused-ignore]
        if out.__class__ is tuple:
            time, self.busy = out  # type: ignore[misc,unused-ignore]
            return time, None
        return out.since, out  # type: ignore[union-attr,return-value,unused-ignore]


GeneratorTask.resumes = GeneratorTask.resume.__code__
