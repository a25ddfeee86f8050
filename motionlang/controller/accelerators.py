"""Where a run may be handed something faster in the place of a part of the engine.

The engine is complete without accelerators, and every accelerator gives the same result. `motionlang.execution` reads
the switch (`MOTIONLANG_FAST`, `fast=`) and hands them to a machine; nothing else knows which there are.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any


class Accelerators:
    """The accelerators of a machine, by the part of the engine that each replaces; None leaves that part as it is.

    * `scheduler(…)`: the scheduler of a run, called as `Scheduler` is
    * `ranges(function)`: the variables of a Mint function whose ranges are known, and the ranges by node
    * `loader(controller, axis, relative, command)`: loads a move about which nothing is special
    * `counted(counters, steps)`: how many iterations of a loop may be skipped in which variables count
    * `recurrence(machine, pace)`: finds the period of tasks that poll side by side
    * `servo(loop, plant, track, …)`: the simulated servo of an axis, called as `Ahead` is
    """

    __slots__ = ("counted", "loader", "ranges", "recurrence", "scheduler", "servo")

    def __init__(
        self,
        *,
        counted: Callable[[Sequence[float], Sequence[float]], float] | None = None,
        loader: Callable[..., Callable[[float, int], bool]] | None = None,
        ranges: Callable[[Any], tuple[set[Any], dict[int, Any]]] | None = None,
        recurrence: Callable[..., Any] | None = None,
        scheduler: Callable[..., Any] | None = None,
        servo: Callable[..., Any] | None = None,
    ) -> None:
        self.counted, self.loader, self.ranges = counted, loader, ranges
        self.recurrence, self.scheduler, self.servo = recurrence, scheduler, servo


NO_ACCELERATORS = Accelerators()
