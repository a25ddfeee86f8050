"""`motionlang plan`: missing figures of a trapezoidal move, and its program.

AN00115: distance, time, speed, rates and ramp times determine one another; a rule supplies any figure that is
still undetermined. A move that is too short for its speed has a lower peak, which the figures show.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Command, WrongOption, flag, option
from motionlang.cli.option_groups import OutputOptions
from motionlang.cli.picture import Picture
from motionlang.cli.readers import integer, number
from motionlang.commands.plan import WRITERS, solve_plan
from motionlang.commands.plan import number as shown
from motionlang.commands.plan.an00115 import formulas
from motionlang.commands.plan.an00115_plot import plan_figure
from motionlang.commands.plan.reach import needed_distance, remedies
from motionlang.commands.plan.scale import ScaleOptions
from motionlang.commands.plan.solve import NAMES, RULES, Underdetermined
from motionlang.kernel import dialects
from motionlang.views.formatting import dialect_name
from motionlang.views.table import Column, Document, Table
from motionlang.views.terminal import styled, wants_colour

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


@dataclass
class WrittenProgram(Command):
    """The program that is written for a move."""

    title: ClassVar[str] = "program"
    lang: str | None = option("", "the language of the program; default: both", choices=dialects())
    axis: int | None = option("N", "the axis of the program (the first of the language)", read=integer)
    use_times: bool = flag("write ACCELTIME and DECELTIME instead of rates (Mint)")


@dataclass
class PlanCommand(ScaleOptions, WrittenProgram, OutputOptions, Picture):
    """Work out the missing figures of a move and write a program for it."""

    title: ClassVar[str] = "move"
    epilog: ClassVar[str] = """\
Give any figures that determine the move; a rule fills in the rest:
  third    a third of the time each for acceleration, slew and deceleration
  quarter  a quarter each for acceleration and deceleration, half for slew
  equal    the same time for acceleration and deceleration

examples:
  motionlang plan --distance 20 --time 0.6 --rule third --plot move.svg
  motionlang plan --distance 200 --speed 250 --accel 1250 --scale 1200
  motionlang plan --distance 20 --time 0.6 --speed 50 --rule equal --lang mint
  motionlang plan --resolution 0.001 --distance 20 --time 0.6 --rule third
"""
    distance: float | None = option(
        "X", "distance, user units; negative for the reverse direction", read=number
    )
    time: float | None = option("X", "time of the whole move, seconds", read=number)
    speed: float | None = option("X", "slew speed, user units/s", read=number)
    accel: float | None = option("X", "acceleration, user units/s²", read=number)
    decel: float | None = option("X", "deceleration, user units/s²; default: the acceleration", read=number)
    accel_time: float | None = option("X", "time from rest to speed, seconds", read=number)
    slew_time: float | None = option("X", "time at speed, seconds", read=number)
    decel_time: float | None = option("X", "time from speed to rest, seconds", read=number)
    rule: str | None = option("", "how to split the time if the figures do not", choices=tuple(RULES))

    def run(self) -> int:
        """Solve the move, print figures and program."""
        given = {name: value for name in NAMES if (value := getattr(self, name)) is not None}
        backwards = given.get("distance", 0.0) < 0.0
        if backwards:
            given["distance"] = -given["distance"]
        try:
            scale, how = self.counts()
        except ValueError as problem:
            raise WrongOption(str(problem)) from None
        if self.axis is not None and self.axis < (1 if self.lang == "mccl" else 0):
            raise WrongOption("no such axis: Mint numbers axes from 0, MCCL from 1")
        try:
            move, assumed, wanted = solve_plan(given, self.rule)
        except ValueError as problem:
            changes = remedies(self.rule, given)
            hint = f"\n  hint: change one: {'; '.join(changes)}" if changes else ""
            if isinstance(problem, Underdetermined):
                hint = "\n  hint: give distance, speed and accel, or distance and time with a --rule"
            raise WrongOption(f"{problem}{hint}") from None
        stated = (set(given) - set(wanted)) | assumed
        behind = formulas(move, stated, self.rule)
        status = self.drawn(lambda: plan_figure(move))
        if status:
            return status
        if backwards:
            move["distance"] = -move["distance"]
        programs = {
            name: write(move | wanted, scale, self.axis, self.use_times)
            for name, write in WRITERS.items()
            if self.lang in (None, name)
        }
        notes = [f"scale: {how} = {shown(scale)} counts/uu"] if how else []
        notes += _unreached(move, wanted)
        table = _table(move, set(given) - set(wanted), assumed, behind)
        written = [{"dialect": name, "program": program} for name, program in programs.items()]
        tables = (table, Table("programs", (Column("dialect"), Column("program")), written))
        colour = wants_colour(sys.stdout)
        lines = [*table.lines(1000, colour=colour), *_remarks(notes, programs, colour)]
        self.show(Document(tables, {"scale": scale, "notes": notes}), "\n".join(lines) + "\n")
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


def _table(move: dict[str, float], given: set[str], assumed: set[str], behind: dict[str, str]) -> Table:
    """Return the figures of a move, each with the way it is known."""
    rows = [
        {
            "figure": name,
            "value": move[name],
            "unit": UNITS[name],
            "origin": "given" if name in given else "assumed" if name in assumed else behind.get(name, ""),
        }
        for name in NAMES
    ]
    columns = (
        Column("figure", text=lambda name: name.replace("_", " "), left=True),
        Column("value", text=shown),
        Column("unit", "", left=True),
        Column("origin", "", left=True),
    )
    return Table("move", columns, rows, style=lambda row: "dim" if row["figure"] in given else "")


def _remarks(notes: list[str], programs: dict[str, str], colour: bool) -> list[str]:
    lines: list[str] = []
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
