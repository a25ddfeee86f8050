"""Loops write into the log when they ran: what the profile needs to charge a loop that polls, or computes.

    l7 = t, E.statements.base
    while …: …
    if t - l7[0] > 100.0 or E.statements.base is not l7[1]: E.looped(t, l7, 7)
    l7 = None

The variable is named after the source offset of the loop, so that the frame of a task that is still in a loop, or has
been thrown out of it, says since when. A loop shorter than `LEAST` statements that never waited leaves no record.
Nothing is added to an iteration.

A call of a sub outside of loops is noted in the same way, for what it computes outside of its own.

A backward Goto makes a loop of the stretches from its label to the last jump back to it. It begins where its label is
reached, and ends behind the statement of that last jump, or at a jump to a stretch outside of it.
"""

from __future__ import annotations

from motionlang.mint.compile.lines import Line
from motionlang.mint.runtime.loop_log import LEAST
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import walk

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.compile.body import Body

# In a function of more labels than this no loop of Gotos is noted.
MAX_LABELS = 200


class Region:
    """A loop of Gotos: the stretches `first` to `last`, in which statement `end` has the last jump back."""

    __slots__ = ("at", "end", "first", "last")

    def __init__(self, at: int, first: int) -> None:
        self.at, self.first = at, first
        self.last = self.end = -1


def begin(b: Body) -> None:
    """Before the first iteration of the loop being written; `t` is up to date."""
    b.timed.append(b.at)
    b.emit(f"l{b.at} = t, E.statements.base")


def end(b: Body) -> None:
    """Behind a loop."""
    _close(b, b.timed.pop())


def call(b: Body, node: nodes.Stmt, begin: int) -> None:
    """Around a statement, written from line `begin` on, that calls a sub: it leaves a record as a loop does.

    Not where it waits, as the places of its waits say in which sub it is. Not in a loop, whose iterations stay what
    they are, and not where a sub calls itself: the first call is enough.
    """
    if type(node) not in (nodes.Call, nodes.Assign) or b.callee is None or b.callee is b.function:
        return
    at = node.at
    b.lines.insert(begin, Line(b.indent, f"l{at} = t, E.statements.base", at))
    b.emit(
        f"if t - l{at}[0] > {LEAST} and E.statements.base is l{at}[1]: "
        f"E.looped(t, l{at}, {b.callee.at}, ({at},))"
    )
    b.emit(f"l{at} = None")


def leave(b: Body) -> None:
    """Before the function returns from within its loops."""
    for at in reversed(b.timed):
        _close(b, at)
    for region in b.regions:
        _close_region(b, region)


# ---------------------------------------------------------------------------------------------------- Goto


def regions(b: Body) -> list[Region]:
    """The loops that the Gotos of a function make; none of one that has too many labels."""
    found: dict[int, Region] = {}
    labels = [node for node in b.function.body if type(node) is nodes.Label]
    if len(labels) > MAX_LABELS:
        return []
    for number, (_, body) in enumerate(b.stretches()):
        for place, statement in enumerate(body):
            for node in walk([statement]):
                if type(node) is not nodes.Jump or node.kind == "gosub":
                    continue
                first = b.labels().get(node.name.lower(), number + 1)
                if 0 < first <= number:
                    region = found.setdefault(first, Region(labels[first - 1].at, first))
                    region.last, region.end = number, place + 1
    return list(found.values())


def open_regions(b: Body) -> None:
    """At the begin of a stretch: the loop that begins with its label, if it has not begun yet."""
    for region in b.regions:
        if region.first == b.stretch:
            b.emit(f"if r{region.at} is None: r{region.at} = t, E.statements.base")


def close_regions(b: Body, place: int) -> None:
    """Behind so many statements of a stretch: the loops whose last jump back is the one before."""
    for region in b.regions:
        if (region.last, region.end) == (b.stretch, place):
            b.flush()
            _close_region(b, region)


def left(b: Body, number: int) -> list[Region]:
    """The loops of Gotos that a jump to a stretch leaves."""
    return [
        region
        for region in b.regions
        if region.first <= b.stretch <= region.last and not region.first <= number <= region.last
    ]


def jump(b: Body, number: int) -> None:
    """Before a jump to a stretch that no other loop stands around: the loops that it leaves."""
    for region in left(b, number):
        _close_region(b, region)


def thrown(b: Body) -> None:
    """Where a jump out of loops has arrived: these, which other functions may have counted, and those of Gotos."""
    b.emit("E.thrown(t, jump)")
    for at in sorted(b.thrown):
        b.emit(f"l{at} = None")
    for region in b.regions:
        at = region.at
        b.emit(
            f"if r{at} is not None and not {region.first} <= pc <= {region.last}: "
            f"E.looped(t, r{at}, {at}); r{at} = None"
        )


# ------------------------------------------------------------------------------------------------ the text


def _close(b: Body, at: int) -> None:
    b.emit(f"if t - l{at}[0] > {LEAST} or E.statements.base is not l{at}[1]: E.looped(t, l{at}, {at})")
    b.emit(f"l{at} = None")


def _close_region(b: Body, region: Region) -> None:
    at = region.at
    b.emit(f"if r{at} is not None: E.looped(t, r{at}, {at}); r{at} = None")
