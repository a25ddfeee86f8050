"""Default values of settings, used by the rows of the table and by the operations."""

from __future__ import annotations

# Bit patterns of a bank of inputs.
PATTERNS = {"INPUTMODE": 0, "INPUTPOSTRIGGER": -1, "INPUTNEGTRIGGER": 0, "IMASK": -1}
ANALOGUE = {"ADCGAIN": 100.0, "ADCOFFSET": 0.0}
# The reaction of an axis to an error: one of the _em constants.
MODES = {
    "LIMITMODE": 1,
    "SOFTLIMITMODE": 1,
    "FOLERRORMODE": 2,
    "ERRORINPUTMODE": 3,
    "ABORTMODE": 1,
}
STOP_INPUT_MODE = 3
IDLE = {"IDLEMODE": 0, "IDLEPOS": 0.0, "IDLEVEL": 0.0, "IDLETIME": 0}
# The gains of the servo loop, by quantity. A test checks that `kernel/servo/gains.py` has the same values.
GAINS = {
    "proportional": 0.0,
    "integral": 0.0,
    "integral_limit": 100.0,
    "integral_mode": 0.0,
    "derivative": 0.0,
    "velocity_feedback": 0.0,
    "velocity_ff": 0.0,
    "accel_ff": 0.0,
}
# The quantity that LOOPTIME sets.
PERIOD = "period"
LOOP_TIME, FATAL_ERROR = 1000.0, 8388607.0
HOME_SPEED, HOME_BACKOFF = 4000.0, 10.0
# HOME: the constant, the direction of the search, what is searched for, and True if an index mark follows.
# The numbers are from memory. The sources only say that 1 homes on the switch and the encoder's index (MN1270
# p. 86).
HOME_TYPES: tuple[tuple[str, int, str, bool], ...] = (
    ("_hmNEGATIVE_SWITCH", -1, "home", False),
    ("_hmNEGATIVE_SWITCH_INDEX", -1, "home", True),
    ("_hmPOSITIVE_SWITCH", +1, "home", False),
    ("_hmPOSITIVE_SWITCH_INDEX", +1, "home", True),
    ("_hmNEGATIVE_INDEX", -1, "index", True),
    ("_hmPOSITIVE_INDEX", +1, "index", True),
    ("_hmNEGATIVE_LIMIT", -1, "limit", False),
    ("_hmNEGATIVE_LIMIT_INDEX", -1, "limit", True),
    ("_hmPOSITIVE_LIMIT", +1, "limit", False),
    ("_hmPOSITIVE_LIMIT_INDEX", +1, "limit", True),
)
