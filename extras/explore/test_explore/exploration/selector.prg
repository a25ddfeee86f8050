REM Hand mode jogs, and the idle loop prints without a wait; a start, a key, doors, a selector and a photocell
REM IN 0 key AUTO  1 start  3 doors shut  7 photocell  11 jog up  12 jog down
ACCEL.0 = 500 : DECEL.0 = 500 : SPEED.0 = 100 : SPEED.1 = 50 : ACCEL.1 = 500 : DECEL.1 = 500
#IDLE
? "STOPPED"
WHILE INX.1 = 0
  IF INX.0 = 0 THEN GOSUB HAND
  WAIT = 20
ENDW
IF INX.0 = 0 THEN GOTO IDLE
IF INX.3 = 0 THEN ? "SHUT THE DOORS" : WAIT = 500 : GOTO IDLE
sz = (IN.0 & 112) / 16
IF sz < 1 OR sz > 5 THEN ? "SELECTOR" : WAIT = 500 : GOTO IDLE
#STROKE
IF INX.2 = 0 THEN GOTO IDLE
MOVEA.0 = 50 * sz : GO.0 : PAUSE IDLE.0
MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
? "PART"
GOTO STROKE
GOTO IDLE
#HAND
IF INX.11 = 1 AND POS.1 < 90 THEN JOG.1 = 20 : PAUSE INX.11 = 0 OR POS.1 >= 90 : STOP.1 : PAUSE IDLE.1
IF INX.12 = 1 AND POS.1 > 0 THEN JOG.1 = -20 : PAUSE INX.12 = 0 OR POS.1 <= 0 : STOP.1 : PAUSE IDLE.1
RETURN
