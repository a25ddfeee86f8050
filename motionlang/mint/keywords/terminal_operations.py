"""Terminals: where the program prints, and the keys and lines that come from there.

A terminal is a bit: 1, 2, 4 … 128. TERMINAL is a pattern of them, which each task has for itself; event handlers share
that of the parent task. Terminal 1 is the console.
"""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.lang.machine.machine import CONSOLE
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.input_values import take, wait_for_answer

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.task import Wait
    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment

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


# --------------------------------------------------------------------------------------------------- printing


def read_printer(environment: Environment, row: Row) -> Operation:
    """What prints a text on the terminals of TERMINAL, or on those of a pattern."""
    return environment.part(Terminals).write


def read_terminal(environment: Environment, row: Row) -> Operation:
    terminals = environment.part(Terminals)
    return lambda: terminals.current


@repeatable
def write_terminal(environment: Environment, row: Row) -> Operation:
    """TERMINAL: the terminals that PRINT speaks to, a bit each."""
    terminals = environment.part(Terminals)

    def write(pattern: int) -> None:
        terminals.choose(pattern)

    return write


def _writing(environment: Environment, text: str) -> Operation:
    terminals = environment.part(Terminals)
    return lambda number: terminals.write(text, _pattern(number))


def do_clear_screen(environment: Environment, row: Row) -> Operation:
    return _writing(environment, "\x1b[2J\x1b[H")


def do_line_start(environment: Environment, row: Row) -> Operation:
    return _writing(environment, "\r")


def do_beep(environment: Environment, row: Row) -> Operation:
    return _writing(environment, "\a")


def do_locate(environment: Environment, row: Row) -> Operation:
    terminals = environment.part(Terminals)
    return lambda column, row: terminals.write(f"\x1b[{max(row, 1)};{max(column, 1)}H")


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


def read_held_key(environment: Environment, row: Row) -> Operation:
    """READKEY."""
    return environment.machine.operator.held_key


# ------------------------------------------------------------------------------------------------------ INPUT


def read_place(environment: Environment, row: Row) -> Operation:
    """The one terminal at which an INPUT asks."""
    return environment.part(Terminals).one


def read_question(environment: Environment, row: Row) -> Operation:
    """The wait for an answer at a terminal."""

    def ask(count: float, number: int) -> Wait:
        environment.acts += 1
        return wait_for_answer(environment, environment.statements.leave(count), number)

    return ask


def read_answer(environment: Environment, row: Row) -> Operation:
    return lambda as_text, number: take(environment, as_text, number)


OPERATIONS = {
    "terminal.terminal": {"read": read_terminal, "write": write_terminal},
    "terminal.key": {"read": read_key},
    "terminal.held_key": {"read": read_held_key},
    "terminal.clear_screen": {"do": do_clear_screen},
    "terminal.locate": {"do": do_locate},
    "terminal.line_start": {"do": do_line_start},
    "terminal.beep": {"do": do_beep},
    "terminal.answer": {"read": read_answer},
    "terminal.place": {"read": read_place},
    "terminal.printer": {"read": read_printer},
    "terminal.question": {"read": read_question},
}
