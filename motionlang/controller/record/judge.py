"""What a proof notes, and what it looks things up in."""

from __future__ import annotations

from bisect import bisect_right
from math import inf
from typing import TYPE_CHECKING

from motionlang.errors import Diagnostic

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from motionlang.controller.axis import Axis
    from motionlang.controller.move import Move
    from motionlang.controller.record.orders import Order, Orders

# A part of the largest figure that rounding may be worth.
SLACK = 1e-6
# Paths that may be blended into one another at one time.
_AT_ONCE = 4


class Proof:
    """What was proved: `counts` of things looked at, the `worst` use of each bound (1.0: all of it), `exceptions` that
    the program has ordered by name, and `violations`, each a diagnostic at its line."""

    def __init__(self) -> None:
        self.counts = {"moves": 0, "profiles": 0, "joins": 0, "paths": 0}
        self.worst: dict[str, float] = {}
        self.exceptions: dict[str, int] = {}
        self.violations: list[Diagnostic] = []

    @property
    def holds(self) -> bool:
        """Whether nothing was broken."""
        return not self.violations

    def lines(self) -> list[str]:
        """The same for a person."""
        looked = ", ".join(f"{name} {count}" for name, count in self.counts.items())
        found = [
            f"proof: {looked}; {len(self.violations) or 'no'} violation{'s'[: len(self.violations) != 1]}"
        ]
        found += [f"  {name}: {share:.9f} of what is allowed" for name, share in sorted(self.worst.items())]
        found += [f"  ordered: {name}, {count} x" for name, count in sorted(self.exceptions.items())]
        return found

    def breaks(self, line: int, message: str) -> None:
        """Something is broken."""
        self.violations.append(Diagnostic("proof", message, line))

    def excuses(self, name: str) -> None:
        """Something would be broken if the program had not ordered it."""
        self.exceptions[name] = self.exceptions.get(name, 0) + 1

    def uses(self, name: str, figure: float, bound: float) -> bool:
        """Note how much of a bound is used; whether it is kept."""
        if bound == inf:
            return True
        share = figure / bound if bound else (0.0 if figure <= SLACK else inf)
        if share <= 1.0 + SLACK:
            if share > self.worst.get(name, 0.0):
                self.worst[name] = share
            return True
        return False


class Uses:
    """The bounds of one profile, of which each that is broken is told once, with its largest figure."""

    __slots__ = ("_broken", "_proof")

    def __init__(self, proof: Proof) -> None:
        self._proof = proof
        self._broken: dict[str, tuple[float, float]] = {}

    def look(self, name: str, figure: float, bound: float) -> None:
        """A figure beside its bound; what stands behind "of" in the name is left out of the figures of the whole."""
        if not self._proof.uses(name.split(" of axis")[0], figure, bound):
            self._broken[name] = max(self._broken.get(name, (0.0, bound)), (figure, bound))

    def tell(self, line: int, where: str, unit: str) -> None:
        """Tell of what is broken."""
        for name, (figure, bound) in self._broken.items():
            self._proof.breaks(line, f"{where}: the {name} reaches {figure:g}{unit}, above {bound:g}")


class Run:
    """What a run left behind: the tracks of its axes, its log, what was ordered, and when it ended."""

    def __init__(self, axes: Mapping[int, Axis], moves: Iterable[Move], orders: Orders, until: float) -> None:
        self.axes, self.moves, self.orders, self.until = axes, list(moves), orders, until
        # The entries of paths by axis and beginning, and in the order in which they began.
        self.entries: dict[tuple[int, float], Move] = {}
        self.paths: dict[int, list[Move]] = {}
        self.offsets: dict[int, list[Move]] = {}
        for move in self.moves:
            if move.overlaid:
                self.offsets.setdefault(move.axis, []).append(move)
            elif self.kind_at(axes[move.axis], move.start_time) == "path":
                self.entries[move.axis, move.start_time] = move
                self.paths.setdefault(move.axis, []).append(move)

    def span(self, a: Axis, i: int) -> tuple[float, float]:
        """When a profile of a track was in force."""
        begin = a.starts[i]
        if i + 1 < len(a.starts):
            return begin, a.starts[i + 1]
        return begin, min(self.until, begin + a.profiles[i].duration)

    def kind_at(self, a: Axis, time: float) -> str:
        """The kind of what an axis did from a moment on."""
        return self.order_at(a, time).kind

    def order_at(self, a: Axis, time: float) -> Order:
        """What holds for an axis from a moment on."""
        return self.orders.of[a.index][place(a, time)]

    def is_blended(self, a: Axis, time: float) -> bool:
        """Whether an axis is on two paths at once."""
        return a.profiles[place(a, time)].shape == "blend"

    def logged(self, a: Axis, move: Move, time: float) -> float:
        """The position of a track as a log entry tells it: of paths that are blended without what the others add."""
        done = position(a, time)
        entries = self.paths.get(a.index, [])
        if move not in entries:
            return done
        k = entries.index(move)
        for other in entries[max(0, k - _AT_ONCE) : k]:
            done -= _gone(other, time)[1]
        for other in entries[k + 1 : k + 1 + _AT_ONCE]:
            if other.start_time < time:
                done -= _gone(other, time)[0]
        return done


def _gone(move: Move, time: float) -> tuple[float, float]:
    """How far a log entry has come at a time, and how far that is from its end, signed."""
    profile = move.profile
    assert profile is not None
    here = profile.position(min(time - move.start_time, profile.duration))
    return here - profile.start, here - profile.end


def place(a: Axis, time: float) -> int:
    """The number of the profile of a track that is in force at a time."""
    return bisect_right(a.starts, time) - 1


def position(a: Axis, time: float) -> float:
    """The position of a track."""
    i = place(a, time)
    return a.profiles[i].position(time - a.starts[i])
