"""A task: something that runs until the horizon, or until it must wait.

Both languages answer to the scheduler in this one way. A Mint task is a generator that the compiler made; an MCCL
task is a program counter over a tuple of operations.
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
    from motionlang.lang.attention import Attention
    from motionlang.lang.machine.machine import Machine

    class Shared(Protocol):
        """What the tasks of a program share."""

        attention: Attention

        def state(self, alive: dict[int, object]) -> tuple[int, int, bytes]:
            """Two counters of what tasks did that cannot be compared, and what their variables hold."""


INFINITY = float("inf")
# Times that are nearer to each other than this are one: it is not rounding that decides who comes first.
ROUNDING = 1e-9
# So near to a solved moment, s, what was read is not relied upon: the solution is rounded, and so is the reading.
CLOSE = 1e-7
# Who lets more time pass than this, s, between two looks keeps watch or shows something, and does not look in vain.
WATCH = 0.03


class Wait:
    """What a task waits for.

    `since`   the time at which the task began to wait
    `ready()` whether it may go on, asked whenever something has happened
    `due()`   the earliest time at which `ready` may become true if nothing else happens (infinite if never)
    `why`     how a person would say it, for the report of a wait that never ends
    `cause`   what kind of thing ends it, and `what` its numbers: one of `record.records.CAUSES`
    `ends`    the moment at which it ends whatever happens, where there is one: then neither of the two need be asked
    `place`   the place of its statement and those of the calls that led there, where it knows them itself
    """

    __slots__ = ("cause", "due", "ends", "ready", "since", "what", "why")

    place: tuple[int, tuple[int, ...]] | None = None

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
        """When it ends if nothing happens but what is expected, and no sooner; -1 where nobody can tell, or it has."""
        return -1.0


class Delay(Wait):
    """A wait for a moment; programs have millions of them, so its reason is put into words when somebody asks."""

    __slots__ = ("_clock", "place")

    cause = "time"
    what = ()
    ends: float

    def __init__(
        self, clock: Clock, since: float, time: float, place: tuple[int, tuple[int, ...]] | None = None
    ) -> None:
        self.since, self._clock, self.ends, self.place = since, clock, time, place

    @property
    def length(self) -> float:
        """How long all of it takes, s, to a nanosecond."""
        return round(self.ends - self.since, 9)

    def move(self, time: float) -> None:
        """It ends at another moment, and began as much earlier or later."""
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
    """Wait for a moment."""
    return Delay(machine.clock, since, time)


def wait_idle(controller: Controller, since: float, axes: Iterable[int]) -> Wait:
    """Wait until all of `axes` stand, with nothing released in their buffers; what follows stands with its master."""
    waited = tuple(axes)
    names = ", ".join(str(axis) for axis in waited)
    return Wait(
        since,
        lambda: all(controller.stands(axis) for axis in waited),
        lambda: max((controller.standing_time(axis) for axis in waited), default=since),
        f"for axis {names} to be idle",
        "axis",
        waited,
    )


class Task:
    """`resume(now, horizon)` runs on from `now` and answers with the time reached and what it waits for.

    `None` for the wait means that the horizon was reached, or, with `done` set, that the task has ended.
    Places in the program are token numbers ("at"), which the dialect's `locate` turns into line and column.

    A task that only polls says so in `look`: how much anybody has done by then, and whether it looks at anything.
    `in_vain` is the time since which it has looked for something that nothing could bring about until the end of the
    run, and `looks_at` what it looked at last, as text.
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
        # For how long, of its own running time, nobody can tell what the task does: it computes with what is its own.
        self.busy = 0.0
        self.look: tuple[int, bool] | None = None
        self.in_vain: float | None = None
        self.looks_at = ""
        self.priority = 0  # of two tasks that can run, the one with the higher priority does
        self.turn = INFINITY  # the most that it may run, s, while others can
        self.done = False
        self.wait: Wait | None = None

    @property
    def shared(self) -> Shared | None:
        """What the tasks of its program share, where that can be compared."""
        return None

    def state(self, alive: dict[int, object]) -> bytes | None:
        """All that decides what it does next but its wait and what tasks share; None where that cannot be compared.

        Objects whose identity is part of it are added to `alive`.
        """
        return None

    @property
    def at(self) -> int:
        """Where the task stands."""
        return 0

    @property
    def stack(self) -> tuple[int, ...]:
        """Where it stands, behind the places of the calls that led there, the outermost first."""
        return (self.at,)

    @property
    def standing(self) -> tuple[int, tuple[int, ...]]:
        """Where it stands, and the places of the calls that led there."""
        *callers, at = self.stack
        return at, tuple(callers)

    @property
    def loops(self) -> Sequence[tuple[int, float, tuple[int, ...]]]:
        """The loops that it is in, the outermost first: place, begin, s, and the places of the calls that led there."""
        return ()

    def waited(self, wait: Wait, until: float) -> tuple[object, ...]:
        """The record of a wait that is over, as `record.records.Waited` has it."""
        at, callers = wait.place or self.standing
        why = "" if wait.cause == "time" else wait.why
        return self.name, at, wait.since, until, wait.cause, wait.what, why, callers

    @property
    def running(self) -> bool:
        """Whether a statement of the task is being executed at this very moment."""
        return False

    def at_error(self, error: BaseException) -> int:
        """Where `error`, which came out of `resume`, was raised."""
        return self.at

    def time_at_error(self, error: BaseException) -> float:
        """The time, s, to which the task had come by itself when `error` was raised; 0 where it does not say."""
        return 0.0

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        """Run until `horizon`, s, a wait or the end: the time reached, and the wait if there is one."""
        raise NotImplementedError


