REM All of three inputs in the bank, and a button; then an index table that works without a rest
SPEED.0 = 120 : ACCEL.0 = 600 : DECEL.0 = 600
NG = 0 : GOOD = 0
IF (IN.0 & 0x70) <> 0x70 DO
  ? "NOT READY"
  PAUSE (IN.0 & 0x70) = 0x70 AND INX.8
ENDIF
LOOP
  MOVER.0 = 45 : GO.0 : PAUSE IDLE.0
  IF INX.3 = 0 THEN WAIT = 500
  IF INX.3 DO
    OUTX.2 = 1 : WAIT = 200 : OUTX.2 = 0
    GOOD = GOOD + 1
    ? "good ",GOOD," bad ",NG
  ENDIF
ENDL
