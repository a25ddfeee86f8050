"""The motion of a run, verified by code that shares nothing with the planners and the extremes of the certificate.

Problem. A planner that is wrong in a rare case gives a plausible profile, and a certificate that relies on one piece of
code only certifies that code.

Idea. Two records of a run are independent of each other: the track of each axis, profile by profile, and the entries of
the log, which state what each move covers. `verify_motion` reads both once, in order of time, and verifies:

- continuity: position and velocity are continuous within each profile and from one to the next. A new zero shifts the
  position. The velocity may jump if the entry was cut off and an event names the jump, if a table, a master or a
  reference leads the axis, if a stepper starts or stops at once, and at a corner that the axes of a path pass at one
  speed along it
- ends: a complete move ends at its target, and a complete motion without a target at rest
- limits: no position, speed, acceleration or jerk lies beyond the extremes of the certificate
- log and track: between two events an axis covers the distance that its entries in force cover together, so an axis
  without an entry is at rest; an entry begins where the axis is, and none ends after an axis that is at rest

Extrema of polynomials and waves are found in closed form; a motion that is a formula is compared at points.

Cost. One pass over the log, and one over the profiles of each axis.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import acos, ceil, copysign, cos, floor, fsum, inf, isfinite, nextafter, pi, sin, sqrt
from typing import NamedTuple

from motionlang.commands.certify import CertifiedLimit
from motionlang.kernel import Axis, Controller, Diagnostic
from motionlang.kernel.controller import Playback
from motionlang.kernel.log import LoggedMove
from motionlang.kernel.planners import Plain, Profile

# The fraction of the largest figure that rounding may amount to, and the relative error of a time.
SLACK, ROUNDED = 1e-6, 1.6e-15
# The fractions of a stretch at which a track is compared with its log, and a formula with the extremes.
FRACTIONS = (0.21, 0.5, 0.83, 1.0)
# Shapes of motion that a master, a table or a reference leads, whose velocity may jump.
LED = frozenset({"gear", "cam", "fly", "reference", "pvt"})

# Position, velocity, acceleration and jerk.
State = tuple[float, float, float, float]


class VerifiedMotion:
    """The number of verified `moves` and `pieces` of profiles, and the `violations`, each at the line of its move."""

    def __init__(self) -> None:
        self.moves = self.pieces = 0
        self.violations: list[Diagnostic] = []

    def breaks(self, line: int, message: str) -> None:
        """Record a violation."""
        self.violations.append(Diagnostic("beyond-limit", message, line))


def verify_motion(controller: Controller, lines: Sequence[CertifiedLimit], until: float) -> VerifiedMotion:
    """Verify the motion of all axes up to a time; `lines` are those of the certificate."""
    found, log = VerifiedMotion(), controller.log
    causes = {(each.axis, each.time): each.text for each in log.events if each.kind == "velocity jump"}
    axes = {n: _Side(found, a, lines, causes, until) for n, a in controller.axes.items()}
    begun: list[LoggedMove] = []  # the entries that begin at one time
    for move in log.moves:
        if begun and move.start_time != begun[0].start_time:
            _report_jumps(found, axes, begun)
            begun.clear()
        begun.append(move)
        axes[move.axis].begin(move)
    _report_jumps(found, axes, begun)
    for side in axes.values():
        side.finish()
    _report_jumps(found, axes, [])
    return found


# --------------------------------------------------------------------------------------------------- one axis


class _Jump(NamedTuple):
    """A jump of the velocity of an axis, counts/s, that only the corner of a path can excuse."""

    time: float
    size: float
    line: int


class _Side:
    """The track of an axis and its entries of the log, side by side; both are read up to `time`."""

    def __init__(
        self,
        found: VerifiedMotion,
        a: Axis,
        lines: Sequence[CertifiedLimit],
        causes: Mapping[tuple[int | None, float], str],
        until: float,
    ) -> None:
        self.found, self.a, self.causes, self.until, self.time = found, a, causes, until, 0.0
        self.jumps: list[_Jump] = []
        self.entries: list[LoggedMove] = []  # those in force
        self.ended: list[LoggedMove] = []  # those that have ended last
        self.line = 0  # that of the last entry
        self._is_stepper = self._is_superposed = False
        self._following = zip(a.starts, a.profiles, strict=False)
        self._start, self._profile = next(self._following)
        self._next = next(self._following, None)
        self._before = (self._start, self._profile)  # the profile in force before the present one
        changes = [(each.time, each.datum) for each in a.controller.log.zeros if each.axis == a.index]
        data = [*(datum for _, datum in changes), a.datum]
        self._zeros = [
            (time, old, new) for (time, _), (old, new) in zip(changes, pairwise(data), strict=True)
        ]
        self._datum, self._zero = data[0], 0
        self._peaks = _Peaks(a, [each for each in lines if each.axis == a.index])
        self._verify_profile()

    @property
    def where(self) -> str:
        return f"axis {self.a.index} at {self.time:.6f} s"

    def begin(self, move: LoggedMove) -> None:
        """Add an entry of the log, which is in force from its start on."""
        profile = move.profile
        assert profile is not None
        self.found.moves += 1
        self._advance(move.start_time)
        self.line = move.line
        self._is_superposed |= move.overlaid
        self._is_stepper |= isinstance(move.action, Playback) and move.action.step > 0.0
        if move.overlaid:  # the entry that it is superposed on covers its distance, too
            if abs(profile.start) > SLACK:
                self.found.breaks(
                    move.line, f"{self.where}: it is superposed from {profile.start:g} counts on, not 0"
                )
            if _end_of(move) <= self.until:
                self._verify_end(move)
            return
        if not self.entries and isfinite(profile.start):
            start, before = self._before
            here = (
                before.position(move.start_time - start),
                self._profile.position(move.start_time - self._start),
            )
            gap = min(abs(profile.start - each) for each in here)
            if gap > self._slack(profile.start, profile.start_velocity):
                self.found.breaks(move.line, f"{self.where}: its entry begins {gap:g} counts off the axis")
        self.entries.append(move)

    def finish(self) -> None:
        """Read the track up to the end of the run; no entry may go on without a motion."""
        self._advance(self.until)
        for move in self.entries:
            end = _end_of(move)
            if end > self.until * (1.0 + ROUNDED) and not self.a.is_moving:
                self.found.breaks(
                    move.line, f"{self.where}: its entry ends at {end:g} s, after the end of its motion"
                )
            elif end <= self.until * (1.0 + ROUNDED):
                self._verify_end(move)
        self._peaks.report(self.found)

    def _slack(self, position: float, velocity: float) -> float:
        """Return by how much positions at the present time may differ by rounding."""
        return SLACK * max(1.0, abs(position)) + ROUNDED * (1.0 + self.time) * abs(velocity)

    # ---------------------------------------------------------------------------------------- the two together

    def _advance(self, until: float) -> None:
        """Compare track and entries up to a time, stretch by stretch."""
        while True:
            following = inf if self._next is None else self._next[0]
            stretch = min(until, following, *map(_end_of, self.entries))
            if stretch > self.time:
                self._compare(stretch)
                self.time = stretch
            late = self.time + ROUNDED * (1.0 + self.time)  # an end is the sum of a start and a duration
            over = [move for move in self.entries if _end_of(move) <= late]
            if following <= self.time:
                self._join(over)
            if over:
                self.ended = over
            for move in over:
                self.entries.remove(move)
                self._verify_end(move)
            if self.time >= until and (self._next is None or self._next[0] > until):
                return

    def _compare(self, until: float) -> None:
        """Compare the distances of the track and of the entries in force from the present time on."""
        profile, entries = self._profile, self.entries
        if not entries and profile.shape == "hold":
            return
        if len(entries) == 1 and entries[0].profile is profile and entries[0].start_time == self._start:
            return
        covers = [(self._start, profile, 1.0)]
        covers += [(move.start_time, move.profile, -1.0) for move in entries if move.profile is not None]
        began = [each.position(self.time - start) for start, each, _ in covers]
        size = max(abs(each.position(until - start)) for start, each, _ in covers)
        for share in FRACTIONS:
            time = until if share == 1.0 else self.time + share * (until - self.time)
            gap = fsum(
                sign * (each.position(time - start) - first)
                for (start, each, sign), first in zip(covers, began, strict=True)
            )
            speed = max(abs(each.velocity(time - start)) for start, each, _ in covers)
            if abs(gap) > self._slack(max(size, *map(abs, began)), speed) + ROUNDED * (1.0 + time) * speed:
                words = (
                    f"track and log differ by {abs(gap):g} counts" if entries else "it moves without an entry"
                )
                self.found.breaks(self.line, f"axis {self.a.index} at {time:.6f} s: {words}")
                return

    def _verify_end(self, move: LoggedMove) -> None:
        """Verify that a complete entry ends at its target; without a target, at rest."""
        profile = move.profile
        assert profile is not None
        if move.ended:
            return
        where, end = f"axis {move.axis} from {move.start_time:.6f} s", profile.end + move.offset
        is_led = profile.shape in LED  # with a superposed offset, its end is not its target
        if isfinite(move.target) and not (is_led and self._is_superposed):
            if abs(end - move.target) > SLACK * max(1.0, abs(end), abs(move.target)):
                self.found.breaks(move.line, f"{where}: it ends at {end:g}, its target is {move.target:g}")
        elif not is_led and abs(profile.end_velocity) > SLACK * max(1.0, profile.peak_speed):
            self.found.breaks(
                move.line, f"{where}: it ends at {profile.end_velocity:g} counts/s, not at rest"
            )

    # ------------------------------------------------------------------------------------------------ the track

    def _join(self, over: Sequence[LoggedMove]) -> None:
        """Pass to the profile that begins now; those that are replaced at once count as one."""
        old_datum, self._before = self._datum, (self._start, self._profile)
        old, rests = self._profile.at(self.time - self._start), False
        while self._next is not None and self._next[0] <= self.time:
            self._start, self._profile = self._next
            rests = rests or self._profile.shape == "hold"
            self._next = next(self._following, None)
        while self._zero < len(self._zeros) and self._zeros[self._zero][0] <= self.time:
            self._datum = self._zeros[self._zero][2]
            self._zero += 1
        new, late = self._profile.at(0.0), 4.0 * ROUNDED * (1.0 + self.time)
        gap = abs(new.position - old.position - (self._datum - old_datum))
        slack = SLACK * max(1.0, 1e-6 * abs(old.position)) + late * abs(old.velocity)
        if gap > slack and not (rests and self.a.feedback is not None):  # a motor may have moved by itself
            self.found.breaks(self.line, f"{self.where}: the position jumps by {gap:g} counts")
        slack = SLACK * max(1.0, abs(old.velocity), abs(new.velocity)) + late * abs(old.acceleration)
        if abs(new.velocity - old.velocity) > slack and not self._is_excused(
            old.velocity, new.velocity, over
        ):
            self.jumps.append(_Jump(self.time, abs(new.velocity - old.velocity), self.line))
        self._verify_profile()

    def _is_excused(self, before: float, after: float, over: Sequence[LoggedMove]) -> bool:
        """True if a master, a table or a reference leads the axis, or the log has the reason of a jump."""
        if LED & {self._before[1].shape, self._profile.shape}:
            return True
        cause = self.causes.get((self.a.index, self.time), "")
        if not after and any(move.ended and cause.startswith(f"{move.ended},") for move in over):
            return True
        if not before and _steps(self._profile, after):
            self._is_stepper = True
        return self._is_stepper and not (before and after)

    def _verify_profile(self) -> None:
        """Verify the pieces of the present profile, and compare them with the extremes of the certificate."""
        following = self.until if self._next is None else min(self._next[0], self.until)
        profile, length = self._profile, following - self._start
        if profile.shape == "hold" or length <= 0.0:
            self._peaks.take(self._start, (profile.start, 0.0, 0.0, 0.0), self._datum)
            return
        knots = profile.knots
        count = sum(1 for knot in knots[:-1] if knot < length)
        self.found.pieces += count
        if not profile.pieced:
            for first, last in pairwise((*knots[:count], min(length, knots[-1]))):
                for share in (0.0, *FRACTIONS[:-1]):
                    state = profile.at(first + share * (last - first))
                    here = state.position, state.velocity, state.acceleration, state.jerk
                    self._peaks.take(self._start + first, here, self._datum)
            return
        before: State | None = None
        for k, piece in enumerate(profile.drawn[1][:count]):
            span = min(knots[k + 1], length) - knots[k]
            if before is not None:
                self._verify_knot(profile, knots[k], before, _state(piece, 0.0))
            elif isfinite(profile.start) and abs(
                piece[0] + piece[4] * sin(piece[6]) - profile.start
            ) > self._slack(profile.start, profile.start_velocity):
                self.found.breaks(self.line, f"{self.where}: the position jumps as it begins")
            if isfinite(span):
                before = _state(piece, span)
            if self._peaks.lines:
                for x in (*_turning_points(piece, span), *([span] if isfinite(span) else [])):
                    self._peaks.take(self._start + knots[k] + x, _state(piece, x), self._datum)

    def _verify_knot(self, profile: Profile, knot: float, before: State, after: State) -> None:
        """Verify that position and velocity are continuous where two pieces meet."""
        late = 4.0 * ROUNDED * (1.0 + self._start + knot)
        for n, name in enumerate(("position",) if profile.shape in LED else ("position", "velocity")):
            gap = abs(after[n] - before[n])
            if gap > SLACK * max(1.0, abs(before[n])) + late * max(abs(before[n + 1]), abs(after[n + 1])):
                where = f"axis {self.a.index} at {self._start + knot:.6f} s"
                self.found.breaks(self.line, f"{where}: the {name} jumps by {gap:g} counts within a profile")


def _steps(profile: Profile, velocity: float) -> bool:
    """True if a profile starts and stops at once at the speed of a velocity, as those of steppers do."""
    if not isfinite(profile.duration):
        return False
    ends = profile.at(0.0).velocity, profile.at(nextafter(profile.duration, 0.0)).velocity
    slack = SLACK * max(1.0, abs(velocity))
    return all(abs(abs(each) - abs(velocity)) <= slack for each in ends)


def _end_of(move: LoggedMove) -> float:
    return inf if move.profile is None else move.start_time + move.profile.duration


# ---------------------------------------------------------------------------------------------------- corners


def _report_jumps(found: VerifiedMotion, axes: Mapping[int, _Side], begun: Sequence[LoggedMove]) -> None:
    """Report the jumps of velocity so far, except at the corners of paths whose entries have just begun.

    The axes of a path have its line, and pass the corner at one speed along it.
    """
    for side in axes.values():
        for jump in side.jumps:
            at_once = [move for move in begun if move.start_time == jump.time]
            lines = {move.line for move in at_once if move.axis == side.a.index}
            members = [move for move in at_once if move.line in lines]
            if not _is_corner(axes, members, jump.time):
                where = f"axis {side.a.index} at {jump.time:.6f} s"
                found.breaks(jump.line, f"{where}: the velocity jumps by {jump.size:g} counts/s")
        side.jumps.clear()


def _is_corner(axes: Mapping[int, _Side], members: Sequence[LoggedMove], time: float) -> bool:
    """True if several axes pass from one path to the next at the same speed along both."""
    late, ended = ROUNDED * (1.0 + time), []
    for move in members:
        side = axes[move.axis]
        ended += [each for each in (*side.ended, *side.entries) if abs(_end_of(each) - time) <= late]
    before, after = (
        sqrt(fsum((_velocity(each, time) / each.scale) ** 2 for each in entries))
        for entries in (ended, members)
    )
    return len(members) > 1 and abs(after - before) <= SLACK * max(1.0, before)


def _velocity(move: LoggedMove, time: float) -> float:
    """Return the velocity of an entry at a time, on the side of it on which the entry is."""
    profile = move.profile
    assert profile is not None
    return profile.at(min(max(time - move.start_time, 0.0), nextafter(profile.duration, 0.0))).velocity


# ----------------------------------------------------------------------------------------------------- limits


class _Peaks:
    """The extremes of an axis, compared with those of the certificate."""

    def __init__(self, a: Axis, lines: Sequence[CertifiedLimit]) -> None:
        self.lines = {each.name: each for each in lines if each.reached is not None and each.name in _PEAKS}
        self._a = a
        self._beyond: dict[str, tuple[float, float]] = {}  # by name the worst figure and its time

    def take(self, time: float, state: State, datum: float) -> None:
        """Compare a state, in counts, at a time."""
        counts, _ = self._a.scale_at(time)
        for name, line in self.lines.items():
            order, sign = _PEAKS[name]
            if order:
                figure, bound = abs(state[order] / counts), line.reached or 0.0
            else:
                home = self._a.home or 0.0
                figure, bound = sign * (state[0] - datum - home) / counts, sign * (line.reached or 0.0)
            if figure > bound + SLACK * max(1.0, abs(bound)) and figure > self._beyond.get(name, (-inf,))[0]:
                self._beyond[name] = figure, time

    def report(self, found: VerifiedMotion) -> None:
        """Report the figures that lie beyond the certificate."""
        for name, (figure, time) in self._beyond.items():
            line = self.lines[name]
            words = (
                f"the {name} reaches {abs(figure):g} {line.unit}, beyond {line.reached:g} of the certificate"
            )
            found.breaks(line.line, f"axis {line.axis} at {time:.6f} s: {words}")


# The extremes by their names: the derivative, and the side of a position.
_PEAKS = {
    "lowest position": (0, -1.0),
    "highest position": (0, 1.0),
    "speed": (1, 1.0),
    "acceleration": (2, 1.0),
    "jerk": (3, 1.0),
}


def _state(piece: Plain, x: float) -> State:
    """Evaluate c0 + c1 x + c2 x² + c3 x³ + A sin(ωx + φ) and its derivatives."""
    c0, c1, c2, c3, amplitude, omega, phase = piece
    p, v = c0 + x * (c1 + x * (c2 + x * c3)), c1 + x * (2.0 * c2 + 3.0 * c3 * x)
    a, j = 2.0 * c2 + 6.0 * c3 * x, 6.0 * c3
    if amplitude:
        wave, slope = amplitude * sin(omega * x + phase), amplitude * omega * cos(omega * x + phase)
        p, v, a, j = p + wave, v + slope, a - wave * omega * omega, j - slope * omega * omega
    return p, v, a, j


def _turning_points(piece: Plain, span: float) -> list[float]:
    """Return the beginning of a piece, and the times within `span` at which a derivative is zero."""
    _, c1, c2, c3, amplitude, omega, phase = piece
    found = [0.0]
    if c3:
        found.append(-c2 / (3.0 * c3))
    if amplitude:
        turn, wave = 0.5 * pi, -c1 / (amplitude * omega)
        first, last = ceil(phase / turn), floor((omega * span + phase) / turn)
        found += [(k * turn - phase) / omega for k in range(first, last + 1)]
        if abs(wave) <= 1.0:
            laps = range(floor(phase / (2.0 * pi)) - 1, ceil((omega * span + phase) / (2.0 * pi)) + 2)
            found += [
                (side * acos(wave) + 2.0 * pi * k - phase) / omega for k in laps for side in (1.0, -1.0)
            ]
    elif c3 and c2 * c2 >= 3.0 * c1 * c3:
        q = -(c2 + copysign(sqrt(c2 * c2 - 3.0 * c1 * c3), c2))
        found += [q / (3.0 * c3), *([c1 / q] if q else [])]
    elif c2 and not c3:
        found.append(-0.5 * c1 / c2)
    return [x for x in found if 0.0 <= x < span]
