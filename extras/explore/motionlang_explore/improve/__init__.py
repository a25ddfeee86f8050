"""A shorter cycle of a program, by other values of the numbers that set its speeds, rates and jerks.

Problem. A machine could be faster than its program, but not everywhere: what is not on the critical path gains nothing,
and what is must not exceed a limit, change the order of what the machine does, or break what a scenario expects.

Idea. Only literals and constants count that such a quantity of an axis on the critical path follows, through whatever
variables: each is made a little lower, and the run shows it. Each of these is changed as far as a run allows: the text
is edited, run, certified against `[axis.N.limits]`, and compared with the original run. All are put at their limits
first, and those go back that gain nothing. Then one is changed after the other, on top of what was gained, until none
gains more. Of these edits the fewest are chosen that reach the wanted gain, by
trying all sets of one, of two, and so on.

    must not change    what each task does and in which order: moves with their ends, outputs, prints (their figures
                       may); the place of an output in a move; the final positions, the status, limits met and faults
                       (`behaviour.py`), the expectations of scenarios
    must hold          every limit of the machine file, also that of the motor's torque if there is one

Each change is found by doubling and bisection, in both directions, until it is not allowed or gains nothing more. Of
values with the same gain the one nearest to the original is chosen, rounded to three digits.

A dwell in ticks of a timer hides what one edit gains. So all numbers that could be larger without a loss are then tried
together, and each is made as small as the gain allows.

Cost: about 25 runs of `CYCLES` cycles for each literal, and one for each set of edits. The edits that are left are run
in full, in the own world and in each scenario; one that fails there is taken out. At last they are played in all ways
that an exploration of the program finds (`ways.py`).
"""

from __future__ import annotations

import os
import re
from bisect import bisect_right
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations, cycle, pairwise
from math import ceil, copysign, floor, inf, log10
from statistics import median
from typing import Any

from motionlang.commands.certify import MOTOR, CertifiedLimit, certificate, missing_limits
from motionlang.commands.profile.motions import MOVING
from motionlang.commands.profile.profile import TimeProfile
from motionlang.commands.quantities import cycle_of, cycle_times, no_cycle_notes
from motionlang.commands.scenarios import Entry, Scenario, scenario_files, unmet
from motionlang.commands.sweep.job import SweepJob, SweepWorker
from motionlang.kernel import (
    CheckedSettings,
    Dialect,
    ProgramError,
    Run,
    Source,
    checked_settings,
    dialect_for,
    run,
    settings_next_to,
)
from motionlang.kernel.failures import failures
from motionlang.kernel.lang import Literal, Structure, Use, canonical, number, number_text, replaced
from motionlang.kernel.log import LoggedMove
from motionlang.kernel.tools import bisected, listed, nearest
from motionlang_explore.improve.acts import CYCLES
from motionlang_explore.improve.behaviour import SAME, Behaviour
from motionlang_explore.improve.groups import Groups
from motionlang_explore.improve.pieces import PieceTimes
from motionlang_explore.improve.process import AS_SAID, QUANTITIES, SPEED, MoveChange, Process
from motionlang_explore.improve.tasks import Tasks
from motionlang_explore.improve.ways import PlayedWays, played_ways

# The units of what is not changed: nothing, and the number of a choice.
CHOICES = frozenset(("", "integer"))
# The units of speeds, rates and jerks.
RATES = frozenset(("uu/s", "uu/s2", "uu/s3"))
# A change of the cycle below this share of it is none; one below `WORTH` is not worth an edit.
NOTHING, WORTH = 1e-9, 2e-3
# So much less of the cycle is not worth a larger value. What bounds a value that is large enough.
ENOUGH, SATED = 1e-4, "more gains nothing"
# What bounds a number that gains only with others.
HIDDEN = "the tick that the cycle waits for"
# What bounds a value is seen at one that is larger by this factor.
FURTHER = 1.05
# The largest factor by which a number is changed, and the steps of the bisection between two factors.
MAX_FACTOR, STEPS = 16.0, 7
UNTRIED = f"more than {MAX_FACTOR:.0f} times was not tried"
# Of more edits than this not all sets are tried, but those of the best ones.
MAX_EDITS = 8
# A number is made lower by this factor to see which moves follow it: by enough for a speed of a few counts.
LOWER = 0.75
# The name that frees all numbers of a process.
ALL = "all"
# A wait that ends less than this after the motion is not too long, s.
SHORT = 1e-3


@dataclass
class Edit:
    """Another value of a literal; `share` is the gain of the cycle in seconds, `bound` is why there is not more.

    `outputs` are the names of those that are on during its moves: the value may be that of the process.
    """

    literal: Literal
    value: float
    share: float = 0.0
    bound: str = ""
    outputs: tuple[str, ...] = ()


@dataclass
class Held:
    """A literal that stays as it is, and the reason."""

    literal: Literal
    reason: str


