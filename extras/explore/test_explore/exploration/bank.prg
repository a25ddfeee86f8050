REM the guard is bit 2 of the bank, the button bit 3, and bit 4 must be off
SCALE.0 = 100
mask = 28
LOOP
  REPEAT
    b = IN & mask
  UNTIL b = 12
  MOVEA.0 = 40 : GO.0 : PAUSE IDLE.0
  MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0
  PAUSE INX.3 = 0
ENDL
