REM Two hands, and a curtain that stops the stroke at once
REM IN 1 left hand  2 right hand  6 light curtain clear
SPEED.0 = 50 : ACCEL.0 = 500 : DECEL.0 = 500
#HA
PAUSE INX.1 = 0 AND INX.2 = 0
PAUSE INX.1 AND INX.2
MOVEA.0 = 56 : GO.0
PAUSE IDLE.0 OR INX.1 = 0 OR INX.2 = 0 OR INX.6 = 0
IF INX.6 = 0 THEN ? "LIGHT CURTAIN" : GOTO UP
IF INX.1 = 0 OR INX.2 = 0 THEN ? "HANDS OFF" : GOTO UP
WAIT = 300
? "STAMPED"
#UP
STOP.0 : PAUSE IDLE.0
MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
GOTO HA