@dataclass
class Improvement:
    """The edits, the source with them, and its run; `before` and `after` are the cycles, s.

    `cycle` is the name of the cycle if one was given, "cycle" if not, "" if it is the whole run; `where` has its lines
    and how often it occurs.

    `held` are the numbers of the process, which stay. `skipped` are the remarks about what could not be changed,
    `waits` those about waits that could go and about motions that stop elsewhere, `refused` has why each other literal
    stays. `ways` has what the edits do in all ways that the machine can go, None without edits. `edits` is empty if
    nothing can be gained; `sets` then says what sets the cycle. `trials` is the number of
    runs.
    """

    source: Source
    patched: Source
    cycle: str
    where: str
    before: float
    after: float
    edits: list[Edit]
    result: Run
    limits: list[CertifiedLimit]
    held: list[Held] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)
    waits: list[str] = field(default_factory=list)
    refused: list[str] = field(default_factory=list)
    ways: PlayedWays | None = None
    sets: str = ""
    trials: int = 0


@dataclass
class ExpectedWorld:
    """Settings of a machine, and what is expected of a run there; `name` is that of a scenario."""

    name: str
    settings: Mapping[str, object]
    expected: Sequence[Entry] = ()


class NotPossible(ValueError):
    """A program whose cycle cannot be improved, and what to do."""

    def __init__(self, message: str, hint: str, code: str = "beyond-limit") -> None:
        super().__init__(message)
        self.message, self.hint, self.code = message, hint, code


