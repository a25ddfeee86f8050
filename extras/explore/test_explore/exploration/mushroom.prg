' The stop input is no part of the work, and runs its handler when it is pressed.
STOPINPUT.0 = 4
SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000
MOVER.0 = 50 : GO.0 : PAUSE IDLE.0
? "cut"
END
#STOP
? "pressed"
PAUSE INX.4 = 0
RETURN
