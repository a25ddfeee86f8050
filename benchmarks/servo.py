"""The servo: its steps against a plain Python loop, and all against real time.

Prints `name value unit`. Ratios compare times within one run, the best of several interleaved rounds. Every
engine gets the same trajectory points and produces the same columns; the results are compared before the
engines are timed. `in-a-run` is a program that moves eight axes with motors back and forth, from its text to
its end, including the suggestion of their gains. `suggestion` is the suggestion alone, for a new motor.
"""

from __future__ import annotations

import gc
import os
from time import process_time
from typing import TYPE_CHECKING

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np

from motionlang.execution import run
from motionlang.planners import hold, plan_sinusoidal
from motionlang.servo import Loop, Motor, Track, simulate
from motionlang.servo.discrete import discretise
from motionlang.servo.steps import COLUMNS, empty_columns, initial_state, stepper
from motionlang.servo.stretch import run_stretch
from motionlang.servo.tuning import suggested_loop
from motionlang.source import Source

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    Array = NDArray[np.float64]

SECONDS = 60
RATE = 4000
STEPS = SECONDS * RATE
ROUNDS = 7
MIN_TIME = 0.02
REQUESTED = ("position", "output")
LOOP = Loop(0.04, 2e-5, 0.9, integral_limit=5.0)
MOTOR = Motor()
AXES = "0, 1, 2, 3, 4, 5, 6, 7"
# Eight axes back and forth, at rest for as long as they move.
PROGRAM = f"""
Dim n As Integer
SCALEFACTOR({AXES}) = 100;
SPEED({AXES}) = 100;
ACCEL({AXES}) = 500;
DECEL({AXES}) = 500;
For n = 1 To 12
  MOVER({AXES}) = 20, 30, 40, 35, 20, 30, 40, 35
  GO({AXES})
  PAUSE IDLE({AXES})
  WAIT(500)
  MOVEA({AXES}) = 0;
  GO({AXES})
  PAUSE IDLE({AXES})
  WAIT(500)
Next
"""


def points(kick: float = 0.0) -> Array:
    """Return smooth moves of 0.8 s back and forth, one per second.

    Every ten seconds there is a jump of `kick` counts.
    """
    t = np.arange(SECONDS * 1000 + 1) / 1000.0
    x = np.minimum((t % 1.0) / 0.8, 1.0)
    s = x - np.sin(2.0 * np.pi * x) / (2.0 * np.pi)
    there = np.where(np.floor(t) % 2 == 0, s, 1.0 - s) * 4000.0 + kick * (np.floor(t / 10.0) % 2)
    return np.append(there[0], there)


def track() -> Track:
    """Return moves like those of `points`, as profiles of the planner."""
    starts, profiles, position = [0.0], [hold(0.0)], 0.0
    for k in range(SECONDS):
        target = 4000.0 if k % 2 == 0 else 0.0
        move = plan_sinusoidal(position, target, 15_000.0, 100_000.0, 100_000.0)
        starts += [float(k), k + move.duration]
        profiles += [move, hold(target)]
        position = target
    return Track(starts, profiles)


def python_loop(demand: list[float], loop: Loop, motor: Motor) -> tuple[list[float], list[float]]:
    """Run loop and motor in plain Python, optimised: one pass with local variables.

    Return the positions and the outputs.
    """
    regime = discretise(motor, loop.period).regimes[1, 1]
    (a00, a01, a02), (a10, a11, a12), (a20, a21, a22) = regime.a
    b0, b1, b2 = regime.b
    kp, ki, kd = loop.proportional, loop.integral, loop.derivative
    most, sum_most = loop.output_limit, loop.integral_limit / loop.integral
    least, sum_least = -most, -sum_most
    p = v = c = s = last = 0.0
    positions: list[float] = []
    outputs: list[float] = []
    put, out = positions.append, outputs.append
    for r in demand:
        e = r - p
        s += e
        if s > sum_most:
            s = sum_most
        elif s < sum_least:
            s = sum_least
        u = kp * e + ki * s + kd * (e - last)
        last = e
        if u > most:
            u = most
        elif u < least:
            u = least
        put(p)
        out(u)
        p, v, c = (
            a00 * p + a01 * v + a02 * c + b0 * u,
            a10 * p + a11 * v + a12 * c + b1 * u,
            a20 * p + a21 * v + a22 * c + b2 * u,
        )
    return positions, outputs


def stretch(at: Array, columns: tuple[str, ...]) -> list[Array]:
    """Simulate `STEPS` samples along trajectory points; return the columns.

    The motion begins at the second point; the first one precedes it.
    """
    state = initial_state(discretise(MOTOR, LOOP.period), float(at[1]))
    made, _ = run_stretch(LOOP, MOTOR, columns, at, 0, STEPS, state)
    return [np.asarray(column) for column in made.columns]


def written_out(demand: list[float], loop: Loop, motor: Motor, columns: tuple[str, ...]) -> None:
    """Run the step loop generated for one loop and one motor."""
    run = stepper(loop, motor, columns)
    run(demand, (), initial_state(discretise(motor, loop.period), 0.0), empty_columns(columns))


