' A slide jogs between its two ends: each is where the axis passes, not a button.
SPEED.0 = 50 : ACCEL.0 = 500 : DECEL.0 = 500
LOOP
  JOG.0 = 50
  PAUSE INX.1
  STOP.0 : PAUSE IDLE.0
  JOG.0 = -50
  PAUSE INX.2
  STOP.0 : PAUSE IDLE.0
  ? "stroke"
ENDL
