"""The judge of paths that overlap: two at most, each within its own bounds, and the axes do the sum of both.

So the sum keeps the bounds that the program has set for both. A stop, an override or a limit acts on each of them.
"""

from __future__ import annotations

from math import fsum
from typing import TYPE_CHECKING

from motionlang.controller.record.judge import ROUNDED, SLACK
from motionlang.controller.record.judge_paths import judge_tail

if TYPE_CHECKING:
    from motionlang.controller.move import Move
    from motionlang.controller.record.judge import Proof, Run
    from motionlang.controller.record.order import Order
    from motionlang.controller.record.track import WholeTrack

# Paths that may overlap.
MAX_OVERLAP = 2
# The parts of a profile at which the velocities of its paths are added up.
SHARES = (0.0, 0.35, 0.65, 0.95)


def judge_blend(proof: Proof, run: Run, master: WholeTrack, i: int, order: Order, end: float) -> None:
    """The paths that the path of a profile is blended with, while that is in force."""
    path, begin = order.path, master.starts[i]
    assert path is not None
    ends: list[float] = []
    entries = [run.members(path)]
    for tail in path.tails:
        assert tail.path is not None
        moves = run.members(tail.path)
        if len(moves) != len(path.members) or moves[0].profile is None:
            continue
        finish = min(end, moves[0].start_time + moves[0].profile.duration)
        if finish - begin > ROUNDED * (1.0 + begin):
            ends.append(finish)
            entries.append(moves)
            judge_tail(proof, run, tail, begin, finish - begin)
    if len(ends) >= MAX_OVERLAP:
        count = len(ends) + 1
        words = f"{count} paths overlap at {begin:.6f} s, {MAX_OVERLAP} may at the most"
        proof.breaks(order.line, f"path from {path.begun:.6f} s: {words}")
    if ends and all(len(moves) == len(path.members) for moves in entries):
        _judge_sum(proof, run, order, entries, (begin, min(end, *ends)))


def _judge_sum(
    proof: Proof, run: Run, order: Order, entries: list[list[Move]], time: tuple[float, float]
) -> None:
    path, (begin, end) = order.path, time
    assert path is not None
    for place, number in enumerate(path.members):
        a = run.axes[number]
        for share in SHARES:
            now = begin + share * (end - begin)
            k = a.place(now)
            state = a.profiles[k].at(now - a.starts[k])
            profiles = [(moves[place].profile, moves[place].start_time) for moves in entries]
            parts = [profile.velocity(now - start) for profile, start in profiles if profile is not None]
            done, due = state.velocity, fsum(parts)
            rounding = 8e-16 * (1.0 + now) * abs(state.acceleration)
            if abs(done - due) > SLACK * max(1.0, *map(abs, parts)) + rounding:
                words = f"axis {number} runs at {done:g} counts/s at {now:.6f} s, its paths add up to {due:g}"
                proof.breaks(order.line, f"path from {path.begun:.6f} s: {words}")
                return
