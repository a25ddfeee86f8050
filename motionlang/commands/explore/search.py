"""The search of an exploration: what is tried from which state, and where it leads."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import chain
from math import inf

from motionlang.commands.explore.rests import Rest, RestState, rests
from motionlang.commands.explore.trials import HANDLERS, Change, Timeline, Trial, Trials, levels_at
from motionlang.commands.explore.values import probes, solved
from motionlang.commands.init import Guesses
from motionlang.commands.init.ending import asks, plain
from motionlang.commands.worlds import TABLES as GIVEN
from motionlang.kernel import Program, Run, dialect

MAX_TRIALS = 500
# A change comes so long after the program is at rest, s.
DELAY = 0.3
# So many changes at once are tried.
MAX_TOGETHER = 5

Causes = tuple[Change, ...]


@dataclass
class Transition:
    """A way from a state to the next one.

    `causes` are the changes of the world, none if it comes by itself. `target` is None if the program ends. `lines` are
    those that move an axis, in order, `acts` what the program does: moves, outputs and printed lines. `is_cut` is True
    if a handler ran, or a fault cut off a move.
    """

    source: RestState | None
    causes: Causes
    target: RestState | None
    seconds: float
    lines: tuple[int, ...]
    acts: tuple[str, ...]
    is_cut: bool = False


@dataclass
class Node:
    """A state, the shortest timeline that leads there and when; `lasts` if only a change of the world ends it."""

    state: RestState | None
    timeline: Timeline
    time: float
    lasts: bool = False
    is_open: bool = True
    # The lines that moved an axis on the way there.
    moved: frozenset[int] = frozenset()
    transitions: list[Transition] = field(default_factory=list)

    def knows(self, causes: Causes, target: RestState | None, lines: tuple[int, ...]) -> bool:
        """True if the same happens by these causes, or by some of them."""
        return any(
            each.target == target and each.lines == lines and set(each.causes) <= set(causes)
            for each in self.transitions
        )


class Explorer:
    """The exploration of a program in a world; `machine` are the settings that a person gave."""

    def __init__(self, program: Program, machine: Mapping[str, object], most: int = MAX_TRIALS) -> None:
        kept = {
            key: value for key, value in machine.items() if key not in GIVEN and not key.startswith("run.")
        }
        target = program.target
        if target.model and "controller.model" not in kept:
            kept["controller.model"] = target.model
        self.guesses = Guesses(dict(kept) | {key: value for key, value in machine.items() if key in GIVEN})
        self.trials = Trials(program, kept, most)
        self.program = program = self.trials.program
        self.nodes: dict[RestState | None, Node] = {}
        reads = program.reads
        self.channels = list(
            dict.fromkeys(each.channel for each in reads if each.is_input and each.channel is not None)
        )
        self._lines: dict[int, int] = {}
        # The inputs that each line reads, and the level that it compares each with, if that is known.
        self._read_in: dict[int, dict[int, float]] = {}
        for each in reads:
            if each.is_input and each.channel is not None:
                self._read_in.setdefault(each.line, {})[each.channel] = (
                    1.0 if each.level is None else each.level
                )
        # The statements that read an input of a computed number.
        self._computed = {
            at
            for at, statement in program.structure.statements.items()
            if any(use.channel == "input" and not use.number.isdecimal() for use in statement.channels)
        }
        # The handlers of a program but for those of a timer, as statements.
        graph, units = program.structure.graph, program.structure.units
        entered = (unit.entry for unit in units if unit.kind == "event" and "timer" not in unit.name.lower())
        self._handlers = {
            program.structure.points[point].at for entry in entered for point in graph.reached(entry)
        } - {-1}
        # The trials that go on with work without a rest, each with the node from which it began.
        self.working: list[tuple[Trial, Node]] = []

    # ------------------------------------------------------------------------------------------------- playing

    def line(self, at: int) -> int:
        """Return the line of a source offset."""
        if at not in self._lines:
            self._lines[at] = dialect(self.program.language).locate(self.program.source, at)[0]
        return self._lines[at]

    def play(self, timeline: Timeline, since: float) -> Trial:
        """Run the program with a timeline, and with what leaves no choice."""
        while True:
            trial = self.trials.play(timeline, since)
            self._note_readings(trial)
            if self.trials.is_over or not self._forced(self.trials.last):
                return trial

    def _note_readings(self, trial: Trial) -> None:
        """Take note of the inputs that statements read whose numbers only a run can know."""
        for at, channels in trial.readings.items():
            if at not in self._computed:
                continue  # it reads what its text says; its other readings are those of limits and drives
            known = self._read_in.setdefault(self.line(at), {})
            for channel in channels:
                if channel not in known:
                    known[channel] = 1.0
                if channel not in self.channels:
                    self.channels.append(channel)

    def _forced(self, result: Run) -> bool:
        """Give what the run lacks, and what leaves no choice; False if it lacks nothing."""
        lost = [
            number
            for number, a in result.controller.axes.items()
            if a.homing is not None and a.homing.endless_motion
        ]
        done = [self.guesses.home(axis, result) for axis in lost]
        scheduler = result.machine.scheduler
        for task in scheduler.tasks if scheduler is not None and not any(done) else ():
            wait = task.wait
            if task.done or wait is None or wait.due() < inf:
                continue
            for key in result.dialect.driven_by(wait.why):
                if key.startswith("axis."):
                    _, axis, setting = key.split(".")
                    done.append(self.guesses.home(int(axis), result, (setting,)))
        if not any(done) and asks(result) and result.time:
            question = plain(result.machine.operator.question).strip(" ?:")
            if question not in self.guesses.exhausted:
                done.append(self.guesses.answer(question, [], result))
        if not any(done):
            return False
        given = self.guesses.settings(inf)
        tables = {key: value for key, value in given.items() if key == "answer" or key.startswith("axis.")}
        self.trials.give(tables)
        return True

    # ----------------------------------------------------------------------------------------------- searching

    def explore(self) -> None:
        """Find the states and the transitions."""
        start = self.nodes[None] = Node(None, (), -DELAY)
        self._arrive(start, (), self.play((), 0.0))
        while not self.trials.is_over:
            left = [each for each in self.nodes.values() if each.is_open]
            if not left:
                return
            node = min(left, key=lambda each: (each.state is not None, len(each.timeline), -len(each.moved)))
            node.is_open = False
            self._leave(node)

    def _leave(self, node: Node) -> None:
        """Try each change from a state."""
        time = round(max(node.time + DELAY, 0.0), 4)
        levels = levels_at(node.timeline, time)
        single = ((Change("input", channel, 1 - levels.get(channel, 0.0)),) for channel in self.channels)
        tried: set[Causes] = set()
        for first in chain(single, self._read_together(node, levels), self._values(node, time)):
            waiting = deque((first,))
            while waiting and not self.trials.is_over:
                causes = waiting.popleft()
                if causes in tried:
                    continue
                tried.add(causes)
                before = len(self.trials.seen), len(self.nodes)
                trial = self._changed(node, time, causes)
                news = self._arrive(node, causes, trial) or (len(self.trials.seen), len(self.nodes)) != before
                if news and len(causes) < MAX_TOGETHER:
                    waiting += self._together(trial, causes, levels)

    def _read_together(self, node: Node, levels: Mapping[int, float]) -> Iterator[Causes]:
        """Yield the changes of several inputs that a line of a state reads."""
        lines = dict.fromkeys(map(self.line, sorted(node.state.statements))) if node.state is not None else ()
        for line in lines:
            wanted = self._read_in.get(line, {})
            for levels_of_line in (wanted, {channel: 1.0 - level for channel, level in wanted.items()}):
                changes = [
                    Change("input", channel, level)
                    for channel, level in sorted(levels_of_line.items())
                    if levels.get(channel, 0.0) != level
                ]
                if len(changes) > 1:
                    yield tuple(changes)

    def _changed(self, node: Node, time: float, causes: Causes) -> Trial:
        timeline = tuple(each for each in node.timeline if each[0] <= time)
        return self.play((*timeline, *((time, each) for each in causes)), time)

    def _together(self, trial: Trial, causes: Causes, levels: Mapping[int, float]) -> list[Causes]:
        """Return the changes with one more of the inputs that are read behind them."""
        ran = {self.line(begun.at) for begun in chain.from_iterable(trial.statements.values())}
        read = (channel for line in sorted(ran) for channel in self._read_in.get(line, ()))
        changed = {each.number for each in causes if each.table == "input"}
        return [
            tuple(sorted((*causes, Change("input", channel, 1 - levels.get(channel, 0.0)))))
            for channel in dict.fromkeys(read)
            if channel not in changed
        ]

    def _values(self, node: Node, time: float) -> Iterator[Causes]:
        """Yield the changes of what has more than two levels, by the comparisons that follow."""
        for first, second in probes(self.program):
            if self.trials.is_over:
                return
            trials = [self._changed(node, time, (each,)) for each in (first, second)]
            for trial, cause in zip(trials, (first, second), strict=True):
                self._arrive(node, (cause,), trial)
            yield from ((each,) for each in solved(first, second, *trials))

    # ------------------------------------------------------------------------------------------------ arriving

    def _arrive(self, node: Node, causes: Causes, trial: Trial) -> bool:
        """Take the rests of a trial behind a change; True if it leads this state elsewhere for the first time."""
        news = False
        handled = {begun.at for begun in trial.statements.get(HANDLERS, ())}
        is_cut = bool(handled & self._handlers) or _fails(trial)
        last: dict[str, tuple[Node, Causes, float]] = {}
        if node.state is not None:
            last[node.state.task] = node, causes, trial.since
        found_rests = rests(trial)
        if not any(rest.end == inf for rest in found_rests):
            self.working.append((trial, node))
        for rest in found_rests:
            found = self._reached(rest, trial)
            before = last.get(rest.state.task)
            source, how, since = before or (
                self.nodes[None],
                causes if node.state is None else (),
                trial.since,
            )
            if before is not None or node.state is None:
                news |= self._link(source, how, found.state, trial, since, rest.begin, is_cut)
            last[rest.state.task] = found, (), rest.end if rest.end < inf else trial.time
        if trial.has_ended and node.state is not None:
            news |= self._link(*last[node.state.task][:2], None, trial, trial.since, trial.time, is_cut)
        return news

    def _reached(self, rest: Rest, trial: Trial) -> Node:
        """Return the node of a rest, with the shorter timeline that leads there."""
        lasts = rest.end == inf
        node = self.nodes.get(rest.state)
        if (
            node is None
            or (lasts and not node.lasts)
            or (lasts == node.lasts and len(trial.timeline) < len(node.timeline))
        ):
            moved = frozenset(each.line for each in trial.motions if each.begin <= rest.begin)
            made = Node(rest.state, trial.timeline, rest.begin, lasts, moved=moved)
            if node is not None:
                made.transitions = node.transitions
                made.is_open = node.is_open or (lasts and not node.lasts)
            node = self.nodes[rest.state] = made
        return node

    def _link(
        self,
        source: Node,
        causes: Causes,
        target: RestState | None,
        trial: Trial,
        since: float,
        until: float,
        is_cut: bool,
    ) -> bool:
        """Add a transition; True if it is new, and leads elsewhere or moves an axis."""
        lines = tuple(each.line for each in trial.moves if since - 1e-9 <= each.begin < until + 1e-9)
        if source.knows(causes, target, lines) or (target == source.state and not lines):
            return False
        acts = _acts(trial, since, until)
        source.transitions.append(
            Transition(source.state, causes, target, until - since, lines, acts, is_cut)
        )
        return True


def _fails(trial: Trial) -> bool:
    """True if a fault cut off a move."""
    return any(move.begin >= trial.since and move.ended == "fault" for move in trial.moves)


def _acts(trial: Trial, since: float, until: float) -> tuple[str, ...]:
    """Return what a program does between two times, in order."""
    found: list[tuple[float, int, str]] = []
    for move in trial.moves:
        if since - 1e-9 <= move.begin < until + 1e-9 and move.act:
            found.append((move.begin, 0, move.act))
    for switched in trial.outputs:
        if since - 1e-9 <= switched.time <= until + 1e-9:
            found.append((switched.time, 1, f"output {switched.channel} {'on' if switched.value else 'off'}"))
    for printed in trial.prints:
        if since - 1e-9 <= printed.time <= until + 1e-9:
            found.append((printed.time, 2, repr(printed.text.strip())))
    return tuple(text for _, _, text in sorted(found, key=lambda each: each[:2]))
