' Each choice of a menu is a change; the answer to another question lies in the range that is printed.
SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000
#MENU
INPUT "1 run 2 service ", c
IF c = 1 THEN GOSUB RUNIT
IF c = 2 THEN MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
GOTO MENU
#RUNIT
INPUT "length (20-40) ", s
IF s < 20 OR s > 40 THEN ? "no" : GOTO RUNIT
OUTX.2 = 1
PAUSE INX.1
MOVER.0 = s : GO.0 : PAUSE IDLE.0
OUTX.2 = 0
PAUSE INX.1 = 0
RETURN
