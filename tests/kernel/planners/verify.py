"""An independent checker of profiles, which reads only their pieces."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from motionlang.kernel.planners import Plain, Profile

SMOOTH = frozenset({"sinusoidal", "scurve"})
"""Shapes that promise an acceleration without jumps."""


def verify(
    profile: Profile,
    *,
    speed: float | None = None,
    accel: float | None = None,
    decel: float | None = None,
    jerk: float | None = None,
    end: float | None = None,
    tolerance: float = 1e-9,
) -> list[str]:
    """Return every violation of a profile as one sentence; empty if there is none.

    Position and velocity must be continuous (the acceleration too if the shape promises it), the extrema of
    every piece within limits, and the end exact within tolerance. `accel` limits speeding up, `decel` slowing down.
    Tolerances are relative to the profile's own size. A start faster than `speed` is allowed until it has
    braked.
    """
    spans = [_Span(*item) for item in zip(profile.drawn[1], profile.knots, profile.knots[1:], strict=False)]
    scale = _scales(profile, spans)
    bounds = {"speed": speed, "acceleration": accel, "deceleration": decel, "jerk": jerk}
    return [
        *_knot_complaints(profile),
        *_joint_complaints(profile, spans, [s * tolerance for s in scale]),
        *_end_complaints(profile, spans, end, [s * tolerance for s in scale]),
        *_limit_complaints(profile, spans, bounds, tolerance),
    ]


class _Span:
    """A piece with its times, and its derivatives evaluated by NumPy."""

    def __init__(self, piece: Plain, begin: float, finish: float) -> None:
        self.begin = begin
        self.length = finish - begin if math.isfinite(finish) else 1.0
        self.poly = [np.polynomial.Polynomial(piece[:4]).deriv(order) for order in range(5)]
        self.amplitude, self.omega, self.phase = piece[4:]

    def value(self, order: int, x: float) -> float:
        wave = (
            self.amplitude * self.omega**order * math.sin(self.omega * x + self.phase + order * math.pi / 2)
        )
        return float(self.poly[order](x)) + wave

    def rounding(self, order: int) -> float:
        """Return how much rounding of the knot times can change derivative `order`."""
        return 4e-16 * (self.begin + self.length) * abs(self.value(order + 1, self.length))

    def extrema(self, order: int) -> list[float]:
        """Return both ends, and the inner times at which derivative `order` is zero."""
        roots = np.asarray(self.poly[order].roots(), dtype=np.complex128)
        found = [float(x.real) for x in roots if abs(x.imag) < 1e-12 * (1.0 + abs(x.real))]
        if self.amplitude:
            found = self._wave_extrema(order)
        return [0.0, *sorted(x for x in found if 0.0 < x < self.length), self.length]

    def _wave_extrema(self, order: int) -> list[float]:
        offset = -self.poly[order].coef[0] / (self.amplitude * self.omega**order)
        if abs(offset) > 1.0:
            return []
        angle = math.asin(offset)
        shift = self.phase + order * math.pi / 2
        angles = [b + 2 * math.pi * k for b in (angle, math.pi - angle) for k in range(-2, 3)]
        return [(a - shift) / self.omega for a in angles]


def _scales(profile: Profile, spans: list[_Span]) -> list[float]:
    ends = [profile.start, profile.end if math.isfinite(profile.end) else profile.start]
    return [
        max([abs(ends[0]), abs(ends[1]), *_sizes(spans, 0), 1e-300]),
        max([*_sizes(spans, 1), 1e-300]),
        max([*_sizes(spans, 2), 1e-300]),
    ]


def _sizes(spans: list[_Span], order: int) -> list[float]:
    return [abs(span.value(order, x)) for span in spans for x in span.extrema(order + 1)]


def _knot_complaints(profile: Profile) -> list[str]:
    pairs = pairwise(profile.knots)
    out = [f"the knots {a!r} and {b!r} are out of order" for a, b in pairs if not a < b]
    if profile.knots[0] != 0.0 or profile.knots[-1] != profile.duration:
        out.append("the knots do not span the duration")
    return out


def _joint_complaints(profile: Profile, spans: list[_Span], slack: list[float]) -> list[str]:
    smooth = profile.shape in SMOOTH
    names = ("position", "velocity", "acceleration")[: 3 if smooth else 2]
    out = []
    for left, right in pairwise(spans):
        for order, name in enumerate(names):
            jump = right.value(order, 0.0) - left.value(order, left.length)
            if not abs(jump) <= slack[order] + left.rounding(order):
                out.append(f"{name} jumps by {jump:g} at {right.begin:g} s")
    return out


def _end_complaints(profile: Profile, spans: list[_Span], end: float | None, slack: list[float]) -> list[str]:
    out = []
    if end is not None and not abs(profile.end - end) <= slack[0]:
        out.append(f"the profile ends at {profile.end!r}, not at {end!r}")
    if not spans:
        return out if profile.start == profile.end else [*out, "the profile is empty but has a distance"]
    promised = [(spans[0], 0.0, "starts", profile.start, profile.start_velocity)]
    if math.isfinite(profile.duration):
        promised.append((spans[-1], spans[-1].length, "ends", profile.end, profile.end_velocity))
    for span, x, verb, position, velocity in promised:
        if not abs(span.value(0, x) - position) <= slack[0]:
            out.append(f"the curve {verb} at {span.value(0, x)!r}, not at {position!r}")
        if not abs(span.value(1, x) - velocity) <= slack[1] + span.rounding(1):
            out.append(f"the curve {verb} with velocity {span.value(1, x)!r}, not {velocity!r}")
    return out


def _limit_complaints(
    profile: Profile, spans: list[_Span], bounds: dict[str, float | None], tolerance: float
) -> list[str]:
    peaks = {"speed": 0.0, "acceleration": 0.0, "deceleration": 0.0, "jerk": 0.0}
    excused = abs(profile.start_velocity)
    for span in spans:
        for x in span.extrema(2):
            peaks["speed"] = max(peaks["speed"], abs(span.value(1, x)) - span.rounding(1))
        for x in span.extrema(3):
            peaks["jerk"] = max(peaks["jerk"], abs(span.value(3, x)))
        _acceleration_peaks(span, peaks)
    out = []
    for name, bound in bounds.items():
        if bound is not None and not peaks[name] <= max(bound, excused * (name == "speed")) * (1 + tolerance):
            out.append(f"{name} reaches {peaks[name]!r}, above the limit {bound!r}")
    return out


def _acceleration_peaks(span: _Span, peaks: dict[str, float]) -> None:
    cuts = sorted({*span.extrema(1), *span.extrema(2), *span.extrema(3)})
    for a, b in pairwise(cuts):
        middle = 0.5 * (a + b)
        power = span.value(1, middle) * span.value(2, middle)
        name = "acceleration" if power > 0.0 else "deceleration"
        # Slivers are rounding: a wave's extremum is found to half the digits, so next to the knot it belongs
        # to, and a ramp that lasts microseconds late in a long move ends a little away from rest.
        near_rest = max(abs(span.value(1, a)), abs(span.value(1, b))) <= span.rounding(1)
        if power and b - a > 1e-7 * span.length and not near_rest:
            peak = max(abs(span.value(2, a)), abs(span.value(2, b)))
            peaks[name] = max(peaks[name], peak - span.rounding(2))
