"""Declarations with one mistake each: the marked text, the message and the hint."""

from __future__ import annotations

from motionlang.commands.check import check
from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT
from tests.cases import cases

DIM = "Dim n As Integer, t As String * 5\n"
EVENTS = (
    "the events are ONERROR, BUS0, STOP, FASTIN0, LATCH0, TIMER, IN0, NETDATA0, COMMS0, AXISIDLE, MBLOW, "
    "TERMINALRECEIVE, SERIALRECEIVE"
)
OTHER = "choose another name"
TYPES = "the types are Integer, Float, String, Time, Semaphore, Controller"
SIZE = "the size of c must be a whole number of at least 1 that is known beforehand"
ITSELF = "the expression of a Define must not contain its own name"
CONST = "a Const can use numbers, texts and other constants"


@cases(
    "text, location, message, hint",
    [
        # A keyword with its number, but without brackets.
        ("GO3", (2, 1, 3), "GO3 is neither a keyword nor a sub of this program", "did you mean GO(3)?"),
        ("PRINT POS2 + 1", (2, 7, 4), "POS2 is unknown", "did you mean POS(2)?"),
        ("PRINT IN3", (2, 7, 3), "IN3 is unknown", "did you mean INX(3)?"),
        (
            "OUT3 = 1",
            (2, 1, 4),
            "OUT3 is assigned but never read",
            "did you mean OUTX(3)? If it is a variable, declare it with Dim",
        ),
        (
            "CANCELALL3",
            (2, 1, 10),
            "CANCELALL3 is neither a keyword nor a sub of this program",
            "did you mean CANCELALL?",
        ),
        # Events.
        ("Event FOO\nEnd Event", (2, 1, 5), "there is no event FOO", EVENTS),
        ("Event TIMR\nEnd Event", (2, 1, 5), "there is no event TIMR", "did you mean TIMER?"),
        (
            "Event IN3\nEnd Event\nEvent in3\nEnd Event",
            (4, 1, 5),
            "there is already a handler for in3",
            "",
        ),
        (
            "Event TIMER\nEnd Event\nEvent Timer\nEnd Event",
            (4, 1, 5),
            "there is already a handler for Timer",
            "",
        ),
        # Names of the language, and names that are declared twice.
        ("Dim Float As Integer", (2, 5, 5), "Float is a statement of Mint and cannot be declared", OTHER),
        ("Dim Sqrt As Integer", (2, 5, 4), "Sqrt is a function of Mint and cannot be declared", OTHER),
        ("Dim _ON As Integer", (2, 5, 3), "_ON is a constant of Mint and cannot be declared", OTHER),
        ("Dim GO As Integer", (2, 5, 2), "GO is a command of Mint and cannot be declared", OTHER),
        ("Sub GO()\nEnd Sub", (2, 1, 3), "GO is a command of Mint and cannot be declared", OTHER),
        ("Task POS\nEnd Task", (2, 1, 4), "POS is a setting of Mint and cannot be declared", OTHER),
        ("Const WAIT = 5", (2, 1, 5), "WAIT is a setting of Mint and cannot be declared", OTHER),
        ("Define IDLE = 3", (2, 1, 6), "IDLE is a reading of Mint and cannot be declared", OTHER),
        ("Sub q(SPEED)\nEnd Sub", (2, 7, 5), "SPEED is a setting of Mint and cannot be declared", OTHER),
        ("Dim m As Float, M", (2, 17, 1), "M is already declared", "the first one is in line 2"),
        ("Sub q(v, V)\nEnd Sub", (2, 10, 1), "V is already declared", "the first one is in line 2"),
        ("Const k = 1\nConst K = 2", (3, 1, 5), "K is already declared", "the first one is in line 2"),
        ("Sub q()\nDim z\nDim Z\nEnd Sub", (4, 5, 1), "Z is already declared", "the first one is in line 3"),
        # Types and sizes.
        ("Dim q As Foo", (2, 10, 3), "there is no type Foo", TYPES),
        ("Function q() As Foo\nEnd Function", (2, 17, 3), "there is no type Foo", TYPES),
        ("Type P\n x As P\nEnd Type", (3, 7, 1), "there is no type P", TYPES),
        ("Type P\n x As Q\nEnd Type\nType Q\n y As P\nEnd Type", (3, 7, 1), "there is no type Q", TYPES),
        ("Dim c(n) As Integer", (2, 7, 1), SIZE, ""),
        ("Dim c(1.5) As Integer", (2, 7, 3), SIZE, ""),
        ("Dim c(-1) As Integer", (2, 7, 2), SIZE, ""),
        ("Dim c(0) As Integer", (2, 7, 1), SIZE, ""),
        (
            "Dim c(10000001) As Integer",
            (2, 5, 1),
            "c has more than 10000000 elements",
            "make the array smaller",
        ),
        # Values that are known beforehand.
        ("Define k = k + 1\nPRINT k", (2, 1, 6), "k is defined by itself", ITSELF),
        ("Const k = n", (2, 1, 5), "the value of k is not known before the program runs", CONST),
        ("Const k = m\nConst m = 3", (2, 1, 5), "the value of k is not known before the program runs", CONST),
        # What a name is.
        (
            "Function q() As Integer\nq = 1\nEnd Function\nq = 2",
            (5, 1, 1),
            "q is a function and cannot be assigned to",
            "",
        ),
        ("Sub q()\nq = 2\nEnd Sub", (3, 1, 1), "q is a sub and cannot be assigned to", ""),
        ("Task q\nEnd Task\nq = 1", (4, 1, 1), "q is a task and cannot be assigned to", ""),
        ("Const k = 1\nk = 2", (3, 1, 1), "k is a constant and cannot be assigned to", ""),
        ("Task q\nEnd Task\nq()", (4, 1, 1), "q is a task, not a command", ""),
    ],
)
def test_a_declaration_that_is_refused(
    text: str, location: tuple[int, int, int], message: str, hint: str
) -> None:
    found = [each for each in check(Source("a.mnt", DIM + text), DIALECT) if each.severity == "error"]
    assert [((each.line, each.column, each.length), each.message, each.hint) for each in found] == [
        (location, message, hint)
    ]


def test_an_event_that_never_occurs_is_a_warning() -> None:
    (found,) = check(Source("a.mnt", "PRINT 1\nEvent RESET\nEnd Event"), DIALECT)
    assert (found.severity, found.line, found.message, found.hint) == (
        *("warning", 2, "the event RESET never occurs here"),
        "EVENTPEND(17, 0, 0) raises it",
    )


@cases(
    "text",
    [
        "Dim n2 As Integer, n3 As Float",
        f"Dim c(9) As Integer, d({10**7}) As Integer",
        "Dim e As Float",
        "PO = 1",
    ],
)
def test_a_declaration_that_is_accepted(text: str) -> None:
    """E is a short form, and PO is too short to be a misspelt POS."""
    assert [each for each in check(Source("a.mnt", text), DIALECT) if each.severity == "error"] == []


def test_of_many_errors_a_hundred_are_reported() -> None:
    found = check(Source("a.mnt", 'SPEED(0) = "fast"\n' * 120), DIALECT)
    assert [(each.code, each.line) for each in found] == [("type", line) for line in range(1, 101)]
