' A change for the middle of a move comes behind it where an eye has stopped the axis before: it is what ends the rest.
s = 0 : f = 0
SPEED.1 = 240 : ACCEL.1 = 900 : DECEL.1 = 900
LOOP
  IF INX.2 = 0 THEN f = 1
  IF f > 0 DO
    ? "GUARD OPEN"
    PAUSE INX.8
    PAUSE INX.8 = 0
    f = 0 : s = 0
  ENDIF
  IF s = 0 AND INX.0 THEN MOVER.1 = 400 : GO.1 : s = 2
  IF s = 2 DO
    IF INX.6 DO
      STOP.1 : PAUSE IDLE.1
      OUTX.0 = 1 : s = 3
    ENDIF
    IF s = 2 AND IDLE.1 THEN s = 0
  ENDIF
  IF s = 3 AND INX.4 THEN OUTX.0 = 0 : ? "DONE" : s = 0
  WAIT = 5
ENDL
