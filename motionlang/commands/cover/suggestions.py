"""Worlds in which a program reaches what its runs have not reached yet, for `motionlang cover --suggest`.

Problem. A statement that no run reaches needs an input, an answer, an analogue value or a key at the right time, and
the program does not say when.

Idea. Begin with the worlds that `init` guesses, one for each path through the menus, as far as they reach anything new.
Then change one entry at a time, or the inputs that one line reads together, run, and keep what reaches more. What is
kept is changed further, in turn with the others: a world in which the program is stuck holds up none.

    what the program reads      what is tried
    a digital input             the other level from the start; at a moment of the run, for half a second or for good
    an analogue input           0, 25, 50, 75 and 100 %, from the start or from a moment of the run on
    an answer to INPUT          the numbers that the program compares it with, the ones beside them, and usual ones
    a key                       the keys that the program compares with, at a moment of the run

The moments of a run are the middles of its waits, loops and moves. Entries whose lines are near something that was not
reached come first.

Cost: a run for each change, for at most so many seconds as the search has (`Worlds`).
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain, zip_longest
from textwrap import wrap
from typing import Any

from motionlang.commands.cover import Coverage, coverage, ranges
from motionlang.commands.init import ANSWERS, KEY_DELAY, LEVELS, answer_entry, branches, guessed, together
from motionlang.commands.init.ending import ending, wording
from motionlang.commands.init.file import inline, toml_value
from motionlang.commands.worlds import TABLES, Entry, Event, World, Worlds, entries
from motionlang.kernel import Run
from motionlang.kernel.lang import InputRead, Structure, layered
from motionlang.kernel.report import axes as axes_of
from motionlang.kernel.report import moves as moves_of

# The moments of a run that are tried, and the length of a pulse, s.
MAX_MOMENTS, PULSE = 16, 0.5
# The printed lines that a scenario expects, the last ones, and the tolerance of positions, uu.
MAX_LINES, WITHIN = 4, 0.001
REVIEW = "The expectations are what the program does in it: check whether they are what it should do."


@dataclass
class Suggestion:
    """A world: settings on top of the program's own, a run in them, and the lines that it is the first to reach."""

    settings: dict[str, object]
    result: Run
    reaches: list[int]


