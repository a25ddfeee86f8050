"""Runs for testing views without a language: the controller is driven directly."""

from __future__ import annotations

from motionlang.kernel import Controller, Dialect, Machine, Run, Source


class Nameless(Dialect):
    """A dialect that has only a name."""

    name = "mint"


def new_run(name: str = "pick.mnt", axes: int = 4) -> tuple[Run, Controller]:
    """Return a run that has not started, and its controller."""
    machine = Machine({"controller.axes": axes})
    return Run(Source(name, ""), Nameless(), machine), machine.controller


def ended(run: Run, status: str = "ended") -> Run:
    """Return the run after setting its final state."""
    run.time, run.status = run.controller.clock.now, status
    run.machine.terminal.close()
    return run


def ballscrew() -> Run:
    """Return AN00115's exercise: 1200 counts/mm, 250 mm/s, 1250 mm/s², 200 mm."""
    run, controller = new_run("ballscrew.mnt")
    controller.set_scale(0, 1200.0)
    for name, value in (("speed", 300_000.0), ("accel", 1_500_000.0), ("decel", 1_500_000.0)):
        controller.configure(0, name, value)
    controller.clock.advance(5e-5)
    controller.move_by(0, 240_000.0, "MOVER", 5)
    controller.clock.advance(controller.idle_time(0))
    return ended(run)


def pick() -> Run:
    """Return a run of three axes: three shapes, a stop, a return, an unfinished jog."""
    run, controller = new_run("pick.mnt")
    for axis, shape in enumerate(("trapezoid", "sinusoidal", "parabolic")):
        controller.set_scale(axis, 1200.0)
        for name, value in (
            ("shape", shape),
            ("speed", 300_000.0),
            ("accel", 1_500_000.0),
            ("decel", 1_000_000.0),
        ):
            controller.configure(axis, name, value)
    controller.move_by(0, 240_000.0, "MOVER", 5)
    controller.move_by(1, 100_000.0, "MOVER", 6)
    controller.clock.advance(0.7)
    controller.move_by(2, -300_000.0, "MOVER", 8)
    controller.clock.advance(1.2)
    controller.stop(2)
    controller.clock.advance(1.6)
    controller.move_to(0, 0.0, "MOVEA", 12)
    controller.jog(1, -50_000.0, "JOG", 14)
    controller.clock.advance(3.0)
    return ended(run, "until")


def shift(moves: int = 400) -> Run:
    """Return a run of many different moves of four axes, one every 1.44 s."""
    run, controller = new_run("shift.mnt")
    for axis in range(4):
        controller.set_scale(axis, 1200.0)
    for i in range(moves):
        controller.move_by(i % 4, 997.0 * ((i * 37) % 101) - 48_000.0, "MOVER", 5 + i % 2)
        controller.clock.advance(controller.clock.now + 1.44)
    return ended(run)


def short_shift() -> Run:
    """Return a run of 120 moves, which is sampled finely in little time."""
    return shift(120)


def switched() -> Run:
    """Return a run of 10 units at 10 units/s with minimal ramps and switched channels."""
    run, controller = new_run()
    controller.set_scale(0, 100.0)
    for name, value in (("speed", 1000.0), ("accel", 1e12), ("decel", 1e12)):
        controller.configure(0, name, value)
    controller.inputs[12] = 1
    controller.clock.advance(0.150000001)
    controller.outputs[1] = 1
    controller.clock.advance(0.25)
    controller.inputs[3] = 1
    controller.move_by(0, 1000.0)
    controller.clock.advance(0.6)
    controller.outputs[1] = 0
    controller.analogue_inputs[0] = 12.5
    controller.clock.advance(1.5)
    return ended(run)
