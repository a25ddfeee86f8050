' A question with two answers is no menu: one more part is the cycle, and it goes on.
SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000
#ASK
INPUT "one more", y
IF y = 1 THEN MOVER.0 = 30 : GO.0 : PAUSE IDLE.0 : ? "cut" : GOTO ASK
? "bye"