class Search:
    """Searches for worlds of a program whose `own` settings are those of its machine file.

    `before` are the events that its runs have reached already. `until` is the time limit of the worlds. `progress` is
    called with the share of the search's time that is used.
    """

    def __init__(
        self,
        worlds: Worlds,
        own: dict[str, object],
        before: Counter[Event],
        until: float,
        progress: Callable[[float], object] = lambda share: None,
    ) -> None:
        self.worlds, self.own, self.until = worlds, own, until
        self.structure: Structure = worlds.program.structure
        self.offsets = worlds.program.offsets
        self.events = before.copy()
        # What all runs together have reached.
        self.coverage = self._covered()
        self.found: list[Suggestion] = []
        self._progress = progress
        self._tried: set[str] = set()

    def run(self) -> list[Suggestion]:
        """Return the worlds that reach something new, in the order in which they were found."""
        for settings in self._guesses():
            self._try(settings)
        own: dict[str, object] = {"run.until": self.until}
        bases = [Suggestion(own, self._ran(own).result, []), *self.found]
        pending = deque(self._changes(each) for each in bases)
        while pending and not self.worlds.is_over and self.coverage.reached < self.coverage.total:
            changed = next(pending[0], None)
            if changed is None:
                pending.popleft()
                continue
            pending.rotate(-1)
            if (world := self._try(changed)) is not None:
                pending.appendleft(self._changes(world))
        return self.found

    def _covered(self) -> Coverage:
        return coverage(self.structure, self.offsets, self.events)

    def _guesses(self) -> Iterator[dict[str, object]]:
        """Yield the worlds that `init` guesses: for the program, and for each path through its menus."""
        own = {key: value for key, value in self.own.items() if key != "run.until"}
        target = self.worlds.program.target
        if target.model:
            own.setdefault("controller.model", target.model)
        guesses, _ = guessed(self.worlds, self.until, own)
        yield self._above(guesses.settings(self.until))
        for each, _ in branches(self.worlds, self.until, own):
            yield self._above(each.settings(self.until))

    def _above(self, settings: dict[str, object]) -> dict[str, object]:
        """Return what settings add to those of the program."""
        return {key: value for key, value in settings.items() if self.own.get(key) != value}

    def _ran(self, settings: dict[str, object]) -> World:
        self._progress(self.worlds.share)
        return self.worlds.run(layered(self.own, settings))

    def _try(self, settings: dict[str, object]) -> Suggestion | None:
        """Run a world, keep it if it reaches something new, and return it if it can be changed further."""
        key = repr(sorted(settings.items()))
        if key in self._tried:
            return None
        self._tried.add(key)
        world = self._ran(settings)
        new = [event for event in world.events if event not in self.events]
        if not new or (world.result.status == "fault" and not world.result.machine.scheduler):
            return None
        self.events += world.events
        before, self.coverage = self.coverage, self._covered()
        if self.coverage.reached == before.reached:
            return None
        reaches = sorted(before.missed.keys() - self.coverage.missed.keys())
        if world.is_cut:  # the scenario ends where its run did
            settings = {**settings, "run.until": round(world.result.time, 2)}
        self.found.append(Suggestion(settings, world.result, reaches))
        return None if world.is_cut else self.found[-1]

    # ------------------------------------------------------------------------------------------------- changes

    def _changes(self, world: Suggestion) -> Iterator[dict[str, object]]:
        """Yield the settings of a world with one entry changed, the most promising ones first."""
        missed = sorted(self.coverage.missed)

        def distance(read: InputRead) -> int:
            return min((abs(line - read.line) for line in missed), default=0)

        moments = _moments(world.result)
        reads = sorted(self.worlds.reads, key=distance)
        channels = dict.fromkeys(each.channel for each in reads if each.is_input and each.channel is not None)
        keys = dict.fromkeys(chr(each.channel) for each in reads if each.kind == "key" and each.channel)
        kinds = (
            self._answers(world, reads),
            *(self._inputs(world, {channel: 1}, moments) for channel in channels),
            *(self._inputs(world, channels, moments) for channels in together(reads)),
            *(self._analogue(world, channel, moments) for channel in self._analogue_channels()),
            *(self._key(world, key, moments) for key in keys),
        )
        for round_ in zip_longest(*kinds):
            yield from (each for each in round_ if each is not None)

    def _with(self, world: Suggestion, table: str, changed: Sequence[Entry]) -> dict[str, object]:
        return {**world.settings, table: list(changed)}

    def _entries(self, world: Suggestion, table: str) -> list[Entry]:
        """Return the entries of a table in a world: its own, or those of the program."""
        return list(entries(layered(self.own, world.settings), table))

    def _inputs(
        self, world: Suggestion, levels: Mapping[int, int], moments: Sequence[float]
    ) -> Iterator[dict[str, object]]:
        """Yield the worlds in which inputs have these levels, or all the other ones."""
        before = self._entries(world, "input")
        others = [each for each in before if each.get("channel") not in levels]
        mine = [each for each in before if each.get("channel") in levels]

        def changed(same: int, keys: Entry) -> list[Entry]:
            return [
                {"channel": channel, **keys, "value": int(level == same)} for channel, level in levels.items()
            ]

        for same in (1, 0):
            yield self._with(world, "input", [*others, *changed(same, {"at": 0.0})])
        for moment in moments:
            for same in (0, 1):
                pulses = changed(same, {"at": moment, "for": PULSE})
                yield self._with(world, "input", [*others, *mine, *pulses])
                until = changed(1 - same, {"at": 0.0, "for": moment}) if same else mine
                yield self._with(world, "input", [*others, *until, *changed(same, {"at": moment})])

    def _analogue(
        self, world: Suggestion, channel: int, moments: Sequence[float]
    ) -> Iterator[dict[str, object]]:
        before = self._entries(world, "analogue")
        others = [each for each in before if each.get("channel") != channel]
        for moment in (0.0, *moments):
            for level in LEVELS:
                mine = [each for each in before if each.get("channel") == channel] if moment else []
                change: Entry = {"channel": channel, "value": level, "at": moment}
                yield self._with(world, "analogue", [*others, *mine, change])

    def _analogue_channels(self) -> list[int]:
        uses = chain.from_iterable(each.channels for each in self.structure.statements.values())
        numbers = dict.fromkeys(each.number for each in uses if each.channel == "analogue input")
        return [int(number) for number in numbers if number.isdecimal()]

    def _key(self, world: Suggestion, key: str, moments: Sequence[float]) -> Iterator[dict[str, object]]:
        before = self._entries(world, "key")
        for moment in (KEY_DELAY, *moments):
            yield self._with(world, "key", [*before, {"at": moment, "text": key}])

    def _answers(self, world: Suggestion, reads: Sequence[InputRead]) -> Iterator[dict[str, object]]:
        """Yield the worlds in which a question gets another first answer, or all its answers are another one."""
        before = self._entries(world, "answer")
        numbers = [each.channel for each in reads if each.kind == "answer" and each.channel is not None]
        texts = [str(number + more) for number in numbers for more in (0, 1, -1)]
        for question in dict.fromkeys(str(each.get("prompt", "")) for each in before):
            mine = [each for each in before if each.get("prompt", "") == question]
            others = [each for each in before if each.get("prompt", "") != question]
            for text in dict.fromkeys((*texts, "0", "-1", *ANSWERS)):
                answer = answer_entry(question, text)
                yield self._with(world, "answer", [*others, answer, *mine])
                yield self._with(world, "answer", [*others, *([answer] * len(mine))])