class Improver:
    """Improves the cycle of a program in its own `world`.

    `others` are its scenarios. `cycle` is the name of the cycle as a quantity; without one it is the cycle of the run,
    or the whole run if that ends and repeats nothing. `progress` is called with the number of runs so far, and
    with what is played of the ways of the program. `machine` is the path of the machine file, for messages. `hold` are
    the addresses or names of numbers that stay, in addition to those of the machine file and of comments; `also` those
    of the process that are tried all the same. `allow` has the events that the run may have.
    """

    def __init__(
        self,
        source: Source,
        language: Dialect,
        world: ExpectedWorld,
        others: Sequence[ExpectedWorld] = (),
        *,
        cycle: str = "",
        until: float | None = None,
        progress: Callable[[int, str], object] = lambda runs, playing: None,
        machine: str | None = None,
        hold: Iterable[str] = (),
        also: Iterable[str] = (),
        allow: Collection[str] = (),
    ) -> None:
        self.machine, self._in = machine, "" if machine is None else f" in {machine}"
        self.source, self.language, self.world, self.others = source, language, world, others
        self.until, self._progress, self._runs = until, progress, 0
        # What runs the program in each world with other numbers, in full; the numbers of all trials, as they are.
        self._worker = self._short = self._worker_until(until)
        self._numbers: dict[str, float] = {}
        program = self._worker.program(world.settings)
        self.literals = [*program.constants, *program.literals]
        named_in_file: list[str] = world.settings.get("improve.hold", [])  # type: ignore[assignment]
        self._hold = self._known((*hold, *named_in_file))
        self._also = self._known(also, ALL)
        self.held: list[Held] = []
        self.skipped: list[str] = []
        self._refused: dict[str, str] = {}
        # The moves whose speed follows a literal; the literals that speeds, rates or jerks are proportional to, with
        # their highest values by the limits, and what these are in words.
        self._moves: dict[str, list[LoggedMove]] = {}
        self._rates: dict[str, tuple[float, str]] = {}
        # What each literal changes, and what else it sets; the literals that are scaled along with another one.
        self._changes: dict[str, list[MoveChange]] = {}
        self._also_sets: dict[str, str] = {}
        self._along_with: dict[str, list[Literal]] = {}
        # The powers of the factor of time by which these are scaled.
        self._powers: Mapping[str, int] = {}
        self._base = self._run(world)
        found = None if cycle else self._base.cycle
        self.cycle = cycle if found is None else found.name or "cycle"
        self._title = cycle or ("" if found is None else "cycle")
        self.before = self._cost(self._base)
        wrong = failures(self._base, allow)
        if wrong:
            raise ProgramError(wrong)
        if (self._base.status != "ended" and not self.cycle) or not 0.0 < self.before < inf:
            raise NotPossible(
                "the program has no cycle to improve: nothing repeats",
                "; ".join(["motionlang run shows what it does", *no_cycle_notes(self._base, {cycle: None})]),
                "option",
            )
        if not self.cycle and not _works(self._base):
            raise NotPossible(
                "the program has no cycle to improve: the run only homes its axes",
                "the machine file lacks what lets it work: motionlang run shows where it waits",
                "option",
            )
        assert self._base.program is not None
        self._structure = self._base.program.structure
        self._tasks = Tasks(self._base, () if found is None else found.lines)
        starts = self._starts(self._base)
        self._pieces = PieceTimes(
            self._base, self._tasks, starts, self._tasks.at(found.lines[0] if found else 0)
        )
        self._whole = Behaviour(self._base, self._tasks, starts)
        self._behaviour = self._of_cycles(starts)
        count = found.count if found is not None else len(starts) - 1
        self._where = f"{found.where}, {count} times" if found is not None else f"{count} times"
        self._process = Process(self._base, self._tasks, starts)
        self._limits = certificate(self._base.controller, self._base.machine.settings, self._base.time)
        # What the program exceeds already is no edit's, as long as no edit makes it worse: an edit moves no position.
        self._exceeded = {
            (each.axis, each.name): each.margin for each in self._limits if each.verdict == "exceeded"
        }
        for axis, name in self._exceeded:
            if "position" not in name:
                raise NotPossible(
                    f"the {name} of axis {axis} exceeds its limit already",
                    "motionlang certify lists the limits",
                )
            self.skipped.append(
                f"the {name} of axis {axis} exceeds its limit already: see motionlang certify"
            )
        self._unmet = [unmet(self._run(each), list(each.expected)) for each in (world, *others)]

    # ------------------------------------------------------------------------------------------------ the answer

    def _known(self, names: Iterable[str], *others: str) -> set[str]:
        known = {*others, *(name for each in self.literals for name in _names_of(each))}
        found = set()
        for each in names:
            name = canonical(each) or each.lower()
            if name not in known:
                near = nearest(each, [*others, *(literal.address for literal in self.literals)])
                hint = f"did you mean {near}?" if near else "motionlang check --literals lists its numbers"
                raise NotPossible(f"the program has no number {each}", hint, "option")
            found.add(name)
        return found

    def improved(self, by: float = 0.0, most: int = 0) -> Improvement:
        """Return the fewest edits that gain the share `by` of the cycle, or the best ones, at most `most` if given."""
        edits = self._proven(self._all())
        chosen = self._chosen(edits, by, most)
        if len(chosen) < len(edits):
            chosen = self._proven(chosen)
        values = self._scaled({each.literal.address: each.value for each in chosen})
        patched, result = self._patched(values), self._trial(self.world, values, self._worker)
        after = self._cost(result)
        self._share(chosen)
        limits = certificate(result.controller, result.machine.settings, result.time)
        notes = [
            *self._pieces.moved(result, "this run"),
            *_rests(self._base, result),
            *dict.fromkeys(_waits(result, self._tasks)),
        ]
        made = {each.literal.address for each in edits}
        chosen = [edit for each in chosen for edit in (each, *self._others(each, values))]
        refused = [text for address, text in self._refused.items() if address not in made]
        sets = "" if chosen or refused else _what_sets(self._base)
        settings = self.world.settings
        program = self.language.program(self.source, settings, is_debug=True) if chosen else None
        ways = None
        if program is not None:
            ways = played_ways(
                program, values, settings, self._tasks, lambda _, playing: self._progress(self._runs, playing)
            )
        return Improvement(
            self.source, patched, self._title, self._where, self.before, after, chosen, result, limits, self.held,
            self.skipped, notes, refused, ways, sets, self._runs,
        )  # fmt: skip

    def _all(self) -> list[Edit]:
        """Return all edits that are worth it: each literal in turn, until none gains more on top of the others."""
        candidates = self._free(self._candidates())
        best, joint = self._jointly(candidates)
        edits, last = {each.literal.address: each for each in joint}, ""
        # Once around without a gain since the last edit, none is left.
        for literal in cycle(candidates):
            if literal.address == last:
                break
            values = {each.literal.address: each.value for each in edits.values()}
            cost, edit = self._search(literal, values, best)
            worth = ENOUGH if literal.address in edits else WORTH
            if edit is not None and best - cost > worth * best:
                edits[literal.address] = edit
                best, last = cost, literal.address
            last = last or literal.address
        for edit in self._together([each for each in candidates if each.address not in edits], edits, best):
            edits[edit.literal.address] = edit
        return list(edits.values())

    def _jointly(self, candidates: Sequence[Literal]) -> tuple[float, list[Edit]]:
        edits = []
        for literal in candidates:
            highest, words = self._rates.get(literal.address, (inf, ""))
            value = _rounded(copysign(highest, literal.value), False) if highest < inf else literal.value
            if abs(value) > abs(literal.value):
                edits.append(Edit(literal, value, bound=words))
        values = {each.literal.address: each.value for each in edits}
        cost, reason = self._judge(values) if len(edits) > 1 else (inf, "")
        if reason or cost > self.before * (1.0 - WORTH):
            return self.before, []
        for edit in list(edits):
            address, was = edit.literal.address, edit.literal.value
            without, reason = self._judge({**values, address: was})
            if not reason and without <= cost * (1.0 + WORTH):
                del values[address]
                edits.remove(edit)
                cost = without
                continue
            values[address] = edit.value = self._least(edit, values, cost)
        return self._judge(values)[0], edits

    def _least(self, edit: Edit, values: Mapping[str, float], cost: float) -> float:
        def is_enough(value: float) -> bool:
            return self._is_within({**values, edit.literal.address: value}, cost * (1.0 + ENOUGH))

        low, high = edit.literal.value, edit.value
        nearly = 0.02 * low + 0.98 * high
        if not is_enough(nearly):
            return high
        high = bisected(nearly, low, is_enough, STEPS)
        round_ = _roundest(high, 1.02 * high)
        return round_ if is_enough(round_) else high

    def _together(self, left: Sequence[Literal], edits: Mapping[str, Edit], best: float) -> list[Edit]:
        base = {each.literal.address: each.value for each in edits.values()}
        values = dict(base)
        found = []
        for literal in left:
            value = self._furthest(literal, values, best) if literal.address in self._rates else literal.value
            if value != literal.value:
                values[literal.address] = value
                found.append(Edit(literal, value, bound=HIDDEN))
        cost, reason = self._judge(values)
        if len(found) < 2 or reason or cost > best * (1.0 - WORTH):
            return []
        # No more of them, and no more of each, than the gain takes.
        for edit in list(found):
            address = edit.literal.address
            if self._is_within({**values, address: edit.literal.value}, cost * (1.0 + ENOUGH)):
                del values[address]
                found.remove(edit)
            else:
                values[address] = edit.value = self._least(edit, values, cost)
        return found

    def _furthest(self, literal: Literal, values: Mapping[str, float], best: float) -> float:
        def is_allowed(factor: float) -> bool:
            return self._is_within({**values, literal.address: literal.value * factor}, best * (1.0 + WORTH))

        low, high = 1.0, 2.0
        while high <= MAX_FACTOR and is_allowed(high):
            low, high = high, 2.0 * high
        if high <= MAX_FACTOR:
            low = bisected(low, high, is_allowed, STEPS)
        return _rounded(literal.value * low, True) if low > 1.0 else literal.value

    def _proven(self, edits: Sequence[Edit]) -> list[Edit]:
        if not edits or not self._failure(edits):
            return list(edits)
        left: list[Edit] = []
        for each in edits:
            reason = self._failure([*left, each])
            if reason:
                self._refuse(each.literal, reason)
            else:
                left.append(each)
        return left

    def _failure(self, edits: Sequence[Edit]) -> str:
        values = {each.literal.address: each.value for each in edits}
        result = self._trial(self.world, values, self._worker)
        reason = self._whole.difference(result, self._starts(result)) or self._beyond(result)
        if not reason and self._cost(result) > self.before * (1.0 - NOTHING):
            reason = "the cycle of the whole run is no shorter"
        if reason:
            return reason
        for world, before in zip((self.world, *self.others), self._unmet, strict=True):
            if world.expected or world is not self.world:
                run = result if world is self.world else self._trial(world, values, self._worker)
                new = [each for each in unmet(run, list(world.expected)) if each not in before]
                if new:
                    return f"{f'scenario {world.name}: ' if world.name else ''}{new[0]}"
        return ""

    def _chosen(self, edits: Sequence[Edit], by: float, most: int) -> list[Edit]:
        if not (by or most) or len(edits) <= 1:
            return list(edits)
        pool = sorted(edits, key=lambda each: self._tried([each]))[:MAX_EDITS]
        pool.sort(key=lambda each: each.literal.offset)
        best, lowest = list[Edit](), self.before
        for size in range(1, min(most or len(pool), len(pool)) + 1):
            for each in combinations(pool, size):
                cost = self._tried(each)
                if cost < lowest * (1.0 - NOTHING):
                    best, lowest = list(each), cost
            if by and lowest <= self.before * (1.0 - by):
                return best
        return best if most else list(edits)

    def _tried(self, edits: Sequence[Edit]) -> float:
        values = {each.literal.address: each.value for each in edits}
        cost, reason = self._judge(values)
        return inf if reason else cost

    def _share(self, edits: Sequence[Edit]) -> None:
        """Give each edit the gain that it adds to those before it, and what bounds it when all are made."""
        last, values = self.before, dict[str, float]()
        for each in edits:
            values[each.literal.address] = each.value
            cost = self._judge(values)[0]
            each.share, last = last - cost, cost
        for each in edits:
            is_larger = abs(each.value) > abs(each.literal.value)
            further = each.value * (FURTHER if is_larger else 1.0 / FURTHER)
            cost, reason = self._judge({**values, each.literal.address: further})
            each.outputs = tuple(self._process.outputs(self._moves.get(each.literal.address, ())))
            is_open = cost < last * (1.0 - NOTHING) or each.bound == HIDDEN
            each.bound = reason or (each.bound if is_open else SATED)

    # ------------------------------------------------------------------------------------------------ candidates

    def _candidates(self) -> list[Literal]:
        """Return the literals that a speed, a rate and so on of a limited axis on the critical path follows."""
        spans = TimeProfile(self._base).spans()
        axes = {axis for _, _, about in spans if about[0] in MOVING for axis in about[3]}
        axes = axes or {move.axis for move in self._base.moves}  # with a motor, waits are for a condition
        limited = {each.axis for each in self._limits}
        self._leading = _leading_to_rates(self._structure)
        self._words = {each.lower() for text in self._leading.values() for each in re.findall(r"\w+", text)}
        self._offsets = sorted(self._structure.statements)
        self._numbers = {each.address: each.value for each in self.literals if self._may_set(each)}
        lacking: dict[int, dict[str, list[Literal]]] = {}
        found = []
        for literal in self.literals:
            if literal.address not in self._numbers:
                continue
            lowered = self._lowered(literal)
            if lowered is None:
                continue
            changes = self._changes[literal.address] = self._process.changes(lowered)
            self._also_sets[literal.address] = self._process.also_sets(lowered, LOWER)
            needed = dict.fromkeys(
                (each.move.axis, each.quantity) for each in changes if each.move.axis in axes
            )
            without = [each for each in needed if not self._is_bounded(*each)]
            for axis, name in without:
                lacking.setdefault(axis, {}).setdefault(name, []).append(literal)
            self._moves[literal.address] = [each.move for each in changes if each.quantity == SPEED]
            if needed and not without:
                found.append(literal)
            if changes and all(each.is_proportional(LOWER) for each in changes):
                self._rates[literal.address] = self._cap(literal, changes)
        if lacking:
            self._need(dict(sorted(lacking.items())), limited)
        return found

    def _is_bounded(self, axis: int, quantity: str) -> bool:
        names = {each.name.replace(" ", "_") for each in self._limits if each.axis == axis}
        return not names.isdisjoint((quantity, *MOTOR))

    def _may_set(self, literal: Literal) -> bool:
        if not (literal.is_write and literal.value):
            return False
        at = self._offsets[max(bisect_right(self._offsets, literal.offset) - 1, 0)]
        return at in self._leading or literal.base.lower() in self._words

    def _lowered(self, literal: Literal) -> Run | None:
        """Return the run with a lower number; None if the program is refused with it."""
        try:
            made = self._trial(self.world, {literal.address: literal.value * LOWER})
        except ProgramError:
            return None
        return made if made.program is not None else None

    def _cap(self, literal: Literal, changes: Iterable[MoveChange]) -> tuple[float, str]:
        found = [
            (abs(literal.value) * each.limit / change.value, _limit_text(each))
            for change in changes
            for each in self._limits
            if (each.axis, each.name) == (change.move.axis, change.quantity)
        ]
        value, words = min(found, default=(inf, ""))
        return max(value, abs(literal.value)), words

    def _need(self, lacking: Mapping[int, Mapping[str, Sequence[Literal]]], limited: Collection[int]) -> None:
        """Name the numbers whose limits are missing; raise NotPossible if there are no limits."""
        missing = {axis: sorted(names, key=QUANTITIES.index) for axis, names in lacking.items()}
        figures = "; ".join(
            f"axis {axis}: {', '.join(f'limits.{name}' for name in names)}" for axis, names in missing.items()
        )
        axis, names = next(iter(missing.items()))
        by_hand = f"--set axis.{axis}.limits.{names[0]}=VALUE"
        if not limited:
            raise NotPossible(
                "nothing bounds a faster cycle: the machine file has no limits",
                f"it needs {figures}: {by_hand}, or "
                + missing_limits(self.source.name, self.machine, self.language.first_axis),
            )
        stay = {
            id(each): f"{each.address} = {each.text}"
            for some in lacking.values()
            for one in some.values()
            for each in one
        }
        self.skipped.append(
            f"{', '.join(stay.values())} stay: limits are missing{self._in}, {figures}; {by_hand} gives one"
        )

    def _free(self, candidates: Sequence[Literal]) -> list[Literal]:
        """Return a number of each group that is not held; the others of its group are scaled along with it."""
        literals = {each.address: each for each in self.literals if self._changes.get(each.address)}
        speeds = [each for each in literals.values() if self._moves[each.address]]
        reasons = {each.address: self._why_held(each, speeds) for each in literals.values()}
        groups = Groups(self._base, self._tasks, self._changes)
        self._powers = groups.powers
        free: dict[str, Literal] = {}
        for literal in candidates:
            address, group = literal.address, groups.of[literal.address]
            reason = reasons[address]
            if not reason and not self._is_tried(literal):
                other = next((each for each in group if reasons[each]), "")
                reason = f"its axis moves with that of {other}, which stays" if other else ""
                if address in groups.parts:
                    reason = (
                        reason or f"its axis moves with axis {groups.parts[address]}, which keeps its own"
                    )
            if reason:
                self.held.append(Held(literal, reason))
            elif not any(each in free for each in group):
                free[address] = literal
                others = [literals[each] for each in group if each != address and not reasons[each]]
                self._along_with[address] = others
                power = self._powers.get(address, 1)
                caps = [
                    (
                        abs(literal.value) * (cap / abs(each.value)) ** (power / self._powers[each.address]),
                        words,
                    )
                    for each in (literal, *others)
                    for cap, words in (self._rates.get(each.address, (inf, "")),)
                    if cap < inf
                ]
                if address in self._rates:
                    self._rates[address] = min(caps, default=(inf, ""))
        return list(free.values())

    def _is_tried(self, literal: Literal) -> bool:
        """True if the user wants a number of the process to be tried."""
        return not {ALL, *_names_of(literal)}.isdisjoint(self._also)

    def _scaled(self, values: Mapping[str, float]) -> dict[str, float]:
        """Return values with those of the numbers that are scaled along."""
        found = dict(values)
        for literal in self.literals:
            factor = values.get(literal.address, literal.value) / (literal.value or 1.0)
            if factor != 1.0:
                for other in self._along_with.get(literal.address, ()):
                    power = self._powers[other.address] / self._powers[literal.address]
                    found[other.address] = float(f"{other.value * factor**power:.6g}")
        return found

    def _others(self, edit: Edit, values: Mapping[str, float]) -> Iterator[Edit]:
        """Yield the edits of the numbers that are scaled along with one."""
        for other in self._along_with.get(edit.literal.address, ()):
            yield Edit(other, values[other.address], 0.0, f"scaled with {edit.literal.address}")

    def _why_held(self, literal: Literal, speeds: Sequence[Literal]) -> str:
        names = _names_of(literal)
        if names & self._hold:
            return AS_SAID
        if names & self._also:
            return ""
        comment = self._process.comment(literal, speeds)
        if comment == AS_SAID or ALL in self._also:
            return comment if comment == AS_SAID else ""
        lacking = [(each.move.axis, each.quantity) for each in self._changes[literal.address]]
        for axis, quantity in dict.fromkeys(lacking):
            if not self._is_bounded(axis, quantity):
                return f"limits.{quantity} of axis {axis} is missing"
        reason = self._process.reason(self._moves[literal.address], literal.value)
        return reason or self._also_sets[literal.address] or comment

    # -------------------------------------------------------------------------------------------------- searching

    def _search(
        self, literal: Literal, values: Mapping[str, float], best: float
    ) -> tuple[float, Edit | None]:
        was = values.get(literal.address, literal.value)
        if not was:
            return best, None
        found: tuple[float, Edit | None] = best, None
        bounds = []
        for grows in (True, False):
            cost, edit, bound = self._along(literal, was, values, best, grows)
            bounds.append(bound)
            if edit is not None and cost < found[0] * (1.0 - NOTHING):
                found = cost, edit
        reason = next((each for each in bounds if each not in (SATED, UNTRIED)), SATED)
        if found[1] is None and literal.address not in self._refused:
            self._refuse(literal, reason)
        return found

    def _refuse(self, literal: Literal, reason: str) -> None:
        stay = [f"{each.address} stays {each.text}" for each in (literal, *self._along_with[literal.address])]
        self._refused[literal.address] = f"{listed(stay)}: {reason}"

    def _along(
        self, literal: Literal, was: float, values: Mapping[str, float], best: float, grows: bool
    ) -> tuple[float, Edit | None, str]:
        def judged(factor: float) -> tuple[float, str]:
            value = was * factor if grows else was / factor
            round_ = _rounded(value, grows)
            return self._judge({**values, literal.address: value if round_ == was else round_})

        slower, low, cost, bound, is_free = 1.0, 1.0, best, SATED, False
        high, refused = 2.0, ""
        while high <= MAX_FACTOR:
            made, refused = judged(high)
            if refused or made >= cost * (1.0 - NOTHING):
                bound = refused or bound
                break
            slower, low, cost, high = low, high, made, 2.0 * high
        else:
            bound = UNTRIED
        for _ in range(STEPS if refused else 0):
            middle = 0.5 * (low + high)
            made, reason = judged(middle)
            is_free = is_free or not reason
            if not reason and made < cost * (1.0 - NOTHING):
                slower, low, cost = low, middle, made
            else:
                high, bound = middle, reason or bound
        if low == 1.0:
            return best, None, f"{SATED} (bounded by {bound})" if is_free and bound != SATED else bound
        if bound in (SATED, UNTRIED):
            # It may be more than enough.
            def is_enough(factor: float) -> bool:
                made, reason = judged(factor)
                return not reason and made <= cost * (1.0 + ENOUGH)

            low = bisected(low, slower, is_enough, STEPS)
            high = 1.02 * low
        value, beyond = (was * each if grows else was / each for each in (low, high))
        round_ = _roundest(value, beyond)
        made, reason = self._judge({**values, literal.address: round_})
        if reason or made > cost * (1.0 + ENOUGH):
            round_ = _rounded(value, grows)
            cost, _ = self._judge({**values, literal.address: round_})
        else:
            cost = made
        return cost, Edit(literal, round_, bound=bound), bound

    def _patched(self, values: Mapping[str, float]) -> Source:
        edits = {
            each.offset: (len(each.text), number_text(each.address, values[each.address]))
            for each in self.literals
            if each.address in values
        }
        return Source(self.source.name, replaced(self.source.text, edits))

    def _judge(self, values: Mapping[str, float]) -> tuple[float, str]:
        for address, value in values.items():
            # Also a speed that no move reaches is none that the machine allows.
            highest, words = self._rates.get(address, (inf, ""))
            if abs(value) > highest * (1.0 + NOTHING):
                return inf, words
        result = self._trial(self.world, values)
        cost = self._cost(result)
        reason = self._behaviour.difference(result, self._starts(result)) or self._beyond(result)
        return cost, reason or ("" if 0.0 < cost < inf else "nothing repeats any more")

    def _is_within(self, values: Mapping[str, float], most: float) -> bool:
        cost, reason = self._judge(values)
        return not reason and cost <= most

    def _beyond(self, result: Run) -> str:
        for each in certificate(result.controller, result.machine.settings, result.time):
            before = self._exceeded.get((each.axis, each.name))
            if each.verdict == "exceeded" and (before is None or (each.margin or 0.0) < before - SAME):
                return _limit_text(each)
        return ""

    def _run(self, world: ExpectedWorld) -> Run:
        self._count()
        settings = CheckedSettings(world.settings)
        return run(self._worker.program(settings), machine=settings, until=self.until)

    def _trial(
        self, world: ExpectedWorld, values: Mapping[str, float], worker: SweepWorker | None = None
    ) -> Run:
        numbers = {**self._numbers, **self._scaled(values)}
        given = {name: number(name, value) for name, value in numbers.items()}
        used = worker or self._short
        if world is not self.world:
            self._count()
            return used.run_given(given, world.settings)
        return self._pieces.played(lambda settings: self._played(used, given, settings))

    def _played(
        self, worker: SweepWorker, given: Mapping[str, float | str], settings: Mapping[str, object]
    ) -> Run:
        self._count()
        return worker.run_given(given, CheckedSettings(settings))

    def _worker_until(self, until: float | None) -> SweepWorker:
        return SweepWorker(
            SweepJob(self.source, self.language.name, (), (), self.world.settings, {}, {}, until)
        )

    def _of_cycles(self, starts: Sequence[float]) -> Behaviour:
        """Return the behaviour of the first cycles, which trials have from now on; of the whole run if they differ."""
        periods = [after - before for before, after in pairwise(starts[: CYCLES + 1])]
        if len(starts) <= CYCLES + 1 or abs(median(periods) - self.before) > ENOUGH * self.before:
            return self._whole
        until = starts[CYCLES] + SHORT
        self._short = self._worker_until(until)
        short = run(
            self._short.program(self.world.settings),
            machine=CheckedSettings(self.world.settings),
            until=until,
        )
        self._count()
        return Behaviour(short, self._tasks, self._starts(short), self._base.status)

    def _count(self) -> None:
        self._runs += 1
        self._progress(self._runs, "")

    def _starts(self, result: Run) -> Sequence[float]:
        return cycle_times(result, self.cycle) if self.cycle else ()

    def _cost(self, result: Run) -> float:
        found = cycle_of(result, self.cycle) if self.cycle else result.time
        return inf if found is None else float(found)