if TYPE_CHECKING:
    Steps = Generator[float | Wait | tuple[float, float], tuple[float, float], float]


class GeneratorTask(Task):
    """A task made of a generator: it yields the time at the horizon, or a `Wait`, and returns its last time.

    At the horizon it may yield `(time, busy)` instead, and say that way how long nobody can tell what it does.

    `file` is the file name of the generated code and `places[n]` the place in the program of its line `n`.
    """

    __slots__ = ("_calls", "_file", "_generator", "_make", "_places")

    # The code of `resume`, behind which no further code of a program stands.
    resumes: CodeType

    def __init__(
        self, name: str, make: Callable[[float, float], Steps], file: str, places: Sequence[int]
    ) -> None:
        super().__init__(name)
        self._make = make
        self._file = file
        self._places = places
        self._generator: Steps | None = None
        # The places of calls, by the number of their code and where in it they stand.
        self._calls: dict[tuple[int, int], tuple[CodeType, int]] = {}

    @property
    def at(self) -> int:
        """The place of the innermost sub that the task is in."""
        if getattr(self._generator, "gi_running", False):
            # A generator that runs does not tell what it has handed on to; the frames between here and it do.
            caller: FrameType | None = _getframe(1)
            while caller is not None and caller.f_code.co_filename != self._file:
                caller = caller.f_back
            return self._places[caller.f_lineno] if caller is not None else 0
        return self.stack[-1]

    @property
    def stack(self) -> tuple[int, ...]:
        """The places of its subs, the innermost last; not while it is running."""
        generator: Any = self._generator
        if generator is not None and generator.gi_yieldfrom is None and generator.gi_frame is not None:
            return (self._places[generator.gi_frame.f_lineno],)
        places = []
        inner = generator
        while (frame := getattr(inner, "gi_frame", None)) is not None:
            if frame.f_code.co_filename == self._file:
                places.append(self._places[frame.f_lineno])
            inner = getattr(inner, "gi_yieldfrom", None)
        return tuple(places) or (self._places[0],)

    def callers(self, above: int = 2) -> tuple[int, ...]:
        """The same while it is running and without the innermost one, for what the program's code has called.

        `above` says how many calls above this one that code is.
        """
        if _getframe(above + 1).f_code is self.resumes:
            return ()
        frame: FrameType | None = _getframe(above)
        found = []
        while (
            frame is not None and frame.f_back is not None and frame.f_back.f_code.co_filename == self._file
        ):
            frame = frame.f_back
            found.append(self._place(frame))
        return tuple(found[::-1])

    def _place(self, frame: FrameType) -> int:
        """The place of a call. To find its line Python counts from where its code begins, as long as a wait takes."""
        code = frame.f_code
        known = self._calls.get((id(code), frame.f_lasti))
        if known is None:
            # With the code, so that no other one gets its number.
            known = self._calls[id(code), frame.f_lasti] = code, self._places[frame.f_lineno]
        return known[1]

    @property
    def running(self) -> bool:
        return bool(getattr(self._generator, "gi_running", False))

    def at_error(self, error: BaseException) -> int:
        """The place of the innermost frame of the program that the error came through."""
        line, traceback = 0, error.__traceback__
        while traceback is not None:
            if traceback.tb_frame.f_code.co_filename == self._file:
                line = traceback.tb_lineno
            traceback = traceback.tb_next
        return self._places[line] if line else self.at

    def time_at_error(self, error: BaseException) -> float:
        """The time, s, to which the program had counted when `error` was raised; 0 where it does not say."""
        reached, traceback = 0.0, error.__traceback__
        while traceback is not None:
            frame, traceback = traceback.tb_frame, traceback.tb_next
            if frame.f_code.co_filename == self._file:
                reached = max(reached, frame.f_locals.get("t", 0.0))
        return reached

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        """Run to the horizon, to a wait or to the end: the time reached, s, and the wait if there is one."""
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
