"""What says that something is wrong, why it comes by the text of a program, and what was played that ends it."""

from __future__ import annotations

import pytest

from motionlang_explore.map import stops
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
# A time within a loop, one behind a wait, and a lamp that is switched off before the next piece is waited for.
TIMES = """\
' IN 1 pedal  2 frame clamped  4 part fallen  5 reset
' OUT 3 clamp  7 red lamp
Dim e As Integer, t As Integer
Dim l As Time
Loop
  Pause INX(1)
  OUTX(3) = 1 : t = TIME : e = 0
  While INX(2) = 0
    If TIME - t > 2000 Then
      e = 1
      Exit While
    End If
  End While
  If e Then
    OUTX(7) = 1
    Pause INX(5)
    OUTX(7) = 0
  Else
    MOVER(0) = 10 : GO(0) : Pause IDLE(0)
    l = 0
    Pause INX(4) Or l > 1500
    If l > 1500 Then Print "PART STUCK"
  End If
  OUTX(3) = 0
  Pause INX(1) = 0
End Loop
"""
# A clock that is set in two branches, and looked at in a branch within one of them.
NESTED = """\
' IN 1 pedal  2 frame clamped  4 part fallen
Dim l As Time
Loop
  Pause INX(1)
  If INX(2) Then
    MOVER(0) = 10 : GO(0) : Pause IDLE(0)
    l = 0
    Wait(500)
    If INX(4) = 0 Then
      Wait(500)
      If l > 900 Then Print "PART STUCK"
    End If
  Else
    l = 0
    Pause INX(2) Or l > 1500
  End If
  Pause INX(1) = 0
End Loop
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
# Numbers of faults in a register, one by a level that another register holds.
CODES = """\
; inputs 1 run  2 sugar
; analogue 1 force   reg 30 fault  reg 12 wasted
MD1,WN1,IF2,MJ7,NO,2MR10,2WS.1,GA1,AR25,RA25,IG6.8,MJ8,NO,IB2,MJ3,NO,AL0,AR12,MJ1
MD3,RA12,AA1,AR12,IG2,MJ8,NO,MJ1
MD7,AL1,AR30,MJ9
MD8,AL2,AR30,MJ9
MD9,RA30,IE1,OT"NO SUGAR",NO,RA30,IE2,OT"WASTE",NO,AL0,AR30,WF1,MJ1
2MN
MJ1
"""
# A flag that a handler sets, a sensor that is a parameter, and a wait with a time-out before what it has waited for.
WAITS = """\
' IN 0 start  1 clamp  2 ram  3 hood
Dim bTrip As Integer
Dim bTold As Integer
Loop
  If bTold = 0 Then Print "READY"
  bTold = 1
  If bTrip = 1 Then
    bTrip = 0
    If POS(0) > 5 Then Print "HOOD OPEN"
  End If
  Pause INX(0)
  MOVEA(0) = 10 : GO(0) : Pause IDLE(0)
  TIME = 0
  Repeat
  Until INX(2) Or TIME > 800
  If INX(2) = 0 Then Print "RAM STUCK"
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  Reached(1)
  Reached(2)
  bTold = 0
End Loop
Sub Reached(ByVal sensor As Integer)
  Wait(50)
  If Not INX(sensor) Then Print "NO ANSWER"
End Sub
Event IN3
  STOP(0)
  bTrip = 1
End Event
"""
# What the good cycle prints is no alarm, and what prints the count of bad pieces is one.
GAUGE = """\
Dim good As Integer, bad As Integer
Loop
  Pause INX(1)
  MOVER(0) = 25 : GO(0) : Pause IDLE(0)
  If INX(6) Then
    good = good + 1
    Print good; " pushed off"
  Else
    bad = bad + 1
    Print bad; " short ones"
  End If
End Loop
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

