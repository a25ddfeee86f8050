"""`motionlang servo`: slip, DAC steps, profiles under servo, step responses, first gains, and chapter 12's figures.

`add_parser` registers the commands; each handler takes the parsed arguments and returns the exit status.
"""

from __future__ import annotations

import json
import sys
from math import inf, isfinite
from typing import TYPE_CHECKING

from motionlang.cli_servo_input import add_loop, add_plant, loop_of, plant_of
from motionlang.profile import dissect

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable, Sequence

    from motionlang.controller.servo.slip import Slip

    Handler = Callable[[argparse.Namespace], int]

OK, WRONG, USAGE = 0, 1, 2
SCHEMA = "motionlang.servo/1"
PLOTS = (".png", ".svg")


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Register `servo` and its commands; the chosen handler is `args.handler`."""
    servo = subparsers.add_parser(
        "servo", help="the servo behind the profile: slip, DAC steps, tuning, comparison"
    )
    commands = servo.add_subparsers(dest="servo_command", required=True, metavar=" | ".join(_COMMANDS))
    for name, (summary, handler, options) in _COMMANDS.items():
        parser = commands.add_parser(name, help=summary, description=summary)
        options(parser)
        parser.add_argument("--report", choices=["table", "json", "none"], default="table")
        parser.add_argument("--plot", metavar="OUT", help="draw it into a .png or .svg file")
        parser.set_defaults(handler=_guarded(name, handler))


# --------------------------------------------------------------------------------------------------- the commands


def slip(args: argparse.Namespace) -> int:
    """How fast a load may be accelerated that only friction holds, and whether a move keeps to it."""
    from motionlang.views import servo as view

    limit = dissect.slip_acceleration(args.friction, args.gravity)
    per_second = args.speed / _SECONDS[args.per]
    figures = {
        "weight": args.weight,
        "friction_force": dissect.friction_force(args.weight, args.friction),
        "limit": limit,
        "speed": per_second,
        "fastest_time": dissect.fastest_time(per_second, limit),
    }
    checked = _moves_to_check(args)
    if args.report == "json":
        _print_json({**figures, "moves": [{"move": name, **_slip_json(found)} for name, found in checked]})
    elif args.report == "table":
        _print(view.slip_lines(args, figures))
        for name, found in checked:
            _print(["", *view.slip_check_lines(name, found, args.unit)])
    if args.plot:
        from motionlang.views.chapter12 import draw_figure

        draw_figure("12.3", args.plot)
    return WRONG if any(found.slips for _, found in checked) else OK


def dac(args: argparse.Namespace) -> int:
    """What a DAC step asks of the motor, and what holding it back gains."""
    from motionlang.controller.servo.override import demonstrate
    from motionlang.views import servo as view

    limit = dissect.slip_acceleration(args.friction, args.gravity)
    speed = args.speed / _SECONDS[args.per]
    timings = [dissect.dac_timing(speed, limit, bits) for bits in args.bits or (12, 16)]
    runs = demonstrate(speed, limit, args.friction, args.gravity, args.share, args.gain)
    if args.report == "json":
        _print_json(
            {
                "limit": limit,
                "timings": [_plain(t) for t in timings],
                "runs": [_plain(r, "trace") for r in runs],
            }
        )
    elif args.report == "table":
        _print(view.dac_lines(timings, args))
        _print(["", *view.override_lines(runs, args.unit)])
    if args.plot:
        from motionlang.views.servo_plot import plot_override

        plot_override(runs, limit, args.unit, args.plot)
    return OK


def compare(args: argparse.Namespace) -> int:
    """The four profiles of TN1069 on one simulated axis."""
    from motionlang.controller.servo.compare import BASES
    from motionlang.controller.servo.compare import compare as compared
    from motionlang.views import servo as view

    plant = plant_of(args)
    loop = loop_of(args, plant)
    bases = (args.equal,) if args.equal else BASES
    tables = {
        basis: compared(loop, plant, args.distance, args.speed, args.accel, basis, args.window, args.ramp)
        for basis in bases
    }
    if args.report == "json":
        _print_json({basis: [_plain(row, "trace") for row in rows] for basis, rows in tables.items()})
    elif args.report == "table":
        for i, (basis, rows) in enumerate(tables.items()):
            _print([*([""] if i else []), *view.compare_lines(basis, rows, args.window)])
    if args.plot:
        from motionlang.views.servo_plot import plot_comparison

        plot_comparison(tables, args.plot)
    return OK


def step(args: argparse.Namespace) -> int:
    """The answer of an axis to a step: rise, overshoot, settling."""
    from motionlang.controller.servo.response import loop_figures, step_figures, step_response
    from motionlang.views import servo as view

    plant = plant_of(args)
    loop = loop_of(args, plant)
    trace = step_response(loop, plant, args.size, args.time)
    figures = step_figures(trace, args.size)
    linear = None
    if loop.is_linear and plant.is_linear and loop.derivative_every == 1:
        linear = loop_figures(loop, plant)
    if args.report == "json":
        _print_json({**_plain(figures), "linear": None if linear is None else _plain(linear)})
    elif args.report == "table":
        _print(view.step_lines(figures, linear))
    if args.plot:
        from motionlang.views.servo_plot import plot_trace

        plot_trace(trace, f"a step of {args.size:g} counts", args.plot)
    return OK


def tune(args: argparse.Namespace) -> int:
    """First gains for a motor and a bandwidth, as Mint and as MCCL have them."""
    from motionlang.cli_servo_input import pairs
    from motionlang.controller.servo.gains import mccl_values, mint_values
    from motionlang.controller.servo.response import step_figures, step_response
    from motionlang.controller.servo.settings import SERVO, make_loop
    from motionlang.controller.servo.tuning import suggest
    from motionlang.views import servo as view

    plant = plant_of(args)
    base = make_loop(pairs(args.loop, SERVO))
    made = suggest(plant, args.bandwidth, base, integral=not args.no_integral)
    trace = step_response(made.loop, plant, args.size, max(0.05, 20.0 / args.bandwidth))
    figures = step_figures(trace, args.size)
    mint, mccl = mint_values(made.loop), mccl_values(made.loop, args.scale)
    if args.report == "json":
        gains = {"loop": _plain(made.loop), "mint": mint, "mccl": mccl, "warnings": list(made.warnings)}
        _print_json({**gains, "linear": _plain(made.figures), "step": _plain(figures)})
    elif args.report == "table":
        _print(view.tune_lines(made, figures, mint, mccl))
    if args.plot:
        from motionlang.views.servo_plot import plot_trace

        plot_trace(trace, f"a step of {args.size:g} counts, tuned for {args.bandwidth:g} Hz", args.plot)
    return OK


def figure(args: argparse.Namespace) -> int:
    """The figures of chapter 12: what they show in numbers, and as a picture."""
    from motionlang.views.chapter12 import FIGURES, draw_figure, figure_lines

    if args.report == "json":
        _print_json(
            {"figure": args.number, "title": FIGURES[args.number].title, "lines": figure_lines(args.number)}
        )
    elif args.report == "table":
        _print(figure_lines(args.number))
    if args.plot:
        draw_figure(args.number, args.plot)
    return OK


def listing(args: argparse.Namespace) -> int:
    """Chapter 12's C program, run on its own drive."""
    from motionlang.controller.servo.chapter12 import NOTES, Settings, run_listing
    from motionlang.views import servo as view

    settings = Settings(
        args.distance,
        args.speed,
        args.accel,
        args.kp,
        args.ki,
        args.kd,
        hold=args.hold,
        max_steps=args.steps,
        bits=args.bits,
    )
    made = run_listing(settings, args.full_speed, args.time_constant, args.updates)
    if args.report == "json":
        columns = {name: list(getattr(made, name)) for name in ("demand", "position", "velocity", "dac")}
        _print_json(
            {"peak_onset": made.peak_onset, "peak_mean": made.peak_mean, **columns, "notes": list(NOTES)}
        )
    elif args.report == "table":
        _print(view.listing_lines(settings, made))
    if args.plot:
        from motionlang.views.servo_plot import plot_listing

        plot_listing(made, args.plot)
    return OK


