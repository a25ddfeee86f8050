"""What goes wrong in the good cycle when one thing in its world is otherwise.

What the machine prints, switches on or writes for its host in a play (`plays.py`), and does not in its world, is a sign
of that fault. A time is told if the machine has paused for longer than it does there.
"""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections import Counter, defaultdict
from collections.abc import Callable, Collection, Mapping, Sequence, Set
from itertools import pairwise
from math import inf
from typing import NamedTuple

from motionlang.comparison.texts import plain
from motionlang.kernel import Run
from motionlang_explore.exploration import (
    Change,
    Channel,
    Exploration,
    entries,
    number_in,
)
from motionlang_explore.map.plays import VALUES, Play, Plays, Settings, Watched, switched
from motionlang_explore.map.stops import Stops

# A pause is no shorter, s; a longer one than usual is so by a share and a time, s. A move or a given time is none, if
# it leaves out no larger share at each end.
PAUSE, SHARE, MORE, NAP = 0.05, 1.05, 0.02, 0.1
# A lamp that comes so soon before or behind a text comes with it, s.
TOGETHER = 1.0
# What begins so soon behind a given time is in a row with it, s.
NEXT = 0.01
SAID, SWITCHED, WRITTEN = "said", "switched", "written"
_FIGURES, _MEASURED, _WHOLE = re.compile(r"\d[\d.]*"), re.compile(r"\d+\.\d+"), re.compile(r"\d+")


class Sign(NamedTuple):
    """What a machine says, switches on or writes: its kind, its statement, and its text or its channel.

    Of a text with a number that counts it is the form, with "..." for each number, as for what was measured.
    """

    kind: str
    at: int
    what: str


class Begin(NamedTuple):
    """What something comes by: settings, when they change, and when it comes, s; nothing changes by itself."""

    settings: Settings
    time: float
    came: float
    change: Change | None = None


class Fault(NamedTuple):
    """A change of the world with which a sign comes: the settings with it, when it is made, and when the sign comes, s.

    `seconds` is how long the machine has paused before, behind what `line` does, 0.0 if not longer than usual. `behind`
    is another sign that has come before, so many `times`. The machine `goes_on` if others have come later, or the same
    one behind another move. `together` are the signs that come so soon before or behind it.
    """

    change: Change
    settings: Settings
    time: float
    came: float
    seconds: float
    line: int
    behind: Sign | None
    times: int
    goes_on: bool
    together: frozenset[Sign]

    @property
    def begin(self) -> Begin:
        """What the sign comes by."""
        return Begin(self.settings, self.time, self.came, self.change)


class Faults(NamedTuple):
    """The faults with which each sign comes.

    `rare` is what comes in the world itself, but in no usual cycle, with the cycles before it comes first, and `seen`
    are the statements of all else that has come in the world, or in a play.
    """

    of: Mapping[Sign, Sequence[Fault]]
    rare: Mapping[Sign, tuple[int, Begin]]
    seen: frozenset[int]


class _Came(NamedTuple):
    """A sign that came in a play at a time, s, behind so many moves.

    The `pause` before is how long it was, s, and the line behind which it came.
    """

    play: Play
    time: float
    moves: int
    sign: Sign
    pause: tuple[float, int]


def faults_of(
    exploration: Exploration, plays: Plays, is_trouble: Callable[[Sign], bool], stops: Stops
) -> Faults:
    """Return what goes wrong in the world of an exploration by one change, and take note of what stops it.

    What is no trouble, and comes behind what is, follows from it.
    """
    watched = plays.usual()
    run, pauses = watched.run, _Doings(exploration, watched)
    usual = {_kind(each) for _, each in (*_signs(run), *_signs(exploration.world.run))}
    statements = exploration.program.structure.statements
    asking = {at for at, each in statements.items() if any(use.channel == "answer" for use in each.channels)}
    came, seen = list[list[_Came]](), set[int]()
    for play, watched in plays.all():
        played = watched.run
        stops.take(play, played)
        all_signs = _signs(played)
        seen |= {each.at for _, each in all_signs}
        signs = [each for each in all_signs if _kind(each[1]) not in usual and each[1].at not in asking]
        wrong = next((at for at, each in signs if is_trouble(each)), inf)
        signs = [each for each in signs if each[0] < wrong + PAUSE or is_trouble(each[1])]
        doings = _Doings(exploration, watched)
        begun = sorted(each.start_time for each in played.machine.log.moves)
        came.append(
            [
                _Came(
                    play,
                    at,
                    bisect_left(begun, at),
                    sign,
                    doings.pause(at, play.since, exploration.line(sign.at), pauses),
                )
                for at, sign in signs
            ]
        )
    later = {play.change: {sign for _, sign in _signs(played)} for play, played in plays.later(_unsure(came))}
    known = {
        sign: list(faults.values())
        for sign, faults in _by_sign(came, later, plays.nobody_resets).items()
        if "= ..." not in sign.what
    }
    rare = _rare(run, plays.settings)
    seen |= {each.at for _, each in _signs(run)}
    seen -= {each.at for each, (count, _) in rare.items() if not count}
    return Faults(known, rare, frozenset(seen))


