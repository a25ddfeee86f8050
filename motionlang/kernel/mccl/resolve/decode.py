"""From a node of the tree to a `Command`, or to the fault of a text that is none."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.typography import typographic, unclosed
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords import table
from motionlang.kernel.mccl.resolve.command import NONE, NUMBER, REGISTER, TEXT, Command
from motionlang.kernel.mccl.syntax import tree
from motionlang.kernel.tools import as_hint

if TYPE_CHECKING:
    from motionlang.kernel.mccl.runtime.task import CommandTask


_DIGITS = "0123456789"
# A number beyond this is an error, even for a command without a range.
_MAX_NUMBER = 1e15


def fault_of(command: Command) -> Fault | None:
    """Return the fault of a command that is invalid in any program, or None."""
    fault = getattr(command.action, "fault", None)
    return fault if isinstance(fault, Fault) else None


class _Wrong:
    """The action of an invalid command."""

    def __init__(self, fault: Fault) -> None:
        self.fault = fault

    def __call__(self, task: CommandTask, command: Command) -> None:
        raise Fault(self.fault.code, self.fault.message, self.fault.hint, self.fault.kind)


# The mnemonic of a command that follows another one without a comma, behind its axis.
_NEXT = re.compile(r"[-+.\d]*([A-Za-z]{2})(?![A-Za-z])")
# What begins a comment in other languages.
_COMMENTS = ("#", "'", "//", "/*", "{")


def decoded(node: tree.Command | tree.Wrong, text: str) -> Command:
    """Return the command of a node and its text; an invalid one raises its fault when it runs."""
    if isinstance(node, tree.Wrong):
        return _no_command(node, text)
    name, axis = str(node.word), node.axis or 0  # a plain text, which the log stores
    row = table().get(name)
    kind: int
    value: float | int | str
    match node.argument:
        case None:
            kind, value = NONE, 0
        case tree.Register():
            kind, value = REGISTER, node.argument.number
        case str():
            kind, value = TEXT, node.argument
        case _:
            kind, value = NUMBER, node.argument
    if row is None:
        return _wrong(text, name, None, axis, _unknown(node.word))
    fault = _misfit(row, kind, value)
    if fault is not None:
        return _wrong(text, name, row, axis, fault)
    assert row.actions.do is not None
    return Command(text, name, row, axis, kind, value, row.actions.do, hasattr(row.actions.do, "pure"))


def _wrong(text: str, name: str, row: Keyword | None, axis: int, fault: Fault) -> Command:
    """Return a command without parameter that raises a fault."""
    is_pure = row is not None and hasattr(row.actions.do, "pure")
    return Command(text, name, row, axis, NONE, 0, _Wrong(fault), is_pure)


def _no_command(node: tree.Wrong, text: str) -> Command:
    """Return the invalid command for a text that does not have the form of one."""
    end = node.mistake - node.start
    misprint = typographic(text[end:].lstrip(" \t")) or unclosed(text[end:])
    if misprint is not None:
        name = text[:end].lstrip(_DIGITS)[:2].upper()
        return _wrong(text, name, None, 0, Fault(codes.FORMAT, *misprint, "syntax"))
    if not node.word:
        wrong = f"{text} is not a command"
        hint = "a command is [axis] two letters [parameter], such as 1MR1000"
        if not text.strip(_DIGITS):
            wrong = "a number alone is not a command"
            hint = "a number follows its command directly: 1MR1000"
        elif text.startswith(_COMMENTS):
            hint = "; begins a comment"
        elif text.startswith('"'):
            hint = f"a text follows its command directly: OT{text}"
        fault = Fault(codes.FORMAT, wrong, hint, "syntax")
        digits = len(text) - len(text.lstrip(_DIGITS))
        name, axis = text[digits : digits + 2].upper(), int(text[:digits][:9] or 0)
        return _wrong(text, name, None, axis, fault)
    row = table().get(node.word)
    letters = text[end - 2 :].rstrip("0123456789.+-")
    fault = _unknown(letters) if row is None else _no_parameter(text[:end], text[end:], row, letters)
    return _wrong(text, str(node.word), row, node.axis or 0, fault)


def _unknown(word: str) -> Fault:
    name = word if len(word) > 2 else word.upper()
    message = f"there is no command {name}"
    return Fault(codes.UNRECOGNISED, message, hint(word), "unknown-word", candidates(word))


def _no_parameter(command: str, rest: str, row: Keyword, letters: str) -> Fault:
    """Return the fault of a text after the axis and the mnemonic of a command that is not a parameter.

    `letters` are the mnemonic and what follows it: they may be a word of another language.
    """
    if rest[0] == "@":
        return Fault(codes.FORMAT, f"{row.name} needs a register number after @", "such as MR@10", "syntax")
    if rest[0] == '"':
        return Fault(codes.FORMAT, f"the text after {row.name} is not closed", 'a text ends with "', "syntax")
    if _takes_text(row):
        return _wants_text(row)
    others, advice = candidates(letters) if len(letters) > 2 else [], ""
    number = rest.strip("=()[] \t")
    if others:
        advice = hint(letters)
    elif rest[0] in "=([" and number.replace(".", "", 1).removeprefix("-").isdecimal():
        advice = f"write the number alone: {command.upper()}{number}"
    else:
        found = _NEXT.match(rest)
        is_command = found is not None and table().get(found[1].upper()) is not None
        advice = "commands are separated by commas" if is_command else f"only a number follows {row.name}"
    return Fault(codes.FORMAT, f"{rest} is not a number", advice, "syntax", others)


def _misfit(row: Keyword, kind: int, value: float | int | str) -> Fault | None:
    """Return the fault of a parameter that the command does not accept, if it is known before the run."""
    if isinstance(value, str):
        return None if _takes_text(row) else _no_text(row)
    if kind == REGISTER:
        return None
    if _takes_text(row):
        return _wants_text(row)
    if (kind == NONE and not row.simulated) or _accepts(row, value):
        return None
    return out_of_range(value, row)


def _takes_text(row: Keyword) -> bool:
    return row.unit == "text" and row.access == "W"


def _wants_text(row: Keyword) -> Fault:
    return Fault(codes.FORMAT, f'{row.name} needs a text in quotes, such as {row.name}"STATUS"', "", "values")


def _no_text(row: Keyword) -> Fault:
    return Fault(codes.FORMAT, f"{row.name} takes no text", as_hint(row.help), "values")


def checked(value: float | int, row: Keyword) -> float | int:
    """Return the value if the command accepts it; raise Fault if not."""
    if _accepts(row, value):
        return value
    raise out_of_range(value, row)


def _accepts(row: Keyword, value: float | int) -> bool:
    low, high = row.limits
    return low <= value <= high and abs(value) <= _MAX_NUMBER


def out_of_range(value: float | int, row: Keyword) -> Fault:
    """Return the fault of a value that a command does not accept."""
    accepted = row.accepted
    if abs(value) > _MAX_NUMBER and (row.low if value < 0 else row.high) is None:
        low = -_MAX_NUMBER if row.low is None else row.low
        accepted = f"{low:.10g} to {_MAX_NUMBER if row.high is None else row.high:.10g}"
    shown = f"{value:.10g}"
    if abs(value) > _MAX_NUMBER >= abs(float(shown)):
        shown = f"{value:.17g}"  # fewer digits would show the bound itself
    return Fault(codes.PARAMETER, f"{row.name} accepts {accepted}, not {shown}", as_hint(row.help), "range")


def candidates(word: str) -> list[str]:
    """Return the commands that may have been meant by a word."""
    upper, found = word.upper(), table().meant_by(word)
    if found or len(upper) > 2 or upper[0] == upper[-1]:
        return found
    swapped = table().get(upper[::-1])
    return [] if swapped is None else [swapped.name]


def hint(word: str) -> str:
    """Return a hint for an unknown word, or an empty text."""
    upper, found = word.upper(), candidates(word)
    if len(found) > 1 or (found and found[0] != upper[::-1]):
        return f"did you mean {' or '.join(filter(None, (', '.join(found[:-1]), found[-1])))}?"
    if len(upper) > 2:
        return "a command is two letters and its parameter; commands are separated by commas"
    if found and (swapped := table().get(found[0])) is not None:
        return f"did you mean {swapped.name}? {swapped.help}"
    similar = [row.name for row in table() if row.name[0] == upper[0]]
    return f"the commands that begin with {upper[0]} are {', '.join(sorted(similar))}" if similar else ""
