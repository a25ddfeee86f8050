"""A move is loaded into the buffer, and no GO for it follows.

Going backward from every end of a part, each point gets the set of axes that a GO may still start behind it; a STOP
empties the buffer and removes its axis. A load is reported for the axes that are not in the set, a path if none of its
axes is, and if nothing that runs at the same time may start it.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from functools import partial, reduce
from operator import or_
from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import LOADS, spelt
from motionlang.kernel.mccl import table

if TYPE_CHECKING:
    from collections.abc import Collection

    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.lang import AxisKey as Key
    from motionlang.kernel.lang import Use
    from motionlang.kernel.mint.resolve.symbols import Function

# The bit of each axis in a set of axes.
Bits = dict["Key", int]
# A function that starts motion with its axis, and the bit of each in a set of these.
Start = tuple[str, "Key"]
StartBits = dict[Start, int]

_GO = frozenset(("go",))
# The roles of keywords that load one entry for several axes.
_OF_ONE_GO = frozenset(("path", "course"))
# What starts the motion of a mode of MCCL, by the function that selects the mode.
_STARTS = {"velocity_mode": "go", "contour_mode": "path"}


def check_mint(facts: MintFacts, warn: Warn) -> None:
    roots = [each for each in facts.functions if each.kind != "sub"]
    started = set().union(*(facts.touched(root, _GO) for root in roots))
    without_go = facts.triggered()
    for function in facts.functions:
        keys = (key for act in facts.acts_of[function] if act.role in LOADS for key in act.axes)
        bits = {key: 1 << n for n, key in enumerate(dict.fromkeys(keys))}
        if not bits:
            continue
        last = _behind_the_end(facts, function, bits, started)
        behind = facts.graph.backward(
            facts.points[function],
            lambda p, last=last: last if facts.leaves(p) else 0,  # type: ignore[misc]
            partial(_goes, facts, bits),
        )
        for p, _ in facts.nodes_of(function):
            for act in facts.acts[p]:
                if act.role not in LOADS or p not in facts.axes.before[function]:
                    continue
                waiting = [key for key in dict.fromkeys(act.axes) if not behind[p] & bits[key]]
                if act.role in _OF_ONE_GO and len(waiting) < len(set(act.axes)):
                    continue  # a path is one entry, which is in the buffers of all its axes
                if not waiting or {None, *waiting} & without_go:
                    continue
                if not _is_started_elsewhere(facts, function, replace(act, axes=tuple(waiting))):
                    what = "entry" if act.role == "entry" else "move"
                    names = ", ".join(map(spelt, waiting))
                    part = f" of axis {names}" if len(waiting) < len(set(act.axes)) else ""
                    message = f"the {what}{part} is loaded, but no GO for it follows"
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


def _is_started_elsewhere(facts: MintFacts, function: Function, act: Use) -> bool:
    """True if another task or a handler may start the move."""
    if None in act.axes:
        return True
    others = facts.touched_elsewhere(function, _GO)
    any_axis = any(isinstance(key, str) for key in act.axes)
    return bool(others & {*act.axes, None}) or (any_axis and bool(others))


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    """Report each mode whose motion nothing starts; what a macro prepares that nothing calls, a host may start."""
    started = {
        part: {each for act in facts.acts_of[part] for each in _starts_of(act)} for part in facts.parts
    }
    parts_with = Counter(each for found in started.values() for each in found)
    bits: StartBits = {each: 1 << n for n, each in enumerate(parts_with)}
    begins = {
        p: reduce(or_, (bits[each] for act in acts for each in _starts_of(act)), 0)
        for p, acts in facts.acts.items()
    }
    for part in facts.parts:
        modes = [
            (p, act, function)
            for p, _ in (facts.statements_of(part) if part.kind != "sub" else ())
            for act in (facts.acts[p] if p in facts.axes.before[part] else ())
            if act.row is not None and (function := _STARTS.get(act.row.function))
        ]
        if not modes:
            continue
        elsewhere = sum(bits[each] for each, count in parts_with.items() if count > (each in started[part]))
        behind = facts.graph.backward(
            facts.points[part], lambda p: 0, lambda p, later: later | begins.get(p, 0)
        )
        for p, act, function in modes:
            # The axis that controls a contour, the parameter of CM, starts its paths.
            axis = act.number(0) if function == "path" else act.axes[0]
            if not _is_started(bits, behind[p] | elsewhere, function, axis):
                word = table().doing(function)
                message = f"{facts.text(act)} selects a mode, and no {word} that starts its motion follows"
                number = "" if axis is None else f"{axis:.0f}"
                warn(
                    message,
                    act.at,
                    f"{number}{word}{'1 begins a path' if function == 'path' else ' starts it'}",
                )


def _starts_of(act: Use) -> list[Start]:
    """Return the motions that a command starts: what does it, and each axis."""
    function = act.row.function if act.row is not None else ""
    return [(function, key) for key in act.axes or ("",)] if function in _STARTS.values() else []


def _is_started(bits: StartBits, behind: int, function: str, axis: Key | float) -> bool:
    """True if what is behind a mode, or in another part, starts its motion."""
    return any(
        behind & bit
        for (starting, key), bit in bits.items()
        if starting == function and (axis is None or key is None or key == axis)
    )


RULE = Rule(
    code="never-started",
    text="""\
A move is loaded into the buffer, and on every path from there the buffer is emptied (STOP, CANCEL, RESET) or the
program ends before a GO of its axis. These count as a GO: another task, a handler, the caller of the sub, and a
TRIGGERMODE that starts moves by itself. `MOVEA(0, 1) = 10, 20` loads a move for each axis, and each needs its GO. For a
path of several axes the GO of any of them counts; in a run only that of its first axis starts it
(`motion.go-of-a-path`). A run that ends with a move in a buffer names it, too, also one that a
GO has released and that waits, as for the end of a jog.

In MCCL, VM selects velocity mode and no GO of the axis follows, or CM joins a contour and no CP of the controlling axis
follows.
""",
    fix="write GO after the move",
    mint=RuleCase(
        check_mint,
        wrong="MOVER(0) = 5\n",
        right="MOVER(0) = 5\nGO(0)\n",
    ),
    mccl=RuleCase(check_mccl, wrong="1MN,1VM\n", right="1MN,1VM,1GO\n"),
)
