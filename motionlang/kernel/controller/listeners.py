"""Subscribers to changes of the axes of a controller."""

from __future__ import annotations

from collections.abc import Callable

Listener = Callable[[str, int], None]

# The kinds of changes. With the number of an axis: it has come to rest, has a fault, has one that was not
# pending before ("error"), its faults are cleared, it was enabled or disabled, has another scale, its home
# switch or a limit has changed, its buffer has room again, its move holds because its speed is 0. With the
# bits of an error of the controller itself: the last one ("misc").
KINDS = (
    "idle",
    "fault",
    "error",
    "cleared",
    "switched",
    "scale",
    "home",
    "limit",
    "buffer-low",
    "held",
    "misc",
)


class Listeners:
    """The subscribers in order of notification, each with the kinds it wants."""

    def __init__(self) -> None:
        self._calls: list[tuple[Listener, tuple[str, ...]]] = []

    def __contains__(self, call: Listener) -> bool:
        return any(each == call for each, _ in self._calls)

    def append(self, call: Listener, *kinds: str) -> None:
        """Call `call(what, number)` for the given kinds, or for all."""
        self._set([*self._calls, (call, kinds or KINDS)])

    def put_first(self, call: Listener) -> None:
        """Call `call` for every kind, before all others."""
        self._set([(call, KINDS), *self._calls])

    def remove(self, call: Listener) -> None:
        """End a subscription; a no-op if it has ended."""
        self._set([each for each in self._calls if each[0] != call])

    def notify(self, what: str, number: int) -> None:
        """Notify the subscribers of a kind; they may unsubscribe meanwhile."""
        for call, kinds in self._calls:
            if what in kinds:
                call(what, number)

    def _set(self, calls: list[tuple[Listener, tuple[str, ...]]]) -> None:
        self._calls = calls  # a new list, so that a notification in progress uses the old one
