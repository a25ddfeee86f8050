"""The search of an exploration: which state is left next, and where what is tried leads.

Problem. There are more combinations of changes than can be played, and most lead nowhere.

Idea. From each state what was read there is changed (`questions.py`). What leads to a new state, begins a new statement
or turns a comparison for the first time is asked further; what only repeats what is known is not.

Invariants. A state is where the tasks rest and what the program remembers there (`rests.py`, `memory.py`). A variable
that takes many values counts or measures: it is forgotten, and the states that differ in it alone are one.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import Counter, defaultdict
from collections.abc import Callable, Collection, Hashable, Iterator, Mapping, Sequence
from math import inf
from operator import attrgetter

from motionlang.comparison.texts import plain, without_figures
from motionlang.kernel import Program, dialect
from motionlang.kernel.lang import Named, names_in_comments
from motionlang.kernel.log import Printed, Switched
from motionlang_explore.exploration import questions
from motionlang_explore.exploration.changes import AT_REST, Channel, Timeline, given_in
from motionlang_explore.exploration.likely import Likely
from motionlang_explore.exploration.recorder import HANDLERS, Seen
from motionlang_explore.exploration.rests import (
    BODY,
    QUIET,
    SHORTEST_REST,
    Rest,
    RestState,
    rests,
    without_memory,
)
from motionlang_explore.exploration.roles import (
    beside_work,
    commands,
    encoders_read,
    given_inputs,
    numbers_that_start,
    reached_in,
    triggers_of,
)
from motionlang_explore.exploration.states import (
    DELAY,
    Causes,
    Departure,
    Effect,
    StateNode,
    Transition,
    Visit,
    Work,
)
from motionlang_explore.exploration.switches import FoundSwitches
from motionlang_explore.exploration.trials import (
    SHORTEST_MOVE,
    Act,
    Trial,
    TrialMotion,
    Trials,
)
from motionlang_explore.exploration.values import codes, is_probe, levels, periods, printed_for
from motionlang_explore.exploration.words import alarms_in, has_stopped, is_wrong, wrong

# A variable with more values at rest counts or measures; a step, which is set to numbers alone, has up to so many.
MAX_REMEMBERED, MAX_STEPS = 5, 12
# The depth of what is asked of a state whose place is known.
LATE = 3


# Called with the share of the work that is done, and what is played.
Progress = Callable[[float, str], object]


class Explorer:
    """The exploration of a program in a world; `machine` are the settings that a person gave."""

    def __init__(
        self,
        program: Program,
        machine: Mapping[str, object],
        whole: float,
        used: Callable[[], float] = lambda: 0.0,
        progress: Progress = lambda share, playing: None,
    ) -> None:
        kept = {key: value for key, value in machine.items() if not key.startswith("run.")}
        target = program.target
        if target.model:
            kept.setdefault("controller.model", target.model)
        self.switches = FoundSwitches(kept)
        self.whole = whole
        self.trials = Trials(program, kept, whole, used)
        self.trials.tell = lambda words: progress(min(self.trials.work / max(whole, 1.0), 1.0), words)
        self.trials.limit = whole
        self.program = program = self.trials.program
        self.switches.turn(encoders_read(program.structure))
        self.trials.give(self.switches.settings)
        self.nodes: dict[RestState | None, StateNode] = {}
        # What a person has given does not change.
        self.given = given_in(kept)
        # What the program has read, and does not hold itself.
        self.read: dict[Channel, None] = {}
        structure = program.structure
        # The statements of the handlers that more than time starts.
        events = [unit for unit in structure.units if unit.kind == "event" and not unit.is_timed]
        self.handlers = frozenset[int]().union(*(reached_in(structure, each) for each in events))
        self.beside = beside_work(structure)
        # The inputs whose changes start a handler.
        self.triggers = triggers_of(events)
        # The numbers of a host that start one, but for those that a person has given.
        self.started_by = sorted(numbers_that_start(events) - self.given)
        # Handlers that command nothing count or take note.
        quiet = [each for each in events if not commands(structure, each)]
        # What stops an axis, and what triggers a latch, which comes and goes like what is counted.
        given = given_inputs(structure)
        self.stops, self.latches = given["limits"], given[""]
        self.counters = triggers_of(quiet) | self.latches
        self._commanding = self.handlers.difference(*(reached_in(structure, each) for each in quiet))
        # The timelines that were tried, and the changes in the middle of a move: at all, and from each state.
        self.tried: set[Timeline] = set()
        self.changed_in: set[Hashable] = set()
        # What the trials have seen that were taken.
        self._seen: set[Seen] = set()
        # The channels on which the comparisons and truths of statements have depended.
        self.decided: dict[int, set[Channel]] = defaultdict(set)
        # The shares of the way of a move where a mark of a latch turns comparisons.
        self.marks: dict[int, dict[float, None]] = {}
        # The levels on both sides of those at which comparisons turn.
        self.levels: dict[Channel, dict[float | str, None]] = defaultdict(dict)
        # The periods of inputs with which comparisons of the way between two marks turn.
        self.periods: dict[int, dict[float, None]] = defaultdict(dict)
        # The lines that move an axis in any transition.
        self._moved: set[int] = set()
        # The values of each remembered variable at rest; those that are forgotten.
        self._values: dict[int, set[object]] = defaultdict(set)
        self._forgotten: set[int] = set()
        # The axes that each line moves.
        self.axes: dict[int, set[int]] = defaultdict(set)
        # The rules of inputs that are likely by their names; the outputs whose names say that something is wrong.
        uses = (each for some in structure.statements.values() for each in some.channels)
        aliases = [
            Named(each.channel, int(each.number), each.alias, 0) for each in uses if each.number.isdecimal()
        ]
        named = (*names_in_comments(program.source, dialect(program.language)), *aliases)
        self.likely, self.alarms = Likely(structure, named, program.source), alarms_in(named)
        # Work that goes on without a rest.
        self.working: list[Work] = []

    # ------------------------------------------------------------------------------------------------- playing

    def most(self, share: float = 1.0) -> float:
        """Return the work at which something ends that may take a share of the whole, or what is left of it."""
        return min(self.trials.work + share * self.whole, self.trials.limit)

    @property
    def has_work(self) -> bool:
        """True if some of the work of the exploration is left; once it is done, always."""
        return self.trials.work < self.trials.limit

    @property
    def channels(self) -> list[int]:
        """The inputs that the program has read, or that start a handler."""
        read = [number for table, number in self.read if table == "input"]
        started = [each for each in sorted(self.triggers) if ("input", each) not in self.given]
        return list(dict.fromkeys((*read, *started)))

    def line(self, at: int) -> int:
        """Return the line of a source offset."""
        return self.program.structure.line(at)

    def play(
        self, timeline: Timeline, since: float, is_settled: Callable[[Trial], bool] = lambda trial: False
    ) -> Trial:
        """Run the program with a timeline, and with what leaves no choice; see `Trials.play`."""
        has_switches = True

        def is_enough(trial: Trial) -> bool:
            nonlocal has_switches
            has_switches = not self.switches.add_for_homing(self.trials.last)
            return not has_switches or is_settled(trial)

        while True:
            trial = self.trials.play(timeline, since, is_enough)
            self.likely.note(trial, self.program.structure)
            for at, found in trial.decided.items():
                self.decided[at] |= found
            for channels in trial.readings.values():
                self.read |= dict.fromkeys(questions.that_matter(self, channels, trial.decided))
            for change in levels(trial):
                self.levels[change.channel][change.value] = None
            for number in self.triggers:
                self.periods[number] |= dict.fromkeys(periods(trial, number))
            if self.trials.is_over or (has_switches and not self.switches.add(self.trials.last)):
                return trial
            self.trials.give(self.switches.settings)

    def changed(self, visit: Visit, causes: Causes) -> Trial:
        """Play the changes from a visit on."""
        return self.play(visit.changed(causes), visit.change_time, self._is_settled)

    def _is_settled(self, trial: Trial) -> bool:
        if trial.is_busy:
            return False
        last = next((rest for rest in self.rests(trial) if rest.end == inf), None)
        return (
            last is not None
            and last.begin < trial.time - QUIET
            and last.state in self.nodes
            and self.nodes[last.state].first.lasts
        )

    def rests(self, trial: Trial) -> list[Rest]:
        """Return the rests of the machine in a trial."""
        return rests(trial, self.beside, self.trials.memory, self._forgotten)

    # ----------------------------------------------------------------------------------------------- searching

    def explore(self, work: float) -> bool:
        """Find more states and transitions, by so much work; False if nothing is left to try."""
        self.trials.most = self.trials.work + work
        if not self.nodes:
            start = self.nodes[None] = StateNode(None, Visit((), -DELAY))
            trial = self.play((), 0.0)
            self._seen |= trial.seen
            rest = self.arrive(start, start.first, (), trial)
            start.left.append(Departure(start.first, questions.at_power_up(self, trial, rest)))
        has_tried = False
        while not self.trials.is_over:
            self._forget()
            left = [(node, departure) for node in self.nodes.values() for departure in node.left]
            if not left:
                break
            has_tried = True
            node, departure = min(left, key=_urgency)
            node.left.remove(departure)
            self._leave(node, departure)
        return has_tried

    def _leave(self, node: StateNode, departure: Departure) -> None:
        """Try the changes of a departure; what leads to something new is tried again with one more change."""
        visit = departure.visit
        if departure.changes is None:
            more = questions.of_conditions(self, node, visit)
            node.left.append(Departure(visit, more, departure.depth + 1))
        departure.changes = departure.changes or questions.one_by_one(self, node, visit)
        for causes in departure.changes:
            if visit.changed(causes) not in self.tried:
                self.take(node, visit, causes, self.changed(visit, causes))
            if self.trials.is_over:  # more work may come
                node.left.append(departure)
                return

    def take(self, node: StateNode, visit: Visit, causes: Causes, trial: Trial) -> None:
        """Record a trial; ask more questions if it has found something new."""
        self.tried.add(trial.timeline)
        node.tried[causes] = None
        known, is_news = node.channels, self.is_news(trial)
        before = {at: len(channels) for at, channels in node.reads.items()}
        self._seen |= trial.seen
        rest = self.arrive(node, visit, causes, trial, is_news)
        further: list[Iterator[Causes]] = []
        if len(causes) == 1 and questions.is_read_again(self, trial, causes[0]):
            further.append(questions.pulses(self, node, visit, causes[0], trial))
        on_way = questions.read_on_way(self, trial, rest) if len(causes) > 1 else []
        if is_news:
            further.append(questions.behind(self, node, visit, causes, trial, rest))
        elif first_read := [each for each in on_way if each not in node.on_way and each not in known]:
            further.append(questions.with_more(self, node, visit, causes, first_read))
        node.on_way.update(on_way)
        if is_news and any(map(is_wrong, (each.text for each in trial.part(trial.since, inf).prints))):
            # What says trouble may lack an input, such as a guard, that alone leads nowhere from here.
            leads = {each.causes[0].channel for each in node.transitions if len(each.causes) == 1}
            inputs = [each for each in node.channels if each[0] == "input" and each not in leads]
            if len(inputs) <= questions.MAX_READ:
                further.append(questions.with_more(self, node, visit, causes, inputs))
        # What is read for the first time here, or by a condition with one of the changed channels.
        changed = {each.channel for each in causes}
        reads = [(read, list(read)[before.get(at, 0) :]) for at, read in node.reads.items()]
        more = [
            each for read, new in reads for each in new if each not in known or not changed.isdisjoint(read)
        ]
        if more:
            further.append(questions.with_more(self, node, visit, causes, dict.fromkeys(more)))
        node.left += (Departure(visit, each, len(causes) + 1) for each in further)
        if is_news:
            for other, answers in questions.with_other_answers(self, visit, causes, trial):
                other.left.append(Departure(other.first, iter((answers,)), len(answers)))

    def is_news(self, trial: Trial) -> bool:
        """True if a statement began or a comparison turned in a trial that no trial taken so far has seen."""
        return not trial.seen <= self._seen

    def _forget(self) -> None:
        """Forget the variables with many values, and take states for one that differ in them alone."""
        steps = self.trials.memory.steps
        many = {
            n
            for n, values in self._values.items()
            if len(values) > (MAX_STEPS if n in steps else MAX_REMEMBERED)
        } - self._forgotten
        if not many:
            return
        self._forgotten |= many

        def known(state: RestState | None) -> RestState | None:
            if state is None:
                return None
            return tuple(
                each._replace(memory=tuple(value for value in each.memory if value[0] not in many))
                for each in state
            )

        nodes, self.nodes = self.nodes, {}
        for state, node in nodes.items():
            node.state = known(state)
            for each in node.transitions:
                each.source, each.target = node.state, known(each.target)
            same = self.nodes.setdefault(node.state, node)
            if same is not node:
                same.take(node)

    # ------------------------------------------------------------------------------------------------ arriving

    def arrive(
        self, node: StateNode, visit: Visit, causes: Causes, trial: Trial, is_news: bool = False
    ) -> Rest | None:
        """Take the rests of a trial behind a change, and return the first one.

        If it `is_news`, what it says leads on, too.
        """
        known = {*self.nodes, None}
        first: Rest | None = None
        is_over = False  # the stay has ended by itself all the same
        source, back, how, since = node, visit, causes, trial.since
        # An input that comes and goes passes the rests on its way.
        pulses = [each.levels(trial.since)[-1][0] for each in causes if each.moment.every]
        found = [rest for rest in self.rests(trial) if rest.end > max(pulses, default=-inf)]
        works_on = trial.status == "until" and not any(rest.end == inf for rest in found)
        if works_on:
            self._note_work(trial)
        for rest in found:
            if source.state == rest.state and not _moves_between(trial, since, rest):
                source.note_reads(rest)
                if rest.question is not None:
                    source.printed += printed_for(trial, rest.question)
                    if any(each.table == "answer" for each in how):
                        source.refused.setdefault(how, self.acts(self.part(trial, since, rest.begin)))
                is_over |= rest.end < inf and rest.end > back.end - SHORTEST_REST
                did = [*self._handled(trial, since, rest.end), *_jogs(trial, since, rest.end)] if how else []
                if how and is_news:
                    asks = self.handlers.union(*(place.statements for place in rest.state))
                    said = self.part(trial, since, rest.end).prints
                    did += [each.time for each in said if each.at not in asks]
                if did:
                    # What a question prints when it is asked again is no effect.
                    until = max(did if rest.question is not None else [*did, rest.begin])
                    self._link(source, back, how, rest.state, trial, since, until, known, is_over)
                continue  # the same stay
            reached, way = self._reached(rest, trial)
            first = first or rest
            until = self._arrival(trial, rest)
            self._link(source, back, how, reached.state, trial, since, until, known, is_over)
            is_over = False
            source, back, since = reached, way, rest.end if rest.end < inf else trial.time
            how = _later(causes, visit, way, since)
        if trial.has_ended:
            self._link(source, back, how, None, trial, since, trial.time, known, is_over)
        elif works_on:
            self._ask_in_moves(source, back, how, trial, since, trial.time)
        return first

    def _arrival(self, trial: Trial, rest: Rest) -> float:
        """Return when a rest is reached: what begins soon after the last move, and is none of the rest, leads there.

        So does a jog, during which the machine is at rest.
        """
        until = max([rest.begin, *_jogs(trial, rest.begin, rest.begin + BODY)])
        for place in rest.state:
            begun = trial.statements.get(place.task, ())
            first, last = (
                bisect_left(begun, time, key=attrgetter("time"))
                for time in (rest.begin, min(rest.begin + BODY, rest.end))
            )
            until = max(
                [until, *(each.time for each in begun[first:last] if each.at not in place.statements)]
            )
        return until

    def _note_work(self, trial: Trial) -> None:
        cycle = self.trials.last.cycle
        is_unusual = any(each.table == "answer" and is_probe(each) for _, each in trial.timeline)
        # An unusual count makes an endless batch, and no cycle of the machine; nor are moves without time for them.
        if cycle is None or is_unusual or cycle.period < SHORTEST_MOVE:
            return
        for move in trial.moves:
            self.axes[move.line].add(move.axis)
        # What all tasks do in every other cycle at least.
        often = 0.5 * cycle.count
        moves = Counter(each.line for each in trial.moves if each.is_work)
        switched = Counter(each.channel for each in trial.outputs if each.value)
        work = {line for line, count in moves.items() if count >= often}
        outputs = {channel for channel, count in switched.items() if count >= often}
        # What is said before it moves is no part of it; of lines that differ in figures, the last one.
        since = min((each.begin for each in trial.moves if each.line in work), default=inf)
        said = {without_figures(each.text): each.text for each in trial.prints if each.time >= since}
        if work:
            lines = frozenset(work)
            done = lines & {each.line for each in trial.moves if each.end < inf and not each.ended}
            texts = frozenset(said.values())
            begun = frozenset(
                each.at for some in trial.statements.values() for each in some if each.time >= since
            )
            found = Work(trial.timeline, cycle.period, lines, done, frozenset(outputs), texts, begun)
            self.working.append(found)

    def _reached(self, rest: Rest, trial: Trial) -> tuple[StateNode, Visit]:
        """Return the node of a rest, and this visit; the shortest one is that of the node, and a later one is kept."""
        moved = frozenset(each.line for each in trial.motions if each.begin <= rest.begin)
        visit = Visit(trial.timeline, rest.begin, rest.end, moved, rest.question)
        for place in rest.state:
            for number, value in place.memory:
                self._values[number].add(value)
        node = self.nodes.get(rest.state)
        if node is None:
            node = self.nodes[rest.state] = StateNode(rest.state, visit)
            node.left = self._departures(node, visit)
        elif (
            visit.lasts > node.first.lasts
            and trial.time - rest.begin > node.first.end - node.first.time + QUIET
        ):
            node.left = [Departure(visit)]
            node.first = visit
        elif visit.lasts == node.first.lasts and len(visit.timeline) < len(node.first.timeline):
            for each in node.left:
                if each.visit is node.first and each.changes is None:
                    each.visit = visit
            node.first = visit
        elif node.later is None and visit.lasts and not moved <= node.first.moved:
            node.later = visit
            node.left.append(Departure(visit))
        node.note_reads(rest)
        if visit.lasts:
            node.codes |= dict.fromkeys(codes(trial, node.channels))
        if rest.question is not None:
            node.printed += printed_for(trial, rest.question)
        return node, visit

    def _departures(self, node: StateNode, visit: Visit) -> list[Departure]:
        """Return what is tried from a new state: at a known place what leads on there first, and the rest late."""
        if not self.same_place(node):
            return [Departure(visit)]
        return [
            Departure(visit, questions.as_before(self, node)),
            Departure(visit, depth=LATE),
            Departure(visit, questions.as_before(self, node), LATE + 1),
        ]

    def same_place(self, node: StateNode) -> list[StateNode]:
        """Return the other states in which the tasks rest at the same places."""
        place = without_memory(node.state)
        return [
            each for each in self.nodes.values() if each is not node and without_memory(each.state) == place
        ]

    def _link(
        self,
        source: StateNode,
        visit: Visit,
        causes: Causes,
        target: RestState | None,
        trial: Trial,
        since: float,
        until: float,
        known: Collection[RestState | None],
        is_over: bool,
    ) -> None:
        """Add a transition if it is new, and leads elsewhere, moves an axis, says something or starts a handler."""
        part = self.part(trial, since, until)
        lines = tuple(each.line for each in part.moves)
        does = _does(part, until)
        handled = self._handled(trial, since, until)
        is_idle = target == source.state and not (lines or handled or does.prints)
        if source.knows(causes, target, does) or is_idle:
            return
        is_later = visit is source.later
        if is_later and target in known and self._moved.issuperset(lines):
            return  # only its levels differ
        self._moved.update(lines)
        for move in trial.moves:
            self.axes[move.line].add(move.axis)
        is_stopped = any(
            each.table == "input" and each.number in self.stops and each.value for each in causes
        )
        # A jog that the loop of a rest begins by a button is no work.
        has_key = any(each.table == "key" for each in causes)
        resting = {self.line(at) for place in target or () for at in place.statements if not has_key}
        jogging = {each.line for each in part.moves if each.end == inf and each.line in resting}
        fails = is_stopped or any(each.ended == "fault" for each in part.moves)
        self._ask_in_moves(source, visit, causes, trial, since, until)
        acts = self.acts(part)
        said = tuple(act.words for act in acts if not act.subject)
        source.transitions.append(
            Transition(
                source.state,
                causes,
                target,
                until - (since if causes else max(visit.time, 0.0)),
                lines,
                frozenset(each.line for each in part.moves if each.is_work and each.line not in jogging),
                frozenset(
                    each.line for each in part.moves if each.is_work and each.end < inf and not each.ended
                ),
                frozenset(each.channel for each in part.outputs if each.value),
                acts,
                said,
                wrong(said),
                len([each for each in said if has_stopped(each)]),
                fails or bool(handled),
                visit,
                is_later,
                is_over or not causes,
                does,
                frozenset(
                    each.at
                    for begun in trial.statements.values()
                    for each in begun
                    if since <= each.time <= until
                ),
            )
        )

    def _ask_in_moves(
        self, source: StateNode, visit: Visit, causes: Causes, trial: Trial, since: float, until: float
    ) -> None:
        """Ask for changes in the moves between two times, early where no state has asked before."""
        possible = questions.changes_in_moves(self, trial, since, until, causes)
        for is_new in (True, False):
            some = [each for each in possible if (each.key not in self.changed_in) is is_new]
            changes = questions.in_moves(self, source, visit, causes, some)
            source.left += [Departure(visit, changes, 1 if is_new else LATE)] if some else []

    def _handled(self, trial: Trial, since: float, until: float) -> list[float]:
        begun = trial.statements.get(HANDLERS, ())
        return [each.time for each in begun if each.at in self._commanding and since <= each.time <= until]

    def part(self, trial: Trial, since: float, until: float) -> Trial:
        """Return the trial with only what the tasks that work do between two times."""
        found = trial.part(since, until)
        return found._replace(
            outputs=[each for each in found.outputs if each.at not in self.beside],
            prints=[each for each in found.prints if each.at not in self.beside],
        )

    def acts(self, part: Trial) -> tuple[Act, ...]:
        """Return what a program does in a part of a trial, in order."""
        found = [
            *(Act(each.begin, each.line, f"axis {each.axis}", each.words) for each in _whole(part.moves)),
            *(
                self._act(each, f"output {each.channel}", "on" if each.value else "off")
                for each in part.outputs
            ),
            *(self._act(each, "", repr(plain(each.text))) for each in part.prints),
        ]
        return tuple(sorted(found, key=lambda each: each.time))

    def _act(self, each: Switched | Printed, subject: str, words: str) -> Act:
        return Act(each.time, self.line(each.at) if each.at >= 0 else 0, subject, words)


def _urgency(left: tuple[StateNode, Departure]) -> tuple[bool, int, bool, int, int]:
    """Return the order in which states are left: by the fewest changes at once and before, and later visits last."""
    node, departure = left
    visit = departure.visit
    return (
        visit is node.later,
        departure.depth,
        node.state is not None,
        len(visit.timeline) - len(visit.moved),
        len(visit.timeline),
    )


def _later(causes: Causes, visit: Visit, way: Visit, since: float) -> Causes:
    """Return those changes of a visit for the middle of a move that come in a later visit, or after its end."""
    times = ((each, visit.change_time + each.moment.delay) for each in causes if each.moment.line)
    return tuple(
        each._replace(
            moment=each.moment._replace(delay=round(time - way.change_time, 4)) if time > since else AT_REST
        )
        for each, time in times
        if time > way.time
    )


def _moves_between(trial: Trial, since: float, rest: Rest) -> bool:
    return any(since <= move.begin < rest.begin for move in trial.moves)


def _jogs(trial: Trial, since: float, until: float) -> list[float]:
    return [each.begin for each in trial.moves if each.end == inf and since <= each.begin < until]


def _whole(moves: Sequence[TrialMotion]) -> Iterator[TrialMotion]:
    """Yield the moves that move something, a homing with all its phases once."""
    last: dict[int, TrialMotion] = {}
    for each in moves:
        before = last.get(each.axis)
        is_phase = each.is_homing and before is not None and before.is_homing and before.line == each.line
        last[each.axis] = each
        if each.profile is not None and not is_phase:
            yield each


def _does(part: Trial, until: float) -> Effect:
    return Effect(
        tuple((each.line, each.ended if each.end <= until else "") for each in part.moves),
        frozenset((each.channel, bool(each.value)) for each in part.outputs),
        frozenset(without_figures(each.text) for each in part.prints),
    )