def run(args: argparse.Namespace) -> int:
    """Run a program and send what its axes were told to do through a servo and a motor."""
    from motionlang import run as run_program
    from motionlang.controller.servo import simulate
    from motionlang.views import servo as view

    plant = plant_of(args)
    loop = loop_of(args, plant)
    result = run_program(args.file, dialect=args.dialect, until=args.until)
    if any(found.severity == "error" for found in result.diagnostics):
        raise ValueError(f"{args.file} does not run: {result.diagnostics[0].message}")
    rows = []
    for number, axis in result.controller.axes.items():
        if len(axis.starts) > 1:
            trace = simulate(axis, loop, plant, until=min(result.time + args.rest, args.until))
            rows.append((number, trace, trace.settled_at(args.window, axis.end_of_motion())))
    if args.report == "json":
        _print_json({"axes": [view.run_figures(*row) for row in rows], "time": result.time})
    elif args.report == "table":
        _print(view.run_lines(rows, args.window) if rows else ["no axis was moved"])
    if args.plot and rows:
        from motionlang.views.servo_plot import plot_trace

        plot_trace(rows[0][1], f"{args.file}, axis {rows[0][0]}", args.plot)
    return OK


# ---------------------------------------------------------------------------------------------------- the options

_SECONDS = {"second": 1.0, "minute": 60.0}


