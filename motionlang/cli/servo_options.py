"""The options of the `servo` commands."""

from __future__ import annotations

from motionlang.cli.numbers import machine_time, real
from motionlang.cli.parser import flag, option
from motionlang.cli.servo_input import LOOP_OPTIONS, PLANT_OPTIONS

_POSITIVE = real("a number greater than zero", 0.0, above=True)

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

RUN = (
    option("file", "FILE", "the program"),
    option("--dialect --lang", None, "the language; default: by file extension", choices=["mint", "mccl"]),
    option("--until", "S", "end the run after S seconds of machine time (600)", machine_time, default=600.0),
    option("--settle-time", "S", "time to simulate after the program ends, s (0.5)", _POSITIVE, default=0.5),
    option("--window", "C", "settling window, counts (1)", _POSITIVE, default=1.0),
    *PLANT_OPTIONS,
    *LOOP_OPTIONS,
)  # fmt: skip
