' The keys are those of digits, less 48.
SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000
#MENU
k = INKEY
IF k = 0 THEN GOTO MENU
k = k - 48
IF k = 7 THEN GOTO BYE
IF k = 1 THEN MOVER.0 = 10 : GO.0 : PAUSE IDLE.0
GOTO MENU
#BYE
? "BYE"
END
