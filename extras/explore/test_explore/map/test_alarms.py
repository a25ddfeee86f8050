"""What says that something is wrong, why it comes by the text of a program, and what was played that ends it."""

from __future__ import annotations

import pytest

from motionlang_explore.map import plays
from tests.cli.programs import Cell

# Steps in a variable, a count, times, two buttons that reset, and alarms that no trial reaches.
STEPS = """\
REM IN 1 cycle start  2 curtain clear  3 label on pad  5 reset right  6 reset left  7 air on
REM OUT 1 vacuum  2 alarm horn
s = 0 : tries = 0 : made = 0
#MAIN
IF INX.7 = 0 AND s < 90 THEN er = 7 : s = 90
IF s = 0 THEN GOSUB READY
IF s = 10 THEN GOSUB PICK
IF s = 20 THEN GOSUB PLACE
IF s = 90 THEN GOSUB ALARM
WAIT = 5
GOTO MAIN
#READY
IF INX.1 AND INX.2 THEN s = 10 : tt = TIME : OUTX.1 = 1
RETURN
#PICK
IF INX.3 THEN s = 20 : tries = 0 : RETURN
IF TIME - tt < 2000 THEN RETURN
tries = tries + 1
IF tries > 2 THEN er = 3 : s = 90 : RETURN
tt = TIME
RETURN
#PLACE
MOVEA.0 = 120 : GO.0 : PAUSE IDLE.0
made = made + 1
IF made > 4000 THEN ? "FILTER NOT CLEAN"
PAUSE NOT INX.3
MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
s = 0
RETURN
#ALARM
OUTX.2 = 1
IF er = 3 THEN ? "NO LABEL"
IF er = 7 THEN ? "AIR"
PAUSE INX.6
PAUSE INX.5
OUTX.2 = 0 : s = 0
RETURN
"""
# Numbers of alarms that a sub, a handler and the program set, which the host reads and clears.
NUMBERS = """\
' IN 1 guard open  2 air on  3 tray
' OUT 5 red lamp
Dim nAlarm As Integer
Dim t As Time
Loop
  COMMS(12) = nAlarm
  If Not INX(2) Then Failed(2)
  If nAlarm Then
    OUTX(5) = 1
    Print "alarm "; nAlarm
    Pause COMMS(1) = 3 And INX(1) = 0
    nAlarm = 0 : OUTX(5) = 0
  ElseIf INX(3) Then
    MOVER(0) = 10 : GO(0) : Pause IDLE(0)
    t = 0
    Pause Not INX(3) Or t > 500
    If INX(3) Then Failed(3)
  End If
  Wait(10)
End Loop
Sub Failed(ByVal n As Integer)
  nAlarm = n
End Sub
Event IN1
  STOP(0)
  Failed(1)
End Event
"""
MACROS = """\
; INPUTS 1 gate shut, 3 vacuum ok, 5 reset
; OUTPUTS 9 vacuum, 11 fault lamp
MD10,IF1,MJ90,NO,AL0,AR31,CN9,MJ21
MD21,IN3,MJ30,NO,WA.01,RA31,AA1,AR31,IG49,MJ80,NO,MJ21
MD30,CF9,2MR10,2WS.1,MJ10
MD80,CN11,OT"NO VACUUM",WN5,CF11,MJ10
MD90,OT"GATE NOT SHUT",WN1,MJ10
2MN
MC10
"""
# A flag that something else has set, and a loop that ends by a sensor or a time.
FLAGS = """\
REM IN 1 lid shut  2 green button  4 ram down
going = 0
LOOP
  IF INX.1 = 0 DO
    IF going = 1 DO
      going = 0
      OUTX.0 = 0
      PRINT "STOPPED"
    ENDIF
  ENDIF
  IF INX.2 = 1 AND INX.1 = 1 AND going = 0 DO
    going = 1 : late = 0
    OUTX.0 = 1
    MOVER.0 = 20 : GO.0 : PAUSE IDLE.0
    TIME = 0
    WHILE INX.4 = 0 AND late = 0
      IF TIME > 1500 THEN late = 1
    ENDW
    IF late = 1 THEN PRINT "RAM STUCK"
    PAUSE INX.2 = 0
  ENDIF
  WAIT = 10
ENDL
"""
# Levels, a fault, and a loop of GOTOs that counts.
LEVELS = """\
REM IN 1 stop  4 cutter down
fmin = 42 : fmax = 58
#NEXT
PAUSE INX.2
MOVEA.0 = 40 : GO.0 : PAUSE IDLE.0
peak = ADC.0
IF peak < fmin OR peak > fmax THEN ? "force: reject"
t = 0
#CUT
IF INX.4 THEN GOTO BACK
WAIT = 10
t = t + 1
IF t < 80 THEN GOTO CUT
? "CUTTER STUCK" : GOTO OUT
#BACK
MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
IF INX.1 THEN ? "stopped" : GOTO OUT
GOTO NEXT
#OUT
END
#ONERROR
? "ERROR ", ERR
RETURN
"""

