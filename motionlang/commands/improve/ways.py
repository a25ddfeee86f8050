"""The final edits, played in all ways that the machine can go: time-outs, rejects, other keys of a menu.

A trial shows one way in each world. So the program is explored, and each of its ways is played with the edits, too.
What the edits are for does not count: speeds, times, figures in prints, and where a motion is cut off. If the program
ends otherwise in a way, or prints another line, the edits are refused; if it only does something else, such as behind a
fixed second that comes earlier in a move than before, the way is named.

Cost. At most `EXPLORED` for the exploration, and `PLAYED` for the ways. What is not played is named.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from motionlang.commands.diff.acts import ComparedAct, PlayedWay
from motionlang.commands.diff.ways import FoundDifference, Player, compared_ways
from motionlang.commands.diff.ways_view import found_words, input_names, not_compared, way_words
from motionlang.exploration import HORIZON, SECOND, Timeline, explore, without_figures, without_world
from motionlang.kernel import Program
from motionlang.kernel.tools import count_of

# The work of the exploration of the program, in seconds of an ordinary core, and that of both programs in the ways.
EXPLORED, PLAYED = 2.0, 2.0 * SECOND


class PlayedWays(NamedTuple):
    """The differences that edits make: a sentence about all ways, those that refuse the edits, and the others."""

    summary: str
    refused: list[str]
    elsewhere: list[str]


class _WithoutTimes(Player):
    """A program whose speeds, figures in prints, and places where a motion is cut off do not count."""

    def play(self, timeline: Timeline, since: float = 0.0, patience: float = HORIZON) -> PlayedWay:
        played = super().play(timeline, since, patience)
        acts = {task: [*map(_without_times, some)] for task, some in played.acts.items()}
        return played._replace(acts=acts)


def _without_times(act: ComparedAct) -> ComparedAct:
    if act.exact:
        return act._replace(speed=0.0, target=None if act.is_cut else act.target)
    return act if act.subject else act._replace(words=without_figures(act.words))


def played_ways(
    program: Program, values: Mapping[str, float | str], settings: Mapping[str, object]
) -> PlayedWays:
    """Play a program, a debug build, with other values in the ways that an exploration finds; return what differs."""
    own = without_world(settings)
    a = explore(program, own, seconds=EXPLORED)
    b = explore(program.with_values(values), {**a.switches.settings, **own}, seconds=0.0)
    found = compared_ways(_WithoutTimes(a), _WithoutTimes(b), PLAYED)
    names = input_names(a)
    texts: dict[bool, list[str]] = {True: [], False: []}
    differences = [each for each in (*found.differences, *found.behind) if not _is_beyond(each)]
    for each in differences:
        texts[_is_grave(each)].append(f"{way_words(each.way, names)}: {found_words(each)}")
    differ = f", {found.differ} differ" if differences else ": the same but for time"
    left = not_compared(found, explored="A")
    summary = f"{count_of(found.played, 'way')} played with the edits, too{differ}"
    return PlayedWays(f"{summary}; not compared: {left}" if left else summary, texts[True], texts[False])


def _is_beyond(found: FoundDifference) -> bool:
    """True if the faster program has only done more when the play of the other one was cut, or has come to its end."""
    difference = found.difference
    if found.a.status != "waits" or found.a.is_at_rest:
        return False
    if difference.end is not None:
        return found.b.status == "ended"
    return bool(difference.b) and not difference.a and found.b.ordered[-1] in difference.b


def _is_grave(found: FoundDifference) -> bool:
    """True if a program ends otherwise, or prints another line."""
    difference = found.difference
    if difference.end is not None:
        return found.a.status != found.b.status
    return not difference.is_order and any(not act.subject for act in (*difference.a, *difference.b))