# A lamp goes off as the hood shuts, and the pedal has to be let go before the piece is finished.
HOOD = """\
REM IN 0 foot pedal  1 hood shut
REM OUT 3 red lamp
SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000
LOOP
  PAUSE INX.0
  MOVEA.0 = 50 : GO.0 : PAUSE IDLE.0
  IF INX.1 = 0 DO
    OUTX.3 = 1
    PAUSE INX.1
    OUTX.3 = 0
    PAUSE INX.0 = 0
    PAUSE INX.0
  ENDIF
  MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
  ? "struck"
  PAUSE INX.0 = 0
ENDL
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
# Valves that one sub waits for by their number, a lamp that is on without a fault, and a door that stops a run.
VALVES = """\
REM IN 0 start  1 jaw shut  2 ram down  3 door shut  4 reset  5 stop
REM OUT 1 jaw  2 ram  3 red lamp  4 green lamp
bad = 0 : going = 0
LOOP
  IF INX.0 = 1 AND INX.3 = 1 AND bad = 0 THEN going = 1
  IF INX.3 = 0 AND going = 1 THEN ? "DOOR OPEN" : going = 0
  IF INX.5 = 1 THEN going = 0
  IF going = 1 AND bad = 0 THEN GOSUB work
  OUTX.4 = (bad = 0) : OUTX.3 = (bad > 0)
  IF bad > 0 AND INX.4 THEN bad = 0
  WAIT = 10
ENDL
#work
  OUTX.1 = 1
  valve = 1 : GOSUB look
  IF bad = 0 DO
    OUTX.2 = 1
    valve = 2 : GOSUB look
  ENDIF
  IF bad = 0 DO
    MOVEA.0 = 50 : GO.0 : PAUSE IDLE.0
    MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
    ? "PART OK"
  ENDIF
  OUTX.1 = 0 : OUTX.2 = 0
  WAIT = 300
RETURN
#look
  t0 = TIME
  WHILE INX[valve] = 0 AND TIME - t0 < 800
    WAIT = 5
  ENDW
  IF INX[valve] = 0 DO
    bad = valve
    ? "VALVE FAULT ", valve
  ENDIF
