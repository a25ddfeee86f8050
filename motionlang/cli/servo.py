"""`motionlang servo`: step responses, gains, the four profiles and programs under servo."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from dataclasses import dataclass, fields, is_dataclass
from math import isfinite
from typing import TYPE_CHECKING, ClassVar

from motionlang.cli.command import Command, Refused, WrongOption, argument, flag, option
from motionlang.cli.readers import machine_time
from motionlang.cli.servo_input import BANDWIDTH, POSITIVE, Gains, OneAxis, gains_of, pairs
from motionlang.cli.shared import Picture, Program, Report
from motionlang.execution import Checked
from motionlang.execution import run as run_program
from motionlang.lang.gains import spoken
from motionlang.log.track import WholeTrack
from motionlang.notes.tn1069_servo import BASES
from motionlang.notes.tn1069_servo import compare as compared
from motionlang.servo import simulate
from motionlang.servo.gains import mccl_values, mint_values
from motionlang.servo.plant import Drive, Motor
from motionlang.servo.settings import SERVO, make_loop
from motionlang.views import servo as view
from motionlang.views.figure import Figure

if TYPE_CHECKING:  # which needs numpy
    from motionlang.servo.trace import ServoTrace

SCHEMA = "motionlang.servo/1"


@dataclass
class ServoCommand(Report, Picture):
    """A command that simulates servo loops."""

    def run(self) -> int:
        """Simulate, print and draw; a value that does not fit the motor is a wrong option."""
        try:
            return self.show()
        except WrongOption:
            raise
        except (ValueError, OverflowError) as problem:
            raise WrongOption(str(problem)) from None

    def show(self) -> int:
        """Return the exit status; ValueError names an invalid option."""
        raise NotImplementedError

    def draw(self, trace: ServoTrace, title: str) -> int:
        """Draw a trace, if wished; return the exit status."""

        def figure() -> Figure:
            from motionlang.views.servo_plot import trace_figure

            return trace_figure(trace, title)

        return self.drawn(figure)


@dataclass
class ServoCompare(OneAxis, Gains, ServoCommand):
    """Compare the four profiles of TN1069 under servo, at equal acceleration and equal time."""

    title: ClassVar[str] = "comparison"
    distance: float = option("D", "counts (40000, as in TN1069)", read=POSITIVE, default=40_000.0)
    speed: float = option("V", "counts/s (40000)", read=POSITIVE, default=40_000.0)
    accel: float = option("A", "counts/s² (100000)", read=POSITIVE, default=100_000.0)
    equal: str | None = option(
        "", "show only the comparison at equal acceleration or at equal time", choices=tuple(BASES)
    )
    window: float = option("C", "settling window, counts (1)", read=POSITIVE, default=1.0)
    ramp: float = option("N", "ramp fraction of the trapezoidal S-curve (0.1)", read=POSITIVE, default=0.1)

    def show(self) -> int:
        """Print and draw the settling, errors and torques of each profile."""
        plant = self.motor_of(self.axis)
        loop = self.loop_of(self.axis, plant)
        move = self.distance, self.speed, self.accel
        tables = {
            basis: compared(loop, plant, *move, basis, self.window, self.ramp)
            for basis in ((self.equal,) if self.equal else BASES)
        }
        if self.format == "json":
            made = {basis: [_plain(row, "trace") for row in rows] for basis, rows in tables.items()}
            _print_json({"plant": _plain(plant), **made})
        elif self.format == "text":
            for i, (basis, rows) in enumerate(tables.items()):
                _print([*([""] if i else []), *view.compare_lines(basis, rows, self.window)])
            _print(["", view.plant_line(plant)])

        def figure() -> Figure:
            from motionlang.views.servo_plot import comparison_figure

            return comparison_figure(tables)

        return self.drawn(figure)


@dataclass
class ServoStep(OneAxis, Gains, ServoCommand):
    """Show the step response of a simulated axis: rise, overshoot, settling."""

    title: ClassVar[str] = "step"
    size: float = option("C", "counts (100)", read=POSITIVE, default=100.0)
    time: float = option("S", "time to simulate, s (0.5)", read=POSITIVE, default=0.5)

    def show(self) -> int:
        """Print and draw the step response; add the figures of the linear loop, if it is one."""
        from motionlang.servo.response import loop_figures, step_figures, step_response

        plant = self.motor_of(self.axis)
        loop = self.loop_of(self.axis, plant)
        trace = step_response(loop, plant, self.size, self.time)
        figures = step_figures(trace, self.size)
        linear = None
        if loop.is_linear and plant.is_linear and loop.derivative_every == 1:
            linear = loop_figures(loop, plant)
        if self.format == "json":
            found = {**_plain(figures), "linear": None if linear is None else _plain(linear)}
            _print_json({"plant": _plain(plant), **found})
        elif self.format == "text":
            _print([*view.step_lines(figures, linear), "", view.plant_line(plant)])
        return self.draw(trace, f"a step of {self.size:.10g} counts")


@dataclass
class ServoTune(OneAxis, ServoCommand):
    """Suggest gains for a motor and a bandwidth, for Mint and MCCL."""

    title: ClassVar[str] = "gains"
    no_integral: bool = flag("omit the integral term")
    size: float = option("C", "size of the step shown, counts (100)", read=POSITIVE, default=100.0)
    scale: float = option("C", "counts per user unit, for VG, AG and DG (1)", read=POSITIVE, default=1.0)

    def show(self) -> int:
        """Print the gains and their step response."""
        from motionlang.servo.response import step_figures, step_response
        from motionlang.servo.tuning import suggest

        plant, bandwidth = self.motor_of(self.axis), self.bandwidth or BANDWIDTH
        base = make_loop(pairs(self.loop, SERVO))
        made = suggest(plant, bandwidth, base, integral=not self.no_integral)
        trace = step_response(made.loop, plant, self.size, max(0.05, 20.0 / bandwidth))
        figures = step_figures(trace, self.size)
        mint = spoken(gains_of("mint"), mint_values(made.loop))
        mccl = spoken(gains_of("mccl"), mccl_values(made.loop, self.scale))
        if self.format == "json":
            gains = {"loop": _plain(made.loop), "mint": mint, "mccl": mccl, "warnings": list(made.warnings)}
            of = {"linear": _plain(made.figures), "step": _plain(figures)}
            _print_json({"plant": _plain(plant), **gains, **of})
        elif self.format == "text":
            _print([*view.tune_lines(made, figures, mint, mccl), "", view.plant_line(plant)])
        return self.draw(trace, f"a step of {self.size:.10g} counts, tuned for {bandwidth:.10g} Hz")


@dataclass
class ServoRun(Program, Gains, ServoCommand):
    """Run a program with a simulated servo loop and motor.

    The motors are those of the machine file or of the options.
    """

    title: ClassVar[str] = "run"
    file: str = argument("FILE", "the program")
    until: float = option(
        "S", "end the run after S seconds of machine time (600)", read=machine_time, default=600.0
    )
    settle_time: float = option(
        "S", "time to simulate after the program ends, s (0.5)", read=POSITIVE, default=0.5
    )
    window: float = option("C", "settling window, counts (1)", read=POSITIVE, default=1.0)

    def show(self) -> int:
        """Run the program and print the data of the motors of its axes."""
        source, language, settings = self.source(), self.known_language(), self.settings()
        if self.plant or self.loop or self.mint or self.mccl or self.bandwidth:
            settings = Checked({key: value for key, value in settings.items() if ".plant." not in key})
        result = run_program(
            source, dialect=language, until=self.until, machine=settings, overrides=self.overrides()
        )
        wrong = [each for each in result.diagnostics if each.severity == "error"]
        if wrong:
            raise Refused(wrong, source=result.source, file=self.file)
        from motionlang.log.history import servo_trace

        rows: list[tuple[int, ServoTrace, float]] = []
        plants: dict[int, Motor | Drive] = {}  # of the axes whose motors are those of the options
        for number, axis in result.controller.axes.items():
            if len(axis.starts) > 1:
                end = min(result.time + self.settle_time, self.until)
                trace = servo_trace(axis, end)
                if trace is None:
                    plant = plants[number] = self.motor_of(number)
                    loop = self.loop_of(number, plant, axis.scale.counts)
                    trace = simulate(WholeTrack(axis), loop, plant, until=end)
                rows.append((number, trace, trace.settled_at(self.window, axis.end_of_motion())))
        if self.format == "json":
            figures = {"axes": [view.run_figures(*row) for row in rows], "time": result.time}
            _print_json({**figures, "plants": {str(axis): _plain(plant) for axis, plant in plants.items()}})
        elif self.format == "text":
            lines = view.run_lines(rows, self.window) if rows else ["no axis was moved"]
            _print([*lines, *view.plant_lines(plants)])
        return self.draw(rows[0][1], f"{self.file}, axis {rows[0][0]}") if rows else 0


class Servo(Command):
    """Simulate and tune the servo loop behind the profile."""

    commands: ClassVar = {
        "compare": (
            ServoCompare,
            "compare the four profiles of TN1069 under servo, at equal acceleration and equal time",
        ),
        "step": (ServoStep, "show the step response of a simulated axis"),
        "tune": (ServoTune, "suggest gains for a motor and a bandwidth, for Mint and MCCL"),
        "run": (ServoRun, "run a program with a simulated servo loop and motor"),
    }


def _plain(value: object, *without: str) -> dict[str, object]:
    """Return the fields of a dataclass; values that JSON cannot represent are null."""
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
    return _plain(value) if is_dataclass(value) else str(value)
