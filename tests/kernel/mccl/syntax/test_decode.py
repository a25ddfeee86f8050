"""A command from its text: its axis and parameter, or why it is invalid."""

from __future__ import annotations

import pytest

from motionlang.kernel.mccl import NONE, NUMBER, Command, Fault, checked, line_of, table
from motionlang.kernel.mccl.resolve.command import REGISTER, TEXT
from motionlang.kernel.mccl.resolve.decode import problem
from tests.cases import cases


def command(text: str) -> Command:
    """Return a command that stands behind another one."""
    line = line_of(f"NO,{text}")
    assert line is not None
    _, found = line.commands
    return found


@cases(
    "text, name, axis, kind, value",
    [
        ("1MR5", "MR", 1, NUMBER, 5),
        ("mr-5.5", "MR", 0, NUMBER, -5.5),
        ("MR@10", "MR", 0, REGISTER, 10),
        ('LU"X"', "LU", 0, TEXT, "X"),
        ("DI", "DI", 0, NONE, 0),
        # Of a number of an axis that does not exist, nine digits are enough.
        ("12345678901MR5", "MR", 123456789, NUMBER, 5),
        ("XN255", "XN", 0, NUMBER, 255),
        ("1PS0.4", "PS", 1, NUMBER, 0.4),
        ("1SA1e15", "SA", 1, NUMBER, 1e15),
        ("AL1000000000000000", "AL", 0, NUMBER, 10**15),
        ("AL-1000000000000000", "AL", 0, NUMBER, -(10**15)),
        ("MD-1", "MD", 0, NUMBER, -1),
    ],
)
def test_a_command_has_its_axis_and_parameter(
    text: str, name: str, axis: int, kind: int, value: float | str
) -> None:
    found = command(text)
    assert problem(found) is None
    assert (found.name, found.axis, found.kind, found.value) == (name, axis, kind, value)
    assert isinstance(found.value, type(value))


FORM = "a command is [axis] two letters [parameter], such as 1MR1000"
ALONE = "a number follows its command directly: 1MR1000"
COMMAS = "commands are separated by commas"
CODE = "set the code that lets the controller send; 0 for none"
# The text; the name, axis, code, kind of error, message and hint.
WRONG: list[tuple[str, str, int, int, str, str, str]] = [
    (
        "1XX",
        "XX",
        1,
        1,
        "unknown-word",
        "there is no command XX",
        "the commands that begin with X are XF, XN",
    ),
    (
        "1xx5",
        "XX",
        1,
        1,
        "unknown-word",
        "there is no command XX",
        "the commands that begin with X are XF, XN",
    ),
    ("7", "", 7, 2, "syntax", "a number alone is not a command", ALONE),
    ("12345678901", "", 123456789, 2, "syntax", "a number alone is not a command", ALONE),
    ("1M", "M", 1, 2, "syntax", "1M is not a command", FORM),
    ("??", "??", 0, 2, "syntax", "?? is not a command", FORM),
    ("#", "#", 0, 2, "syntax", "# is not a command", "; begins a comment"),
    ("//start", "//", 0, 2, "syntax", "//start is not a command", "; begins a comment"),
    ("1MR1.2.3", "MR", 1, 2, "syntax", "1.2.3 is not a number", "only a number follows MR"),
    ("1WA1s", "WA", 1, 2, "syntax", "1s is not a number", "only a number follows WA"),
    ("CNx", "CN", 0, 2, "syntax", "x is not a number", "only a number follows CN"),
    ("1MR10002MR5", "MR", 1, 2, "syntax", "10002MR5 is not a number", COMMAS),
    ("MR@", "MR", 0, 2, "syntax", "MR needs a register number after @", "such as MR@10"),
    ("MR=5", "MR", 0, 2, "syntax", "=5 is not a number", "write the number alone: MR5"),
    ("1WS(0.1)", "WS", 1, 2, "syntax", "(0.1) is not a number", "write the number alone: WS0.1"),
    ("MR[-5", "MR", 0, 2, "syntax", "[-5 is not a number", "write the number alone: MR-5"),
    ("MR=", "MR", 0, 2, "syntax", "= is not a number", "only a number follows MR"),
    ('LU"X', "LU", 0, 2, "syntax", "the text after LU is not closed", 'a text ends with "'),
    ("MR“5”", "MR", 0, 2, "syntax", '“ is a typographic quote, not a plain "', 'type "'),
    ("LUx", "LU", 0, 2, "values", 'LU needs a text in quotes, such as LU"STATUS"', ""),
    ("LU5", "LU", 0, 2, "values", 'LU needs a text in quotes, such as LU"STATUS"', ""),
    ("LU", "LU", 0, 2, "values", 'LU needs a text in quotes, such as LU"STATUS"', ""),
    (
        '1MR"far"',
        "MR",
        1,
        2,
        "values",
        "MR takes no text",
        "move by a distance, counted from the present target",
    ),
    ("XN256", "XN", 0, -1, "range", "XN accepts 0 to 255, not 256", CODE),
    (
        "TR1000000",
        "TR",
        0,
        -1,
        "range",
        "TR accepts 0 to 255, not 1000000",
        "tell a register; 0 is the accumulator",
    ),
    ("XN-1e16", "XN", 0, -1, "range", "XN accepts 0 to 255, not -1e+16", CODE),
    (
        "1SA-1",
        "SA",
        1,
        -1,
        "range",
        "SA accepts 0 or more, not -1",
        "set the acceleration; a whole number until a scale is set",
    ),
    (
        "1SA1e16",
        "SA",
        1,
        -1,
        "range",
        "SA accepts 0 to 1e+15, not 1e+16",
        "set the acceleration; a whole number until a scale is set",
    ),
    ("AL1e16", "AL", 0, -1, "range", "AL accepts -1e+15 to 1e+15, not 1e+16", "load the accumulator"),
    (
        "AL1000000000000001.0",
        "AL",
        0,
        -1,
        "range",
        "AL accepts -1e+15 to 1e+15, not 1000000000000001",
        "load the accumulator",
    ),
    ("AL-1e16", "AL", 0, -1, "range", "AL accepts -1e+15 to 1e+15, not -1e+16", "load the accumulator"),
]


@cases("text, name, axis, code, kind, message, hint", WRONG)
def test_an_invalid_command_has_its_reason(
    text: str, name: str, axis: int, code: int, kind: str, message: str, hint: str
) -> None:
    found = command(text)
    fault = problem(found)
    assert fault is not None
    assert (found.name, found.axis, found.kind) == (name, axis, NONE)
    assert (fault.code, fault.kind, fault.message, fault.hint) == (code, kind, message, hint)


# The command, the least and the largest value that a register may give it; a step beyond them is a fault.
BOUNDS: list[tuple[str, float, float, float]] = [
    ("AL", -1e15, 1e15, 1.0),
    ("SA", 0.0, 1e15, 1.0),
    ("XN", 0.0, 255.0, 1e-9),
    ("DI", 0.0, 1.0, 1e-9),
    ("PS", 0.0, 0.499_999, 1e-6),
]


@cases("name, low, high, step", BOUNDS)
def test_a_value_from_a_register_has_the_same_bounds(name: str, low: float, high: float, step: float) -> None:
    row = table().get(name)
    assert row is not None
    assert [checked(value, row) for value in (low, 0.0, high)] == [low, 0.0, high]
    for value in (low - step, high + step):
        with pytest.raises(Fault, match=f"{name} accepts"):
            checked(value, row)
