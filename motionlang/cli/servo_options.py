"""The options of the `servo` commands."""

from __future__ import annotations

from motionlang.cli.numbers import machine_time, real, whole
from motionlang.cli.parser import flag, option
from motionlang.cli.servo_input import LOOP_OPTIONS, PLANT_OPTIONS
from motionlang.notes import dissect

SECONDS = {"second": 1.0, "minute": 60.0}
_POSITIVE = real("a number greater than zero", 0.0, above=True)
_COUNT = whole("a whole number, 1 or more", 1, 10**9)
_WHOLE = whole("a whole number from 0 to 32767", 0, 32767)
_BITS = whole("a whole number from 8 to 16", 8, 16)

_FRICTION = (
    option("--friction", "MU", "coefficient of friction (0.1)", _POSITIVE, default=dissect.FRICTION),
    option("--gravity", "G", "acceleration of gravity: 32.2 for ft, 9.81 for m", _POSITIVE, default=dissect.GRAVITY_FT),
    option("--speed", "V", "target speed (100)", _POSITIVE, default=dissect.SPEED_FT_MIN),
    option("--per", None, "time unit of the speed (minute)", choices=list(SECONDS), default="minute"),
    option("--unit", None, "the name of the length unit (ft)", default="ft"),
)  # fmt: skip

SLIP = (
    *_FRICTION,
    option("--weight", "W", "weight of the load (5 lb)", _POSITIVE, default=dissect.WEIGHT_LB),
    option("--distance", "D", "check a move of this distance", _POSITIVE),
    option("--move-speed", "V", "speed of the move, units/s (--speed)", _POSITIVE),
    option("--accel", "A", "acceleration of the move, units/s²", _POSITIVE),
    option("--profile", None, "profile of the move (all four)",
           choices=["trapezoid", "sinusoidal", "scurve", "parabolic"]),
    option("--ramp", "N", "ramp fraction of the S-curve (0.1)", _POSITIVE, default=0.1),
)  # fmt: skip

DAC = (
    *_FRICTION,
    option("--bits", "N", "bits of the DAC; may be repeated (12 and 16)", _BITS, action="append"),
    option("--fraction", "X", "demanded acceleration as a fraction of the limit (0.25)", _POSITIVE, default=0.25),
    option("--gain", "KP", "proportional gain of the loop (60)", _COUNT, default=60),
)  # fmt: skip

COMPARE = (
    *PLANT_OPTIONS,
    *LOOP_OPTIONS,
    option("--distance", "D", "counts (40000, as in TN1069)", _POSITIVE, default=40_000.0),
    option("--speed", "V", "counts/s (40000)", _POSITIVE, default=40_000.0),
    option("--accel", "A", "counts/s² (100000)", _POSITIVE, default=100_000.0),
    option("--equal", None, "show only the comparison at equal acceleration or at equal time",
           choices=["acceleration", "time"]),
    option("--window", "C", "settling window, counts (1)", _POSITIVE, default=1.0),
    option("--ramp", "N", "ramp fraction of the trapezoidal S-curve (0.1)", _POSITIVE, default=0.1),
)  # fmt: skip

STEP = (
    *PLANT_OPTIONS,
    *LOOP_OPTIONS,
    option("--size", "C", "counts (100)", _POSITIVE, default=100.0),
    option("--time", "S", "time to simulate, s (0.5)", _POSITIVE, default=0.5),
)

TUNE = (
    *PLANT_OPTIONS,
    option("--loop", "NAME=VALUE", "rates and limits of the loop", action="append", default=[]),
    option("--bandwidth", "HZ", "closed-loop bandwidth, Hz (50)", _POSITIVE, default=50.0),
    flag("--no-integral", "omit the integral term"),
    option("--size", "C", "size of the step shown, counts (100)", _POSITIVE, default=100.0),
    option("--scale", "C", "counts per user unit, for VG, AG and DG (1)", _POSITIVE, default=1.0),
)  # fmt: skip

FIGURE = (option("number", "N", "12.1 to 12.11", choices=[f"12.{k}" for k in range(1, 12)]),)

# Values are per update, as in the listing.
LISTING = (
    option("--distance", "D", "counts (20000)", _COUNT, default=20_000),
    option("--speed", "V", "MxVel, counts per update (50)", _COUNT, default=50),
    option("--accel", "A", "change of velocity per update (1)", _COUNT, default=1),
    option("--hold", "N", "RegCnt: updates per DAC value (4)", _COUNT, default=4),
    option("--steps", "N", "MxDAC_Stps: override limit, 0 for none (32)", _WHOLE, default=32),
    option("--kp", "K", "proportional gain (40)", _WHOLE, default=40),
    option("--ki", "K", "integral gain (0)", _WHOLE, default=0),
    option("--kd", "K", "differential gain (80)", _WHOLE, default=80),
    option("--bits", "N", "bits of the DAC (12)", _BITS, default=12),
    option("--full-speed", "V", "counts per update at full scale (100)", _POSITIVE, default=100.0),
    option("--time-constant", "T", "time constant of the drive, in updates (2)", _POSITIVE, default=2.0),
    option("--updates", "N", "number of updates (1000)", _COUNT, default=1000),
)  # fmt: skip

RUN = (
    option("file", "FILE", "the program"),
    option("--dialect --lang", None, "the language; default: by file extension", choices=["mint", "mccl"]),
    option("--until", "S", "end the run after S seconds of machine time (600)", machine_time, default=600.0),
    option("--settle-time", "S", "time to simulate after the program ends, s (0.5)", _POSITIVE, default=0.5),
    option("--window", "C", "settling window, counts (1)", _POSITIVE, default=1.0),
    *PLANT_OPTIONS,
    *LOOP_OPTIONS,
)  # fmt: skip
