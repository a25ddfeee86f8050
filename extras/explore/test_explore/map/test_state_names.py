"""The names of states in a map: a step tells the passes of a scan apart, and what most repeat is said once."""

from __future__ import annotations

from tests.cli.programs import Cell

# All steps are in the lines of one scan, a flag is set again and again, and a command is counted in each pass.
SCAN = """\
REM IN 1 start  2 stop  3 clamp shut  4 clamp open
REM OUT 1 clamp
phase = 0 : go1 = 0
LOOP
  IF INX.1 AND INX.2 THEN go1 = 1
  IF INX.2 = 0 THEN go1 = 0
  IF phase = 0 AND go1 THEN OUTX.1 = 1 : phase = 1
  IF phase = 1 AND INX.3 THEN MOVEA.0 = 50 : GO.0 : PAUSE IDLE.0 : OUTX.1 = 0 : phase = 2
  IF phase = 2 AND INX.4 THEN MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0 : ? "PART OK" : phase = 0
  WAIT = 5
ENDL
"""
# The steps have blocks, and a fault waits for its reset elsewhere.
BLOCKS = """\
REM IN 1 start  2 door shut  3 clamp shut  5 reset
REM OUT 1 clamp  2 lamp
phase = 0
LOOP
  IF INX.2 = 0 AND phase > 0 THEN GOSUB FAULT
  IF phase = 0 DO
    IF INX.1 THEN OUTX.1 = 1 : phase = 1
  ENDIF
  IF phase = 1 DO
    IF INX.3 THEN MOVEA.0 = 50 : GO.0 : PAUSE IDLE.0 : phase = 2
  ENDIF
  IF phase = 2 DO
    OUTX.1 = 0
    IF INX.3 = 0 THEN MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0 : ? "PART OK" : phase = 3
  ENDIF
  IF phase = 3 DO
    IF INX.1 = 0 THEN phase = 0
  ENDIF
  WAIT = 5
ENDL
#FAULT
  OUTX.1 = 0 : OUTX.2 = 1
  ? "DOOR"
  PAUSE INX.5 AND INX.2
  OUTX.2 = 0 : phase = 0
RETURN
"""

SCAN_STATES = """\
power-up
  by itself → 5-10 (phase = 0), 0.00 s
waits in 5-10 (phase = 0): If INX.1 AND INX.2   [input 1 (start), input 2 (stop)]
  input 1 (start) on and input 2 (stop) on → 5-10 (phase = 1), 0.00 s: output 1 (clamp) on
waits in 5-10 (phase = 1): If INX.1 AND INX.2   [input 1 (start), input 2 (stop), input 3 (clamp shut)]
  input 3 (clamp shut) on → 5-10 (phase = 2), 0.05 s: axis 0 to 50 at 2236.07; output 1 (clamp) off
waits in 5-10 (phase = 2): If INX.1 AND INX.2   [input 1 (start), input 2 (stop), input 4 (clamp open)]
  input 2 (stop) off and input 4 (clamp open) on → 5-10 (phase = 0), 0.05 s: axis 0 to 0 at 2236.07; 'PART OK'
  input 3 (clamp shut) off and input 4 (clamp open) on → 5-10 (phase = 1), 0.05 s: axis 0 to 0 at 2236.07; 'PART OK';
      output 1 (clamp) on
  input 4 (clamp open) on → 5-10 (phase = 0), 0.05 s: axis 0 to 0 at 2236.07; 'PART OK'
"""

BLOCKS_STATES = """\
in most states the program waits in 5, 6, 9, 12, 16, 19: If INX.2 = 0 AND phase > 0
power-up
  by itself → 7 (phase = 0), 0.00 s
waits in 7 (phase = 0): If INX.1   [input 2 (door shut), input 1 (start)]
  input 1 (start) on → 24 called in 5, 0.01 s: output 1 (clamp) on; output 1 (clamp) off; output 2 (lamp) on; 'DOOR'
  input 1 (start) on and input 2 (door shut) on → 10 (phase = 1), 0.00 s: output 1 (clamp) on
  input 1 (start) on and input 3 (clamp shut) on → 24 called in 5, 0.05 s: output 1 (clamp) on; axis 0 to 50 at 2236.07;
      output 1 (clamp) off; output 2 (lamp) on; 'DOOR'
waits in 10 (phase = 1): If INX.3   [input 2 (door shut), input 3 (clamp shut)]
  input 2 (door shut) off → 24 called in 5, 0.00 s: output 1 (clamp) off; output 2 (lamp) on; 'DOOR'
  input 3 (clamp shut) on → 14 (phase = 2), 0.05 s: axis 0 to 50 at 2236.07
waits in 14 (phase = 2): If INX.3 = 0   [input 2 (door shut), input 3 (clamp shut)]
  input 2 (door shut) off → 24 called in 5, 0.00 s: output 2 (lamp) on; 'DOOR'
  input 3 (clamp shut) off → 17 (phase = 3), 0.05 s: axis 0 to 0 at 2236.07; 'PART OK'
waits in 17 (phase = 3): If INX.1 = 0   [input 2 (door shut), input 1 (start)]
  input 2 (door shut) off → 24 called in 5, 0.00 s: output 2 (lamp) on; 'DOOR'
  input 1 (start) off → 7 (phase = 0), 0.00 s
waits in 24 called in 5: PAUSE INX.5 AND INX.2   [input 5 (reset), input 2 (door shut)]
  input 2 (door shut) on and input 5 (reset) on → 10 (phase = 1), 0.00 s: output 2 (lamp) off; output 1 (clamp) on
  input 1 (start) off and input 2 (door shut) on and input 5 (reset) on → 7 (phase = 0), 0.00 s: output 2 (lamp) off
"""


def states(cell: Cell, program: str) -> list[str]:
    """Return the states of the map of a program, each with its ways."""
    cell.write("a.prg", program)
    found = cell("map", "a.prg", "--all").out
    begin, end = found.index("States\n"), found.index("Inputs and outputs\n")
    lines = found[begin:end].splitlines()[1:]
    return [line for line in lines if line.strip()]


def test_a_step_in_the_lines_of_one_scan_tells_its_states_apart(cell: Cell) -> None:
    assert states(cell, SCAN) == SCAN_STATES.splitlines()


def test_what_is_repeated_in_most_states_is_said_once(cell: Cell) -> None:
    assert states(cell, BLOCKS) == BLOCKS_STATES.splitlines()