# A lamp that each scan writes while a step waits for its reset, behind two texts of which a move is still made.
LAMP = """\
REM IN 1 start  2 door shut  3 vacuum ok  4 reset
REM OUT 1 vacuum  4 fault lamp
SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000
phase = 0
LOOP
  IF phase = 0 AND INX.1 AND INX.2 DO
    OUTX.1 = 1 : tt = TIME : phase = 1
  ENDIF
  IF phase = 1 DO
    IF INX.3 THEN phase = 2
    IF phase = 1 AND TIME - tt > 2000 THEN ? "FAULT: no vacuum" : phase = 9
  ENDIF
  IF phase = 2 DO
    MOVEA.0 = 50 : GO.0 : PAUSE IDLE.0
    IF INX.3 = 0 THEN ? "FAULT: dropped" : phase = 9
    IF phase = 2 THEN ? "PART OK" : phase = 3
    MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
    OUTX.1 = 0
  ENDIF
  IF phase = 3 AND INX.1 = 0 THEN phase = 0
  IF phase = 9 DO
    OUTX.1 = 0 : OUTX.4 = 1
    IF INX.4 THEN OUTX.4 = 0 : phase = 3
  ENDIF
  WAIT = 5
ENDL
"""
# A function that returns 1 but for a time, hands that are looked at together, and a gauge that another task scales.
HANDS = """\
' IN 0 pedal  1 clamp shut  2 left hand  3 right hand  4 reset
' OUT 1 clamp
' AD 0 gauge
Dim ok As Integer, depth As Float, checked As Integer, right As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Run Gauge
Loop
  Pause INX(0)
  OUTX(1) = 1
  If Seen(1, 800) = 0 Then
    Print "FAULT clamp"
    Pause INX(4)
  Else
    ok = 1
    MOVEA(0) = 20 : GO(0) : Pause IDLE(0)
    If (INX(2) And INX(3)) = 0 Then ok = 0
    MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
    checked = 0
    Pause checked
    If ok = 0 Then Print "HANDS OFF, SCRAP"
    If right = 1 Then Print "PART OK" Else Print "REJECT"
  End If
  OUTX(1) = 0
  Pause Not INX(0)
End Loop
Task Gauge
  Loop
    Pause checked = 0
    depth = ADC(0) * 0.5
    If depth > 21 Then right = 0 Else right = 1
    checked = 1
  End Loop
End Task
Function Seen(channel As Integer, ms As Integer) As Integer
  Dim t As Integer
  t = TIME
  Seen = 1
  While Not INX(channel)
    If TIME - t > ms Then
      Seen = 0
      Exit Function
    End If
    Wait = 10
  End While
End Function
"""
# A guard and faults by number that one sub tells, a flag that is set before the sheet is felt, and a magazine.
STAPLER = """\
' IN 0 start  1 guard shut  2 staple formed  3 double sheet  4 reset
' OUT 0 head  1 red lamp
Dim told As Integer, twice As Integer, fault As Integer, done As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  If Not INX(1) Then
    If told = 0 Then Print "guard open"
    told = 1
    OUTX(1) = 1
  Else
    If told = 1 Then Print "guard shut again"
    told = 0
    If fault = 0 Then OUTX(1) = 0
    If fault > 0 Then
      If INX(4) Then Clear()
    ElseIf INX(0) Then
      Staple()
    End If
  End If
  Wait(10)
End Loop
Sub Staple()
  If INX(3) Then twice = 1 Else twice = 0
  MOVEA(0) = 20 : GO(0) : Pause IDLE(0)
  OUTX(0) = 1
  Wait(200)
  OUTX(0) = 0
  If INX(2) Then
    If twice = 1 Then Fail(3) Else Count()
  Else
    Fail(2)
  End If
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
End Sub
Sub Count()
  Print "STAPLED"
  done = done + 1
  If done >= 6 Then
    Print "magazine low"
    done = 0
  End If
End Sub
Sub Fail(ByVal n As Integer)
  fault = n
  OUTX(1) = 1
  Select Case n
  Case 2
    Print "NO STAPLE"
  Case Else
    Print "FAULT ", n
  End Select
End Sub
Sub Clear()
  Print "fault ", fault, " cleared"
  fault = 0
  OUTX(1) = 0
End Sub
"""
# What a function returns that waits, asked in three spellings, by a part that two keys call.
SEEN = """\
' IN 0 part in  1 clamp shut  2 ram down  3 ram up  4 reset
Dim k As Integer
Dim n As Integer
Loop
  k = INKEY
  If k = Asc("1") Then Stroke()
  If k = Asc("2") Then
    PAUSE INX(0)
    Stroke()
    Print "PART OK"
  End If
  WAIT = 20
End Loop
Sub Stroke()
  OUTX(1) = 1
  If Seen(1, 500) = 0 Then Print "NO CLAMP"
  MOVEA(0) = 40 : GO(0) : PAUSE IDLE(0)
  If Not Seen(2, 800) Then Print "RAM STUCK"
  MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)
  n = Seen(3, 1200)
  If n = 0 Then
    Print "RAM LOW"
    PAUSE INX(4)
  End If
  OUTX(1) = 0
  If Not Comes(1, 0, 600) Then Print "CLAMP STUCK"
End Sub
Function Seen(ByVal sensor As Integer, ByVal ms As Integer) As Integer
  TIME = 0
  Seen = 0
  Repeat
    If INX(sensor) Then Seen = 1
    WAIT = 5
  Until Seen = 1 Or TIME > ms
End Function
Function Comes(ByVal sensor As Integer, ByVal level As Integer, ByVal ms As Integer) As Integer
  Dim t0 As Integer
  t0 = TIME
  While INX(sensor) <> level And TIME - t0 < ms
    WAIT = 5
  End While
  Comes = (INX(sensor) = level)
End Function
"""
# The reset is pushed at power-up, too, and nobody holds it behind an alarm; a part comes behind an output.
HELD = """\
; i/p 1 jar at stop  2 strip present  3 fault reset  4 knife down
; o/p 9 knife  10 jar stop open  12 red lamp
CT9,CT10,CT12
1MN
MD30,CN9,AL50,AR30,MC35,CF9
MD35,IN4,JR10,NO,WA0.02,RA30,AS1,AR30,IG0,JR-8,NO,MC90,NO
MD60,OT"STRIP EMPTY",CN12,WN2,WN3,CF12
MD90,CF9,CN12,OT"KNIFE FAULT",WN3,CF12
MD10,IF2,MC60,NO,WN1,1MR10,1WS0.05,MC30,OT"JAR OK",CN10,WF1,CF10,RP
MD5,WN3,CN10,WA0.2,CF10
MC5
MC10
"""
# A number that tells the faults apart, and an emergency stop that is let go before the reset.
CODES = """\
' in 1 start  2 part there  4 emergency stop  5 reset
' out 1 chuck  2 red lamp
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Dim parts As Integer, t As Integer, fault As Integer
Loop
  Pause INX(1)
  fault = 0 : OUTX(1) = 1 : t = TIME
  Repeat
    Wait(10)
  Until INX(2) Or TIME - t > 1500
  If INX(2) = 0 Then fault = 1
  If fault = 0 Then
    MOVEA(0) = 80 : GO(0) : Pause IDLE(0)
    If INX(2) = 0 And fault = 0 Then fault = 3
    MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  End If
  OUTX(1) = 0
  If fault Then
    OUTX(2) = 1
    Print "FAULT "; fault
    Pause INX(4) = 0
    Pause INX(5)
    OUTX(2) = 0
  Else
    parts = parts + 1
    Print "part "; parts
  End If
  If parts Mod 5 = 0 Then Print "box full" : Pause INX(6) : Pause Not INX(6)
  Pause Not INX(1)
End Loop
Event IN4
  STOP(0)
  fault = 4
End Event
"""
# One input with two texts: where the cycle begins, and in the middle of it.
CURTAIN = """\
' in 1 start  3 curtain free  5 reset
' out 2 red lamp
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Dim parts As Integer
Loop
  If INX(3) = 0 Then Print "CURTAIN BROKEN" : Pause INX(3)
  Pause INX(1)
  MOVEA(0) = 80 : GO(0) : Pause IDLE(0)
  If INX(3) = 0 Then OUTX(2) = 1 : Print "ALARM curtain" : Pause INX(5) : OUTX(2) = 0
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  parts = parts + 1 : Print "part "; parts
  Pause Not INX(1)
End Loop
"""
# A sub that takes the sensor from what is wanted.
WANTED = """\
REM IN 1 start  3 valve at nozzle  4 valve at hopper  5 reset
REM OUT 0 valve  3 red lamp
SPEED.1 = 100 : ACCEL.1 = 1000 : DECEL.1 = 1000
LOOP
  PAUSE INX.1
  way = 0 : GOSUB turn
  MOVEA.1 = 40 : GO.1 : PAUSE IDLE.1
  way = 1 : GOSUB turn
  MOVEA.1 = 0 : GO.1 : PAUSE IDLE.1
  ? "POUR OK"
  PAUSE INX.1 = 0
ENDL
#turn
  OUTX.0 = way
  t0 = TIME
  eye = 3 : IF way = 0 THEN eye = 4
  REPEAT
    there = INX[eye]
  UNTIL there = 1 OR TIME - t0 > 1500
  IF there = 0 DO
    ? "VALVE FAULT ", eye
    OUTX.3 = 1
    PAUSE INX.5
    OUTX.3 = 0
  ENDIF
RETURN
"""
# A part that is missing three times in a row, and a level on which both sides are refused, with what was measured.
MISSING = """\
' IN 1 start  6 ball seen  7 reset
' ADC 0 weight
Dim missed As Integer
SPEED(0) = 20 : ACCEL(0) = 200 : DECEL(0) = 200
Loop
  Pause INX(1)
  MOVER(0) = 10 : GO(0) : Pause IDLE(0)
  If INX(6) = 0 Then
    missed = missed + 1
    Print "no ball, ", missed
    If missed = 3 Then
      Print "ALARM three missing"
      Pause INX(7)
      missed = 0
    End If
  ElseIf ADC(0) < 40 Or ADC(0) > 60 Then
    Print "reject, ", ADC(0) * 1.5
  Else
    missed = 0
    Print "ball good"
  End If
End Loop
"""


