"""Access to a running program from outside, in real time or in lock step.

A server for hosts has its own thread. The program and its controller belong to the thread that runs them.
`Outside.ask` connects the two: the run answers a question between two steps, at its own machine time.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from concurrent.futures import Future
from threading import Condition
from time import monotonic

from motionlang.hosts.console import MEMORY, SELDOM
from motionlang.hosts.serve.wall import WallClock
from motionlang.kernel import INFINITY, Machine
from motionlang.kernel.controller import Clock

# Default machine seconds that lock step advances for each request.
STEP = 10e-3
# The longest wait of the thread that runs the program, so that every system notices a Ctrl-C.
PATIENCE = 0.5


class Closed(Exception):
    """The run has ended and answers no more questions."""


class QuestionQueue:
    """A queue of questions for the run.

    The run calls `start` with its machine before the program starts.
    """

    def __init__(self) -> None:
        self._waiting: deque[tuple[Callable[[], object], Future[object]]] = deque()
        self._changed = Condition()
        self._closed = False
        self.machine: Machine | None = None
        self._passes = 0

    @property
    def clock(self) -> Clock:
        assert self.machine is not None, "the run has not started"
        return self.machine.clock

    def start(self, machine: Machine) -> None:
        self.machine = machine

    def ask(self, question: Callable[[], object]) -> Future[object]:
        """Let the run answer `question`; may be called from any thread.

        The future fails with `Closed` after the end of the run.
        """
        future: Future[object] = Future()
        with self._changed:
            if self._closed:
                future.set_exception(Closed())
            else:
                self._waiting.append((question, future))
                self._changed.notify()
        return future

    def close(self) -> None:
        """Close the queue: questions that are still waiting fail with `Closed`."""
        with self._changed:
            self._closed = True
            while self._waiting:
                self._waiting.popleft()[1].set_exception(Closed())

    def may_act(self) -> bool:
        """True if more questions may arrive, so that a wait may still end."""
        return True

    def advance(self, time: float) -> None:
        """Let machine time pass until `time`, or less if a question arrives; trim unused history at intervals."""
        assert self.machine is not None
        self._passes += 1
        if not self._passes % SELDOM:
            self.machine.controller.forget_history(MEMORY)

    def _answer(self) -> bool:
        """Answer the oldest question; return False if there is none."""
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
        """Wait until a question arrives, at most `seconds`."""
        with self._changed:
            if not self._waiting:
                self._changed.wait(min(seconds, PATIENCE))


class InTurn(QuestionQueue):
    """Questions that a server of hosts answers, one in each of its iterations.

    `wake` starts an iteration. Add `answer_next` to the server's calls; `entered` is called for each question.
    """

    def __init__(self, wake: Callable[[], None], entered: Callable[[], None]) -> None:
        super().__init__()
        self._wake, self._entered = wake, entered

    def ask(self, question: Callable[[], object]) -> Future[object]:
        future = super().ask(question)
        self._wake()
        return future

    def answer_next(self) -> None:
        """Answer the oldest question; the next one waits until this one has had its machine time."""
        if self._answer():
            self._entered()
        if self._waiting:
            self._wake()


class RealTimeQueue(QuestionQueue):
    """Machine time follows real time: `factor` machine seconds per second.

    Lost real time is not made up for.
    """

    def __init__(self, factor: float = 1.0, wall: Callable[[], float] = monotonic) -> None:
        super().__init__()
        self._factor, self._wall = factor, wall
        self._real: WallClock | None = None

    def advance(self, time: float) -> None:
        """Advance in real time and answer questions meanwhile; an answer ends the call."""
        super().advance(time)
        if self._real is None:
            self._real = WallClock(self._wall, self._factor, self.clock.now)
        while True:
            due_time = self._real.due
            if due_time >= time:
                self.clock.advance(time)
                self._answer_all()
                return
            if due_time > self.clock.now:
                self.clock.advance(due_time)
            if self._answer_all():
                return
            self._sleep(self._real.left(time))

    def _answer_all(self) -> bool:
        any_came = False
        while self._answer():
            any_came = True
        return any_came


class LockStepQueue(QuestionQueue):
    """Machine time stops until a request arrives, which advances it by `step` s.

    The same requests in the same order find the same machine, regardless of the speed of this computer and of
    the time between the requests.
    """

    def __init__(self, step: float = STEP) -> None:
        super().__init__()
        self._step = step
        self._granted = step

    def advance(self, time: float) -> None:
        """Advance machine time as far as granted; each further request grants a step."""
        super().advance(time)
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
