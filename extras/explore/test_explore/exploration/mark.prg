REM The web is fed; a mark that passes on the way is cut at, a feed without a mark stops the machine.
SPEED[0,1] = 100,50 : ACCEL[0,1] = 1000,500 : DECEL[0,1] = 1000,500
#READY
PAUSE INX.0
IF INX.3 THEN ? "STUCK" : END
seen = 0
MOVER.0 = 200 : GO.0
REPEAT
  IF INX.3 THEN seen = 1
UNTIL IDLE.0
IF seen = 0 THEN GOTO LOST
MOVER.1 = 30 : GO.1 : PAUSE IDLE.1
OUTX.1 = 1 : WAIT = 100 : OUTX.1 = 0
PAUSE INX.0 = 0
GOTO READY
#LOST
? "NO MARK"
PAUSE INX.1
PAUSE INX.1 = 0
GOTO READY
