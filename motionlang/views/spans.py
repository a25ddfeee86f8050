"""Time spans for pictures, in which spans and gaps are at least one pixel wide.

This holds as long as there is enough space. `visibleSpans` of the scope page (`scope/model.js`) does the same for
the visible window.
"""

from __future__ import annotations

from collections.abc import Iterable

# Begin and end.
Span = tuple[float, float]


def visible(spans: Iterable[Span], window: Span, pixel: float) -> list[Span]:
    """Return the `spans` in the `window`, in order, each at least `pixel` long.

    A gap shorter than a pixel is widened at the cost of the span before it, or of the span after it if that is
    too short. If both are too short, overlapping spans are merged.
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
