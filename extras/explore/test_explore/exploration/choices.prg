' A menu is answered with each choice once, the one that ends it last.
SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000
#ASK
INPUT "cut, home or end", c
IF c = 1 THEN MOVER.0 = 30 : GO.0 : PAUSE IDLE.0 : ? "cut"
IF c = 2 THEN MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
IF c < 3 THEN GOTO ASK
? "bye"
