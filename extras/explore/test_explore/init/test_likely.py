"""`motionlang init` begins where a person would: by the names of inputs, their place, and answers within time-outs.

Each program makes a good piece in one world, which no state of it asks for.
"""

from __future__ import annotations

import json

import pytest

from motionlang.kernel import Source, dialect
from motionlang.kernel.lang import names_in_comments
from motionlang_explore.exploration.likely import Likely
from tests.cli.programs import Cell

RATES = "SPEED(0) = 20 : ACCEL(0) = 2000 : DECEL(0) = 2000\n"
# Three pulses within 0.4 s.
PULSES = """\
Dim n As Integer, last As Integer
Dim t As Time
Loop
  Pause INX(0)
  n = 0 : last = 0 : t = 0
  While n < 3 And t < 400
    If INX(5) = 1 And last = 0 Then n = n + 1
    last = INX(5)
    Wait(2)
  End While
  If n < 3 Then Print "BAD PART" Else Print "welded"
  Wait(2000)
  Pause INX(0) = 0
End Loop
"""
# What an input says has an effect four strokes later.
SHIFT = f"""\
{RATES}
Dim nest(5) As Integer, i As Integer
Pause INX(0)
Loop
  If INX(2) Then nest(1) = 1
  If nest(5) = 1 Then Print "cell passed"
  MOVER(0) = 40 : GO(0) : Pause IDLE(0)
  For i = 5 To 2 Step -1
    nest(i) = nest(i - 1)
  Next
  nest(1) = 0
End Loop
"""
# A load cell reads nothing above, and something within limits below.
SPRINGS = f"""\
{RATES}
Define Guard = INX(0)
Dim force As Float
Loop
  Pause Guard
  If ADC(0) > 3 Then Print "zero error" : Wait(2000)
  MOVEA(0) = 30 : GO(0) : Pause IDLE(0)
  force = ADC(0)
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  If force > 42 And force < 56 Then Print "passed" Else Print "scrap"
End Loop
"""
# A web with a mark each 400 mm, which an encoder measures.
MARKS = """\
Dim marked As Integer, here As Float, last As Float
ENCODERSCALE(2) = 10
SPEED(0) = 600 : ACCEL(0) = 2500 : DECEL(0) = 2500
IMASK(0) = 2
Loop
  Pause marked
  marked = 0
  If Abs(here - last - 400) > 6 Then
    Print "mark out of register"
  Else
    MOVER(0) = 30 : GO(0) : Pause IDLE(0)
    MOVER(0) = -30 : GO(0) : Pause IDLE(0)
    Print "sheet cut"
  End If
  last = here
End Loop
Event IN1
  here = ENCODER(2)
  marked = 1
End Event
"""
# A tray that was seen one place before needs a mark on its film, which a latch takes in the middle of a feed; it is
# counted two places later, with its lid on. A host starts the line.
LATCHED = f"""\
{RATES}
LATCHTRIGGERCHANNEL(0) = 5
Dim tray(4) As Integer, film(4) As Integer, fault As Integer, i As Integer
Loop
  If NETINTEGER(1) = 1 And fault = 0 And INX(2) = 0 Then
    fault = 1
    Print "guard open"
  ElseIf NETINTEGER(1) = 1 And fault = 0 Then
    MOVER(1) = 4 : GO(1) : Pause IDLE(1)
    For i = 4 To 2 Step -1
      tray(i) = tray(i - 1) : film(i) = film(i - 1)
    Next
    tray(1) = INX(1) : film(1) = 0
    If tray(2) Then Seal()
    If film(3) And INX(3) = 0 Then film(3) = 0
    If film(4) And fault = 0 Then Print "tray sealed"
  ElseIf fault Then
    If INX(6) Then fault = 0
  End If
  Wait(20)
End Loop
Sub Seal()
  LATCHENABLE(0) = 1
  MOVER(0) = 9 : GO(0)
  Pause LATCH(0) Or IDLE(0)
  If LATCH(0) Then
    INCA(0) = LATCHVALUE(0) + 2
    Pause IDLE(0)
    film(2) = 1
  Else
    fault = 1
    Print "film mark not found"
  End If
End Sub
"""
# A part, a probe that feels it, and a stop; all are looked at once in a stroke.
PROBE = f"""\
{RATES}
Define Halt = INX(1)
Define TeilImNest = INX(2)
Define TasterUnten = INX(3)
Define Messtaster = OUTX(1)
Dim tested As Integer, last As Integer, bad As Integer
Loop
  Wait(20)
  If Not Halt Then bad = 1
  If Halt And TeilImNest Then
    MOVER(0) = 30 : GO(0) : Pause IDLE(0)
    If TasterUnten Then bad = 1
    Messtaster = 1 : Wait(200)
    If Not TasterUnten Then bad = 1
    Messtaster = 0 : Wait(200)
    tested = tested + 1
    If tested = 4 And Not bad Then Print "four passed"
    If tested = 4 Then tested = 0 : bad = 0
  End If
End Loop
"""
# A host orders a length, which the program reads as a float.
ORDER = f"""\
{RATES}
Dim l As Float
Loop
  Pause NETINTEGER(10) > 0
  NETINTEGER(10) = 0
  l = NETFLOAT(11)
  If l < 60 Or l > 1300 Then
    Print "length refused"
  Else
    MOVER(0) = l / 20 : GO(0) : Pause IDLE(0)
    Print "tube cut"
  End If
End Loop
"""
# A person types how many, and Enter.
TYPED = f"""\
{RATES}
Dim k As Integer, n As Integer, i As Integer
Loop
  Print "how many"
  n = 0 : k = 0
  While k <> 13
    k = INKEY
    If k >= 48 And k <= 57 Then n = 10 * n + k - 48
    Wait(20)
  End While
  For i = 1 To n
    MOVER(0) = 10 : GO(0) : Pause IDLE(0)
    Print "bun glazed"
  Next
End Loop
"""
# A hood and a curtain that are good at 0, as their remarks say; both are looked at in a stroke.
REMARKS = "' IN4 hood (0 = shut)   IN5 curtain ( free = 0 )\n" + PROBE.replace(
    "    If TasterUnten Then bad = 1\n",
    "    If INX(4) Then bad = 1\n    If INX(5) Then bad = 1\n    If TasterUnten Then bad = 1\n",
)
# What says no more than a greeting does not work yet.
GREETING = SHIFT.replace("Pause INX(0)", 'Print "SHIFT LINE READY"\nPause INX(0)')

