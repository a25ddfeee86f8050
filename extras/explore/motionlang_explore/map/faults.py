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
from motionlang_explore.map.plays import VALUES, Play, Plays, Settings
from motionlang_explore.map.stops import Stops

# A pause is no shorter, s; a longer one than usual is so by a share and a time, s. A move or a given time is none, if
# it leaves out no larger share at each end.
PAUSE, SHARE, MORE, NAP = 0.05, 1.05, 0.02, 0.1
# What begins so soon behind a given time is in a row with it, s.
NEXT = 0.01
SAID, SWITCHED, WRITTEN = "said", "switched", "written"
_FIGURES, _MEASURED = re.compile(r"\d[\d.]*"), re.compile(r"\d+\.\d+")


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
    one behind another move. `together` are all signs that have come in its play.
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
    run = exploration.world.run
    usual, pauses = {_kind(each) for _, each in _signs(run)}, _doings(exploration, run).longest
    statements = exploration.program.structure.statements
    asking = {at for at, each in statements.items() if any(use.channel == "answer" for use in each.channels)}
    owners, tasks = exploration.program.structure.owners(), defaultdict[str, set[int]](set)
    for line, task in owners.items():
        tasks[task].add(line)

    def lines_of(sign: Sign) -> Collection[int]:
        return tasks[owners.get(exploration.line(sign.at), "")]

    came, seen = list[list[_Came]](), set[int]()
    for play, played in plays.all():
        stops.take(play, played)
        all_signs = _signs(played)
        seen |= {each.at for _, each in all_signs}
        signs = [each for each in all_signs if _kind(each[1]) not in usual and each[1].at not in asking]
        wrong = next((at for at, each in signs if is_trouble(each)), inf)
        signs = [each for each in signs if each[0] < wrong + PAUSE or is_trouble(each[1])]
        doings = _doings(exploration, played)
        begun = sorted(each.start_time for each in played.machine.log.moves)
        came.append(
            [
                _Came(
                    play,
                    at,
                    bisect_left(begun, at),
                    sign,
                    doings.pause(at, play.since, pauses, lines_of(sign)),
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
        for sign, each in zip(told, play, strict=True):
            if not count[sign]:
                is_followed = play[-1].time > each.time + PAUSE and told[-1] != sign
                goes_on = nobody_resets and (is_followed or last[sign].moves > each.moves)
                change, settings, since, _ = each.play
                fault = Fault(
                    change, settings, since, each.time, *each.pause, *often, goes_on, frozenset(told)
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
    found = {form for play in plays for form, signs in _by_form(play).items() if len(signs) > 1}
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


def _by_form(came: Sequence[_Came]) -> Mapping[Sign, set[Sign]]:
    """Return what came by its form."""
    found = defaultdict[Sign, set[Sign]](set)
    for each in came:
        found[form_of(each.sign)].add(each.sign)
    return found


class _Doings(NamedTuple):
    """What a run does, in order: `longest` is its longest pause behind what each line does, s.

    `pauses` are those that are neither a move nor of a given time, and in which nobody pushes a button: their ends and
    begins, s, and the lines of what was done last.
    """

    longest: Mapping[int, float]
    pauses: Sequence[tuple[float, float, Sequence[int]]]

    def pause(
        self, time: float, since: float, usual: Mapping[int, float], own: Collection[int]
    ) -> tuple[float, int]:
        """Return how long the machine has paused before a time, s, and behind what line; 0.0 if not longer than usual.

        A pause in which the change comes is none. Of several lines it is one of `own`, those of the same task.
        """
        before = bisect_right(self.pauses, (time, inf))
        for end, begin, lines in self.pauses[:before][-1:]:
            line = next((each for each in reversed(lines) if each in own), lines[-1])
            if begin >= since and end - begin > SHARE * usual.get(line, 0.0) + MORE:
                return end - begin, line
        return 0.0, 0


def _doings(exploration: Exploration, run: Run) -> _Doings:
    """Return the pauses between what a run does, and its waits but for a time end."""
    log, line = run.machine.log, exploration.line
    found = [(0.0, 0), *((each.start_time, each.line) for each in log.moves)]
    found += [(each.until, line(each.at)) for each in log.waits if each.at >= 0 and each.cause != "time"]
    for stream in (log.outputs, log.writes, log.prints):
        found += [(each.time, line(each.at)) for each in stream if each.at >= 0]
    events = sorted(each for each in found if each[0] <= run.time)
    moves = ((each.start_time, each.profile, each.line) for each in log.moves)
    naps = [(time, time + profile.duration, -at) for time, profile, at in moves if profile is not None]
    naps += [(*each[2:4], each.at) for each in log.waits if each.cause == "time"]
    begins, ends = _in_a_row(naps)
    given = entries(exploration.world.settings, "input")
    asked = {number_in("input", each) for each in given if "asked" in each}
    # A button that is let go leads on to nothing.
    led = [each.time for each in log.inputs if each.value and each.channel in asked]
    longest, pauses = defaultdict[int, float](float), list[tuple[float, float, Sequence[int]]]()
    last = list[int]()
    for (begin, at), (end, _) in pairwise(events):
        longest[at] = max(longest[at], end - begin)
        last.append(at)
        if end - begin < NEXT:
            continue
        share = NAP * (end - begin)
        begun = bisect_right(begins, begin + share)
        is_given = begun and ends[begun - 1] >= end - share
        is_led = bisect_left(led, end) > bisect_right(led, begin)
        if end - begin >= PAUSE and not (is_given or is_led):
            pauses.append((end, begin, last))
        last = []
    return _Doings(longest, pauses)


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
