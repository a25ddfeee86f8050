REM BAG WELDER BW-2    film feed + welding jaw      K.L. 11.97
REM EuroSystem, axis 0 = film 50/mm  axis 1 = jaw 200/mm
REM IN 0 guard   IN 1 film ok   IN 2 jaw hot
REM OUT 0 heater   OUT 1 knife   OUT 2 lamp
AUTO
GOSUB SETUP
GOSUB REF

IF INX.0 = 0 THEN ? "CLOSE GUARD"
PAUSE INX.0

#ASK
INPUT "BAG LENGTH MM (50-450) ", bl
IF bl < 50 OR bl > 450 THEN GOTO ASK
INPUT "WELD TIME MS (100-900) ", wd
OUTX.0 = 1
PAUSE INX.2
bags = 0

LOOP
  TIME = 0
  IF INX.1 = 0 THEN GOTO NOFILM
  MOVER.0 = bl : GO.0
  PAUSE IDLE.0
  GOSUB WELD
  OUTX.1 = 1
  WAIT = 80
  OUTX.1 = 0
  bags = bags + 1
  ? "BAG ",bags," ",TIME," MS"
ENDL

#WELD
  MOVEA.1 = 40 : GO.1
  PAUSE IDLE.1
  WAIT = wd
  MOVEA.1 = 5 : GO.1
  PAUSE IDLE.1
RETURN

#NOFILM
  OUTX.0 = 0 : OUTX.2 = 1
  ? "NO FILM AFTER ",bags
END

#SETUP
  SCALE.0 = 50 : SCALE.1 = 200
  SPEED.0 = 500 : ACCEL.0 = 2500 : DECEL.0 = 2500
  SPEED.1 = 200 : ACCEL.1 = 2000 : DECEL.1 = 2000
  OUT.0 = 0
RETURN

#REF
  HOMESPEED.1 = 20
  HOME.1 = 0
  PAUSE IDLE.1
  MOVEA.1 = 5 : GO.1
  PAUSE IDLE.1
RETURN
