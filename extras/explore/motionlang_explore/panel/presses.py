"""The buttons that hands are on: a button is down as long as a page says that it presses it."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable
from time import monotonic
from typing import NamedTuple

# A page repeats what it presses every 0.5 s; without that it presses nothing any more, s.
PATIENCE = 1.5


class PagePresses(NamedTuple):
    """The inputs that a page presses, by its last message, until a real time."""

    message: int = -1
    numbers: frozenset[int] = frozenset()
    until: float = 0.0


class Presses:
    """The inputs that any page presses; `changed` is called with each that goes down or comes up, in order."""

    def __init__(
        self, changed: Callable[[int, bool], object], clock: Callable[[], float] = monotonic
    ) -> None:
        self._changed, self._clock = changed, clock
        self._pages: dict[str, PagePresses] = {}
        self._lock = threading.Lock()

    @property
    def down(self) -> set[int]:
        """The inputs that are pressed."""
        return {number for each in self._pages.copy().values() for number in each.numbers}

    def put(self, page: str, message: int, numbers: Iterable[int]) -> None:
        """Take note of all that a page presses, unless a later message of it has come already."""
        with self._lock:
            if message > self._pages.get(page, PagePresses()).message:
                self._set(page, PagePresses(message, frozenset(numbers), self._clock() + PATIENCE))

    def gone(self, page: str) -> None:
        """Release all that a page presses."""
        with self._lock:
            if page in self._pages:
                self._set(page, PagePresses(self._pages[page].message))

    def expire(self) -> None:
        """Release what is pressed by pages that have not repeated it."""
        for page, each in self._pages.copy().items():
            if each.numbers and each.until < self._clock():
                self.gone(page)

    def _set(self, page: str, presses: PagePresses) -> None:
        before = self.down
        self._pages[page] = presses
        for number in sorted(before ^ self.down):
            self._changed(number, number not in before)
