REM DRILLING UNIT for flange plates, 2 axes + pneumatic clamp
REM Rev C  11/2003   spindle feed in mm, table in degrees
REM
REM   0 = table (36000 counts/rev)    1 = spindle feed (1000 counts/mm)
REM   IN 0 plate present  1 clamp closed  2 spindle at speed
REM   IN 3 cycle start button             6 drill broken (sensor, 0 = ok)
REM   OUT 0 clamp 1 spindle 2 coolant 3 part finished
AUTO
SCALE.0 = 100
SCALE.1 = 1000
SPEED.0 = 90 : ACCEL.0 = 360 : DECEL.0 = 360
SPEED.1 = 120 : ACCEL.1 = 800 : DECEL.1 = 800
OUT.0 = 0
parts = 0
bad = 0

REM home the feed on its switch, then zero the table where it is
HOMESPEED.1 = 15
HOME.1 = 0 : PAUSE IDLE.1
POS.0 = 0

? "HOLES ON CIRCLE?"
INPUT holes
IF holes < 2 THEN GOTO STOPPED
ang = 360 / holes

#NEWPART
REM operator loads a plate and presses the button
PAUSE INX.0 AND INX.3
TIME = 0
OUTX.0 = 1
TM = 0
WHILE INX.1 = 0
  TM = TM + 1
  WAIT = 10
  IF TM > 200 THEN ? "CLAMP!" : GOTO STOPPED
ENDW
OUTX.1 = 1
PAUSE INX.2
OUTX.2 = 1

FOR H = 1 TO holes
  REM rapid to 2 mm above the plate
  SPEED.1 = 120 : MOVEA.1 = 38 : GO.1 : PAUSE IDLE.1
  GOSUB PECK
  SPEED.1 = 120 : MOVEA.1 = 20 : GO.1 : PAUSE IDLE.1
  IF INX.6 THEN bad = bad + 1 : GOTO BROKEN
  MOVER.0 = ang : GO.0 : PAUSE IDLE.0
NEXT

OUTX.2 = 0
OUTX.1 = 0
MOVEA.1 = 0 : GO.1 : PAUSE IDLE.1
OUTX.0 = 0
PAUSE INX.1 = 0
parts = parts + 1
OUTX.3 = 1 : WAIT = 500 : OUTX.3 = 0
? "PART ",parts USING 5,0,"  TIME ",TIME
REM wait for plate to be taken out
PAUSE INX.0 = 0
GOTO NEWPART

REM peck drilling, 3 steps of 4 mm, back to clear chips
#PECK
D = 40
FOR S = 1 TO 3
  D = D + 4
  SPEED.1 = 8
  MOVEA.1 = D : GO.1 : PAUSE IDLE.1
  SPEED.1 = 120
  MOVEA.1 = 38 : GO.1 : PAUSE IDLE.1
  IF S < 3 THEN MOVEA.1 = D - 1 : GO.1 : PAUSE IDLE.1
NEXT
RETURN

#BROKEN
? "DRILL BROKEN, HOLE ",H USING 3,0
#STOPPED
OUT.0 = 0
SPEED.1 = 60
MOVEA.1 = 0 : GO.1 : PAUSE IDLE.1
? "STOPPED"
END
