"""The event at which a run ends before its time limit: `run.stop` of the machine file."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from typing import Any

from motionlang.kernel.controller.clock import Clock
from motionlang.kernel.log.log import Log
from motionlang.kernel.log.stream import Stream

# The event of a program that asks for a line when no answer is left.
ASKS = "input"


class Stop:
    """One condition, which holds once it has occurred so many `times`.

    It is the kind of an `event`, a text that a printed line contains, or a `line` of the program whose moves, waits,
    outputs or prints are in the log; each of these kinds is counted by itself. `end` is called when it holds, as an
    event of the clock: between two statements.
    """

    def __init__(self, settings: Mapping[str, object], clock: Clock, log: Log) -> None:
        self.event, self.text = settings.get("run.stop.event"), settings.get("run.stop.prints")
        self.line: int = settings.get("run.stop.line", 0)  # type: ignore[assignment]
        self.times = settings.get("run.stop.times", 1)
        # How often it has occurred, by kind.
        self.counts: Counter[str] = Counter()
        self.end: Callable[[], object] = _nothing
        # The line of a source offset.
        self.line_of: Callable[[int], int] = int
        self._clock = clock
        if self.text is not None:
            log.prints.heard = lambda row: self._occurs(str(self.text) in row[1])
        elif self.line:
            log.moves.heard = lambda move: self._occurs(move.line == self.line, "moves")
            log.waits.heard = self._listener(log.waits, "waits")
            log.outputs.heard = self._listener(log.outputs, "outputs")
            log.analogue_outputs.heard = self._listener(log.analogue_outputs, "analogue outputs")
            log.prints.heard = self._listener(log.prints, "prints")
        elif self.event != ASKS:
            log.events.heard = lambda row: self._occurs(row[1] == self.event)

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

    def _listener(self, stream: Stream[Any], kind: str) -> Callable[[tuple[Any, ...]], None]:
        column = stream.fields.index("at")
        return lambda row: self._occurs(self.line_of(row[column]) == self.line, kind)

    def _occurs(self, holds: bool, kind: str = "") -> None:
        self.counts[kind] += holds
        if holds and self.counts[kind] == self.times:
            self._clock.at(self._clock.now, self.end)


def _nothing() -> None:
    """End nothing, before the run begins."""


def stop_of(settings: Mapping[str, object], clock: Clock, log: Log) -> Stop | None:
    """Return the condition of the settings, None if there is none."""
    names = ("event", "prints", "line")
    return Stop(settings, clock, log) if any(f"run.stop.{name}" in settings for name in names) else None
