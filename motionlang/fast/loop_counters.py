"""Skip the iterations of a polling loop that only change its counters.

Replaces: running every iteration of a polling loop in which a variable counts. The variable may be compared with
constants only, and iterations are skipped only while all comparisons give the same result.

Hook: `Accelerators.counted`; `Site.skip` of mint/runtime/loop_skipping.py calls it if counters have changed.

Gain: 10² to 10⁵ times for a loop that counts while it polls (`poll_counter` of benchmarks/poll.py).

Equality is tested by: tests/mint/runtime/test_loop_skipping.py.
"""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.controller.clock import INFINITY

LARGEST = 2147483647  # Integer


def counted(
    counters: Sequence[float], steps: Sequence[float], levels: Sequence[Sequence[float]] = ()
) -> float:
    """Return how many iterations counters can advance before one passes a level.

    They also stop before a counter exceeds the range of 32-bit integers. `levels` are, for each counter, the constants
    that it is compared with. An iteration may compare the counter before or after it has counted.
    """
    if any(n != int(n) for n in (*counters, *steps)):
        return 0
    left = [(LARGEST - abs(n)) // abs(step) for n, step in zip(counters, steps, strict=True) if step]
    for n, step, compared in zip(counters, steps, levels, strict=False):
        for level in compared:
            distance = (level - n) * (1.0 if step > 0 else -1.0)
            if step and distance > 0:
                left.append(max(0, -(-distance // abs(step)) - 1))
            elif step and -distance <= abs(step):
                return 0  # the last iteration may have passed it
    return min(left, default=INFINITY)
