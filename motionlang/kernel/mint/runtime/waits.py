"""The waits of a Mint program; the keywords and statements of `steps/waiting.py` make them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY, Clock
from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.lang.change_times import Dependencies
from motionlang.kernel.lang.waits import Condition, Wait
from motionlang.kernel.mint.runtime.task import MintTask

if TYPE_CHECKING:
    from motionlang.kernel.mint.runtime.errors import Errors


class Waits:
    """The waits that `Environment` offers."""

    acts: int
    dependencies: Dependencies
    clock: Clock
    controller: Controller
    settled: Callable[[int], bool] | None
    task: MintTask
    # The errors, if the program has a handler or reads them.
    _errors: Errors | None

    @property
    def has_errors(self) -> bool:
        """True if errors are recorded."""
        return self._errors is not None

    def space_wait(self, axes: tuple[int, ...]) -> Wait:
        """Return the wait of a move until the buffers of all its axes have space."""
        room = self.controller.room
        buffers = f"move buffer of axis {axes[0]}"
        if len(axes) > 1:
            names = [f"{axis} ({f'{room(axis)} free' if room(axis) > 0 else 'full'})" for axis in axes]
            buffers = f"move buffers of axes {', '.join(names)}"
        self.controller.log.note(self.clock.now, "buffer full", axes[0], text=f"space in the {buffers}")
        return Wait(
            self.clock.now,
            lambda: all(room(axis) > 0 for axis in axes),
            lambda: INFINITY,
            f"for space in the {buffers}",
            "axis",
            axes,
        )

    def pause(self, holds: Callable[[], object], why: str, axes: tuple[int, ...], ignores_data: bool) -> Wait:
        """Return the wait for a condition of PAUSE.

        `axes` are given if the condition only tests that these are at rest. `ignores_data`: no data of the program can
        end the wait.
        """
        self.acts += 1
        task, since = self.task, self.clock.now

        def test() -> object:
            running, self.task = self.task, task  # the condition may read the TIME of this task
            try:
                return holds()
            finally:
                self.task = running

        if axes and self.settled is None and not self.has_errors:
            return UntilRest(self, since, self.controller.end_of_moves(axes), test, why)
        return Condition(self.dependencies, test, since, why, ignores_data)


class UntilRest(Wait):
    """A wait until axes are at rest, which events report.

    If the program also requires settled axes, the condition is tested instead.
    """

    __slots__ = ("_built", "_environment", "_test", "end_of_moves")

    end_of_moves: Callable[[], float]

    cause = "condition"
    what = ()
    ends = None
    ignores_data = True

    def __init__(
        self,
        environment: Waits,
        since: float,
        end_of_moves: Callable[[], float],
        test: Callable[[], object],
        why: str,
    ) -> None:
        self.since, self.why, self._environment, self._test = since, why, environment, test
        self.end_of_moves = end_of_moves
        self._built: Wait | None = None

    def ready(self) -> bool:
        if self._environment.settled is not None:
            return self._condition().ready()
        return self.end_of_moves() < 0.0

    def due(self) -> float:
        return INFINITY if self._environment.settled is None else self._condition().due()

    def _condition(self) -> Wait:
        if self._built is None:
            self._built = Condition(self._environment.dependencies, self._test, self.since, self.why)
        return self._built
