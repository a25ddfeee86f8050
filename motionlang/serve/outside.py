"""How machine time passes while a running program is reached from outside: with the wall clock, or in lock step.

Whoever serves a host does so in a thread of its own; the program and its controller belong to the thread that runs
them. `Outside.ask` is the way across: the question is answered by the run, between two steps, at its own machine time.
"""

from __future__ import annotations

from collections import deque
from concurrent.futures import Future
from threading import Condition
from time import monotonic
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.clock import Clock
    from motionlang.lang.machine.machine import Machine

INFINITY = float("inf")
# Machine seconds by which lock step goes on for each request, as long as nothing else is said.
STEP = 10e-3
# The longest wait of the thread that runs the program, so that a Ctrl-C is heard on every system.
PATIENCE = 0.5


class Closed(Exception):
    """The run has ended and answers no more."""


class Outside:
    """The questions that wait for the run. `start` is called by the run with its machine, before the program starts."""

    def __init__(self) -> None:
        self._waiting: deque[tuple[Callable[[], object], Future[object]]] = deque()
        self._changed = Condition()
        self._closed = False
        self.machine: Machine | None = None

    @property
    def clock(self) -> Clock:
        assert self.machine is not None, "the run has not started"
        return self.machine.clock

    def start(self, machine: Machine) -> None:
        self.machine = machine

    def ask(self, question: Callable[[], object]) -> Future[object]:
        """From any thread: have `question` answered by the run. The future fails with `Closed` after its end."""
        future: Future[object] = Future()
        with self._changed:
            if self._closed:
                future.set_exception(Closed())
            else:
                self._waiting.append((question, future))
                self._changed.notify()
        return future

    def close(self) -> None:
        """The run is over: questions that still wait are refused."""
        with self._changed:
            self._closed = True
            while self._waiting:
                self._waiting.popleft()[1].set_exception(Closed())

    def may_act(self) -> bool:
        """Whether anything can still come, so that a wait which nothing else can end is not without hope."""
        return True

    def advance(self, time: float) -> None:
        """Let machine time pass until `time`, or less far where something has come from outside."""
        raise NotImplementedError

    def _answer(self) -> bool:
        """Answer the question that has waited longest; False where there is none."""
        with self._changed:
            if not self._waiting:
                return False
            question, future = self._waiting.popleft()
        try:
            future.set_result(question())
        except Exception as error:
            future.set_exception(error)
        return True

    def _sleep(self, seconds: float) -> None:
        """Until something comes, or for so long."""
        with self._changed:
            if not self._waiting:
                self._changed.wait(min(seconds, PATIENCE))


class RealTime(Outside):
    """Machine time is the wall's, `factor` machine seconds a second; a run that cannot keep up is late for good."""

    def __init__(self, factor: float = 1.0, wall: Callable[[], float] = monotonic) -> None:
        super().__init__()
        self._factor, self._wall = factor, wall
        self._began: float | None = None

    def advance(self, time: float) -> None:
        """Let machine time pass with the wall's, answering meanwhile; an answer ends it early."""
        if self._began is None:
            self._began = self._wall() - self.clock.now / self._factor
        while True:
            due = (self._wall() - self._began) * self._factor
            if due >= time:
                self.clock.advance(time)
                self._answer_all()
                return
            if due > self.clock.now:
                self.clock.advance(due)
            if self._answer_all():
                return
            self._sleep((time - due) / self._factor)

    def _answer_all(self) -> bool:
        any_came = False
        while self._answer():
            any_came = True
        return any_came


class LockStep(Outside):
    """Machine time stands still until a request comes, and goes on by `step` seconds after each.

    The same requests in the same order find the same machine, however fast this computer is and however long the
    client thinks.
    """

    def __init__(self, step: float = STEP) -> None:
        super().__init__()
        self._step = step
        self._granted = step

    def advance(self, time: float) -> None:
        """Let machine time pass as far as requests have granted; each further request grants a step."""
        while True:
            if time <= self._granted:
                self.clock.advance(time)
                return
            self.clock.advance(self._granted)
            while not self._answer():
                self._sleep(INFINITY)
            self._granted += self._step
            if time == INFINITY or self.clock.next_time() < time:
                return
