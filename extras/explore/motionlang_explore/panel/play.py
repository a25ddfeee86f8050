"""One run of a program in real time, in a thread of its own, with the changes of a hand.

Problem. A person acts at any time, and pauses, steps and goes back. The same changes at the same machine times must
give the same run to the byte, in the panel as in a scenario.

Idea. The run is an ordinary one, and nothing but the clock knows of the hand: an event every 20 ms makes the changes of
that moment, and waits there until real time has come so far. So each change has a time that a scenario can write down,
and a run is repeated by making the recorded changes at the same events. To go back is to run again, without waiting, up
to an earlier moment.

    clock      0.00   0.02   0.04   0.06   …
    event        │      │      │      │        makes changes, publishes the state, waits for real time
    program      └──────┴──────┴──────┴──      statements, moves and waits as in any run

A question of INPUT stops machine time until it is answered, as a run on a terminal does. A step ends before the next
statement; what a hand does there is made at the next event.

Invariants.
- Only the thread of the present run touches its machine, and only that thread replaces the run by another.
- Other threads post actions. The run takes them in their order while it waits; the run that replaces it takes the rest.
- An abandoned run publishes nothing and takes no action any more.
"""

from __future__ import annotations

import threading
from bisect import insort
from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from itertools import count
from math import ceil, inf
from operator import itemgetter
from time import monotonic

from motionlang.kernel import CheckedSettings, Machine, Program, Run, Task, run
from motionlang.kernel.lang import CONSOLE
from motionlang_explore.exploration import Change, Entry, tables_of
from motionlang_explore.panel.pace import PlayPace
from motionlang_explore.panel.rest import SHADOW, PanelWait, RestWatch

# Changes are made at multiples of 1 / so many seconds.
PER_SECOND = 50
# The state is published so often, in seconds of real time, and at once after a change.
PUBLISH = 0.04
# A wait that is not worth while, s.
SHORT = 0.002
# A table of changes that the machine file does not have: a hand lets go of an input that the machine file drives.
RELEASE = "release"
# The tables whose changes are of inputs.
INPUTS = "input", RELEASE
STACK_SIZE = 64 * 1024 * 1024


def in_words(change: Change) -> str:
    """Return a change of a hand in words."""
    return f"input {change.number} let go" if change.table == RELEASE else str(change)


class Abandoned(BaseException):
    """Raised in the thread of a run that is no longer needed."""


class Press(Change):
    """A change of an input by a hand that is on its button."""

    __slots__ = ()


@dataclass
class PlayRecord:
    """The actions of a person: changes with their times, in order, and answers with the time of their question."""

    changes: list[tuple[float, Change]] = field(default_factory=list)
    answers: list[tuple[float, str]] = field(default_factory=list)

    def until(self, time: float) -> PlayRecord:
        """Return what was done up to a time."""
        return PlayRecord(
            [each for each in self.changes if each[0] <= time],
            [each for each in self.answers if each[0] <= time],
        )

    @property
    def last(self) -> dict[int, Change]:
        """The last change of each input."""
        return {each.number: each for _, each in self.changes if each.table in INPUTS}

    @property
    def pressed(self) -> set[int]:
        """The inputs that hands press."""
        return {number for number, each in self.last.items() if isinstance(each, Press) and each.value}

    def __len__(self) -> int:
        return len(self.changes) + len(self.answers)


class ActionQueue:
    """The actions that pages have asked for: any thread adds one, the thread of the run carries them out."""

    def __init__(self) -> None:
        self._posted: deque[Action] = deque()
        # The numbers of questions, which no two runs share.
        self.questions = count(1)
        self._changed = threading.Condition()

    def post(self, action: Action) -> None:
        """Let the present run do something; a run that replaces it before does it instead."""
        with self._changed:
            self._posted.append(action)
            self._changed.notify()

    def take(self, seconds: float) -> Action | None:
        """Return the next action, after at most so many seconds; None if there is none."""
        with self._changed:
            self._changed.wait_for(lambda: self._posted, None if seconds == inf else seconds)
            return self._posted.popleft() if self._posted else None