# A batch that is given up at each board is none, whatever else is done in it.
BATCH = f"""\
' channel 10 vac clamp OK     channel 11 saw up       channel 12 dust hood down
' channel 13 green button     channel 14 red button   channel 15 board against stop
' OUT 10 vac pump, OUT 11 saw motor, OUT 12 saw plunge (air)
Dim want As Integer, done As Integer, i As Integer, ok As Integer
{RATES}Loop
  Input "How many boards? ", want
  done = 0
  While done < want
    ok = oneBoard()
    If ok = 1 Then
      done = done + 1
      Print "Board slotted"
    ElseIf ok = 2 Then
      Print "Batch given up"
      Exit While
    Else
      Print "Board spoiled, next"
    End If
  End While
End Loop

Function oneBoard() As Integer
  Dim tm As Time
  oneBoard = 0
  Pause INX(13) Or INX(14)
  If INX(14) Then
    oneBoard = 2
    Exit Function
  End If
  If Not INX(15) Or Not INX(12) Then
    Print "board or hood?"
    Exit Function
  End If
  OUTX(10) = _ON
  tm = 0
  Pause INX(10) Or tm > 3000
  If Not INX(10) Then
    Print "no vacuum"
    OUTX(10) = _OFF
    Exit Function
  End If
  OUTX(11) = _ON
  For i = 1 To 4
    MOVEA(0) = 5 * i : GO(0) : Pause IDLE(0)
    OUTX(12) = _ON : WAIT = 500
    OUTX(12) = _OFF
    tm = 0
    Pause INX(11) Or tm > 1500
    If Not INX(11) Or Not INX(10) Then
      Print "stopped at fret "; i
      Exit For
    End If
    If i = 4 Then oneBoard = 1
  Next
  OUTX(11) = _OFF : OUTX(12) = _OFF
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  OUTX(10) = _OFF
  Pause Not INX(15)
  Pause INX(15)
End Function
"""
# What is printed with the count of what was bad is a reject, whatever its words say.
COUNTED = f"""\
{RATES}
Dim good As Integer, bad As Integer
Loop
  Pause INX(1)
  MOVER(0) = 25 : GO(0) : Pause IDLE(0)
  Wait(100)
  If INX(6) Then
    good = good + 1
    Print good; " pushed off"
  Else
    bad = bad + 1
    Print bad; " short ones, remelted"
  End If
End Loop
"""
# What a machine says is good overrules the name of an output.
SUCTION = f"""\
{RATES}
' IN 0 start
' OUT 3 scrap suction
Loop
  Pause INX(0)
  MOVER(0) = 25 : GO(0) : Pause IDLE(0)
  If ADC(0) > 38 And ADC(0) < 46 Then
    Print "good cleave"
    OUTX(3) = _ON : Wait(250) : OUTX(3) = _OFF
  Else
    Print "fibre refused"
  End If
End Loop
"""
# An input that ends a slab early leaves less to cut; 13 is the code of Enter, and also a level below 15.
SLAB = f"""\
{RATES}
' IN 0 start  1 end of slab
Loop
  Pause INX(0) And ADC(0) > 15
  MOVEA(0) = 50 : GO(0) : Pause IDLE(0)
  For i = 1 To 8
    MOVER(0) = 5 : GO(0) : Pause IDLE(0)
    Print "bar cut"
    If INX(1) Then Exit For
  Next
  Print "slab done"
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
End Loop
"""


