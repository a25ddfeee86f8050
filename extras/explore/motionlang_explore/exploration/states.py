"""The states of a machine, the visits that lead there, and the transitions between them."""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from dataclasses import dataclass, field
from math import inf
from typing import NamedTuple

from motionlang_explore.exploration.changes import (
    AT_REST,
    Change,
    Channel,
    Moment,
    Timeline,
    levels_at,
    made_at,
)
from motionlang_explore.exploration.rests import Rest, RestState
from motionlang_explore.exploration.trials import Act, TrialMotion
from motionlang_explore.exploration.values import is_probe

# A change comes so long after the program is at rest, s.
DELAY = 0.3

Causes = tuple[Change, ...]


class Visit(NamedTuple):
    """A way to a state: the timeline that leads there, and when the stay begins and ends, at infinity if it lasts.

    `moved` are the lines that moved an axis on the way. `question` is that of an INPUT.
    """

    timeline: Timeline
    time: float
    end: float = inf
    moved: frozenset[int] = frozenset()
    question: str | None = None

    @property
    def lasts(self) -> bool:
        """True if only a change of the world ends the stay."""
        return self.end == inf

    @property
    def change_time(self) -> float:
        """When a change comes; an answer is taken when the program asks."""
        if self.question is not None:
            return self.time
        return round(max(self.time + delay(self.time, self.end), 0.0), 4)

    @property
    def levels(self) -> dict[int, float]:
        """The levels of the inputs that have changed by then."""
        return levels_at(self.timeline, self.change_time)

    def changed(self, causes: Causes) -> Timeline:
        """Return the timeline with changes of the stay."""
        time = self.change_time
        return (*(each for each in self.timeline if each[0] <= time), *made_at(time, causes))


def delay(begin: float, end: float) -> float:
    """Return the time from the begin of a rest to a change: it comes before the rest ends by itself."""
    return min(DELAY, (end - begin) / 2.0)


class Effect(NamedTuple):
    """The effect of a transition, without figures, and without how often a lamp blinks.

    `moves` are the lines that move an axis, each with how it was cut off, "" if it was not; `outputs` those that were
    switched, with their levels; `prints` the printed lines.
    """

    moves: tuple[tuple[int, str], ...]
    outputs: frozenset[tuple[int, bool]]
    prints: frozenset[str]


@dataclass
class Transition:
    """A way from a state to the next one.

    `causes` are the changes of the world, none if it comes by itself. `target` is None if the program ends. `lines` are
    those that move an axis, in order, `work` those that do more than a homing, `done` those with a move that ends by
    itself; `outputs` are switched on. `acts` are the moves, outputs and printed lines in order, `said` the lines alone;
    `faults` is how often these say that something is wrong, `stops` how many say that the machine has stopped. `is_cut`
    is True if a handler ran that commands anything, or a fault cut off a move. `visit` is that of the source from which
    it was found, `is_later` if that is no shortest one. `begun` are the source offsets of the statements that began.
    `is_by_itself` is True if the stay ends without the changes at that time. Two transitions do the same if `does` is
    equal. `variants` are other values of the same channels with which the same happens.
    """

    source: RestState | None
    causes: Causes
    target: RestState | None
    seconds: float
    lines: tuple[int, ...]
    work: frozenset[int]
    done: frozenset[int]
    outputs: frozenset[int]
    acts: tuple[Act, ...]
    said: tuple[str, ...]
    faults: int
    stops: int
    is_cut: bool
    visit: Visit
    is_later: bool
    is_by_itself: bool
    does: Effect
    begun: frozenset[int]
    variants: dict[Causes, None] = field(default_factory=dict)

    @property
    def goes_on(self) -> bool:
        """True if the state goes on meanwhile: it prints, or begins motion without an end."""
        return self.source == self.target and not self.done


@dataclass(eq=False)
class Departure:
    """Changes that are still to be tried from a visit, so many at once; None for each change by itself."""

    visit: Visit
    changes: Iterator[Causes] | None = None
    depth: int = 1