def _by_sign(
    plays: Sequence[Sequence[_Came]], later: Mapping[Change, Set[Sign]], nobody_resets: bool
) -> Mapping[Sign, dict[Change, Fault]]:
    """Return the fault of each change with which a sign comes, in the first play with it.

    What comes `later` has come with a change that was made one cycle later. That a machine goes on is known if
    `nobody_resets` it.
    """
    counting, found = _counting(plays, later), defaultdict[Sign, dict[Change, Fault]](dict)
    for play in plays:
        count = Counter[Sign]()
        often: tuple[Sign | None, int] = None, 0
        told = [form_of(each.sign) if form_of(each.sign) in counting else each.sign for each in play]
        last = dict(zip(told, play, strict=True))
        # A lamp may blink.
        others = [(each.time, sign) for sign, each in zip(told, play, strict=True) if sign.kind != SWITCHED]
        for sign, each in zip(told, play, strict=True):
            if not count[sign]:
                is_followed = any(at > each.time + TOGETHER and other != sign for at, other in others[-1:])
                goes_on = nobody_resets and (is_followed or last[sign].moves > each.moves)
                near = (
                    other
                    for other, one in zip(told, play, strict=True)
                    if abs(one.time - each.time) < TOGETHER
                )
                change, settings, since, _ = each.play
                fault = Fault(
                    change, settings, since, each.time, *each.pause, *often, goes_on, frozenset(near)
                )
                found[sign].setdefault(change, fault)
            count[sign] += 1
            often = (sign, count[sign]) if count[sign] > 1 else often
    return found


def _rare(run: Run, settings: Settings) -> dict[Sign, tuple[int, Begin]]:
    """Return what a run says, switches on or writes, but in no usual cycle, and the cycles before it comes first."""
    begin, end = (0.0, run.time) if run.cycle is None else run.cycle.span
    times, found = () if run.cycle is None else run.cycle.times, dict[Sign, tuple[int, Begin]]()
    usual = set[int]()
    for time, each in _signs(run):
        found.setdefault(
            form_of(each), (bisect_right(times, time), Begin(settings, max(time - PAUSE, 0.0), time))
        )
        usual |= {each.at} if begin <= time < end else set()
    return {sign: count for sign, count in found.items() if sign.at not in usual}


def _signs(run: Run) -> list[tuple[float, Sign]]:
    """Return what a run says, switches on and writes but for 0, with the times, in order."""
    log = run.machine.log
    found = [(each.time, Sign(SAID, each.at, _text(each.text))) for each in log.prints]
    found += [
        (each.time, Sign(SWITCHED, each.at, f"output {each.channel}")) for each in log.outputs if each.value
    ]
    found += [
        (each.time, Sign(WRITTEN, each.at, f"{each.target} = {each.value:g}"))
        for each in log.writes
        if each.value
    ]
    return sorted((each for each in found if each[1].at >= 0 and each[1].what), key=lambda each: each[0])


def _text(printed: str) -> str:
    return _MEASURED.sub("...", " ".join(plain(printed).split()))


def form_of(sign: Sign) -> Sign:
    """Return a sign without the numbers of its text, or the number that is written."""
    if sign.kind == SWITCHED:
        return sign
    head, equal, text = sign.what.partition(" = ") if sign.kind == WRITTEN else ("", "", sign.what)
    return sign._replace(what=head + equal + _FIGURES.sub("...", text))


def _kind(sign: Sign) -> Sign:
    """Return the form of a sign; an output is the same wherever it is switched on."""
    return sign._replace(at=-1) if sign.kind == SWITCHED else form_of(sign)


def _counting(plays: Sequence[Sequence[_Came]], later: Mapping[Change, Set[Sign]]) -> set[Sign]:
    """Return the forms of what has numbers that count, or measure: they differ in a play, or a cycle later.

    What has the number that was given, with two of them, repeats it.
    """
    found = {form for play in plays for form, signs in _by_form(play).items() if _ascends(signs)}
    found |= {form_of(each.sign) for play in plays for each in play if "..." in each.sign.what}
    given = defaultdict[tuple[Sign, Channel], set[str]](set)
    for each in (each for play in plays for each in play if each.play.change.table in VALUES):
        change = each.play.change
        value = change.value if isinstance(change.value, str) else f"{change.value:g}"
        if value in _FIGURES.findall(each.sign.what):
            given[form_of(each.sign), change.channel].add(value)
    found |= {form for (form, _), values in given.items() if len(values) > 1}
    unsure = _unsure(plays)
    for each in (each for play in plays for each in play if each.play.since and each.play.change in later):
        change, form = each.play.change, form_of(each.sign)
        others = later[change] if form in unsure[change] else ()
        if form in map(form_of, others) and each.sign not in others:
            found.add(form_of(each.sign))
    return found