@pytest.mark.parametrize(
    ("text", "good", "bad"),
    [
        pytest.param(PULSES, "welded", "BAD PART", id="pulses", marks=pytest.mark.slow),
        pytest.param(SHIFT, "cell passed", "nothing", id="shift"),
        pytest.param(SPRINGS, "passed", "scrap", id="springs"),
        pytest.param(MARKS, "sheet cut", "nothing", id="marks"),
        pytest.param(LATCHED, "tray sealed", "nothing", id="latched"),
        pytest.param(PROBE, "four passed", "nothing", id="probe"),
        pytest.param(ORDER, "tube cut", "length refused", id="order"),
        pytest.param(TYPED, "bun glazed", "nothing", id="typed"),
        pytest.param(REMARKS, "four passed", "nothing", id="remarks"),
        pytest.param(GREETING, "cell passed", "nothing", id="greeting"),
        pytest.param(COUNTED, " pushed off", "remelted", id="counted"),
        pytest.param(BATCH, "Board slotted", "Batch given up", id="batch"),
        pytest.param(SUCTION, "good cleave", "refused", id="suction"),
        pytest.param(SLAB, "bar cut", "bar cut\nslab done\nbar cut\nslab done", id="slab"),
    ],
)
def test_a_world_with_good_pieces(cell: Cell, text: str, good: str, bad: str) -> None:
    cell.write("old.mnt", text)
    assert cell("init", "old.mnt", "--format", "none").status == 0
    ran = cell("run", "old.mnt", "--until", "60")
    assert ran.out.count(f"{good}\n") >= 6
    assert bad not in ran.out


def test_a_silent_machine_does_not_give_up(cell: Cell) -> None:
    """Without input 3 it stops at the first of eight ribs, asks for a reset, and carries out more of the program."""
    cell.write(
        "old.mnt",
        f"""\
{RATES}
Dim r As Integer, bad As Integer
Dim t As Time
Loop
  Pause INX(0)
  OUTX(4) = 1
  bad = 0
  For r = 1 To 8
    If Not bad Then
      MOVER(0) = 5 : GO(0) : Pause IDLE(0)
      OUTX(1) = 1 : t = 0
      Repeat
        Wait(5)
      Until INX(3) Or t > 700
      If Not INX(3) Then bad = 1
      OUTX(1) = 0 : Wait(60)
    End If
  Next
  OUTX(4) = 0
  If bad Then
    OUTX(6) = 1
    Pause INX(7)
    OUTX(6) = 0
    MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  Else
    OUTX(5) = 1 : Wait(400) : OUTX(5) = 0
  End If
  Pause Not INX(0)
End Loop
""",
    )
    assert cell("init", "old.mnt", "--format", "none").status == 0
    report = json.loads(cell("run", "old.mnt", "--until", "30", "--format", "json").out)
    switched = [each["channel"] for each in report["switched"] if each["value"]]
    assert (switched.count(5) >= 3, 6 in switched) == (True, False)


def test_a_machine_goes_on_after_its_tool_change(cell: Cell) -> None:
    """With the reset on for ever it makes eight pieces; the door must not open in between."""
    cell.write(
        "old.prg",
        """\
AUTO
REM  I/P 0  FOOT SWITCH   1  DOOR (1 = OPEN)   2  PART IN NEST   5  RESET BUTTON
REM  O/P 1  NEST VACUUM   4  GREEN LAMP
SPEED.0 = 300 : ACCEL.0 = 3000 : DECEL.0 = 3000
prints = 0 : open = 0 : was = 0
LOOP
  IF INX.1 DO
    IF open = 0 THEN PRINT "DOOR OPEN"
    open = 1 : OUTX.4 = 0
  ELSE
    open = 0
  ENDIF
  IF open = 0 DO
    OUTX.4 = 1
    IF INX.2 = 1 AND INX.0 = 1 AND was = 0 THEN GOSUB STAMP
    was = INX.0
  ENDIF
  WAIT = 10
ENDL
END

#STAMP
  OUTX.1 = 1
  MOVEA.0 = 55 : GO.0 : PAUSE IDLE.0
  WAIT = 150
  MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
  OUTX.1 = 0
  PAUSE INX.2 = 0
  prints = prints + 1
  PRINT "print ok"
  IF prints >= 8 DO
    PRINT "CHANGE PAD THEN RESET"
    PAUSE INX.5
    PAUSE INX.5 = 0
    prints = 0
  ENDIF
RETURN
""",
    )
    assert cell("init", "old.prg", "--format", "none").status == 0
    printed = cell("run", "old.prg", "--until", "30").out.splitlines()
    assert (printed.count("print ok") > 8, "DOOR OPEN" in printed) == (True, False)


