"""Draft of a machine file: guessed inputs, answers, keys and switches.

The problem: a program from a machine waits for a world that no file describes. Nothing in it says when a part
arrives, but it says which inputs it waits for, in which order, and what it does before.

The idea: run the program, see where it is stuck, guess what would let it go on, and run it again, until it ends or
runs to the time limit. Each guess is one entry of the machine file, marked `guess = true`.

    stuck at            guess
    an input            it follows the output that the program has just set, or changes 0.3 s later and stays; if the
                        program also waits for the other level, it is on and off for a second each; the inputs of one
                        value of a bank are off while those of the next are on
    an analogue input   50 %, or 100 %, 0 % and so on until the condition holds
    a menu              the numbers that the program compares the answer with, one after the other
    INPUT               the middle of a range such as `1 to 6` that the program prints, or 10, 1, 100 and so on, as in a
                        wide range
    a key               the keys that the program compares with, one after the other
    nothing yet         an input at whose other level the program jumps away (`IF INX.2 = 0 THEN GOTO FAULT`) is on, and
                        one that it waits for and a handler tests for 0
    a polling loop      the inputs, analogue inputs and keys that its conditions read, each by itself and those of one
                        line together, if no axis has moved for 10 s; what lets most lines of the program move stays, if
                        more than before; if none does, what reaches something new is changed further
    a loop of work      an input that ends it, in the same way
    homing              a switch one second ahead of the axis, then index marks

Data: `Guesses` has the entries by channel, question, key and axis. An input that was guessed and is stuck again takes
the next form of the list. Every round changes at least one guess, and no form is taken twice, so the rounds end.

If a program asks again after all answers of a menu, or after 20 equal answers, the run ends for lack of an answer.
`branches` explores the menus as a tree: a path has one choice for each menu, and ends where the program ends or asks a
question of the path again.

An input for which no run waits gets no guess: it may be the button of a fault routine, and held on, it hides the fault.

Cost: a run for each guess, for at most so many seconds as the search has (`Worlds`); those before the last end where
the program is stuck.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator
from copy import deepcopy
from dataclasses import dataclass
from functools import partial
from itertools import count
from math import inf

from motionlang.commands.init.ending import asks, plain
from motionlang.commands.worlds import Entry, World, Worlds, entries
from motionlang.kernel import Run, Task
from motionlang.kernel.lang import InputRead, LoopDependencies, Read, layered

# Seconds from when the program waits to when an input changes, and from an output to the input that follows it.
DELAY = 0.3
# An input that follows an output is waited for at most so many seconds after the output has changed.
MAX_LEAD = 1.0
# An input that comes and goes is on for half of this period, s.
PERIOD = 2.0
# Channels beyond this one are relays, which no input can follow.
LAST_OUTPUT = 999
PULSES: dict[str, object] = {"at": PERIOD / 2, "for": PERIOD / 2, "every": PERIOD}
# Seconds from when the program looks for a key to when it is pressed.
KEY_DELAY = 0.5
# The home switch lies so many seconds of homing ahead, and a tenth of that is its length.
HOME_AHEAD = 1.0
SWITCHES = ("home_switch", "index_every")
# Answers that are tried one after the other, and how often one question is answered.
ANSWERS = ("10", "1", "100", "1000", "5", "0.5")
MAX_REPEATS = 20
# The last number of a wide range is so many times the first one.
WIDE = 100.0
# Levels of analogue inputs that are tried one after the other, percent.
LEVELS = (50.0, 100.0, 0.0, 25.0, 75.0)
# The number of branches of all menus that are explored.
MAX_BRANCHES = 30
# A program that has done nothing for so many seconds waits for a key, if it looks for one. If no axis has moved for so
# long, it waits for a value that the conditions of its loops read.
QUIET = 10.0
_RANGE = re.compile(r"(\d+(?:\.\d+)?)\s*(?:to|-|\.\.)\s*(\d+(?:\.\d+)?)", re.IGNORECASE)


class Guesses:
    """The guesses for one program.

    `inputs` and `analogue` have the entry of each channel, `answers` the lines for each question in order, `keys` the
    key entries, `axes` the settings of each axis by key. `fixed` are settings that a person gave; no guess
    changes them.
    """

    def __init__(self, fixed: dict[str, object] | None = None, path: dict[str, str] | None = None) -> None:
        self.fixed = dict(fixed or {})
        # The choice of each menu on this path of the tree; None to make all choices in turn.
        self.path = path
        # The questions that get no further answer, each with the choices of its menu.
        self.exhausted: dict[str, list[str]] = {}
        # True if the run ends where a question gets no further answer.
        self.ends_at_question = False
        self.inputs: dict[int, Entry] = {}
        self.analogue: dict[int, Entry] = {}
        self.answers: dict[str, list[str]] = {}
        self.keys: list[Entry] = []
        self.axes: dict[int, dict[str, object]] = {}
        # Tried so far: forms of each input, answers to each question.
        self._forms: dict[int, set[str]] = {}
        self._tried: dict[str, list[str]] = {}
        self._lines: dict[int, int] = {}
        # The inputs that are off while the others of a bank are on, in the first wait for both levels.
        self._late: set[int] = set()

    @property
    def count(self) -> int:
        """The number of guessed entries and axes."""
        return (
            len(self.inputs)
            + len(self.analogue)
            + sum(map(len, self.answers.values()))
            + len(self.keys)
            + len(self.axes)
        )

    def settings(self, until: float) -> dict[str, object]:
        """Return the settings of a machine file with all guesses."""
        found: dict[str, object] = {"run.until": until}
        if self.ends_at_question:
            found["run.stop.event"] = "input"
        for axis, keys in self.axes.items():
            found |= {f"axis.{axis}.{key}": value for key, value in keys.items()}
        tables: dict[str, list[Entry]] = {
            "input": list(self.inputs.values()),
            "analogue": list(self.analogue.values()),
            "answer": [answer_entry(each, text) for each, texts in self.answers.items() for text in texts],
            "key": self.keys,
        }
        found |= {table: entries for table, entries in tables.items() if entries}
        return layered(found, self.fixed)

    def line(self, result: Run, at: int) -> int:
        """Return the line of a source offset.

        The lines are cached, because finding one costs as much as parsing the program.
        """
        found = self._lines.get(at)
        if found is None:
            found = self._lines[at] = result.dialect.locate(result.source, at)[0]
        return found

    # ------------------------------------------------------------------------------------------------- inputs

    def guard(self, reads: list[InputRead]) -> None:
        """Switch on the inputs that the program expects to be on.

        These make it jump away while they are off, or it tests them for 0 before it waits for 1, or in a handler. An
        input for whose level 0 the program also waits stays unchanged.
        """
        for read in reads:
            off = any(
                each.kind in ("wait", "poll") and each.channel == read.channel and not each.level
                for each in reads
            )
            waits = any(
                each.kind == "wait"
                and each.channel == read.channel
                and each.level
                and (each.line >= read.line or read.at_any_time)
                for each in reads
            )
            if (
                (read.level if read.kind == "guard" else read.kind == "test" and read.level == 0 and waits)
                and read.channel is not None
                and not off
                and not self.is_fixed(read.channel)
            ):
                self.inputs[read.channel] = {"channel": read.channel, "at": 0.0}

    def alternate(self, reads: list[InputRead]) -> None:
        """Find the inputs whose pulses come while those of others pause.

        They are off where the program first waits for a value of the bank, such as the 10 of `PAUSE IN = 5` and
        `PAUSE IN = 10`.
        """
        levels: dict[int, dict[int, int | None]] = {}
        for read in reads:
            if read.kind == "wait" and read.channel is not None:
                levels.setdefault(read.line, {})[read.channel] = read.level
        seen: set[int] = set()
        for _, wanted in sorted(levels.items()):
            if 0 in wanted.values() and 1 in wanted.values():
                self._late |= {each for each, level in wanted.items() if level == 0 and each not in seen}
            seen |= wanted.keys()

    def _pulses(self, channel: int) -> Entry:
        return {"channel": channel, **PULSES, "at": PERIOD if channel in self._late else PULSES["at"]}

    def is_fixed(self, channel: int) -> bool:
        """True if a person has given entries for an input."""
        return any(each["channel"] == channel for each in entries(self.fixed, "input"))

    def flip(self, channel: int, since: float, result: Run) -> bool:
        """Let an input change to its other level after `since`.

        Returns False if all forms of the entry have been tried.
        """
        if self.is_fixed(channel):
            return False
        wanted = 0 if result.controller.inputs[channel] else 1
        tried = self._forms.setdefault(channel, set())
        for form, entry in self._choices(channel, wanted, since, result):
            if form not in tried:
                tried.add(form)
                self.inputs[channel] = entry
                return True
        return False

    def _choices(self, channel: int, wanted: int, since: float, result: Run) -> Iterator[tuple[str, Entry]]:
        cause = _cause(since, result)
        if cause is not None:
            output, level = cause
            follows: Entry = {"channel": channel, "output": output, "delay": DELAY}
            if level != wanted:
                follows["value"] = 0
            yield f"output {output} {level == wanted}", follows
        at = round(since + DELAY, 1)
        if wanted and channel not in self.inputs:
            yield "on", {"channel": channel, "at": at}
        yield "pulses", self._pulses(channel)

    def level(self, channel: int, since: float) -> bool:
        """Give an analogue input the next level after `since`.

        Returns False if all levels have been tried.
        """
        before = self.analogue.get(channel)
        tried = LEVELS.index(before["value"]) + 1 if before is not None else 0
        if tried == len(LEVELS):
            return False
        self.analogue[channel] = {"channel": channel, "value": LEVELS[tried], "at": round(since + DELAY, 1)}
        return True

    # ------------------------------------------------------------------------------------------------ answers

    def answer(self, question: str, menu: list[str], result: Run) -> bool:
        """Add an answer to a question, or change the last one if it was rejected.

        `menu` are the choices, empty if the question is no menu. Returns False if there is no further answer.
        """
        if menu:
            return self._choose(question, menu)
        given = self.answers.setdefault(question, [])
        tried = self._tried.setdefault(question, [])
        if given and _acted_since_answer(result):
            if len(given) < MAX_REPEATS:
                given.append(given[-1])
                return True
            self.exhausted[question] = []
            return False
        ranges = [_middle(found) for found in _RANGE.findall(_printed_since_answer(result, question, given))]
        for text in (*ranges, *ANSWERS):
            if text not in tried:
                tried.append(text)
                self.answers[question] = [text]
                return True
        return False

    def _choose(self, question: str, menu: list[str]) -> bool:
        """Add the next choice of a menu, or that of the path."""
        given = self.answers.get(question, [])
        choices = menu if self.path is None else [self.path[question]] if question in self.path else []
        if len(given) == len(choices):
            self.exhausted[question] = menu
            return False
        self.answers[question] = [*given, choices[len(given)]]
        return True

    # --------------------------------------------------------------------------------------------------- axes

    def home(self, axis: int, result: Run, wanted: tuple[str, ...] = SWITCHES) -> bool:
        """Put the home switch ahead of a moving axis, or index marks on its encoder.

        `wanted` are those that may be missing. Returns False if the axis is at rest or has them.
        """
        a = result.controller.axes[axis]
        velocity = a.profiles[-1].end_velocity / a.scale.counts if a.profiles else 0.0
        if not velocity:
            return False
        keys = self.axes.setdefault(axis, {})
        ahead = velocity * HOME_AHEAD
        if "home_switch" in wanted and "home_switch" not in keys:
            low, high = sorted((rounded(ahead), rounded(1.1 * ahead)))
            keys["home_switch"] = [low, high]
            return True
        if "index_every" in wanted and "index_every" not in keys:
            keys["index_every"] = rounded(abs(ahead) / 5)
            return True
        return False


def answer_entry(question: str, text: str) -> Entry:
    """Return the entry of an answer; without a question it answers any INPUT."""
    return {"prompt": question, "text": text} if question else {"text": text}


def rounded(value: float) -> float:
    """Return a figure with two significant digits, as a person would guess it."""
    return float(f"{value:.2g}")


def guessed(
    worlds: Worlds, until: float, fixed: dict[str, object], path: dict[str, str] | None = None
) -> tuple[Guesses, Run]:
    """Return the guesses with which a program continues, and the run with all of them.

    `fixed` are the settings that no guess changes, `path` is a path through the program's menus.
    """
    guesses = Guesses(fixed, path)
    guesses.alternate(worlds.reads)
    guesses.guard(worlds.reads)
    search = _Search(worlds, until)
    found = guesses, search.settled(guesses)
    while (better := search.better(*found)) is not None:
        found = better
    return found[0], found[1].result


@dataclass
class _Search:
    """The search for guesses of one program."""

    worlds: Worlds
    until: float

    def settled(self, guesses: Guesses) -> World:
        """Improve guesses until the program is stuck nowhere, and return its world with them."""
        while True:
            world = self.worlds.run(guesses.settings(self.until))
            result = world.result
            failed = result.status == "fault" and not result.machine.scheduler
            if failed or result.status == "interrupted" or self.worlds.is_over:
                return world
            if not (_improve(guesses, result, self.worlds.reads) or _end_at_question(guesses, result)):
                return world

    def better(self, guesses: Guesses, world: World) -> tuple[Guesses, World] | None:
        """Change the polled values with which a program does most; None if it does no more with any.

        If no change by itself lets it do more, those that reach something new are changed further: one of two inputs
        that have to be on may only lead to the test of the other one.
        """
        result = world.result
        quiet = 0.5 * result.time if world.is_cut else QUIET
        at_rest = result.time - _last_motion(result) > quiet
        most, seen = _work(result, at_rest), set(world.events)
        pending = [(guesses, world)]
        while pending:
            found, beyond = None, list[tuple[Guesses, World]]()
            for trial in (each for one in pending for each in self._trials(*one, most, at_rest)):
                work = _work(trial[1].result, at_rest)
                if work > most:
                    found, most = trial, work
                elif trial[1].events.keys() - seen and trial[1].result.status != "fault":
                    beyond.append(trial)
                seen |= trial[1].events.keys()
            if found is not None:
                return found
            pending = beyond
        return None

    def _trials(
        self, guesses: Guesses, world: World, most: tuple[int, int], at_rest: bool
    ) -> Iterator[tuple[Guesses, World]]:
        """Yield the worlds of each change, in all its forms until one of them does more than `most`."""
        result = world.result
        for change in _polled(result, self.worlds.reads, at_rest) if result.status == "until" else ():
            for times in count(1):
                trial = deepcopy(guesses)
                if self.worlds.is_over or not all(change(trial) for _ in range(times)):
                    break
                tried = self.settled(trial)
                yield trial, tried
                if _work(tried.result, at_rest) > most:
                    break


def branches(worlds: Worlds, until: float, fixed: dict[str, object]) -> list[tuple[Guesses, Run]]:
    """Return each path through the menus of a program whose last choice moves an axis."""
    found = []
    paths: list[dict[str, str]] = [{}] if any(each.kind == "answer" for each in worlds.reads) else []
    for _ in range(MAX_BRANCHES):
        if not paths:
            break
        path = paths.pop(0)
        guesses, result = guessed(worlds, until, fixed, path)
        below = [
            {**path, question: choice}
            for question, menu in guesses.exhausted.items()
            for choice in menu
            if question not in path
        ]
        paths[:0] = below
        chosen = _answered_at(result)
        if path and not below and any(move.start_time >= chosen for move in result.machine.log.moves):
            found.append((guesses, result))
    return found


def _end_at_question(guesses: Guesses, result: Run) -> bool:
    """Let the run end where the program asks a question that gets no further answer.

    Returns False if that is not why it is stuck.
    """
    question = _question(result)
    if not asks(result) or question not in guesses.exhausted or not result.time:
        return False
    guesses.ends_at_question = True
    return True


def _improve(guesses: Guesses, result: Run, reads: list[InputRead]) -> bool:
    """Change a guess where the program is stuck.

    Returns False if it is not stuck, or if nothing is left to guess.
    """
    axes = result.controller.axes.items()
    lost = [axis for axis, a in axes if a.homing is not None and a.homing.endless_motion]
    changed = [guesses.home(axis, result) for axis in lost]
    if any(changed):
        return True
    scheduler = result.machine.scheduler
    assert scheduler is not None
    tasks = [task for task in scheduler.tasks if not task.done]
    changed = [_improve_wait(guesses, result, reads, task) for task in tasks]
    if any(changed):
        return True
    if _improve_polls(guesses, result, reads, tasks):
        return True
    quiet = result.status == "until" and result.time - _last_act(result) > QUIET
    return quiet and any(task.wait is None for task in tasks) and _press(guesses, _last_act(result), reads)


def _improve_wait(guesses: Guesses, result: Run, reads: list[InputRead], task: Task) -> bool:
    """Change a guess for a wait that never ends."""
    wait = task.wait
    if wait is None or wait.due() != inf:
        return False
    if result.status == "until" and result.time - wait.since < 2 * PERIOD:
        return False  # it may still end
    if wait.cause == "operator":
        question = _question(result)
        line = guesses.line(result, task.at)
        menu = [str(each.channel) for each in reads if each.kind == "answer" and each.last == line]
        return guesses.answer(question, menu, result)
    line = guesses.line(result, task.at)
    changed: list[bool] = []
    for key in result.dialect.driven_by(wait.why):
        if key.startswith("axis."):
            _, axis, setting = key.split(".")
            return guesses.home(int(axis), result, (setting,) if setting in SWITCHES else SWITCHES)
        if key == "key":
            return _press(guesses, _last_act(result), reads)
        if key == "analogue":
            dependencies = _polls(result)(task.at)
            analogue = (
                sorted(n for kind, n in dependencies.leaves if kind == "analogue" and n is not None)
                if dependencies
                else []
            )
            changed += [guesses.level(channel, wait.since) for channel in analogue]
    channels = list(wait.what) if wait.cause == "input" else []
    levels = result.controller.inputs
    for read in () if channels else reads:
        if read.kind in ("wait", "either") and read.line == line and read.channel is not None:
            channels += [read.channel] if read.level is None or read.level != levels[read.channel] else []
    leaving = {
        each.channel
        for each in reads
        if each.kind == "guard" and each.channel is not None and each.level == levels[each.channel]
    }
    wanted = [channel for channel in channels if channel not in leaving] or channels
    changed += [guesses.flip(channel, wait.since, result) for channel in dict.fromkeys(wanted)]
    return any(changed) or _improve_event(guesses, result, reads, task, wait.since)


def _improve_event(guesses: Guesses, result: Run, reads: list[InputRead], task: Task, since: float) -> bool:
    """Change the input of a handler, if a task waits for a variable that a handler or another task changes."""
    dependencies = _polls(result)(task.at)
    if dependencies is None or ("task", None) not in dependencies.leaves:
        return False
    events = dict.fromkeys(each.channel for each in reads if each.kind == "event")
    return any(guesses.flip(channel, since, result) for channel in events if channel is not None)


def _polls(result: Run) -> Callable[[int], LoopDependencies | None]:
    """Return what maps a source offset of a run to the reads of its loop."""
    assert result.program is not None
    return result.program.polls


def _question(result: Run) -> str:
    """Return the question that the program asks, without escape codes and the marks around it."""
    return plain(result.machine.operator.question).strip(" ?:")


def _press(guesses: Guesses, since: float, reads: list[InputRead]) -> bool:
    """Press the next key that the program compares with, after `since`."""
    codes = list(dict.fromkeys(chr(each.channel) for each in reads if each.kind == "key" and each.channel))
    left = codes[len(guesses.keys) :]
    if not left or guesses.fixed.get("key"):
        return False
    guesses.keys.append({"at": round(since + KEY_DELAY, 1), "text": left[0]})
    return True


def _improve_polls(guesses: Guesses, result: Run, reads: list[InputRead], tasks: list[Task]) -> bool:
    """Change a guess for a polling loop on an input that has no guess yet.

    The program is in the loop, or reached the time limit there.
    """
    polls = [each for each in reads if each.kind == "poll" and each.channel not in guesses.inputs]
    if not polls:
        return False
    ends = [guesses.line(result, task.at) for task in tasks]
    depends = _polls(result)
    loops = [(each, depends(each.at)) for each in result.machine.log.loops]
    waits = result.machine.log.waits.written()
    pauses = [(guesses.line(result, each.at), each.since) for each in waits if each.cause == "time"]
    levels = result.controller.inputs
    for read in polls:
        if read.channel is None or read.level == levels.inverted(read.channel):
            continue
        since = [
            each.since
            for each, loop in loops
            if guesses.line(result, each.at) == read.line
            or (loop and read.line in loop.lines and max(loop.lines) <= read.last)
        ]
        if not since and any(read.line <= line <= read.last for line in ends):
            since = [_entered(guesses, result, read)]
        since = since or [time for line, time in pauses if read.line <= line <= read.last]
        if since and guesses.flip(read.channel, since[0], result):
            return True
    return False


def _polled(result: Run, reads: list[InputRead], at_rest: bool) -> Iterator[Callable[[Guesses], bool]]:
    """Yield a change of each value that the loops of a program poll, in the order of the lines.

    These are all values of their conditions if the program is at rest, and else the inputs that end a loop of work,
    such as steps towards a sensor. Last come the inputs that one line reads, all together.
    """
    scheduler = result.machine.scheduler
    since = _last_motion(result) if at_rest else 0.0
    depends = _polls(result)
    tasks = scheduler.tasks if scheduler is not None else ()
    loops = [depends(at) for task in tasks if not task.done for at, _, _ in task.loops]
    polled = {
        read for loop in loops if loop is not None for read in (loop.within if at_rest else loop.leaves)
    }
    if not at_rest:
        polled &= {("input", each.channel) for each in reads if each.kind == "work"}
    order: list[Read] = [("input", each.channel) for each in reads if each.is_input]
    for kind, number in [*dict.fromkeys(order), *sorted(polled - set(order), key=repr)]:
        if (kind, number) not in polled:
            continue
        if kind == "input" and number is not None:
            yield partial(Guesses.flip, channel=number, since=since, result=result)
        elif kind == "analogue" and number is not None:
            yield partial(Guesses.level, channel=number, since=since)
        elif kind == "operator":
            yield partial(_press, since=since, reads=reads)
    levels = result.controller.inputs
    for channels in together(reads):
        off = [each for each, level in channels.items() if levels[each] != level]
        if len(off) > 1 and all(("input", each) in polled for each in off):
            yield partial(_flip_all, channels=off, since=since, result=result)


def _flip_all(guesses: Guesses, channels: list[int], since: float, result: Run) -> bool:
    return all(guesses.flip(each, since, result) for each in channels)


def together(reads: list[InputRead]) -> list[dict[int, int]]:
    """Return the inputs that the lines read, each with its level, of lines with several; 1 if no level is known."""
    lines: dict[int, dict[int, int]] = {}
    for each in reads:
        if each.is_input and each.channel is not None:
            lines.setdefault(each.line, {})[each.channel] = 1 if each.level is None else each.level
    found = [channels for channels in lines.values() if len(channels) > 1]
    return [each for number, each in enumerate(found) if each not in found[:number]]


def _cause(since: float, result: Run) -> tuple[int, int] | None:
    """Return the output that was set last before `since`, and its level.

    An output that blinks afterwards is a lamp. Returns None if the program did anything else in between.
    """
    log = result.machine.log
    later = Counter(each.channel for each in log.outputs if each.time > since)
    outputs = [
        each
        for each in log.outputs
        if since - MAX_LEAD <= each.time <= since and each.channel <= LAST_OUTPUT and later[each.channel] < 2
    ]
    if not outputs:
        return None
    last = outputs[-1]
    if any(last.time < move.start_time <= since for move in log.moves):
        return None
    if any(
        each.cause in ("input", "operator") and last.time < each.until < since for each in log.waits.written()
    ):
        return None
    return int(last.channel), int(bool(last.value))


def _entered(guesses: Guesses, result: Run, loop: InputRead) -> float:
    """Return when the last wait outside `loop` ended."""
    ends = [0.0]
    for wait in result.machine.log.waits.written():
        if not loop.line <= guesses.line(result, wait.at) <= loop.last:
            ends.append(wait.until)
    return max(ends)


def _last_act(result: Run) -> float:
    """Return when the program last moved, set an output, printed or read an input."""
    log = result.machine.log
    acts = [each.time for each in log.outputs] + [each.time for each in log.prints]
    return max([_last_motion(result), *(time for time in acts if time <= result.time)])


def _last_motion(result: Run) -> float:
    """Return when the program last moved, or a wait for an input or an answer ended."""
    log = result.machine.log
    ends = [move.start_time + move.profile.duration for move in log.moves if move.profile is not None]
    ends += [each.until for each in log.waits.written() if each.cause in ("input", "operator")]
    return max((time for time in ends if time <= result.time), default=0.0)


def _work(result: Run, counts: bool) -> tuple[int, int]:
    """Return how many lines of the program move an axis and, if it `counts`, the number of their moves."""
    lines = [move.line for move in result.machine.log.moves]
    return len(set(lines)), len(lines) if counts else 0


def _answered_at(result: Run) -> float:
    """Return when the program took its last answer; 0 if it has taken none."""
    return max(
        (each.until for each in result.machine.log.waits.written() if each.cause == "operator"), default=0.0
    )


def _acted_since_answer(result: Run) -> bool:
    """True if the program moved or set an output since its last answer.

    In that case the next question belongs to the next cycle.
    """
    time, log = _answered_at(result), result.machine.log
    return any(move.start_time > time for move in log.moves) or any(each.time > time for each in log.outputs)


def _printed_since_answer(result: Run, question: str, given: list[str]) -> str:
    """Return the text printed since the last answer.

    It contains the reason why the answer was rejected, and the question, but no answer in the line of the question:
    its digits would continue a range such as `3 to 8`.
    """
    time = _answered_at(result)
    lines = [each.text for each in result.machine.log.prints if each.time >= time]
    echoed = {f"{question}{text}" for text in given if question}
    return "\n".join(line for line in lines if line not in echoed)


def _middle(found: tuple[str, str]) -> str:
    """Return the middle of a range, as an integer if an integer lies in the range.

    A wide range, such as `1-9999` pieces, gets the first usual answer in it: ten pieces show as much as 5000.
    """
    low, high = float(found[0]), float(found[1])
    if high > WIDE * max(low, 1.0):
        return next((each for each in ANSWERS if low <= float(each) <= high), found[0])
    middle = (low + high) / 2
    return f"{int(middle) if int(middle) >= low else middle:.10g}"
