"""The points at which a component of the engine can be replaced by a faster one.

The engine is complete without accelerators, and gives the same results with them. `motionlang.execution`
reads the switch (`MOTIONLANG_FAST`, `fast=`) and passes the accelerators to a machine; no other module
knows which ones exist.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from motionlang.controller.axis import Axis


class Accelerators:
    """The accelerators of a machine, named after the components that they replace.

    None selects the engine's own component.

    * `axes(numbers)`: creates the axes of a controller
    * `scheduler(…)`: creates the scheduler of a run, called like `Scheduler`
    * `ranges(function)`: returns the variables of a Mint function with known ranges, and the ranges by node
    * `counted(counters, steps, levels)`: returns how many iterations of a loop with counters can be skipped
    * `servo(loop, plant, track, …)`: creates the simulated servo of an axis, called like `SpeculativeServo`
    * `switches(environment)`: creates the object that skips iterations of a Mint loop that switch outputs, by its
      method `skip`
    """

    def __init__(
        self,
        *,
        axes: Callable[[Sequence[int]], Sequence[Axis]] | None = None,
        counted: Callable[[Sequence[float], Sequence[float], Sequence[Sequence[float]]], float] | None = None,
        ranges: Callable[[Any], tuple[set[Any], dict[int, Any]]] | None = None,
        scheduler: Callable[..., Any] | None = None,
        servo: Callable[..., Any] | None = None,
        switches: Callable[[Any], Any] | None = None,
    ) -> None:
        self.axes, self.counted, self.ranges = axes, counted, ranges
        self.switches, self.scheduler, self.servo = switches, scheduler, servo


NO_ACCELERATORS = Accelerators()
