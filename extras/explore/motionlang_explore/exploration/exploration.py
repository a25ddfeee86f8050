"""What an exploration has found: states, transitions, cycles and the world, and what can be played of them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from math import inf
from typing import NamedTuple

from motionlang.kernel import Run
from motionlang_explore.exploration.changes import (
    AT_REST,
    Change,
    Channel,
    Moment,
    Timeline,
    entries,
    number_in,
    tables_of,
)
from motionlang_explore.exploration.cycles import MachineCycle, cycles
from motionlang_explore.exploration.playing import TIMES, played
from motionlang_explore.exploration.questions import PERIOD
from motionlang_explore.exploration.recorder import HANDLERS
from motionlang_explore.exploration.rests import (
    Rest,
    RestState,
)
from motionlang_explore.exploration.search import Explorer
from motionlang_explore.exploration.simple import fault_of, neighbours
from motionlang_explore.exploration.switches import TURNING, encoder_entry
from motionlang_explore.exploration.trials import (
    HORIZON,
    NOWHERE,
    Act,
    Trial,
)
from motionlang_explore.exploration.world import PLAYED, FoundWorld, nowhere, world_of


class PlayedTimeline(NamedTuple):
    """A run with a timeline: its record, the run, valid until the next play, and the rests of the machine."""

    trial: Trial
    run: Run
    rests: Sequence[Rest]


class Exploration:
    """The states, transitions and cycles that an exploration has found in a program.

    `nodes` are its states with their transitions, power-up first, `cycles` the cycles, the likeliest first and those
    without motion last, `trials` the number of runs. `world` is that of the first cycle that repeats when it is played.
    `switches` are those of axes that would home for ever. `is_whole` is False if the budget or the user ended the
    search; `interrupted` is then the run that Ctrl-C ended.
    """

    def __init__(
        self, explorer: Explorer, interrupted: Run | None = None, before: Exploration | None = None
    ) -> None:
        self._explorer, self.interrupted = explorer, interrupted
        self.program = explorer.program
        self.nodes = list(explorer.nodes.values())
        self.trials = explorer.trials.count
        self.is_whole = not explorer.trials.is_over and interrupted is None
        statements = len(self.program.structure.statements)
        self.cycles = cycles(explorer.nodes, explorer.working, statements, explorer.alarms)
        self.switches = explorer.switches
        self.channels = sorted(explorer.channels)
        if interrupted is not None:
            self.world = self._unplayed(interrupted)
        elif before is not None and (before._decides == self._decides or not explorer.has_work):
            self.world = before.world
        else:
            world = self.world_of(self.cycles)
            # Little of the work may be left, and a cycle that was not played comes to nothing.
            self.world = world if world.times or before is None else before.world
        # The statements of the tasks beside the work: those that blink, regulate or watch.
        self.beside = explorer.beside
        # The axes that each line moves.
        self.axes = explorer.axes

    def __getstate__(self) -> dict[str, object]:
        return {**vars(self), "interrupted": None, "world": self.world._replace(run=self.world.run.time)}  # type: ignore[arg-type]

    def __setstate__(self, state: dict[str, object]) -> None:
        """Play the world again: its run is a living machine, which cannot be sent."""
        vars(self).update(state)
        run_in = self._explorer.trials.run_in
        self.world = self.world._replace(run=run_in(self.world.settings, self.world.run)[0])  # type: ignore[arg-type]

    @property
    def inputs(self) -> list[int]:
        """The inputs that the program has read, or that have a rule in the world."""
        given = (number_in("input", each) for each in entries(self.world.settings, "input"))
        return sorted({*self.channels, *given})

    @property
    def begun(self) -> frozenset[int]:
        """The source offsets of the statements that any trial has carried out."""
        return frozenset(each for each in self._explorer.trials.seen if isinstance(each, int))

    @property
    def decided(self) -> Mapping[int, Collection[Channel]]:
        """The channels on which the conditions of statements have depended, by their source offsets."""
        return self._explorer.decided

    @property
    def missed(self) -> list[int]:
        """The lines with a statement that no trial has carried out."""
        return self.without(self.begun)

    @property
    def missed_moves(self) -> list[int]:
        """The lines with a statement that moves an axis and that no trial has carried out."""
        statements, begun = self.program.structure.statements, self.begun
        return sorted({each.line for at, each in statements.items() if each.moves and at not in begun})

    def without(self, begun: Collection[int]) -> list[int]:
        """Return the lines with a statement that is not among those that have begun, by their source offsets."""
        statements = self.program.structure.statements
        offsets = (at for at in self.program.offsets if at in statements and at not in begun)
        return sorted({statements[at].line for at in offsets if not statements[at].is_silent})

    @property
    def _decides(self) -> object:
        """The cycles that are played and the channels, on which its world depends."""
        return self.cycles[:PLAYED], self.channels

    def cut_off(self) -> dict[Change, set[int]]:
        """Return the changes in the middle of a move that cut off moves, with the lines of these moves.

        A line whose moves are always cut off without such a change, too, such as a jog to a mark, is left out, and what
        a good cycle cuts off. Of several changes each is charged with what none of the others cuts off by itself, and
        an input that comes and goes from an earlier state on with nothing; one that does so in the move is told so.
        """
        usual, done = set[int](), set[int]()
        trials: list[tuple[set[Change], set[Change], set[int]]] = []
        for each in (each for node in self.nodes for each in node.transitions):
            if any(one.moment.line for _, one in each.visit.timeline):
                continue
            cut = {line for line, ended in each.does.moves if ended}
            changes = {_at_rest(one)._replace(prompt="") for one in each.causes if one.moment.line}
            if changes:
                trials.append((changes, set(map(_at_rest, each.causes)), cut))
            else:
                usual |= cut
                done |= each.done
        usual -= done
        for each in () if self.fault_of(self.world.run) else self.world.cycle.transitions:
            usual |= {line for line, ended in each.does.moves if ended}
        movable = set[Change]().union(*(changes for changes, *_ in trials))
        found: dict[Change, set[int]] = defaultdict(set)
        for changes, made, cut in sorted(trials, key=lambda trial: len(trial[1] & movable)):
            for one in changes:
                others = (found[other] for other in made & movable if other.channel != one.channel)
                found[one] |= cut - usual - set[int]().union(*others)
        for one in found:
            found[one] -= found.get(one._replace(moment=AT_REST), set()) if one.moment != AT_REST else set()
        return {one: cut for one, cut in found.items() if cut}

    def acts(self, trial: Trial, since: float) -> tuple[Act, ...]:
        """Return what the tasks that work do in a trial from a time on, in order."""
        return self._explorer.acts(self._explorer.part(trial, since, inf))

    @property
    def work(self) -> int:
        """The statements that all trials so far have begun, and a share for each trial."""
        return self._explorer.trials.work

    @property
    def settings(self) -> Mapping[str, object]:
        """The settings in which it plays: those that a person gave, and the switches that it has found."""
        return self._explorer.trials.base

    def give(self, settings: Mapping[str, object]) -> None:
        """Add settings for all later plays."""
        self._explorer.trials.give(settings)

    def play(
        self,
        timeline: Timeline,
        since: float = 0.0,
        patience: float = HORIZON,
        world: Mapping[str, object] = NOWHERE,
    ) -> PlayedTimeline:
        """Play the changes of a timeline from power-up; record what the tasks do from a time on.

        It is played for `patience`, s, and without a `world` until no axis is on its way to an end any more.
        """

        def is_settled(trial: Trial) -> bool:
            return bool(world) and trial.time >= max((since, *(time for time, _ in timeline))) + patience

        trials = self._explorer.trials
        trial = trials.play(timeline, since, is_settled, inf if world else patience, world)
        return PlayedTimeline(trial, trials.last, self._explorer.rests(trial))

    def play_in(self, settings: Mapping[str, object], until: float) -> PlayedTimeline:
        """Play the program in the world with some entries of a machine file, up to a time, s."""
        trial = self._explorer.trials.play_in(settings, until)
        return PlayedTimeline(trial, self._explorer.trials.last, self._explorer.rests(trial))

    def turning(self) -> dict[str, object]:
        """Return the settings in which each encoder that the last play has used turns, at a speed of its own."""
        channels = enumerate(sorted(self.last.controller.encoders), 1)
        made = [{**encoder_entry(each), "velocity": TURNING * k} for k, each in channels]
        return {"encoder": made} if made and "encoder" not in self.settings else {}

    def show(self, tell: Callable[[str], object]) -> None:
        """Call a function with what is played from now on, in words."""
        self._explorer.trials.tell = tell

    def observe(self) -> None:
        """Let all later plays record how conditions come out."""
        self._explorer.trials.observe()

    def turns(self, cycle: MachineCycle, times: int) -> Trial:
        """Play a cycle so many times, each change at the state that it leads on from."""
        return played(self._explorer, cycle, times=times)

    @property
    def last(self) -> Run:
        """The run of the last play."""
        return self._explorer.trials.last

    def world_of(self, likeliest: Sequence[MachineCycle], times: int = TIMES) -> FoundWorld:
        """Return the world of the first of some cycles that repeats when it is played so often."""
        return world_of(self._explorer, likeliest, times)

    def _unplayed(self, run: Run) -> FoundWorld:
        """Return the changes that led to the likeliest cycle as a world, since nothing is played after Ctrl-C."""
        cycle = next(iter(self.cycles), None) or nowhere(self._explorer)
        return FoundWorld(cycle, tables_of(cycle.visit.timeline), run, 0)

    def variants(self) -> Iterator[tuple[MachineCycle, Trial]]:
        """Yield the cycles with another key or answer, or number of a host, in place of one that leads to the same.

        Each value is played once, in the likeliest cycle that has its transition.
        """
        tried: set[tuple[RestState | None, tuple[Change, ...]]] = set()
        for cycle in self.cycles if self.interrupted is None else ():
            for k, each in enumerate(cycle.transitions):
                for causes in each.variants:
                    if (each.source, causes) not in tried:
                        tried.add((each.source, causes))
                        changed = replace(each, causes=causes)
                        path = (*cycle.transitions[:k], changed, *cycle.transitions[k + 1 :])
                        varied = replace(cycle, transitions=path)
                        yield varied, played(self._explorer, varied, times=1)

    def neighbours(self) -> Iterator[tuple[Channel, Mapping[str, object]]]:
        """Yield the settings of its world with another simple rule for one channel, and that channel."""
        return neighbours(self._explorer, self.world.settings)

    def run(self, settings: Mapping[str, object], until: float) -> Run:
        """Run the program in the world with some entries of a machine file whose `run.until` is a time, s."""
        return self._explorer.trials.run_in({**settings, "run.until": until})[0]

    def watch(
        self, settings: Mapping[str, object], *until: float, stands: Callable[[Run], bool] = lambda run: False
    ) -> tuple[Run, Mapping[int, Set[str]]]:
        """Run the program in such a world up to the first of some times at which it `stands`, or the last one, s.

        Returns also the tasks in which each line has been carried out; a handler is "".
        """
        run, tasks, _ = self._explorer.trials.run_in(settings, *until, stands=stands)
        found = defaultdict[int, set[str]](set)
        for at, names in tasks.items():
            found[self.line(at)] |= {"" if name == HANDLERS else name for name in names}
        return run, found

    def fault_of(self, run: Run) -> str:
        """Return what is wrong with the work of a run in words, "" if nothing is."""
        return fault_of(self._explorer, run)

    @property
    def trouble(self) -> frozenset[int]:
        """The source offsets of the statements of trouble, which a person resets, or which print how much was bad."""
        return self._explorer.likely.trouble

    def line(self, at: int) -> int:
        """Return the line of a source offset."""
        return self._explorer.line(at)

    def reads(self, state: RestState) -> list[str]:
        """Return the names of what was read in a state, such as "input 3" or "a key"."""
        node = self._explorer.nodes.get(state)
        return [] if node is None else [Change(*channel, 0.0).subject for channel in node.channels]

    def read_line(self, state: RestState, channel: Channel) -> int:
        """Return the line that has read a channel in a state; the first line of the state if none has."""
        node = self._explorer.nodes.get(state)
        read = [] if node is None else [at for at, channels in node.reads.items() if channel in channels]
        return self.line(min(read or (at for place in state for at in place.statements)))


def _at_rest(change: Change) -> Change:
    """Return a change at rest; one that comes and goes does so once."""
    return change._replace(moment=Moment(every=PERIOD) if change.moment.every else AT_REST)
