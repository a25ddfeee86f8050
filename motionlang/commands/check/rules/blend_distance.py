"""A BLENDDISTANCE exceeds half of a path, which is the most that a blend takes.

The last path of a set of axes has no blend after it and is not checked.
"""

from __future__ import annotations

from math import hypot
from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import spelt

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.lang import Use

# The fraction of a path that a blend into the next one may take.
SHARE = 0.5


def check(facts: MintFacts, warn: Warn) -> None:
    word = facts.word("blend_distance")
    distances, modes = facts.constants(word), facts.constants(facts.word("blend_mode"))
    paths = list(facts.written_by(lambda row: row.role == "path"))
    last = {act.axes: act for act in sorted(paths, key=lambda act: act.at)}
    for act in paths:
        key, length = act.axes[0], _length(act)
        given = None if None in distances else distances.get(key)
        if not length or not given or not modes.get(key) or act is last[act.axes]:
            continue
        if min(given) > SHARE * length:
            assert act.row is not None
            message = (
                f"{word} of axis {spelt(key)} is {min(given):.10g}, but a blend takes at most "
                f"{SHARE * length:g} of this {act.row.name}"
            )
            warn(message, act.at, "set it to half of the shortest path, or less")


def _length(act: Use) -> float | None:
    """Return the length of a relative straight path, None if it is unknown."""
    values = [value.number for value in act.values]
    numbers = [value for value in values if value is not None]
    if act.row is None or not (act.row.does("line") and act.row.does("relative")):
        return None
    return hypot(*numbers) if len(numbers) == len(values) else None


RULE = Rule(
    code="blend-distance",
    group="Motion",
    text="""\
Each path begins at BLENDDISTANCE before the end of the path before it, but overlaps at most half of that path. A
distance of 6 on a path of 10 acts like 5, and the run records a `clamp` event.
""",
    fix="set BLENDDISTANCE to at most half of the shorter path",
    mint=RuleCase(
        check,
        wrong=(
            "BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 6\nVECTORR(0, 1) = 10, 0\nVECTORR(0, 1) = 0, 20\nGO(0)\n"
        ),
        right=(
            "BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 4\nVECTORR(0, 1) = 10, 0\nVECTORR(0, 1) = 0, 20\nGO(0)\n"
        ),
    ),
)
