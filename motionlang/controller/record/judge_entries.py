"""The judge of how entries of the log end: before the run does, and where their axis is left."""

from __future__ import annotations

from math import fsum, isfinite
from typing import TYPE_CHECKING

from motionlang.controller.record.judge import ROUNDED, SLACK, position

if TYPE_CHECKING:
    from motionlang.controller.move import Move
    from motionlang.controller.record.judge import Proof, Run
    from motionlang.controller.record.track import WholeTrack


class Ends:
    """How the entries of one axis end: `going` are those that end after the run, `last` is the one begun last."""

    __slots__ = ("going", "last")

    def __init__(self) -> None:
        self.going: list[Move] = []
        self.last: Move | None = None


def take_entry(ends: dict[int, Ends], run: Run, move: Move) -> None:
    """Count an entry of the log; those that lie on top of another one are none of their own."""
    profile = move.profile
    if move.overlaid or profile is None:
        return
    found = ends.setdefault(move.axis, Ends())
    found.last = move
    if move.start_time + profile.duration > run.until * (1.0 + ROUNDED):
        found.going.append(move)


def judge_ends(proof: Proof, run: Run, ends: dict[int, Ends]) -> None:
    """No entry ends after the run unless its axis is on it, as fast as it says; the last one ends where its axis is."""
    for number, found in ends.items():
        a = run.axes[number]
        if found.going:
            _judge_going(proof, run, a, found.going)
        elif found.last is not None:
            _judge_last(proof, run, a, found.last)


def _judge_going(proof: Proof, run: Run, a: WholeTrack, going: list[Move]) -> None:
    present = a.move
    first = going[0]
    where = f"axis {a.index} from {first.start_time:.6f} s"
    if present is None:
        assert first.profile is not None
        end = first.start_time + first.profile.duration
        proof.breaks(first.line, f"{where}: its entry ends at {end:g} s, the run at {run.until:g} s")
        return
    if a.index in run.offsets:
        return
    speeds = [
        each.profile.velocity(run.until - each.start_time) for each in going if each.profile is not None
    ]
    k = a.place(run.until)
    done = a.profiles[k].velocity(run.until - a.starts[k])
    if abs(fsum(speeds) - done) > SLACK * max(1.0, abs(done), *map(abs, speeds)):
        words = f"its entries run at {fsum(speeds):g} counts/s as the run ends, the axis at {done:g}"
        proof.breaks(first.line, f"{where}: {words}")


def _judge_last(proof: Proof, run: Run, a: WholeTrack, last: Move) -> None:
    profile = last.profile
    assert profile is not None
    if a.feedback is not None or a.index in run.offsets or not isfinite(profile.end) or run.orders.was_cut:
        return
    data, done = run.orders.data[a.index], position(a, run.until)
    # What it has been shifted by since it began: another zero may have come at that very moment.
    i = a.place(last.start_time)
    shifts = [data[-1] - data[i]]
    while i > 0 and a.starts[i] >= last.start_time - ROUNDED * (1.0 + last.start_time):
        i -= 1
        shifts.append(data[-1] - data[i])
    end = min((profile.end + shift for shift in shifts), key=lambda each: abs(each - done))
    if abs(end - done) > SLACK * max(1.0, abs(end), abs(done)):
        where = f"axis {a.index} from {last.start_time:.6f} s"
        proof.breaks(last.line, f"{where}: the last entry ends at {end:g}, the axis stands at {done:g}")