@pytest.mark.parametrize(
    ("name", "text", "lines"),
    [
        pytest.param(
            "a.prg",
            STEPS,
            [
                "output 2 (alarm horn) comes with 'AIR' and 'NO LABEL'",
                "'NO LABEL' comes by input 3 (label on pad) off 6 s after line 27, line 32; ends by input 6 "
                "(reset left) on, then input 5 (reset right) on, and comes again without input 3 (label on pad) on",
                "'AIR' comes by input 7 (air on) off, line 33; ends by input 7 (air on) on, then input 6 (reset "
                "left) on, then input 5 (reset right) on",
                "'FILTER NOT CLEAN' comes by `made > 4000`, line 25 (not played)",
            ],
            id="steps",
            marks=pytest.mark.slow,
        ),
        pytest.param(
            "a.mnt",
            NUMBERS,
            [
                "comms element 12 = 1 and 'alarm 1' come by input 1 (guard open) on, line 6; ends by input 1 "
                "(guard open) off, then comms element 1 = 3",
                "comms element 12 = 3 and 'alarm 3' come by input 3 (tray) on 0.5 s after line 14, line 6; ends "
                "by input 3 (tray) off, then comms element 1 = 3",
                "output 5 (red lamp) comes with 'alarm 1', 'alarm 2' and 'alarm 3'",
                "'alarm 2' comes by input 2 (air on) off, line 10; ends by input 2 (air on) on, then comms "
                "element 1 = 3",
            ],
            id="numbers",
        ),
        pytest.param(
            "a.mccl",
            MACROS,
            [
                "output 11 (fault lamp) and 'NO VACUUM' come by input 3 (vacuum ok) off 0.5 s after line 3, line "
                "6; ends by input 3 (vacuum ok) on, then input 5 (reset) on",
                "'GATE NOT SHUT' comes by input 1 (gate shut) off, line 7; ends by input 1 (gate shut) on",
            ],
            id="macros",
        ),
        pytest.param(
            "a.prg",
            LAMP,
            [
                "'FAULT: no vacuum' comes by input 3 (vacuum ok) off 2 s after line 7, line 11; ends by input 4 "
                "(reset) on, and comes again without input 3 (vacuum ok) on",
                "'FAULT: dropped' and output 4 (fault lamp) come by input 3 (vacuum ok) off, line 15; ends by "
                "input 4 (reset) on",
            ],
            id="lamp",
        ),
        pytest.param(
            "a.mnt",
            HANDS,
            [
                "'FAULT clamp' comes by input 1 (clamp shut) off 0.8 s after line 9, line 11; ends by input 4 "
                "(reset) on, and comes again without input 1 (clamp shut) on",
                "'HANDS OFF, SCRAP' comes by input 2 (left hand) off or input 3 (right hand) off, line 20",
                "'REJECT' comes by analogue input 0 (gauge) = 44, line 21",
            ],
            id="hands",
        ),
        pytest.param(
            "a.mnt",
            STAPLER,
            [
                "'guard open' and output 1 (red lamp) come by input 1 (guard shut) off, line 7; ends by input 1 "
                "(guard shut) on",
                "output 1 (red lamp) comes with 'FAULT 3' and 'NO STAPLE'",
                "'NO STAPLE' comes by input 2 (staple formed) off, line 48; ends by input 2 (staple formed) on, "
                "then input 4 (reset) on",
                "'FAULT 3' comes by input 3 (double sheet) on, line 50; ends by input 3 (double sheet) off, then "
                "input 4 (reset) on",
                "'magazine low' comes after 6 cycles, line 39",
            ],
            id="stapler",
        ),
        pytest.param(
            "a.mnt",
            SEEN,
            [
                "'NO CLAMP' comes by input 1 (clamp shut) off 0.5 s after line 15, line 16",
                "'RAM STUCK' comes by input 2 (ram down) off 0.8 s after line 17, line 18",
                "'RAM LOW' comes by input 3 (ram up) off 1.2 s after line 19, line 22; ends by input 4 (reset) "
                "on, and comes again without input 3 (ram up) on",
                "'CLAMP STUCK' comes by input 1 (clamp shut) on 0.6 s after line 25, line 26",
            ],
            id="function",
        ),
        pytest.param(
            "a.mccl",
            HELD,
            [
                "'STRIP EMPTY' and output 12 (red lamp) come by input 2 (strip present) off, line 7; ends by "
                "input 2 (strip present) on, then input 3 (fault reset) on",
                "output 12 (red lamp) and 'KNIFE FAULT' come by input 4 (knife down) off 1 s after line 5, line "
                "8; ends by input 3 (fault reset) on, and comes again without input 4 (knife down) on",
            ],
            id="held",
        ),
        pytest.param(
            "a.mnt",
            CODES,
            [
                "output 2 (red lamp) comes with 'FAULT 1', 'FAULT 3' and 'FAULT 4'",
                "'FAULT 3' comes by input 2 (part there) off, line 20; ends by input 5 (reset) on",
                "'FAULT 4' comes by input 4 (emergency stop) on, line 20; ends by input 4 (emergency stop) off, then "
                "input 5 (reset) on",
                "'FAULT 1' comes by input 2 (part there) off 1.5 s after line 7, line 20; ends by input 5 "
                "(reset) on, and comes again without input 2 (part there) on",
            ],
            id="codes",
        ),
        pytest.param(
            "a.mnt",
            CURTAIN,
            [
                "'CURTAIN BROKEN' comes by input 3 (curtain free) off, line 6; ends by input 3 (curtain free) on",
                "output 2 (red lamp) and 'ALARM curtain' come by input 3 (curtain free) off, line 9; ends by input 5 "
                "(reset) on",
            ],
            id="curtain",
        ),
        pytest.param(
            "a.prg",
            WANTED,
            [
                "'VALVE FAULT 3' comes by input 3 (valve at nozzle) off 1.5 s after line 14, line 21; ends by "
                "input 5 (reset) on, and comes again without input 3 (valve at nozzle) on",
                "'VALVE FAULT 4' comes by input 4 (valve at hopper) off 1.5 s after line 14, line 21; ends by "
                "input 5 (reset) on, and comes again without input 4 (valve at hopper) on",
                "output 3 (red lamp) comes with 'VALVE FAULT 3' and 'VALVE FAULT 4'",
            ],
            id="wanted",
        ),
        pytest.param(
            "a.mnt",
            MISSING,
            [
                "'no ball, ...' comes by input 6 (ball seen) off, line 10",
                "'ALARM three missing' comes by input 6 (ball seen) off after 'no ball, ...' 3 times, line 12; "
                "ends by input 7 (reset) on, and comes again without input 6 (ball seen) on",
                "'reject, ...' comes by analogue input 0 (weight) = 38 or 62, line 17",
            ],
            id="missing",
        ),
        pytest.param(
            "a.prg",
            FLAGS,
            [
                "'RAM STUCK' comes by input 4 (ram down) off 1.5 s after line 14, line 19",
                "'STOPPED' comes by input 1 (lid shut) off in 4, 11, 22, line 8; what ends it was not played",
            ],
            id="flags",
        ),
        pytest.param(
            "a.prg",
            LEVELS,
            [
                "'force: reject' comes by analogue input 0 = 40 or 60, line 7",
                "'CUTTER STUCK' comes by input 4 (cutter down) off 0.8 s after line 5, line 14",
                "'stopped' comes by input 1 (stop) on, line 17",
                "'ERROR' comes by event ONERROR, line 21 (not played)",
            ],
            id="levels",
            marks=pytest.mark.slow,
        ),
    ],
)
def test_alarms_have_the_reasons_of_their_branches_and_all_steps_of_their_reset(
    cell: Cell, name: str, text: str, lines: list[str]
) -> None:
    cell.write(name, text)
    part = cell("map", name, "--all").out.split("Before you change anything\n")[1].split("\n\n")[0]
    assert [
        each.strip()
        for each in part.replace("\n      ", " ").splitlines()
        if " come" in each or each.strip() in lines
    ] == lines