class Play:
    """A run with the changes of a record, to which a hand adds others.

    It does not wait for real time before `until`, where it pauses unless `goes_on`. `publish` is called with the play
    when its state may have changed, in its own thread.
    """

    def __init__(
        self,
        program: Program,
        settings: Mapping[str, object],
        overrides: Mapping[str, float | str],
        record: PlayRecord,
        actions: ActionQueue,
        publish: Callable[[Play], object],
        *,
        until: float = 0.0,
        speed: float = 1.0,
        goes_on: bool = True,
    ) -> None:
        self.program, self.settings, self.overrides, self.record = program, settings, overrides, record
        self.until, self.pace = until, PlayPace(speed)
        # True if the run waits, or will at `until`.
        self.is_paused = not goes_on
        # The result of a run that is over.
        self.result: Run | None = None
        self.machine: Machine | None = None
        # The question of an INPUT that waits for an answer.
        self.question: str | None = None
        # Its number, by which an answer says that it is for this one.
        self.asks = 0
        # The task and the statement before which a step has ended.
        self.stopped: dict[Task, int] = {}
        # The inputs that a hand has taken from the machine file.
        self.held: set[int] = set()
        # How long the program had asked for each change that is made, s, None if it did not ask for it.
        self.asked: list[float | None] = []
        self.text: list[str] = []
        self.watch = RestWatch(program)
        self.watch.stop = self._stop
        self._actions, self._publish = actions, publish
        self._is_abandoned = False
        # The number of the present event, or of the next one between two.
        self._ticks = 0
        # The changes of the record that are made, and the answers that are given.
        self._made = self._answered = 0
        self._answer: str | None = None
        self._steps_after_event = False
        # When a run to the next rest began, in machine time, infinite if there is none, and what was awaited then.
        self._seeks_rest = inf
        self._awaited: list[PanelWait] = []
        # True while the run waits for real time.
        self._is_in_time = False
        # The real time of the last publication.
        self._published = -inf
        self._thread = threading.Thread(target=self._run, name="panel run", daemon=True)

    def start(self) -> None:
        """Start the run."""
        before = threading.stack_size(STACK_SIZE)
        try:
            self._thread.start()
        finally:
            threading.stack_size(before)

    def join(self, seconds: float) -> None:
        """Wait for the end of the thread."""
        self._thread.join(seconds)

    @property
    def now(self) -> float:
        """The machine time, s."""
        return 0.0 if self.machine is None else self.machine.clock.now

    @property
    def moment(self) -> float:
        """The machine time that it has come to, or will without waiting, s."""
        return max(self.now, self.until)

    @property
    def shown(self) -> float:
        """The machine time that a page shows, s: that of real time, which comes to the next event."""
        if not self._is_in_time:
            return self.now
        return min(self.now, max(self.pace.machine_time, self.now - 1.0 / PER_SECOND))

    @property
    def pending(self) -> list[str]:
        """The changes that are made at the next event, since the run is stopped, in words."""
        if not self._is_between and not self.is_paused:
            return []
        return [in_words(change) for _, change in self.record.changes[self._made :]]

    @property
    def driven(self) -> set[int]:
        """The inputs that the machine file drives."""
        entries = self.settings.get("input", ())
        return {each["channel"] for each in entries}  # type: ignore[attr-defined]

    # -------------------------------------------------------------------------- actions, in the thread of the run

    def abandon(self) -> None:
        """End the run; nothing of it is published any more."""
        self._is_abandoned = True

    def change(self, change: Change) -> None:
        """Make a change now; at the next event if the run is stopped between two, or when it has come to `until`.

        A press comes an event after the last change of its input at least, so that the program sees each of any length.
        """
        event = max(self._ticks, ceil(self.until * PER_SECOND - 1e-6))
        if change.table in INPUTS:
            is_press = change.table == RELEASE or isinstance(change, Press)
            for time, each in self.record.changes:
                if each.number == change.number and each.table in INPUTS:
                    event = max(event, round(time * PER_SECOND) + is_press)
        insort(self.record.changes, (event / PER_SECOND, change), key=itemgetter(0))
        if self.result is not None:
            self._make_until(inf)
        elif self.now >= self.until and not self._is_between:
            self._make_until(self.now)

    def press(self, number: int, *, is_down: bool) -> None:
        """Press a button or let it come up; one that is latched stays on.

        The machine file then drives again what it drove before.
        """
        last = self.record.last.get(number)
        if is_down and (last is None or last.table == RELEASE or not last.value):
            self.change(Press("input", number, 1))
        elif not is_down and number in self.record.pressed:
            self.change(Change(RELEASE, number, 0.0) if number in self.driven else Press("input", number, 0))

    def reply(self, text: str, question: int) -> bool:
        """Answer the question of an INPUT; False if it does not wait for an answer any more."""
        if self.question is None or self._answer is not None or self.asks != question:
            return False
        self._answer = text
        return True

    def pause(self) -> None:
        self.is_paused, self._seeks_rest = True, inf
        self.pace.restart()

    def go_on(self) -> None:
        self.is_paused, self._seeks_rest = False, inf
        self.watch.limit = inf
        self.pace.restart()

    def step(self) -> None:
        """Go on to the next statement of any task, behind the changes that are yet to be made."""
        self.go_on()
        if self._made < len(self.record.changes) or self.now < self.until:
            self._steps_after_event = True
        else:
            self.watch.limit = self.watch.count + 1

    def seek_rest(self) -> None:
        """Go on, without waiting for real time, until the program rests again."""
        self.go_on()
        self._seeks_rest = self.moment
        self._awaited = []
        if self.machine is not None and self.now >= self.until:
            self._awaited = self.watch.awaited(self.machine)

    # ---------------------------------------------------------------------------------------- the thread

    def _run(self) -> None:
        try:
            self.result = run(
                self.program,
                machine=CheckedSettings(self._wired()),
                until=inf,
                overrides=self.overrides,
                show=self.text.append,
                begun=self._begin,
                hook=self.watch,
                keep_crash=True,
            )
            while True:  # the last state stays, for pages that go back from it
                self._tell()
                self._act(inf)
        except Abandoned:
            pass

    def _wired(self) -> dict[str, object]:
        """Return the settings with each input of the machine file moved to its shadow, but for those that answer.

        An input that answers when the program asks for it is the one that the program reads.
        """
        entries: list[Entry] = self.settings.get("input", [])  # type: ignore[assignment]
        asked = {each["channel"] for each in entries if "asked" in each}
        wired = [
            each if each["channel"] in asked else {**each, "channel": each["channel"] + SHADOW}  # type: ignore[operator]
            for each in entries
        ]
        return {**self.settings, "input": wired} if wired else dict(self.settings)

    def _begin(self, machine: Machine) -> None:
        self.machine = machine
        machine.controller.answering()  # before the watch, which lets it know of a value that is about to be read
        self.watch.attach(machine)
        machine.ask = self._ask
        inputs = machine.controller.inputs
        if machine.world is not None:
            for channel, value in inputs.values:  # of power-up
                self._copy(channel, value)
            machine.world.driven |= {each - SHADOW for each in machine.world.driven if each >= SHADOW}
        inputs.listeners.insert(0, self._copy)
        self._tick()

    def _copy(self, channel: int, value: float) -> None:
        """Let an input follow its shadow, unless a hand holds it."""
        if channel >= SHADOW and channel - SHADOW not in self.held and self.machine is not None:
            self.machine.controller.inputs[channel - SHADOW] = value

    def _tick(self) -> bool:
        """Make the changes of this moment and wait for real time; True if nothing has changed."""
        assert self.machine is not None
        made = self._made
        self._make_until(self.now)
        if self._steps_after_event and self.now >= self.until:
            self._steps_after_event, self.watch.limit = False, self.watch.count + 1
        if self.now >= self._seeks_rest and self._rests() and self._is_elsewhere():
            self.pause()
        self._hold()
        self._ticks += 1
        self.machine.clock.at(self._ticks / PER_SECOND, self._tick)
        return self._made == made

    def _hold(self) -> None:
        """Wait until real time has come to the present moment, or as long as the run is paused."""
        now, seconds = self.now, 0.0
        while True:
            any_came = self._act(seconds)
            self._is_in_time = False
            if any_came and not self.is_paused:
                self._tell()
            if now < self.until or (self._seeks_rest < inf and not self._rests()):
                self._tell(PUBLISH)
                return
            if self.is_paused:
                self._tell()
                seconds = inf
                continue
            left = self.pace.left(now)
            self._is_in_time = True
            self._tell(PUBLISH)
            if left < SHORT:
                self._is_in_time = False
                return
            seconds = min(left, PUBLISH)

    @property
    def _is_between(self) -> bool:
        """True if the run is stopped between two events."""
        return bool(self.stopped) or self.question is not None

    def _rests(self) -> bool:
        assert self.machine is not None
        return self.watch.is_at_rest(self.machine)

    def _is_elsewhere(self) -> bool:
        """True if this rest is another one than that from which a run to the next rest began."""
        assert self.machine is not None
        return self.watch.news >= self._seeks_rest or self.watch.awaited(self.machine) != self._awaited

    def _stop(self, task: Task, time: float, offset: int) -> None:
        """Wait before a statement, at the end of a step."""
        self.watch.limit = inf
        self.stopped[task] = offset
        self.is_paused = True
        while self.is_paused:
            self._tell()
            self._act(inf)
        self.stopped.clear()

    def _ask(self) -> str | None:
        """Return the recorded answer to an INPUT, or that of a person."""
        assert self.machine is not None
        answers = self.record.answers
        if self._answered == len(answers):
            self.question, self.asks = self.machine.operator.question, next(self._actions.questions)
            while self._answer is None:
                self._tell()
                self._act(inf)
            answers.append((self.now, self._answer))
            self.question = self._answer = None
            self.pace.restart()
        self._answered += 1
        return answers[self._answered - 1][1]

    def _make_until(self, time: float) -> None:
        """Make the recorded changes up to a time."""
        changes = self.record.changes
        while self._made < len(changes) and changes[self._made][0] <= time:
            self._made += 1
            change = changes[self._made - 1][1]
            self.asked.append(self._asked_for(change))
            self._make(change)

    def _asked_for(self, change: Change) -> float | None:
        """Return how long the program has asked for a change, s, None if it does not ask for it."""
        assert self.machine is not None
        controller = self.machine.controller
        if change.table == "input" and controller.inputs.present(change.number) == change.value:
            return None
        number = CONSOLE if change.table == "key" else change.number
        since = controller.answering().asked_since(change.table, number)
        return None if since is None else self.now - since

    def _make(self, change: Change) -> None:
        assert self.machine is not None
        inputs, asking = self.machine.controller.inputs, self.machine.controller.answering()
        if change.table == RELEASE:
            self.held.discard(change.number)
            asking.let_go("input", change.number)
            if change.number + SHADOW in dict(inputs.values):
                inputs[change.number] = inputs.present(change.number + SHADOW)
            return
        if change.table == "input" and change.number in self.driven:
            self.held.add(change.number)
            asking.hold("input", change.number)
        self.machine.add_entries(tables_of(((self.now, change),), self.now))

    def _act(self, seconds: float = 0.0) -> bool:
        """Do what pages have asked for, and wait for that at most so many seconds; True if there was anything.

        Raises Abandoned if that has ended the run.
        """
        any_came = False
        while (action := self._actions.take(0.0 if any_came else seconds)) is not None:
            action(self)
            any_came = True
            if self._is_abandoned:
                raise Abandoned
        return any_came

    def _tell(self, every: float = 0.0) -> None:
        """Publish the state, unless it was published less than `every` seconds of real time ago."""
        real = monotonic()
        if real - self._published >= every:
            self._published = real
            self._publish(self)


# What a page has asked a run for.
Action = Callable[[Play], object]
