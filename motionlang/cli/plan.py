"""`motionlang plan`: missing figures of a trapezoidal move, and its program.

AN00115: distance, time, speed, rates and ramp times determine one another; a rule supplies any figure that is
still undetermined. A move that is too short for its speed has a lower peak, which the figures show.
"""

from __future__ import annotations

import argparse
import json
import sys

from motionlang.analysis.planning import WRITERS, number, solve_plan
from motionlang.cli.format_options import add_format
from motionlang.cli.output_files import need_writer
from motionlang.cli.parser import Commands, add_all, add_command, arrange, flag, option
from motionlang.cli.plan_scale import add_scale_arguments, scale_of
from motionlang.lang.dialect import dialects
from motionlang.notes.an00115 import formulas
from motionlang.planners.reach import needed_distance, remedies
from motionlang.planners.solve import NAMES, RULES, Underdetermined
from motionlang.views.grid import Column, grid
from motionlang.views.terminal import draws, plain, styled, wants_colour
from motionlang.views.words import dialect_name

SCHEMA = "motionlang.plan/1"
UNITS = {
    "distance": "uu",
    "time": "s",
    "accel_time": "s",
    "slew_time": "s",
    "decel_time": "s",
    "speed": "uu/s",
    "accel": "uu/s²",
    "decel": "uu/s²",
}
HELP = {
    "distance": "distance of the move, user units; negative for the reverse direction",
    "time": "time of the whole move, seconds",
    "accel_time": "time from rest to speed, seconds",
    "slew_time": "time at speed, seconds",
    "decel_time": "time from speed to rest, seconds",
    "speed": "slew speed, user units/s",
    "accel": "acceleration, user units/s²",
    "decel": "deceleration, user units/s²; default: the acceleration",
}
EPILOG = """\
Give any figures that determine the move; a rule fills in the rest:
  third    a third of the time each for acceleration, slew and deceleration
  quarter  a quarter for acceleration, half for slew, a quarter for deceleration
  equal    the same time for acceleration and deceleration

examples:
  motionlang plan --distance 20 --time 0.6 --rule third
  motionlang plan --distance 20 --time 0.6 --rule third --plot move.svg
  motionlang plan --distance 200 --speed 250 --accel 1250 --scale 1200
  motionlang plan --distance 20 --time 0.6 --speed 50 --rule equal --use-times --dialect mint
  motionlang plan --encoder-lines 1000 --gear 3:1 --pitch 10 --distance 200 --time 1 --accel-time 0.2 --decel-time 0.2
"""

GROUPS = {
    "move": "distance time speed accel decel accel-time slew-time decel-time rule",
    "scale": "scale encoder-lines quadrature gear pitch degrees resolution",
    "program": "dialect axis use-times",
    "report": "format output",
    "pictures": "plot",
}


