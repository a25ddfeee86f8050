REM the guard is bit 2 of the bank, the button bit 3; bit 4 is not asked for
SCALE.0 = 100
LOOP
  REPEAT
    b = IN & 12
  UNTIL b = 12
  MOVEA.0 = 40 : GO.0 : PAUSE IDLE.0
  MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
  PAUSE INX.3 = 0
ENDL
