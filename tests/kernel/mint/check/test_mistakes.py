"""Programs with one mistake each: its location, the message and the hint."""

from __future__ import annotations

from motionlang.commands.check import check
from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT
from tests.cases import cases


@cases(
    "text, line, column, message, hint",
    [
        (
            "SPEED(0, 1) = 5",
            1,
            1,
            "SPEED needs 2 values here, 1 value given",
            "end the list with ; to give the last value to all further axes",
        ),
        (
            "SPEED(0) = 5, 6",
            1,
            1,
            "SPEED needs 1 value here, 2 values given",
            "name an axis for each value: SPEED(0, 1) = …",
        ),
        (
            "SPEED(0, 1) = 5, 6, 7",
            1,
            1,
            "SPEED needs 2 values here, 3 values given",
            "name an axis for each value: SPEED(0, 1, 2) = …",
        ),
        (
            "Fill\nEnd\nSub Fll()\nEnd Sub",
            1,
            1,
            "Fill is neither a keyword nor a sub of this program",
            "did you mean Fll?",
        ),
        (
            "Call Fill\nEnd\nSub Fill()\nEnd Sub",
            1,
            1,
            "Call is neither a keyword nor a sub of this program",
            "a sub is called by its name alone: Fill",
        ),
        (
            "Call f\nf=1",
            1,
            1,
            "Call is neither a keyword nor a sub of this program",
            "a sub is called by its name alone",
        ),
        (
            "Fill(q)\nEnd\nSub Fill(ByRef x)\nEnd Sub",
            1,
            6,
            "q is unknown",
            "a variable must be declared or assigned to before it is read",
        ),
        (
            "Dim n As Integer\nFill(n)\nEnd\nSub Fill(ByRef x As Float)\nEnd Sub",
            2,
            6,
            "x is by reference and needs a variable of type Float, not Integer",
            "",
        ),
        (
            "Fill(1)\nEnd\nSub Fill(a() As Float)\nEnd Sub",
            1,
            6,
            "a must be given an array with one subscript",
            "",
        ),
        (
            "Dim b(3) As Integer\nFill(b)\nEnd\nSub Fill(a() As Float)\nEnd Sub",
            2,
            6,
            "a is an array of Float, b one of Integer",
            "",
        ),
        (
            "Const k = POS(0)\nDim a(k)",
            1,
            1,
            "the value of k is not known before the program runs",
            "a Const can use numbers, texts and other constants",
        ),
        ("Const k As String = 5", 1, 1, "k is String, its value is Integer", ""),
        ('Const k As Integer = "a"', 1, 1, "k is Integer, its value is String", ""),
        ("INPUT k\nConst k = 5", 1, 7, "INPUT needs a variable, and k is a const", ""),
        ("INPUT f\nSub f()\nEnd Sub", 1, 7, "INPUT needs a variable, and f is a sub", ""),
        ('PRINT 1 USING "a"', 1, 15, "a width is needed here, not a String", ""),
        (
            'PRINT 1 USING 5, "a"',
            1,
            18,
            "decimals are needed here, not a String",
            "decimals follow the width after a comma; a semicolon ends the item",
        ),
        ("Dim a As Integer = 1, 2", 1, 5, "a is one value, 2 given", ""),
        ("Dim a(2) = 1, 2, 3", 1, 5, "a has 2 elements, 3 values are given", ""),
        ("Dim a(0)", 1, 7, "the size of a must be a whole number of at least 1 that is known beforehand", ""),
        ('a = "x" - 1', 1, 5, "- cannot take a String and an Integer", ""),
        ('a = "x" + 1', 1, 5, "+ cannot take a String and an Integer", "convert the number with Str"),
        ('a = "x" * "y"', 1, 5, "* needs numbers, not texts", ""),
        ('s = "x" < 5', 1, 5, "< cannot take a String and an Integer", ""),
        ("WAIT = 1, 2", 1, 1, "WAIT needs 1 value, 2 given", "WAIT = 100 waits for 100 ms"),
        ("WAIT", 1, 1, "WAIT needs 1 value, 0 given", "WAIT = 100 waits for 100 ms"),
        ('a = IIf(1, 2, "a")', 1, 5, "the two values of IIf must both be numbers or both be texts", ""),
        ("a = Len(5)", 1, 9, "Len needs a text, not a number", "convert the number with Str"),
        ('a = Abs("x")', 1, 9, "a number is needed here, not a String", ""),
        ("a = Abs(1, 2)", 1, 5, "Abs takes 1 value, 2 given", "Abs(number)"),
        ("a = Max(1)", 1, 5, "Max takes 2 values, 1 given", "Max(number, number)"),
        ("n = 1\nn(1) = 2", 2, 1, "n is not an array", ""),
        ("Dim a(3)\na = 5", 2, 1, "a is an array and needs a subscript", ""),
        ("Dim a(3)\na(1, 2) = 5", 2, 1, "a has 1 subscript, 2 are given", ""),
        (
            "Dim a(3)\na(4) = 5",
            2,
            3,
            "there is no element 4: the subscript must be 1 to 3",
            "the first element of an array has the subscript 1",
        ),
        ("x.y = 5", 1, 1, "x is unknown", "a variable must be declared or assigned to before it is read"),
        ("Type t\nDim a As Integer\nEnd Type\nDim p As t\np.b = 5", 5, 1, "t has no member b", ""),
        ("p = 1\nEnd\nTask p\nEnd Task", 1, 1, "p is a task and cannot be assigned to", ""),
        ("Run f\nSub f()\nEnd Sub", 1, 1, "there is no task f", ""),
        ("x = MOVEA(0)", 1, 5, "MOVEA can be written but not read", ""),
        ("POSREMAINING(0) = 5", 1, 1, "POSREMAINING can be read but not written", ""),
        ('SPEED(0) = "a"', 1, 12, "SPEED takes a number, not a text", ""),
        ("x = POS(0, 1)", 1, 5, "POS takes 1 axis in brackets, 2 given", ""),
        ("VECTORA(0, 1) = 5", 1, 1, "VECTORA needs 2 values here, 1 given", "VECTORA(0, 1) = 30, 40"),
        (
            "VECTORA(0) = 5",
            1,
            1,
            "VECTORA needs 2 axes or more in brackets, 1 given",
            "VECTORA(0, 1) = 30, 40",
        ),
        ("For i = 1 To 5 Step 0\nNext", 1, 21, "a For that counts by 0 never ends", "leave it with Exit For"),
        ('While "a"\nWend', 1, 7, "a condition is needed here, not a String", ""),
        (
            'Select Case "a"\nCase 1\nEnd Select',
            2,
            6,
            "an Integer cannot be compared with the String of the Select",
            "",
        ),
        (
            'Select Case 1\nCase "a" To 5\nEnd Select',
            2,
            6,
            "a String cannot be compared with the Integer of the Select",
            "",
        ),
        ("a = 1 / 0", 1, 5, "division by zero", "the divisor is 0 whatever the program does"),
        ("a = 5 Mod 0", 1, 5, "division by zero", "the divisor is 0 whatever the program does"),
        ("INPUT POS(0)", 1, 7, "a variable is needed here, and POS is a keyword", ""),
        ("POS(0).x = 5", 1, 1, "a variable is needed here, and POS is a keyword", ""),
        ("x = POS(0).y", 1, 5, "a variable is needed here, and POS is a keyword", ""),
        ("INPUT _on", 1, 7, "a variable is needed here, and _ON is a keyword", ""),
        ("x = q.r", 1, 5, "q is unknown", "a variable must be declared or assigned to before it is read"),
    ],
)
def test_a_mistake_is_reported_with_its_location(
    text: str, line: int, column: int, message: str, hint: str
) -> None:
    found = [each for each in check(Source("a.mnt", text), DIALECT) if each.severity == "error"]
    assert [(each.line, each.column, each.message, each.hint) for each in found] == [
        (line, column, message, hint)
    ]


@cases("argument", ["POS(0)", "_on", "1", "n + 1", "n", "a(1)"])
def test_a_reference_to_no_variable_is_a_temporary_value(argument: str) -> None:
    """Anything that is no variable, a keyword included, may be passed by reference."""
    text = f"Dim a(3)\nn = 1\nFill({argument})\nEnd\nSub Fill(ByRef x)\nx = 2\nEnd Sub"
    assert [each for each in check(Source("a.mnt", text), DIALECT) if each.severity == "error"] == []