def _unsure(plays: Sequence[Sequence[_Came]]) -> Mapping[Change, set[Sign]]:
    """Return the forms of what comes with its numbers in one play of a change alone: they may count."""
    by_change, found = defaultdict[Change, set[tuple[float, Sign]]](set), defaultdict[Change, set[Sign]](set)
    for each in (each for play in plays for each in play):
        by_change[each.play.change].add((each.play.since, each.sign))
    for change, came in by_change.items():
        for sign, count in Counter(sign for _, sign in came).items():
            if count == 1 and form_of(sign) != sign:
                found[change].add(form_of(sign))
    return found


def _by_form(came: Sequence[_Came]) -> Mapping[Sign, dict[Sign, None]]:
    """Return what came by its form, in order."""
    found = defaultdict[Sign, dict[Sign, None]](dict)
    for each in came:
        found[form_of(each.sign)][each.sign] = None
    return found


def _ascends(signs: Collection[Sign]) -> bool:
    """True if a number of several signs of one form is larger each time."""
    rows = zip(*([int(each) for each in _WHOLE.findall(sign.what)] for sign in signs), strict=False)
    return len(signs) > 1 and any(all(a < b for a, b in pairwise(row)) for row in rows)


class _Doings:
    """What a run does, in order, and the pauses between it, those of each task by themselves.

    A pause is neither a move nor of a given time, and nobody pushes a button in it.
    """

    def __init__(self, exploration: Exploration, watched: Watched) -> None:
        self._tasks, run, line = watched.tasks, watched.run, exploration.line
        log = run.machine.log
        found = [(0.0, 0), *((each.start_time, each.line) for each in log.moves)]
        # Waits but for a time end.
        found += [(each.until, line(each.at)) for each in log.waits if each.at >= 0 and each.cause != "time"]
        for stream in (switched(exploration, run), log.writes, log.prints):
            found += [(each.time, line(each.at)) for each in stream if each.at >= 0]
        self._events = sorted(each for each in found if each[0] <= run.time)
        moves = ((each.start_time, each.profile, each.line) for each in log.moves)
        naps = [
            (line, time, time + profile.duration, -line)
            for time, profile, line in moves
            if profile is not None
        ]
        naps += [(line(each.at), *each[2:4], each.at) for each in log.waits if each.cause == "time"]
        self._naps = naps
        given = entries(exploration.world.settings, "input")
        asked = {number_in("input", each) for each in given if "asked" in each}
        # A button that is let go leads on to nothing.
        self._led = [each.time for each in log.inputs if each.value and each.channel in asked]
        self._known = dict[str, tuple[Mapping[int, float], Sequence[tuple[float, float, int]]]]()

    def pause(self, time: float, since: float, line: int, usual: _Doings) -> tuple[float, int]:
        """Return how long the task of a line has paused before a time, s, and behind what line.

        It is 0.0 if that is no longer than usual. A pause in which the change comes is none.
        """
        task = self._task(line)
        pauses, longest = self._of(task)[1], usual._of(task)[0]
        for end, begin, last in pauses[: bisect_right(pauses, (time, inf))][-1:]:
            if begin >= since and end - begin > SHARE * longest.get(last, 0.0) + MORE:
                return end - begin, last
        return 0.0, 0

    def _task(self, line: int) -> str:
        """Return the task of a line, "" for all that the machine does if it is that of a handler or of several."""
        tasks = self._tasks.get(line, ())
        return next(iter(tasks)) if len(tasks) == 1 else ""

    def _of(self, task: str) -> tuple[Mapping[int, float], Sequence[tuple[float, float, int]]]:
        """Return the longest pause of a task behind each line, s, and its pauses: ends, begins, s, and lines."""
        if task not in self._known:
            self._known[task] = self._worked_out(task)
        return self._known[task]

    def _worked_out(self, task: str) -> tuple[Mapping[int, float], Sequence[tuple[float, float, int]]]:
        def is_own(line: int) -> bool:
            return not task or task in self._tasks.get(line, (task,))

        begins, ends = _in_a_row([each[1:] for each in self._naps if is_own(each[0])])
        longest, pauses = defaultdict[int, float](float), list[tuple[float, float, int]]()
        for (begin, line), (end, _) in pairwise(each for each in self._events if is_own(each[1])):
            longest[line] = max(longest[line], end - begin)
            if end - begin < NEXT:
                continue
            share = NAP * (end - begin)
            begun = bisect_right(begins, begin + share)
            is_given = begun and ends[begun - 1] >= end - share
            is_led = bisect_left(self._led, end) > bisect_right(self._led, begin)
            if end - begin >= PAUSE and not (is_given or is_led):
                pauses.append((end, begin, line))
        return longest, pauses


def _in_a_row(naps: Sequence[tuple[float, float, int]]) -> tuple[list[float], list[float]]:
    """Return the begins, and the latest ends so far, of moves and given times, s; those in a row are one.

    What comes again, such as the wait of a loop, begins another row.
    """
    begins, ends, seen = list[float](), list[float](), set[int]()
    for begin, end, at in sorted(naps):
        if at in seen or not ends or begin > ends[-1] + NEXT:
            begins.append(begin)
            ends.append(max([*ends[-1:], end]))
            seen = {at}
        else:
            ends[-1] = max(ends[-1], end)
            seen.add(at)
    return begins, ends
