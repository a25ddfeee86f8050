REM a menu: 1 makes a batch, 2 cleans the piston
SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000
#MENU
? "1 RUN  2 CLEAN"
#KEY
k = INKEY
IF k = 49 THEN GOSUB RUNIT : GOTO MENU
IF k = 50 THEN GOSUB CLEAN : GOTO MENU
WAIT = 20
GOTO KEY
#CLEAN
  MOVEA.0 = 40 : GO.0 : PAUSE IDLE.0
  MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
  ? "piston cleaned"
RETURN
#RUNIT
  FOR n = 1 TO 3
    IF INX.1 = 0 THEN ? "hopper low" : RETURN
    PAUSE INX.0
    FOR r = 1 TO 4
      MOVEA.1 = r * 45 : GO.1 : PAUSE IDLE.1
      OUTX.0 = 1 : TIME = 0
      PAUSE INX.2 OR TIME > 2000
      IF INX.2 = 0 THEN OUTX.0 = 0 : ? "BAR STUCK" : RETURN
      MOVER.0 = 12 : GO.0 : PAUSE IDLE.0
      OUTX.0 = 0
      PAUSE INX.2 = 0
    NEXT
    MOVEA[0,1] = 0, 0 : GO[0,1]
    PAUSE IDLE[0] AND IDLE[1]
    PAUSE INX.0 = 0
    ? "tray ", n
  NEXT
  ? "batch ready"
RETURN
