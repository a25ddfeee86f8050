"""The rules behind what a hand does to inputs; the delay is that of the hand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from motionlang.kernel import Axis, Machine
from motionlang_explore.exploration import Change
from motionlang_explore.identification import Entry, Observation, channels, place, rules_of
from motionlang_explore.identification.positions import Series

# A hand is so long after its cause at most, and its delays vary by so much, s.
MAX_DELAY, REACTION = 1.0, 0.3
# The keys of what a hand reacts to.
CAUSES = {"output", "axis", "asked"}
# Rows of the position of an axis, and the time from a change to those next to it, s.
ROWS, NEXT = 5000, 0.01


def rules(
    changes: Sequence[tuple[float, Change]], machine: Machine, asked: Mapping[tuple[int, float], float]
) -> dict[int, Entry]:
    """Return an entry of the machine file for each input whose changes have a cause, by its number.

    `asked` has for how long the program has asked for a change, s, by the input and the time.
    """
    inputs = channels((each.number, time, each.value) for time, each in changes if each.table == "input")
    times = [time for time, _ in changes]
    now = machine.clock.now
    seen = Observation(
        0.0,
        now,
        outputs=channels((each.channel, each.time, each.value) for each in machine.log.outputs),
        positions={number: _path(a, times, now) for number, a in machine.controller.axes.items()},
        asked=asked,
        reaction=REACTION,
    )
    found = {}
    for number, channel in inputs.items():
        for rule in rules_of(number, channel, seen):
            (entry, *more) = rule.entries
            if entry.keys() & CAUSES and not more and rule.delay <= MAX_DELAY:
                found[number] = entry
                break
    return found


def _path(a: Axis, changed: Sequence[float], now: float) -> Series:
    """Return the positions of an axis, with rows next to each change."""
    near = [each + apart for each in changed for apart in (-NEXT, 0.0, NEXT)]
    times = np.unique(np.clip([*np.linspace(0.0, now, ROWS), *near], 0.0, now))
    return Series("", times, np.array([place(a, time) for time in times.tolist()]), is_exact=True)
