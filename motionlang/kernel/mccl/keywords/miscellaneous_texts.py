"""OT, FT and FD: a line of text, with the accumulator in place of a format.

That these commands output text is known from memory only. The format in their texts, which is that of printf,
is our choice.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords.row import Group

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask

_ESCAPES = {"n": "\n", "r": "\r", "t": "\t", "\\": "\\"}
_FLAGS = "-+ 0"
WIDEST, FINEST = 80, 20


def put_text(task: CommandTask, command: Command) -> None:
    task.reply(_filled(str(command.value), None, ""))


def put_integer(task: CommandTask, command: Command) -> None:
    value = int(task.registers[0])
    task.reply(_filled(str(command.value), lambda form, kind: _whole(form, kind, value), "dxX"))


def put_real(task: CommandTask, command: Command) -> None:
    value = float(task.registers[0])
    task.reply(_filled(str(command.value), lambda form, kind: f"%{form}{kind}" % value, "feg"))


def _whole(form: str, kind: str, value: int) -> str:
    return f"%{form}{kind}" % (value if kind == "d" else value & 0xFFFFFFFF)


def _filled(text: str, show: Callable[[str, str], str] | None, kinds: str) -> str:
    """Return the text with escapes replaced, and formats such as %6.2f by the value."""
    out: list[str] = []
    k = 0
    while k < len(text):
        character = text[k]
        k += 1
        if character == "\\":
            out.append(_escape(text[k : k + 1]))
            k += 1
        elif character == "%" and text[k : k + 1] == "%" and show is not None:
            out.append("%")
            k += 1
        elif character == "%" and show is not None:
            form, kind, k = _form(text, k, kinds)
            out.append(show(form, kind))
        else:
            out.append(character)
    return "".join(out)


def _escape(character: str) -> str:
    if character not in _ESCAPES:
        hint = "the escapes are \\n, \\r, \\t and \\\\"
        raise Fault(codes.PARAMETER, f"there is no escape \\{character}", hint, "values")
    return _ESCAPES[character]


def _form(text: str, k: int, kinds: str) -> tuple[str, str, int]:
    """Parse a format at index `k`.

    Returns the flags and width between % and its letter, the letter, and the index after it.
    """
    begin = k
    while k < len(text) and (text[k] in _FLAGS or text[k].isdecimal() or text[k] == "."):
        k += 1
    form, kind = text[begin:k], text[k : k + 1]
    width, _, decimals = form.lstrip(_FLAGS).partition(".")
    if not kind or kind not in kinds or not (_is_small(width, WIDEST) and _is_small(decimals, FINEST)):
        hint = "such as " + ("%d, %6d or %08X" if "d" in kinds else "%f, %8.3f or %g")
        raise Fault(codes.PARAMETER, f"%{form}{kind} is not a number format here", hint, "values")
    return form, kind, k + 1


def _is_small(digits: str, most: int) -> bool:
    """True if a width or a number of decimals is small enough for a line."""
    return not digits or (digits.isdecimal() and len(digits) <= 2 and int(digits) <= most)


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("miscellaneous").row


ROWS = (
    _row("OT", "command", "W", "none", "text", put_text, "Put out a line of text; the form of the text is ours.",
         'OT"ready"'),
    _row("FT", "command", "W", "none", "text", put_integer,
         "Put out a line of text with the accumulator as a whole number in it (%d, %x); the form is ours.",
         'AL12,FT"parts: %4d"'),
    _row("FD", "command", "W", "none", "text", put_real,
         "Put out a line of text with the accumulator as a real number in it (%f, %e, %g); the form is ours.",
         'AL1,AD3.0,FD"%.3f mm"'),
)  # fmt: skip
