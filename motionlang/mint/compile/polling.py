"""Loops that only poll: what is written into their turns so that those which cannot differ are skipped.

A turn that did nothing (`E.acts` counts what a program does) and left every variable as it was before will be repeated
as it was until something happens. `motionlang.mint.runtime.loop_skipping` pays for all those turns at once, to the
exact same end. A `Goto` back to an earlier label ends a turn as `End Loop` does.

    if w2: w2 -= 1
    else: t, H, w1, w2 = k1.turn(t, H, w1, (E.acts, v_state))
    if t >= H: t, H = yield t; w2 or (w1 := k1.begin(t, w1, (E.acts, v_state)))

`w1` is what the turn began with, `w2` for how many turns nobody looks. What decides nothing (`poll_variables`) is no
part of that state; counters are given beside it, and are found in `w1` as they are when turns have been skipped.
"""

from __future__ import annotations

from motionlang.mint.compile.poll_variables import carried
from motionlang.mint.syntax import nodes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Collection, Sequence

    from motionlang.lang.keyword import Keyword
    from motionlang.mint.compile.body import Body
    from motionlang.mint.compile.poll_analysis import Look

# A loop that gives more variables a value is not looked at turn by turn.
MOST_VARIABLES = 40


class Poll:
    """One loop that is watched, and the names of what its turn began with and for how many turns nobody looks."""

    __slots__ = ("counters", "left", "look", "site", "state")

    def __init__(self, b: Body, look: Look, counters: Sequence[str] = (), mere: Collection[str] = ()) -> None:
        self.site = b.whole.use("loop", look.reads, b.whole.polls, bool(mere))
        b.whole.polls += 1
        self.look, self.left = b.temp(), b.temp()
        self.state = f"({', '.join(['E.acts', *sorted(look.assigned.difference(mere))])},)"
        self.counters = "".join(f"{each}, " for each in counters)
        if counters:
            self.state += f", ({self.counters})"

    @property
    def first(self) -> str:
        """What stands before the first turn."""
        return f"{self.look} = None; {self.left} = {self.site}.left"


def watched(b: Body, body: list[nodes.Stmt], *conditions: nodes.Expr) -> Poll | None:
    """The watch on a loop, None where it would never find anything to skip."""
    if any(_plainly_acts(b, node) for node in body):
        return None
    look = look_at(b, [*body, *conditions])
    counters, mere, levels = carried(b, [*body, *conditions])
    poll = watched_jump(b, look, counters, mere)
    if poll is not None:
        b.emit(poll.first)
        b.levels.update(levels)
        b.watching += 1
    return poll


def look_at(b: Body, turn: Sequence[nodes.Node]) -> Look:
    """What the turns of a loop look at and leave behind."""
    from motionlang.mint.compile.poll_analysis import Look

    return Look(b, turn)


def watched_jump(
    b: Body, look: Look, counters: Sequence[str] = (), mere: Collection[str] = ()
) -> Poll | None:
    """The watch on a Goto that ends a turn which has been looked at; with what decides nothing in it, if known."""
    if look.acts or len(look.assigned) > MOST_VARIABLES or (look.computes and not look.reads):
        return None  # with nothing but its own variables it computes
    b.whole.rewritten |= look.rewritten
    return Poll(b, look, counters, mere)


def turn(b: Body, poll: Poll) -> None:
    """The end of a turn, `t` being up to date."""
    look, left, site = poll.look, poll.left, poll.site
    counted = f"; {poll.counters}= {look}.counters" if poll.counters else ""
    b.emit(f"if {left}: {left} -= 1")
    b.emit(f"else: t, H, {look}, {left} = {site}.turn(t, H, {look}, {poll.state}){counted}")
    b.horizon(then=f"; {left} or ({look} := {site}.begin(t, {look}, {poll.state}))")


def _plainly_acts(b: Body, node: nodes.Stmt) -> bool:
    """Whether a statement does something in every turn, at a glance."""
    if not isinstance(node, (nodes.Assign, nodes.Call)):
        return node.__class__ in _ACTS
    target = node.target
    if not isinstance(target, nodes.Name) or target.symbol is not None:
        return False
    row = target.row
    return row is not None and row.verb != "wait" and not is_repeated(row)


def is_repeated(row: Keyword) -> bool:
    """Whether a word may be written with what it has already, or stops what stands; the operation itself tells."""
    return row.kind != "move" and (row.access == "RW" or row.effect.startswith("stop"))


_ACTS = frozenset((nodes.Print, nodes.Input, nodes.End))
