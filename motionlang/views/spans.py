"""Spans of time as a picture can show them: none, and no gap between two, is narrower than a pixel if there is room.

`visibleSpans` of the scope page (`scope/model.js`) does the same, for the window that is looked at.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

# Begin and end.
Span = tuple[float, float]


def visible(spans: Iterable[Span], window: Span, pixel: float) -> list[Span]:
    """The `spans`, in order, that touch the `window`, each at least `pixel` long.

    A gap shorter than a pixel takes one from the span before it, or else from the span after it. Where neither has one
    to spare, spans that overlap become one.
    """
    first, last = window
    made: list[Span] = []
    for start, stop in spans:
        if stop < first or start > last:
            continue
        begin, end = max(start, first), min(stop, last)
        if end - begin < pixel:
            begin = min(begin, last - pixel)
            end = begin + pixel
        if made and begin - made[-1][1] < pixel:
            previous, gap = made[-1]
            if begin - previous >= 2.0 * pixel:
                made[-1] = previous, begin - pixel
            elif end - gap >= 2.0 * pixel:
                begin = gap + pixel
            elif begin <= gap:
                made[-1] = previous, max(gap, end)
                continue
        made.append((begin, end))
    return made