RETURN
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
# The lamp of two texts is switched by a step that a switch leaves, too; a result of 1 is good, and a code is a key.
SHOWN = """\
' IN 0 start  1 wire ok  2 weight ok  3 reset  4 auto
' OUT 2 red lamp
Dim s As Integer
Dim result As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  If INX(4) = 0 And s < 99 Then s = 0
  Select Case s
  Case 0
    If INX(0) And INX(4) Then s = 10
  Case 10
    MOVEA(0) = 50 : GO(0) : Pause IDLE(0)
    If INX(1) = 0 Then
      Print "WIRE BROKEN"
      s = 90
    Else
      result = 1
      If INX(2) = 0 Then result = 4
      If result = 1 Then
        Print "PART OK"
      Else
        Print "scrap, code "; result
      End If
      MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
      s = 20
    End If
  Case 20
    If INX(0) = 0 Then s = 0
  Case 90
    OUTX(2) = 1
    If INX(3) Or INKEY = Asc("R") Then
      OUTX(2) = 0
      s = 20
    End If
  End Select
  WAIT = 10
End Loop
"""
# A register that a macro counts down from what its caller has loaded.
DOWN = """\
; i/p 1 jar at stop  2 knife down  3 reset
; o/p 9 knife  12 red lamp
CT9,CT12
1MN
MD5,AL25,AR30,CF12
MD30,CN9,AL100,AR30,MC35,CF9
MD35,IN2,JR10,NO,WA0.02,RA30,AS1,AR30,IG0,JR-8,NO,MC90,NO
MD90,CN12,OT"KNIFE FAULT",WN3,MC5
MD60,WN1,1MR10,1WS0.05,MC30,OT"JAR OK",WF1,RP
MC60
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


@pytest.mark.parametrize(
    ("name", "text", "lines"),
    [
        pytest.param(
            "a.prg",
            STEPS,
            [
                "'FILTER NOT CLEAN' comes after 4001 times input 3 (label on pad) on, line 16 (not played)",
                "output 2 (alarm horn) comes by input 7 (air on) off, line 5 or 3 times input 3 (label "
                "on pad) off, line 16 and 2 s after line 13; as it was played, it ends by input 6 (reset left) on, "
                "then input 5 (reset right) on",
                "'NO LABEL' comes after 3 times input 3 (label on pad) off, line 16 and 2 s after line "
                "13; ends by input 6 (reset left) on, then input 5 (reset right) on",
                "'AIR' comes by input 7 (air on) off, line 5; ends by input 7 (air on) on, then "
                "input 6 (reset left) on, then input 5 (reset right) on",
            ],
            id="steps",
            marks=pytest.mark.slow,
        ),
        pytest.param(
            "a.mnt",
            NUMBERS,
            [
                "comms element 12 and output 5 (red lamp) and 'alarm ...' come with 1: by input 1 "
                "(guard open) (event IN1), line 24; 2: by input 2 (air on) off, line 7; 3: by input 3 "
                "(tray) on 0.5 s after line 15, line 17; as it was played, it ends by input 2 (air on) on, "
                "then comms element 1 = 3",
            ],
            id="numbers",
        ),
        pytest.param(
            "a.mccl",
            MACROS,
            [
                "output 11 (fault lamp) and 'NO VACUUM' come by input 3 (vacuum ok) off, line 4 and "
                "0.49 s in line 4; ends by input 3 (vacuum ok) on, then input 5 (reset) on",
                "'GATE NOT SHUT' comes by input 1 (gate shut) off, line 3; ends by input 1 (gate shut) on",
            ],
            id="macros",
        ),
        pytest.param(
            "a.mccl",
            CODES,
            [
                "'NO SUGAR' comes by input 2 (sugar) off, line 3; ends by input 1 (run) off",
                "'WASTE' comes by analogue input 1 (force) above 6.8, line 3 or 3 times analogue input "
                "1 (force) below 2, line 3; as it was played, it ends by input 1 (run) off",
            ],
            id="codes",
        ),
        pytest.param(
            "a.mnt",
            WAITS,
            [
                "'HOOD OPEN' comes by input 3 (hood) (event IN3), line 26 and `POS(0) > 5`, line 9 (not "
                "played)",
                "'RAM STUCK' comes by input 2 (ram) off 0.8 s after line 13, line 16",
                "'NO ANSWER' comes by input 1 (clamp) off, line 24 or input 2 (ram) off, line 24",
            ],
            id="waits",
        ),
        pytest.param(
            "a.mnt",
            TIMES,
            [
                "output 7 (red lamp) comes by input 2 (frame clamped) off, line 8 and 2 s after line 7; "
                "ends by input 5 (reset) on",
                "'PART STUCK' comes 1.5 s after line 20 without input 4 (part fallen) on",
            ],
            id="times",
        ),
        pytest.param(
            "a.mnt",
            NESTED,
            ["'PART STUCK' comes by input 4 (part fallen) off, line 9 and 0.9 s after line 7"],
            id="nested",
        ),
        pytest.param("a.mnt", GAUGE, ["'short ones' comes by input 6 off, line 5"], id="gauge"),
        pytest.param(
            "a.prg",
            HOOD,
            ["output 3 (red lamp) comes by input 1 (hood shut) off, line 7; ends by input 1 (hood shut) on"],
            id="hood",
        ),
        pytest.param(
            "a.prg",
            LAMP,
            [
                "'FAULT: no vacuum' comes 2 s after line 7 without input 3 (vacuum ok) on; ends by input 4 (reset) on",
                "'FAULT: dropped' comes by input 3 (vacuum ok) off, line 15",
                "output 4 (fault lamp) comes 2 s after line 7 without input 3 (vacuum ok) on or input 3 "
                "(vacuum ok) off, line 15; as it was played, it ends by input 4 (reset) on",
            ],
            id="lamp",
        ),
        pytest.param(
            "a.mnt",
            HANDS,
            [
                "'FAULT clamp' comes by input 1 (clamp shut) off, line 38 and 0.8 s after line 36; ends by input 4 "
                "(reset) on",
                "'HANDS OFF, SCRAP' comes by input 2 (left hand) off, line 16 or input 3 (right hand) off, line 16",
                "'REJECT' comes by analogue input 0 (gauge) above 42, line 30",
            ],
            id="hands",
        ),
        pytest.param(
            "a.mnt",
            STAPLER,
            [
                "'guard open' comes by input 1 (guard shut) off if `told = 0`, line 6; ends by input 1 (guard shut) on",
                "output 1 (red lamp) comes by input 1 (guard shut) off, line 6; ends by input 1 (guard shut) on",
                "'magazine low' comes after 6 times line 37",
                "output 1 (red lamp) comes by input 2 (staple formed) on if `twice = 1` (input 3 (double sheet) on, "
                "line 23), line 28 or input 2 (staple formed) off, line 28; as it was played, it ends by input 2 "
                "(staple formed) on, then input 4 (reset) on",
                "'NO STAPLE' comes by input 2 (staple formed) off, line 28; ends by input 2 (staple formed) on, then "
                "input 4 (reset) on",
                "'FAULT' comes by input 2 (staple formed) on if `twice = 1` (input 3 (double sheet) on, line 23), "
                "line 28; ends by input 3 (double sheet) off, then input 4 (reset) on",
                "'guard shut again' is printed by input 1 (guard shut) on if `told = 1`, line 6",
                "'fault ... cleared' is printed by input 4 (reset) on, line 15",
            ],
            id="stapler",
        ),
        pytest.param(
            "a.prg",
            VALVES,
            [
                "'DOOR OPEN' comes by input 3 (door shut) off, line 6",
                "output 3 (red lamp) and 'VALVE FAULT ...' come with 1: by input 1 (jaw shut) off 0.8 s "
                "after line 29, line 33; 2: by input 2 (ram down) off 0.8 s after line 29, line 33; as it was "
                "played, it ends by input 2 (ram down) on, then input 4 (reset) on",
            ],
            id="valves",
        ),
        pytest.param(
            "a.mnt",
            SEEN,
            [
                "'NO CLAMP' comes 0.5 s after line 29 without input 1 (clamp shut) on, line 16",
                "'RAM STUCK' comes 0.8 s after line 29 without input 2 (ram down) on, line 18",
                "'RAM LOW' comes 1.2 s after line 29 without input 3 (ram up) on, line 21; ends by input 4 (reset) on",
                "'CLAMP STUCK' comes by input 1 (clamp shut) on 0.6 s after line 38, line 26; ends by "
                "input 1 (clamp shut) off",
            ],
            id="function",
        ),
        pytest.param(
            "a.mnt",
            SHOWN,
            [
                "'WIRE BROKEN' and output 2 (red lamp) come by input 1 (wire ok) off, line 13; ends by input 3 "
                "(reset) on",
                "'scrap, code' comes by input 2 (weight ok) off, line 18",
            ],
            id="shown",
        ),
        pytest.param(
            "a.mccl",
            DOWN,
            [
                "output 12 (red lamp) and 'KNIFE FAULT' come by input 2 (knife down) off, line 7 and 2 s in line 7; "
                "ends by input 3 (reset) on",
            ],
            id="down",
        ),
        pytest.param(
            "a.mccl",
            HELD,
            [
                "'STRIP EMPTY' and output 12 (red lamp) come by input 2 (strip present) off, line 9; ends by input 3 "
                "(fault reset) on and input 2 (strip present) on",
                "output 12 (red lamp) and 'KNIFE FAULT' come by input 4 (knife down) off, line 6 and 1 s in line 6; "
                "ends by input 3 (fault reset) on",
            ],
            id="held",
        ),
        pytest.param(
            "a.prg",
            WANTED,
            [
                "'VALVE FAULT ...' and output 3 (red lamp) come with 3: by input 3 (valve at nozzle) off, line 20; "
                "4: by input 4 (valve at hopper) off, line 20; as it was played, it ends by input 5 (reset) on",
            ],
            id="wanted",
        ),
        pytest.param(
            "a.prg",
            FLAGS,
            [
                "'STOPPED' comes by input 1 (lid shut) off if `going = 1`, line 4",
                "'RAM STUCK' comes by input 4 (ram down) off, line 16 and 1.5 s after line 15",
            ],
            id="flags",
        ),
        pytest.param(
            "a.prg",
            LEVELS,
            [
                "'force: reject' comes by analogue input 0 above 58, line 7 or analogue input 0 below "
                "42, line 7",
                "'CUTTER STUCK' comes after 80 times input 4 (cutter down) off, line 10",
                "'stopped' comes by input 1 (stop) on, line 17",
                "'ERROR' comes by a fault (event ONERROR), line 21 (not played)",
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
        "input 3 (stop released) off or key 9 in the move of line 8 stops the machine at the end of its cycle",
        "input 2 (door shut) off in the move of line 8 stops the machine behind line 8",
    ]


def test_what_was_not_played_of_the_stops_is_named(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    cell.write("a.prg", STOPS)
    monkeypatch.setattr(stops, "WORK", 0)
    shown = cell("map", "a.prg", "--all").out.splitlines()
    assert [line.strip() for line in shown if "machine stops" in line or "stops the machine" in line] == [
        "input 2 (door shut) off in the move of line 8 stops the machine behind line 8",
        "whether the machine stops by input 3 (stop released) off, key 9 was not played",
    ]