# The door is looked at between the moves, the stop button before a piece; key 9 ends the shift.
STOPS = """\
REM IN 1 start  2 door shut  3 stop released
AUTO
SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000
over = 0
WHILE over = 0
  IF INKEY = 57 THEN over = 1
  IF INX.1 AND INX.3 DO
    MOVEA.0 = 50 : GO.0 : PAUSE IDLE.0
    PAUSE INX.2
    MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
    ? "PART OK"
    PAUSE INX.1 = 0
  ENDIF
  WAIT = 5
ENDW
"""


def test_what_stops_the_machine_between_its_moves_is_played(cell: Cell) -> None:
    cell.write("a.prg", STOPS)
    shown = cell("map", "a.prg", "--all").out.splitlines()
    assert [line.strip() for line in shown if "stops the machine" in line or "cuts off" in line] == [
        "nothing that was played cuts off a move to a target",
        "input 2 (door shut) off in the move of line 8 stops the machine behind line 8",
        "input 3 (stop released) off or key 9 in the move of line 8 stops the machine at the end of its cycle",
    ]


# The tip is looked at behind the press, and refused in the next cycle before it; the guard is asked for before a start.
NEXT_CYCLE = """\
REM IN 1 start  2 guard shut  3 tip in tube  4 reset   OUT 1 alarm lamp
AUTO
SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000
tip = 1
LOOP
  PAUSE INX.1
  IF INX.2 = 0 DO
    ? "SHUT THE GUARD"
    PAUSE INX.2
  ENDIF
  MOVEA.0 = 50 : GO.0 : PAUSE IDLE.0
  IF tip = 0 OR INX.2 = 0 DO
    OUTX.1 = 1
    IF tip = 0 THEN ? "ALARM NO TIP"
    IF INX.2 = 0 THEN ? "ALARM GUARD"
    PAUSE INX.4
    OUTX.1 = 0
  ENDIF
  tip = INX.3
  MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
  ? "PART OK"
  WAIT = 200
ENDL
"""