_OPTIONS = (
    option("--axis", "N", "the axis of the program; default: the first of the language", int),
    flag("--use-times", "write ACCELTIME and DECELTIME instead of rates (Mint)"),
    option("--dialect --lang", None, "the language of the program; default: both", choices=dialects()),
    option("--plot", "FILE", "draw the move into a .png or .svg file"),
)  # fmt: skip


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang plan` and its options."""
    parser = add_command(commands, "plan", summary, plan_command)
    for name in NAMES:
        parser.add_argument(f"--{name.replace('_', '-')}", type=float, metavar="X", help=HELP[name])
    parser.add_argument("--rule", choices=tuple(RULES), help="how to split the time if the figures do not")
    add_scale_arguments(parser)
    add_all(parser, _OPTIONS)
    add_format(parser)
    parser.epilog = EPILOG
    arrange(parser, GROUPS)


def plan_command(arguments: argparse.Namespace) -> int:
    """Solve the move, print figures and program; exit with 2 if there is no such move."""
    parser = arguments.parser
    given = {name: value for name in NAMES if (value := getattr(arguments, name)) is not None}
    backwards = given.get("distance", 0.0) < 0.0
    if backwards:
        given["distance"] = -given["distance"]
    try:
        scale, how = scale_of(arguments)
    except ValueError as problem:
        parser.error(str(problem))
    if arguments.axis is not None and arguments.axis < (1 if arguments.dialect == "mccl" else 0):
        parser.error("no such axis: Mint numbers axes from 0, MCCL from 1")
    try:
        move, assumed, wanted = solve_plan(given, arguments.rule)
    except ValueError as problem:
        changes = remedies(arguments.rule, given)
        hint = f"\n  hint: change one: {'; '.join(changes)}" if changes else ""
        if isinstance(problem, Underdetermined):
            hint = "\n  hint: give distance, speed and accel, or distance and time with a --rule"
        parser.error(f"{problem}{hint}")
    stated = (set(given) - set(wanted)) | assumed
    behind = formulas(move, stated, arguments.rule)
    if arguments.plot:
        status = _draw(move, arguments.plot, parser)
        if status:
            return status
    if backwards:
        move["distance"] = -move["distance"]
    programs = {
        name: write(move | wanted, scale, arguments.axis, arguments.use_times)
        for name, write in WRITERS.items()
        if arguments.dialect in (None, name)
    }
    notes = [f"scale: {how} = {number(scale)} counts/uu"] if how else []
    notes += _unreached(move, wanted)
    if arguments.format == "json":
        document = {
            "schema": SCHEMA,
            "move": move,
            "formulas": behind,
            "scale": scale,
            "notes": notes,
            "programs": programs,
        }
        sys.stdout.write(json.dumps(document, indent=1) + "\n")
        return 0
    colour = wants_colour(sys.stdout)
    lines = _lines(move, set(given) - set(wanted), assumed, behind, notes, programs, colour)
    text = "\n".join(lines) + "\n"
    sys.stdout.write(text if draws(sys.stdout) else plain(text))
    return 0


def _draw(move: dict[str, float], path: str, parser: argparse.ArgumentParser) -> int:
    """Draw the move; return 1 if the file cannot be written, which is reported."""
    from motionlang.errors import Diagnostic
    from motionlang.views.an00115_plot import draw_plan
    from motionlang.views.diagnostics import render

    if not path.lower().endswith((".png", ".svg")):
        parser.error("--plot draws .png and .svg files")
    need_writer("--plot", path)
    try:
        draw_plan(move, path)
    except OSError as problem:
        sys.stderr.write(render(Diagnostic("file", f"{path}: {problem.strerror or problem}"), None))
        return 1
    return 0


def _unreached(move: dict[str, float], wanted: dict[str, float]) -> list[str]:
    """Return the remark that the speed is not reached, and what would reach it.

    Empty if the speed is reached.
    """
    if not wanted:
        return []
    speed, distance = wanted["speed"], abs(move["distance"])
    needed = needed_distance(speed, move["accel"], move["decel"])
    factor = needed / distance
    rates = {f"{name} {move[name] * factor:.6g}" for name in ("accel", "decel")}
    each = " and ".join(sorted(rates))
    if move["accel"] == move["decel"]:
        each = f"{move['accel'] * factor:.6g} uu/s² for acceleration and deceleration"
    return [
        (
            f"the move does not reach {speed:.10g} uu/s: its peak is {move['speed']:.6g} after "
            f"{move['accel_time']:.6g} s; it needs a distance of {needed:.6g} uu, or {each}"
        )
    ]


def _lines(
    move: dict[str, float],
    given: set[str],
    assumed: set[str],
    behind: dict[str, str],
    notes: list[str],
    programs: dict[str, str],
    colour: bool,
) -> list[str]:
    rows, styles = [], []
    for name in NAMES:
        origin = "given" if name in given else "assumed" if name in assumed else behind.get(name, "")
        rows.append([name.replace("_", " "), number(move[name]), UNITS[name], origin])
        styles.append("dim" if name in given else "")
    columns = (Column("figure", align="<"), Column("value"), Column("", align="<"), Column("", align="<"))
    lines = grid(columns, rows, width=1000, colour=colour, styles=styles)
    if notes:
        lines += ["", *(f"{styled('note:', 'note', colour)} {note}" for note in notes)]
    for name, program in programs.items():
        lines += ["", styled(dialect_name(name), "bold", colour)]
        lines += [f"  {styled(line, 'word', colour)}" for line in program.splitlines()]
        if name == "mccl" and "US" not in program and "." in program:
            lines.append(
                f"  {styled('note:', 'note', colour)} without a scale MCCL accepts only whole counts; give "
                "--scale"
            )
    return lines
