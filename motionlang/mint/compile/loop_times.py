"""Code with which loops log their times, so that a profile can charge them.

The profile needs this for loops that poll or compute.

    l7 = t, E.statements.base
    while …: …
    if t - l7[0] > 100.0 or E.statements.base is not l7[1]: E.looped(t, l7, 7)
    l7 = None

The variable is named after the source offset of the loop. If a task is still in a loop, or has left it by an
exception, the frame shows when the loop began. A loop shorter than `MIN_STATEMENTS` statements that never waited
leaves no record. Iterations do not become slower, as nothing is added to them.

A call of a sub outside loops is logged in the same way, so that computing outside the sub's loops is charged, too.

A backward Goto makes a loop of the stretches from its label to the last jump back to it. The loop begins when
its label is reached. It ends after the statement with that last jump, or at a jump to a stretch outside the
loop.
"""

from __future__ import annotations

from motionlang.lang.task import MIN_STATEMENTS
from motionlang.mint.compile.body import Body
from motionlang.mint.compile.lines import Line
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import walk


class Region:
    """A loop of Gotos: the stretches `first` to `last`.

    `end` is the statement with the last jump back.
    """

    __slots__ = ("at", "end", "first", "last")

    def __init__(self, at: int, first: int) -> None:
        self.at, self.first = at, first
        self.last = self.end = -1


def begin(b: Body) -> None:
    """Write the start of the record before a loop; `t` is up to date."""
    b.timed.append(b.at)
    b.emit(f"l{b.at} = t, E.statements.base")


def end(b: Body) -> None:
    """Write the end of the record after a loop."""
    _close(b, b.timed.pop())


def call(b: Body, node: nodes.Stmt, begin: int) -> None:
    """Log a statement that calls a sub, like a loop.

    The statement's lines start at line `begin`. It is not logged if the sub waits, because the source offsets of
    the waits identify it; in a loop, whose iterations must not change; or if the sub calls itself, because the
    first call is enough.
    """
    if type(node) not in (nodes.Call, nodes.Assign) or b.callee is None or b.callee is b.function:
        return
    at = node.start
    b.lines.insert(begin, Line(b.indent, f"l{at} = t, E.statements.base", at))
    b.emit(
        f"if t - l{at}[0] > {MIN_STATEMENTS} and E.statements.base is l{at}[1]: "
        f"E.looped(t, l{at}, {b.callee.at}, ({at},))"
    )
    b.emit(f"l{at} = None")


def leave(b: Body) -> None:
    """Close the records of all loops that a return from the function leaves."""
    for at in reversed(b.timed):
        _close(b, at)
    for region in b.regions:
        _close_region(b, region)


# ---------------------------------------------------------------------------------------------------- Goto


def regions(b: Body) -> list[Region]:
    """Return the loops formed by the Gotos of a function."""
    found: dict[int, Region] = {}
    labels = [node for node in b.function.body if type(node) is nodes.Label]
    for number, (_, body) in enumerate(b.stretches()):
        for index, statement in enumerate(body):
            for node in walk([statement]):
                if type(node) is not nodes.Jump or node.kind == "gosub":
                    continue
                first = b.labels().get(node.name.lower(), number + 1)
                if 0 < first <= number:
                    region = found.setdefault(first, Region(labels[first - 1].start, first))
                    region.last, region.end = number, index + 1
    return list(found.values())


def open_regions(b: Body) -> None:
    """Open the record of the loop that begins with the label of this stretch.

    A loop that is already open is not changed.
    """
    for region in b.regions:
        if region.first == b.stretch:
            b.emit(f"if r{region.at} is None: r{region.at} = t, E.statements.base")


def close_regions(b: Body, index: int) -> None:
    """Close the records of the loops whose last jump back is the preceding statement."""
    for region in b.regions:
        if (region.last, region.end) == (b.stretch, index):
            b.flush()
            _close_region(b, region)


def left(b: Body, number: int) -> list[Region]:
    """Return the loops of Gotos that a jump to a stretch leaves."""
    return [
        region
        for region in b.regions
        if region.first <= b.stretch <= region.last and not region.first <= number <= region.last
    ]


def jump(b: Body, number: int) -> None:
    """Close the records of the loops that a jump leaves; no other loop encloses it."""
    for region in left(b, number):
        _close_region(b, region)


def thrown(b: Body) -> None:
    """Close the records of loops that a jump has left by an exception.

    Some of these loops may be in other functions. Loops of Gotos are closed, too.
    """
    b.emit("E.thrown(t, jump)")
    for at in sorted(b.thrown):
        b.emit(f"l{at} = None")
    for region in b.regions:
        at = region.at
        b.emit(
            f"if r{at} is not None and not {region.first} <= pc <= {region.last}: "
            f"E.looped(t, r{at}, {at}); r{at} = None"
        )


# ----------------------------------------------------------------------------------------- loops and calls


def _close(b: Body, at: int) -> None:
    b.emit(
        f"if t - l{at}[0] > {MIN_STATEMENTS} or E.statements.base is not l{at}[1]: E.looped(t, l{at}, {at})"
    )
    b.emit(f"l{at} = None")


def _close_region(b: Body, region: Region) -> None:
    at = region.at
    b.emit(f"if r{at} is not None: E.looped(t, r{at}, {at}); r{at} = None")