def test_a_lamp_comes_with_the_texts_of_its_own_plays_and_an_alarm_ends_for_good(cell: Cell) -> None:
    cell.write("a.prg", NEXT_CYCLE)
    shown = cell("map", "a.prg", "--all").out.replace("\n      ", " ").splitlines()
    assert [line.strip() for line in shown if "stops the machine" in line or " come" in line] == [
        "input 1 (start) off in the move of line 11 stops the machine at the end of its cycle",
        "input 2 (guard shut) off in the move of line 11 stops the machine behind line 11",
        "input 3 (tip in tube) off in the move of line 11 stops the machine in its next cycle, behind line 11",
        "'SHUT THE GUARD' comes by input 2 (guard shut) off, line 8; ends by input 2 (guard shut) on",
        "output 1 (alarm lamp) comes with 'ALARM GUARD' and 'ALARM NO TIP'",
        "'ALARM NO TIP' comes by input 3 (tip in tube) off, line 14; ends by input 4 (reset) on, and comes again "
        "without input 3 (tip in tube) on",
        "'ALARM GUARD' comes by input 2 (guard shut) off, line 15; ends by input 4 (reset) on",
    ]


# The run switch parks the head, an unknown kind and a cold pot wait, and a label that does not come is said late.
REFUSED = """\
' IN 1 run switch  IN 2 label at gate   ADC 0 glue pot   NET 1 = kind of label 1..3
Dim kind As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  If Not INX(1) Then
    MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
    Pause INX(1)
  End If
  Pause NETINTEGER(1) > 0
  kind = NETINTEGER(1)
  If kind > 3 Then
    Print "KIND ", kind, " unknown"
    Pause NETINTEGER(1) <> kind
  Else
    Pause ADC(0) > 40
    TIME = 0
    Pause INX(2) Or TIME > 20000
    If Not INX(2) Then Print "NO LABEL"
    MOVER(0) = 30 : GO(0) : Pause IDLE(0)
    Print "PIECE OK"
    Wait(200)
  End If
End Loop
"""


