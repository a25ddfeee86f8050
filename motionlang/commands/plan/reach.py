"""Limits of trapezoidal moves: the peak of a short move, and impossible figures."""

from __future__ import annotations

from math import inf, sqrt

from motionlang.commands.plan.solve import NAMES, solve_move


def triangle(distance: float, speed: float, accel: float, decel: float) -> dict[str, float] | None:
    """Return all eight figures of a move too short to reach `speed`, or None."""
    if needed_distance(speed, accel, decel) <= distance:
        return None
    return solve_move(None, distance=distance, slew_time=0.0, accel=accel, decel=decel)


def needed_distance(speed: float, accel: float, decel: float) -> float:
    """Return the distance in which a move speeds up to `speed` and slows down again."""
    return 0.5 * speed * speed * (1.0 / accel + 1.0 / decel)


def remedies(rule: str | None, given: dict[str, float]) -> list[str]:
    """Return single changes that make an impossible move possible, as texts."""
    found = [f"{_word(name)} {value:.6g}" for name, value in _replaced(rule, given)]
    return found or _ranges(given)


def _replaced(rule: str | None, given: dict[str, float]) -> list[tuple[str, float]]:
    """Return each given figure that follows from the others, with the value required."""
    values = []
    for name in NAMES:
        if name in given:
            others = {each: value for each, value in given.items() if each != name}
            try:
                values.append((name, solve_move(rule, **others)[name]))
            except ValueError:
                continue
    return values


def _ranges(given: dict[str, float]) -> list[str]:
    """Return the bounds of the figures that limit each other, as texts."""
    distance, time, speed = (given.get(name, 0.0) for name in ("distance", "time", "speed"))
    if not (distance and time):
        return []
    if speed and not distance < speed * time <= 2.0 * distance * (1.0 + 1e-9):
        return [
            f"speed above {distance / time:.6g} and up to {2.0 * distance / time:.6g}",
            f"time above {distance / speed:.6g} and up to {2.0 * distance / speed:.6g}",
            f"distance from {0.5 * speed * time:.6g} to below {speed * time:.6g}",
        ]
    rates = given.get("accel", given.get("decel", inf)), given.get("decel", given.get("accel", inf))
    share = 1.0 / rates[0] + 1.0 / rates[1]
    if share and speed:
        ramps = 0.5 * speed * share
        changed = [_rates(given, ramps / (time - distance / speed))]
        if speed * ramps <= distance:
            changed.append(f"time {distance / speed + ramps:.6g}")
        return changed
    if share and time * time < 2.0 * distance * share:
        return [
            f"{_rates(given, 2.0 * distance * share / (time * time))} or more",
            f"time {sqrt(2.0 * distance * share):.6g} or more",
            f"distance {0.5 * time * time / share:.6g} or less",
        ]
    return []


def _rates(given: dict[str, float], factor: float) -> str:
    return " and ".join(f"{name} {given[name] * factor:.6g}" for name in ("accel", "decel") if name in given)


def _word(name: str) -> str:
    return name.replace("_", " ")
