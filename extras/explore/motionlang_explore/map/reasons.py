"""Why a program comes to a statement, in words, from its text.

Each point of the graph has guards: the sides of branches that decide whether the program comes there. They are carried
forward once, in the order of the flow; where both sides of a branch meet, what guards the branch guards. A call guards
what it calls, a handler what it does. A side is put into words from the form of its statement: channels by their names,
a variable by the reasons of what assigns to it, a count and a clock by their numbers. Anything else is quoted. A time
in a step names what has not led on from the step; what holds at the start names what has not changed it.
"""

from __future__ import annotations

import operator
import re
from bisect import bisect_right
from collections import defaultdict
from collections.abc import Collection, Iterator, Sequence
from functools import reduce
from typing import NamedTuple

from motionlang.commands.channels import ASSIGNS, CALL, given_numbers, parameters_of, with_number
from motionlang.kernel.lang import READ, ChannelUse, Statement, Structure
from motionlang.kernel.tools import ranges
from motionlang_explore.map.names import ReaderNames

# Of each comparison its words, its opposite, that of the sides exchanged, and what it means.
_COMPARISONS = {
    "=": ("=", "<>", "=", operator.eq), "<>": ("is not", "=", "<>", operator.ne),
    "<": ("below", ">=", ">", operator.lt), ">": ("above", "<=", "<", operator.gt),
    "<=": ("at most", ">", ">=", operator.le), ">=": ("at least", "<", "<=", operator.ge),
}  # fmt: skip
# In the form of a statement: a number, a reading of a channel, one times a number, and a time.
_NUMBER = re.compile(r"-?[\d.]+")
_READING = re.compile(r"!?([A-Z]\w*)(?:\(([\d, ]*|~\w+)\))?")
_SCALED = re.compile(r"\(([\d.]+) \* (!?[A-Z]\w*(?:\([\d, ]*\))?)\)")
_CLOCK = re.compile(r"\(TIME - ~(\w+)\)|~(\w+)|TIME")
_STARTED = re.compile(r"~(\w+) TypeName ~time (\d+)")
_CASE = re.compile(r"CaseTest None (\S+) ([^\s,()]+)")
# A comparison of a channel or a register in MCCL, a register that is set, and a wait.
_STORED, _WAITED = re.compile(r"0AR '(\d+)'"), re.compile(r"0WA '([\d.]+)'")
_COMPARED = re.compile(r"((?:analogue input|register) \d+) (<>|[=<>]) (\S+)")
_TIME = re.compile(r"[\d.]+ s after ")
_TOKEN = re.compile(r"[()]|[^\s()]+")
# So many guards of a point, reasons of one thing, reasons behind one another, and assignments of a name are followed.
MAX_GUARDS, MAX_REASONS, MAX_DEPTH, MAX_SITES = 12, 6, 12, 100
# A function that is called by one that is called is followed, and no further.
MAX_CALLS = 2
# So many points of a line are searched, and a longer condition is quoted.
MAX_LENGTH = 400

# What a reason is: a quotation, a time or a count, something behind a variable, a channel or a handler.
QUOTED, COUNTED, THROUGH, DIRECT = range(4)
# A branch and its side, or ~ the entry of what begins by itself.
Guard = tuple[int, bool]


class Reason(NamedTuple):
    """A reason in words, the line of its condition, 0 if the words have it, and what it is."""

    words: str
    line: int = 0
    rank: int = QUOTED

    @property
    def text(self) -> str:
        return f"{self.words}, line {self.line}" if self.line else self.words


