"""A planned move: its eight figures, and the program for it in either language."""

from __future__ import annotations

from collections.abc import Callable

from motionlang.commands.plan.reach import triangle
from motionlang.commands.plan.solve import NAMES, solve_move


class Plan:
    """A trapezoidal move from rest to rest, from `motionlang.plan`.

    `distance` is in user units (uu), `time`, `accel_time`, `slew_time` and `decel_time` are seconds, `speed`
    is uu/s, `accel` and `decel` are uu/s². `commanded_speed` exceeds `speed` if the move is too short to
    reach it.
    """

    distance: float
    time: float
    accel_time: float
    slew_time: float
    decel_time: float
    speed: float
    accel: float
    decel: float

    def __init__(self, figures: dict[str, float], wanted: dict[str, float]) -> None:
        for name in NAMES:
            setattr(self, name, figures[name])
        self._wanted = wanted
        self.commanded_speed = wanted.get("speed", self.speed)

    def figures(self) -> dict[str, float]:
        """Return the eight figures by name."""
        return {name: getattr(self, name) for name in NAMES}

    def program(
        self, dialect: str = "mint", *, axis: int | None = None, scale: float = 1.0, use_times: bool = False
    ) -> str:
        """Return the program of the move in "mint" or "mccl".

        Raises ValueError for another language. `axis` is by default the first axis of the language, `scale`
        the counts per user unit. With `use_times` a Mint program sets ACCELTIME and DECELTIME instead of
        rates.
        """
        if dialect not in WRITERS:
            raise ValueError(f"there is no dialect {dialect!r}: {' or '.join(WRITERS)}")
        first = 0 if dialect == "mint" else 1
        if axis is not None and axis < first:
            raise ValueError(f"there is no axis {axis}: {dialect} counts from {first}")
        return WRITERS[dialect](self.figures() | self._wanted, scale, axis, use_times)

    def __repr__(self) -> str:
        return f"<Plan: {', '.join(f'{name}={getattr(self, name):.6g}' for name in NAMES)}>"


def plan(
    *,
    rule: str | None = None,
    distance: float | None = None,
    time: float | None = None,
    accel_time: float | None = None,
    slew_time: float | None = None,
    decel_time: float | None = None,
    speed: float | None = None,
    accel: float | None = None,
    decel: float | None = None,
) -> Plan:
    """Compute the missing figures of a trapezoidal move from rest to rest.

    Any figures that determine the move will do; `rule` "third", "quarter" or "equal" splits the time if they
    leave it free. Distances are user units (uu), times seconds, speeds uu/s, rates uu/s². A negative distance
    is a move in the other direction. Raises ValueError with the missing figures, the two that contradict each
    other, or the available rules.
    """
    given = {
        name: float(value)
        for name, value in (
            ("distance", distance),
            ("time", time),
            ("accel_time", accel_time),
            ("slew_time", slew_time),
            ("decel_time", decel_time),
            ("speed", speed),
            ("accel", accel),
            ("decel", decel),
        )
        if value is not None
    }
    backwards = given.get("distance", 0.0) < 0.0
    if backwards:
        given["distance"] = -given["distance"]
    figures, _, wanted = solve_plan(given, rule)
    if backwards:
        figures["distance"] = -figures["distance"]
    return Plan(figures, wanted)


def solve_plan(
    given: dict[str, float], rule: str | None
) -> tuple[dict[str, float], set[str], dict[str, float]]:
    """Return all figures, the mirrored ones, and the request if the move is too short.

    A mirrored figure is copied from its counterpart.
    """
    short = _too_short(given)
    if short is not None:
        return short
    try:
        return solve_move(rule, **given), set(), {}
    except ValueError as first:
        problem = first
        for one, other in (("accel", "decel"), ("accel_time", "decel_time")):
            if (one in given) != (other in given) and rule is None:
                missing = other if one in given else one
                full = {**given, missing: given[one if one in given else other]}
                try:
                    return solve_move(None, **full), {missing}, {}
                except ValueError as contradiction:
                    problem = contradiction
        raise problem from None


def _too_short(
    given: dict[str, float],
) -> tuple[dict[str, float], set[str], dict[str, float]] | None:
    """Return the result for a move too short for its speed and ramps, or None."""
    rates = {}
    for rate, time in (("accel", "accel_time"), ("decel", "decel_time")):
        if (rate in given) == (time in given):
            continue
        value = given[rate if rate in given else time]
        if value > 0.0 and given.get("speed", 0.0) > 0.0:
            rates[rate] = value if rate in given else given["speed"] / value
    ramps = {"accel", "decel", "accel_time", "decel_time"} & set(given)
    if not rates or len(ramps) != len(rates) or set(given) - ramps != {"distance", "speed"}:
        return None
    assumed = {"accel", "decel"} - set(rates)
    accel, decel = (rates.get(name, next(iter(rates.values()))) for name in ("accel", "decel"))
    speed = given["speed"]
    try:
        move = triangle(given["distance"], speed, accel, decel)
    except (ValueError, OverflowError, ZeroDivisionError):
        return None
    if move is None:
        return None
    return move, assumed, {"speed": speed, "accel_time": speed / accel, "decel_time": speed / decel}


def _mint(move: dict[str, float], scale: float, axis: int | None, by_times: bool) -> str:
    n = axis or 0
    lines = [f"SCALE({n}) = {number(scale)}"] if scale != 1.0 else []
    lines.append(f"SPEED({n}) = {number(move['speed'])}")
    for rate, time in (("accel", "accel_time"), ("decel", "decel_time")):
        word, value = (rate, move[rate]) if not by_times else (rate + "time", 1000.0 * move[time])
        lines.append(f"{word.upper()}({n}) = {number(value)}")
    lines += [f"MOVER({n}) = {number(move['distance'])}", f"GO({n})"]
    return "\n".join(lines) + "\n"


def _mccl(move: dict[str, float], scale: float, axis: int | None, by_times: bool) -> str:
    """Return the move in MCCL, which has rates only.

    A scale takes effect at the next MN.
    """
    n = 1 if axis is None else axis
    lines = [f"{n}US{number(scale)}"] if scale != 1.0 else []
    lines += [
        f"{n}MN,{n}PM,{n}PT",
        f"{n}SV{number(move['speed'])},{n}SA{number(move['accel'])},{n}DS{number(move['decel'])}",
        f"{n}MR{number(move['distance'])},{n}WS0",
    ]
    return "\n".join(lines) + "\n"


WRITERS: dict[str, Callable[[dict[str, float], float, int | None, bool], str]] = {
    "mint": _mint,
    "mccl": _mccl,
}


def number(value: float) -> str:
    """Return a figure in the notation of both languages, without an exponent.

    It has at most 10 significant digits.
    """
    text = f"{value:.10g}"
    return f"{value:.12f}".rstrip("0").rstrip(".") if "e" in text else text
