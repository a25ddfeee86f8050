"""A scale is set after a speed or a rate, whose value in user units it changes, and a move uses that value."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import spelt
from motionlang.kernel.mccl import table
from motionlang.kernel.tools import listed

if TYPE_CHECKING:
    from motionlang.commands.check.axis_state import AxisFacts
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.commands.check.rule_facts import Facts
    from motionlang.kernel.lang import AxisKey as Key

# The settings that a scale changes, in the order of a message.
_ORDER = ("speed", "accel", "decel", "minimum", "vector speed", "vector accel", "vector decel")
_LIMITS = {"upper limit": "SOFTLIMITFORWARD", "lower limit": "SOFTLIMITREVERSE"}


def check_mint(facts: MintFacts, warn: Warn) -> None:
    for (key, _), axis in _first_motions(facts).items():
        words = ", ".join(sorted(_LIMITS.get(each, each.upper()) for each in axis.stale))
        message = f"the scale of axis {spelt(key)} is set after {words}, whose value it changes"
        assert axis.scaled is not None
        warn(message, axis.scaled, "set the scale first")


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    names = {row.gives: row.name for row in table()}
    for (key, _), axis in _first_motions(facts).items():
        stale = [names[slot] for slot in _ORDER if slot in axis.stale]
        if not stale:  # soft limits are counts, whichever scale comes first
            continue
        words, verb = listed(stale), "are" if len(stale) > 1 else "is"
        assert axis.scaled is not None
        message = (
            f"the scale of axis {key} is in force only from MN on: {words} before it {verb} in the old unit"
        )
        warn(message, axis.scaled, f"set {words} behind the {key}MN that follows it")
    for act, key, _ in facts.axes.problems.get("scale-pending", ()):
        message = f"{facts.text(act)} is in the old unit: the scale of axis {key} is in force only from the next MN on"
        warn(message, act.at, f"{key}MN before it puts it in force")


def _first_motions(facts: Facts) -> dict[tuple[Key, int | None], AxisFacts]:
    """Return what is known of an axis at its first motion, by the axis and the offset of the scale before it."""
    found = facts.axes.problems.get("scale-after-speed", [])
    return {(key, axis.scaled): axis for _, key, axis in reversed(found)}


RULE = Rule(
    code="scale-after-speed",
    text="""\
SPEED, ACCEL, software limits and similar settings are stored in counts, so a later SCALEFACTOR changes their value in
user units. For example, 250 mm/s set at scale 1 is 250 counts per second; after `SCALE(0) = 1200` it is about a fifth
of a millimetre per second. Set the scale first. The warning is at the scale, and appears only if a move uses such a
setting before it is set again.

In MCCL a US is in force only from the next MN on. Speeds, rates and moves between the two are in counts: behind
`1US1200,1SV250,1SA1250,1MN` an axis moves at 250 counts per second, a fifth of a millimetre. The same holds for a path
and its VV, VA and VD.
""",
    fix="set the scale first",
    mint=RuleCase(
        check_mint,
        wrong="SPEED(0) = 250\nSCALE(0) = 1200\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
        right="SCALE(0) = 1200\nSPEED(0) = 250\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
    ),
    mccl=RuleCase(
        check_mccl,
        wrong="1US1200,1SV250,1SA1250,1DS1250,1MN\n1MR200,1WS\n",
        right="1US1200,1MN,1SV250,1SA1250,1DS1250\n1MR200,1WS\n",
    ),
)
