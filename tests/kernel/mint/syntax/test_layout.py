"""The indentation of the lines of a text, also of one that has errors."""

from __future__ import annotations

from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT as MINT

# The levels by which a line moves back and by which the lines below it change. A line with `c` continues
# another one, and one with `u` is unreadable.
LINES = """\
0 +1  |#first
0 +0  |WAIT = 1
0 +0  |If INX(1) Then Return
1 -1  |Return
0 +1  |Startup
0 +0  |  SPEED(0) = 5
1 -1  |End Startup
0 +1  |While a
0 +1  |  If b Then
0 +0  |    PRINT 1
1 +0  |  Else If c Then
0 +0  |    PRINT 2
1 +0  |  ElseIf d Then
0 +0  |    PRINT 3
1 +0  |  Else
0 +0  |    If e Then PRINT 4 Else PRINT 5
1 -1  |  End If
0 +0  |  If f Then : : PRINT 6
0 +1  |  If f Then :
0 +0  |    PRINT 7
1 -1  |  End If
1 -1  |End While
0 +1  |For i = 1 To 2
0 +1  |  For j = 1 To 2 : PRINT j
2 -2  |Next j, i
0 +0  |For k = 1 To 2 : PRINT k : Next
0 +0  |Repeat : a = 1 : Until a
0 +1  |Loop
0 +0  |  Exit Loop
1 -1  |End Loop
0 +1  |Select Case a
1 +0  |Case 1
0 +0  |  PRINT 1
1 +0  |Case Else
0 +0  |  If a Then PRINT 2 : Loop : End Loop
1 -1  |End Select
0 +1  |IF a DO
0 +0  |  x = 1 + _
0 +0 c|    2
1 -1  |ENDIF
0 +1  |routine:
0 +1  |  Loop
0 +0  |    Return
1 -1  |  ENDL
0 +0  |  If a Then PRINT 1 Else Return
0 -1  |  x = 1 : Return
0 +0  |x = 1
0 +0  |Return
0 +1  |Task t
0 +1  |  Sub inner(ByVal a)
0 +0  |    Exit Sub
1 -1  |  End Sub
0 +0  |  End t
1 -1  |End Task
0 +1  |Type pair
0 +0  |  Dim n As Integer
1 -1  |End Type
0 +0  |Event IN1 : PRINT 1 : End Event
0 +1  |Function f(x) As Float
0 +0 u|  f = “
0 +0  |  TASK = 5
1 -1  |End Function
1 -1  |Wend
0 +0  |Goto last
0 +0  |last:
0 +0  |PRINT 1
"""


def rows() -> list[tuple[str, str]]:
    """Return the columns of `LINES`: the expected layout and the text."""
    return [(row[:6].rstrip(), row[7:]) for row in LINES.splitlines()]


def source() -> Source:
    return Source("a.mnt", "\n".join(text for _, text in rows()))


def test_the_layout_of_each_line() -> None:
    """A `Return` ends the routine of a label, unless an If or a loop contains it."""
    found = []
    for line in MINT.program(source()).layout:
        mark = " c" if line.continues else " u" if line.unreadable else ""
        found.append(f"{line.back} {line.change:+d}{mark}")
    assert found == [expected for expected, _ in rows()]


def test_a_label_within_a_v4_routine_does_not_end_it() -> None:
    """A routine begins at a label that the statement before does not reach."""
    text = (
        "x = 1 : END\n#drill\nx = 1\nagain:\nx = x + 1\nIF x < 5 THEN GOTO again\n#last\nx = 0 : RETURN\n"
        "\n#next\nx = 2\nRETURN\nstart:\nGOTO start\n#third\nx = 3\nRETURN\n#fault\nEND\n"
    )
    lines = text.split("\n")
    made = enumerate(MINT.program(Source("a.mnt", text)).layout)
    found = [(lines[number], line.change) for number, line in made if line.change]
    assert [name for name, change in found if change > 0] == ["#drill", "#next", "#third"]
    assert [name for name, change in found if change < 0] == ["x = 0 : RETURN", "RETURN", "RETURN"]
