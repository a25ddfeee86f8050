"""`motionlang plan`: the missing figures of a trapezoidal move, and a program that makes it.

AN00115's lesson: distance, time, speed, rates and ramp times determine one another; a rule fills what is still free.
"""

from __future__ import annotations

import json
import sys
from typing import TYPE_CHECKING

from motionlang.execution import dialects
from motionlang.profile.solve import NAMES, RULES, solve_move
from motionlang.views.grid import Column, grid
from motionlang.views.terminal import draws, plain, styled, wants_colour
from motionlang.views.words import dialect_name

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable

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
# What MCCL takes in whole counts while no user unit is set.
WHOLE = ("distance", "speed", "accel", "decel")
HELP = {
    "distance": "distance of the move, user units; negative for a move the other way",
    "time": "time of the whole move, seconds",
    "accel_time": "time from rest to speed, seconds",
    "slew_time": "time at speed, seconds",
    "decel_time": "time from speed to rest, seconds",
    "speed": "slew speed, user units a second",
    "accel": "acceleration, user units a second squared",
    "decel": "deceleration; as the acceleration where nothing else is said",
}
EPILOG = """\
Any figures that determine the move will do; a rule fills what is still free:
  third    a third of the time each to speed up, to run and to slow down
  quarter  a quarter to speed up, half to run, a quarter to slow down
  equal    as long to speed up as to slow down

examples:
  motionlang plan --distance 20 --time 0.6 --rule third
  motionlang plan --distance 200 --speed 250 --accel 1250 --scale 1200
  motionlang plan --distance 20 --time 0.6 --speed 50 --rule equal --by-times --dialect mint
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options of `plan`."""
    for name in NAMES:
        parser.add_argument(f"--{name.replace('_', '-')}", type=float, metavar="X", help=HELP[name])
    parser.add_argument("--rule", choices=tuple(RULES), help="how to split the time where nothing else does")
    parser.add_argument("--scale", type=float, default=1.0, metavar="COUNTS", help="counts per user unit (1)")
    parser.add_argument("--axis", type=int, metavar="N", help="the axis of the program; the language's first")
    parser.add_argument(
        "--by-times", action="store_true", help="ACCELTIME and DECELTIME instead of rates (Mint)"
    )
    parser.add_argument("--dialect", choices=dialects(), help="the language of the program; both without it")
    parser.add_argument("--json", action="store_true", help="print one JSON document and nothing else")
    parser.epilog = EPILOG


def plan_command(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> int:
    """Solve, and print the figures and the program; argparse's error where the figures do not make a move."""
    given = {name: value for name in NAMES if (value := getattr(arguments, name)) is not None}
    backwards = given.get("distance", 0.0) < 0.0
    if backwards:
        given["distance"] = -given["distance"]
    if not 1e-6 <= arguments.scale <= 1e12:
        parser.error("--scale must be a number of counts from 1e-06 to 1e+12")
    if arguments.axis is not None and arguments.axis < (1 if arguments.dialect == "mccl" else 0):
        parser.error("there is no such axis: Mint counts from 0, MCCL from 1")
    try:
        move, assumed = _solve(given, arguments.rule)
    except ValueError as problem:
        parser.error(str(problem))
    if backwards:
        move["distance"] = -move["distance"]
    programs = {
        name: write(move, arguments.scale, arguments.axis, arguments.by_times)
        for name, write in WRITERS.items()
        if arguments.dialect in (None, name)
    }
    if arguments.json:
        sys.stdout.write(json.dumps({"schema": SCHEMA, "move": move, "programs": programs}, indent=1) + "\n")
        return 0
    colour = wants_colour(sys.stdout)
    text = "\n".join(_lines(move, set(given), assumed, programs, colour)) + "\n"
    sys.stdout.write(text if draws(sys.stdout) else plain(text))
    return 0


def _solve(given: dict[str, float], rule: str | None) -> tuple[dict[str, float], set[str]]:
    """The eight figures, and those that were taken over from their opposite number for want of anything else."""
    try:
        return solve_move(rule, **given), set()
    except ValueError:
        for one, other in (("accel", "decel"), ("accel_time", "decel_time")):
            if (one in given) != (other in given) and rule is None:
                missing = other if one in given else one
                full = {**given, missing: given[one if one in given else other]}
                try:
                    return solve_move(None, **full), {missing}
                except ValueError:
                    continue
        raise


def _lines(
    move: dict[str, float], given: set[str], assumed: set[str], programs: dict[str, str], colour: bool
) -> list[str]:
    rows, styles = [], []
    for name in NAMES:
        origin = "given" if name in given else "assumed" if name in assumed else ""
        rows.append([name.replace("_", " "), _number(move[name]), UNITS[name], origin])
        styles.append("dim" if name in given else "")
    columns = (Column("figure", align="<"), Column("value"), Column("", align="<"), Column("", align="<"))
    lines = grid(columns, rows, width=1000, colour=colour, styles=styles)
    for name, program in programs.items():
        lines += ["", styled(dialect_name(name), "bold", colour)]
        lines += [f"  {styled(line, 'word', colour)}" for line in program.splitlines()]
        if name == "mccl" and "US" not in program and any("." in _number(move[each]) for each in WHOLE):
            lines.append(
                f"  {styled('note:', 'note', colour)} without a scale MCCL takes whole counts only; give --scale"
            )
    return lines


def _mint(move: dict[str, float], scale: float, axis: int | None, by_times: bool) -> str:
    """The move in Mint, where ramp times are milliseconds."""
    n = axis or 0
    lines = [f"SCALEFACTOR({n}) = {_number(scale)}"] if scale != 1.0 else []
    lines.append(f"SPEED({n}) = {_number(move['speed'])}")
    for rate, time in (("accel", "accel_time"), ("decel", "decel_time")):
        word, value = (rate, move[rate]) if not by_times else (rate + "time", 1000.0 * move[time])
        lines.append(f"{word.upper()}({n}) = {_number(value)}")
    lines += [f"MOVER({n}) = {_number(move['distance'])}", f"GO({n})"]
    return "\n".join(lines) + "\n"


def _mccl(move: dict[str, float], scale: float, axis: int | None, by_times: bool) -> str:
    """The move in MCCL, which knows rates only; a scale acts from the next MN on."""
    n = 1 if axis is None else axis
    lines = [f"{n}US{_number(scale)}"] if scale != 1.0 else []
    lines += [
        f"{n}MN,{n}PM,{n}PT",
        f"{n}SV{_number(move['speed'])},{n}SA{_number(move['accel'])},{n}DS{_number(move['decel'])}",
        f"{n}MR{_number(move['distance'])},{n}WS0",
    ]
    return "\n".join(lines) + "\n"


WRITERS: dict[str, Callable[[dict[str, float], float, int | None, bool], str]] = {
    "mint": _mint,
    "mccl": _mccl,
}


def _number(value: float) -> str:
    """A figure as both languages read it: no exponent, no digit that says nothing."""
    text = f"{value:.10g}"
    return f"{value:.12f}".rstrip("0").rstrip(".") if "e" in text else text
