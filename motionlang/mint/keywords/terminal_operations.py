"""Terminals: where the program prints, and the keys and lines that come from there.

A terminal is a bit: 1, 2, 4 … 128. TERMINAL is a pattern of them, which each task has for itself; event handlers share
that of the parent task. Terminal 1 is the console.
"""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.lang.machine.machine import CONSOLE
from motionlang.mint.runtime.binding import of
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.environment import Environment
from motionlang.mint.runtime.input_values import take, wait_for_answer

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.task import Wait
    from motionlang.mint.runtime.binding import Maker, Operation, Row

# All terminals that there can be, and what stands for those of TERMINAL.
ALL = 255
CURRENT = -1


class Terminals:
    """Which terminals each task prints to."""

    def __init__(self, environment: Environment) -> None:
        self._environment, self._machine = environment, environment.machine
        # By what counts the TIME of a task: handlers share it with the parent, and with it the terminals.
        self._chosen: dict[int, tuple[object, int]] = {}

    @property
    def current(self) -> int:
        """TERMINAL of the task that runs."""
        return self._chosen.get(id(self._environment.task.timer), (None, CONSOLE))[1]

    def choose(self, pattern: int) -> None:
        """TERMINAL: the terminals that PRINT speaks to, a bit each."""
        timer = self._environment.task.timer
        self._chosen[id(timer)] = timer, pattern

    def bits(self, pattern: int) -> list[int]:
        """The terminals of a pattern."""
        if pattern == CURRENT:
            pattern = self.current
        elif not 1 <= pattern <= ALL:
            raise Refusal(
                "terminal", f"there is no terminal {pattern}", "they are 1, 2, 4 and so on up to 128"
            )
        return [1 << k for k in range(8) if pattern >> k & 1]

    def one(self, pattern: int) -> int:
        """The only terminal of a pattern."""
        found = self.bits(pattern)
        if len(found) != 1:
            known = " and ".join(map(str, found)) or "none"
            raise Refusal("one-terminal", f"the program asks at one terminal, not at {known}", "TERMINAL = 1")
        return found[0]

    def write(self, text: str, pattern: int = CURRENT) -> None:
        """Print on the terminals of a pattern, or on those that TERMINAL has chosen."""
        self._environment.acts += 1
        if not self._chosen and pattern == CURRENT:
            self._machine.terminal.write(text)
            return
        for number in self.bits(pattern):
            self._machine.terminal_at(number).write(text)


def _pattern(number: int) -> int:
    """What a word means by the number of a terminal: 0, as where none is given, those of TERMINAL."""
    return number or CURRENT


def writing(text: str) -> Maker:
    """What writes a text to a terminal."""
    return of(Terminals, lambda terminals, number: terminals.write(text, _pattern(number)))


def do_locate(terminals: Terminals, column: int, row: int) -> None:
    terminals.write(f"\x1b[{max(row, 1)};{max(column, 1)}H")


# ------------------------------------------------------------------------------------------------------- keys


def read_key(environment: Environment, row: Row) -> Operation:
    """INKEY."""
    terminals, operator_at = environment.part(Terminals), environment.machine.operator_at
    for entry in environment.machine.settings.get("key", ()):  # type: ignore[attr-defined]
        operator_at(entry.get("terminal", CONSOLE))  # keys are pressed also while the program asks elsewhere

    def read(number: int) -> int:
        for each in terminals.bits(_pattern(number)):
            key = operator_at(each).next_key()
            if key:
                environment.acts += 1
                return key
        return 0

    return read


def ask(environment: Environment, count: float, number: int) -> Wait:
    """The wait for an answer at a terminal."""
    environment.acts += 1
    return wait_for_answer(environment, environment.statements.leave(count), number)


def read_held_key(environment: Environment, row: Row) -> Operation:
    """READKEY."""
    return environment.machine.operator.held_key


OPERATIONS = {
    "terminal.terminal": {
        "read": of(Terminals, lambda terminals: terminals.current),
        "write": repeatable(of(Terminals, Terminals.choose)),
    },
    "terminal.key": {"read": read_key},
    "terminal.held_key": {"read": read_held_key},
    "terminal.clear_screen": {"do": writing("\x1b[2J\x1b[H")},
    "terminal.locate": {"do": of(Terminals, do_locate)},
    "terminal.line_start": {"do": writing("\r")},
    "terminal.beep": {"do": writing("\a")},
    # An INPUT: the one terminal at which it asks, the wait for the answer, and that.
    "terminal.place": {"read": of(Terminals, Terminals.one)},
    "terminal.question": {"read": of(Environment, ask)},
    "terminal.answer": {"read": of(Environment, take)},
    # What prints a text on the terminals of TERMINAL, or on those of a pattern.
    "terminal.printer": {"read": of(Terminals, Terminals.write)},
}
