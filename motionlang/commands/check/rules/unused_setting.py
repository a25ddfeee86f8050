"""A speed or a rate is set, and set again, or the program ends, before any move uses it.

Going backward from every end of a part, each point gets the set of settings, one bit for each property of each axis,
that a move behind it may use. Axes that another task or handler uses are left out.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from motionlang.commands.check.axis_state import COMMANDS, IDLE
from motionlang.commands.check.reach import LOWER, UPPER
from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import Facts, Part, spelt
from motionlang.kernel.lang import RETURN, Use
from motionlang.kernel.lang import AxisKey as Key

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts

# A bit for each property of each axis.
Bits = dict[tuple["Key", str], int]

TOUCHES = COMMANDS | {"read", "slot", "use"}
# Roles of keywords that use no setting.
_IDLE = frozenset(("scale", "rescale", "enable", "mode"))


def check(facts: Facts, warn: Warn) -> None:
    for part in facts.parts:
        bits = _slot_bits(facts, part)
        if not bits:
            continue
        everything = (1 << len(bits)) - 1
        ends = part.kind == "main" and not facts.outlasts_text
        last = _left_over(facts, part, bits) if ends else everything
        behind = facts.graph.backward(
            facts.points[part],
            lambda p, last=last: last,  # type: ignore[misc]
            partial(_used, facts, bits, everything),
        )
        for p, _ in facts.statements_of(part):
            if p in facts.axes.before[part]:
                _check_point(facts, p, behind[p], bits, warn)


def _slot_bits(facts: Facts, part: Part) -> Bits:
    """Assign a bit to each property of each axis that only this part uses."""
    found: Bits = {}
    if len(facts.roots[part]) > 1:  # it runs in more than one task or handler
        return found
    others = facts.touched_elsewhere(part, TOUCHES)
    for act in facts.acts_of[part]:
        if act.role == "slot":
            assert act.row is not None
            for key in act.axes:
                alone = not {key, None} & others and not (isinstance(key, str) and others)
                if key is not None and alone:
                    found.setdefault((key, act.row.gives), 1 << len(found))
    return found


def _left_over(facts: Facts, part: Part, bits: Bits) -> int:
    """Return the settings that still matter at the end of the parent task.

    These are the settings of axes that may still be in motion.
    """
    found = 0
    for p, state in facts.axes.before[part].items():
        if not facts.graph.within[p]:
            for (key, _), bit in bits.items():
                if facts.axes.known(state, key).motion != IDLE:
                    found |= bit
    return found


def _used(facts: Facts, bits: Bits, everything: int, p: int, behind: int) -> int:
    """Return the settings that are used from a point on, of those that are used behind it."""
    statement = facts.statement_at.get(p)
    if facts.graph.points[p].kind == RETURN or (
        statement is not None and (statement.waits or statement.starts)
    ):
        return everything
    for act in reversed(facts.acts.get(p, ())):
        assert act.row is not None or act.role == "call"
        if act.role == "slot" and act.row is not None:
            if len(set(act.axes)) == len(act.axes):
                for key in act.axes:
                    behind &= ~bits.get((key, act.row.gives), 0)
        elif act.role == "call" or None in act.axes or (act.row is not None and act.row.function == "wait"):
            behind = everything
        elif act.role not in _IDLE:
            for (key, _), bit in bits.items():
                if key in act.axes or any(isinstance(each, str) for each in act.axes):
                    behind |= bit
    return behind


def _check_point(facts: Facts, p: int, behind: int, bits: Bits, warn: Warn) -> None:
    for act in facts.acts[p]:
        if act.role != "slot":
            continue
        assert act.row is not None
        slot, word = act.row.gives, act.row.name
        dead = [key for key in act.axes if (bit := bits.get((key, slot), 0)) and not behind & bit]
        # `SPEED(0, 1, 2) = 10;` followed by an exception for one of the axes is good style.
        if not dead or len(dead) < len(act.axes):
            continue
        later = _next_setting(facts, p, dead[0], slot)
        if later is None:
            message = f"{word} of axis {spelt(dead[0])} is set but no longer used"
            warn(message, act.at, "remove it, or set it before the move that needs it")
        else:
            assert later.row is not None
            by = f"{later.row.name} in line {facts.structure.line(later.at)}"
            message = f"{word} of axis {spelt(dead[0])} is replaced by {by} before any move"
            warn(message, act.at, "remove one of the two")


def _next_setting(facts: Facts, p: int, key: Key, slot: str) -> Use | None:
    seen: set[int] = set()
    stack = list(reversed(facts.graph.within[p]))
    while stack:
        each = stack.pop()
        if each in seen:
            continue
        seen.add(each)
        for act in facts.acts.get(each, ()):
            if act.role == "slot" and key in act.axes and act.row is not None and act.row.gives == slot:
                return act
        stack.extend(reversed(facts.graph.within[each]))
    return None


def check_mint(facts: Facts, warn: Warn) -> None:
    check(facts, warn)
    modes = facts.values(lambda row: row.function == "feedrate_mode")
    for act in facts.written_by(lambda row: row.function == "override"):
        for k, key in enumerate(act.axes):
            known = [modes.get(each, []) for each in (key, None)]
            acts = any(each is None or any(int(value) & 2 for value in each) for each in known)
            if key is not None and not acts and act.number(k) not in (None, 100):
                assert act.row is not None
                message = (
                    f"{act.row.name} of axis {spelt(key)} has no effect: bit 1 of FEEDRATEMODE is never set"
                )
                warn(message, act.at, f"FEEDRATEMODE({spelt(key)}) = 2 makes it act")


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    check(facts, warn)
    enabled: dict[str, set[Key]] = {UPPER: set(), LOWER: set()}
    for act in facts.written_by(lambda row: row.function == "limits_on"):
        for side in facts.limited(act, 0, frozenset()):
            enabled[side].update(act.axes)
    for side in (UPPER, LOWER):
        for act in facts.written_by(lambda row, side=side: row.does(side)):  # type: ignore[misc]
            for key in act.axes:
                if key is not None and not {key, None} & enabled[side]:
                    assert act.row is not None
                    message = f"{act.row.name} of axis {key} has no effect: no line of this file enables it"
                    warn(message, act.at, f"{key}LN12 enables both software limits")


RULE = Rule(
    code="unused-setting",
    text="""\
The program sets a speed, a rate, a jerk or the shape of moves, and sets it again, or ends, before any motion can use
it. ACCEL and ACCELTIME are the same setting: the later one counts. While the axis moves, and if another task uses the
axis, every setting counts as used.

In Mint also: FEEDRATEOVERRIDE, where no statement sets bit 1 of FEEDRATEMODE, without which it does not act. In MCCL
the settings are SV, SA, DS, MV, VV, VA, VD, HL, LL and the shape of profiles, and HL and LL also where no LN enables
them.
""",
    fix="remove the setting, or move it in front of the motion that needs it",
    mint=RuleCase(
        check_mint,
        wrong="SPEED(0) = 100\n",
        right="SPEED(0) = 100\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
    ),
    mccl=RuleCase(check_mccl, wrong="1MN,1SV1000,1SV2000\n1MR100,1WS\n", right="1MN,1SV2000\n1MR100,1WS\n"),
)
