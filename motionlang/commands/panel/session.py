"""The session that all pages of a panel share: the present run, its state, and the actions of its users."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Mapping, Sequence
from math import floor, isfinite
from typing import Any

from motionlang.cli.command import Refused
from motionlang.commands.explore import TABLES, Change, Entry
from motionlang.commands.explore.switches import FoundSwitches
from motionlang.commands.explore.trials import TEXTS, tables_of
from motionlang.commands.panel.play import PER_SECOND, RELEASE, Play, PlayRecord
from motionlang.commands.panel.rule import in_words, rules
from motionlang.commands.panel.scenario import NotSaved, save
from motionlang.commands.panel.state import Data, contents, state_of
from motionlang.kernel import Program, ProgramError, Run, dialect
from motionlang.kernel.lang import first_mistake

# Reads the program and its machine file again; raises Refused or ProgramError.
Load = Callable[[], tuple[Program, Mapping[str, object]]]
# Characters of output that a page that is opened later is sent, and entries of the record.
MAX_TEXT, MAX_RECORD = 100_000, 100
# Characters of an answer.
MAX_LINE = 200
MIN_SPEED, MAX_SPEED = 0.1, 100.0
# Real time between two checks of the files, s.
CHECK = 1.0


class WrongAction(ValueError):
    """A page has asked for what cannot be done."""


class Cursor:
    """The data that a page has: the number of the run, the characters of its output, the record, the notice."""

    def __init__(self) -> None:
        self.run = self.text = self.notice = self.state = -1
        self.record = -1, -1


class PanelSession:
    """The run that the pages show; `act` is called with what a page asks for.

    `file` is the path of the program, `watched` are the files that are checked for changes.
    """

    def __init__(
        self, load: Load, file: str, watched: Sequence[str], overrides: Mapping[str, float | str]
    ) -> None:
        self._load, self._file, self._watched, self._overrides = load, file, watched, overrides
        self.program, self.settings = load()
        # What a person has let the panel add to the machine file: switches of axes, and rules of inputs.
        self._given: dict[str, object] = {}
        self._contents = self._made()
        self._news = threading.Condition()
        self._acts = threading.Lock()
        self._state: Data = {}
        # The numbers of the last state, run and notice, and the length of the output with what is not stored any more.
        self._states = self._runs = self._notices = 0
        self._text, self._length = "", 0
        # The rules behind the inputs of the record, for so many entries of it.
        self._rules: dict[int, Entry] = {}
        self._explained = -1
        self._notice = ""
        self._seen = self._stamps()
        self._is_changed = False
        self._play = self._new(PlayRecord())
        self._play.start()

    def _made(self) -> Data:
        return contents(self.program, dialect(self.program.language), self.settings)

    def _new(self, record: PlayRecord, until: float = 0.0, *, goes_on: bool = True) -> Play:
        """Return another run, from now on the present one, which ends the one before."""
        before: Play | None = getattr(self, "_play", None)
        if before is not None:
            before.abandon()
        speed = 1.0 if before is None else before.speed
        self._play = Play(
            self.program,
            self.settings,
            self._overrides,
            record,
            self._publish,
            until=until,
            speed=speed,
            goes_on=goes_on,
        )
        with self._news:
            self._runs, self._explained, self._rules = self._runs + 1, -1, {}
            # Nothing of the run before is shown as the state of this one.
            self._state, self._text, self._length = {}, "", 0
        return self._play

    def close(self) -> None:
        """End the run."""
        self._play.abandon()
        self._play.join(1.0)

    # ------------------------------------------------------------------------------------------- for the pages

    def _publish(self, play: Play) -> None:
        """Store the state of a run for the pages; called in its thread."""
        state = state_of(play, self._contents)
        is_there = play.machine is not None and play.now >= play.until and play is self._play
        if is_there and self._explained != len(play.record):
            mine = [each for each in play.record.changes if each[1].number not in play.driven]
            assert play.machine is not None
            self._explained, self._rules = len(play.record), rules(mine, play.machine)
        with self._news:
            if play is not self._play:
                return
            new = "".join(play.text)
            play.text.clear()
            self._length += len(new)
            self._text = (self._text + new)[-MAX_TEXT:]
            self._state, self._states = state, self._states + 1
            self._news.notify_all()

    def updates(self, cursor: Cursor, seconds: float) -> Data | None:
        """Return what is new to a page, after at most so many seconds; None if nothing is."""

        def is_news() -> bool:
            return bool(self._state) and (cursor.state, cursor.notice) != (self._states, self._notices)

        with self._news:
            if not self._news.wait_for(is_news, seconds):
                return None
            found: Data = {"state": self._state}
            if cursor.run != self._runs:
                found["contents"] = {**self._contents, "run": self._runs}
                cursor.run, cursor.text, cursor.record = self._runs, 0, (-1, -1)
            missing = self._length - cursor.text
            found["text"] = self._text[-missing:] if missing else ""
            record = self._play.record
            if cursor.record != (len(record), self._explained):
                cursor.record = len(record), self._explained
                found["record"] = _in_words(record)
                found["rules"] = {number: in_words(entry) for number, entry in self._rules.items()}
            found["changed"] = self._is_changed
            if cursor.notice != self._notices:
                found["notice"] = self._notice
            cursor.text, cursor.state, cursor.notice = self._length, self._states, self._notices
            return found

    def say(self, notice: str) -> None:
        """Show a sentence on all pages."""
        with self._news:
            self._notice, self._notices = notice, self._notices + 1
            self._news.notify_all()

    def watch_files(self, over: threading.Event) -> None:
        """Take note of changes of the program and its machine file until `over`."""
        while not over.wait(CHECK):
            is_changed = self._stamps() != self._seen
            if is_changed != self._is_changed:
                self._is_changed = is_changed
                self.say(
                    f"{os.path.basename(self._file)} or its machine file has changed" if is_changed else ""
                )

    def _stamps(self) -> list[tuple[int, int] | None]:
        return [_stamp(each) for each in self._watched]

    # ---------------------------------------------------------------------------------------- what pages ask for

    def act(self, request: Mapping[str, Any]) -> None:
        """Do what a page asks for; raise WrongAction if that is not possible."""
        with self._acts:
            act = self._handlers().get(str(request.get("do", "")))
            if act is None:
                raise WrongAction("unknown action")
            act(request)

    def _handlers(self) -> dict[str, Callable[[Mapping[str, Any]], object]]:
        play = self._play
        return {
            "pause": lambda request: play.post(play.pause),
            "run": lambda request: play.post(play.go_on),
            "step": lambda request: play.post(play.step),
            "rest": lambda request: play.post(play.seek_rest),
            "speed": self._set_speed,
            "change": self._change,
            "reply": self._reply,
            "back": lambda request: self._go_back(_number(request, "time")),
            "restart": lambda request: self._restart(bool(request.get("keep"))),
            "switch": lambda request: play.post(self._put_switch),
            "rule": lambda request: self._follow(int(_number(request, "number"))),
            "save": lambda request: play.post(self._save),
        }

    def _set_speed(self, request: Mapping[str, Any]) -> None:
        speed, play = _number(request, "speed"), self._play
        if not MIN_SPEED <= speed <= MAX_SPEED:
            raise WrongAction(f"the speed is {MIN_SPEED:g} to {MAX_SPEED:g}")
        play.post(lambda: play.set_speed(speed))

    def _change(self, request: Mapping[str, Any]) -> None:
        table, number, play = str(request.get("table", "")), int(_number(request, "number")), self._play
        if table == RELEASE:
            if number not in play.driven:
                raise WrongAction(f"the machine file does not drive input {number}")
            change = Change(RELEASE, number, 0.0)
        elif table in TABLES and table != "answer":
            value = str(request.get("value", "")) if table in TEXTS else _number(request, "value")
            change = Change(table, number, value)
            mistake = first_mistake(tables_of(((0.0, change),)))
            if mistake:
                raise WrongAction(mistake)
        else:
            raise WrongAction(f"nothing changes {table or 'this'}")
        play.post(lambda: play.change(change))

    def _reply(self, request: Mapping[str, Any]) -> None:
        text, play = str(request.get("text", "")), self._play
        if len(text) > MAX_LINE or not text.isprintable():
            raise WrongAction("this is no line")
        play.post(lambda: play.reply(text))

    def _go_back(self, time: float) -> None:
        before = self._play
        time = floor(time * PER_SECOND + 1e-6) / PER_SECOND
        record = before.record.until(time)
        cut = len(before.record) - len(record)
        self._new(record, min(time, before.now), goes_on=False).start()
        if cut:
            self.say(f"back at {time:g} s: {_actions(cut)} after it cut off")
        else:
            self.say(f"back at {time:g} s")

    def _restart(self, keeps: bool) -> None:
        stamps, before = self._stamps(), self._play
        try:
            self.program, settings = self._load()
        except (Refused, ProgramError) as error:
            first = error.diagnostics[0]
            where = f"line {first.line}: " if first.line else ""
            raise WrongAction(f"the old program stays: {where}{first.message}") from None
        self.settings = {**settings, **self._given}
        self._seen, self._is_changed = stamps, False
        self._contents = self._made()
        if keeps:
            self._new(before.record.until(before.now), before.now).start()
            self.say(f"started again, with {_actions(len(before.record))} up to {before.now:.2f} s")
        else:
            self._new(PlayRecord()).start()
            self.say("started again")

    def _put_switch(self) -> None:
        """Put a switch where an axis looks for one; called in the thread of the run."""
        play, machine = self._play, self._play.machine
        if machine is None:
            return
        switches = FoundSwitches(self.settings.keys())
        if not switches.add(Run(self.program.source, dialect(self.program.language), machine)):
            return
        self._given |= switches.settings
        self.settings = {**self.settings, **switches.settings}
        words = ", ".join(f"{key} = {value}" for key, value in switches.settings.items())
        self._new(play.record, play.now, goes_on=not play.is_paused).start()
        self.say(f"repeated with {words}")

    def _follow(self, number: int) -> None:
        """Let an input follow the output that explains what a hand did to it, and repeat the run."""
        play, entry = self._play, self._rules.get(number)
        if entry is None:
            raise WrongAction(f"no output explains the changes of input {number}")
        given = self.settings.get("input", ())
        others = [each for each in given if each["channel"] != number]  # type: ignore[attr-defined]
        self._given = {**self._given, "input": [*others, entry]}
        self.settings = {**self.settings, **self._given}
        self._contents = self._made()
        changes = [
            each
            for each in play.record.changes
            if (each[1].table, each[1].number) not in (("input", number), (RELEASE, number))
        ]
        self._new(PlayRecord(changes, play.record.answers), play.now, goes_on=not play.is_paused).start()
        self.say(f"repeated: input {number} {in_words(entry)}")

    def _save(self) -> None:
        """Write the run so far as a scenario; called in the thread of the run."""
        try:
            saved = save(self._file, self.program, self.settings, self._overrides, self._play)
        except NotSaved as error:
            self.say(f"not saved: {error}")
        except OSError as error:
            self.say(f"not saved: {error.strerror}: {error.filename}")
        else:
            differs = f", but its run differs: {saved.difference}" if saved.difference else ""
            self.say(f"saved {saved.path}{differs}; motionlang verify {self._file} runs it")


def _in_words(record: PlayRecord) -> list[tuple[float, str]]:
    """Return the last entries of a record in words, with their times."""
    words = [(time, _word(change)) for time, change in record.changes[-MAX_RECORD:]]
    words += [(time, f"answer {text}") for time, text in record.answers[-MAX_RECORD:]]
    return sorted(words)[-MAX_RECORD:]


def _word(change: Change) -> str:
    return f"input {change.number} let go" if change.table == RELEASE else str(change)


def _actions(count: int) -> str:
    return f"{count} action{'s' * (count != 1)}"


def _number(request: Mapping[str, Any], key: str) -> float:
    value = request.get(key)
    if not isinstance(value, (int, float)) or not isfinite(value):
        raise WrongAction(f"{key} is a number")
    return value


def _stamp(path: str) -> tuple[int, int] | None:
    try:
        found = os.stat(path)
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size
