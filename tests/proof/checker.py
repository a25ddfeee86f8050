"""The results of a proof, and its lookups."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Mapping
from itertools import accumulate
from math import fsum, inf, isfinite

from motionlang.kernel import Axis, Diagnostic
from motionlang.kernel.log import CONTINUED, LoggedMove
from tests.proof.expected_motion import ExpectedMotion
from tests.proof.order import Order, PathOrder

# The fraction of the largest figure that rounding may amount to.
SLACK = 1e-6
# The relative error of an end, which is the sum of a beginning and a time.
ROUNDED = 4e-16


class Proof:
    """The results of a proof.

    `counts` has the number of checked items, `worst` the largest used fraction of each bound (1.0 is all of
    it), `exceptions` the violations that the program commanded, by name, and `violations` the others, each as
    a diagnostic at its line.
    """

    def __init__(self) -> None:
        self.counts = {"moves": 0, "profiles": 0, "joins": 0, "paths": 0}
        self.worst: dict[str, float] = {}
        self.exceptions: dict[str, int] = {}
        self.violations: list[Diagnostic] = []

    @property
    def holds(self) -> bool:
        """True if there is no violation."""
        return not self.violations

    def lines(self) -> list[str]:
        """Return the results as lines of text."""
        checked = ", ".join(f"{name} {count}" for name, count in self.counts.items())
        found = [
            f"proof: {checked}; {len(self.violations) or 'no'} violation{'s'[: len(self.violations) != 1]}"
        ]
        found += [f"  {name}: {share:.9f} of the limit" for name, share in sorted(self.worst.items())]
        found += [f"  ordered: {name}, {count} x" for name, count in sorted(self.exceptions.items())]
        return found

    def as_dict(self) -> dict[str, object]:
        """Return the results in the form of the JSON report; its diagnostics have the violations."""
        return {
            **self.counts,
            "violations": len(self.violations),
            "bounds": [{"name": name, "share": share} for name, share in sorted(self.worst.items())],
            "exceptions": [{"name": name, "count": count} for name, count in sorted(self.exceptions.items())],
        }

    def breaks(self, line: int, message: str) -> None:
        """Record a violation."""
        self.violations.append(Diagnostic("crash", message, line))

    def excuses(self, name: str) -> None:
        """Record a violation that the program has commanded."""
        self.exceptions[name] = self.exceptions.get(name, 0) + 1

    def uses(self, name: str, figure: float, bound: float) -> bool:
        """Record the used fraction of a bound; True if the bound is observed."""
        if bound == inf:
            return True
        share = figure / bound if bound else (0.0 if figure <= SLACK else inf)
        if share <= 1.0 + SLACK:
            if share > self.worst.get(name, 0.0):
                self.worst[name] = share
            return True
        return False


class BoundUses:
    """The used bounds of one profile; each violation is reported once, at its worst."""

    def __init__(self, proof: Proof) -> None:
        self._proof = proof
        self._broken: dict[str, tuple[float, float]] = {}

    def compare(self, name: str, figure: float, bound: float) -> None:
        """Compare a figure with its bound.

        The totals omit the text after "of" in the name.
        """
        if not self._proof.uses(name.split(" of axis")[0], figure, bound):
            self._broken[name] = max(self._broken.get(name, (0.0, bound)), (figure, bound))

    def report(self, line: int, where: str, unit: str) -> None:
        """Report the violations."""
        for name, (figure, bound) in self._broken.items():
            self._proof.breaks(line, f"{where}: the {name} reaches {figure:g}{unit}, above {bound:g}")


class Offsets:
    """The superposed offset entries of one axis, by start time."""

    def __init__(self) -> None:
        self._moves: list[LoggedMove] = []
        self._starts: list[float] = []
        # For each index: the latest end of the entries before it, and their total distance by then.
        self._ends: list[float] = []
        self._sums = [0.0]

    def add(self, move: LoggedMove) -> None:
        """Append an entry."""
        profile = move.profile
        if profile is None:
            return
        end = move.start_time + profile.duration
        self._moves.append(move)
        self._starts.append(move.start_time)
        self._ends.append(max(end, self._ends[-1]) if self._ends else end)
        self._sums.append(self._sums[-1] + (profile.distance if isfinite(profile.duration) else 0.0))

    def travelled(self, time: float) -> float:
        """Return the total distance of all offsets at a time."""
        in_force, over = self._in_force(time)
        return fsum((self._sums[over], *(travelled(move, time)[0] for move in in_force)))

    def is_active_at(self, time: float) -> bool:
        """True if an offset is in progress at a time."""
        return bool(self._in_force(time)[0])

    def begin_at(self, time: float) -> bool:
        """True if an offset begins at a time."""
        k = bisect_left(self._starts, time)
        return k < len(self._starts) and self._starts[k] == time

    def _in_force(self, time: float) -> tuple[list[LoggedMove], int]:
        """Return the offsets in progress at a time, and the number of entries before them."""
        k, found = bisect_right(self._starts, time), []
        while k > 0 and self._ends[k - 1] > time:
            k -= 1
            found.append(self._moves[k])
        return found, k


class RunRecords:
    """The records of a run: tracks of its axes, log, orders, and end time."""

    def __init__(
        self,
        axes: Mapping[int, Axis],
        moves: Iterable[LoggedMove],
        expected_motion: ExpectedMotion,
        until: float,
    ) -> None:
        self.axes, self.expected_motion, self.until = axes, expected_motion, until
        # A log creates its entries on each read; those of paths and offsets, by number, are cached.
        self._log = moves
        self._stored: dict[int, LoggedMove] = {}
        # The entries of paths by axis, beginning and number, as the orders refer to them.
        self.entries: dict[tuple[int, float, int], LoggedMove] = {}
        # By axis the latest end of all path entries up to each.
        self._ends: dict[int, list[float]] = {}
        # For each path entry that continues another one: that entry, and where the path began.
        self._rest_of: dict[int, LoggedMove] = {}
        self._origins: dict[int, float] = {}
        # The entries of each path, in the order in which the paths began, and the index of each entry's path.
        self._chains: dict[int, list[list[LoggedMove]]] = {}
        self._chain_of: dict[int, int] = {}
        self.offsets: dict[int, Offsets] = {}
        # By axis the last offset that was checked, and its distance.
        self.offset_goals: dict[int, tuple[LoggedMove, float]] = {}
        self._begins: dict[int, list[float]] = {}
        self._order_of: dict[int, Order] = {}
        ordered = {
            order.path.entry: order
            for records in expected_motion.of.values()
            for order in records
            if order.path is not None
        }
        # The path entries of each axis that were continued, and are still without the entry that does so.
        full: dict[int, list[LoggedMove]] = {}
        for number, move in enumerate(moves):
            if move.overlaid:
                self._stored[number] = move
                self.offsets.setdefault(move.axis, Offsets()).add(move)
                continue
            before = _continued_by(move, full.get(move.axis, ()))
            order = ordered.get(number)
            if before is not None:
                order = _continued(self._order_of[id(before)], move, number)
            if order is not None and order.path is not None:
                self._stored[number] = self.entries[move.axis, order.path.begun, order.path.nth] = move
                self._add_path(move, before)
                self._order_of[id(move)] = order
                if before is not None:
                    full[move.axis].remove(before)
                    self._rest_of[id(move)] = before
                    self._origins[id(move)] = self._origin(before) + before.offset
                if move.ended == CONTINUED:
                    full.setdefault(move.axis, []).append(move)

        for axis, chains in self._chains.items():
            ends = [_end(chain[-1]) for chain in chains]
            self._ends[axis] = list(accumulate(ends, max))

    def _add_path(self, move: LoggedMove, before: LoggedMove | None) -> None:
        """Add a path entry to those of its axis; it continues `before`."""
        chains = self._chains.setdefault(move.axis, [])
        if before is None:
            self._chain_of[id(move)] = len(chains)
            chains.append([move])
        else:
            self._chain_of[id(move)] = self._chain_of[id(before)]
            chains[self._chain_of[id(before)]].append(move)

    def _origin(self, move: LoggedMove) -> float:
        """Return the start position of a path, relative to the zero of one of its entries."""
        assert move.profile is not None
        return self._origins.get(id(move), move.profile.start)

    def origins(self, path: PathOrder) -> list[float]:
        """Return the start positions of a path's axes.

        A path may have begun before its current entries did.
        """
        return [self._origin(move) for move in self.members(path)]

    def is_continued(self, move: LoggedMove) -> bool:
        """True if another entry continues a path entry."""
        k = self._chain_of.get(id(move))
        return k is not None and self._chains[move.axis][k][-1] is not move

    def rest_of(self, move: LoggedMove) -> LoggedMove | None:
        """Return the entry that a path entry continues; None if it begins the path."""
        return self._rest_of.get(id(move))

    @property
    def moves(self) -> Iterator[LoggedMove]:
        """The entries of the log in order."""
        for number, move in enumerate(self._log):
            yield self._stored.get(number, move)

    def span(self, a: Axis, i: int) -> tuple[float, float]:
        """Return when a profile of a track came into force, and when it ended."""
        begin, profile = a.starts[i], a.profiles[i]
        over = a.starts[i + 1] if i + 1 < len(a.starts) else self.until
        is_over = i + 1 == len(a.starts) or not profile.end_velocity
        return begin, min(over, begin + profile.duration) if is_over else over

    def order_of(self, move: LoggedMove) -> Order:
        """Return the order in force when an entry of the log begins."""
        found = self._order_of.get(id(move))
        if found is None:
            a, records = self.axes[move.axis], self.expected_motion.of[move.axis]
            i = a.index_at(move.start_time)
            while records[i].path is not None and i and a.starts[i] == move.start_time:
                i -= 1  # a path that begins at the end of a move without a distance
            found = records[i]
        return found

    def begins_near(self, axis: int, time: float) -> list[float]:
        """Return the times next to `time` at which motion or an offset of an axis began."""
        begins = self._begins.get(axis)
        if begins is None:
            offsets = {begun for number, begun in self.expected_motion.offsets if number == axis}
            begins = self._begins[axis] = sorted(offsets | self.expected_motion.begun[axis])
        k = bisect_left(begins, time)
        return begins[max(k - 1, 0) : k + 1]

    def members(self, path: PathOrder) -> list[LoggedMove]:
        """Return the entries of a path."""
        found = [self.entries.get((number, path.begun, path.nth)) for number in path.members]
        return [entry for entry in found if entry is not None and entry.profile is not None]

    def logged(self, a: Axis, move: LoggedMove, time: float, ending: bool) -> float:
        """Return a track's position from a log entry, without the motion of blended paths.

        An entry without a duration may precede a position that is set at the same time.
        """
        done = position(a, time, ending)
        if move.profile is not None and not move.profile.duration:
            done = _at_instant(a, time, move.profile.start, done)
        k = self._chain_of.get(id(move))
        if k is None:
            return done
        chains, ends = self._chains[a.index], self._ends[a.index]
        before = k - 1
        while before >= 0 and ends[before] > time:
            for entry in reversed(chains[before]):
                if _end(entry) <= time:
                    break
                done -= travelled(entry, max(time, entry.start_time))[1]
            before -= 1
        after = k + 1
        while after < len(chains) and chains[after][0].start_time < time:
            done -= fsum(travelled(entry, time)[0] for entry in chains[after] if entry.start_time < time)
            after += 1
        return done


def _at_instant(a: Axis, time: float, stated: float, last: float) -> float:
    """Return the position at a time that is nearest to the stated one.

    `last` is the final one; others are those of profiles that began then and were replaced at once.
    """
    found, i = [last], a.index_at(time)
    while i >= 0 and a.starts[i] == time:
        found.append(a.profiles[i].start)
        i -= 1
    return min(found, key=lambda each: abs(each - stated))


def _end(move: LoggedMove) -> float:
    return move.start_time + (move.profile.duration if move.profile is not None else 0.0)


def _continued_by(move: LoggedMove, entries: Iterable[LoggedMove]) -> LoggedMove | None:
    """Return the path entry that `move` continues; None if there is none."""
    for each in entries:
        end = _end(each)
        if each.line == move.line and abs(move.start_time - end) <= 4.0 * ROUNDED * (1.0 + end):
            return each
    return None


def _continued(order: Order, move: LoggedMove, number: int) -> Order:
    """Return the order of a path, adapted to an entry that continues it."""
    assert order.path is not None
    return order._replace(path=order.path._replace(begun=move.start_time, entry=number))


def travelled(move: LoggedMove, time: float) -> tuple[float, float]:
    """Return the distance of a log entry at a time, and the signed remaining distance."""
    profile = move.profile
    assert profile is not None
    here = profile.position(min(time - move.start_time, profile.duration))
    return here - profile.start, here - profile.end


def position(a: Axis, time: float, ending: bool = False) -> float:
    """Return the position of a track; with `ending`, before the events of that time.

    A new zero is such an event.
    """
    i = a.index_at(time)
    while ending and i > 0 and a.starts[i] >= time - ROUNDED * (1.0 + time):
        i -= 1
    return a.profiles[i].position(time - a.starts[i])
