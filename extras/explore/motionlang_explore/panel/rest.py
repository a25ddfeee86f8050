"""The waits of a running program: its tasks, if they are at rest, and the channels that they read.

A loop that polls is no wait of the scheduler, so rest is a matter of time: no statement begins that is not one of the
last second, no move begins, and no axis is on its way to an end. The exploration finds rests in the statements of a
whole trial; here the question is asked 50 times a second, of a run that may last all day.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import inf
from typing import NamedTuple

from motionlang.kernel import Dialect, Hook, Machine, Program, Task, Wait
from motionlang.kernel.lang import READ, Statement
from motionlang_explore.exploration import SHORTEST_REST, Channel, Entry, keys_of

# A statement that began within so many seconds belongs to a loop that goes on.
RECENT = 1.0
# Inputs that the machine file drives change these channels, so far away from them, from which the panel copies them.
SHADOW = 100_000
# An entry that never acts: with it, a run knows since when the program asks for a value.
NEVER: Entry = {"asked": 0.0, "times": 0}
VALUES: Mapping[str, Entry] = {
    **{table: {"value": 0} for table in ("comms", "netdata", "modbus.register")},
    "key": {"text": ""},
}
# The tables of the machine file that drive a channel, by its kind; a bank of inputs is known by what it reads.
TABLE_OF = {
    "input": "input",
    "analogue input": "analogue",
    "comms element": "comms",
    "network data": "netdata",
    "key": "key",
    "answer": "answer",
}
# The tables whose numbers a program may compute.
NUMBERED = "input", "analogue", "comms", "netdata"


class PanelWait(NamedTuple):
    """A channel that a program at rest looks at, by its table and number, and the line that reads it."""

    table: str
    number: int
    line: int


class RestWatch(Hook):
    """The statements of a run, and the inputs that they read, each with the time of the last one."""

    def __init__(self, program: Program) -> None:
        super().__init__(lambda task, time, offset: None)
        self._structure = program.structure
        self._begun: dict[int, float] = {}
        # When a statement began last that had begun not long before, and how long before that was.
        self._repeated: dict[int, float] = {}
        self._period: dict[int, float] = {}
        self._begun_by: dict[int, Task] = {}
        # The last statement of each task.
        self._last: dict[str, int] = {}
        # The statements of handlers, which wait for nothing.
        self._handlers: set[int] = set()
        # What the program has read, and from then on asks for, with the time and the statement of the last read.
        self._read: dict[Channel, tuple[float, int]] = {}
        self._machine: Machine | None = None
        # When something new began last, and the number of moves then.
        self.news = 0.0
        self._moves = 0

    def attach(self, machine: Machine) -> None:
        """Watch a run that is about to begin on a machine."""
        self._machine = machine
        machine.controller.reads.add(self._reads)

    def begins(self, task: Task, time: float, offset: int) -> bool:
        period = time - self._begun.get(offset, -inf)
        if period > RECENT:
            self.news = time
        else:
            self._repeated[offset], self._period[offset] = time, period
        scheduler = None if self._machine is None else self._machine.scheduler
        if scheduler is not None and scheduler.interrupts:
            self._handlers.add(offset)
        self._begun[offset], self._begun_by[offset], self._last[task.name] = time, task, offset
        return super().begins(task, time, offset)

    def _reads(self, table: str, channel: int) -> None:
        machine = self._machine
        if machine is None or machine.scheduler is None or channel >= SHADOW:
            return
        if (table, channel) not in self._read:
            machine.add_entries({table: [keys_of(table, channel) | NEVER | VALUES.get(table, {})]})
        self._read[table, channel] = machine.clock.now, machine.scheduler.current.at

    @property
    def inputs(self) -> list[int]:
        """The inputs that the program has read."""
        return sorted(number for table, number in self._read if table == "input")

    def line(self, offset: int) -> int:
        """Return the line of a source offset."""
        return self._structure.line(offset)

    # ------------------------------------------------------------------------------------------------- at rest

    def is_at_rest(self, machine: Machine) -> bool:
        """True if a change of the world alone leads on."""
        now = machine.clock.now
        if machine.moves_made != self._moves:
            self._moves, self.news = machine.moves_made, now
        if now - self.news < SHORTEST_REST or any(
            now < machine.controller.idle_time(axis) < inf for axis in machine.controller.moving()
        ):
            return False
        return all(map(self._is_resting, _tasks(machine)))

    def _is_resting(self, task: Task) -> bool:
        """True if a task waits for anything but a time, or repeats a loop."""
        assert self._machine is not None
        wait = wait_of(self._machine, task)
        if task.done or (wait is not None and wait.cause != "time"):
            return True
        last = self._last.get(task.name, task.at)
        return self._machine.clock.now - self._repeated.get(last, -inf) <= RECENT

    def awaited(self, machine: Machine) -> list[PanelWait]:
        """Return what the statements read that tasks repeat or wait at."""
        now = machine.clock.now
        places = {at for at, time in self._begun.items() if now - time < self._window(machine, at)}
        places |= {task.at for task in _tasks(machine) if not task.done}
        found = [
            PanelWait(*channel, self.line(at))
            for channel, (time, at) in self._read.items()
            if channel[0] in NUMBERED
            if now - time <= self._window(machine, at)
            or (at in places - self._handlers and time >= self._begun.get(at, inf))
        ]
        for at in sorted(places - self._handlers):
            statement = self._structure.statements.get(at)
            if statement is not None:
                found += _read_by(statement, self.line(at))
        found.sort()
        return list({each[:2]: each for each in found}.values())

    def _window(self, machine: Machine, at: int) -> float:
        """Return how long ago a statement that a loop repeats may have begun, s; a loop may wait for a time."""
        task = self._begun_by.get(at)
        wait = None if task is None else wait_of(machine, task)
        if wait is None or wait.cause != "time":
            return SHORTEST_REST
        return max(SHORTEST_REST, 1.5 * self._period.get(at, 0.0))


def _tasks(machine: Machine) -> list[Task]:
    scheduler = machine.scheduler
    return [] if scheduler is None else scheduler.interrupts[-1:] or scheduler.tasks


def _read_by(statement: Statement, line: int) -> Iterator[PanelWait]:
    """Yield the channels that a statement reads, but for those whose number a run alone knows."""
    for use in statement.channels:
        if use.access == READ and use.channel in TABLE_OF and (not use.number or use.number.isdecimal()):
            yield PanelWait(TABLE_OF[use.channel], int(use.number or 0), line)


def tasks_of(machine: Machine, watch: RestWatch, stopped: Mapping[Task, int]) -> list[tuple[str, int, str]]:
    """Return name, line and wait of each task; `stopped` has the next statement of one that is stepped."""
    return [
        (
            task.name,
            watch.line(stopped.get(task, task.at)),
            wait.why if (wait := wait_of(machine, task)) is not None else "",
        )
        for task in _tasks(machine)
        if not task.done
    ]


def wait_of(machine: Machine, task: Task) -> Wait | None:
    """Return the wait of a task, None if it goes on."""
    scheduler = machine.scheduler
    return None if scheduler is None or task.done else scheduler.wait_of(task)


def seeking(machine: Machine, settings: Mapping[str, object], language: Dialect) -> list[int]:
    """Return the axes that home for ever or find no mark, since nothing says where their switches are."""
    axes = machine.controller.axes
    found = {
        number for number, axis in axes.items() if axis.homing is not None and axis.homing.endless_motion
    }
    for task in _tasks(machine):
        wait = wait_of(machine, task)
        for key in () if wait is None else language.driven_by(wait.why):
            if key.startswith("axis.") and key not in settings:
                found.add(int(key.split(".")[1]))
    return sorted(number for number in found if axes[number].velocity(machine.clock.now))