def test_levels_and_numbers_of_a_host_stop_the_machine_too(cell: Cell) -> None:
    cell.write("a.mnt", REFUSED)
    shown = cell("map", "a.mnt", "--all").out.replace("\n      ", " ").splitlines()
    assert [line.strip() for line in shown if "stops the machine" in line or " by " in line] == [
        "analogue input 0 (glue pot) = 38 or input 1 (run switch) off or network data 1 (kind of label 1..3) = -1, 0, "
        "4 or 5 in the move of line 19 stops the machine at the end of its cycle",
        "'NO LABEL' comes by input 2 (label at gate) off 20 s after line 20, line 18",
        "'KIND ... unknown' is printed by network data 1 (kind of label 1..3) = 4 or 5, line 12",
        "by itself → 7, 0.00 s: axis 0 to 0",
    ]


# A host that starts a lot once, says how many it wants, and stops it behind a lid.
LOT = """\
' host: comms 1 = command (1 start, 2 stop after this lid)   comms 2 = lids of a lot   comms 3 = lids made
Dim made As Integer, wanted As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  Pause COMMS(1) = 1
  wanted = COMMS(2) : made = 0
  Repeat
    COMMS(1) = 0
    MOVEA(0) = 50 : GO(0) : Pause IDLE(0)
    MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
    made = made + 1 : COMMS(3) = made
    Print "LID OK "; made
    Wait(200)
  Until made >= wanted Or COMMS(1) = 2
  Print "lot over"
End Loop
"""


