REM LABELLER LB200 - single axis feed roller, product from customer belt
REM Mint v4 - ServoNode 50     S.K. 22/05/03
REM IN 0 product eye   IN 1 label gap eye   IN 2 roll end (0 = empty)
REM IN 3 run switch    OUT 0 applicator air  OUT 1 alarm
AUTO
SCALE.0 = 50
SPEED.0 = 300
ACCEL.0 = 4000
DECEL.0 = 4000
n = 0
miss = 0
OUT.0 = 0
? "LB200 V1.4"
? "C)ALIBRATE OR R)UN"
#KEY
K = INKEY
IF K = 67 THEN GOSUB CALIB : GOTO KEY
IF K <> 82 THEN GOTO KEY
IF LL = 0 THEN LL = 62

INPUT "DELAY MM ? ", dm
dly = dm / 400 * 1000

#MAIN
IF INX.3 = 0 THEN PAUSE INX.3
IF INX.2 = 0 THEN GOTO EMPTY
PAUSE INX.0
TIME = 0
WAIT = dly
OUTX.0 = 1
REM run until gap, at most one and a half labels
MOVER.0 = LL * 1.5 : GO.0
PAUSE INX.1 OR IDLE.0
IF IDLE.0 THEN miss = miss + 1 : ? "NO GAP" : GOTO NEXTONE
P = POS.0
STOP.0
PAUSE IDLE.0
REM stop every label at the same place, 3 mm after the gap
MOVEA.0 = P + 15 : GO.0
PAUSE IDLE.0
n = n + 1
? "LABEL ",n," AFTER ",TIME
#NEXTONE
WAIT = 30
OUTX.0 = 0
IF miss > 2 THEN GOTO EMPTY
PAUSE INX.0 = 0
GOTO MAIN

#EMPTY
OUTX.1 = 1
? "FIT NEW ROLL, PRESS RUN"
PAUSE INX.3 = 0
PAUSE INX.2
PAUSE INX.3
OUTX.1 = 0
miss = 0
GOTO MAIN

REM measure label length between two gaps
#CALIB
SPEED.0 = 50
JOG.0 = 50
PAUSE INX.1 = 0
PAUSE INX.1
P = POS.0
PAUSE INX.1 = 0
PAUSE INX.1
LL = POS.0 - P
STOP.0
PAUSE IDLE.0
SPEED.0 = 300
? "LABEL LENGTH ",LL USING 4,1
RETURN