def scenario_text(program: str, world: Suggestion, own: Mapping[str, object]) -> str:
    """Return a world as a scenario of a program with `own` settings; its results are the expectations."""
    lines = ", ".join(ranges(world.reaches))
    added = {key: value for key, value in world.settings.items() if key not in TABLES}
    reaches = f"lines {lines}" if lines else "more"
    head = f"A world of {program}, found by motionlang cover --suggest. It reaches {reaches}. {REVIEW}"
    parts = ["".join(f"# {line}\n" for line in wrap(head, 98)), "\n"]
    stop = {} if any(key.startswith("run.stop.") for key in own) else ending(world.result)
    added |= {f"run.stop.{key}": value for key, value in stop.items()}
    parts += [f"{key} = {toml_value(value)}\n" for key, value in sorted(added.items())]
    for table in TABLES:
        changed = _changed(entries(world.settings, table), entries(own, table))
        if changed:
            parts += [f"\n{table} = [\n", *(f"  {inline(each)},\n" for each in changed), "]\n"]
    for expected in _expected(world.result, bool(stop)):
        parts += ["\n[[expect]]\n", *(f"{key} = {toml_value(value)}\n" for key, value in expected.items())]
    return "".join(parts)


def _changed(own: Sequence[Entry], before: Sequence[Entry]) -> list[Entry]:
    """Return the entries of the channels and so on that have others than in the program's own world."""
    subject = ("channel", "prompt")

    def about(entry: Entry, among: Sequence[Entry]) -> list[Entry]:
        return [each for each in among if all(each.get(key) == entry.get(key) for key in subject)]

    return [each for each in own if about(each, own) != about(each, before)]


def _expected(result: Run, stops: bool) -> Iterator[Entry]:
    """Yield what a run has done, as expectations: no time, no figure and, of a run that `stops` itself, no error.

    The positions at a time limit depend on the speed of the machine, so they are none.
    """
    status = "stopped" if stops else result.status
    if status in ("ended", "until", "stopped", "fault"):
        yield {"status": status}
    for code in dict.fromkeys(
        each.code for each in result.diagnostics if each.severity == "error" and not stops
    ):
        yield {"diagnostic": code}
    for text in list(dict.fromkeys(filter(None, map(wording, result.output))))[-MAX_LINES:]:
        yield {"prints": text}
    if stops or status in ("until", "stopped"):
        return
    rows: Iterable[dict[str, Any]] = axes_of(result)
    for axis in rows:
        yield {"axis": axis["axis"], "position": round(axis["position"], 4), "within": WITHIN}


def _moments(result: Run) -> list[float]:
    """Return the middles of the waits, loops and moves of a run, at most `MAX_MOMENTS` of them."""
    log = result.machine.log
    waits = [0.5 * (each.since + each.until) for each in log.waits]
    waits += [0.5 * (each.since + each.until) for each in log.loops]
    rows: Iterable[dict[str, Any]] = moves_of(result)
    moves = [each["start_time"] + 0.5 * each["duration"] for each in rows]
    tasks = result.machine.scheduler.tasks if result.machine.scheduler else ()
    still = [each.wait.since + PULSE for each in tasks if each.wait is not None]
    found = sorted(
        {round(moment, 2) for moment in (0.5 * result.time, *waits, *moves, *still) if moment > 0.0}
    )
    step = max(1, len(found) // MAX_MOMENTS)
    return found[::step]
