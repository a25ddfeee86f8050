REM Both hands are free first and come together, while a strap lies there; it is taken out before the next one
AUTO
SPEED.0 = 350 : ACCEL.0 = 3000 : DECEL.0 = 3000
armed = 0 : straps = 0
LOOP
  IF INX.0 = 0 AND INX.1 = 0 THEN armed = 1
  both = 0
  IF INX.0 + INX.1 = 2 AND armed DO
    armed = 0 : both = 1
  ENDIF
  ready = INX.3
  OUTX.2 = ready
  IF both AND ready DO
    OUTX.1 = 1
    MOVEA.0 = 90 : GO.0 : PAUSE IDLE.0
    MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
    OUTX.1 = 0
    straps = straps + 1
    ? "strap ", straps
    PAUSE INX.3 = 0
  ENDIF
  WAIT = 5
ENDL
