"""A controller that records the verbs a language calls."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from motionlang.kernel import Axis
from motionlang.kernel.controller import Clock, readers
from motionlang.kernel.controller.readers import NO_SUBSCRIBER
from motionlang.kernel.controller.settings import SETTINGS
from motionlang.kernel.controller.state import Listeners
from motionlang.kernel.controller.triggers.limit import Limit
from motionlang.kernel.log import Log
from tests.operations import OPERATIONS

if TYPE_CHECKING:
    from motionlang.kernel.controller.readers import Reader, Subscriber, Writer


class Recorder:
    """A controller without physics, which records every operation.

    Readings return values from `answers`. `calls` is a list of `(operation, argument, …)` tuples. It has a clock and
    axes with a scale, so that a language can run on it; nothing ever moves.
    """

    def __init__(self, axes: int = 8, first: int = 0, answers: dict[str, Any] | None = None) -> None:
        self.clock, self.log = Clock(), Log()
        self.axes = {number: Axis(number, self) for number in range(first, first + axes)}  # type: ignore[arg-type]
        self.listeners = Listeners()
        self.calls: list[tuple[Any, ...]] = []
        self.answers: dict[str, Any] = {
            "is_idle": True,
            "is_at_standstill": True,
            "master_of": None,
            "is_enabled": True,
            "room": 2,
            "moving": [],
            "settling": [],
            **(answers or {}),
        }

    def set_scale(self, axis: int, counts: float, rate: float = 1.0, zero: float = 0.0) -> None:
        """Record and apply the scale, which everything else needs."""
        self.calls.append(("set_scale", axis, counts, rate, zero))
        self.axes[axis].scale.set(counts, rate, zero)

    def run_by(self, tasks: object) -> None:
        """Take no note of the tasks: nothing answers them."""

    def add_limit(self, axis: int, sign: int, bit: int, action: str, physical: bool = False) -> Limit:
        """Return a limit that is never passed."""
        return Limit(self.axes[axis], sign, bit, action, physical)

    def reader(self, name: str, axis: int, unit: str = "", subscriber: Subscriber = NO_SUBSCRIBER) -> Reader:
        """Return a reader that records every reading."""
        a = self.axes[axis]
        if name in SETTINGS:
            return readers.setting(lambda _: self.setting(axis, name), a, unit)
        if unit == readers.POSITION:
            return lambda *level: a.scale.position_to_user(getattr(self, name)(axis))
        until = readers.passing(self, name, a, unit)  # type: ignore[arg-type]
        return readers.converted(lambda: getattr(self, name)(axis), a.scale, unit, subscriber, until)

    def writer(self, name: str, axis: int, unit: str = "") -> Writer:
        """Return a writer that records every setting, in counts."""
        scale = self.axes[axis].scale
        return lambda value: self.configure(axis, name, scale.to_counts(value, unit))

    def __getattr__(self, operation: str) -> Any:
        if operation not in OPERATIONS:
            raise AttributeError(operation)

        def record(*arguments: Any) -> Any:
            self.calls.append((operation, *arguments))
            return self.answers.get(operation, 0.0)

        return record
