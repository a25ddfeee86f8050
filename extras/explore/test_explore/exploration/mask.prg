REM A code of three switches in the bank of a start button
SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000
LOOP
  PAUSE INX.7
  C = IN.0 & 7
  IF C > 0 AND C < 6 DO
    MOVER.0 = 10 * C : GO.0 : PAUSE IDLE.0
    ? "done ",C
  ENDIF
  PAUSE INX.7 = 0
ENDL
