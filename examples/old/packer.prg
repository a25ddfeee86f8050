REM ****************************************************************
REM *  CARTON PACKER PK-12            J.H.   03.2003   NextMove BX  *
REM *  axis 0 pusher (ballscrew 10 mm)    axis 1 lift (belt)        *
REM ****************************************************************
REM  IN  0 carton at stop     1 carton clamped    2 guard closed
REM      3 start              4 row of product complete
REM  OUT 0 clamp              1 infeed belt       2 eject cylinder
REM      3 red lamp           4 green lamp
AUTO
GOSUB INIT
GOSUB HOMING

#ASK
INPUT "Layers per carton ? ", nl
IF nl < 1 OR nl > 6 THEN ? "1 to 6" : GOTO ASK
INPUT "Product height mm ? ", ht
IF ht < 10 OR ht > 80 THEN ? "10 to 80" : GOTO ASK

PAUSE INX.2
? "READY - press START"
OUTX.4 = 1
PAUSE INX.3
cartons = 0

REM ------------------------------------------------- production loop
LOOP
  TIME = 0
  GOSUB CARTONIN
  layer = 0
  WHILE layer < nl
    PAUSE INX.4
    GOSUB PUSH
    layer = layer + 1
    MOVER.1 = -ht : GO.1
    PAUSE IDLE.1
  ENDW
  GOSUB CARTONOUT
  cartons = cartons + 1
  ? "carton ",cartons USING 4,0," ",TIME," ms"
ENDL

#CARTONIN
  OUTX.1 = 1
  PAUSE INX.0
  WAIT = 150
  OUTX.1 = 0
  OUTX.0 = 1
  PAUSE INX.1
  MOVEA.1 = 300 : GO.1
  PAUSE IDLE.1
RETURN

#PUSH
  SPEED.0 = 600
  MOVEA.0 = 250 : GO.0
  PAUSE IDLE.0
  REM come back faster, empty
  SPEED.0 = 1000
  MOVEA.0 = 0 : GO.0
  PAUSE IDLE.0
RETURN

#CARTONOUT
  OUTX.0 = 0
  PAUSE INX.1 = 0
  OUTX.2 = 1
  WAIT = 400
  OUTX.2 = 0
  REM wait for the carton to clear the stop
  PAUSE INX.0 = 0
RETURN

#HOMING
  ? "HOMING"
  OUTX.3 = 1
  HOMESPEED[0,1] = 50, 50
  HOMEBACKOFF[0,1] = 10, 10
  HOME.0 = 0
  PAUSE IDLE.0
  HOME.1 = 0
  PAUSE IDLE.1
  OUTX.3 = 0
RETURN

#INIT
  CANCEL[0,1]
  SCALE[0,1] = 400, 100
  SPEED[0,1] = 600, 300
  ACCEL[0,1] = 5000, 2000
  DECEL[0,1] = 5000, 2000
  HOMEINPUT.0 = 8
  HOMEINPUT.1 = 9
  OUT.0 = 0
RETURN

REM guard opened: stop both, wait for guard and start
#IN2
  IF INX.2 = 0 THEN STOP[0,1] : OUTX.3 = 1
RETURN

#ONERROR
  ? "ERROR ",ERR," LINE ",ERL
  OUT.0 = 8
END
