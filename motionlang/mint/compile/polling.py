"""Loops that only poll: what is written into their turns so that those which cannot differ are skipped.

A turn that did nothing (`E.acts` counts what a program does) and left every variable as it was before will be repeated
as it was until something happens. `motionlang.mint.runtime.loop_skipping` pays for all those turns at once, to the
exact same end. A `Goto` back to an earlier label ends a turn as `End Loop` does.

    if w2: w2 -= 1
    else: t, H, w1, w2 = k1.turn(t, H, w1, (E.acts, v_state))
    if t >= H: t, H = yield t; w2 or (w1 := k1.begin(t, w1, (E.acts, v_state)))

`w1` is what the turn began with, `w2` for how many turns nobody looks.
"""

from __future__ import annotations

from motionlang.mint.syntax import nodes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.lang.keyword import Keyword
    from motionlang.mint.compile.body import Body
    from motionlang.mint.compile.poll_analysis import Look

# A loop that gives more variables a value is not looked at turn by turn.
MOST_VARIABLES = 40


class Poll:
    """One loop that is watched, and the names of what its turn began with and for how many turns nobody looks."""

    __slots__ = ("left", "look", "site", "state")

    def __init__(self, b: Body, look: Look) -> None:
        self.site = b.whole.use("loop", look.reads, b.whole.polls)
        b.whole.polls += 1
        self.look, self.left = b.temp(), b.temp()
        self.state = f"({', '.join(['E.acts', *sorted(look.assigned)])},)"

    @property
    def first(self) -> str:
        """What stands before the first turn."""
        return f"{self.look} = None; {self.left} = {self.site}.left"


def watched(b: Body, body: list[nodes.Stmt], *conditions: nodes.Expr) -> Poll | None:
    """The watch on a loop, None where it would never find anything to skip."""
    if any(_plainly_acts(b, node) for node in body):
        return None
    poll = watched_jump(b, look_at(b, [*body, *conditions]))
    if poll is not None:
        b.emit(poll.first)
    return poll


def look_at(b: Body, turn: Sequence[nodes.Node]) -> Look:
    """What the turns of a loop look at and leave behind."""
    from motionlang.mint.compile.poll_analysis import Look

    return Look(b, turn)


def watched_jump(b: Body, look: Look) -> Poll | None:
    """The watch on a Goto that ends a turn which has been looked at."""
    if look.acts or len(look.assigned) > MOST_VARIABLES or (look.computes and not look.reads):
        return None  # with nothing but its own variables it computes
    b.whole.rewritten |= look.rewritten
    return Poll(b, look)


def turn(b: Body, poll: Poll) -> None:
    """The end of a turn, `t` being up to date."""
    look, left, site = poll.look, poll.left, poll.site
    b.emit(f"if {left}: {left} -= 1")
    b.emit(f"else: t, H, {look}, {left} = {site}.turn(t, H, {look}, {poll.state})")
    b.horizon(then=f"; {left} or ({look} := {site}.begin(t, {look}, {poll.state}))")


def _plainly_acts(b: Body, node: nodes.Stmt) -> bool:
    """Whether a statement does something in every turn, at a glance."""
    if not isinstance(node, (nodes.Assign, nodes.Call)):
        return node.__class__ in _ACTS
    target = node.target
    if not isinstance(target, nodes.Name):
        return False
    if b.scope.find(target.name) is not None:
        return isinstance(node, nodes.Assign) and _counts(target, node)
    row = b.whole.table.get(target.name)
    return row is not None and row.verb != "wait" and not is_repeated(row)


def is_repeated(row: Keyword) -> bool:
    """Whether a word may be written with what it has already, or stops what stands; the operation itself tells."""
    return row.kind != "move" and (row.access == "RW" or row.effect.startswith("stop"))


def _counts(target: nodes.Name, node: nodes.Assign) -> bool:
    """`n = n + 1`."""
    value = node.values[0] if node.values else None
    return (
        isinstance(value, nodes.Binary)
        and value.op in ("+", "-")
        and isinstance(value.left, nodes.Name)
        and isinstance(value.right, nodes.Number)
        and target.args is None
        and value.left.name.lower() == target.name.lower()
    )


_ACTS = frozenset((nodes.Print, nodes.Input, nodes.End))