def improver_of(
    program: str | Source,
    settings: Mapping[str, object] | str | os.PathLike[str] | None = None,
    /,
    dialect: str | Dialect | None = None,
    **given: Any,
) -> Improver:
    """Return the improver of a program in its own world and its scenarios; `given` is as for `Improver`.

    `settings` are those in place of the machine file. Raises OSError if a file cannot be read, ProgramError
    for a wrong one, and NotPossible.
    """
    source = program if isinstance(program, Source) else Source.read(program)
    settings = settings_next_to(program) if settings is None else checked_settings(settings)
    files = [] if isinstance(program, Source) else scenario_files(program)
    others = [Scenario(str(program), each) for each in files]
    expected: list[Entry] = settings.get("expect", [])  # type: ignore[assignment]
    worlds = [ExpectedWorld(each.name, each.settings, each.expected) for each in others]
    return Improver(
        source, dialect_for(source, dialect), ExpectedWorld("", settings, expected), worlds, **given
    )


def _limit_text(limit: CertifiedLimit) -> str:
    return f"{limit.name} of axis {limit.axis}: {limit.limit:.6g} {limit.unit}"


def _names_of(literal: Literal) -> set[str]:
    names = canonical(literal.address) or literal.address, literal.base
    return {*names, *(each.lower() for each in names)}