@dataclass
class StateNode:
    """A state: the shortest way there, and a later one with further moves, since these may decide what follows.

    `printed` is what the program prints before it asks the question of the state, `refused` what it does with answers
    after which it asks again.
    """

    state: RestState | None
    first: Visit
    later: Visit | None = None
    printed: str = ""
    refused: dict[Causes, tuple[Act, ...]] = field(default_factory=dict)
    # The channels that statements have read while the state lasted, by source offset.
    reads: dict[int, dict[Channel, None]] = field(default_factory=dict)
    # The channels that statements have read behind several changes, until the next rest.
    on_way: set[Channel] = field(default_factory=set)
    # The values of a channel at which comparisons turn here.
    solved: dict[Channel, tuple[Change, ...]] = field(default_factory=dict)
    # The changes of several inputs that let a bank have the code with which it is compared here.
    codes: dict[Causes, None] = field(default_factory=dict)
    # What was tried, and what is still to be tried.
    tried: dict[Causes, None] = field(default_factory=dict)
    left: list[Departure] = field(default_factory=list)
    transitions: list[Transition] = field(default_factory=list)

    @property
    def places(self) -> frozenset[int]:
        """The statements at which the tasks rest."""
        return frozenset[int]().union(*(each.statements for each in self.state or ()))

    @property
    def moved(self) -> frozenset[int]:
        """The lines that moved an axis on the shortest way there."""
        return self.first.moved

    def note_reads(self, rest: Rest) -> list[Channel]:
        """Take note of what was read in a stay, and return what is new."""
        news: dict[Channel, None] = {}
        for at, channels in rest.reads.items():
            known = self.reads.setdefault(at, {})
            news |= dict.fromkeys(each for each in channels if each not in known)
            known |= dict.fromkeys(channels)
        return list(news)

    @property
    def channels(self) -> list[Channel]:
        """The channels that were read while the state lasted."""
        return list(dict.fromkeys(each for channels in self.reads.values() for each in channels))

    def take(self, other: StateNode) -> None:
        """Take over what is known of a state that is the same after all."""
        for each in other.transitions:
            if not self.knows(each.causes, each.target, each.does):
                self.transitions.append(each)
        for at, channels in other.reads.items():
            self.reads.setdefault(at, {}).update(channels)
        self.codes |= other.codes
        self.tried |= other.tried
        self.refused |= other.refused

    def knows(self, causes: Causes, target: RestState | None, does: Effect) -> bool:
        """True if the same happens by these causes, by some of them, or by other values or moments of their channels.

        What cuts off a move that the other causes start is no more of the same than what cuts it off at once. Other
        values are noted, since what they do may differ later.
        """
        kinds = {each.kind for each in causes}
        at_rest = {each.kind for each in causes if not each.moment.line}
        for each in self.transitions:
            known = {one.kind for one in each.causes}
            is_some = known <= kinds and (at_rest <= known or kinds - at_rest <= known)
            if each.target == target and each.does == does and is_some:
                values = [one._replace(moment=AT_REST) for one in causes]
                others = [one._replace(moment=AT_REST) for one in each.causes]
                if known == kinds and others != values and not any(map(is_probe, causes)):
                    each.variants[causes] = None
                return True
        return False


class Work(NamedTuple):
    """Work that a program repeats without a rest: its period, s, the lines that move an axis, outputs, what it says.

    `done` are the lines whose moves end by themselves, `begun` the source offsets of the statements that begin.
    """

    timeline: Timeline
    period: float
    lines: frozenset[int]
    done: frozenset[int]
    outputs: frozenset[int]
    said: frozenset[str]
    begun: frozenset[int]


class ChangeInMove(NamedTuple):
    """An input that may change in the middle of a move; `onward` are the lines that move an axis later."""

    change: Change
    motion: TrialMotion
    onward: frozenset[int]

    @property
    def key(self) -> Hashable:
        """The input, the line that moves the axis, and what comes after it: the change is tried once in each."""
        return self.change.number, self.motion.line, self.onward

    def added(self, causes: Causes, since: float, times: int = 0, share: float = 0.5) -> Causes:
        """Return changes at a time, and this one at a share of the move after it, or so many times in the move."""
        begin, end, axis, line = self.motion[:4]
        every = (end - begin) / times if times else 0.0
        first = begin + (every / 4 if times else (end - begin) * share)
        moment = Moment(round(first - since, 4), axis, line, times or 1, every)
        return (*causes, self.change._replace(moment=moment))
