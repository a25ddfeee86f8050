"""Counters of a polling loop: how many iterations that only count may be skipped.

Replaces: running every iteration of a polling loop in which a variable counts and decides nothing.

Hook: `Accelerators.counted`; `Site.skip` of mint/runtime/loop_skipping.py calls it if counters have moved.

Gain: 10² to 10⁵ times for a loop that counts while it polls (`poll_counter` of benchmarks/poll.py).

Held equal by: tests/mint/runtime/test_loop_skipping.py.
"""

from __future__ import annotations

from motionlang.lang.task import INFINITY

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

LARGEST = 2147483647  # Integer


def counted(counters: Sequence[float], steps: Sequence[float]) -> float:
    """How many iterations counters can advance before one is no integer in range."""
    if any(n != int(n) for n in (*counters, *steps)):
        return 0
    left = [(LARGEST - abs(n)) // abs(step) for n, step in zip(counters, steps, strict=True) if step]
    return min(left, default=INFINITY)
