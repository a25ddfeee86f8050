"""Objectives and conditions: numeric expressions over the figures of a variant.

Examples are `time + 0.1 * peak.0` and `peak.0 < 400`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import inf

from motionlang.commands.expressions import Expression, Value, WrongExpression

_FUNCTIONS: dict[str, Callable[..., Value]] = {"abs": abs, "min": min, "max": max}
_EXAMPLE = "time + 0.1 * peak.0, or peak.0 < 400"


class QuantityExpression(Expression):
    """An expression over names such as `time`, `accel` and `axis.0.plant.inertia`; raises ValueError."""

    def __init__(self, text: str) -> None:
        try:
            super().__init__(text, _EXAMPLE, r"cycle\([^()]*\)(?:\.\w+)?|")
            wrong = self.called - _FUNCTIONS.keys()
        except WrongExpression as error:
            raise ValueError(f"{text!r} is not an expression such as {_EXAMPLE}") from error
        if wrong:
            raise ValueError(f"{text!r} is not an expression such as {_EXAMPLE}")

    def __call__(self, values: Mapping[str, object]) -> Value | None:
        """Return its value; None for a missing value, a division by zero and the like."""

        def read(name: str, arguments: list[Value]) -> Value:
            found = _FUNCTIONS[name](*arguments) if arguments else values[name]
            if found is None:
                raise LookupError(name)
            return found  # type: ignore[return-value]

        try:
            return self.value(read)
        except (TypeError, ValueError, LookupError):
            return None

    def number(self, values: Mapping[str, object]) -> float | None:
        """Return its value if that is a finite number; None if it is not."""
        found = self(values)
        return found if isinstance(found, (int, float)) and abs(found) < inf else None


def pareto(costs: list[tuple[float, ...]]) -> list[int]:
    """Return the indices of the Pareto front, in order of the first cost."""
    order = sorted(range(len(costs)), key=lambda n: (costs[n], n))
    if costs and len(costs[0]) == 2:
        front, least = [], inf
        for n in order:
            if costs[n][1] < least:
                front.append(n)
                least = costs[n][1]
        return front
    front = []
    for n in order:
        if not any(all(a <= b for a, b in zip(costs[m], costs[n], strict=True)) for m in front):
            front.append(n)
    return front
