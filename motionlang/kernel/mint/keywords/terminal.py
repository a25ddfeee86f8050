"""Terminals: printed output, keys and lines.

A terminal is a bit: 1, 2, 4 … 128. TERMINAL is a pattern of these bits. Each task has its own TERMINAL, and event
handlers share that of the parent task. Terminal 1 is the console.
"""

from __future__ import annotations

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword, constant
from motionlang.kernel.lang.machine.machine import CONSOLE
from motionlang.kernel.mint.runtime.binding import Maker, Operation, of
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment

# All possible terminals, and the value that stands for those of TERMINAL.
ALL = 255
CURRENT = -1


class TaskTerminals:
    """The terminals that each task prints to."""

    def __init__(self, environment: Environment) -> None:
        self._environment, self._machine = environment, environment.machine
        # By the timer behind TIME of a task. Handlers share it with the parent task, so they share the
        # terminals.
        self._chosen: dict[int, tuple[object, int]] = {}

    @property
    def current(self) -> int:
        """The value of TERMINAL in the running task."""
        return self._chosen.get(id(self._environment.task.timer), (None, CONSOLE))[1]

    def choose(self, pattern: int) -> None:
        """TERMINAL: set the terminals that PRINT uses, one bit each."""
        timer = self._environment.task.timer
        self._chosen[id(timer)] = timer, pattern

    def bits(self, pattern: int) -> list[int]:
        """Return the terminals of a pattern."""
        if pattern == CURRENT:
            pattern = self.current
        elif not 1 <= pattern <= ALL:
            raise Rejected(
                "terminal", f"there is no terminal {pattern}", "they are 1, 2, 4 and so on up to 128"
            )
        return [1 << k for k in range(8) if pattern >> k & 1]

    def one(self, pattern: int) -> int:
        """Return the only terminal of a pattern; raise Rejected if there are more."""
        found = self.bits(pattern)
        if len(found) != 1:
            known = " and ".join(map(str, found)) or "none"
            raise Rejected("one-terminal", f"INPUT uses one terminal, not {known}", "TERMINAL = 1")
        return found[0]

    def write(self, text: str, pattern: int = CURRENT) -> None:
        """Print on the terminals of a pattern, by default those of TERMINAL."""
        self._environment.acts += 1
        if not self._chosen and pattern == CURRENT:
            self._machine.terminal.write(text)
            return
        for number in self.bits(pattern):
            self._machine.terminal_at(number).write(text)

    def write_on_row(self, row: int, text: str) -> None:
        """LINE: print on a row of the screens that TERMINAL selects; see `say_on_row`."""
        for number in self.bits(CURRENT):
            self._environment.acts += self._machine.terminal_at(number).write_on_row(row, text)


def _pattern(number: int) -> int:
    """Return the pattern for a terminal number; 0, the default, means TERMINAL."""
    return number or CURRENT


def text_writer(text: str) -> Maker:
    """Make an operation that writes a text to a terminal."""
    return of(TaskTerminals, lambda terminals, number: terminals.write(text, _pattern(number)))


def do_locate(terminals: TaskTerminals, column: int, row: int) -> None:
    terminals.write(f"\x1b[{max(row, 1)};{max(column, 1)}H")


# ------------------------------------------------------------------------------------------------------- keys


def read_key(environment: Environment, row: Keyword) -> Operation:
    """INKEY: make an operation that reads a key."""
    terminals, operator_at = environment.component(TaskTerminals), environment.machine.operator_at
    for entry in environment.machine.settings.get("key", ()):  # type: ignore[attr-defined]
        operator_at(
            entry.get("terminal", CONSOLE)
        )  # keys are also pressed while the program reads another terminal

    def read(number: int) -> int:
        key = 0
        for each in terminals.bits(_pattern(number)):
            key = operator_at(each).next_key()
            if key:
                environment.acts += 1
                break
        return key

    return read


def read_held_key(environment: Environment, row: Keyword) -> Operation:
    """READKEY: make an operation that reads the key held down."""
    return environment.machine.operator.held_key


# ------------------------------------------------------------------------------------------------- keywords

_TERMINAL = Actions(
    "terminal.terminal",
    read=of(TaskTerminals, lambda terminals: terminals.current),
    write=repeatable(of(TaskTerminals, TaskTerminals.choose)),
)


ROWS = (
    Keyword("TERMINAL", "tm", "setting", "RW", "none", "bits", _TERMINAL,
            "The terminals that PRINT and its like mean in this task: 1, 2, 4 and so on up to 128, or several as bits; "
            "0 none. Terminal 1 is the console; the lines of the others are shown with a label.",
            'TERMINAL = _Term2\nPRINT "there"\nTERMINAL = _Term1\nPRINT "here"',
            default=1, low=0, high=255, group="terminal"),
    *(constant(f"_Term{n}", 1 << n - 1, f"TERMINAL: terminal {1 << n - 1}.") for n in (1, 2, 3)),
    Keyword("INKEY", "ik", "reading", "R", "terminal", "integer", Actions(read=read_key),
            "Code of the next key that the operator has pressed, 0 when there is none; at the terminal in brackets, "
            "or at that of TERMINAL.",
            "PRINT INKEY", default=0.0, group="terminal", driven="key"),
    Keyword("READKEY", "rk", "reading", "R", "none", "integer", Actions(read=read_held_key),
            "Code of the key that the operator holds down, 0 when there is none.",
            "PRINT READKEY", default=0.0, group="terminal", driven="key"),
    Keyword("CLS", "", "command", "C", "terminal", "", Actions(do=text_writer("\x1b[2J\x1b[H")),
            "Clear the terminal's screen (as the ANSI codes that do so).",
            "CLS", group="terminal"),
    Keyword("LOCATE", "", "command", "C", "column, row", "", Actions(do=of(TaskTerminals, do_locate)),
            "Place the cursor (as the ANSI code that does so); the upper left corner is 1, 1.",
            'LOCATE(1, 2)\nPRINT "second row"', group="terminal"),
    Keyword("LINE", "", "command", "C", "row", "", "line",
            "Print values at the start of a row of the screen, with signs and USING as in PRINT. A text that the row "
            "shows already is not sent again, except by `serve`.",
            'LINE 2, "speed ", 250', group="terminal"),
    Keyword("BOL", "", "command", "C", "terminal", "", Actions(do=text_writer("\r")),
            "Go to the start of the line, as Chr(13) does.",
            'PRINT "old",\nBOL\nPRINT "new"', group="terminal"),
    Keyword("BEEP", "", "command", "C", "terminal", "", Actions(do=text_writer("\a")),
            "Sound the terminal's bell.",
            "BEEP", group="terminal"),
)  # fmt: skip


def _hidden(name: str, help: str, read: Maker) -> Keyword:
    return Keyword(name, "", "reading", "R", "none", "", Actions(read=read), help, group="terminal")


HIDDEN = (
    _hidden("(terminal)", "The terminal that INPUT reads from.", of(TaskTerminals, TaskTerminals.one)),
    _hidden("(printer)", "Print a text on the terminals of TERMINAL, or on those of a pattern.",
            of(TaskTerminals, TaskTerminals.write)),
    _hidden("(row)", "Print a text on a row of the screens of TERMINAL.",
            of(TaskTerminals, TaskTerminals.write_on_row)),
)  # fmt: skip