class Reasons:
    """The reasons why a program comes to its statements; inputs of `low` are on at a low level."""

    def __init__(self, structure: Structure, names: ReaderNames, low: Collection[int]) -> None:
        self._structure, self._names, self._low = structure, names, low
        # What begins by itself: the program, tasks, handlers, and macros that are started as tasks.
        started = {each for statement in structure.statements.values() for each in statement.starts}
        self._roots = {
            ~unit.entry: unit
            for unit in structure.units
            if unit.kind in ("program", "task", "event") or unit.title in started
        }
        self._loops = {structure.points[p].at for p in structure.graph.closing}
        self._guards: dict[int, tuple[Guard, ...]] = {}
        # The wait or loop before each point, if there is one way from it.
        self._waits: dict[int, int] = {}
        self._find_guards(self._ordered())
        # The first point of each statement, and what is assigned to each name at which point.
        self._first: dict[int, int] = {}
        self._sites: dict[str, list[tuple[int, str]]] = defaultdict(list)
        # The times for which the lines of MCCL wait.
        self._waited: dict[int, list[str]] = defaultdict(list)
        self._parameters_of, self._given = parameters_of(structure), given_numbers(structure)
        parameters = self._parameters_of
        self._parameters = {each for names in parameters.values() for each in names}
        self._entries = sorted({unit.entry for unit in structure.units})
        self._entry_of = {unit.name.lower(): unit.entry for unit in structure.units}
        self._names_of = {entry: name for name, entry in self._entry_of.items()}
        # The variables that are the numbers of channels.
        uses = (use for each in structure.statements.values() for use in each.channels)
        self._numbers = {use.alias.lower() for use in uses if use.number == "?"}
        for p in sorted(self._guards):
            statement = self._statement(p)
            if statement is not None and self._first.setdefault(statement.at, p) == p:
                assigns = ASSIGNS.fullmatch(statement.form)
                given = [(*assigns.groups(), self._unit_of(p))] if assigns is not None else []
                given += [(*clock, self._unit_of(p)) for clock in _STARTED.findall(statement.form)]
                for called, values in CALL.findall(statement.form):
                    bound = zip(parameters.get(called, ()), values.split(", "), strict=False)
                    given += [(name, value, called) for name, value in bound]
                for name, value, unit in given:
                    self._sites[name].append((p, value))
                    # A parameter is another variable than one with its name elsewhere.
                    scope = unit if name in parameters.get(unit, ()) else ""
                    self._sites[f"{name} of {scope}"].append((p, value))
                stored, waited = _STORED.fullmatch(statement.form), _WAITED.fullmatch(statement.form)
                if stored is not None:
                    value = structure.writes[statement.at + len(statement.text) - len(stored[1])]
                    self._sites[f"register {stored[1]}"].append((p, value))
                elif waited is not None:
                    self._waited[statement.line].append(waited[1])
        forms = "\n".join(each.form for each in structure.statements.values())
        self._clocks = set(re.findall(r"~(\w+) TypeName ~time", forms))
        # The points that call each unit, by its entry.
        self._calls: dict[int, list[int]] = defaultdict(list)
        for p in sorted(self._guards):
            if structure.points[p].calls >= 0:
                self._calls[structure.points[p].calls].append(p)
        self._known: dict[int, list[Reason]] = {}
        # How many reasons, and functions that are called, lie around the present one.
        self._depth = self._within_calls = 0

    def _ordered(self) -> list[int]:
        """Return the points that the program reaches, each before those that follow it but for loops."""
        points, finished, seen = self._structure.points, list[int](), set[int]()
        for unit in reversed(self._roots.values()):
            stack = [(unit.entry, False)]
            while stack:
                p, is_done = stack.pop()
                if is_done:
                    finished.append(p)
                elif p not in seen and p >= 0:
                    seen.add(p)
                    stack.append((p, True))
                    stack += ((after, False) for after in (*points[p].next, points[p].calls))
        return finished[::-1]

    def _find_guards(self, order: Sequence[int]) -> None:
        came: dict[int, dict[Guard, None]] = defaultdict(dict)
        ways: dict[int, list[int]] = defaultdict(list)
        place = {p: k for k, p in enumerate(order)}
        for p in order:
            self._guards[p] = ((~p, True),) if ~p in self._roots else self._joined(came[p])
            point, statement = self._structure.points[p], self._statement(p)
            if statement is not None and statement.condition and (statement.waits or point.at in self._loops):
                self._waits[p] = p
            elif len(ways[p]) == 1 and ways[p][0] in self._waits:
                self._waits[p] = self._waits[ways[p][0]]
            # A wait that goes on by itself, as for the end of a move, decides nothing.
            waits = statement is not None and not statement.condition and bool(statement.waits)
            decides = point.branches and not waits
            for k, after in enumerate(point.next):
                if place[after] > place[p]:
                    came[after] |= dict.fromkeys([(p, k == 0)] if decides else self._guards[p])
                    ways[after].append(p)
            if place.get(point.calls, -1) > place[p]:
                came[point.calls] |= dict.fromkeys(self._guards[p])

    def _joined(self, came: dict[Guard, None]) -> tuple[Guard, ...]:
        """Return guards without the branches of which each side comes here; behind others, a loop decides nothing."""
        found, seen, stack = dict[Guard, None](), set[Guard](), list(came)
        while stack:
            q, side = stack.pop(0)
            if (q, side) in seen:
                continue
            seen.add((q, side))
            if (q, not side) in found:
                del found[q, not side]
                stack += self._guards[q]
            elif (found or stack) and self._is_loop(q):
                stack += self._guards[q]
            elif len(found) < MAX_GUARDS:
                found[q, side] = None
        return tuple(found)

    def _statement(self, p: int) -> Statement | None:
        return self._structure.statements.get(self._structure.points[p].at) if p >= 0 else None

    def _repeats(self, q: int, p: int) -> bool:
        """True if a line goes on from one of its points to another one."""
        seen, stack = set[int](), [q]
        while stack and p not in seen and len(seen) < MAX_LENGTH:
            point = self._structure.points[stack.pop()]
            after = {
                each for each in (*point.next, point.calls) if each >= 0 and self._line(each) == self._line(q)
            }
            stack += after - seen
            seen |= after
        return p in seen

    def _line(self, p: int) -> int:
        return self._structure.line(self._structure.points[p].at)

    def _is_loop(self, p: int) -> bool:
        return p >= 0 and self._structure.points[p].at in self._loops

    # ------------------------------------------------------------------------------------------------ statements

    def knows(self, at: int) -> bool:
        """True if the program can come to the statement at an offset."""
        return at in self._first

    def waits(self, at: int) -> bool:
        """True if a statement waits for its condition, or ends a loop by it."""
        statement = self._structure.statements[at]
        is_loop = at in self._loops and bool(_condition(statement))
        return bool(statement.condition) and (bool(statement.waits) or is_loop)

    def has_clock(self, at: int) -> bool:
        """True if a statement reads the time, or a variable that counts it."""
        form = self._structure.statements[at].form
        return "TIME" in _TOKEN.findall(form) or not self._clocks.isdisjoint(re.findall(r"~(\w+)", form))

    def of(self, at: int) -> list[Reason]:
        """Return why the program comes to a statement; none if it always does."""
        return self._of(self._first[at])

    def waited(self, at: int) -> list[Reason]:
        """Return what the program has waited for before a statement, none if there is no wait, or another way."""
        p = self._waits.get(self._first[at], -1)
        statement = self._statement(p)
        return self._test(p, bool(statement.waits)) if statement is not None else []

    def values(self, name: str, at: int) -> dict[str, list[Reason]]:
        """Return the numbers but 0 that the program gives a variable, with the reasons of each, for a statement."""
        found: dict[str, list[Reason]] = defaultdict(list)
        sites = self._sites.get(name.lower(), [])
        passed = {name.lower(), *(value[1:] for _, value in sites if value.startswith("~"))}
        assigned = [
            each for each in self._assignments(name.lower()) if each[1].isdecimal() and each[1] != "0"
        ]
        tests = list(self._tests_around(self._first[at], name.lower())) if assigned else []
        for p, number in assigned:
            if all(_holds(number, sign, right) == side for sign, right, side in tests):
                known, own = self._of(p), f"{self._names[f'input {number}']} "
                # Of what is found of several channels that of the one with the number counts.
                made = (*known, *self.of(at)) if passed & self._numbers else ()
                mine = [each for each in dict.fromkeys(made) if each.words.startswith(own)]
                found[number] += mine or known
        return dict(sorted(found.items()))

    def _tests_around(self, p: int, name: str) -> Iterator[tuple[str, str, bool]]:
        """Yield the comparisons of a variable with numbers in the branches around a point, and their sides."""
        for q, side in self._blocks(p, MAX_SITES):
            statement = self._statement(q)
            left, sign, right = _binary(_condition(statement)) if statement is not None else ("", "", "")
            if _is_number(left):
                left, sign, right = right, _COMPARISONS[sign][2], left
            if left == f"~{name}" and _is_number(right):
                yield sign, right, side

    def _blocks(self, p: int, most: int = MAX_DEPTH) -> Iterator[Guard]:
        """Yield the sides of the branches around a point, from the inside, while each is the only guard."""
        for _ in range(most):
            guards = self._guards.get(p, ())
            if len(guards) != 1 or guards[0][0] < 0:
                return
            yield guards[0]
            p = guards[0][0]

    # --------------------------------------------------------------------------------------------------- reasons

    def _of(self, p: int) -> list[Reason]:
        if p in self._known or self._depth > MAX_DEPTH:
            return self._known.get(p, [])
        self._known[p] = []  # what leads to itself is no reason
        self._depth += 1
        made = [each for guard in self._guards[p] for each in self._within(*guard)]
        self._depth -= 1
        self._known[p] = list(dict.fromkeys(made))
        return self._known[p]

    def _within(self, q: int, side: bool) -> list[Reason]:
        """Return why a side is taken: a quotation or a time with the channel around it, or only what is around it."""
        if self._is_known(q, side):
            return self._of(q)
        made, statement = self._test(q, side), self._statement(q)
        handlers = [each for outer in self._outside(q) if outer < 0 for each in self._test(outer, True)]
        if handlers and statement is not None and {each.rank for each in made} == {THROUGH}:
            # In a handler a variable only says when it acts.
            return [each._replace(words=f"{each.words} if `{statement.condition}`") for each in handlers]
        before = self._before(q, side) or (self._otherwise(q, made) if side else [])
        if before and statement is not None:
            since = self._since_when(made, before)
            return [each._replace(words=f"{each.words} if `{statement.condition}`{since}") for each in before]
        if q < 0 or any(each.rank > COUNTED or "times" in each.words for each in made):
            return made
        # A time has the conditions before it as well, a quotation those of the blocks around it.
        is_looped = any(self._is_loop(outer) for outer, _ in self._guards[q])
        is_counted = all(each.rank == COUNTED for each in made)
        if is_counted:
            ways = [self._of(q)]
        elif self._depth > MAX_DEPTH:
            return made
        else:
            self._depth += 1
            ways = [self._within(outer, True) for outer in self._outside(q)]
            self._depth -= 1
        ways = [
            [
                each
                for each in way
                if each.rank >= DIRECT and not any(_opposite(each.words) in one.words for one in made)
            ]
            for way in ways
        ]
        # Of several ways each has to be known.
        around = [each for way in ways for each in way] if all(ways) else []
        if not around or (is_looped and not is_counted):
            return made
        outer = " or ".join(each.text for each in around[:MAX_REASONS])
        # What leaves a loop is one of the ways behind it.
        rank = COUNTED if is_looped else DIRECT
        return [each._replace(words=f"{outer} and {each.words}", rank=rank) for each in made]

    def _since_when(self, made: Sequence[Reason], before: Sequence[Reason]) -> str:
        """Return the one reason why a flag is set in brackets, unless it is about what comes later."""
        later = {each.words.rpartition(" ")[0] for each in before}
        is_one = len(made) == 1 and made[0].rank > QUOTED and not any(one in made[0].words for one in later)
        return f" ({made[0].text})" if is_one else ""

    def _before(self, q: int, side: bool) -> list[Reason]:
        """Return the channels of the branches around one that tests a variable which these have not set."""
        name, number = self._tested(((q, side),))
        around = [outer for outer in self._outside(q) if outer >= 0 and not self._is_loop(outer)]
        sites = [p for p, value in self._sites.get(name, [])[:MAX_SITES] if value == number]
        is_flag = {value for _, value in self._sites.get(name, [])} <= {"0", "1"}
        if not sites or not is_flag or any(self._is_inside(p, outer) for p in sites for outer in around):
            return []
        return [each for outer in around for each in self._test(outer, True) if each.rank == DIRECT]

    def _otherwise(self, q: int, made: Sequence[Reason]) -> list[Reason]:
        """Return the channels of the branches around a test of a variable that was set when these were otherwise."""
        if not made or not self._tested(((q, True),))[0]:
            return []
        found = list[Reason]()
        for outer, side in self._blocks(q):
            statement = self._statement(outer)
            if statement is not None and statement.channels and not self._is_loop(outer):
                found += self._test(outer, side)
        return [
            each
            for each in found
            if each.rank == DIRECT and all(_opposite(each.words) in one.words for one in made)
        ]

    def _is_inside(self, p: int, outer: int) -> bool:
        """True if a branch guards a point, or what guards it."""
        seen, stack = set[int](), [p]
        while stack:
            guards = {q for q, _ in self._guards.get(stack.pop(), ())} - seen
            seen |= guards
            stack += guards
        return outer in seen

    def _outside(self, q: int) -> list[int]:
        """Return the branches, or the handler, whose block has a branch, not those that come before it."""
        for _ in range(MAX_DEPTH):
            guards = self._guards.get(q, ())
            if len(guards) != 1 or guards[0][1]:
                break
            q = guards[0][0]
        guards = self._guards.get(q, ())
        # Of several ways each has to be inside of something.
        return [outer for outer, _ in guards] if all(side for _, side in guards) else []

    def _is_known(self, q: int, side: bool) -> bool:
        """True if a branch tests a step that a branch around it has tested, as If step = 2 in Case 2."""
        tested, guards = self._tested(((q, side),)), self._guards.get(q, ())
        while tested[0] and len(guards) == 1 and guards[0][0] >= 0:
            if self._tested(guards) == tested:
                return True
            guards = self._guards[guards[0][0]]
        return False

    def _test(self, q: int, side: bool) -> list[Reason]:
        """Return the reasons, each by itself enough, why a branch goes to one side or a handler is called."""
        statement, unit = self._statement(q), self._roots.get(q)
        if unit is not None and unit.kind == "event":
            by = [self._names[f"{each.channel} {each.number}".strip()] for each in unit.triggers]
            words = f"{' or '.join(by) or 'a fault'} ({unit.title})"
            return [Reason(unit.title if unit.is_timed and not by else words, unit.line, DIRECT)]
        if statement is None or not statement.condition:
            return []
        if statement.condition.startswith("channel "):
            is_on = statement.condition.endswith("on") == side
            return [
                Reason(
                    self._channel(statement.channels[0], "<>" if is_on else "=", "0"), statement.line, DIRECT
                )
            ]
        compared = _COMPARED.fullmatch(statement.condition)
        if compared is not None:
            sign = compared[2] if side else _COMPARISONS[compared[2]][1]
            return self._compared(compared[1], sign, compared[3], q, statement)
        form = _condition(statement)
        made = self._tree(form, side, q, statement) if len(form) < MAX_LENGTH else []
        if {each.rank for each in made} == {DIRECT} and len(statement.channels) == 1:
            return [
                each._replace(words=each.words + self._time_before(q, statement, each.words)) for each in made
            ]
        if len(made) == 1 and made[0].rank == COUNTED:
            return [made[0]._replace(words=made[0].words + self._lacking_before(q, made[0].words))]
        return made or [_quoted(statement, side)]

    def _compared(self, subject: str, sign: str, right: str, q: int, statement: Statement) -> list[Reason]:
        """Return why a channel or a register of MCCL compares so; a count in a loop that waits is a time."""
        stored = self._sites.get(subject, [])[:MAX_SITES]
        sources = {value for _, value in stored}
        if len(sources) == 1 and _COMPARED.fullmatch(f"{min(sources)} = 0"):
            subject = min(sources)
        raw = f"{self._names[subject]} {_COMPARISONS[sign][0]} {right}"
        if not subject.startswith("register"):
            return [Reason(raw, statement.line, DIRECT)]
        line = statement.line
        up, down = f"{subject} + 1", f"{subject} - 1"
        counts = [(p, value) for p, value in stored if value in (up, down) and self._repeats(q, p)]
        waits = self._waited[line] if counts and sign[0] == (">" if counts[0][1] == up else "<") else []
        if len(waits) == 1 and _is_number(right):
            numbers = [(p, value) for p, value in stored if _is_number(value)]
            begin = self._begin(*counts[0], numbers) if counts[0][1] == down else 0.0
            return [Reason(f"{abs(float(right) - begin) * float(waits[0]):g} s in line {line}", 0, COUNTED)]
        return list(self._assigned(subject, sign, right, q, statement)) or [
            Reason(raw, statement.line, COUNTED)
        ]

    def _lacking_before(self, q: int, words: str) -> str:
        """Return what would have ended the wait before a test of its time, "" if there is none."""
        p = self._waits.get(q, q)
        wait = self._statement(p)
        if p == q or wait is None or not wait.waits:
            return ""
        made = self._tree(_condition(wait), True, p, wait)
        others = [each.words for each in made if each.rank == DIRECT]
        is_timed = any(each.words == words for each in made)
        return f" without {' or '.join(others)}" if others and is_timed else ""

    def _time_before(self, q: int, statement: Statement, words: str) -> str:
        """Return the time in the wait before a test of the same channels, "" if there is none."""
        p = self._waits.get(q, q)
        wait = self._statement(p)
        if wait is None or not {each.number for each in statement.channels} & {
            each.number for each in wait.channels
        }:
            return ""
        made = self._tree(_condition(wait), bool(wait.waits), p, wait) if p != q else []
        times = [each.words for each in made if _TIME.match(each.words)]
        # What the wait has waited for comes before its time is over.
        return f" {times[0]}" if times and all(each.words != words for each in made) else ""

    def _tree(self, form: str, side: bool, q: int, statement: Statement) -> list[Reason]:
        """Return the reasons by which an expression is true, or false, none if they are unknown."""
        if form.startswith("Unary Not "):
            return self._tree(form[10:], not side, q, statement)
        left, sign, right = _binary(form)
        if sign in ("And", "Or"):
            parts = [self._tree(each, side, q, statement) for each in (left, right)]
            if (sign == "Or") == side:
                return [one for each in parts for one in each or [_quoted(statement, side)]]
            for step, others in ((_compared_with(left), parts[1]), (_compared_with(right), parts[0])):
                if side and others and self._is_step(step):
                    return self._in_step(step, others, q)
            best = max((one.rank for each in parts for one in each), default=QUOTED)
            kept = [each for each in parts if {one.rank for one in each} in ({COUNTED}, {best})]
            # What was otherwise when a variable was set is over.
            now = [_opposite(one.words) for each in kept for one in each]
            kept = [
                each for each in kept if not all(any(one in its.words for one in now) for its in each)
            ] or kept
            words = " and ".join(dict.fromkeys(" or ".join(one.words for one in each) for each in kept))
            return [Reason(words, max(one.line for one in kept[0]), best)] if kept else []
        if sign in ("=", "<>") and right == "0" and _binary(left)[1] in ("And", "Or"):
            return self._tree(left, (sign == "<>") == side, q, statement)
        if sign == "<>" and "~" in form:
            return []
        left, sign, right = (self._constant(left), sign, self._constant(right)) if sign else (form, "<>", "0")
        if _is_number(left):
            left, sign, right = right, _COMPARISONS[sign][2], left
        sign = sign if side else _COMPARISONS[sign][1]
        clock = _CLOCK.fullmatch(left)
        uses = self._uses(left, statement) if clock is None or clock[2] else []
        if uses:
            return [Reason(self._channel(use, sign, right), statement.line, DIRECT) for use in uses]
        if clock is not None and (clock[2] is None or clock[2] in self._clocks) and _is_number(right):
            kind = "" if sign[0] == ">" else "within "
            return [
                Reason(
                    f"{kind}{float(right) / 1000:g} s after {self._since(clock[1] or clock[2] or 'TIME', q)}",
                    0,
                    COUNTED,
                )
            ]
        called = CALL.fullmatch(left)
        if called is not None:
            return self._result(called, sign, right, q, statement)
        is_name = left.startswith("~") and (side or sign != "=")
        return list(dict.fromkeys(self._assigned(left[1:], sign, right, q, statement))) if is_name else []

    def _is_step(self, tested: tuple[str, str]) -> bool:
        """True if a comparison is that of a variable with one of several numbers that it gets."""
        return (
            len({value for _, value in self._sites.get(tested[0], [])[:MAX_SITES] if _is_number(value)}) > 2
        )

    def _in_step(self, step: tuple[str, str], made: list[Reason], q: int) -> list[Reason]:
        """Return the reasons of a branch in a step: what has led to the step is none, what would have led on is."""
        if any(each.rank != COUNTED for each in made):
            return made
        found: dict[str, None] = {}
        for p, _ in self._sites[step[0]][:MAX_SITES]:
            outer = self._guards[p][0][0] if len(self._guards[p]) == 1 else -1
            if outer >= 0 and outer != q and self._tested(self._guards[outer]) == step:
                found |= dict.fromkeys(each.words for each in self._of(p) if each.rank == DIRECT)
        without = f" without {' or '.join(found)}" if found else ""
        return [each._replace(words=each.words + without) for each in made]

    def _assigned(self, name: str, sign: str, right: str, q: int, statement: Statement) -> Iterator[Reason]:
        """Yield why a variable compares so: why it is assigned, what is counted, or what is read."""
        sites = self._assignments(name, q)
        one = (f"(1 + ~{name})", f"(~{name} - 1)", f"{name} + 1", f"{name} - 1")
        counts = [each for each in sites if each[1] in one]
        if any(f"~{name}" in value for _, value in sites if (_, value) not in counts):
            return
        for p, value in sites:
            scaled = _SCALED.fullmatch(value)
            factor, reading = (float(scaled[1]), scaled[2]) if scaled is not None else (1.0, value)
            uses = self._uses(reading, self._structure.statements[self._structure.points[p].at])
            if uses and factor > 0.0 and (_is_number(right) or scaled is None):
                limit = right if scaled is None else f"{float(right) / factor:.6g}"
                yield from (Reason(self._channel(use, sign, limit), statement.line, DIRECT) for use in uses)
                return
        calls = [(p, called) for p, value in sites if (called := CALL.fullmatch(value)) is not None]
        before = [called for p, called in calls if p < q and self._unit_of(p) == self._unit_of(q)]
        for called in before or [called for _, called in calls]:
            yield from self._result(called, sign, right, q, statement)
        numbers = [(p, value) for p, value in sites if _is_number(value)]
        if _is_number(right):
            yield from self._set(name, numbers, sign, right, q, statement)
        nearest = [each for each in counts if each[0] < q][-1:] or counts[:1]
        if nearest and sign[0] in ("<=" if "-" in nearest[0][1] else ">="):
            yield from self._counted(nearest[0], numbers, sign, right)

    def _result(
        self, called: re.Match[str], sign: str, right: str, q: int, statement: Statement
    ) -> list[Reason]:
        """Return why a function with the values of a call returns what compares so, with the time of its loops."""
        if self._within_calls == MAX_CALLS:
            return []
        self._within_calls += 1
        name, values = called.groups()
        known, given = self._known, self._given
        bound = zip(self._parameters_of.get(name, ()), values.split(", "), strict=False)
        self._known, self._given = {}, {**given, **{parameter: [value] for parameter, value in bound}}
        sites = self._assignments(name)
        numbers = [(p, value) for p, value in sites if _is_number(value)]
        # What a function returns was set before, wherever it is called.
        behind = len(self._structure.points)
        made = list(self._set(name, numbers, sign, right, behind, statement)) if _is_number(right) else []
        if len(sites) == 1 and not numbers and right == "0" and sign in ("=", "<>"):
            # A function that returns a comparison.
            (p, form), own = sites[0], self._structure.statements
            at = own[self._structure.points[p].at]
            made = [each._replace(line=statement.line) for each in self._tree(form, sign == "<>", p, at)]
        times = {
            each.words
            for p in self._within_unit(name)
            if (wait := self._statement(p)) is not None and (self._is_loop(p) or self.waits(wait.at))
            for each in self._tree(_condition(wait), bool(wait.waits), p, wait)
            if _TIME.match(each.words)
        }
        self._known, self._given = known, given
        self._within_calls -= 1
        if len(times) == 1 and len(made) == 1:
            words, time = made[0].words, min(times)
            if words.startswith("without "):
                return [made[0]._replace(words=f"{time} {words}")]
            if sign == "=":
                return [made[0]._replace(words=f"{words} {time}")]
        return made

    def _within_unit(self, name: str) -> Iterator[int]:
        """Yield the points of a unit, without those of what it calls."""
        seen, stack = set[int](), [self._entry_of.get(name, -1)]
        while stack and len(seen) < MAX_LENGTH:
            p = stack.pop()
            if p >= 0 and p not in seen:
                seen.add(p)
                stack += self._structure.points[p].next
                yield p

    def _set(
        self,
        name: str,
        numbers: Sequence[tuple[int, str]],
        sign: str,
        right: str,
        q: int,
        statement: Statement,
    ) -> Iterator[Reason]:
        """Yield why a variable is set to a number that compares so, or what would have set it to another one."""
        is_flag = sum(float(value) != 0.0 for _, value in numbers) == 1
        holding = [(p, _holds(value, sign, right)) for p, value in numbers]
        # What holds at 0, as at the start, has a reason only behind what has made it not hold.
        is_start = bool(holding) and name not in self._parameters and _holds(0.0, sign, right)
        others = [p for p, holds in holding if not holds]
        ends = {each.words for p in others if p != q for each in self._of(p) if each.rank == DIRECT}
        later = {
            p for p, holds in holding if holds and (p > min(others, default=p) or self._is_else(p, others))
        }
        if is_start and len(ends) == 1 and not later:
            yield Reason(f"without {min(ends)}", statement.line)
        for p, holds in holding:
            is_later = p in later and (p < q or self._is_else(p, others))
            if holds and (is_later or not is_start):
                yield from (
                    each if is_flag else each._replace(rank=min(each.rank, THROUGH)) for each in self._of(p)
                )

    def _is_else(self, p: int, others: Sequence[int]) -> bool:
        """True if a point is on the other side of the branch of one of some."""
        guards = self._guards[p]
        opposite = tuple((q, not side) for q, side in guards)
        return len(guards) == 1 and any(self._guards[each] == opposite for each in others)

    def _counted(
        self, count: tuple[int, str], numbers: Sequence[tuple[int, str]], sign: str, right: str
    ) -> Iterator[Reason]:
        """Yield how often a variable is counted until it compares so, and why each time."""
        p, value = count
        begin = self._begin(p, value, numbers)
        times = f"{abs(float(right) - begin) + (sign in '<>'):g}" if _is_number(right) else right.strip("~")
        by = self._of(p)
        # A quotation may have been true before the count, and what a variable is not has other reasons as well.
        is_else = any(not side and self._tested(((q, True),))[0] for q, side in self._guards[p])
        is_known = len(by) == 1 and "`" not in by[0].text and not is_else
        why = by[0].text if is_known else f"line {self._line(p)}"
        if times != "0":
            yield Reason(f"{times} times {f'({why})' if why[0].isdigit() else why}", 0, COUNTED)

    def _begin(self, p: int, value: str, numbers: Sequence[tuple[int, str]]) -> float:
        """Return the number from which a variable is counted: that in the line of the only calls, or of the text."""
        k = bisect_right(self._entries, p)
        entry = self._entries[k - 1] if k else -1
        before = [
            [number for q, number in numbers if q < call and self._line(q) == self._line(call)]
            for call in self._calls[entry]
        ]
        given = {some[-1] for some in before if some}
        if len(given) == 1 and all(before):
            return float(min(given))
        return float(numbers[-1 if "-" in value else 0][1]) if numbers else 0.0

    def _assignments(self, name: str, q: int = -1) -> list[tuple[int, str]]:
        """Return where which value is assigned to a name, as a point knows it; for a parameter, where it is given.

        Each number of a variable that is assigned is one.
        """
        scope = ""
        if q >= 0 and name in self._parameters:
            unit = self._unit_of(q)
            scope = f" of {unit if name in self._parameters_of.get(unit, ()) else ''}"
        found = list[tuple[int, str]]()
        for p, value in self._sites.get(f"{name}{scope}", [])[:MAX_SITES]:
            if value[1:] in self._parameters:
                found += self._sites.get(value[1:], [])[:MAX_SITES]
            else:
                found += [(p, each) for each in self._given.get(value[1:], [value])]
        return found

    def _unit_of(self, p: int) -> str:
        """Return the name of the unit of a point, in small letters."""
        k = bisect_right(self._entries, p)
        return self._names_of[self._entries[k - 1]] if k else ""

    def _constant(self, form: str) -> str:
        """Return the only number that is assigned to a name, or given to it, or the form itself."""
        if form[1:] in self._parameters and len(self._given.get(form[1:], ())) == 1:
            return self._given[form[1:]][0]
        sites = self._sites.get(form[1:], []) if form.startswith("~") and form[1:] not in self._clocks else []
        return sites[0][1] if len(sites) == 1 and _is_number(sites[0][1]) else form

    def _since(self, name: str, q: int) -> str:
        """Return the lines from which a clock counts: in the block of a branch, before the step around it, or all."""
        sites = [p for p, _ in self._sites.get(name, [])[:MAX_SITES]]
        found, p = list[int](), q
        while not found and p >= 0:
            step, value = self._tested(self._guards[p])
            steps = [
                self._guards[other]
                for other, given in self._sites.get(step, [])[:MAX_SITES]
                if given == value
            ]
            found = [each for each in sites if self._guards[each] == self._guards[p] and each < p][-1:]
            found = found or [each for each in sites if self._guards[each] in steps]
            p = self._guards[p][0][0] if len(self._guards[p]) == 1 and not step else -1
        lines = {self._line(each) for each in found or sites}
        return f"line{'s' * (len(lines) > 1)} {ranges(lines)}" if lines else "power-up"

    def _tested(self, guards: Sequence[Guard]) -> tuple[str, str]:
        """Return the name and the number that a single guard tests, such as a step, "" for anything else."""
        statement = self._statement(guards[0][0]) if len(guards) == 1 and guards[0][1] else None
        return _compared_with(_condition(statement)) if statement is not None else ("", "")

    # -------------------------------------------------------------------------------------------------- channels

    def _uses(self, form: str, statement: Statement) -> list[ChannelUse]:
        """Return the reading of a channel in a form, or of each one that its number, a parameter, may be."""
        reading = _READING.fullmatch(form)
        if reading is None:
            return []
        reads = [each for each in statement.channels if each.access == READ]
        number = "?" if (reading[2] or "").startswith("~") else reading[2]
        uses = [each for each in reads if number is None or each.number == number]
        text = self._structure.source.text
        named = (
            each for each in uses if text[each.name_at : each.name_at + len(reading[1])].upper() == reading[1]
        )
        use = next(named, None) or next(iter(uses), None)
        known = with_number(use, self._given) if use is not None else []
        return [each for each in known if each.number != "?"]

    def _channel(self, use: ChannelUse, sign: str, right: str) -> str:
        """Return a comparison of a channel in words."""
        number = float(right) if _is_number(right) else -1.0
        subject, shown = f"{use.channel} {use.number}".strip(), right.replace("~", "")
        if use.channel in ("input", "digital"):
            subject = next(
                (each for each in (subject, f"output {use.number}") if each in self._names), subject
            )
            is_on = (sign == "<>") == (number == 0) or sign[0] == ">"
            is_low = use.number.isdecimal() and int(use.number) in self._low
            return f"{self._names[subject]} {'on' if is_on != is_low else 'off'}"
        if use.channel == "key":
            shown = repr(chr(int(number))) if 32 < number < 127 else shown
            return f"key {shown}" if sign == "=" else f"key {_COMPARISONS[sign][0]} {shown}"
        return f"{self._names[subject]} {_COMPARISONS[sign][0]} {shown}"


