"""`motionlang servo`: step responses, gains, the four profiles and programs under servo."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from motionlang.cli.command import Command, Refused, WrongOption, argument, flag, option
from motionlang.cli.complaints import run_status
from motionlang.cli.option_groups import OutputOptions, ProgramOptions, accepted_events
from motionlang.cli.picture import Picture
from motionlang.cli.readers import machine_time
from motionlang.kernel import CheckedSettings
from motionlang.kernel import run as run_program
from motionlang.kernel.servo import SERVO, Motor, VelocityDrive, make_loop, mccl_values, mint_values
from motionlang.kernel.servo import simulate as simulate_loop
from motionlang.lab.servo import view
from motionlang.lab.servo.input import BANDWIDTH, POSITIVE, Gains, OneAxis, gains_of, pairs, spoken
from motionlang.lab.servo.tn1069 import BASES
from motionlang.lab.servo.tn1069 import compare as compared
from motionlang.views.figure import Figure
from motionlang.views.table import Column, Document, Table, records_table

if TYPE_CHECKING:  # which needs numpy
    from motionlang.kernel.servo import ServoTrace


@dataclass
class ServoCommand(OutputOptions, Picture):
    """A command that simulates servo loops."""

    def run(self) -> int:
        """Simulate, print and draw; a value that does not fit the motor is a wrong option."""
        try:
            return self.simulate()
        except WrongOption:
            raise
        except (ValueError, OverflowError) as problem:
            raise WrongOption(str(problem)) from None

    def simulate(self) -> int:
        """Return the exit status; ValueError names an invalid option."""
        raise NotImplementedError

    def draw(self, trace: ServoTrace, title: str) -> int:
        """Draw a trace, if wished; return the exit status."""

        def figure() -> Figure:
            from motionlang.lab.servo.plot import trace_figure

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

    def simulate(self) -> int:
        """Print and draw the settling, errors and torques of each profile."""
        plant = self.motor_of(self.axis)
        loop = self.loop_of(self.axis, plant)
        move = self.distance, self.speed, self.accel
        tables = {
            basis: compared(loop, plant, *move, basis, self.window, self.ramp)
            for basis in ((self.equal,) if self.equal else BASES)
        }
        shown = [view.profiles_table(basis, rows, self.window) for basis, rows in tables.items()]
        texts = ["\n".join(table.lines(view.WIDTH)) + "\n" for table in shown]
        document = Document([*shown, records_table("plant", [plant])])
        self.show(document, "\n".join([*texts, f"{view.plant_line(plant)}\n"]))

        def figure() -> Figure:
            from motionlang.lab.servo.plot import comparison_figure

            return comparison_figure(tables)

        return self.drawn(figure)


@dataclass
class ServoStep(OneAxis, Gains, ServoCommand):
    """Show the step response of a simulated axis: rise, overshoot, settling."""

    title: ClassVar[str] = "step"
    size: float = option("C", "counts (100)", read=POSITIVE, default=100.0)
    time: float = option("S", "time to simulate, s (0.5)", read=POSITIVE, default=0.5)

    def simulate(self) -> int:
        """Print and draw the step response; add the figures of the linear loop, if it is one."""
        from motionlang.kernel.servo import loop_figures, step_figures, step_response

        plant = self.motor_of(self.axis)
        loop = self.loop_of(self.axis, plant)
        trace = step_response(loop, plant, self.size, self.time)
        figures = step_figures(trace, self.size)
        linear = None
        if loop.is_linear and plant.is_linear and loop.derivative_every == 1:
            linear = loop_figures(loop, plant)
        document = Document([
            records_table("step", [figures]),
            records_table("linear", [] if linear is None else [linear]),
            records_table("plant", [plant]),
        ])  # fmt: skip
        self.show(document, _text([*view.step_lines(figures, linear), "", view.plant_line(plant)]))
        return self.draw(trace, f"a step of {self.size:.10g} counts")


@dataclass
class ServoTune(OneAxis, ServoCommand):
    """Suggest gains for a motor and a bandwidth, for Mint and MCCL."""

    title: ClassVar[str] = "gains"
    no_integral: bool = flag("omit the integral term")
    size: float = option("C", "size of the step shown, counts (100)", read=POSITIVE, default=100.0)
    scale: float = option("C", "counts per user unit, for VG, AG and DG (1)", read=POSITIVE, default=1.0)

    def simulate(self) -> int:
        """Print the gains and their step response."""
        from motionlang.kernel.servo import step_figures, step_response, suggest

        plant, bandwidth = self.motor_of(self.axis), self.bandwidth or BANDWIDTH
        base = make_loop(pairs(self.loop, SERVO))
        made = suggest(plant, bandwidth, base, integral=not self.no_integral)
        trace = step_response(made.loop, plant, self.size, max(0.05, 20.0 / bandwidth))
        figures = step_figures(trace, self.size)
        mint = spoken(gains_of("mint"), mint_values(made.loop))
        mccl = spoken(gains_of("mccl"), mccl_values(made.loop, self.scale))
        gains = [
            {"dialect": language, "keyword": word, "value": value}
            for language, values in (("mint", mint), ("mccl", mccl))
            for word, value in values.items()
        ]
        tables = (
            Table("gains", (Column("dialect"), Column("keyword"), Column("value")), gains),
            records_table("loop", [made.loop]),
            records_table("step", [figures]),
            records_table("linear", [made.figures]),
            records_table("plant", [plant]),
        )
        lines = [*view.tune_lines(made, figures, mint, mccl), "", view.plant_line(plant)]
        self.show(Document(tables, {"warnings": list(made.warnings)}), _text(lines))
        return self.draw(trace, f"a step of {self.size:.10g} counts, tuned for {bandwidth:.10g} Hz")


@dataclass
class ServoRun(ProgramOptions, Gains, ServoCommand):
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
    allow: frozenset[str] = accepted_events()

    def simulate(self) -> int:
        """Run the program and print the data of the motors of its axes."""
        source, language, settings = self.source(), self.known_language(), self.settings()
        if self.plant or self.loop or self.mint or self.mccl or self.bandwidth:
            settings = CheckedSettings(
                {key: value for key, value in settings.items() if ".plant." not in key}
            )
        result = run_program(
            source, dialect=language, until=self.until, machine=settings, overrides=self.overrides()
        )
        wrong = [each for each in result.diagnostics if each.severity == "error"]
        if wrong:
            raise Refused(wrong, source=result.source, file=self.file)
        from motionlang.kernel.tracks import servo_trace

        rows: list[tuple[int, ServoTrace, float]] = []
        plants: dict[int, Motor | VelocityDrive] = {}  # of the axes whose motors are those of the options
        for number, axis in result.controller.axes.items():
            if len(axis.starts) > 1:
                end = min(result.time + self.settle_time, self.until)
                trace = servo_trace(axis, end)
                if trace is None:
                    plant = plants[number] = self.motor_of(number)
                    loop = self.loop_of(number, plant, axis.scale.counts)
                    trace = simulate_loop(axis, loop, plant, until=end)
                rows.append((number, trace, trace.settled_at(self.window, axis.end_of_motion())))
        axes = view.axes_table(rows, self.window)
        document = Document([axes, view.plants_table(plants)], {"time": result.time})
        self.show(document, _text([*axes.lines(view.WIDTH), *view.plant_lines(plants)]))
        status = run_status(result, self.allow)
        return (self.draw(rows[0][1], f"{self.file}, axis {rows[0][0]}") if rows else 0) or status


class ServoSimulation(Command):
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


def _text(lines: Sequence[str]) -> str:
    return "\n".join(lines) + "\n"
