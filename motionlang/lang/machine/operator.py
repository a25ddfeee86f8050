"""The operator at the terminal: keys that are pressed and lines that are typed, from the machine file or for real.

A key of the machine file is an event of the clock, so that a wait for one need not poll. Lines are there from the
beginning and are taken when the program asks. A live operator's keys make a line while the program asks for one.
"""

from __future__ import annotations

from functools import partial

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from motionlang.controller.clock import Clock
    from motionlang.lang.machine.terminal import Terminal

    Entry = Mapping[str, object]

# How long a key is held, in seconds, as long as nothing else is said.
HELD = 0.1
# More than anybody types ahead.
MOST_KEYS = 10_000
_ENTER, _BACK = "\r\n", "\b\x7f"


class Operator:
    """`keys` that the program has not read yet, `lines` that it has not asked for yet.

    `asking` is set by the program while it waits for a line; `number` is that of the terminal.
    """

    def __init__(
        self, clock: Clock, terminal: Terminal, settings: Mapping[str, object], number: int = 1
    ) -> None:
        self._clock, self._terminal = clock, terminal
        self.keys: list[int] = []
        self.listeners: list[Callable[[], None]] = []  # called when keys have been pressed
        self.asking = False
        self._typed = ""
        self._held, self._until = 0, -1.0
        answers: Sequence[Entry] = settings.get("answer", ())  # type: ignore[assignment]
        self.lines = [str(each["text"]) for each in answers if each.get("terminal", 1) == number]
        presses: Sequence[Entry] = settings.get("key", ())  # type: ignore[assignment]
        for entry in presses:
            if entry.get("terminal", 1) != number:
                continue
            time: float = entry.get("at", 0.0)  # type: ignore[assignment]
            held: float = entry.get("for", HELD)  # type: ignore[assignment]
            clock.at(max(time, clock.now), partial(self.press, str(entry["text"]), held))

    def press(self, text: str, held: float = HELD) -> None:
        """Keys are pressed one after the other; the last one is held for a while."""
        codes = [ord(each) & 0xFF for each in text]
        if not codes or len(self.keys) + len(codes) > MOST_KEYS:
            return
        self.keys += codes
        self._held, self._until = codes[-1], self._clock.now + held
        self._clock.at(self._until, _nothing)  # whoever waits for the key to be let go must look again
        for listener in self.listeners:
            listener()

    def next_key(self) -> int:
        """The next key that has been pressed, 0 where there is none."""
        return self.keys.pop(0) if self.keys else 0

    def held_key(self) -> int:
        """The key that is held down now, 0 where none is."""
        return self._held if self._clock.now < self._until else 0

    def type(self, text: str) -> None:
        """A live operator types: keys for the program, or a line while it asks for one."""
        for letter in text:
            if not self.asking:
                self.press(letter)
            elif letter in _ENTER:
                self._echo("\b \b" * len(self._typed))  # the program shows the line itself
                self.lines.append(self._typed)
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
    """A moment at which something may have changed."""
