"""Who hears of what happens to the axes of a controller, and of what."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    Listener = Callable[[str, int], None]

# What there is to hear of. With the number of an axis: it has come to rest, has a fault, has one that was not pending
# before ("error"), its faults are cleared, it was switched on or off, has another scale, its home switch or a limit has
# changed, its buffer has room again. With the number of a latch, or the bits of an error of the controller itself: the
# last two.
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
    "latch",
    "misc",
)


class Listeners:
    """Calls in the order in which they are told, each with what it wants to hear of."""

    __slots__ = ("_calls", "of_rest")

    def __init__(self) -> None:
        self._calls: list[tuple[Listener, tuple[str, ...]]] = []
        # Whether anybody hears of axes that come to rest, which is what happens most.
        self.of_rest = False

    def __contains__(self, call: Listener) -> bool:
        return any(each == call for each, _ in self._calls)

    def append(self, call: Listener, *kinds: str) -> None:
        """Have `call(what, number)` hear of `kinds`, of everything where none are given."""
        self._set([*self._calls, (call, kinds or KINDS)])

    def put_first(self, call: Listener) -> None:
        """Have `call` hear of everything before the others do."""
        self._set([(call, KINDS), *self._calls])

    def remove(self, call: Listener) -> None:
        """End it; nothing where it has ended."""
        self._set([each for each in self._calls if each[0] != call])

    def tell(self, what: str, number: int) -> None:
        """Tell those who want to hear of it; one may leave while it is told."""
        for call, kinds in self._calls:
            if what in kinds:
                call(what, number)

    def _set(self, calls: list[tuple[Listener, tuple[str, ...]]]) -> None:
        self._calls = calls  # another list: telling goes on with those that there were
        self.of_rest = any("idle" in kinds for _, kinds in self._calls)
