"""Loops, branches, arrays and conversions at their bounds, with output by hand."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Run, Source

DIM = "Dim n As Integer, m As Integer, k As Integer, x As Float, t As String * 5, a(3) As Integer\n"


def counted(head: str) -> str:
    """Return a For that prints its counter in the loop and behind it."""
    return f'For {head}\n  PRINT n, ",",\nNext\nPRINT "end ", n'


def counted_float(head: str) -> str:
    return f'For {head}\n  PRINT x USING 1, 2, ",",\nNext\nPRINT "end ", x USING 1, 2'


# A rule, the program and its output.
PROGRAMS: dict[str, tuple[str, list[str]]] = {
    # ------------------------------------------------------------------------------------------------------------ For
    "a For includes its end": (counted("n = 1 To 3"), ["1,2,3,end 4"]),
    "a For may run once": (counted("n = 3 To 3"), ["3,end 4"]),
    "a For may run not at all": (counted("n = 4 To 3"), ["end 4"]),
    "a step that skips the end stops before it": (counted("n = 1 To 6 Step 2"), ["1,3,5,end 7"]),
    "a step that meets the end includes it": (counted("n = 1 To 5 Step 2"), ["1,3,5,end 7"]),
    "a negative step counts down": (counted("n = 3 To 1 Step -1"), ["3,2,1,end 0"]),
    "a negative step to a higher end runs not at all": (counted("n = 1 To 3 Step -1"), ["end 1"]),
    "a step may be a variable": ("m = -2\n" + counted("n = 5 To 1 Step m"), ["5,3,1,end -1"]),
    "a variable step is that of the beginning": (
        "m = 2\nFor n = 1 To 5 Step m\n  m = 1\n  PRINT n,\nNext\nPRINT n", ["1357"]),
    "the end is that of the beginning": ("m = 2\nFor n = 1 To m\n  m = 9\n  PRINT n,\nNext\nPRINT n", ["123"]),
    "the counter may be changed in the loop": ("For n = 1 To 5\n  n = n + 1\n  PRINT n,\nNext\nPRINT n", ["2467"]),
    "a Float counter goes by a fraction": (counted_float("x = 0 To 1 Step 0.25"),
        ["0.00,0.25,0.50,0.75,1.00,end 1.25"]),
    "a Float counter counts down": (counted_float("x = 1 To 0 Step -0.5"), ["1.00,0.50,0.00,end -0.50"]),
    "Exit For leaves the inner loop": (
        "For n = 1 To 3\n  For m = 1 To 3\n    If m = 2 Then Exit For\n    PRINT n, m,\n  Next\nNext\nPRINT n, m",
        ["11213142"]),
    # ------------------------------------------------------------------------------------------------- other loops
    "a While tests before its first iteration": ("n = 3\nWhile n < 3\n  n = n + 1\nEnd While\nPRINT n", ["3"]),
    "a While ends as its condition ends": ("n = 0\nWhile n < 3\n  n = n + 1\nEnd While\nPRINT n", ["3"]),
    "a Repeat runs once at least": ("n = 3\nRepeat\n  n = n + 1\nUntil n > 3\nPRINT n", ["4"]),
    "Exit While and Exit Repeat leave their loops": (
        "n = 0\nWhile n < 9\n  m = 0\n  Repeat\n    m = m + 1\n    If m = 2 Then Exit Repeat\n  Until m = 5\n"
        "  n = n + m\n  If n > 5 Then Exit While\nEnd While\nPRINT n, m", ["62"]),
    "Exit Loop leaves an endless loop": (
        "n = 0\nLoop\n  n = n + 1\n  If n = 4 Then Exit Loop\nEnd Loop\nPRINT n", ["4"]),
    # ---------------------------------------------------------------------------------------------------- Select Case
    "a Case may be values, a range or what is left": (
        "For n = -1 To 6\n  Select Case n\n    Case 0, 2\n      PRINT \"a\",\n    Case 3 To 5\n      PRINT \"b\",\n"
        "    Case Else\n      PRINT \"c\",\n  End Select\nNext\nPRINT \"\"", ["cacabbbc"]),
    "the first Case that fits is the only one": (
        "n = 3\nSelect Case n\n  Case 1 To 3\n    PRINT 1\n  Case 3\n    PRINT 2\nEnd Select", ["1"]),
    "without Case Else nothing may fit": ("n = 9\nSelect Case n\n  Case 1\n    PRINT 1\nEnd Select\nPRINT 2", ["2"]),
    "a Case may be a text": (
        "t = \"up\"\nSelect Case t\n  Case \"down\"\n    PRINT 1\n  Case \"up\"\n    PRINT 2\nEnd Select", ["2"]),
    # ------------------------------------------------------------------------------------------------------------- If
    "ElseIf is tested after what comes before it": (
        "For n = 1 To 4\n  If n < 2 Then\n    PRINT 1,\n  ElseIf n < 4 Then\n    PRINT 2,\n  Else\n    PRINT 3,\n"
        "  End If\nNext\nPRINT \"\"", ["1223"]),
    "an If of a number is that it is not 0": (
        "x = 0.25\nIf x Then PRINT 1\nn = -1\nIf n Then PRINT 2\nn = 0\nIf n Then PRINT 3", ["1", "2"]),
    # ---------------------------------------------------------------------------------------------------- conversions
    "a Float that becomes an Integer loses its fraction": ("n = 2.9\nm = -2.9\nPRINT n, m", ["2-2"]),
    "an Integer becomes a Float": ("x = 7\nPRINT x, \" \", x / 2", ["7.0000 3.5000"]),
    "an Integer holds 32 bits": ("n = 2147483647.0\nm = -2147483648.0\nPRINT n, m", ["2147483647-2147483648"]),
    "an array begins with element 1": (
        "a(1) = 5\na(3) = 7\nPRINT a(1), a(2), a(3)", ["507"]),
    "an index loses its fraction": ("a(2) = 6\nx = 2.9\nPRINT a(x)", ["6"]),
    "values fill an array from its beginning": (
        "Dim b(4) As Integer = 1, 2, 3\nPRINT b(1), b(2), b(3), b(4)", ["1230"]),
    "an array has two dimensions": (
        "Dim c(2, 3) As Integer\nFor n = 1 To 2\n  For m = 1 To 3\n    c(n, m) = 10 * n + m\n  Next\nNext\n"
        "PRINT c(1, 1), c(1, 3), c(2, 1), c(2, 3)", ["11132123"]),
    "a text may be as long as its String": ("t = \"abcde\"\nPRINT t, Len(t)", ["abcde5"]),
    # ------------------------------------------------------------------------------------------------------ functions
    "a function returns the value of its name": (
        "PRINT twice(4)\nFunction twice(ByVal v As Integer) As Integer\n  twice = 2 * v\nEnd Function", ["8"]),
    "ByVal leaves the variable of the caller, ByRef changes it": (
        "n = 1 : m = 1\nboth(n, m)\nPRINT n, m\n"
        "Sub both(ByVal v As Integer, ByRef w As Integer)\n  v = 5\n  w = 6\nEnd Sub",
        ["16"]),
    "a function may call itself": (
        "PRINT factorial(5)\nFunction factorial(ByVal v As Integer) As Integer\n  If v < 2 Then\n    factorial = 1\n"
        "  Else\n    factorial = v * factorial(v - 1)\n  End If\nEnd Function", ["120"]),
    "Return leaves a Sub": ("early()\nPRINT 2\nSub early()\n  PRINT 1\n  Return\n  PRINT 3\nEnd Sub", ["1", "2"]),
    "a local variable begins at 0 in each call": (
        "count()\ncount()\nSub count()\n  Dim own As Integer\n  own = own + 1\n  PRINT own\nEnd Sub", ["1", "1"]),
    # -------------------------------------------------------------------------------------------------------- PRINT
    "a comma joins and a comma at the end continues the line": ("PRINT 1, 2,\nPRINT 3\nPRINT", ["123", ""]),
    "a constant is known before its line": ("PRINT PARTS\nConst PARTS = 4 + 1", ["5"]),
    # ----------------------------------------------------------------------------------------------------------- time
    "WAIT and TIME are in milliseconds": (
        "TIME = 0 : WAIT 250 : PRINT TIME : TIME = 1000 : WAIT 1 : PRINT TIME", ["250", "1001"]),
    "End ends the program": ("PRINT 1\nEnd\nPRINT 2", ["1"]),
    "Goto continues behind its label": ("n = 0\nagain:\nn = n + 1\nIf n < 3 Then Goto again\nPRINT n", ["3"]),
    "a jump out of a loop ends it": (
        "For n = 1 To 9\n  If n = 4 Then Goto done\nNext\ndone:\nPRINT n", ["4"]),
}  # fmt: skip
# A program and the message of its fault.
FAULTS = {
    "PRINT a(0)": "there is no element 0: the subscript must be 1 to 3",
    "n = 4\nPRINT a(n)": "there is no element 4: the subscript must be 1 to 3",
    "n = 0\na(n) = 1": "there is no element 0: the subscript must be 1 to 3",
    "x = 3e9\nn = x": "3000000000 does not fit an Integer",
    "x = -3e9\nn = x": "-3000000000 does not fit an Integer",
    "n = 2147483647\nn = n + 1": "2147483648 does not fit an Integer",
    't = "abc"\nt = t + t': "a text of 6 characters does not fit a String * 5",
}


def ran(text: str) -> Run:
    return run(Source("a.mnt", DIM + text), machine={"controller.instruction_time": 1e-9}, until=10.0)


@pytest.mark.parametrize("rule", PROGRAMS)
def test_what_it_prints(rule: str) -> None:
    text, expected = PROGRAMS[rule]
    result = ran(text)
    assert [each.message for each in result.diagnostics if each.severity == "error"] == []
    assert result.output == expected


@pytest.mark.parametrize("text", FAULTS)
def test_the_fault(text: str) -> None:
    assert FAULTS[text] in [each.message for each in ran(text).diagnostics]
