"""The rules behind what a hand does: an input whose changes each follow a change of an output.

An input may also be on for some time after each change of an output to a level. The exploration describes its world in
this way; here the delay is that of the hand.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import fsum, inf

from motionlang.exploration import Change, Entry, explains, lead
from motionlang.kernel import Machine

# A rule explains so many changes at least, and the output changes so long before them at most, s.
MIN_CHANGES, MAX_DELAY = 2, 1.0
Levels = list[tuple[float, float]]
Switches = list[tuple[float, int]]


def rules(changes: Sequence[tuple[float, Change]], machine: Machine) -> dict[int, Entry]:
    """Return an entry of the machine file for each input whose changes an output explains, by its number."""
    switched: dict[int, Switches] = defaultdict(list)
    for each in machine.log.outputs:
        switched[each.channel].append((each.time, int(bool(each.value))))
    levels: dict[int, Levels] = defaultdict(list)
    for time, change in changes:
        if change.table == "input" and isinstance(change.value, (int, float)):
            before = levels[change.number][-1][1] if levels[change.number] else 0.0
            if change.value != before:
                levels[change.number].append((time, change.value))
    return {
        number: {"channel": number, **rule}
        for number, mine in levels.items()
        if len(mine) >= MIN_CHANGES
        if (rule := _rule(mine, switched)) is not None
    }


def _rule(mine: Levels, switched: Mapping[int, Switches]) -> Entry | None:
    """Return the rule of the output that changes latest before an input does; None if there is none."""
    ons = [each for each in mine if each[1]]
    for output in sorted(switched, key=lambda each: (lead(ons[1:] or ons, switched[each]), each)):
        found = switched[output]
        if explains(mine, found, 0) and (delay := _delay(mine, found)) is not None:
            return {"output": output, "delay": delay}
        pulses = [pulse for level in (1, 0) if (pulse := _pulse(mine, ons, found, level)) is not None]
        if pulses:
            return {"output": output, **min(pulses, key=lambda each: each["delay"])}  # type: ignore[arg-type,return-value]
        is_off_by_it = bool(mine[0][1]) and mine[0][0] < found[0][0] and len(ons) > 1
        if is_off_by_it and explains(mine, found, 1) and (delay := _delay(mine[1:], found)) is not None:
            return {"output": output, "delay": delay, "value": 0}
    return None


def _pulse(mine: Levels, ons: Levels, found: Switches, level: int) -> Entry | None:
    """Return the rule of an input that is on for some time after each change of an output to a level."""
    edges = [each for each in found if each[1] == level]
    is_each = len(ons) > 1 and all(_is_between(edges, *pair) for pair in pairwise([(-inf, 0.0), *ons]))
    delay = _delay(ons, edges) if is_each else None
    if delay is None:
        return None
    lengths = [end - begin for (begin, on), (end, _) in pairwise(mine) if on]
    length = round(fsum(lengths) / len(lengths), 2)
    return {"delay": delay, "for": length, **({} if level else {"level": 0})}


def _delay(mine: Levels, found: Switches) -> float | None:
    """Return the time by which an output changes before an input, s; None if that is too long."""
    delay = round(lead(mine, found), 2)
    return delay if delay <= MAX_DELAY else None


def _is_between(edges: Switches, before: tuple[float, float], on: tuple[float, float]) -> bool:
    """True if an output changes between two times at which an input comes on."""
    return any(before[0] < time <= on[0] for time, _ in edges)


def in_words(entry: Mapping[str, object]) -> str:
    """Return a rule in words."""
    if "for" in entry:
        change = "off" if entry.get("level") == 0 else "on"
        return (
            f"on for {entry['for']} s, {entry.get('delay', 0)} s after output {entry['output']} goes {change}"
        )
    inverted = ", inverted," if entry.get("value") == 0 else ""
    delay = f" after {entry['delay']} s" if entry.get("delay") else ""
    return f"follows output {entry['output']}{inverted}{delay}"