def _leading_to_rates(structure: Structure) -> dict[int, str]:
    """Return the statements that write a rate, or a variable that may lead to one, with their texts, by offset."""
    assigning: dict[tuple[str, int], list[int]] = {}
    read_at: dict[int, set[tuple[str, int]]] = {}
    # The junctions, which are last, use nothing.
    for point, use in zip(structure.points, structure.graph.uses, strict=False):
        if use is not None:
            own = point.key[0]  # variables of a call have numbers below 0 in each list of steps
            read_at.setdefault(point.at, set()).update((own if n < 0 else "", n) for n in use.reads)
            for n in use.sets | use.parts:
                assigning.setdefault((own if n < 0 else "", n), []).append(point.at)
    left = [at for at, each in structure.statements.items() if any(map(_is_rate, each.uses))]
    found = dict.fromkeys(left, "")
    while left:
        for variable in read_at.get(left.pop(), ()):
            for at in assigning.pop(variable, ()):
                if at not in found:
                    found[at] = ""
                    left.append(at)
    return {at: structure.statements[at].text for at in found if at in structure.statements}


def _is_rate(use: Use) -> bool:
    row = use.row
    if row is None or use.role == "read":
        return False
    return row.unit in RATES or (row.topic == "speed" and row.unit not in CHOICES)


