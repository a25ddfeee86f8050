"""The session that all pages of a panel share: the present run, its state, and the actions of its users."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future
from functools import partial
from math import floor, isfinite
from operator import itemgetter
from time import monotonic
from typing import Any

from motionlang.cli.command import Refused
from motionlang.kernel import Program, ProgramError, Run, Source, dialect
from motionlang.kernel.files import reason
from motionlang.kernel.lang import first_mistake
from motionlang.kernel.tools import count_of
from motionlang_explore.exploration import TABLES, TEXTS, Change, FoundSwitches, tables_of
from motionlang_explore.identification import Entry, in_words
from motionlang_explore.panel.play import PER_SECOND, RELEASE, Action, ActionQueue, Play, PlayRecord
from motionlang_explore.panel.play import in_words as change_in_words
from motionlang_explore.panel.presses import Presses
from motionlang_explore.panel.roles import NO_ROLES, Roles
from motionlang_explore.panel.rule import rules
from motionlang_explore.panel.scenario import NotSaved, save
from motionlang_explore.panel.state import Data, contents, state_of, warnings_of

# Reads the program and its machine file again; raises Refused or ProgramError.
Load = Callable[[], tuple[Program, Mapping[str, object]]]
# Explores a program in another process.
Explore = Callable[[Source, Mapping[str, object]], Future[Roles]]
# Characters of output that a page that is opened later is sent, and entries of the record.
MAX_TEXT, MAX_RECORD = 100_000, 100
# Characters of an answer.
MAX_LINE = 200
MIN_SPEED, MAX_SPEED = 0.1, 100.0
# Real time between two checks of the files and of the buttons that pages press, s.
CHECK = 0.5
# Real time after which a page that is opened does not show a notice any more, s.
NOTICE = 10.0


class WrongAction(ValueError):
    """A page has asked for what cannot be done."""


class Cursor:
    """The data that a page has: numbers of the run and its contents, characters of output, the record, the notice."""

    def __init__(self) -> None:
        self.run = self.contents = self.text = self.notice = self.state = -1
        self.record = -1, -1


class PanelSession:
    """The run that the pages show; `act` is called with what a page asks for.

    `file` is the path of the program, `watched` are the files that are checked for changes. All that is done to the run
    is done in its thread, in the order in which pages asked for it, and so is replacing it by another run.
    """

    _play: Play

    def __init__(
        self,
        load: Load,
        file: str,
        watched: Sequence[str],
        overrides: Mapping[str, float | str],
        explore: Explore | None = None,
    ) -> None:
        self._load, self._file, self._watched, self._overrides = load, file, watched, overrides
        # What a person has let the panel add to the machine file: switches of axes, and rules of inputs by number.
        self._switches: dict[str, object] = {}
        self._followers: dict[int, Entry] = {}
        self._explore = explore
        # The program that is explored, what is known of it, and the kinds of inputs that a person has chosen.
        self._explored: Program | None = None
        self._roles = NO_ROLES
        self._chosen: dict[int, str] = {}
        self._actions = ActionQueue()
        self.presses = Presses(self._press)
        # Held for what follows, which the threads of the pages read.
        self._news = threading.Condition()
        self._contents: Data = {}
        self._state: Data = {}
        # The numbers of the last state, run and notice, and the length of the output with what is not stored any more.
        self._states = self._runs = self._made = self._notices = 0
        self._text, self._length = "", 0
        # The rules behind the inputs of the record, for so many entries of it.
        self._rules: dict[int, Entry] = {}
        self._explained = -1
        self._notice, self._said = "", 0.0
        # How often the run has warned, as far as the pages know.
        self._warned = 0
        # The state of the files that the program was read from, and that of which the pages know.
        self._read = self._noticed = self._stamps()
        program, settings = load()
        self._begin(program, settings, PlayRecord())

    def _begin(
        self,
        program: Program,
        settings: Mapping[str, object],
        record: PlayRecord,
        until: float = 0.0,
        notice: str = "",
        *,
        speed: float = 1.0,
        goes_on: bool = True,
    ) -> None:
        """Begin another run, from now on the present one; its first state brings the notice."""
        play = Play(
            program,
            settings,
            self._overrides,
            record,
            self._actions,
            self._publish,
            until=until,
            speed=speed,
            goes_on=goes_on,
        )
        with self._news:
            self._play, self._runs = play, self._runs + 1
            self._show_contents()
            # Nothing of the run before is shown as the state of this one.
            self._state, self._text, self._length = {}, "", 0
            self._explained, self._rules, self._warned = -1, {}, 0
            self.say(notice)
        play.start()

    def _show_contents(self) -> None:
        """Let the pages have the contents of the present run, as far as its program has been explored."""
        program, settings = self._play.program, self._play.settings
        with self._news:
            roles = self._roles._replace(kinds={**self._roles.kinds, **self._chosen})
            self._contents = contents(program, dialect(program.language), settings, roles)
            self._made += 1
            self._states += 1
            self._news.notify_all()

    def explore(self) -> None:
        """Explore the present program, unless that has been done; the pages have the result when it is there."""
        program, settings = self._play.program, self._play.settings
        if self._explore is None or self._explored is program:
            return
        self._explored = program

        def found(future: Future[Roles]) -> None:
            if self._explored is program and not future.cancelled() and future.exception() is None:
                self._roles = future.result()
                self._show_contents()

        self._explore(program.source, settings).add_done_callback(found)

    def close(self) -> None:
        """End the run."""
        self._actions.post(Play.abandon)
        play: Play | None = None
        while play is not self._play:  # it may just be replaced
            play = self._play
            play.join(1.0)

    # ------------------------------------------------------------------------------------------- for the pages

    def _publish(self, play: Play) -> None:
        """Store the state of the present run for the pages; called in its thread."""
        state = state_of(play, self._contents)
        explained, found = self._explained, self._rules
        if play.machine is not None and play.now >= play.until and explained != len(play.record):
            mine = [each for each in play.record.changes if each[1].number not in play.driven]
            made = zip(play.record.changes, play.asked, strict=False)
            asked = {(each.number, time): since for (time, each), since in made if since is not None}
            explained, found = len(play.record), rules(mine, play.machine, asked)
        warned, warning = warnings_of(play)
        new = "".join(play.text)
        play.text.clear()
        with self._news:
            self._explained, self._rules = explained, found
            self._length += len(new)
            self._text = (self._text + new)[-MAX_TEXT:]
            self._state, self._states = state, self._states + 1
            if warned > self._warned:
                self._warned = warned
                self.say(warning)
            self._news.notify_all()

    def updates(self, cursor: Cursor, seconds: float) -> Data | None:
        """Return what is new to a page, after at most so many seconds; None if nothing is."""

        def is_news() -> bool:
            return bool(self._state) and (cursor.state, cursor.notice) != (self._states, self._notices)

        with self._news:
            if not self._news.wait_for(is_news, seconds):
                return None
            found: Data = {"state": self._state}
            if cursor.contents != self._made:
                found["contents"], cursor.contents = self._contents, self._made
            found["begins"] = cursor.run != self._runs
            if found["begins"]:
                cursor.run, cursor.text, cursor.record = self._runs, 0, (-1, -1)
            missing = self._length - cursor.text
            found["text"] = self._text[-missing:] if missing else ""
            record = self._play.record
            if cursor.record != (len(record), self._explained):
                cursor.record = len(record), self._explained
                found["record"] = _entries(record)
                found["rules"] = {number: in_words(entry) for number, entry in self._rules.items()}
            found["changed"] = self._noticed != self._read
            if cursor.notice != self._notices and monotonic() < self._said + NOTICE:
                found["notice"] = self._notice
            cursor.text, cursor.state, cursor.notice = self._length, self._states, self._notices
            return found

    def say(self, notice: str) -> None:
        """Show a sentence on all pages."""
        with self._news:
            self._notice, self._notices, self._said = notice, self._notices + 1, monotonic()
            self._news.notify_all()

    def watch(self, over: threading.Event) -> None:
        """Take note of changes of the program and its machine file, and of pages that are gone, until `over`."""
        while not over.wait(CHECK):
            self.presses.expire()
            self.explore()
            stamps = self._stamps()
            with self._news:
                if stamps == self._noticed:
                    continue
                self._noticed = stamps
                name = os.path.basename(self._file)
                self.say(f"{name} or its machine file has changed" if stamps != self._read else "")

    def _stamps(self) -> list[tuple[int, int] | None]:
        return [_stamp(each) for each in self._watched]

    # ---------------------------------------------------------------------------------------- what pages ask for

    def act(self, request: Mapping[str, Any]) -> None:
        """Let the run do what a page asks for; raise WrongAction if that is not possible."""
        if request.get("do") == "press":
            numbers = request.get("numbers")
            if not isinstance(numbers, (list, tuple)):
                raise WrongAction("numbers must be a list")
            pressed = [
                self._change({"table": "input", "number": each, "value": 1}).number for each in numbers
            ]
            self.presses.put(str(request.get("page")), _whole(request, "message"), pressed)
        else:
            self._actions.post(self._action(request))

    def _press(self, number: int, is_down: bool) -> None:
        self._actions.post(partial(Play.press, number=number, is_down=is_down))

    def _action(self, request: Mapping[str, Any]) -> Action:
        match request.get("do"):
            case "pause":
                return Play.pause
            case "run":
                return Play.go_on
            case "step":
                return Play.step
            case "rest":
                return Play.seek_rest
            case "speed":
                speed = _number(request, "speed")
                if not MIN_SPEED <= speed <= MAX_SPEED:
                    raise WrongAction(f"the speed is {MIN_SPEED:g} to {MAX_SPEED:g}")
                return lambda play: play.pace.set_speed(speed)
            case "change":
                change = self._change(request)
                return lambda play: play.change(change)
            case "reply":
                text = str(request.get("text", ""))
                if len(text) > MAX_LINE or not text.isprintable():
                    raise WrongAction(f"an answer is one line of at most {MAX_LINE} characters")
                return partial(self._reply, text=text, question=_whole(request, "question"))
            case "back":
                time = _number(request, "time")
                if time < 0.0:
                    raise WrongAction("the run begins at 0 s: choose 0 or later")
                return partial(self._go_back, time=time)
            case "restart":
                return self._restart(keeps=bool(request.get("keep")))
            case "switch":
                return self._put_switch
            case "rule":
                number = _whole(request, "number")
                entry = self._rules.get(number)
                if entry is None:
                    raise WrongAction(f"nothing explains the changes of input {number}")
                return partial(self._follow, number=number, entry=entry)
            case "kind":
                number, kind = _whole(request, "number"), str(request.get("kind"))
                if kind not in ("switch", "button"):
                    raise WrongAction(f"an input is a switch or a button, not {kind}")
                return partial(self._choose, number=number, kind=kind)
            case "save":
                return self._save
        raise WrongAction("unknown action")

    def _change(self, request: Mapping[str, Any]) -> Change:
        table, number = str(request.get("table", "")), _whole(request, "number")
        if table == RELEASE:
            if number not in self._play.driven:
                raise WrongAction(f"the machine file does not drive input {number}")
            return Change(RELEASE, number, 0.0)
        if table not in TABLES or table == "answer":
            raise WrongAction(f"{table or 'this'} cannot be changed by hand")
        value = str(request.get("value", "")) if table in TEXTS else _number(request, "value")
        if table == "input" and value not in (0, 1):
            raise WrongAction(f"an input is 1 (on) or 0 (off), not {value:g}")
        change = Change(table, number, value)
        mistake = first_mistake(tables_of(((0.0, change),)))
        if mistake:
            raise WrongAction(mistake)
        return change

    def _restart(self, *, keeps: bool) -> Action:
        """Read the files again, and return what begins a run of them."""
        stamps = self._stamps()
        try:
            program, settings = self._load()
        except (Refused, ProgramError) as error:
            first = error.diagnostics[0]
            where = f"line {first.line}: " if first.line else ""
            raise WrongAction(f"not restarted: {where}{first.message}") from None

        def begin(play: Play) -> None:
            with self._news:
                self._read = self._noticed = stamps
            record, until = (play.record, play.moment) if keeps else (PlayRecord(), 0.0)
            with_them = f", with {count_of(len(record), 'action')} up to {until:.2f} s" if keeps else ""
            notice, completed = f"started again{with_them}", self._completed(settings)
            self._replace(play, record, until, notice, program=program, settings=completed)

        return begin

    # ------------------------------------------------------------------------- actions, in the thread of the run

    def _replace(
        self,
        play: Play,
        record: PlayRecord,
        until: float,
        notice: str,
        *,
        program: Program | None = None,
        settings: Mapping[str, object] | None = None,
        goes_on: bool = True,
    ) -> None:
        """Begin another run in place of the present one, at the same speed.

        From here on the thread of the other run carries out the actions, so `notice` comes with its first state.
        """
        play.abandon()
        self._begin(
            play.program if program is None else program,
            play.settings if settings is None else settings,
            record,
            until,
            notice,
            speed=play.pace.speed,
            goes_on=goes_on,
        )
        self._actions.post(self._hands_on)

    def _hands_on(self, play: Play) -> None:
        """Let the buttons of a new run be down where hands are on them, and up where none are any more."""
        down = self.presses.down
        for number in sorted(down | play.record.pressed):
            play.press(number, is_down=number in down)

    def _choose(self, play: Play, number: int, kind: str) -> None:
        """Let an input be a switch or a button from now on."""
        self._chosen[number] = kind
        self._show_contents()

    def _reply(self, play: Play, text: str, question: int) -> None:
        if not play.reply(text, question):
            self.say(f'the answer "{text}" came too late: its question has been answered')

    def _go_back(self, play: Play, time: float) -> None:
        time = min(floor(time * PER_SECOND + 1e-6) / PER_SECOND, play.moment)
        record = play.record.until(time)
        cut = len(play.record) - len(record)
        cut_off = f": {count_of(cut, 'later action')} cut off" if cut else ""
        self._replace(play, record, time, f"back at {time:g} s{cut_off}", goes_on=False)

    def _put_switch(self, play: Play) -> None:
        """Put a switch where an axis looks for one."""
        switches = FoundSwitches(play.settings.keys())
        if play.machine is None or not switches.add(
            Run(play.program.source, dialect(play.program.language), play.machine)
        ):
            return
        self._switches |= switches.settings
        words = ", ".join(f"{key} = {value}" for key, value in switches.settings.items())
        self._repeat(play, play.record, f" with {words}")

    def _follow(self, play: Play, number: int, entry: Entry) -> None:
        """Let an input follow the output that explains what a hand did to it."""
        self._followers[number] = entry
        mine = ("input", number), (RELEASE, number)
        changes = [each for each in play.record.changes if (each[1].table, each[1].number) not in mine]
        record = PlayRecord(changes, play.record.answers)
        self._repeat(play, record, f": input {number} {in_words(entry)}")

    def _repeat(self, play: Play, record: PlayRecord, how: str) -> None:
        """Repeat the run up to the present moment with what the machine file lacked."""
        settings = self._completed(play.settings)
        goes_on = not play.is_paused
        self._replace(play, record, play.moment, f"repeated{how}", settings=settings, goes_on=goes_on)

    def _completed(self, settings: Mapping[str, object]) -> dict[str, object]:
        """Return the settings of a machine with the switches and the rules that a person has added."""
        given: Sequence[Entry] = settings.get("input", ())  # type: ignore[assignment]
        others = [each for each in given if each["channel"] not in self._followers]
        added = {"input": [*others, *self._followers.values()]} if self._followers else {}
        return {**settings, **self._switches, **added}

    def _save(self, play: Play) -> None:
        """Write the run so far as a scenario."""
        try:
            saved = save(self._file, play)
        except NotSaved as error:
            self.say(f"not saved: {error}")
        except OSError as error:
            self.say(f"not saved: {error.filename}: {reason(error)}")
        else:
            differs = f", but its run differs: {saved.difference}" if saved.difference else ""
            self.say(f"saved {saved.path}{differs}; motionlang verify {self._file} runs it")
        play.pace.restart()


def _entries(record: PlayRecord) -> list[tuple[float, str]]:
    """Return the last entries of a record in words, with their times."""
    words = [(time, change_in_words(change)) for time, change in record.changes[-MAX_RECORD:]]
    words += [(time, f"answer {text}") for time, text in record.answers[-MAX_RECORD:]]
    return sorted(words, key=itemgetter(0))[-MAX_RECORD:]


def _number(request: Mapping[str, Any], key: str) -> float:
    value = request.get(key)
    if not isinstance(value, (int, float)) or not isfinite(value):
        raise WrongAction(f"{key} must be a number")
    return value


def _whole(request: Mapping[str, Any], key: str) -> int:
    value = _number(request, key)
    if value != int(value):
        raise WrongAction(f"{key} must be a whole number")
    return int(value)


def _stamp(path: str) -> tuple[int, int] | None:
    try:
        found = os.stat(path)
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size
