"""Ramps that are written shorter than one trajectory update, the usual mistake of seconds for milliseconds."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.structure import AxisKey, Statement
from motionlang.kernel.mint.resolve.problems import Problems

# One trajectory update, s: the profile is computed each millisecond.
UPDATE = 1e-3
RATES = ("accel", "decel")
# The ramp that a hint suggests instead, s.
USUAL = 0.2


def warn_of_short_ramps(statements: Collection[Statement], problems: Problems) -> None:
    """Warn of each literal ramp time, and of each rate that reaches SPEED, within one trajectory update."""
    written = list(_settings(statements))
    speeds: dict[AxisKey, float | None] = {}  # the highest one; None if one of them is not known
    for row, axis, value, _ in written:
        if row.gives == "speed":
            before = speeds.get(axis, 0.0)
            speeds[axis] = None if value is None or before is None else max(value, before)
    for row, axis, value, at in written:
        if row.gives not in RATES or not value or value < 0.0:
            continue
        if row.unit == "ms":
            _report(
                problems,
                at,
                f"a ramp of {value:.10g} ms",
                f"{row.name} is in milliseconds",
                value,
                value / 1e3,
            )
            continue
        speed = speeds.get(axis)
        if speed is None or speed / value >= UPDATE:
            continue
        hint = f"for a ramp of {USUAL * 1e3:.10g} ms write {speed / USUAL:.10g}"
        _report(
            problems,
            at,
            f"a ramp of {speed / value * 1e3:.3g} ms to SPEED {speed:.10g}",
            hint,
            0.0,
            speed / value,
        )


def _report(problems: Problems, at: int, ramp: str, hint: str, given: float, seconds: float) -> None:
    if not 0.0 < seconds < UPDATE:
        return
    meant = f": did you mean {given * 1e3:.10g}?" if given else ""
    message = f"{ramp} is shorter than one trajectory update, {UPDATE * 1e3:.10g} ms"
    problems.add("short-ramp", message, at, f"{hint}{meant}", "warning")
    problems.in_run.add(("short-ramp", at))


def _settings(statements: Iterable[Statement]) -> Iterator[tuple[Keyword, AxisKey, float | None, int]]:
    """Yield each setting of a move: its row, axis, value and offset; None for a value that is not known."""
    for statement in statements:
        for use in statement.uses:
            if use.row is not None and use.role == "slot":
                yield from ((use.row, axis, use.number(k), use.at) for k, axis in enumerate(use.axes))