def _works(run: Run) -> bool:
    table = run.dialect.table()
    moves = run.machine.log.moves
    return not len(moves) or not all(table.homes(move.command) for move in moves)


def _what_sets(run: Run) -> str:
    share = next((each for each in TimeProfile(run).lines() if each.line), None)
    if share is None:
        return ""
    moves = [move for move in run.machine.log.moves if move.line == share.line and move.profile is not None]
    longest = max(moves, key=lambda move: move.profile.duration, default=None)  # type: ignore[union-attr]
    if longest is None or longest.profile is None:
        how = max(share.causes, key=lambda each: share.causes[each])
    else:
        k, profile = abs(longest.scale or 1.0), longest.profile
        distance, peak = abs(profile.distance) / k, profile.peak_speed / k
        how = f"{longest.command} of axis {longest.axis}, {distance:.6g} uu at {peak:.6g} uu/s"
    return f"line {share.line} sets the cycle: it takes {share.seconds:.6g} s of {run.time:.6g} s, {how}"


def _roundest(one: float, other: float) -> float:
    """Return the value with the fewest digits between two of the same sign, both included."""
    low, high = sorted((one, other))
    for places in range(-floor(log10(max(abs(low), abs(high)))), 12):
        value = float(f"{ceil(low * 10.0**places - 1e-9) / 10.0**places:.12g}")
        if value <= high * (1.0 + 1e-12 * (high > 0.0)):
            return value
    return one


