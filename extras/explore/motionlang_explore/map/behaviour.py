"""The behaviour of a machine in words, from its exploration: cycle, states, handlers, and lines that never ran.

A row is a transition of the exploration. One that happens with fewer changes as well is left out, and so is one that
happens by itself all the same.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from math import inf
from operator import attrgetter
from typing import NamedTuple

from motionlang.comparison.texts import described, plain, without_figures
from motionlang.kernel import Run
from motionlang.kernel.lang import Structure
from motionlang.kernel.tools import ranges
from motionlang_explore.exploration import (
    Act,
    Change,
    Effect,
    Exploration,
    Moment,
    RestState,
    StateNode,
    Transition,
    entries,
    is_probe,
)
from motionlang_explore.map.cautions import CautionRow, cautions
from motionlang_explore.map.names import ReaderNames
from motionlang_explore.map.state_names import StateNames
from motionlang_explore.map.units import Reachability, UnreachedRow

# What a task waits for, by cause.
CAUSES = {
    "time": "a time",
    "axis": "motion",
    "input": "an input",
    "operator": "the operator",
    "task": "another task or a handler",
    "host": "a host",
    "condition": "a condition",
}
# So many inputs and variables that tell two rows apart are named.
MAX_DECIDING = 3
# So many rows of a cycle are a part that is repeated.
MAX_REPEATED = 40
# A wait that is shorter is not shown, and what happens so soon after something else happens then, s.
SHORTEST = 0.001


@dataclass(eq=False, slots=True)
class TransitionRow:
    """A transition in words: what leads on, what happens then, in order, how long it takes, s, and where it leads.

    `lines` are those that it runs.
    """

    until: str
    then: Sequence[str]
    seconds: float
    to: str
    lines: frozenset[int] = frozenset()


@dataclass(eq=False, slots=True)
class StateRow:
    """A state: its lines with the calls that lead there, its first statement, what it reads, and what leads on.

    `lines` are those that it repeats or waits at.
    """

    name: str
    statement: str
    reads: Sequence[str]
    transitions: Sequence[TransitionRow]
    is_in_cycle: bool
    lines: frozenset[int] = frozenset()


@dataclass(eq=False, slots=True)
class HandlerRow:
    """The effect of a handler: its trigger, its acts, the states in which it was seen, and the state that follows.

    `meets` is the line whose move is going on, 0 for none; `lines` are those that it runs.
    """

    unit: str
    start: str
    then: Sequence[str]
    states: dict[str, None]
    to: str
    meets: int
    lines: frozenset[int]


@dataclass(eq=False, slots=True)
class ChoiceRow:
    """Another key, answer or number of a host in the cycle, where it is given, and what happens then, in order."""

    instead: str
    state: str
    then: Sequence[str]


@dataclass(eq=False, slots=True)
class CycleRow:
    """Something in the cycle: s since its begin, the line, what it is, and how long it takes, None for no time."""

    time: float
    line: int
    what: str
    seconds: float | None = None


@dataclass(eq=False, slots=True)
class MachineBehaviour:
    """The behaviour of a machine: its states, power-up first, handlers, choices, its cycle, and lines that never ran.

    `cautions` are what to know before the program is changed, `remarks` what holds in all states that say nothing else.
    `span` are begin and end of the cycle in the run of the exploration's world, or of the whole run if it has none.
    `ending` is what happens in that run behind its last move, if the program ends.
    """

    exploration: Exploration
    states: list[StateRow]
    handlers: list[HandlerRow]
    choices: list[ChoiceRow]
    cycle_rows: list[CycleRow]
    cautions: list[CautionRow]
    remarks: list[str]
    unreached: list[UnreachedRow]
    span: tuple[float, float]
    ending: Sequence[str]

    @property
    def run(self) -> Run:
        """The run in the world of the likeliest cycle."""
        return self.exploration.world.run


def behaviour_of(
    exploration: Exploration, structure: Structure, names: ReaderNames, unreached: Iterable[UnreachedRow]
) -> MachineBehaviour:
    """Return what a machine does by its exploration; nothing leads to the lines of `unreached`."""
    run = exploration.world.run
    cycle = run.cycle
    span = (0.0, run.time) if cycle is None else cycle.span
    words = _Words(exploration, structure, names)
    return MachineBehaviour(
        exploration,
        words.states(),
        words.handlers(),
        words.choices(),
        _folded(_joined(sorted(_cycle_rows(exploration, structure, names, *span), key=attrgetter("time")))),
        cautions(exploration, structure, names),
        words.remarks(),
        sorted(
            (*never_run(exploration, structure), *unreached),
            key=attrgetter("first"),
        ),
        span,
        _ending(exploration, structure, names),
    )


class _Seen(NamedTuple):
    """The state from which something was seen, the state that followed, the changes, and the levels of the inputs.

    `branched` are the inputs that conditions on the way have read.
    """

    source: RestState | None
    target: RestState | None
    causes: Sequence[Change] = ()
    levels: Mapping[int, float] = {}
    branched: frozenset[int] = frozenset()

    def needs(self, others: Sequence[_Seen]) -> bool:
        """True if it needs more changes than others, each of which was made before all of these."""
        return set(self.causes) > set(others[0].causes) and all(
            one.table == "input" and each.levels.get(one.number, 0.0) == one.value
            for each in others
            for one in set(self.causes).difference(each.causes)
        )


class _Words:
    """The states and transitions of an exploration in words."""

    def __init__(self, exploration: Exploration, structure: Structure, names: ReaderNames) -> None:
        self.exploration, self.names = exploration, names
        self.structure = structure
        self.state_names = StateNames(exploration.nodes, structure)
        self._commanding = {each.line for each in structure.statements.values() if not each.is_silent}
        # The handlers that the change of a channel starts, by the name of the channel.
        self.started = {
            f"{each.channel} {each.number}": unit.title for unit in structure.units for each in unit.triggers
        }

    def remarks(self) -> list[str]:
        """Return what is repeated in most states, and which inputs read 0 when they are on."""
        low = sorted(self.exploration.world.run.controller.inputs.active_low)
        named = [self.names[subject] for n in low if (subject := f"input {n}") in self.names]
        inverted = [f"active low, so the program reads 0 when it is on: {', '.join(named)}"] if named else []
        return [*self.state_names.remarks(), *inverted]

    def states(self) -> list[StateRow]:
        """Return the states, those of the cycle first; of those with one name one, with what makes a difference."""
        groups = {self.state_names[group[0].state]: group for group in self.state_names.groups}
        cycle = {self.state_names[state]: None for state in self.exploration.world.cycle.states}
        first = dict.fromkeys((self.state_names[None], *cycle, *groups))
        return [self.state(groups[name], name in cycle) for name in first if name in groups]

    def state(self, nodes: Sequence[StateNode], is_in_cycle: bool) -> StateRow:
        """Return a state with what leads on from it, but for handlers; `nodes` differ in what the program remembers."""
        found: dict[tuple[str, Hashable], tuple[TransitionRow, list[_Seen]]] = {}
        for node in nodes:
            ways = [
                (
                    self.way(each),
                    _once(each.does),
                    _Seen(each.source, each.target, each.causes, each.visit.levels, self.branched(each)),
                )
                for each in self.kept(node)
                if not self.handler(each)
            ]
            seen = _Seen(node.state, node.state)
            ways += [(row, tuple(map(without_figures, row.then)), seen) for row in self.refused(node)]
            for row, does, seen in ways:
                first, its = found.setdefault((row.until, (row.to, does, not row.then)), (row, []))
                first.lines |= row.lines
                its.append(seen)
        same = defaultdict[Hashable, list[_Seen]](list)
        for (_, leads), (_, its) in found.items():
            same[leads].append(its[0])
        rows = [
            (row, its)
            for (_, leads), (row, its) in found.items()
            if not any(other.needs(its) for other in same[leads])
        ]
        alike = defaultdict[str, list[list[_Seen]]](list)
        for row, its in rows:
            alike[row.until].append(its)
        decides = []
        for row, its in rows:
            theirs = [each for others in alike[row.until] if others is not its for each in others]
            theirs += [
                _Seen(node.state, node.state, levels=node.first.levels) for node in nodes if _fails(node, its)
            ]
            decides.append(self.deciding(its, theirs) or self.passed(its))
        for (row, _), text in zip(rows, decides, strict=True):
            row.until += f", seen with {text}" if text else ""
        state, name = nodes[0].state, self.state_names[nodes[0].state]
        # Nothing is seen of what leads to the same state, does nothing, and is not remembered.
        transitions = [row for row, _ in rows if row.to != name or row.then]
        if state is None:
            return StateRow(name, "", (), transitions, is_in_cycle)
        reads = dict.fromkeys(
            self.names[each] for node in nodes for each in self.exploration.reads(node.state or ())
        )
        shown_at = self.state_names.shown(state) or ()
        lines = frozenset(self.structure.line(at) for place in shown_at for at in place.statements)
        return StateRow(name, self.state_names.statement(state), list(reads), transitions, is_in_cycle, lines)

    def deciding(self, mine: Sequence[_Seen], theirs: Sequence[_Seen]) -> str:
        """Return the inputs and variables whose values one thing was seen with, and others not, or not always."""
        if not theirs:
            return ""
        read = {each for one in (*mine, *theirs) for each in self.exploration.reads(one.target or ())}
        changed = {change.number for change in mine[0].causes if change.table == "input"}
        channels = sorted({channel for one in (*mine, *theirs) for channel in one.levels} - changed)
        found = []
        for channel in (each for each in channels if f"input {each}" in read):
            levels, others = ({one.levels.get(channel, 0.0) for one in some} for some in (mine, theirs))
            if len(levels) == 1 and others - levels:
                found.append(self.names.of(Change("input", channel, levels.pop())))
        sources = ([one.source for one in some] for some in (mine, theirs))
        return " and ".join([*found, *self.state_names.deciding(*sources)][:MAX_DECIDING])

    def branched(self, each: Transition) -> frozenset[int]:
        """Return the inputs that conditions read where a state ends by itself, and neither of the two states reads."""
        if each.causes:
            return frozenset()
        known = {*self.exploration.reads(each.source or ()), *self.exploration.reads(each.target or ())}
        statements = (self.structure.statements[at] for at in each.begun if at in self.structure.statements)
        return frozenset(
            int(use.number)
            for statement in statements
            if statement.condition
            for use in statement.channels
            if use.channel in ("input", "digital") and use.number.isdecimal()
            if f"input {use.number}" not in known
        )

    def passed(self, its: Sequence[_Seen]) -> str:
        """Return the levels of the inputs that conditions on the way have read, if they were the same each time."""
        found = []
        for number in sorted(frozenset.intersection(*(each.branched for each in its))):
            levels = {each.levels.get(number, 0.0) for each in its}
            if len(levels) == 1 and number in self.exploration.channels:
                found.append(self.names.of(Change("input", number, levels.pop())))
        return " and ".join(found[:MAX_DECIDING])

    def way(self, each: Transition) -> TransitionRow:
        then = [*self.then(each), *self.state_names.changed(each.source, each.target)]
        return TransitionRow(self.until(each), then, each.seconds, self.to(each.target), self.run(each))

    def to(self, target: RestState | None) -> str:
        """Return the name of the state to which something leads."""
        return "the end" if target is None else self.state_names[target]

    def kept(self, node: StateNode) -> list[Transition]:
        """Return transitions, those with fewer changes first, without those that happen by fewer, or none, as well.

        An input that comes and goes more often, and leads to the same state, is left out, too.
        """
        names, same = self.state_names, defaultdict[Hashable, list[Transition]](list)
        given, known = list[tuple[Transition, Hashable]](), set[Hashable]()
        for each in sorted(node.transitions, key=lambda each: (len(each.causes), _times(each))):
            leads = self.to(each.target), *names.changed(each.source, each.target)
            does = _once_each(each), leads
            if _is_in_time(each) and not (_times(each) and does in known):
                known.add(does)
                given.append((each, leads))
                same[leads].append(each)
        return [each for each, leads in given if not any(_replaces(one, each) for one in same[leads])]

    def refused(self, node: StateNode) -> Iterator[TransitionRow]:
        """Yield what happens with answers after which the program asks again; of the same several once."""
        found: dict[tuple[str, ...], list[tuple[Change, ...]]] = {}
        for causes, acts in node.refused.items():
            words = tuple(without_figures(each.words) for each in acts)
            found.setdefault(words, []).append(causes)
        for same in found.values():
            first = min(same, key=lambda causes: (len(causes), any(map(is_probe, causes))))
            others = [one for causes in same for one in causes]
            until = " and ".join(self.values(one, others) for one in first)
            then = [self.names.of(act) for act in node.refused[first]]
            yield TransitionRow(until, then, 0.0, "the same question")

    def until(self, each: Transition) -> str:
        """Return what leads on, with the other values that do the same."""
        given = [one for causes in each.variants for one in causes]
        # Another value may move an axis somewhere else.
        same = "with {}, the same lines" if each.does.moves else "or {}"
        return " and ".join(self.values(one, given, same) for one in each.causes) or "by itself"

    def run(self, each: Transition) -> frozenset[int]:
        """Return the lines that a transition runs; a line with commands does not run where its macro is defined."""
        statements = self.structure.statements
        return frozenset(
            line
            for at in each.begun
            if (line := self.structure.line(at)) not in self._commanding
            or not (at in statements and statements[at].is_silent)
        )

    def then(self, each: Transition) -> list[str]:
        return [self.names.of(act) for act in each.acts]

    def values(self, change: Change, others: Iterable[Change], form: str = "or {}") -> str:
        """Return a change, with the other values of the same channel among some, in words."""
        same = change._replace(value=0)
        values = dict.fromkeys(
            ("on" if one.value else "off") if one.table == "input" else str(one.value)
            for one in others
            if one._replace(value=0) == same and one.value != change.value and not is_probe(one)
        )
        return self.names.of(change) + (f" ({form.format(', '.join(values))})" if values else "")

    def handler(self, each: Transition) -> str:
        """Return the handler that a change of a transition starts, "" for none; the state does not wait for it."""
        reads = set(self.exploration.reads(each.source or ()))
        subjects = {one.subject for one in each.causes} - reads
        found = (unit for subject, unit in self.started.items() if subject in subjects)
        return next(found, "") if each.is_cut else ""

    def handlers(self) -> list[HandlerRow]:
        """Return what handlers do: for each move that one meets the row in which most goes on, then the rest.

        What is at rest, and the rest, is in the order of the states in which it is seen.
        """
        found: dict[Hashable, HandlerRow] = {}
        for node in self.exploration.nodes:
            for each in self.kept(node):
                unit = self.handler(each)
                if not unit:
                    continue
                start = " and ".join(map(self.names.of, each.causes))
                acts = _after(each)
                then = [self.names.of(act) for act in acts]
                if each.target == node.state and not then:
                    continue  # nothing is seen of it
                to = "the same state" if each.target == node.state else self.to(each.target)
                key = unit, start, to, tuple((act.subject, without_figures(act.words)) for act in acts)
                meets = max(change.moment.line for change in each.causes)
                row = found.setdefault(key, HandlerRow(unit, start, then, {}, to, meets, self.run(each)))
                row.states[self.state_names[node.state]] = None
        rows = sorted(
            found.values(), key=lambda each: (-len(each.states), each.unit, len(each.start), each.start)
        )
        first: dict[tuple[str, int], HandlerRow] = {}
        for row in rows:
            known = first.setdefault((row.unit, row.meets), row)
            if row.meets and len(row.then) > len(known.then):
                first[row.unit, row.meets] = row
        return [*first.values(), *(row for row in rows if row is not first[row.unit, row.meets])]

    def choices(self) -> list[ChoiceRow]:
        """Return the keys, answers and numbers of a host with which lines move an axis that no transition runs."""
        exploration = self.exploration
        moved = {line for node in exploration.nodes for each in node.transitions for line in each.lines}
        found = []
        for cycle, trial in exploration.variants():
            lines = {each.line for each in trial.moves}
            if lines <= moved:
                continue
            moved |= lines
            for each in cycle.transitions:
                if each.causes in each.variants:
                    acts = [self.names.of(act) for act in exploration.acts(trial, cycle.visit.time)]
                    instead = " and ".join(map(self.names.of, each.causes))
                    found.append(ChoiceRow(instead, self.state_names[each.source], acts))
        return found


def _is_in_time(each: Transition) -> bool:
    """True if the moves have begun in which its changes come."""
    begun = {line for line, _ in each.does.moves} | each.visit.moved
    return all(not one.moment.line or one.moment.line in begun for one in each.causes)


def _times(each: Transition) -> int:
    """Return how often an input comes and goes at most in a transition, 0 if none does."""
    return max((one.moment.times for one in each.causes if one.moment.every), default=0)


def _once_each(each: Transition) -> tuple[Change, ...]:
    """Return the changes of a transition as if all that come and go did so once."""
    once = Moment(every=1.0)
    return tuple(
        one._replace(moment=once._replace(line=one.moment.line)) if one.moment.every else one
        for one in each.causes
    )


def _replaces(other: Transition, each: Transition) -> bool:
    """True if fewer changes do the same, or it happens by itself before the changes make a difference."""
    if not set(other.causes) < set(each.causes):
        return False
    if other.does == each.does:
        return True
    waited = each.visit.change_time - each.visit.time
    return (
        not other.causes
        and other.lines == each.lines
        and abs(other.seconds - each.seconds - waited) < SHORTEST
    )


def _fails(node: StateNode, seen: Sequence[_Seen]) -> bool:
    """True if what was seen in other states was not in this one, with the same changes."""
    return (
        bool(seen[0].causes)
        and tuple(seen[0].causes) in node.tried
        and all(each.source != node.state for each in seen)
    )


def _once(does: Effect) -> Hashable:
    """Return what a transition does, with a move of a line once: a homing has as many phases as it takes."""
    return does._replace(moves=tuple(dict.fromkeys(does.moves)))


def _after(each: Transition) -> list[Act]:
    """Return what happens from the last change of a transition on, and before it the move that it meets."""
    last = max(each.causes, key=lambda change: change.moment.delay)
    time = each.visit.change_time + last.moment.delay
    before = [act for act in each.acts if act.time < time and act.subject == f"axis {last.moment.axis}"]
    return [*before[-1:], *(act for act in each.acts if act.time >= time)]


# ------------------------------------------------------------------------------------------------------- the cycle


def _cycle_rows(
    exploration: Exploration, structure: Structure, names: ReaderNames, begin: float, end: float
) -> Iterator[CycleRow]:
    """Yield what happens between two times in the run of a cycle, but for the tasks beside the work."""
    run, beside = exploration.world.run, exploration.beside
    log, line, homes = run.machine.log, structure.line, run.dialect.table().homes
    within = partial(_is_within, begin=begin, end=end)
    inputs = entries(exploration.world.settings, "input")
    # What comes and goes by itself is none of the work.
    periodic = {each["channel"] for each in inputs if "every" in each}
    for each in log.inputs:
        if within(each.time) and each.channel not in periodic:
            level = "on" if each.value else "off"
            yield CycleRow(each.time - begin, 0, f"{names[f'input {each.channel}']} {level}")
    for wait in log.waits.written():
        seconds = wait.until - wait.since
        statement = structure.statements.get(wait.at)
        is_condition = statement is not None and wait.cause == "condition" and statement.waits
        cause = statement.waits if statement is not None and is_condition else wait.cause
        if wait.at not in beside and within(wait.since) and cause != "axis" and SHORTEST <= seconds < inf:
            what = "waits" if cause == "time" else f"waits for {CAUSES[cause]}"
            yield CycleRow(wait.since - begin, line(wait.at), what, seconds)
    for move in log.moves:
        if within(move.start_time) and move.profile is not None:
            is_homing = homes(move.command)
            where = described(move, is_homing)
            start = "" if is_homing else f"from {move.to_user(move.profile.start):.6g} "
            jogs = f"{move.command} " if where.startswith(f"{move.command} ") else ""
            words = f"{names[f'axis {move.axis}']} {jogs}{start}{where.removeprefix(jogs)}"
            seconds = move.profile.duration
            yield CycleRow(move.start_time - begin, move.line, words, None if seconds == inf else seconds)
    for output in log.outputs:
        if output.at not in beside and within(output.time):
            level = "on" if output.value else "off"
            yield CycleRow(
                output.time - begin, line(output.at), f"{names[f'output {output.channel}']} {level}"
            )
    for print_ in log.prints:
        if print_.at not in beside and within(print_.time):
            yield CycleRow(print_.time - begin, line(print_.at), f"prints {plain(print_.text)!r}")


def _ending(exploration: Exploration, structure: Structure, names: ReaderNames) -> list[str]:
    """Return what happens behind the last move of a run that ends by itself and has a cycle."""
    run = exploration.world.run
    moves = run.machine.log.moves
    if run.status != "ended" or run.cycle is None:
        return []
    last = max(each.start_time for each in moves)
    found = sorted(_cycle_rows(exploration, structure, names, last, run.time + 1.0), key=attrgetter("time"))
    return [each.what for each in found if each.seconds is None]


def _joined(cycle_rows: Iterable[CycleRow]) -> list[CycleRow]:
    """Return what happens with the waits of a loop in which nothing else happens as one."""
    found: list[CycleRow] = []
    for each in cycle_rows:
        last = found[-1] if found else None
        if (
            last is not None
            and each.seconds
            and last.seconds
            and (each.line, each.what) == (last.line, last.what)
        ):
            last.seconds = each.time + each.seconds - last.time
        else:
            found.append(each)
    return found


def _folded(rows: Sequence[CycleRow]) -> list[CycleRow]:
    """Return rows with what is repeated at once several times shown once, and how often it comes again."""
    same = [(each.line, without_figures(each.what)) for each in rows]
    found, k = list[CycleRow](), 0
    while k < len(rows):
        for length in range(1, MAX_REPEATED + 1):
            part, times = same[k : k + length], 1
            # Inputs that come and go are no work that is repeated.
            while part == same[k + times * length : k + (times + 1) * length] and any(
                line for line, _ in part
            ):
                times += 1
            if times > 2:
                break
        else:
            found.append(rows[k])
            k += 1
            continue
        after = k + times * length
        found += rows[k : k + length]
        lines = {line for line, _ in part if line}
        begin, last = rows[k + length].time, rows[after - 1]
        end = rows[after].time if after < len(rows) else last.time + (last.seconds or 0.0)
        what = f"{times - 1} times more: line{'s' * (len(lines) > 1)} {ranges(lines)}"
        found.append(CycleRow(begin, min(lines), what, end - begin))
        k = after
    return found


def _is_within(time: float, begin: float, end: float) -> bool:
    return begin - 1e-9 <= time < end - 1e-9


# ------------------------------------------------------------------------------------------------- what never ran


def never_run(exploration: Exploration, structure: Structure) -> Iterator[UnreachedRow]:
    """Yield the lines that something leads to and that no trial of an exploration has carried out."""
    points, statements, counted = structure.points, structure.statements, set(exploration.program.offsets)
    begun = exploration.begun
    why: dict[int, str] = {}
    for unit in structure.units:
        why |= dict.fromkeys(_first(structure, counted, unit.entry), unit.title)
    for point in points:
        statement = statements.get(point.at)
        if point.at in begun and statement is not None and point.branches:
            condition = statement.condition or statement.text
            for side, following in enumerate(point.next):
                text = f"line {statement.line}: {'unless' if side else 'if'} {condition}"
                for at in _first(structure, counted, following):
                    why.setdefault(at, text)
    reached = Reachability(structure).reached
    found: UnreachedRow | None = None
    for at in sorted(counted.intersection(reached) - begun):
        line, reason = structure.line(at), why.get(at, "")
        if found is not None and not reason and line <= found.last + 1:
            found.last = line
            continue
        if found is not None:
            yield found
        found = UnreachedRow(line, line, statements[at].text, reason)
    if found is not None:
        yield found


def _first(structure: Structure, counted: Collection[int], start: int) -> Iterator[int]:
    """Yield the offsets of the first statements from a point on."""
    points, seen, stack = structure.points, set[int](), [start]
    while stack:
        p = stack.pop()
        if p in seen:
            continue
        seen.add(p)
        # A jump behind the last statement of a block belongs to that statement, too.
        if points[p].at in counted and (not p or points[p - 1].at != points[p].at):
            yield points[p].at
        else:
            stack += points[p].next
