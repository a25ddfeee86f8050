REM Hands over parts to a robot in layers of four; request, ready, taken, with a time-out each
AUTO
DIM place(4)
place(1) = 10 : place(2) = 60 : place(3) = 110 : place(4) = 160
part = 0 : layer = 0 : fault = 0
SPEED.0 = 150 : ACCEL.0 = 900 : DECEL.0 = 900
SPEED.1 = 40 : ACCEL.1 = 400 : DECEL.1 = 400
OUT = 0
LOOP
  PAUSE INX.0
  FOR part = 1 TO 4
    MOVEA.0 = place(part) : GO.0
    PAUSE IDLE.0
    GOSUB handover
    IF fault THEN EXIT
  NEXT
  IF fault = 0 DO
    layer = layer + 1
    ? "LAYER ",layer
    MOVER.1 = -12 : GO.1 : PAUSE IDLE.1
  ENDIF
  IF layer = 3 DO
    ? "PALLET"
    OUTX.4 = 1
    PAUSE INX.6
    PAUSE INX.6 = 0
    OUTX.4 = 0
    layer = 0
    MOVEA.1 = 0 : GO.1 : PAUSE IDLE.1
  ENDIF
  IF fault DO
    ? "FAULT ",fault
    OUTX.5 = 1
    PAUSE INX.7
    OUTX.5 = 0
    fault = 0
  ENDIF
  MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
ENDL
END
#handover
  TIME = 0
  WHILE INX.1 = 0
    IF TIME > 4000 DO
      fault = 1
      RETURN
    ENDIF
    WAIT = 10
  ENDW
  OUTX.2 = 1
  TIME = 0
  REPEAT
    IF TIME > 2000 DO
      OUTX.2 = 0
      fault = 2
      RETURN
    ENDIF
    WAIT = 10
  UNTIL INX.3
  OUTX.2 = 0
  PAUSE INX.3 = 0 AND INX.1 = 0
RETURN
