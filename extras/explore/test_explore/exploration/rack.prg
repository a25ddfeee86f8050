REM A rack is hung before key 1, and taken off at the end: the next turn needs the inputs and the level of the first one
AUTO
SPEED = 150 : ACCEL = 1500 : DECEL = 1500
LOOP
  k = INKEY
  IF k = 49 THEN GOSUB dip
  WAIT = 25
ENDL
#dip
  IF INX.0 = 0 THEN ? "HANG A RACK FIRST" : RETURN
  IF ADC.0 < 68 OR ADC.0 > 76 THEN ? "ALARM" : RETURN
  MOVEA = 200 : GO : PAUSE IDLE
  MOVEA = 0 : GO : PAUSE IDLE
  ? "RACK DIPPED"
  OUTX.3 = 1
  PAUSE INX.0 = 0
  OUTX.3 = 0
RETURN
