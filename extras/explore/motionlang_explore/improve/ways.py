"""The final edits, played in all ways that the machine can go: time-outs, rejects, other keys of a menu.

A trial shows one way in each world. So the program is explored, and each of its ways is played with the edits, too.
What the edits are for does not count: speeds, times, figures in prints, and where a motion is cut off. If the program
ends otherwise in a way, or prints another line, or if another axis is elsewhere as it does something, the edits are
refused; if it only does something else, such as behind a fixed second that comes earlier in a move than before, the way
is named.

Cost. At most `EXPLORED` for the exploration, and `PLAYED` for the ways. What is not played is named.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from motionlang.comparison.acts import ComparedAct, PlayedWay
from motionlang.comparison.texts import without_figures
from motionlang.kernel import Program
from motionlang.kernel.tools import count_of
from motionlang_explore.diff.ways import FoundDifference, Player, Way, compared_ways
from motionlang_explore.diff.ways_view import found_words, input_names, not_compared, way_words
from motionlang_explore.exploration import (
    HORIZON,
    SECOND,
    Exploration,
    Progress,
    Timeline,
    explore,
    without_world,
)
from motionlang_explore.improve.behaviour import Behaviour
from motionlang_explore.improve.tasks import Tasks

# The exploration of the program, and both programs in the ways, may take so many seconds of an ordinary core.
EXPLORED, PLAYED = 2.0, 2.0


class PlayedWays(NamedTuple):
    """The differences that edits make: a sentence about all ways, those that refuse the edits, and the others."""

    summary: str
    refused: list[str]
    elsewhere: list[str]


class _WithoutTimes(Player):
    """A program whose speeds, figures in prints, and places where a motion is cut off do not count.

    `elsewhere` is why an axis is elsewhere than in the `other` program in the ways of that one, "" if it is not.
    """

    def __init__(self, exploration: Exploration, tasks: Tasks, other: _WithoutTimes | None = None) -> None:
        super().__init__(exploration)
        self._tasks, self._other = tasks, other
        self._played: tuple[Timeline, Behaviour] | None = None
        self.elsewhere: dict[Timeline, str] = {}

    def play(self, timeline: Timeline, since: float = 0.0, patience: float = HORIZON) -> PlayedWay:
        played = _without_times(super().play(timeline, since, patience))
        if self._other is None:
            self._played = timeline, Behaviour(self.exploration.last, self._tasks, None)
        elif self._other._played is not None:
            way, behaviour = self._other._played
            # The beginning of a way is played to find out when its next change comes.
            if len(way) == len(timeline):
                self.elsewhere[way] = behaviour.elsewhere(self.exploration.last)
        return played

    def play_in(self, world: Mapping[str, object]) -> PlayedWay:
        return _without_times(super().play_in(world))


def _without_times(played: PlayedWay) -> PlayedWay:
    return played._replace(acts={task: [*map(_timeless, some)] for task, some in played.acts.items()})


def _timeless(act: ComparedAct) -> ComparedAct:
    if act.exact:
        return act._replace(speed=0.0, target=None if act.is_cut else act.target)
    return act if act.subject else act._replace(words=without_figures(act.words))


def played_ways(
    program: Program,
    values: Mapping[str, float | str],
    settings: Mapping[str, object],
    tasks: Tasks,
    progress: Progress,
) -> PlayedWays:
    """Play a program, a debug build, with other values in the ways that an exploration finds; return what differs.

    `tasks` are those of the program.
    """
    own = without_world(settings)
    a = explore(program, own, seconds=EXPLORED, progress=progress)
    b = explore(program.with_values(values), {**a.switches.settings, **own}, seconds=0.0, progress=progress)
    first = _WithoutTimes(a, tasks)
    second = _WithoutTimes(b, tasks, first)
    found = compared_ways(first, second, PLAYED * SECOND, progress=progress)
    names = input_names(a)
    texts: dict[bool, list[str]] = {True: [], False: []}
    for each in (*found.differences, *found.behind):
        if not _is_beyond(each):
            texts[_is_grave(each)].append(f"{way_words(each.way, names)}: {found_words(each)}")
    reasons: dict[str, Timeline] = {}
    for timeline, reason in sorted(second.elsewhere.items(), key=lambda each: len(each[0])):
        reasons.setdefault(reason, timeline)
    texts[True] += [
        f"{way_words(Way(way, 'A'), names)}: {reason}" for reason, way in reasons.items() if reason
    ]
    verdict = "some differ" if any(texts.values()) else "the same but for time"
    summary = f"{count_of(found.count, 'way')} played with the edits, too: {verdict}"
    left = [not_compared(found, explored=""), "" if a.is_whole else "what the exploration had not found"]
    if any(left):
        summary = f"{summary}; not compared: {', '.join(filter(None, left))}"
    return PlayedWays(summary, texts[True], texts[False])


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
