"""The observers of what the program reads of the world."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

# It is called with the table of the machine file that can change the value, and the number of the value there.
ReadObserver = Callable[[str, int], object]


class ObservedPlace(Protocol):
    """Values that the program reads, such as the digital inputs."""

    # Called before a value is read; None without an observer.
    observer: ReadObserver | None
    # True if what is read is a number that knows its channel (`kernel/traced.py`).
    traces: bool


class ReadObservers:
    """The observers of a run, and the places that call them."""

    def __init__(self) -> None:
        self._places: list[ObservedPlace] = []
        self._observers: list[ReadObserver] = []
        # What the places call.
        self._called: ReadObserver | None = None
        # True if the places return traced numbers.
        self.traces = False

    def join(self, place: ObservedPlace) -> None:
        """Let a place call the observers of now and later."""
        self._places.append(place)
        place.observer, place.traces = self._called, self.traces

    def add(self, observer: ReadObserver) -> None:
        """Call an observer with each value that the program reads from now on, before the others."""
        self._observers.insert(0, observer)
        self._call(observer if len(self._observers) == 1 else self._call_all)

    def trace(self) -> None:
        """Let all places return traced numbers from now on."""
        self.traces = True
        for place in self._places:
            place.traces = True

    def replaced(self, observer: ReadObserver | None = None) -> ReplacedObservers:
        """Return a block in which only `observer` is called, if any, since not the program reads there."""
        return ReplacedObservers(self._call, self._called, observer)

    def _call_all(self, table: str, number: int) -> None:
        for each in self._observers:
            each(table, number)

    def _call(self, observer: ReadObserver | None) -> None:
        self._called = observer
        for place in self._places:
            place.observer = observer


class ReplacedObservers:
    """A block in which places call another observer."""

    __slots__ = ("_before", "_call", "_observer")

    def __init__(
        self,
        call: Callable[[ReadObserver | None], None],
        before: ReadObserver | None,
        observer: ReadObserver | None,
    ) -> None:
        self._call, self._before, self._observer = call, before, observer

    def __enter__(self) -> None:
        self._call(self._observer)

    def __exit__(self, *_: object) -> None:
        self._call(self._before)
