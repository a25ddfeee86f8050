"""The linear step of a loop and a plant, as one matrix.

It is found by applying unit values to the step itself.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from motionlang.servo.discrete import discretise
from motionlang.servo.steps import MEMORY, empty_columns, stepper

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from motionlang.servo.loop import Loop
    from motionlang.servo.plant import Drive, Motor

    Array = NDArray[np.float64]


class Probe:
    """One step without limits, and the columns at its beginning.

    Both are matrices over (state, demand, feed-forward, 1). In `held`, the derivative is that of an earlier step.
    """

    def __init__(self, loop: Loop, plant: Motor | Drive, columns: tuple[str, ...]) -> None:
        run = stepper(loop, plant, columns, limited=False)
        names = discretise(plant, loop.period).names
        remembered, size = remembered_states(loop, names), len(names) + len(MEMORY)
        wait = size - len(MEMORY) + MEMORY.index("derivative_wait")

        def tried(values: Array, held: bool) -> tuple[Array, Array]:
            state = [0.0] * size
            for i, value in zip(remembered, values.tolist(), strict=False):
                state[i] = value
            state[wait] = float(held)
            made = empty_columns(columns)
            after = run([float(values[-3])], [float(values[-2])], tuple(state), made)
            return np.array([after[i] for i in remembered]), np.array([column[0] for column in made])

        self.sampled = _affine(tried, len(remembered), False)
        self.held = _affine(tried, len(remembered), True)


def _affine(tried: object, nz: int, held: bool) -> tuple[Array, Array]:
    assert callable(tried)
    zero = tried(np.zeros(nz + 3), held)
    found = [tried(unit, held) for unit in np.eye(nz + 3)[:-1]]
    after = np.array([each[0] - zero[0] for each in found] + [zero[0]]).T
    outputs = np.array([each[1] - zero[1] for each in found] + [zero[1]]).T
    return after, outputs


def remembered_states(loop: Loop, names: tuple[str, ...]) -> list[int]:
    """Return the indices of the states that the linear system needs."""
    memory = {
        "total": loop.has_integral,
        "last_error": bool(loop.derivative),
        "change": bool(loop.derivative) and loop.derivative_every > 1,
        "last_position": bool(loop.velocity_feedback),
    }
    return [*range(len(names)), *(len(names) + MEMORY.index(name) for name, used in memory.items() if used)]