def test_a_number_of_a_host_stops_a_lot_that_goes_on_by_itself(cell: Cell) -> None:
    """Of the sizes of a lot, the first ones are tried."""
    cell.write("a.mnt", LOT)
    shown = cell("map", "a.mnt", "--all").out.replace("\n      ", " ").splitlines()
    assert [line.strip() for line in shown if "stops the machine" in line or " by " in line] == [
        "comms element 1 (command) = 2 in the move of line 9 stops the machine at the end of its cycle",
        "'lot over' is printed by comms element 1 (command) = 2 or comms element 2 (lids of a lot) = 0, 1 or 2, "
        "line 15",
        "by itself → 5, 0.00 s",
    ]
    sizes = {
        line.split(" → ")[0].split("a lot) = ")[1] for line in shown if "a lot) = " in line and " → " in line
    }
    assert sizes == {"2", "3", "4", "10"}


# Two tasks whose alarms one sub tells by a number, two hands, and a box that is full after nine pieces.
TASKS = """\
' IN 1 left palm  2 right palm  3 slider fed  4 gripped  5 reset
' OUT 1 gripper  2 feeder  3 red lamp      comms 7 = alarm
Auto
Dim want As Integer, have As Integer, bad As Integer, made As Integer, k As Integer

Task feeding
  Loop
    If want = 1 Then
      OUTX(2) = 1 : TIME = 0
      Pause INX(3) Or TIME > 2000
      OUTX(2) = 0
      If INX(3) = 0 Then stopWith(3) Else have = 1
      want = 0
    End If
    Wait(20)
  End Loop
End Task

Sub stopWith(n As Integer)
  bad = n : COMMS(7) = n : OUTX(3) = 1
End Sub

SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Run feeding
Loop
  If bad Then
    Pause INX(5)
    bad = 0 : COMMS(7) = 0 : OUTX(3) = 0
  End If
  Pause INX(1) And INX(2)
  have = 0 : want = 1 : OUTX(1) = 1 : k = 0
  Repeat
    Wait(50)
    k = k + 1
  Until INX(4) Or k = 30
  If INX(4) = 0 Then
    stopWith(4)
  Else
    Pause have Or bad
    If bad = 0 Then
      MOVER(0) = 50 : GO(0)
      Pause IDLE(0) Or INX(1) = 0 Or INX(2) = 0
      If IDLE(0) = 0 Then
        STOP(0) : Pause IDLE(0)
        Print "HANDS OFF"
      Else
        made = made + 1
        Print "FITTED"
        If made = 9 Then Print "BOX FULL" : made = 0
      End If
    End If
  End If
  OUTX(1) = 0
  Pause INX(1) = 0 And INX(2) = 0
End Loop
"""


