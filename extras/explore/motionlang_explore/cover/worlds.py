"""One program in many worlds: it is compiled once, and each run counts what it reaches.

A world is the settings around a program, such as its inputs and answers. `cover` runs all worlds of a program here, and
those that it suggests.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from motionlang.kernel import CheckedSettings, Dialect, Hook, Machine, Program, Run, Steps, Task, run
from motionlang.kernel.lang import Values, conditions

# An event of a run: the offset of a statement that begins, or of a condition with its number there and its outcome.
Event = tuple[int, int, bool]
BEGINS = -1
# A world ends after so many statements: three seconds of a loop that toggles an output as fast as it can.
MAX_STATEMENTS = 300_000


@dataclass
class PlayedWorld:
    """The settings around a program, a run in them, and its events; `is_cut` if it had too many statements."""

    settings: Mapping[str, object]
    result: Run
    events: Counter[Event]
    is_cut: bool


class CutOff(Exception):
    """A signal has ended a run, whose events so far are known."""

    def __init__(self, result: Run, events: Counter[Event]) -> None:
        super().__init__("cut off")
        self.result, self.events = result, events


class Worlds:
    """Runs of one program, a debug build."""

    def __init__(self, program: Program, language: Dialect) -> None:
        self.program, self.language = program, language
        # The program as it was last run, and the settings that it depends on.
        self._last = program
        self._deciding = self._decisive(program.settings)

    def _decisive(self, settings: Mapping[str, object]) -> dict[str, object]:
        """Return the settings that the check of the program depends on."""
        return {key: value for key, value in settings.items() if self.language.compiled_in(key)}

    def run(self, settings: Mapping[str, object], until: float | None = None) -> PlayedWorld:
        """Run the program in a world; raise CutOff at a signal."""
        deciding = self._decisive(settings)
        if deciding != self._deciding:
            self._last = self.program.on(settings)
            self._deciding = deciding
        counts = Counts()
        result = run(
            self._last,
            machine=CheckedSettings(settings),
            until=until,
            hook=counts,
            observer=counts,
            begun=counts.attach,
        )
        if result.status == "interrupted":
            raise CutOff(result, counts.events)
        return PlayedWorld(settings, result, counts.events, counts.count >= MAX_STATEMENTS)


class Counts(Hook):
    """The events of a run; the hook and the observer of a debug build."""

    def __init__(self) -> None:
        super().__init__(lambda task, time, offset: None)
        self.events: Counter[Event] = Counter()
        self._machine: Machine | None = None

    def attach(self, machine: Machine) -> None:
        """Watch a run that is about to begin on a machine."""
        self._machine = machine

    def begins(self, task: Task, time: float, offset: int) -> bool:
        """Count a statement, and end the run after `MAX_STATEMENTS` of them."""
        self.events[offset, BEGINS, True] += 1
        self.count += 1
        if self.count < MAX_STATEMENTS:
            return False
        if self._machine is not None and self._machine.scheduler is not None:
            self._machine.scheduler.until = time
        return True

    @property
    def seen(self) -> Counter[Event]:
        """The events so far."""
        return self.events.copy()

    def written(self, steps: Steps) -> None:
        """Let the conditions among some steps count how they turn out."""
        for pc, number in conditions(steps):
            step = steps[pc]
            assert step.do is not None
            steps[pc] = step._replace(do=self._counted(step.do, step.at, number))

    def skipped(self, first: Mapping[Event, int], end: Mapping[Event, int], times: int) -> None:
        """Count the events between two moments so many more times."""
        for event, count in end.items():
            self.events[event] += times * (count - first.get(event, 0))

    def failed(self, task: Task) -> None:
        """A statement that fails has begun."""

    def _counted(self, test: Callable[[Values], Any], at: int, number: int) -> Callable[[Values], Any]:
        def decide(values: Values) -> Any:
            holds = test(values)
            self.events[at, number, bool(holds)] += 1
            return holds

        return decide
