"""`motionlang servo`: step responses, gains, the four profiles and programs under servo.

`add_parser` registers the commands; each handler takes the parsed arguments and returns the exit status.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Sequence
from math import isfinite

from motionlang.cli.complaints import complain, unreadable, unwritten
from motionlang.cli.format_options import add_format
from motionlang.cli.options import REPORTS
from motionlang.cli.output_files import need_writer
from motionlang.cli.parser import Commands, Row, add_all, arrange, sentence
from motionlang.cli.servo_input import gains_of, loop_of, machine_of, pairs, plant_of
from motionlang.cli.servo_options import COMPARE, RUN, STEP, TUNE

Handler = Callable[[argparse.Namespace], int]

OK, WRONG, USAGE = 0, 1, 2
SCHEMA = "motionlang.servo/1"
PLOTS = (".png", ".svg")

GROUPS = {
    "motor and servo loop": "machine axis plant loop mint mccl model bandwidth",
    "report": "format quiet output",
    "pictures": "plot",
}


def add_parser(family: Commands, summary: str) -> None:
    """Add `motionlang servo` and its commands."""
    servo = family.add_parser("servo", help=summary, description=sentence(summary))
    commands = servo.add_subparsers(dest="servo_command", required=True, metavar=" | ".join(_COMMANDS))
    servo.usage = "%(prog)s [-h] COMMAND ..."  # Python 3.13 does not wrap a long list of commands
    for name, (what, handler, rows) in _COMMANDS.items():
        parser = commands.add_parser(name, help=what, description=sentence(what))
        add_all(parser, rows)
        add_format(parser, REPORTS)
        parser.add_argument("--plot", metavar="OUT", help="draw the result into a .png or .svg file")
        arrange(parser, GROUPS)
        parser.set_defaults(command=_guarded(name, handler))


# --------------------------------------------------------------------------------------------------- commands


def compare(args: argparse.Namespace) -> int:
    """Compare the four profiles of TN1069 on one simulated axis."""
    from motionlang.notes.tn1069_servo import BASES
    from motionlang.notes.tn1069_servo import compare as compared
    from motionlang.views import servo as view

    plant = plant_of(args)
    loop = loop_of(args, plant)
    bases = (args.equal,) if args.equal else BASES
    tables = {
        basis: compared(loop, plant, args.distance, args.speed, args.accel, basis, args.window, args.ramp)
        for basis in bases
    }
    if args.format == "json":
        made = {basis: [_plain(row, "trace") for row in rows] for basis, rows in tables.items()}
        _print_json({"plant": _plain(plant), **made})
    elif args.format == "table":
        for i, (basis, rows) in enumerate(tables.items()):
            _print([*([""] if i else []), *view.compare_lines(basis, rows, args.window)])
        _print(["", view.plant_line(plant)])
    if args.plot:
        from motionlang.views.servo_plot import plot_comparison

        plot_comparison(tables, args.plot)
    return OK


def step(args: argparse.Namespace) -> int:
    """Print the step response of an axis: rise, overshoot, settling."""
    from motionlang.servo.response import loop_figures, step_figures, step_response
    from motionlang.views import servo as view

    plant = plant_of(args)
    loop = loop_of(args, plant)
    trace = step_response(loop, plant, args.size, args.time)
    figures = step_figures(trace, args.size)
    linear = None
    if loop.is_linear and plant.is_linear and loop.derivative_every == 1:
        linear = loop_figures(loop, plant)
    if args.format == "json":
        found = {**_plain(figures), "linear": None if linear is None else _plain(linear)}
        _print_json({"plant": _plain(plant), **found})
    elif args.format == "table":
        _print([*view.step_lines(figures, linear), "", view.plant_line(plant)])
    if args.plot:
        from motionlang.views.servo_plot import plot_trace

        plot_trace(trace, f"a step of {args.size:.10g} counts", args.plot)
    return OK


def tune(args: argparse.Namespace) -> int:
    """Print starting gains for a motor and a bandwidth, in Mint and in MCCL."""
    from motionlang.lang.gains import spoken
    from motionlang.servo.gains import mccl_values, mint_values
    from motionlang.servo.response import step_figures, step_response
    from motionlang.servo.settings import SERVO, make_loop
    from motionlang.servo.tuning import suggest
    from motionlang.views import servo as view

    plant = plant_of(args)
    base = make_loop(pairs(args.loop, SERVO))
    made = suggest(plant, args.bandwidth, base, integral=not args.no_integral)
    trace = step_response(made.loop, plant, args.size, max(0.05, 20.0 / args.bandwidth))
    figures = step_figures(trace, args.size)
    mint = spoken(gains_of("mint"), mint_values(made.loop))
    mccl = spoken(gains_of("mccl"), mccl_values(made.loop, args.scale))
    if args.format == "json":
        gains = {"loop": _plain(made.loop), "mint": mint, "mccl": mccl, "warnings": list(made.warnings)}
        of = {"linear": _plain(made.figures), "step": _plain(figures)}
        _print_json({"plant": _plain(plant), **gains, **of})
    elif args.format == "table":
        _print([*view.tune_lines(made, figures, mint, mccl), "", view.plant_line(plant)])
    if args.plot:
        from motionlang.views.servo_plot import plot_trace

        plot_trace(trace, f"a step of {args.size:.10g} counts, tuned for {args.bandwidth:.10g} Hz", args.plot)
    return OK


def run(args: argparse.Namespace) -> int:
    """Run a program on its machine and show the motor data.

    The motors are those of the machine file or of the options.
    """
    from motionlang import run as run_program
    from motionlang.log.history import servo_trace
    from motionlang.log.track import WholeTrack
    from motionlang.servo import simulate
    from motionlang.views import servo as view

    settings = machine_of(args)
    result = run_program(args.file, dialect=args.dialect, until=args.until, machine=settings)
    if any(found.severity == "error" for found in result.diagnostics):
        return _complain("run", f"{args.file} does not run: {result.diagnostics[0].message}", WRONG)
    rows, plants = [], {}  # of the axes whose motors are those of the options
    for args.axis, axis in result.controller.axes.items():
        if len(axis.starts) > 1:
            end = min(result.time + args.settle_time, args.until)
            trace = servo_trace(axis, end)
            if trace is None:
                plant = plants[args.axis] = plant_of(args)
                trace = simulate(WholeTrack(axis), loop_of(args, plant, axis.scale.counts), plant, until=end)
            rows.append((args.axis, trace, trace.settled_at(args.window, axis.end_of_motion())))
    if args.format == "json":
        figures = {"axes": [view.run_figures(*row) for row in rows], "time": result.time}
        _print_json({**figures, "plants": {str(axis): _plain(plant) for axis, plant in plants.items()}})
    elif args.format == "table":
        lines = view.run_lines(rows, args.window) if rows else ["no axis was moved"]
        _print([*lines, *view.plant_lines(plants)])
    if args.plot and rows:
        from motionlang.views.servo_plot import plot_trace

        plot_trace(rows[0][1], f"{args.file}, axis {rows[0][0]}", args.plot)
    return OK


_COMMANDS: dict[str, tuple[str, Handler, tuple[Row, ...]]] = {
    "compare": (
        "compare the four profiles of TN1069 under servo, at equal acceleration and equal time",
        compare,
        COMPARE,
    ),
    "step": ("show the step response of a simulated axis", step, STEP),
    "tune": ("suggest gains for a motor and a bandwidth, for Mint and MCCL", tune, TUNE),
    "run": ("run a program with a simulated servo loop and motor", run, RUN),
}


# ------------------------------------------------------------------------------------------- input and output


def _plain(value: object, *without: str) -> dict[str, object]:
    """Return the fields of a dataclass; values that JSON cannot represent are null."""
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
    """Return a handler that reports errors: 2 for the command line, 1 for a file."""

    def call(args: argparse.Namespace) -> int:
        try:
            _check_plot(args.plot)
            return handler(args)
        except OSError as problem:
            if problem.filename is None:  # of standard output: `main` reports it
                raise
            say = unwritten if problem.filename == args.plot else unreadable
            complain([say(problem.filename, problem)], None, "")
            return WRONG
        except (ValueError, OverflowError) as problem:
            return _complain(name, str(problem), USAGE)

    return call


def _check_plot(path: str | None) -> None:
    if path is None:
        return
    if not path.lower().endswith(PLOTS):
        raise ValueError(f"--plot writes {' and '.join(PLOTS)} files, not {path}")
    need_writer("--plot", path)


def _complain(name: str, message: str, status: int) -> int:
    sys.stderr.write(f"motionlang servo {name}: error: {message}\n")
    return status
