"""Check whether a load that is held only by friction slips.

Such a load cannot follow an acceleration beyond mu g (chapter 12). A profile is checked exactly, piece by piece. A
servo trace is checked sample by sample and the slip is simulated: the load's velocity follows the motor's no faster
than the friction allows.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import asin, pi
from typing import TYPE_CHECKING

from motionlang.kernel.planners import Plain, Profile, acceleration_in, check_positive, crest_points
from tests.lab.notes.vendor.dissect import slip_acceleration

if TYPE_CHECKING:
    from motionlang.kernel.servo import ServoTrace


@dataclass(frozen=True, slots=True)
class Slip:
    """The accelerations `limit` and `peak`, and the `spans` (s) of slip.

    `distance` is the distance that the load slipped, if it was simulated.
    """

    limit: float
    peak: float
    peak_time: float
    spans: tuple[tuple[float, float], ...]
    distance: float = 0.0

    @property
    def slips(self) -> bool:
        """True if the load slips."""
        return bool(self.spans)

    @property
    def margin(self) -> float:
        """The fraction of the limit left at the peak; negative if the load slips."""
        return 1.0 - self.peak / self.limit


# An acceleration planned at exactly the limit does not exceed it.
_EPSILON = 1e-9


def check_profile(profile: Profile, friction: float, gravity: float, scale: float = 1.0) -> Slip:
    """Check one planned profile, which has pieces.

    `scale` is counts (the length unit of the profile) per length unit of `gravity`.

    >>> from motionlang.kernel.planners import plan_trapezoid
    >>> found = check_profile(plan_trapezoid(0.0, 0.5, 0.8, 2.6, 2.6), 0.25, 9.81)
    >>> found.slips, found.limit, round(found.margin, 3)
    (True, 2.4525, -0.06)
    """
    limit = slip_acceleration(friction, gravity)
    check_positive(scale=scale)
    most = limit * scale * (1.0 + _EPSILON)
    spans: list[tuple[float, float]] = []
    peak = peak_time = 0.0
    for piece, begin, end in zip(profile.drawn[1], profile.knots, profile.knots[1:], strict=False):
        length = end - begin
        for x in (0.0, *crest_points(piece, length), length):
            value = abs(acceleration_in(piece, x))
            if value > peak * (1.0 + 1e-12):
                peak, peak_time = value, begin + x
        spans += [(begin + a, begin + b) for a, b in _beyond(piece, length, most)]
    return Slip(limit, peak / scale, peak_time, tuple(_joined(spans)))


def check_trace(trace: ServoTrace, friction: float, gravity: float, scale: float = 1.0) -> Slip:
    """Check the motion of a simulated motor, and simulate the slip of its load.

    >>> from tests.lab.notes.vendor.dac_override import demonstrate
    >>> free, held, *_ = demonstrate()
    >>> [check_trace(run.trace, 0.1, 32.2, 60_000.0).slips for run in (free, held)]
    [True, False]
    """
    limit = slip_acceleration(friction, gravity)
    check_positive(scale=scale)
    if not len(trace):
        return Slip(limit, 0.0, 0.0, ())
    most, period = limit * scale * (1.0 + _EPSILON), trace.loop.period
    sizes = abs(trace.acceleration)
    peak = int(sizes.argmax())
    spans = [(i * period, (i + 1) * period) for i in (sizes > most).nonzero()[0].tolist()]
    distance = _slid(trace.velocity.tolist(), most * period, period) / scale
    return Slip(limit, float(sizes[peak]) / scale, peak * period, tuple(_joined(spans)), distance)


def _slid(velocities: list[float], reach: float, period: float) -> float:
    """Return the distance that the load moves relative to its carrier.

    `reach` is the largest change of the load's velocity in one sample.
    """
    load, total = velocities[0], 0.0
    for carrier in velocities:
        load = max(load - reach, min(load + reach, carrier))
        total += abs(carrier - load) * period
    return total


def _beyond(piece: Plain, span: float, most: float) -> list[tuple[float, float]]:
    """Return the local spans in which a piece's acceleration exceeds `most` in size."""
    marks = [0.0, *sorted(x for x in _levels(piece, most) if 0.0 < x < span), span]
    found = []
    for a, b in pairwise(marks):
        if abs(acceleration_in(piece, 0.5 * (a + b))) > most:
            found.append((a, b))
    return found


def _levels(piece: Plain, most: float) -> list[float]:
    """Return the local times at which the acceleration is `most` or -`most`.

    A sine piece lies within one half wave.
    """
    _, _, c2, c3, amplitude, omega, phase = piece
    if not amplitude:
        return [(sign * most - 2.0 * c2) / (6.0 * c3) for sign in (1.0, -1.0)] if c3 else []
    first = asin(min(most / (abs(amplitude) * omega * omega), 1.0))
    return [(angle - phase) / omega for angle in (first, pi - first)]


def _joined(spans: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Merge spans that touch."""
    made: list[tuple[float, float]] = []
    for begin, end in sorted(spans):
        if made and begin <= made[-1][1] + 1e-12:
            made[-1] = (made[-1][0], max(made[-1][1], end))
        else:
            made.append((begin, end))
    return made
