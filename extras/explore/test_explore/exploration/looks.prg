REM the press looks thirty times for its piece, and then for the reset
SCALE.0 = 100
#LOOP
t = 0
#LOOK
IF INX.1 THEN GOTO PRESS
WAIT = 20 : t = t + 1
IF t < 30 THEN GOTO LOOK
OUTX.5 = 1
WAIT = 300
OUTX.5 = 0
? "NO PIECE"
#RESET
IF INX.2 = 0 THEN GOTO RESET
GOTO LOOP
#PRESS
MOVEA.0 = 40 : GO.0 : PAUSE IDLE.0
MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
GOTO LOOP
