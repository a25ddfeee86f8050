"""What starts the cycle of a machine, and what it needs, as it is played."""

from __future__ import annotations

import pytest

from tests.cli.programs import Cell

# The pump fills itself at power-up, by the same move as in the cycle; a fault jumps back to the idle macro.
FILLER = """\
; i/p 1 tray at stop  2 syrup in hopper  3 nozzle open  4 start key  5 purge key  6 reset
; o/p 9 nozzle  10 red lamp
CT9,CT10
1MN,2MN
1SV50,1SA500,1DS500,2SV100,2SA900,2DS900
MD2,AL0,AR30,CN9,MC3
MD3,IN3,BK,NO,WA0.01,RA30,AA1,AR30,IB40,JP0,NO,MJ80
MD4,CF9,WF3,WN2,1MA20,1WS0.05
MD10,MC2,1MR-6,1WS0.1,MC4
MD20,WN1,MC10,2MR40,2WS0.05,RP2
MD30,IN5,MC10,NO,IN4,MC20,NO,WA0.02,JP0
MD80,CF9,CN10,WN6,WF6,CF10,MJ30
MC4
MJ30
"""
# A menu that also tries a part of the work; the clamp follows its valve, and the pedal is held.
MENU = """\
' IN 0 foot pedal  1 clamp shut  2 guard shut  3 oil ok  5 hand wheel out
' OUT 1 clamp
Dim k As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  k = INKEY
  If k = Asc("1") Then Work()
  If k = Asc("2") Then Bend(0)
  WAIT = 20
End Loop
Sub Work()
  Input "How many ", n
  For i = 1 To n
    PAUSE INX(0)
    Bend(1)
    PAUSE Not INX(0)
    Print "PART "; i
  Next
End Sub
Sub Bend(ByVal all As Integer)
  OUTX(1) = 1
  PAUSE INX(1)
  PAUSE INX(2)
  MOVEA(0) = 40 : GO(0) : PAUSE IDLE(0)
  If Not INX(3) Then Print "LOW OIL"
  MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)
  If all Then MOVER(1) = 5 : GO(1) : PAUSE IDLE(1)
  OUTX(1) = 0
End Sub
"""
# Nobody starts it: the part comes when the stop opens.
BELT = """\
; i/p 1 jar at stop  2 strip present
; o/p 10 jar stop open
CT10
1MN
MD10,WN1,WN2,1MR10,1WS0.05,OT"JAR OK",CN10,WF1,CF10,RP
MC10
"""
# The first cycles fill the machine and are shorter; nobody holds the reset of a fault that does not come.
FILLED = """\
' X0 run switch  X1 film in jaws  X2 seal hot  X3 reset
' Y0 knife
Dim bags(3) As Integer, fault As Integer, i As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  Pause INX(0)
  If fault Then
    Pause INX(3)
    fault = 0
  End If
  MOVER(0) = 20 : GO(0) : Pause IDLE(0)
  For i = 3 To 2 Step -1
    bags(i) = bags(i - 1)
  Next
  bags(1) = INX(1)
  If bags(2) Then
    Wait(600)
    If Not INX(2) Then fault = 1
    If fault Then Print "SEAL COLD"
  End If
  If bags(3) And fault = 0 Then
    OUTX(0) = 1 : Wait(200) : OUTX(0) = 0
    Print "BAG OK"
  End If
End Loop
"""


@pytest.mark.parametrize(
    ("name", "text", "sentence"),
    [
        pytest.param(
            "a.mccl",
            FILLER,
            "input 4 (start key) on starts the cycle with input 1 (tray at stop), input 2 (syrup in hopper) on; "
            "played with input 3 (nozzle open) behind an output or an axis",
            id="filler",
        ),
        pytest.param(
            "a.mccl",
            BELT,
            "input 1 (jar at stop) on starts the cycle with input 2 (strip present) on",
            id="belt",
        ),
        pytest.param(
            "a.mnt",
            FILLED,
            "input 0 (run switch) on starts the cycle with input 1 (film in jaws), input 2 (seal hot) on; played with "
            "input 3 (reset) on",
            id="filled",
        ),
        pytest.param(
            "a.mnt",
            MENU,
            "input 0 (foot pedal) on and key 1 and 'How many' 10 start the cycle with input 1 (clamp shut), "
            "input 2 (guard shut), input 3 (oil ok) on",
            id="menu",
        ),
    ],
)
def test_what_starts_the_cycle_is_played(cell: Cell, name: str, text: str, sentence: str) -> None:
    cell.write(name, text)
    part = cell("map", name, "--all").out.split("Before you change anything\n")[1].split("\n\n")[0]
    assert [each.strip() for each in part.replace("\n      ", " ").splitlines() if " the cycle" in each] == [
        sentence
    ]


def test_macros_that_jump_to_one_another_get_no_deeper_states(cell: Cell) -> None:
    cell.write("a.mccl", FILLER)
    shown = cell("map", "a.mccl", "--all").out.splitlines()
    assert [each.split(":")[0] for each in shown if each.startswith("waits in 12")] == [
        "waits in 12 called in 11, 9, 6",
        "waits in 12 called in 11, 9, 6",
        "waits in 12 called in 11, 10, 9, 6",
        "waits in 12 called in 11, 10, 9, 6",
    ]


# A part takes seven strokes of more than four seconds; macros 60 and 61 are typed by a fitter.
STROKES = """\
; i/p 1 blank in chuck  2 tool down  3 start button  5 fault acknowledged
; o/p 9 tool  10 lamp fault  11 lamp at work
; analogue 1 photocell, more than 4 is good
CT9,CT10,CT11
AL0,AR20
1MN,2MN
1SV50,1SA900,1DS900,2SV100,2SA900,2DS900
MD5,AL0,AR30,CN9,MC6
MD6,IN2,BK,NO,WA0.02,RA30,AA1,AR30,IB50,JP0,NO,MJ90
MD90,CF9,CN10,OT"FAULT TOOL",WN5,WF5,CF10,MJ4
MD1,MC5,1MR100,1WS0.03,CF9,WF2,1MR-100,1WS0.03,2MR5,2WS0.05
MD2,MC1,RP6
MD3,WN1,WN3,CN11,MC2,WA0.5,MC8,CF11,2MA0,2WS0.1,WF1
MD8,GA1,IG4,MC31,BK,MC32
MD31,RA20,AA1,AR20,FT"PART %d GOOD"
MD32,FT"PART REJECTED",CN10,WN5,CF10
; for the fitter: MC60 tries the tool,
; MC61 a stroke without it
MD60,CN9,WA1,CF9
MD61,1MR100,1WS0.03,1MR-100,1WS0.03
MD4,MC3,RP
MC4
"""


def test_the_cycle_is_that_of_a_part_that_takes_long(cell: Cell) -> None:
    cell.write("a.mccl", STROKES)
    shown = cell("map", "a.mccl", "--all").out.splitlines()
    assert shown[shown.index("Cycle") + 1] == "36.461 s, 11 times (lines 8 to 15), cycle(print PART)"
    assert [" ".join(each.split()) for each in shown if "times more" in each] == [
        "4.971 8 6 times more: lines 8, 9, 11 29.828"
    ]


def test_a_comment_of_several_lines_says_what_macros_do(cell: Cell) -> None:
    cell.write("a.mccl", STROKES)
    shown = cell("map", "a.mccl", "--no-run").out.splitlines()
    assert [" ".join(each.split()) for each in shown if each.startswith(("macro 60", "macro 61"))] == [
        "macro 60 19 for the fitter: MC60 tries the tool, MC61 a stroke without it never reached",
        "macro 61 20 never reached",
    ]
