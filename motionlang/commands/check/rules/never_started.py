"""A move is loaded into the buffer, and no GO for it follows.

Going backward from every end of a part, each point gets the set of axes that a GO may still start behind it; a STOP
empties the buffer and removes its axis. A load is reported if none of its axes is in the set, and if nothing that runs
at the same time may start it.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from motionlang.commands.check.facts import spelt
from motionlang.commands.check.mint.buffers import LOADS, triggered
from motionlang.commands.check.rule import Case, Rule, Warn

if TYPE_CHECKING:
    from collections.abc import Collection

    from motionlang.commands.check.facts import Part
    from motionlang.commands.check.mint.facts import MintFacts
    from motionlang.kernel.lang import AxisKey as Key
    from motionlang.kernel.lang import Use
    from motionlang.kernel.mint.resolve.symbols import Function

# The bit of each axis in a set of axes.
Bits = dict["Key", int]

_GO = frozenset(("go",))


def check(facts: MintFacts, warn: Warn) -> None:
    started: dict[Part, set[Key]] = {
        root: facts.touched(root, _GO) for root in facts.functions if root.kind != "sub"
    }
    without_go = triggered(facts)
    for function in facts.functions:
        keys = (key for act in facts.acts_of[function] if act.role in LOADS for key in act.axes)
        bits = {key: 1 << n for n, key in enumerate(dict.fromkeys(keys))}
        if not bits:
            continue
        last = _behind_the_end(facts, function, bits, set().union(*started.values()))
        behind = facts.graph.backward(
            facts.points[function],
            lambda p, last=last: last if facts.leaves(p) else 0,  # type: ignore[misc]
            partial(_goes, facts, bits),
        )
        for p, _ in facts.nodes_of(function):
            for act in facts.acts[p]:
                if act.role not in LOADS or p not in facts.axes.before[function]:
                    continue
                own = sum(bits[key] for key in set(act.axes))
                if behind[p] & own or {None, *act.axes} & without_go:
                    continue
                if not _is_started_elsewhere(facts, function, act, started):
                    what = "entry" if act.role == "entry" else "move"
                    names = ", ".join(map(spelt, act.axes))
                    message = f"the {what} is loaded, but no GO for it follows"
                    warn(message, act.at, f"GO({names}) starts the buffered moves")


def _behind_the_end(facts: MintFacts, function: Function, bits: Bits, started: set[Key]) -> int:
    """Return the axes that may be started after a function returns.

    The caller of a sub may start them, or the code that a v4 handler has interrupted.
    """
    if function.kind != "sub" and not facts.entries[function][1:]:
        return 0
    return sum(
        bit for key, bit in bits.items() if {key, None} & started or (isinstance(key, str) and started)
    )


def _goes(facts: MintFacts, bits: Bits, p: int, behind: int) -> int:
    """Return the axes that may be started from a point on, of those that may be started behind it."""
    for act in reversed(facts.acts.get(p, ())):
        if act.role == "go":
            behind = _with(behind, act.axes, bits)
        elif act.role == "stop" and None not in act.axes:
            for key in act.axes:
                behind &= ~bits.get(key, 0)
        elif act.callee:
            started = {facts.outer(act, key) for key in facts.touched(facts.callee(act), _GO)}
            behind = _with(behind, started, bits)
    return behind


def _with(behind: int, axes: Collection[Key], bits: Bits) -> int:
    for key in axes:
        if key is None or isinstance(key, str) is not any(isinstance(each, str) for each in bits):
            return behind | sum(bits.values())
        behind |= bits.get(key, 0)
    return behind


def _is_started_elsewhere(
    facts: MintFacts, function: Function, act: Use, started: dict[Part, set[Key]]
) -> bool:
    """True if another task or a handler may start the move."""
    if None in act.axes:
        return True
    mine = facts.roots[function]
    others = set().union(*(keys for root, keys in started.items() if root not in mine))
    any_axis = any(isinstance(key, str) for key in act.axes)
    return bool(others & {*act.axes, None}) or (any_axis and bool(others))


RULE = Rule(
    code="never-started",
    group="Motion",
    text="""\
A move is loaded into the buffer, and on every path from there the buffer is emptied (STOP, CANCEL, RESET) or the
program ends before a GO of its axis. These count as a GO: another task, a handler, the caller of the sub, and a
TRIGGERMODE that starts moves by itself. A move of several axes needs the GO of only one of them. A run that ends with
such a move in a buffer also warns of it.
""",
    fix="write GO after the move",
    mint=Case(
        check,
        wrong="MOVER(0) = 5\n",
        right="MOVER(0) = 5\nGO(0)\n",
    ),
)
