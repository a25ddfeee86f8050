"""One execution of a program, in a thread that blocks in the hook at a stop, and that goes back.

Problem. A debugger asks for the state of a run at a statement, and then for an earlier one. A run that is split into
parts at its stops differs in the last bits.

Idea. A run is never split: its thread waits inside the hook, in the middle of its work, while another thread reads its
state. Between two rounds of the scheduler the whole state of the run is in its objects. Snapshots are taken there,
now and then (`checkpoints.py`). To go back, the thread ends, the last snapshot before the statement is put back, and
another thread continues from there. Runs are deterministic, so a statement has the same number whenever it is executed.

    controlling thread                       thread of the run
    go(…)              -- None ------------> continues
      waits                                  … statement 17: decide(point) is true
      returns          <-- "stopped" ------- waits in the hook
    back(12)           -- ABANDON ---------> raises `RunAbandoned` through the program
      puts a snapshot back
    go(…)              -- starts ----------> another thread, from statement 9

Invariants.
- One thread runs at a time, except for `pause`, which only makes the next statement a stop.
- A run that gives up, because no statement begins, ends between two events. It only shows its log until it goes back.
- The changes of the journal are made before their statements, whenever these are executed.
- An abandoned thread leaves nothing behind: it writes no files, and only its new output is shown.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from queue import Empty, SimpleQueue

from motionlang.ide.debug.checkpoints import Checkpoint, Checkpoints
from motionlang.ide.debug.journal import Assigned, Entered, Journal
from motionlang.ide.debug.scopes import find
from motionlang.kernel import (
    INFINITY,
    Dialect,
    Hook,
    Machine,
    Program,
    Rejected,
    Run,
    Source,
    Task,
    run,
    run_on,
)
from motionlang.kernel.lang import Snapshot

# The limit at which every statement is considered: they are numbered from 1.
EVERY = 0
# Statements before the target of a replay at which a snapshot is taken.
NEAR = 64
# How often the clock advances without a statement until a pause ends the run instead.
PAUSE = 64
# Real time between two calls of `meanwhile`, s.
POLL = 0.05
# Enough for the deepest recursion of a program on systems whose threads have small stacks.
STACK_SIZE = 64 * 1024 * 1024


class RunAbandoned(BaseException):
    """Raised in the hook to end a run that is no longer needed."""


class Cancelled(Exception):
    """The session ended while the run waited for the operator."""


@dataclass(eq=False, slots=True)
class StopPoint:
    """A statement about to be executed: its number, time (s) and source offset."""

    number: int
    time: float
    task: Task
    offset: int


@dataclass(eq=False, slots=True)
class Setup:
    """The data shared by all runs of a session."""

    source: Source
    language: Dialect
    settings: Mapping[str, object]
    overrides: Mapping[str, float | str]
    until: float | None
    program: Program


class SessionOutput:
    """The output of a session; text that an earlier run has shown is not repeated.

    A run that searches for a moment may have to go back. It retains its output until it is known up to which character
    the output is valid.
    """

    def __init__(self, show: Callable[[str], object]) -> None:
        self._show, self._shown = show, 0
        self._buffered = ""
        self._holds = False

    def write(self, begin: int, text: str) -> None:
        """Show, or retain, the new part of a text at character `begin` of the output."""
        known = self._shown + len(self._buffered)
        self._buffered += text[max(known - begin, 0) :]
        if not self._holds:
            self.release(known + len(self._buffered))

    def hold(self) -> None:
        """Retain all text from here on."""
        self._holds = True

    def release(self, length: int) -> None:
        """Show the output up to a length, and discard the retained rest."""
        text = self._buffered[: max(length - self._shown, 0)]
        self._buffered, self._holds = "", False
        self._shown += len(text)
        if text:
            self._show(text)

    def forget(self, length: int) -> None:
        """Allow the output after the first `length` characters to be shown again."""
        self._shown = min(self._shown, length)


class Replay:
    """A run in its own thread.

    `ask_user` returns the line for an INPUT; without it there is no operator, as in a plain run. `meanwhile` is called
    again and again while the run goes on.
    """

    def __init__(
        self,
        setup: Setup,
        journal: Journal,
        output: SessionOutput,
        ask_user: Callable[[str], str | None] | None = None,
        meanwhile: Callable[[], None] = lambda: None,
    ) -> None:
        self._setup, self._journal, self._output, self._ask_user = setup, journal, output, ask_user
        self._meanwhile = meanwhile
        self.hook = self._new_hook()
        self.checkpoints = Checkpoints()
        # The statement shortly before which another snapshot is taken, since a user steps back from it.
        self._target = INFINITY
        # How often the clock has advanced, and who is asked then whether to give up.
        self.advances = 0
        self._give_up: Callable[[float], bool] | None = None
        self.gave_up = False
        self._idle = 0
        self.machine: Machine
        self._is_new = True
        self.point: StopPoint | None = None
        # The result, once the program has ended, and an internal error.
        self.run: Run | None = None
        self.error: BaseException | None = None
        self.problems: list[str] = []
        # Hits by breakpoint, and the last values of watched variables.
        self.hits: dict[object, int] = {}
        self.values: dict[tuple[str, ...], object] = {}
        self.written = 0
        self._answers_used = 0
        self._decide: Callable[[StopPoint], bool] = lambda point: False
        self._limit = INFINITY
        # True if `pause` caused the last stop.
        self.paused = self._pausing = False
        self._requests: SimpleQueue[str] = SimpleQueue()
        self._news: SimpleQueue[str] = SimpleQueue()
        self._thread: threading.Thread | None = None

    # ---------------------------------------------------------------------------- from the controlling thread

    def go(
        self,
        decide: Callable[[StopPoint], bool],
        limit: float = INFINITY,
        offsets: frozenset[int] | None = None,
        give_up: Callable[[float], bool] | None = None,
    ) -> StopPoint | None:
        """Continue until `decide` is true; return that point, or None at the end.

        `decide` is called before each statement from number `limit` on, and before those at `offsets`. `give_up` is
        called with each time to which the clock is about to advance. If it is true, `gave_up` is set and the run ends.
        """
        if self.run is not None or self.error is not None or self.gave_up:
            return None
        self._decide, self._limit, self._give_up = decide, limit, give_up
        self.paused = False
        self.hook.offsets = offsets
        self._arm()
        self.point = None
        if self._thread is None:
            self._start()
        else:
            self._requests.put("go")
        while self._next_news() == "asks":
            self._requests.put("go" if self._answer_input() else "abandon")
        if self.error is not None:
            raise self.error
        return self.point

    def _next_news(self) -> str:
        """Wait for the thread of the run."""
        while True:
            try:
                return self._news.get(timeout=POLL)
            except Empty:
                self._meanwhile()

    def pause(self) -> None:
        """Stop before the next statement, or end the run if none begins.

        May be called from any thread.
        """
        self._pausing = True
        self.hook.limit = EVERY

    def consider_from(self, number: int) -> None:
        """Call `decide` only from statement `number` on; called by `decide` itself."""
        self._limit = number

    def abandon(self) -> None:
        """End the thread of the run."""
        if self._thread is not None and self.run is None and self.point is not None:
            self._requests.put("abandon")
            while self._news.get() != "ended":
                pass
            self.point = None

    def back(self, to: Checkpoint | None, target: float = INFINITY) -> None:
        """Go back to a snapshot, or to the start; `go` continues from there, towards statement `target`."""
        self.abandon()
        self._thread, self.run, self.error, self.gave_up = None, None, None, False
        self.paused = self._pausing = False
        self.values = {}
        begin = 0 if to is None else to.number
        self._target = target - NEAR if target - NEAR > begin else INFINITY
        self.checkpoints.drop_after(to)
        if to is None:
            self._is_new, self.hook = True, self._new_hook()
            self.hits = {}
            self.written = self._answers_used = self.advances = 0
            return
        to.snapshot.restore()
        self.hook.count = to.number
        self.hits = dict(to.hits)
        self.written, self._answers_used, self.advances = to.written, to.answers_used, to.advances

    def enter(self, entries: Mapping[str, object]) -> None:
        """Add inputs and keys to the simulated world now."""
        self.machine.add_entries(entries)

    # -------------------------------------------------------------------------------- in the thread of the run

    def _start(self) -> None:
        before = threading.stack_size(STACK_SIZE)
        try:
            self._thread = threading.Thread(target=self._main, name="program", daemon=True)
            self._thread.start()
        finally:
            threading.stack_size(before)

    def _main(self) -> None:
        setup = self._setup
        try:
            if not self._is_new:
                self.run = run_on(setup.source, setup.language, setup.program, self.machine, setup.until)
                return
            self._is_new = False
            self.run = run(
                setup.program,
                machine=setup.settings,
                until=setup.until,
                overrides=setup.overrides,
                show=self._show,
                begun=self._begun,
                hook=self.hook,
            )
        except RunAbandoned:
            if not self.gave_up:
                self.error = Cancelled()
        except BaseException as error:
            self.error = error
        finally:
            self._news.put("ended")

    def _begun(self, machine: Machine) -> None:
        self.machine = machine
        if self._ask_user is not None:
            machine.ask = self._input

    def _show(self, text: str) -> None:
        begin, self.written = self.written, self.written + len(text)
        self._output.write(begin, text)

    def _stop(self, task: Task, time: float, offset: int) -> None:
        point = StopPoint(self.hook.count, time, task, offset)
        decided = self._decide(point)  # before the changes, as when they were made
        for change in self._journal.at(point.number):
            self.make(change, point)
        if decided or self._pausing:
            self.paused, self._pausing, self._idle = not decided, False, 0
            self.point = point
            self._news.put("stopped")
            self._wait()
        self._arm()

    def _advancing(self, time: float) -> None:
        """Give up if that is due; the clock is about to advance."""
        self.advances += 1
        if self._pausing:
            self._idle += 1
            self.paused = self._idle > PAUSE
        if self.paused or (self._give_up is not None and self._give_up(time)):
            self._pausing, self.gave_up = False, True
            raise RunAbandoned

    def _wait(self) -> None:
        """Wait until the run continues or is abandoned."""
        if self._requests.get() == "abandon":
            raise RunAbandoned

    def _arm(self) -> None:
        """Set the number of the next statement for `decide` or the journal."""
        self.hook.limit = min(self._limit, self._journal.following(self.hook.count))
        if self._pausing:
            self.hook.limit = EVERY

    def _new_hook(self) -> Hook:
        return Hook(self._stop, advancing=self._advancing, between=self._between)

    def _between(self) -> None:
        """Take a snapshot if one is due; the scheduler is between two rounds."""
        number, target = self.hook.count, self._target
        if number >= min(self.checkpoints.due, target):
            snapshot = Snapshot(self.machine.scheduler)
            self.checkpoints.add(
                Checkpoint(
                    number,
                    self.machine.clock.now,
                    snapshot,
                    dict(self.hits),
                    self.written,
                    self._answers_used,
                    self.advances,
                )
            )
            if number >= target:
                self._target = INFINITY
        self.hook.round_at = min(self.checkpoints.due, self._target)

    def depth(self, task: Task) -> int:
        """Return the number of calls that the running task is in."""
        assert self.hook.inspection is not None
        return self.hook.inspection.depth(task)

    def make(self, change: Assigned | Entered, point: StopPoint) -> None:
        """Make a change of the journal before a statement."""
        try:
            if isinstance(change, Entered):
                self.machine.add_entries(change.entries)
            else:
                variable = find(self.hook, point, change.path)
                if variable is None or variable.set is None:
                    self.problems.append(f"there is no variable {change.path[-1]} here any more")
                else:
                    variable.set(change.value)
                    if change.path in self.values:
                        self.values[change.path] = change.value
        except (ValueError, Rejected) as error:
            self.problems.append(str(error))

    def _input(self) -> str | None:
        """Return the line for an INPUT: from the journal, or from the user."""
        number, self._answers_used = self._answers_used, self._answers_used + 1
        if number >= len(self._journal.answers):
            self._news.put("asks")
            self._wait()
        answers = self._journal.answers
        return answers[number].text if number < len(answers) else None

    def _answer_input(self) -> bool:
        """Ask the user for the line of an INPUT; False if the session ends meanwhile."""
        assert self._ask_user is not None
        line = self._ask_user(self.machine.terminal.begun)
        if line is None:
            return False
        self._journal.answer(self.hook.count, line, self._answers_used - 1)
        return True
