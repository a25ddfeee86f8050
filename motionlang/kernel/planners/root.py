"""The root of a monotone function in a bracket, to the last bit of a float."""

from __future__ import annotations

from collections.abc import Callable


def bracketed_root(f: Callable[[float], tuple[float, float]], low: float, high: float, rising: bool) -> float:
    """Return the zero of f in [low, high].

    f returns (value, slope) and is monotone, rising or falling. A Newton step is replaced by bisection if it
    leaves the bracket or fails to halve it, so the worst case is that of bisection.
    """
    x = 0.5 * (low + high)
    before = high - low
    for _ in range(200):
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


def summit(value: Callable[[float], float], low: float, high: float) -> float:
    """Return the argument at which a function with one maximum is largest.

    The search is by golden section.
    """
    share = 0.6180339887498949
    a, b = high - share * (high - low), low + share * (high - low)
    y_a, y_b = value(a), value(b)
    for _ in range(34):
        if y_a > y_b:
            high, b, y_b = b, a, y_a
            a = high - share * (high - low)
            y_a = value(a)
        else:
            low, a, y_a = a, b, y_b
            b = low + share * (high - low)
            y_b = value(b)
    return a if y_a > y_b else b