def _slip_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    _add_friction(parser)
    add("--weight", type=_positive, default=dissect.WEIGHT_LB, metavar="W", help="weight of the load (5 lb)")
    add("--distance", type=_positive, metavar="D", help="check a move of this distance")
    add("--move-speed", type=_positive, metavar="V", help="its speed, units a second (the --speed)")
    add("--accel", type=_positive, metavar="A", help="its acceleration, units/s²")
    add("--profile", choices=["trapezoid", "sinusoidal", "scurve", "parabolic"], help="its shape (all four)")
    add("--ramp", type=_positive, default=0.1, metavar="N", help="the ramp of the S-curve (0.1)")


def _dac_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    _add_friction(parser)
    add(
        "--bits",
        type=_bits,
        action="append",
        metavar="N",
        help="bits of the DAC; may be repeated (12 and 16)",
    )
    add("--share", type=_positive, default=0.25, metavar="X", help="demanded share of the limit (0.25)")
    add("--gain", type=_count, default=60, metavar="KP", help="proportional gain of the loop (60)")


def _add_friction(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add(
        "--friction",
        type=_positive,
        default=dissect.FRICTION,
        metavar="MU",
        help="coefficient of friction (0.1)",
    )
    add("--gravity", type=_positive, default=dissect.GRAVITY_FT, metavar="G", help="32.2, for ft; 9.81 for m")
    add("--speed", type=_positive, default=dissect.SPEED_FT_MIN, metavar="V", help="speed to reach (100)")
    add("--per", choices=list(_SECONDS), default="minute", help="what the speed is per (minute)")
    add("--unit", default="ft", help="the name of the length unit (ft)")


def _compare_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add_plant(parser)
    add_loop(parser)
    add("--distance", type=_positive, default=40_000.0, metavar="D", help="counts (40000, as in TN1069)")
    add("--speed", type=_positive, default=40_000.0, metavar="V", help="counts/s (40000)")
    add("--accel", type=_positive, default=100_000.0, metavar="A", help="counts/s² (100000)")
    add("--equal", choices=["acceleration", "time"], help="only this comparison")
    add("--window", type=_positive, default=1.0, metavar="C", help="settled within this many counts (1)")
    add("--ramp", type=_positive, default=0.1, metavar="N", help="the ramp of the trapezoidal S-curve (0.1)")


def _step_options(parser: argparse.ArgumentParser) -> None:
    add_plant(parser)
    add_loop(parser)
    parser.add_argument("--size", type=_positive, default=100.0, metavar="C", help="counts (100)")
    parser.add_argument("--time", type=_positive, default=0.5, metavar="S", help="seconds to watch (0.5)")


def _tune_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add_plant(parser)
    add("--loop", action="append", default=[], metavar="NAME=VALUE", help="rates and limits of the loop")
    add("--bandwidth", type=_positive, default=50.0, metavar="HZ", help="wanted closed-loop bandwidth (50)")
    add("--no-integral", action="store_true", help="leave the integral out")
    add("--size", type=_positive, default=100.0, metavar="C", help="counts of the step shown (100)")
    add(
        "--scale",
        type=_positive,
        default=1.0,
        metavar="C",
        help="counts per user unit, for VG, AG and DG (1)",
    )


def _figure_options(parser: argparse.ArgumentParser) -> None:
    numbers = [f"12.{k}" for k in range(1, 12)]
    parser.add_argument("number", choices=numbers, metavar="N", help="12.1 to 12.11")


def _listing_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--distance", type=_count, default=20_000, metavar="D", help="counts (20000)")
    add("--speed", type=_count, default=50, metavar="V", help="MxVel, counts per update (50)")
    add("--accel", type=_count, default=1, metavar="A", help="what the velocity changes by (1)")
    add("--hold", type=_count, default=4, metavar="N", help="RegCnt: updates a DAC value is held (4)")
    add("--steps", type=_whole, default=32, metavar="N", help="MxDAC_Stps; 0: no override (32)")
    add("--kp", type=_whole, default=40, metavar="K", help="proportional gain (40)")
    add("--ki", type=_whole, default=0, metavar="K", help="integral gain (0)")
    add("--kd", type=_whole, default=80, metavar="K", help="differential gain (80)")
    add("--bits", type=_bits, default=12, metavar="N", help="bits of the DAC (12)")
    add(
        "--full-speed",
        type=_positive,
        default=100.0,
        metavar="V",
        help="counts per update at full scale (100)",
    )
    add("--time-constant", type=_positive, default=2.0, metavar="T", help="of the drive, in updates (2)")
    add("--updates", type=_count, default=1000, metavar="N", help="updates to run (1000)")


def _run_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("file", metavar="FILE", help="the program")
    add("--dialect", choices=["mint", "mccl"], help="the language, where the suffix does not say it")
    add("--until", type=_positive, default=600.0, metavar="S", help="end after this machine time (600)")
    add("--rest", type=_positive, default=0.5, metavar="S", help="seconds to watch after the program (0.5)")
    add("--window", type=_positive, default=1.0, metavar="C", help="settled within this many counts (1)")
    add_plant(parser)
    add_loop(parser)


_COMMANDS: dict[str, tuple[str, Handler, Callable[[argparse.ArgumentParser], None]]] = {
    "slip": (
        "how fast a load held by friction may be accelerated, and whether a move keeps to it",
        slip,
        _slip_options,
    ),
    "dac": ("what one DAC step asks of a motor, and the override that holds it back", dac, _dac_options),
    "compare": (
        "the four profiles of TN1069 under servo, at equal acceleration and equal time",
        compare,
        _compare_options,
    ),
    "step": ("the answer of a simulated axis to a step", step, _step_options),
    "tune": ("first gains for a motor and a bandwidth, as Mint and as MCCL have them", tune, _tune_options),
    "run": ("a program's motion through a servo and a motor", run, _run_options),
    "listing": ("the C program that closes chapter 12, run", listing, _listing_options),
    "figure": ("the figures of chapter 12, in numbers and drawn", figure, _figure_options),
}


def _positive(text: str) -> float:
    value = _number(text, float)
    if not 0.0 < value < inf:
        raise _refused(text, "a number greater than zero")
    return value


def _count(text: str) -> int:
    value = _number(text, int)
    if not 1 <= value <= 10**9:
        raise _refused(text, "a whole number from 1 on")
    return int(value)


def _whole(text: str) -> int:
    value = _number(text, int)
    if not 0 <= value <= 32767:
        raise _refused(text, "a whole number from 0 to 32767")
    return int(value)


def _bits(text: str) -> int:
    value = _number(text, int)
    if not 8 <= value <= 16:
        raise _refused(text, "a whole number from 8 to 16")
    return int(value)


def _number(text: str, kind: Callable[[str], float]) -> float:
    try:
        return kind(text)
    except ValueError:
        raise _refused(text, "a whole number" if kind is int else "a number") from None


def _refused(text: str, wanted: str) -> Exception:
    from argparse import ArgumentTypeError

    return ArgumentTypeError(f"{text!r} is not {wanted}")


# ---------------------------------------------------------------------------------------------------- in and out


def _moves_to_check(args: argparse.Namespace) -> list[tuple[str, Slip]]:
    from motionlang.controller.servo.compare import SHAPES
    from motionlang.controller.servo.slip import check_profile
    from motionlang.profile import plan

    if args.distance is None:
        if args.accel is not None or args.profile is not None:
            raise ValueError("to check a move give its --distance and its --accel")
        return []
    if args.accel is None:
        raise ValueError("to check a move give its --accel as well")
    speed = args.move_speed or args.speed / _SECONDS[args.per]
    found = []
    for shape in (args.profile,) if args.profile else SHAPES:
        profile = plan(shape, 0.0, args.distance, speed, args.accel, args.accel, ramp=args.ramp)
        found.append((shape, check_profile(profile, args.friction, args.gravity)))
    return found


def _slip_json(found: Slip) -> dict[str, object]:
    return {**_plain(found), "slips": found.slips, "margin": found.margin}


def _plain(value: object, *without: str) -> dict[str, object]:
    """The fields of a dataclass; what has no number in JSON is null."""
    from dataclasses import fields

    found: dict[str, object] = {}
    for field in fields(value):  # type: ignore[arg-type]
        if field.name not in without:
            item = getattr(value, field.name)
            found[field.name] = None if isinstance(item, float) and not isfinite(item) else item
    return found


def _print(lines: Sequence[str]) -> None:
    sys.stdout.write("\n".join(lines) + "\n")


def _print_json(body: dict[str, object]) -> None:
    text = json.dumps({"schema": SCHEMA, **body}, indent=2, allow_nan=False, default=_as_json)
    sys.stdout.write(text + "\n")


def _as_json(value: object) -> object:
    from dataclasses import is_dataclass

    return _plain(value) if is_dataclass(value) else str(value)


def _guarded(name: str, handler: Handler) -> Handler:
    """A handler whose troubles are messages: 2 where the command line is wrong, 1 where a file is."""

    def call(args: argparse.Namespace) -> int:
        try:
            _check_plot(args.plot)
            return handler(args)
        except OSError as problem:
            return _complain(name, f"{problem.filename or 'a file'}: {problem.strerror or problem}", WRONG)
        except ImportError:
            return _complain(name, "a plot needs matplotlib: pip install 'motionlang[plot]'", USAGE)
        except (ValueError, OverflowError) as problem:
            return _complain(name, str(problem), USAGE)

    return call


def _check_plot(path: str | None) -> None:
    if path is not None and not path.lower().endswith(PLOTS):
        raise ValueError(f"--plot writes {' and '.join(PLOTS)} files, not {path}")


def _complain(name: str, message: str, status: int) -> int:
    sys.stderr.write(f"motionlang servo {name}: error: {message}\n")
    return status
