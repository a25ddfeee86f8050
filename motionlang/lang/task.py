"""A task: code that runs until the horizon, or until it must wait.

Both languages implement this interface for the scheduler. A Mint task is a generator made by the compiler; an
MCCL task is a program counter over a tuple of operations.
"""

from __future__ import annotations

from sys import _getframe

from motionlang.controller.clock import INFINITY

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Sequence
    from types import CodeType, FrameType
    from typing import Any, Protocol

    from motionlang.lang.dependencies import Dependencies
    from motionlang.lang.waits import Wait

    class Shared(Protocol):
        """The state shared by the tasks of a program."""

        dependencies: Dependencies

        def acted(self) -> tuple[int, int]:
            """Return two counters of the actions whose effects cannot be compared."""

        def state(self, alive: dict[int, object]) -> bytes:
            """Return the shared variables in a form that can be compared."""


# A loop of fewer statements leaves no record; it counts for the code around it.
MIN_STATEMENTS = 100.0
# The first letter of the names of functions in generated code that are a part of another one, and what precedes its
# name in that of the dispatcher of a function with labels. A dispatcher that calls a dispatcher is a GoSub.
CHUNK = "q"
DISPATCHER = "j_"
# The number of frames, from the running code outwards, whose calls are looked up each time. Calls further out
# are cached.
NEAR = range(16)


class Task:
    """`resume(now, horizon)` runs from `now`; it returns the time reached and a wait.

    `None` for the wait means that the horizon was reached, or, with `done` set, that the task has ended.
    Source positions ("at") are offsets, which the dialect's `locate` converts to line and column.

    A task that only polls sets `poll_check`: the number of actions so far, and true if it reads anything.
    `last_poll` is its last reading, as text.
    """

    __slots__ = (
        "busy",
        "done",
        "last_poll",
        "max_slice",
        "name",
        "poll_check",
        "priority",
        "wait",
    )

    def __init__(self, name: str) -> None:
        self.name = name
        # For how long, of its own running time, no other task can observe it: it computes with its own data.
        self.busy = 0.0
        self.poll_check: tuple[int, bool] | None = None
        self.last_poll = ""
        self.priority = 0  # of the tasks that can run, one of the highest priority runs
        self.max_slice = INFINITY  # the longest that it may run, s, while others can
        self.done = False
        self.wait: Wait | None = None

    @property
    def polls_in_vain(self) -> bool:
        """True if it polls, and only another task or an event can change what it reads."""
        return False

    @property
    def shared(self) -> Shared | None:
        """The state shared by the tasks of its program; None if that cannot be compared."""
        return None

    def state(self, alive: dict[int, object], since: float = -INFINITY) -> bytes | None:
        """Return the state that decides the task's future, without wait and shared state.

        Returns None if it cannot be compared. Objects whose identity is part of the state are added to
        `alive`. It does not matter when loops began that began by `since` and
        are so long that they leave a record.
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
    def stack_offsets(self) -> tuple[int, tuple[int, ...]]:
        """The source position of the task, and those of the calls that led there."""
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
        at, callers = wait.location or self.stack_offsets
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

    __slots__ = ("_calls", "_deep", "_file", "_generator", "_make", "_offsets")

    # The code of `resume`, below which there is no further code of a program.
    resumes: CodeType

    def __init__(
        self, name: str, make: Callable[[float, float], Steps], file: str, offsets: Sequence[int]
    ) -> None:
        super().__init__(name)
        self._make = make
        self._file = file
        self._offsets = offsets
        self._generator: Steps | None = None
        # The source positions of calls, by the identity of their code and the offset in it.
        self._calls: dict[tuple[int, int], tuple[CodeType, int]] = {}
        # The calls that led to some frames of deep recursions.
        self._deep: dict[FrameType, tuple[int, ...]] = {}

    @property
    def at(self) -> int:
        """The source position of the innermost sub that the task is in."""
        if getattr(self._generator, "gi_running", False):
            # A running generator does not know its delegate; the frames between here and it do.
            caller: FrameType | None = _getframe(1)
            while caller is not None and caller.f_code.co_filename != self._file:
                caller = caller.f_back
            return self._offsets[caller.f_lineno] if caller is not None else 0
        return self.stack[-1]

    @property
    def stack(self) -> tuple[int, ...]:
        """The source positions of its subs, innermost last; invalid while it is running."""
        generator: Any = self._generator
        if generator is not None and generator.gi_yieldfrom is None and generator.gi_frame is not None:
            return (self._offsets[generator.gi_frame.f_lineno],)
        offsets: list[int] = []
        inner = caller = generator
        while (frame := getattr(inner, "gi_frame", None)) is not None:
            if frame.f_code.co_filename == self._file:
                if offsets and is_same_function(frame, caller):
                    offsets.pop()
                offsets.append(self._offsets[frame.f_lineno])
                caller = frame
            inner = getattr(inner, "gi_yieldfrom", None)
        return tuple(offsets) or (self._offsets[0],)

    def callers(self, above: int = 2) -> tuple[int, ...]:
        """Return the stack without the innermost position, for a running task.

        `above` is the number of calls between this one and the program's code.
        """
        if _getframe(above + 1).f_code is self.resumes:
            return ()
        frame = _getframe(above)
        # A recursion may be a thousand calls deep: only a call that is new costs one of `_offset_of`.
        calls, file = self._calls, self._file
        found: list[int] = []
        for _ in NEAR:
            caller = frame.f_back
            if caller is None or (code := caller.f_code).co_filename != file:
                return tuple(found[::-1])
            if not is_same_function(frame, caller):
                known = calls.get((id(code), caller.f_lasti))
                found.append(known[1] if known is not None else self._offset_of(caller))
            frame = caller
        return (*self._callers_of(frame), *found[::-1])

    def _callers_of(self, frame: FrameType) -> tuple[int, ...]:
        """Return the calls that led to a frame far from the running code.

        They do not change while the frame lasts, so those of one frame in `len(NEAR)` are cached. Leaving n nested
        calls then takes time proportional to n, not to its square.
        """
        cached, file, passed = self._deep, self._file, []
        above = cached.get(frame)
        while above is None:
            caller = frame.f_back
            if caller is None or caller.f_code.co_filename != file:
                above = ()
                break
            passed.append((frame, caller))
            frame = caller
            above = cached.get(frame)
        if len(cached) > len(NEAR) * len(NEAR):
            cached.clear()  # most of these frames have ended
        for count, (frame, caller) in enumerate(reversed(passed), 1):
            if not is_same_function(frame, caller):
                above = (*above, self._offset_of(caller))
            if not count % len(NEAR):
                cached[frame] = above
        return above

    def _offset_of(self, frame: FrameType) -> int:
        """Return the source position of a call, cached.

        Python finds the line of a call by counting from the start of its code, which takes as long as a wait.
        """
        code = frame.f_code
        known = self._calls.get((id(code), frame.f_lasti))
        if known is None:
            # The code is stored too, so that its identity is not reused.
            known = self._calls[id(code), frame.f_lasti] = code, self._offsets[frame.f_lineno]
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
        return self._offsets[line] if line else self.at

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


def is_same_function(frame: FrameType, caller: FrameType) -> bool:
    """True if a frame of generated code and its caller are of one function."""
    name = frame.f_code.co_name
    return name[0] == CHUNK or (name[0] == DISPATCHER[0] and name == DISPATCHER + caller.f_code.co_name)