def interpolated(at: Array) -> list[float]:
    """Return the command at the servo rate."""
    time = np.arange(STEPS) / RATE
    made: list[float] = np.interp(time, np.arange(-1, len(at) - 1) / 1000.0, at).tolist()
    return made


def timed(jobs: dict[str, Callable[[], object]]) -> dict[str, float]:
    """Return CPU seconds of each job, the best of interleaved rounds.

    A job that takes less than `MIN_TIME` is repeated within a round.
    """
    best: dict[str, float] = {}
    repeats: dict[str, int] = {}
    for name, job in jobs.items():
        job()
        begin = process_time()
        job()
        repeats[name] = max(1, round(MIN_TIME / max(process_time() - begin, 1e-6)))
        best[name] = float("inf")
    for _ in range(ROUNDS):
        for name, job in jobs.items():
            gc.collect()
            begin = process_time()
            for _ in range(repeats[name]):
                job()
            best[name] = min(best[name], (process_time() - begin) / repeats[name])
    return best


def check(at: Array) -> float:
    """Return the largest difference between the plain loop and the stretch engine.

    It is relative to the travel, or to the output limit.
    """
    positions, outputs = python_loop(interpolated(at), LOOP, MOTOR)
    position, output = stretch(at, REQUESTED)
    worst = float(np.abs(position - positions).max()) / float(np.abs(at).max())
    return max(worst, float(np.abs(output - outputs).max()) / LOOP.output_limit)


def in_a_run(quantised: bool) -> float:
    """Return machine time over CPU time of the program; all axes have the same motor."""
    plant = {"load_inertia": 4e-5, "quantised": quantised}
    machine = {f"axis.{axis}.plant.{name}": value for axis in range(8) for name, value in plant.items()}
    began = process_time()
    result = run(Source("eight.mnt", PROGRAM), machine=machine, cache=False)
    assert result.status == "ended"
    return result.time / (process_time() - began)


def suggestion(number: int) -> float:
    """Return CPU seconds to suggest gains for a motor that has not been seen before."""
    began = process_time()
    suggested_loop(Motor(load_inertia=4e-5 + 1e-6 * number), 40.0, Loop())
    return process_time() - began


def main() -> None:
    """Measure, and print."""
    smooth, rough = points(), points(500.0)
    demand, moves = interpolated(smooth), track()
    jobs: dict[str, Callable[[], object]] = {
        "python": lambda: python_loop(demand, LOOP, MOTOR),
        "written": lambda: written_out(demand, LOOP, MOTOR, REQUESTED),
        "written-all": lambda: written_out(demand, LOOP, MOTOR, COLUMNS),
        "stretch": lambda: stretch(smooth, REQUESTED),
        "stretch-all": lambda: stretch(smooth, COLUMNS),
        "stretch-limits": lambda: stretch(rough, REQUESTED),
        "simulate": lambda: simulate(moves, LOOP, MOTOR, until=SECONDS - 1e-4, columns=REQUESTED),
        "quantised": lambda: written_out(demand, LOOP, Motor(quantised=True), REQUESTED),
        "friction": lambda: written_out(demand, LOOP, Motor(coulomb=0.003), REQUESTED),
        "both": lambda: written_out(demand, LOOP, Motor(coulomb=0.003, quantised=True), REQUESTED),
        "both-all": lambda: written_out(demand, LOOP, Motor(coulomb=0.003, quantised=True), COLUMNS),
        "chapter12": lambda: written_out(
            demand,
            Loop(100, 4, 2000, integral_limit=2000, arithmetic="chapter12", dac_bits=12),
            Motor(quantised=True),
            REQUESTED,
        ),
    }
    took = timed(jobs)
    saturated = int((np.abs(stretch(rough, REQUESTED)[1]) >= LOOP.output_limit).sum())
    print(f"difference-to-python {max(check(smooth), check(rough)):.2e} of range")
    for name, seconds in took.items():
        print(f"{name}-step {seconds / STEPS * 1e9:.2f} ns")
    print(f"saturated-steps {saturated} of {STEPS}")
    for name in ("stretch", "stretch-limits", "simulate"):
        print(f"{name}-vs-python {took['python'] / took[name]:.1f} times faster")
    for name in ("stretch", "stretch-limits", "simulate"):
        print(f"{name}-real-time {SECONDS / took[name]:.0f} times, one axis")
    for name in ("quantised", "friction", "both", "both-all", "chapter12"):
        print(f"{name}-real-time {SECONDS / took[name] / 8.0:.0f} times, eight axes")
    for name, quantised in (("linear", False), ("quantised", True)):
        print(f"{name}-in-a-run {max(in_a_run(quantised) for _ in range(ROUNDS)):.0f} times, eight axes")
    print(f"suggestion {min(suggestion(number) for number in range(ROUNDS)) * 1e3:.1f} ms, one axis")


if __name__ == "__main__":
    main()
