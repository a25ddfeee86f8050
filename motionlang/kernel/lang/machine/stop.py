"""The event at which a run ends before its time limit: `run.stop` of the machine file."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from typing import Any

from motionlang.kernel.controller.clock import Clock
from motionlang.kernel.log.log import Log

# The event of a program that asks for a line when no answer is left.
ASKS = "input"


class StopCondition:
    """One condition, which holds once it has occurred so many `times`.

    It is the kind of an `event`, a text that a printed line contains, or a `line` of the program whose moves, waits,
    outputs or prints are in the log; its commands, the causes for which one waits, and the axes that move are counted
    each by itself. `end` is called when it holds, as an event of the clock: between two statements.
    """

    def __init__(self, settings: Mapping[str, object], clock: Clock, log: Log) -> None:
        self.event, self.text = settings.get("run.stop.event"), settings.get("run.stop.prints")
        self.line: int = settings.get("run.stop.line", 0)  # type: ignore[assignment]
        self.times = settings.get("run.stop.times", 1)
        # How often it has occurred, by what is counted by itself.
        self.counts: Counter[tuple[object, ...]] = Counter()
        self.end: Callable[[], object] = _nothing
        # The line of a source offset.
        self.line_of: Callable[[int], int] = int
        self._clock = clock
        if self.text is not None:
            log.prints.heard = lambda line: self._occurs(str(self.text) in line.text)
        elif self.line:
            log.moves.heard = lambda move: self._occurs(move.line == self.line, "moves", move.axis)
            for stream in (log.waits, log.outputs, log.analogue_outputs, log.prints):
                stream.heard = self._hears
        elif self.event != ASKS:
            log.events.heard = lambda event: self._occurs(event.kind == self.event)

    def asks(self) -> None:
        """Take note that the program asks for a line, and no answer is left."""
        self._occurs(self.event == ASKS)

    def __str__(self) -> str:
        """Return the condition in words, as a cause."""
        often = f", {self.times} times" if self.times != 1 else ""
        if self.text is not None:
            return f"the printed text {self.text!r}{often}"
        if self.line:
            return f"line {self.line}{often}"
        return "an INPUT without an answer" if self.event == ASKS else f"the event {self.event}{often}"

    def _hears(self, record: Any) -> None:
        cause = getattr(record, "cause", "")
        self._occurs(self.line_of(record.at) == self.line, record.at, cause)

    def _occurs(self, holds: bool, *counted: object) -> None:
        self.counts[counted] += holds
        if holds and self.counts[counted] == self.times:
            self._clock.at(self._clock.now, self.end)


def _nothing() -> None:
    """End nothing, before the run begins."""


def stop_of(settings: Mapping[str, object], clock: Clock, log: Log) -> StopCondition | None:
    """Return the condition of the settings, None if there is none."""
    names = ("event", "prints", "line")
    return (
        StopCondition(settings, clock, log) if any(f"run.stop.{name}" in settings for name in names) else None
    )
