"""The check for a BLENDDISTANCE that exceeds half a path.

A blend takes at most half of a path.
"""

from __future__ import annotations

from collections.abc import Callable
from math import hypot

from motionlang.commands.check.facts import spelt
from motionlang.commands.check.mint.facts import MintFacts
from motionlang.kernel.lang import Use

Add = Callable[..., None]

# The fraction of a path that a blend into the next one may take.
SHARE = 0.5


def check_blends(facts: MintFacts, add: Add) -> None:
    """Warn of each path shorter than twice a BLENDDISTANCE that its axis is given.

    The last path of a set of axes has no blend after it and is not checked.
    """
    word = facts.word("blend_distance")
    distances, modes = facts.constants(word), facts.constants(facts.word("blend_mode"))
    paths = list(facts.written_by(lambda row: row.role == "path"))
    last = {act.axes: act for act in sorted(paths, key=lambda act: act.at)}
    for act in paths:
        key, length = act.axes[0], _length(facts, act)
        given = None if None in distances else distances.get(key)
        if not length or not given or not modes.get(key) or act is last[act.axes]:
            continue
        if min(given) > SHARE * length:
            assert act.row is not None
            message = (
                f"{word} of axis {spelt(key)} is {min(given):.10g}, but a blend takes at most "
                f"{SHARE * length:g} of this {act.row.name}"
            )
            add("blend-distance", message, act.at, "set it to half of the shortest path, or less")


def _length(facts: MintFacts, act: Use) -> float | None:
    """Return the length of a relative straight path, None if it is unknown."""
    values = [value.number for value in act.values]
    numbers = [value for value in values if value is not None]
    if act.row is None or not (act.row.does("line") and act.row.does("relative")):
        return None
    return hypot(*numbers) if len(numbers) == len(values) else None