def _rounded(value: float, grows: bool) -> float:
    size = 10.0 ** (floor(log10(abs(value))) - 2)
    steps = value / size
    near = round(steps)
    is_near = abs(steps - near) < 1e-9 * abs(steps)
    whole = near if is_near else floor(steps) + (grows is not (value > 0.0))
    return float(f"{whole * size:.3g}")


def _rests(before: Run, after: Run) -> Iterator[str]:
    """Yield a remark on each motion that the program stops and that comes to rest elsewhere, once for each line."""
    homes = before.dialect.table().homes
    stopped = (
        [move for move in run.machine.log.moves if move.ended == "stop" and move.commanded_speed is not None]
        for run in (before, after)
    )
    lines = set()
    for was, is_ in zip(*stopped, strict=False):
        if was.line == is_.line and was.profile is not None and is_.profile is not None:
            shift = (is_.profile.distance - was.profile.distance) / abs(was.scale or 1.0)
            if abs(shift) > SAME and was.line not in lines and not homes(was.command):
                lines.add(was.line)
                where = f"{shift:+.4g} uu from where it did"
                yield f"line {was.line}: {was.command} of axis {was.axis} comes to rest {where}"


def _waits(run: Run, tasks: Tasks) -> Iterator[str]:
    """Yield a remark on each fixed wait of a task that is longer than its own motion that goes on during it."""
    found: dict[int, tuple[float, float, int]] = {}
    moves = list(run.moves)
    for wait in run.machine.log.waits:
        if wait.cause != "time":
            continue
        line = run.dialect.locate(run.source, wait.at)[0]
        ends = [
            (move.start_time + move.duration, move.axis)
            for move in moves
            if move.start_time < wait.until and wait.since < move.start_time + move.duration < wait.until
            if tasks.at(move.line) == tasks.at(line)
        ]
        if ends and wait.until - max(ends)[0] > SHORT:
            end, axis = max(ends)
            left = min(wait.until - end, found.get(line, (inf,))[0])
            found[line] = left, wait.until - wait.since, axis
    for line, (left, length, axis) in sorted(found.items()):
        yield (
            f"line {line} waits {length:.6g} s while axis {axis} moves, which is at rest {left:.6g} s before: "
            "a wait for the axis would be shorter"
        )