def _condition(statement: Statement) -> str:
    """Return the condition of a statement as a form, "" if it has none."""
    head, _, form = statement.form.partition(" ")
    cases = _CASE.findall(form)
    if cases and len(cases) == form.count("CaseTest"):
        name = statement.condition.split(" is ")[0].lower()
        return reduce(
            lambda tests, test: f"({tests} Or {test})", (f"(~{name} {' '.join(each)})" for each in cases)
        )
    form = form if head == "Pause" else form[1:-1] if head in ("If", "While", "Until") else ""
    return f"Unary Not {form}" if head == "Until" else form


def _compared_with(form: str) -> tuple[str, str]:
    """Return the name and the number that a form compares for equality, "" for anything else."""
    left, sign, right = _binary(form)
    left, right = (right, left) if _is_number(left) else (left, right)
    return (left[1:], right) if sign == "=" and left.startswith("~") else ("", "")


def _opposite(words: str) -> str:
    """Return the words of an input at its other level."""
    head, _, level = words.rpartition(" ")
    return f"{head} {'off' if level == 'on' else 'on'}"


def _quoted(statement: Statement, side: bool) -> Reason:
    text = statement.condition
    if not side:  # the condition of an Until has been turned around already
        is_until = statement.form.startswith("Until ") and text.startswith("not (")
        text = text[5:-1] if is_until else f"not ({text})" if " " in text else f"not {text}"
    return Reason(f"`{text}`", statement.line)


def _holds(left: str | float, sign: str, right: str) -> bool:
    return bool(_COMPARISONS[sign][3](float(left), float(right)))


def _is_number(form: str) -> bool:
    return _NUMBER.fullmatch(form) is not None


def _binary(form: str) -> tuple[str, str, str]:
    """Return the two sides of a form in brackets and the operator between them, "" if it is none."""
    depth = 0
    for token in _TOKEN.finditer(form if form[:1] == "(" else ""):
        depth += (token[0] == "(") - (token[0] == ")")
        if depth == 1 and token[0] in ("And", "Or", *_COMPARISONS):
            return form[1 : token.start() - 1], token[0], form[token.end() + 1 : -1]
    return "", "", ""
