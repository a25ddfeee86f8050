"""A scale is set after a speed or a rate, whose value in user units it changes, and a move uses that value."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.facts import spelt
from motionlang.commands.check.rule import Case, Rule, Warn

if TYPE_CHECKING:
    from motionlang.commands.check.mint.facts import MintFacts


def check(facts: MintFacts, warn: Warn) -> None:
    for _, key, axis in facts.axes.problems.get("scale-after-speed", ()):
        words = ", ".join(sorted(each.upper() for each in axis.stale))
        message = f"the scale of axis {spelt(key)} is set after {words}, whose value it changes"
        assert axis.scaled is not None
        warn(message, axis.scaled, "set the scale first")


RULE = Rule(
    code="scale-after-speed",
    group="Motion",
    text="""\
SPEED, ACCEL and similar settings are stored in counts, so a later SCALEFACTOR changes their value in user units. For
example, 250 mm/s set at scale 1 is 250 counts per second; after `SCALE(0) = 1200` it is about a fifth of a millimetre
per second. Set the scale first. The warning is at the scale, and appears only if a move uses such a setting before it
is set again.
""",
    fix="set the scale first",
    mint=Case(
        check,
        wrong="SPEED(0) = 250\nSCALE(0) = 1200\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
        right="SCALE(0) = 1200\nSPEED(0) = 250\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
    ),
)
