REM Sealer: the gauge on analogue input 0 keeps 70 to 90 after a good seal; the next part comes on input 1
n = 0 : leakers = 0
LOOP
  PAUSE INX.1
  MOVEA = 85 : GO : PAUSE IDLE
  v = ADC.0
  MOVEA = 0 : GO : PAUSE IDLE
  IF v >= 70 AND v <= 90 DO
    n = n + 1
    PRINT "sealed ",n," at ",v
  ELSE
    leakers = leakers + 1
    PRINT "to cullet, ",v
  ENDIF
  PAUSE NOT INX.1
ENDL
