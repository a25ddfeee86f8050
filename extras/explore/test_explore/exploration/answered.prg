' A menu that remembers an answer is another state: key 2 works once key 1 has asked for the length.
length = 0
#MENU
k = INKEY
IF k = 49 THEN INPUT "LENGTH MM ? ",length
IF k = 50 THEN GOTO RUNJOB
WAIT = 50
GOTO MENU
#RUNJOB
IF length = 0 THEN ? "SET LENGTH FIRST" : GOTO MENU
MOVER.0 = length : GO.0 : PAUSE IDLE.0
? "PCE"
GOTO MENU