def test_alarms_of_tasks_count_from_what_their_own_task_did_last(cell: Cell) -> None:
    cell.write("a.mnt", TASKS)
    shown = cell("map", "a.mnt", "--all").out.replace("\n      ", " ").splitlines()
    assert [line.strip() for line in shown if " come" in line or "cuts off" in line or "cycles" in line] == [
        "input 1 (left palm) off or input 2 (right palm) off cuts off moves of line 41",
        "comms element 7 (alarm) = 3 comes by input 3 (slider fed) off 2 s after line 9, line 20; ends by input 5 "
        "(reset) on, and comes again without input 3 (slider fed) on",
        "comms element 7 (alarm) = 4 comes by input 4 (gripped) off 1.5 s after line 31, line 20; ends by input 5 "
        "(reset) on, and comes again without input 4 (gripped) on",
        "output 3 (red lamp) comes with comms element 7 (alarm) = 3 and 4",
        "'BOX FULL' is printed after 9 cycles, line 49",
    ]


def test_what_was_not_played_is_named(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    cell.write("a.mnt", MISSING)
    monkeypatch.setattr(plays, "WORK", 0)
    shown = cell("map", "a.mnt", "--all").out.replace("\n      ", " ").splitlines()
    assert [line.strip() for line in shown if "anything else" in line] == [
        "whether the machine stops, or anything else comes, by analogue input 0 (weight) = 38, 42, 58 or 62, "
        "input 1 (start) off, input 6 (ball seen) off, input 7 (reset) on was not played",
    ]
