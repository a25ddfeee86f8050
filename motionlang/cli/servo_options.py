"""The options of the `servo` commands."""

from __future__ import annotations

import argparse

from motionlang.cli.numbers import real, whole
from motionlang.cli.servo_input import add_loop, add_plant
from motionlang.planners import dissect

SECONDS = {"second": 1.0, "minute": 60.0}
_POSITIVE = real("a number greater than zero", 0.0, above=True)
_COUNT = whole("a whole number, 1 or more", 1, 10**9)
_WHOLE = whole("a whole number from 0 to 32767", 0, 32767)
_BITS = whole("a whole number from 8 to 16", 8, 16)


def slip_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of `servo slip`: friction, the load, and a move to check."""
    add = parser.add_argument
    _add_friction(parser)
    add("--weight", type=_POSITIVE, default=dissect.WEIGHT_LB, metavar="W", help="weight of the load (5 lb)")
    add("--distance", type=_POSITIVE, metavar="D", help="check a move of this distance")
    add("--move-speed", type=_POSITIVE, metavar="V", help="speed of the move, units/s (--speed)")
    add("--accel", type=_POSITIVE, metavar="A", help="acceleration of the move, units/s²")
    add(
        "--profile",
        choices=["trapezoid", "sinusoidal", "scurve", "parabolic"],
        help="profile of the move (all four)",
    )
    add("--ramp", type=_POSITIVE, default=0.1, metavar="N", help="ramp fraction of the S-curve (0.1)")


def dac_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of `servo dac`: bits, the share of full scale, the gain."""
    add = parser.add_argument
    _add_friction(parser)
    add(
        "--bits",
        type=_BITS,
        action="append",
        metavar="N",
        help="bits of the DAC; may be repeated (12 and 16)",
    )
    add(
        "--fraction",
        type=_POSITIVE,
        default=0.25,
        metavar="X",
        help="demanded acceleration as a fraction of the limit (0.25)",
    )
    add("--gain", type=_COUNT, default=60, metavar="KP", help="proportional gain of the loop (60)")


def _add_friction(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add(
        "--friction",
        type=_POSITIVE,
        default=dissect.FRICTION,
        metavar="MU",
        help="coefficient of friction (0.1)",
    )
    add(
        "--gravity",
        type=_POSITIVE,
        default=dissect.GRAVITY_FT,
        metavar="G",
        help="acceleration of gravity: 32.2 for ft, 9.81 for m",
    )
    add("--speed", type=_POSITIVE, default=dissect.SPEED_FT_MIN, metavar="V", help="target speed (100)")
    add("--per", choices=list(SECONDS), default="minute", help="time unit of the speed (minute)")
    add("--unit", default="ft", help="the name of the length unit (ft)")


def compare_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of `servo compare`: motor, loop, move, settling window."""
    add = parser.add_argument
    add_plant(parser)
    add_loop(parser)
    add("--distance", type=_POSITIVE, default=40_000.0, metavar="D", help="counts (40000, as in TN1069)")
    add("--speed", type=_POSITIVE, default=40_000.0, metavar="V", help="counts/s (40000)")
    add("--accel", type=_POSITIVE, default=100_000.0, metavar="A", help="counts/s² (100000)")
    add(
        "--equal",
        choices=["acceleration", "time"],
        help="show only the comparison at equal acceleration or at equal time",
    )
    add("--window", type=_POSITIVE, default=1.0, metavar="C", help="settling window, counts (1)")
    add(
        "--ramp",
        type=_POSITIVE,
        default=0.1,
        metavar="N",
        help="ramp fraction of the trapezoidal S-curve (0.1)",
    )


def step_options(parser: argparse.ArgumentParser) -> None:
    add_plant(parser)
    add_loop(parser)
    parser.add_argument("--size", type=_POSITIVE, default=100.0, metavar="C", help="counts (100)")
    parser.add_argument("--time", type=_POSITIVE, default=0.5, metavar="S", help="time to simulate, s (0.5)")


def tune_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of `servo tune`: motor, rates, bandwidth in Hz, displayed step."""
    add = parser.add_argument
    add_plant(parser)
    add("--loop", action="append", default=[], metavar="NAME=VALUE", help="rates and limits of the loop")
    add("--bandwidth", type=_POSITIVE, default=50.0, metavar="HZ", help="closed-loop bandwidth, Hz (50)")
    add("--no-integral", action="store_true", help="omit the integral term")
    add("--size", type=_POSITIVE, default=100.0, metavar="C", help="size of the step shown, counts (100)")
    add(
        "--scale",
        type=_POSITIVE,
        default=1.0,
        metavar="C",
        help="counts per user unit, for VG, AG and DG (1)",
    )


def figure_options(parser: argparse.ArgumentParser) -> None:
    numbers = [f"12.{k}" for k in range(1, 12)]
    parser.add_argument("number", choices=numbers, metavar="N", help="12.1 to 12.11")


def listing_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of `servo listing`; values are per update, as in the listing."""
    add = parser.add_argument
    add("--distance", type=_COUNT, default=20_000, metavar="D", help="counts (20000)")
    add("--speed", type=_COUNT, default=50, metavar="V", help="MxVel, counts per update (50)")
    add("--accel", type=_COUNT, default=1, metavar="A", help="change of velocity per update (1)")
    add("--hold", type=_COUNT, default=4, metavar="N", help="RegCnt: updates per DAC value (4)")
    add("--steps", type=_WHOLE, default=32, metavar="N", help="MxDAC_Stps: override limit, 0 for none (32)")
    add("--kp", type=_WHOLE, default=40, metavar="K", help="proportional gain (40)")
    add("--ki", type=_WHOLE, default=0, metavar="K", help="integral gain (0)")
    add("--kd", type=_WHOLE, default=80, metavar="K", help="differential gain (80)")
    add("--bits", type=_BITS, default=12, metavar="N", help="bits of the DAC (12)")
    add(
        "--full-speed",
        type=_POSITIVE,
        default=100.0,
        metavar="V",
        help="counts per update at full scale (100)",
    )
    add(
        "--time-constant",
        type=_POSITIVE,
        default=2.0,
        metavar="T",
        help="time constant of the drive, in updates (2)",
    )
    add("--updates", type=_COUNT, default=1000, metavar="N", help="number of updates (1000)")


def run_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of `servo run`: a program, its time limit, motor and loop."""
    add = parser.add_argument
    add("file", metavar="FILE", help="the program")
    add("--dialect", choices=["mint", "mccl"], help="the language; default: by file extension")
    add(
        "--until",
        type=_POSITIVE,
        default=600.0,
        metavar="S",
        help="end the run after S seconds of machine time (600)",
    )
    add(
        "--settle-time",
        type=_POSITIVE,
        default=0.5,
        metavar="S",
        help="time to simulate after the program ends, s (0.5)",
    )
    add("--window", type=_POSITIVE, default=1.0, metavar="C", help="settling window, counts (1)")
    add_plant(parser)
    add_loop(parser)
