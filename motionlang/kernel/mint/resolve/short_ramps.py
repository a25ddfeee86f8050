"""Ramps that are written shorter than one trajectory update, the usual mistake of seconds for milliseconds."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.structure import AxisKey, Statement

# One trajectory update, s: the profile is computed each millisecond.
UPDATE = 1e-3
RATES = ("accel", "decel")
# The ramp that a hint suggests instead, s.
USUAL = 0.2


def short_ramps(statements: Iterable[Statement]) -> Iterator[tuple[str, int, str]]:
    """Yield message, offset and hint for each literal ramp time, and rate that reaches SPEED, within one update.

    A rate is compared with the highest SPEED of its axis.
    """
    written = list(_settings(statements))
    speeds: dict[AxisKey, float | None] = {}  # the highest one; None if one of them is not known
    for row, axis, value, _ in written:
        if row.gives == "speed":
            before = speeds.get(axis, 0.0)
            speeds[axis] = None if value is None or before is None else max(value, before)
    reported: set[int] = set()
    for row, axis, value, at in written:
        speed = speeds.get(axis)
        if at in reported or row.gives not in RATES or not value or value < 0.0:
            continue
        if row.unit == "ms":
            ramp, seconds = f"a ramp of {value:.10g} ms", value / 1e3
            hint = f"{row.name} is in milliseconds: did you mean {value * 1e3:.10g}?"
        elif speed:
            ramp, seconds = f"a ramp of {speed / value * 1e3:.3g} ms to SPEED {speed:.10g}", speed / value
            hint = f"for a ramp of {USUAL * 1e3:.10g} ms write {speed / USUAL:.10g}"
        else:
            continue
        if 0.0 < seconds < UPDATE:
            reported.add(at)
            yield f"{ramp} is shorter than one trajectory update, {UPDATE * 1e3:.10g} ms", at, hint


def _settings(statements: Iterable[Statement]) -> Iterator[tuple[Keyword, AxisKey, float | None, int]]:
    """Yield each setting of a move: its row, axis, value and offset; None for a value that is not known."""
    for statement in statements:
        for use in statement.uses:
            if use.row is not None and use.role == "slot":
                yield from ((use.row, axis, use.number(k), use.at) for k, axis in enumerate(use.axes))
