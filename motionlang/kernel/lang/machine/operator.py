"""The operator at the terminal, from the machine file or live.

A key in the machine file is an event of the clock, so that a wait for it need not poll. Lines in the machine
file are available from the start and consumed when the program asks for one. The keys of a live operator form
a line while the program asks for one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial

from motionlang.kernel.controller.io.asking import AskedRule, Responder
from motionlang.kernel.controller.io.reads import ReadObserver
from motionlang.kernel.controller.state import ControllerState
from motionlang.kernel.lang.machine.terminal import Terminal
from motionlang.kernel.traced import reading

Entry = Mapping[str, object]

# How long a key is held by default, in seconds.
PRESS_TIME = 0.1
# More than anyone types ahead.
MAX_KEYS = 10_000
# How keys without a character are spelt among others.
_NAMED = {"{Enter}": "\r", "{Esc}": "\x1b", "{Tab}": "\t"}
_ENTER, _BACK = "\r\n", "\b\x7f"


class Operator:
    """Keys and lines of one terminal that the program has not read yet.

    The program sets `asking` while it waits for a line. `number` is the number of the terminal.
    """

    def __init__(
        self,
        controller: ControllerState,
        terminal: Terminal,
        settings: Mapping[str, object],
        number: int = 1,
    ) -> None:
        self._clock, self._controller, self._terminal = controller.clock, controller, terminal
        self.keys: list[int] = []
        self.asking = False
        self._typed = ""
        self._held_key, self._until = 0, -1.0
        self.observer: ReadObserver | None = None
        self.traces = False
        # The lines typed ahead: the text, and the prompt that it answers ("" for any).
        self.lines: list[tuple[str, str]] = []
        self._number = number
        self.add(settings)
        controller.reads.join(self)

    def add(self, settings: Mapping[str, object], since: float = 0.0) -> None:
        """Add the `[[answer]]` and `[[key]]` entries of this terminal.

        Times of keys count from `since`.
        """
        answers: Sequence[Entry] = settings.get("answer", ())  # type: ignore[assignment]
        self.lines += [
            (str(each["text"]), str(each.get("prompt", "")))
            for each in answers
            if each.get("terminal", 1) == self._number
        ]
        presses: Sequence[Entry] = settings.get("key", ())  # type: ignore[assignment]
        for entry in presses:
            if entry.get("terminal", 1) != self._number:
                continue
            if "asked" in entry:
                asking = self._controller.answering()
                asking.add("key", self._number, entry, since, self._new_responder())
                continue
            duration: float = entry.get("for", PRESS_TIME)  # type: ignore[assignment]
            stimuli = self._controller.stimuli
            stimuli.add("key", entry, partial(self.press, str(entry["text"]), duration), since)

    def _new_responder(self) -> Responder:
        """Return what presses a key when the program asks for one, and none has been pressed or is held."""

        def has_key() -> bool:
            return bool(self.keys) or self._clock.now < self._until

        def text(rule: AskedRule) -> str | None:
            return None if has_key() else str(rule.stimulus.entry["text"])

        def put(rule: AskedRule, keys: object) -> None:
            self.press(str(keys), float(rule.stimulus.entry.get("for", PRESS_TIME)))  # type: ignore[arg-type]

        return Responder(lambda rule, keys: f"key {keys}", has_key, text, put)

    def press(self, text: str, duration: float = PRESS_TIME) -> None:
        """Press keys one after another and hold the last one for `duration` seconds."""
        for name, key in _NAMED.items():
            text = text.replace(name, key)
        codes = [ord(each) & 0xFF for each in text]
        if not codes or len(self.keys) + len(codes) > MAX_KEYS:
            return
        self.keys += codes
        self._held_key, self._until = codes[-1], self._clock.now + duration
        self._clock.at(self._until, _nothing)  # a wait for the release of the key must check again

    @staticmethod
    def typed(code: int) -> str:
        """Return the text of `--keys` that presses a key."""
        return next((f"'{name}'" for name, key in _NAMED.items() if code == ord(key)), chr(code))

    def next_key(self) -> int:
        """Return the next pressed key, or 0 if there is none."""
        if self.observer is not None:
            self.observer("key", self._number)
        key = self.keys.pop(0) if self.keys else 0
        return reading(key, "key", 0) if self.traces else key

    def held_key(self) -> int:
        """Return the key that is held down now, or 0."""
        if self.observer is not None:
            self.observer("key", self._number)
        key = self._held_key if self._clock.now < self._until else 0
        return reading(key, "key", 0) if self.traces else key

    @property
    def question(self) -> str:
        """Return the prompt of the current INPUT.

        It is the unfinished line, or the line above it if that is empty.
        """
        begun = self._terminal.begun
        if begun.strip(" ?") or not self._terminal.prints:
            return begun
        return self._terminal.prints[-1].text

    def has_answer(self) -> bool:
        """True if a line answers the current INPUT."""
        return self._matching() is not None

    def take_answer(self) -> str:
        """Remove the first line that answers the current INPUT, and return its text."""
        found = self._matching()
        assert found is not None, "an INPUT goes on when there is an answer"
        return self.lines.pop(found)[0]

    def _matching(self) -> int | None:
        if not self.lines:
            return None
        question = self.question.lower()
        named = (n for n, (_, prompt) in enumerate(self.lines) if prompt and prompt.lower() in question)
        others = (n for n, (_, prompt) in enumerate(self.lines) if not prompt)
        return next(named, next(others, None))

    def type(self, text: str) -> None:
        """Type as a live operator: keys for the program, or a line while it asks for one."""
        for letter in text:
            if not self.asking:
                self.press(letter)
            elif letter in _ENTER:
                self._echo("\b \b" * len(self._typed))  # the program shows the line itself
                self.lines.append((self._typed, ""))
                self._typed, self.asking = "", False
            elif letter in _BACK:
                self._echo("\b \b" if self._typed else "")
                self._typed = self._typed[:-1]
            else:
                self._typed += letter
                self._echo(letter)

    def _echo(self, text: str) -> None:
        if self._terminal.show is not None:
            self._terminal.show(text)


def _nothing() -> None:
    """Do nothing; an event at which something may have changed."""
