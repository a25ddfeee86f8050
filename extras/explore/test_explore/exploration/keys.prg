' Keys jog until one ends the program: each is pressed once, and that one last.
SPEED.0 = 20 : ACCEL.0 = 200 : DECEL.0 = 200
LOOP
  k = INKEY
  IF k = 43 THEN JOG.0 = 5
  IF k = 45 THEN JOG.0 = -10
  IF k = 69 THEN EXIT
ENDL
STOP.0 : PAUSE IDLE.0
? "left at ", POS.0
