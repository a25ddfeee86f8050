' Springs: the inputs are bits of a variable; guard (bit 0), spring (1), start (2), and the eye behind the flap (3).
' The red button on input 5 is pressed (0) by nobody; TROUBLE names it, and so no text of trouble does.
AUTO
SPEED = 60 : ACCEL = 600 : DECEL = 600
OUT = 0
stp = 10 : last = 0
LOOP
  inp = IN
  IF (inp & 32) = 0 AND stp > 10 THEN fault = 4 : GOSUB TROUBLE
  IF stp = 10 AND (inp & 4) > 0 AND (last & 4) = 0 DO
    IF (inp & 35) = 35 THEN stp = 20 ELSE ? "CANNOT START"
  ENDIF
  IF stp = 20 THEN MOVEA = 30 : GO : PAUSE IDLE : MOVEA = 0 : GO : PAUSE IDLE : stp = 60 : OUTX.3 = 1 : TIME = 0
  IF stp = 60 DO
    IF (inp & 8) > 0 THEN OUTX.3 = 0 : ? "SPRING SORTED" : stp = 70
    IF TIME > 900 THEN fault = 1 : GOSUB TROUBLE
  ENDIF
  IF stp = 70 AND (inp & 8) = 0 THEN stp = 10
  last = inp
  WAIT = 5
ENDL
#TROUBLE
  OUTX.5 = 1
  IF fault = 1 THEN ? "SPRING DID NOT DROP"
  IF fault = 4 THEN ? "RED BUTTON"
  PAUSE INX.6 : PAUSE NOT INX.6
  OUTX.5 = 0 : OUTX.3 = 0
  stp = 10
RETURN
