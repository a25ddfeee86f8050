"""Ramps that are written shorter than one trajectory update, the usual mistake of seconds for milliseconds."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import zip_longest

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.keywords import units
from motionlang.kernel.mint.resolve.problems import Problems
from motionlang.kernel.mint.syntax.nodes import Assign, Expr, Module, Name, Number
from motionlang.kernel.mint.syntax.traversal import names_of, walk

# One trajectory update, s: the profile is computed each millisecond.
UPDATE = 1e-3
RATES = ("accel", "decel")
# The ramp that a hint suggests instead, s.
USUAL = 0.2


def warn_of_short_ramps(module: Module, problems: Problems) -> None:
    """Warn of each literal ramp time, and of each rate that reaches SPEED, within one trajectory update."""
    written = list(_settings(module))
    speeds: dict[int | None, list[float | None]] = {}
    for row, axis, value, _ in written:
        if row.gives == "speed":
            speeds.setdefault(axis, []).append(value)
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
        known = speeds.get(axis, [None])
        if None in known:
            continue
        speed = max(each for each in known if each is not None)
        if speed / value >= UPDATE or _has_units(module):
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


def _settings(module: Module) -> Iterator[tuple[Keyword, int | None, float | None, int]]:
    """Yield each setting of an axis: its row, axis, value and position; None for what is not literal."""
    for node in walk(module.everything):
        if not isinstance(node, Assign) or not isinstance(node.target, Name) or not node.values:
            continue
        row = node.target.row
        if row is None or not row.gives:
            continue
        axes: list[Expr | None] = list(node.target.args) if node.target.args else [None]
        for axis, value in zip_longest(axes, node.values[: len(axes)], fillvalue=node.values[-1]):
            number = _literal(axis)
            yield row, None if number is None else int(number), _literal(value), node.target.start


def _has_units(module: Module) -> bool:
    """True if speeds or rates have units of their own, so that their quotient is no time."""
    rows = {row.name for row in units.ROWS if not row.effect}
    return any(row is not None and row.name in rows for row in (name.row for name in names_of(module)))


def _literal(node: Expr | None) -> float | None:
    if isinstance(node, Number):
        return node.value
    value = node.symbol.const if isinstance(node, Name) and node.symbol is not None else None
    return value if isinstance(value, (int, float)) else None
