"""Check that a run up to a time equals the beginning of a longer run."""

from __future__ import annotations

from collections.abc import Iterator

from motionlang.kernel import Axis, Run

# Seconds before the end of the shorter run within which events may belong to its last instant.
LAST = 1e-6
# Statements that are executed after the end: those that touch only variables do not read the clock. The most in a row
# are a PRINT, the assignment before a Loop, and the Loop, the count and the If of its first iteration.
STATEMENTS = 6
# Counts by which two beginnings of a move may differ: a rate that is written later rounds them in another way.
CLOSE = 1e-6
# Times up to the end of the shorter run at which positions are compared.
SAMPLES = 8


def differences(whole: Run, prefix: Run, until: float) -> Iterator[str]:
    """Yield the differences between a run up to `until` and the complete run."""
    end = max(until - LAST, 0.0)
    if (
        whole.time > until
        and not until <= prefix.time <= until + STATEMENTS * prefix.machine.instruction_time
    ):
        yield f"prefix: to {until!r} s: it ends at {prefix.time!r} s"
    for name, known, found in (
        ("events", list(_events(whole, end)), list(_events(prefix, end))),
        ("prints", list(_prints(whole, end)), list(_prints(prefix, end))),
        ("waits", list(_waits(whole, end)), list(_waits(prefix, end))),
        ("moves", list(_moves(whole, end)), list(_moves(prefix, end))),
    ):
        first = next((k for k, (a, b) in enumerate(zip(known, found, strict=False)) if a != b), None)
        if first is not None or len(known) != len(found):
            values = (known[first], found[first]) if first is not None else (len(known), len(found))
            yield f"prefix: to {until!r} s: {name}: {values[0]} without, {values[1]} with an end"
    for number, axis in whole.controller.axes.items():
        tracks = axis, prefix.controller.axes[number]
        for k in range(SAMPLES):
            time = end * k / (SAMPLES - 1)
            here, there = (_position(track, time) for track in tracks)
            if here != there:
                yield f"prefix: to {until!r} s: axis {number} is at {here!r} and {there!r} at {time!r} s"
                break


class _Position(float):
    """A position, counts, which is the same up to `CLOSE`."""

    def __eq__(self, other: object) -> bool:
        return isinstance(other, float) and abs(self - other) <= CLOSE

    __hash__ = float.__hash__


def _position(track: Axis, time: float) -> float:
    index = track.index_at(time)
    return track.profiles[index].position(time - track.starts[index])


def _events(result: Run, end: float) -> Iterator[object]:
    return (each for each in result.controller.log.events if each.time < end)


def _prints(result: Run, end: float) -> Iterator[object]:
    return (each for each in result.controller.log.prints if each.time < end)


def _waits(result: Run, end: float) -> Iterator[object]:
    return (each for each in result.controller.log.waits if each.until < end)


def _moves(result: Run, end: float) -> Iterator[object]:
    """Yield the entries that start before `end`, in the state in which they began.

    An entry that is blended into the one before it has no
    position here: it begins where that one ends, which may be earlier than planned.
    """
    over: dict[int, float] = {}
    for move in result.controller.log.moves:
        if move.start_time < end:
            assert move.profile is not None
            is_blended = move.start_time < over.get(move.axis, 0.0) - LAST
            begin = None if is_blended else _Position(move.profile.start)
            over[move.axis] = move.start_time + move.profile.duration
            yield (move.axis, move.command, move.line, move.start_time, begin, move.scale)
