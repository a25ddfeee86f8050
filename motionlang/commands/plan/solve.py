"""Solver of AN00115: enough consistent figures of a move determine all eight.

distance = (accel_time/2 + slew_time + decel_time/2) speed, time = accel_time + slew_time + decel_time, speed
= accel accel_time = decel decel_time. A rule supplies what the figures leave open.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf, isnan, sqrt

NAMES = ("distance", "time", "accel_time", "slew_time", "decel_time", "speed", "accel", "decel")
# Share of the total time for the acceleration and for the deceleration. For "equal" T_a = T_d, with any share.
RULES = {"third": 1.0 / 3.0, "quarter": 1.0 / 4.0, "equal": 0.0}
_TOO_LARGE = 1e300  # leaves sums and small multiples finite


Figures = dict[str, float]
Step = Callable[[Figures], float | None]


class Underdetermined(ValueError):
    """Raised if the given figures do not determine the move."""


def solve_move(rule: str | None = None, **given: float | None) -> dict[str, float]:
    """Return all eight figures of a trapezoidal move from rest, from the given ones.

    The given ones are any of `NAMES`; None means unknown. `rule` "third", "quarter" or "equal" splits the time if
    nothing else does. Figures are magnitudes, in any length unit and seconds. Raises ValueError with the
    missing figures, or the two that contradict each other.
    """
    figures = {name: float(value) for name, value in given.items() if value is not None}
    _check(figures, rule)
    known = dict(figures)
    while _deduce(known):
        pass
    _possible(known)
    if rule and len(known) < len(NAMES):
        _apply_rule(known, rule)
        while _deduce(known):
            pass
    missing = [name.replace("_", " ") for name in NAMES if name not in known]
    if missing:
        raise Underdetermined(f"not enough is known: {', '.join(missing)} cannot be determined")
    for name in NAMES:
        if known[name] == inf:
            raise ValueError(f"no number is large enough for the {name.replace('_', ' ')}")
    _agree(known, figures)
    return {name: known[name] for name in NAMES}


def _check(figures: Figures, rule: str | None) -> None:
    for name, value in figures.items():
        if name not in NAMES:
            raise ValueError(f"a move has no figure called {name}")
        word = name.replace("_", " ")
        if isnan(value):
            raise ValueError(f"{word} is not a number")
        if value < 0.0 or (value == 0.0 and name != "slew_time"):
            raise ValueError(
                f"{word} must be {'zero or more' if name == 'slew_time' else 'greater than zero'}"
            )
        if value >= _TOO_LARGE:
            raise ValueError(f"{word} must be less than {_TOO_LARGE:g}")
    if rule is not None and rule not in RULES:
        raise ValueError(f"there is no rule called {rule}: third, quarter or equal")


def _possible(known: Figures) -> None:
    share = known.get("slew_time", 0.0) / known.get("time", inf)
    # Known ramps may be so short that their time rounds to nothing beside the slew.
    if not -1e-9 <= share <= 1.0 or (share == 1.0 and "accel_time" not in known):
        raise ValueError("contradiction: the distance does not fit the speed and the time")


def _apply_rule(known: Figures, rule: str) -> None:
    if rule == "equal":
        if "time" not in known or "slew_time" not in known:
            raise ValueError("equal ramps need distance, speed and time")
        known["accel_time"] = known["decel_time"] = 0.5 * (known["time"] - known["slew_time"])
        return
    share = RULES[rule]
    if "time" not in known and "distance" in known and "speed" in known:
        known["time"] = known["distance"] / (known["speed"] * (1.0 - share))
    if "time" not in known:
        raise ValueError("a rule splits the time of the move: give the time, or distance and speed")
    for name in ("accel_time", "decel_time"):
        known.setdefault(name, known["time"] * share)


def _deduce(known: Figures) -> bool:
    """Add one figure that follows from the known ones; False if none follows.

    Raises ValueError if it would have to be zero or negative; only the slew time may be zero, and is checked later.
    """
    for name, needs, step in _STEPS:
        if name not in known and all(need in known for need in needs):
            value = step(known)
            if value is not None:
                if value <= 0.0 and name != "slew_time":
                    words = name.replace("_", " ")
                    raise ValueError(f"contradiction: the {words} would have to be {value:g}")
                known[name] = value
                return True
    return False


def _speed_in_time(k: Figures) -> float | None:
    """Compute the speed from distance and time: v (T - t/2) - h v^2 = D, lower root."""
    h, t = _ramps(k)
    reach = k["time"] - 0.5 * t
    under = reach * reach - 4.0 * h * k["distance"]
    if reach <= 0.0 or under < -1e-12 * reach * reach:
        raise ValueError("contradiction: with these ramps the distance cannot be covered in the time")
    return 2.0 * k["distance"] / (reach + sqrt(max(under, 0.0)))


def _speed_with_slew(k: Figures) -> float | None:
    """Compute the speed from distance and slew time: v (T_s + t/2) + h v^2 = D."""
    h, t = _ramps(k)
    hold = k["slew_time"] + 0.5 * t
    return 2.0 * k["distance"] / (hold + sqrt(hold * hold + 4.0 * h * k["distance"]))


def _speed_of_times(k: Figures) -> float | None:
    """Compute the speed from the total time and the slew time: T = T_s + t + 2 h v."""
    h, t = _ramps(k)
    left = k["time"] - k["slew_time"] - t
    return 0.5 * left / h if h else None


def _ramps(k: Figures) -> tuple[float, float]:
    """Return h and t of the ramps.

    Ramps given by their rates cover h v^2 in the time 2 h v; ramps given by their times last t together.
    """
    h = t = 0.0
    for time, rate in (("accel_time", "accel"), ("decel_time", "decel")):
        if time in k:
            t += k[time]
        else:
            h += 0.5 / k[rate]
    return h, t


_RAMPS = ("accel_time", "decel_time")
_STEPS: tuple[tuple[str, tuple[str, ...], Step], ...] = (
    ("accel", ("speed", "accel_time"), lambda k: k["speed"] / k["accel_time"]),
    ("decel", ("speed", "decel_time"), lambda k: k["speed"] / k["decel_time"]),
    ("accel_time", ("speed", "accel"), lambda k: k["speed"] / k["accel"]),
    ("decel_time", ("speed", "decel"), lambda k: k["speed"] / k["decel"]),
    ("speed", ("accel", "accel_time"), lambda k: k["accel"] * k["accel_time"]),
    ("speed", ("decel", "decel_time"), lambda k: k["decel"] * k["decel_time"]),
    ("time", (*_RAMPS, "slew_time"), lambda k: k["accel_time"] + k["slew_time"] + k["decel_time"]),
    ("slew_time", ("time", *_RAMPS), lambda k: k["time"] - k["accel_time"] - k["decel_time"]),
    (
        "accel_time",
        ("time", "slew_time", "decel_time"),
        lambda k: k["time"] - k["slew_time"] - k["decel_time"],
    ),
    (
        "decel_time",
        ("time", "slew_time", "accel_time"),
        lambda k: k["time"] - k["slew_time"] - k["accel_time"],
    ),
    ("speed", ("distance", "time", "slew_time"), lambda k: 2 * k["distance"] / (k["time"] + k["slew_time"])),
    ("distance", ("speed", "time", "slew_time"), lambda k: 0.5 * k["speed"] * (k["time"] + k["slew_time"])),
    ("slew_time", ("distance", "speed", "time"), lambda k: 2 * k["distance"] / k["speed"] - k["time"]),
    ("time", ("distance", "speed", "slew_time"), lambda k: 2 * k["distance"] / k["speed"] - k["slew_time"]),
    (
        "slew_time",
        ("distance", "speed", *_RAMPS),
        lambda k: k["distance"] / k["speed"] - 0.5 * (k["accel_time"] + k["decel_time"]),
    ),
    *(
        ("speed", (*known, up, down), step)
        for up in ("accel_time", "accel")
        for down in ("decel_time", "decel")
        for known, step in (
            (("distance", "time"), _speed_in_time),
            (("distance", "slew_time"), _speed_with_slew),
            (("time", "slew_time"), _speed_of_times),
        )
    ),
)


def _agree(known: Figures, given: Figures) -> None:
    """Raise ValueError unless all eight figures describe one move."""
    if known["slew_time"] < -1e-9 * known["time"]:
        raise ValueError("contradiction: the ramps alone take longer than the move, or go further")
    known["slew_time"] = max(known["slew_time"], 0.0)
    k = known
    statements = (
        ("distance", k["speed"] * (0.5 * k["accel_time"] + k["slew_time"] + 0.5 * k["decel_time"])),
        ("time", k["accel_time"] + k["slew_time"] + k["decel_time"]),
        ("accel", k["speed"] / k["accel_time"]),
        ("decel", k["speed"] / k["decel_time"]),
    )
    for name, value in statements:
        if abs(k[name] - value) > 1e-6 * abs(value):
            origin = "given" if name in given else "deduced"
            raise ValueError(f"contradiction: {name} {k[name]:g} ({origin}) against {value:g} from the rest")
