"""What stops a machine between its moves: it does not go on as usual behind a change in the middle of a move.

What begins fewer of its moves, and then none for 48 s, or for a longer cycle, has been stopped there, whatever it does
on its way.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import defaultdict
from difflib import SequenceMatcher
from math import inf

from motionlang.kernel import Run
from motionlang.kernel.log import CONTINUED
from motionlang_explore.exploration import Change, Exploration
from motionlang_explore.map.plays import LONGER, Play, Plays, acts

# What a move is not cut off by.
UNCUT = ("", CONTINUED)


class Stops:
    """What stops a machine that makes good pieces; nothing stops any other.

    `places` are the changes that bring it to rest, in the middle of the move of line `move`, each with the place of the
    last thing that was done as usual, a move, an output or a print, in words; `cuts` are those that cut off moves, with
    their lines. `waits` are the statements in which the machine then waits to the end of the play.
    """

    def __init__(self, exploration: Exploration, plays: Plays) -> None:
        self.places, self.waits = list[tuple[Change, str]](), set[int]()
        self.cuts = defaultdict[Change, set[int]](set)
        self._exploration, self._since, self._period = exploration, plays.since, plays.period
        world = exploration.world.run
        self._first = None if world.cycle is None or exploration.fault_of(world) else plays.move
        self.move = 0 if self._first is None else self._first.line
        ended = defaultdict[int, set[str]](set)
        for each in world.machine.log.moves:
            ended[each.line].add(each.ended)
        # The lines whose moves are never cut off in the world.
        self._uncut = {line for line, ways in ended.items() if ways.issubset(UNCUT)}
        # What the machine does as usual: its moves in this cycle and the next one, and all that it does in these.
        self._usual = [line for _, line in self._moves(world, plays.end + plays.period)]
        done = [each for each in acts(exploration, world) if plays.since < each[0] < plays.end + plays.period]
        self._done, self._in_cycle = [line for _, line in done], bisect_left(done, (plays.end,))

    def take(self, play: Play, run: Run) -> None:
        """Take note of a play in the middle of a cycle whose change stops the machine."""
        if self._first is None or not play.since:
            return
        cut = {each.line for each in run.machine.log.moves if each.ended not in UNCUT} & self._uncut
        if cut := cut if play.is_left else cut & {self.move}:
            self.cuts[play.change] |= cut
        if play.is_left and self._stays(run):
            self.places.append((play.change, self._place(run)))
            scheduler = run.machine.scheduler
            for task in () if scheduler is None else scheduler.tasks:
                if not task.done and task.wait is not None and task.wait.due() == inf:
                    self.waits.add(task.at)

    def _moves(self, run: Run, until: float = inf) -> list[tuple[float, int]]:
        """Return the times and lines of the moves that a run begins behind a change, up to a time, s."""
        moves = run.machine.log.moves
        begun = ((each.start_time, each.line) for each in moves if each.profile is not None)
        return [each for each in begun if self._since < each[0] < until]

    def _stays(self, run: Run) -> bool:
        """True if a run begins fewer moves than usual, and then none for long."""
        usual = set(self._usual)
        begun = [time for time, line in self._moves(run) if line in usual]
        last = max(begun, default=self._since)
        is_long = run.status != "until" or run.time - last > max(LONGER, self._period)
        return len(begun) < len(self._usual) and is_long

    def _place(self, run: Run) -> str:
        """Return the place of the last thing that was done as usual; a lamp may go off in between."""
        after = [line for time, line in acts(self._exploration, run) if time > self._since]
        blocks = SequenceMatcher(None, self._done, after, autojunk=False).get_matching_blocks()
        last = max((each.a + each.size for each in blocks[:-1]), default=0)
        if last == self._in_cycle:
            return "at the end of its cycle"
        line = [self.move, *self._done][last]
        return f"behind line {line}" if last < self._in_cycle else f"in its next cycle, behind line {line}"
