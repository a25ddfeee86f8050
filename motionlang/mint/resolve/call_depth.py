"""The maximum depth of nested calls, as far as the program text determines it."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.lang.nesting import MAX_DEPTH
from motionlang.mint.resolve.symbols import Function


def count_calls(functions: Sequence[Function], typed: bool) -> None:
    """Mark all functions as `counted` if calls may nest deeper than `MAX_DEPTH`.

    Other programs avoid the cost of counting. Calls may nest that deep if a function calls itself, directly or
    indirectly, or if a Gosub may lead to itself. At a prompt (`typed`) they always may, because later lines may
    add such calls.
    """
    callers: dict[Function, list[Function]] = {}
    unknown: dict[Function, int] = {}
    for function in functions:
        unknown[function] = len(function.calls) + function.gosubs  # a Gosub may lead to itself
        for callee in function.calls:
            callers.setdefault(callee, []).append(function)
    heights = dict.fromkeys(functions, 0)
    ready = [] if typed else [function for function, count in unknown.items() if not count]
    known = 0
    while ready:
        callee = ready.pop()
        known += 1
        for caller in callers.get(callee, ()):
            heights[caller] = max(heights[caller], heights[callee] + 1)
            unknown[caller] -= 1
            if not unknown[caller]:
                ready.append(caller)
    if known < len(functions) or max(heights.values()) > MAX_DEPTH:
        for function in functions:
            function.counted = True