# What a person resets has words of no kind: no level is above 200 %, and a step waits for the reset elsewhere.
AT_ONCE = f"""\
' IN 1 start  4 plate down  7 fault reset
{RATES}
Loop
  Pause INX(1)
  MOVER(0) = 20 : GO(0) : Pause IDLE(0)
  OUTX(1) = 1 : Wait(500) : OUTX(1) = 0
  If INX(4) And ADC(0) > 200 Then
    Print "bullet on tray"
  Else
    Print "TRIP 2"
    Pause INX(7)
    MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  End If
  Pause Not INX(1)
End Loop
"""
IN_A_STEP = f"""\
' IN 1 start  4 plate down  7 fault reset
{RATES}
Dim nStep As Integer = 0
Loop
  Select Case nStep
  Case 0
    If INX(1) Then nStep = 1
  Case 1
    MOVER(0) = 20 : GO(0) : Pause IDLE(0)
    OUTX(1) = 1 : Wait(500) : OUTX(1) = 0
    If INX(4) And ADC(0) > 200 Then
      Print "bullet on tray"
      nStep = 2
    Else
      Print "TRIP 2"
      nStep = 9
    End If
  Case 2
    If Not INX(1) Then nStep = 0
  Case 9
    Pause INX(7)
    MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
    nStep = 2
  End Select
  Wait(5)
End Loop
"""


IN_A_LOOP = AT_ONCE.replace("Pause INX(7)", "While Not INX(7) : Wait(20) : End While")


@pytest.mark.parametrize("text", [AT_ONCE, IN_A_STEP, IN_A_LOOP], ids=["at once", "in a step", "in a loop"])
def test_what_a_person_resets_is_no_good_piece(cell: Cell, text: str) -> None:
    cell.write("old.mnt", text)
    ran = cell("init", "old.mnt")
    assert ran.status == 1
    assert "no good piece was found: the best cycle prints 'TRIP 2'" in ran.err


def test_a_horn_before_each_move_is_no_alarm(cell: Cell) -> None:
    cell.write(
        "old.mnt",
        f"' IN 1 start\n' OUT 1 horn\n{RATES}\nLoop\n  Pause INX(1)\n  OUTX(1) = 1 : Wait(400) : OUTX(1) = 0\n"
        '  MOVER(0) = 20 : GO(0) : Pause IDLE(0)\n  Print "over"\n  Pause Not INX(1)\nEnd Loop\n',
    )
    assert cell("init", "old.mnt").status == 0


def test_an_answer_is_compared_behind_a_later_question(cell: Cell) -> None:
    """A length of 10, a usual answer, is too short; it is asked for before the number of plies."""
    cell.write(
        "old.prg",
        """\
#JOB
INPUT "length ",length
INPUT "plies ",plies
IF length < 500 OR length > 9000 THEN ? "not possible" : GOTO JOB
WHILE plies > 0
  MOVEA.0 = length : GO.0 : PAUSE IDLE.0
  MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
  ? "ply laid"
  plies = plies - 1
ENDW
GOTO JOB
""",
    )
    assert cell("init", "old.prg", "--format", "none").status == 0
    printed = cell("run", "old.prg").out
    assert printed.count("ply laid") >= 3
    assert "not possible" not in printed


@pytest.mark.parametrize(
    ("header", "text", "rule"),
    [
        # By its name, the input follows the output of the clamp, not the one that is switched before it is read.
        (
            "channel 4 clamp shut  channel 8 air  channel 9 clamp valve",
            "OUTX(9) = 1\nOUTX(8) = 1\nPAUSE INX(4)\n",
            {"output": 9, "delay": 0.1},
        ),
        # It is asked for where the clamp has been switched off.
        (
            "channel 4 clamp left  channel 9 clamp valve",
            "OUTX(9) = 0\nPAUSE INX(4)\n",
            {"output": 9, "delay": 0.1, "value": 0},
        ),
        (
            "channel 4 paper in tray  channel 9 lamp paper out",
            "OUTX(9) = 1\nMOVER(0) = 9\nPAUSE INX(4)\n",
            {"at": 0.0},
        ),
        ("channel 4 bag wanted (foot switch below)", "PAUSE INX(4)\n", {"asked": 0.3, "for": 1.0}),
    ],
)
def test_the_names_and_the_text_suggest_what_an_input_follows(
    header: str, text: str, rule: dict[str, object]
) -> None:
    source, language = Source("old.mnt", f"' {header}\n{text}"), dialect("mint")
    likely = Likely(language.program(source).structure, names_in_comments(source, language), source)
    assert likely.rules(4)[0] == rule
