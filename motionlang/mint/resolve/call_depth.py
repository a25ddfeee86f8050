"""How deep the calls of a program may nest, as far as its text says."""

from __future__ import annotations

from motionlang.lang.nesting import MAX_DEPTH

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.mint.resolve.symbols import Function


def count_calls(functions: Sequence[Function], typed: bool) -> None:
    """Mark all functions as `counted` if calls may nest deeper than `MAX_DEPTH`, so that only then it costs something.

    They may where a function calls itself, directly or not, where a Gosub may lead to itself, and at a prompt
    (`typed`), where later lines may do so.
    """
    heights: dict[Function, int] = {}
    waiting = {
        function: function.calls | {function} if function.gosubs else function.calls for function in functions
    }
    while waiting and not typed:
        leaves = [function for function, callees in waiting.items() if not callees - heights.keys()]
        if not leaves:
            break
        for function in leaves:
            heights[function] = 1 + max([heights[each] for each in waiting.pop(function)], default=-1)
    if waiting or max(heights.values()) > MAX_DEPTH:
        for function in functions:
            function.counted = True
