"""Events: their handlers, their priority, and the queue of pending events.

The handler of an event interrupts every task between two statements. A more urgent event interrupts a less urgent
handler. An event that is already pending is not queued twice. If a handler raises events endlessly, no task can run,
so the run then ends with a `never` error.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import TimedCall as ClockEvent
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.waits import Wait
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.keywords.event_kinds import KINDS, RAISED_BY, SINGLE, kind_and_number
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.task import MintTask

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.program import FunctionSteps


# The maximum number of handlers in a row, each raised by a statement of a handler before it, until a task
# must run.
MAX_ROUNDS = 10_000
# After this many handlers in a row, without a statement of a task between them, the run gets a note.
CROWDED = 100


class Events:
    """The handlers of one program, active events (innermost last) and pending ones.

    `_raised_here` are the pending events that a statement of a handler has raised. `_rounds` counts the handlers
    started for such events since a task last ran. `_in_row` counts all handlers that have followed another one since
    then, the first of them at `_row_began`.
    """

    def __init__(self, environment: Environment) -> None:
        self.environment = environment
        self.active: list[tuple[int, int]] = []
        self.pending: list[tuple[int, int]] = []
        self.disabled = 0
        self.timer = 0
        self.listening: set[str] = set()  # kinds that the machine already reports
        # The event of the next tick of the timer, which is number `ticks` since `started`.
        self.tick_event: ClockEvent | None = None
        self.started, self.ticks = 0.0, 0
        self._raised_here: set[tuple[int, int]] = set()
        self._rounds = self._in_row = 0
        self._row_began = 0.0
        self._handlers: dict[tuple[str, int], FunctionSteps] = {}

    def handle(self, kind: str, number: int, unit: FunctionSteps) -> None:
        """Register `unit` as the handler of an event; number -1 means all of its kind."""
        self._handlers[kind, number] = unit

    def handles(self, kind: str, number: int = 0) -> bool:
        """True if the program has a handler for an event."""
        return (kind, number) in self._handlers or (kind, -1) in self._handlers

    def handler(self, kind: str, number: int = 0) -> FunctionSteps:
        """Return the handler of an event; there must be one."""
        return self._handlers.get((kind, number)) or self._handlers[kind, -1]

    def forget_handlers(self) -> None:
        """Discard all handlers, and all active and pending events."""
        self._handlers.clear()
        self.active.clear()
        self.pending.clear()
        self._raised_here.clear()
        self._rounds = self._in_row = self.disabled = 0
        self.set_timer(0)

    def raise_(self, kind: str, number: int = 0) -> None:
        """Raise an event; its handler, if any, runs before the next statement of any task."""
        if not self.handles(kind, number):
            return
        entry = (KINDS.index(kind), number)
        if self.active and self._is_handler_running():
            if self._rounds >= MAX_ROUNDS:
                raise _never_ends(entry)
            self._raised_here.add(entry)
        queued = self.environment.machine.assumptions.get("mint.event-queue")
        known = entry in self.pending or (queued == "forgotten" and entry in self.active)
        if not known or queued == "each":
            self.pending.append(entry)
            self.pending.sort(key=lambda each: each[0])
        clock = self.environment.clock
        clock.at(clock.now, self.deliver)

    def _is_handler_running(self) -> bool:
        """True if a statement of a handler is running; a timer tick does not count."""
        scheduler = self.environment.machine.scheduler
        return scheduler is not None and bool(scheduler.interrupts) and scheduler.current.running

    def deliver(self) -> None:
        """Start the most urgent pending handler if it is more urgent than the active one."""
        for entry in self.pending:
            rank, number = entry
            if self.disabled >> rank & 1:
                continue
            if self.active and rank >= self.active[-1][0]:
                return
            self.pending.remove(entry)
            self.active.append(entry)
            if entry in self._raised_here:
                self._raised_here.discard(entry)
                self._rounds += 1
            if rank == 0:
                self.environment.errors.call()
            unit = self.handler(KINDS[rank], number)
            scheduler = self.environment.machine.scheduler
            assert scheduler is not None
            scheduler.interrupt(EventTask(KINDS[rank], unit, self.environment))
            return

    def done(self) -> None:
        """End a handler and deliver pending events."""
        self.active.pop()
        self.deliver()
        if self.active:
            self._follows()
        else:
            self._rounds = self._in_row = 0

    def _follows(self) -> None:
        """Count a handler that follows another one; note if they leave no time for tasks."""
        now = self.environment.clock.now
        if not self._in_row:
            self._row_began = now
        self._in_row += 1
        if self._in_row == CROWDED:
            kind = KINDS[self.active[-1][0]].upper()
            self.environment.machine.notes[
                f"{CROWDED} handlers in a row, from {self._row_began:.3f} s on, left no time for any task (the last"
                f" one was for {kind}): a handler must end before its event comes again"
            ] = None

    def bits(self, entries: list[tuple[int, int]]) -> int:
        """Return the kinds of some events as a bit pattern."""
        pattern = 0
        for rank, _ in entries:
            pattern |= 1 << rank
        return pattern

    def disable(self, pattern: int) -> None:
        """Set the kinds of event that must wait; deliver pending events of other kinds."""
        self.disabled = pattern
        clock = self.environment.clock
        clock.at(clock.now, self.deliver)

    def set_timer(self, milliseconds: int) -> None:
        """Set the period of the timer event; 0 switches it off."""
        self.timer = milliseconds
        if self.tick_event is not None:
            self.tick_event.cancel()
            self.tick_event = None
        if milliseconds > 0:
            clock, machine = self.environment.clock, self.environment.machine
            self.started = clock.now
            self.ticks = 0 if machine.assumptions.get("mint.timerevent") == "at once" else 1
            self.tick_event = clock.at(self.tick_time(self.ticks), self._tick)

    def tick_time(self, number: int) -> float:
        """Return the time of a tick by multiplication, so rounding does not accumulate."""
        return self.started + number * (self.timer / 1000.0)

    def schedule_tick(self, number: int) -> None:
        """Schedule tick `number`, which follows the tick that has just run."""
        assert self.tick_event is not None
        self.ticks = number
        self.environment.clock.again(self.tick_event, self.tick_time(number))

    def _tick(self) -> None:
        if self.environment.machine.assumptions.get("mint.timerevent") != "once":
            self.schedule_tick(self.ticks + 1)
        self.raise_("timer")


def _never_ends(entry: tuple[int, int]) -> Rejected:
    """Return the error for handlers that endlessly raise the events of each other."""
    kind, number = KINDS[entry[0]], entry[1]
    name = kind.upper() if kind in SINGLE else f"{kind.upper()}{number}"
    message = (
        f"handlers have raised {MAX_ROUNDS} events in a row, the last one {name}, and no task runs anymore"
    )
    return Rejected("never", message, f"tasks continue when a handler ends without raising {name} again")


class EventTask(MintTask):
    """A task that runs an active handler."""

    def __init__(self, name: str, unit: FunctionSteps, environment: Environment) -> None:
        super().__init__(name, unit, environment)
        self.timer = environment.timer

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        time, wait = super().resume(now, horizon)
        if self.done:
            self.environment.events.done()
        return time, wait


def listen(environment: Environment) -> None:
    """Register the handlers of a program, and subscribe to their events."""
    events = environment.events
    kinds: set[str] = set()
    for key, unit in environment.blocks.items():
        what, _, name = key.partition(" ")
        found = kind_and_number(name) if what == "event" else None
        if found is not None:
            events.handle(*found, unit)
            kinds.add(found[0])
    controller = environment.controller
    kinds -= events.listening
    events.listening |= kinds
    for kind in kinds & RAISED_BY.keys():
        environment.component(table().file(RAISED_BY[kind]).SOURCES[kind])
    if "onerror" in kinds:
        _ = environment.errors  # from now on errors are recorded
    if kinds & {"axisidle", "mblow"} and "machine" not in events.listening:
        events.listening.add("machine")
        controller.listeners.append(
            lambda what, axis: _on_event(environment, what, axis), "idle", "buffer-low"
        )


def _on_event(environment: Environment, what: str, axis: int) -> None:
    if what == "idle" and environment.controller.is_idle(axis):
        environment.events.raise_("axisidle")
    elif what == "buffer-low":
        environment.events.raise_("mblow")
