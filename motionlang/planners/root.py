"""The root of a monotone function in a bracket, to the last bit of a float."""

from __future__ import annotations

from collections.abc import Callable

# More steps than a bisection of a bracket needs in practice.
MAX_STEPS = 200


def cubic_root(
    cubic: tuple[float, float, float, float], wanted: float, low: float, high: float, rising: bool
) -> float:
    """Return where a cubic, given by its coefficients from c0 on, is `wanted`.

    It is monotone in [low, high].
    """
    c0, c1, c2, c3 = cubic

    def off(x: float) -> tuple[float, float]:
        value = ((c3 * x + c2) * x + c1) * x + c0 if x != 0.0 else c0
        return value - wanted, (3.0 * c3 * x + 2.0 * c2) * x + c1 if c2 or c3 else c1

    return bracketed_root(off, low, high, rising)


def bracketed_root(f: Callable[[float], tuple[float, float]], low: float, high: float, rising: bool) -> float:
    """Return the zero of f in [low, high].

    f returns (value, slope) and is monotone, rising or falling. A Newton step is replaced by bisection if it
    leaves the bracket or fails to halve it, so the worst case is that of bisection.
    """
    x = 0.5 * (low + high)
    before = high - low
    for _ in range(MAX_STEPS):
        value, slope = f(x)
        if value == 0.0:
            return x
        if (value < 0.0) is rising:
            low = x
        else:
            high = x
        step = value / slope if slope != 0.0 else before
        following = x - step
        if abs(step) > 0.5 * before or not low < following < high:
            following = 0.5 * (low + high)
        if following == x or following in (low, high):
            return following
        before = abs(following - x)
        x = following
    return x
