"""From the text of one command to a `Command`, remembered: programs repeat themselves.

Form: `[axis] MNEMONIC [parameter]`, the mnemonic two letters in either case, the parameter a whole number, a real
number, `@n` (the content of register n) or a text in quotes.
"""

from __future__ import annotations

from motionlang.mccl import codes
from motionlang.mccl.codes import Fault
from motionlang.mccl.keywords import TABLE
from motionlang.mccl.keywords.operations import ACTIONS, PURE, not_simulated
from motionlang.mccl.resolve.command import NONE, NUMBER, REGISTER, TEXT, Command

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.keyword import Keyword
    from motionlang.mccl.runtime.task import Action, CommandTask

_DIGITS = frozenset("0123456789")
_LETTERS = frozenset("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz")
_NUMERIC = frozenset("0123456789+-.eE")
_ROWS = {row.name: row for row in TABLE}
# A number beyond this is a mistake, also where a command has no range of its own.
_LARGEST = 1e15
# Enough for any program; a served board is sent other texts every day, and must not keep them all.
_MEMO_SIZE = 20_000

_memo: dict[str, Command] = {}


def decode(text: str) -> Command:
    """The command of a piece of text; never fails, a wrong one is a command that raises its fault when it runs."""
    command = _memo.get(text)
    if command is None:
        command = _decoded(text)
        if len(_memo) >= _MEMO_SIZE:
            _memo.clear()
        _memo[text] = command
    return command


def problem(command: Command) -> Fault | None:
    """What is wrong with a command, whatever the program does."""
    fault = getattr(command.action, "fault", None)
    return fault if isinstance(fault, Fault) else None


class _Wrong:
    """The action of a command that could not be understood."""

    def __init__(self, fault: Fault) -> None:
        self.fault = fault

    def __call__(self, task: CommandTask, command: Command) -> None:
        raise Fault(self.fault.code, self.fault.message, self.fault.hint, self.fault.kind)


def _decoded(text: str) -> Command:
    count = 0
    while count < len(text) and text[count] in _DIGITS:
        count += 1
    name = text[count : count + 2].upper()
    axis = int(text[:count][:9] or 0)
    row: Keyword | None = None
    kind = NONE
    value: float | int | str = 0
    action: Action
    try:
        row = _row_of(text, count, name)
        kind, value = _parameter(text[count + 2 :], row)
        action = ACTIONS[row.verb] if row.simulated else not_simulated
    except Fault as fault:
        action = _Wrong(fault.with_traceback(None))
    return Command(text, name, row, axis, kind, value, action, row is not None and row.verb in PURE)


def _row_of(text: str, count: int, name: str) -> Keyword:
    row = _ROWS.get(name)
    if row is not None:
        return row
    if len(name) < 2 or name[0] not in _LETTERS or name[1] not in _LETTERS:
        wrong = "a number alone is no command" if count == len(text) else f"{text} is no command"
        raise Fault(
            codes.FORMAT, wrong, "a command is [axis] two letters [parameter], such as 1MR1000", "syntax"
        )
    from motionlang.mccl.resolve.nearest import hint

    word = text[count:].rstrip("0123456789.+-")
    raise Fault(
        codes.UNRECOGNISED,
        f"there is no command {word if len(word) > 2 else name}",
        hint(word),
        "unknown-word",
    )


def _parameter(rest: str, row: Keyword) -> tuple[int, float | int | str]:
    if not rest:
        return NONE, _left_out(row)
    first = rest[0]
    if first == "@":
        if len(rest) < 2 or not _DIGITS.issuperset(rest[1:]) or len(rest) > 10:
            raise Fault(
                codes.FORMAT, f"{row.name} wants a register number after @", "such as MR@10", "syntax"
            )
        return REGISTER, int(rest[1:])
    if first == '"':
        return TEXT, _text(rest, row)
    if row.unit == "text" and row.access == "W":
        raise Fault(
            codes.FORMAT, f'{row.name} wants a text in quotes, such as {row.name}"STATUS"', "", "values"
        )
    return NUMBER, checked(_number(rest, row), row)


def _left_out(row: Keyword) -> int:
    """A parameter that is left out is 0, where the command accepts that."""
    if row.unit == "text" and row.access == "W":
        raise Fault(
            codes.FORMAT, f'{row.name} wants a text in quotes, such as {row.name}"STATUS"', "", "values"
        )
    if row.simulated:
        checked(0, row)
    return 0


def _text(rest: str, row: Keyword) -> str:
    if len(rest) < 2 or rest.find('"', 1) != len(rest) - 1:
        raise Fault(codes.FORMAT, f"the text after {row.name} has no end", 'a text ends with "', "syntax")
    if row.unit != "text" or row.access != "W":
        raise Fault(codes.FORMAT, f"{row.name} takes no text", row.help, "values")
    return rest[1:-1]


def _number(rest: str, row: Keyword) -> float | int:
    if _NUMERIC.issuperset(rest):
        try:
            return int(rest) if len(rest) < 20 else float(rest)
        except ValueError:
            pass
        try:
            return float(rest)
        except ValueError:
            pass
    hint = "commands are separated by commas" if any(c in _LETTERS for c in rest) else ""
    raise Fault(codes.FORMAT, f"{rest} is not a number", hint, "syntax")


def checked(value: float | int, row: Keyword) -> float | int:
    """The value, if the command accepts it."""
    low, high = row.low, row.high
    if low is None and high is None and abs(value) <= _LARGEST:
        return value
    if (low is None or value >= low) and (high is None or value <= high) and abs(value) <= _LARGEST:
        return value
    raise out_of_range(value, row)


def out_of_range(value: float | int, row: Keyword) -> Fault:
    """The fault of a value that a command does not accept."""
    low, high = row.low, row.high
    if high is None and low is not None and value < low:
        accepted = f"{low:g} or more"
    elif low is None and high is not None and value > high:
        accepted = f"{high:g} or less"
    else:
        accepted = f"{-_LARGEST if low is None else low:g} to {_LARGEST if high is None else high:g}"
    return Fault(codes.PARAMETER, f"{row.name} accepts {accepted}, not {value:g}", row.help, "range")
