"""The points at which a component of the engine may be replaced by a faster one.

The engine is complete without accelerators, and every accelerator gives the same result.
`motionlang.execution` reads the switch (`MOTIONLANG_FAST`, `fast=`) and passes them to a machine; no other
module knows which ones exist.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from motionlang.controller.axis import Axis


class Accelerators:
    """The accelerators of a machine, by the component that each replaces.

    None selects the component of the engine.

    * `axes(numbers)`: the axes of a controller
    * `scheduler(…)`: the scheduler of a run, called like `Scheduler`
    * `ranges(function)`: the variables of a Mint function whose ranges are known, and the ranges by node
    * `counted(counters, steps, levels)`: how many iterations of a loop with counters may be skipped
    * `registers(task)`: what knows the registers that the loops of an MCCL task count
    * `rounds(board)`: what skips rounds of several MCCL tasks, by its method `jumped(task)`
    * `servo(loop, plant, track, …)`: the simulated servo of an axis, called like `SpeculativeServo`
    * `switches(environment)`: what skips iterations of a Mint loop that switch outputs, by its method `skip`
    * `ticks(events)`: what runs the ticks of a Mint program's timer while all tasks wait, by its method `run`
    """

    __slots__ = (
        "axes",
        "counted",
        "ranges",
        "registers",
        "rounds",
        "scheduler",
        "servo",
        "switches",
        "ticks",
    )

    def __init__(
        self,
        *,
        axes: Callable[[Sequence[int]], Sequence[Axis]] | None = None,
        counted: Callable[[Sequence[float], Sequence[float], Sequence[Sequence[float]]], float] | None = None,
        ranges: Callable[[Any], tuple[set[Any], dict[int, Any]]] | None = None,
        registers: Callable[[Any], Any] | None = None,
        rounds: Callable[[Any], Any] | None = None,
        scheduler: Callable[..., Any] | None = None,
        servo: Callable[..., Any] | None = None,
        switches: Callable[[Any], Any] | None = None,
        ticks: Callable[[Any], Any] | None = None,
    ) -> None:
        self.axes, self.counted, self.ranges = axes, counted, ranges
        self.registers, self.switches = registers, switches
        self.rounds, self.scheduler, self.servo, self.ticks = rounds, scheduler, servo, ticks


NO_ACCELERATORS = Accelerators()
