"""The cost of planning one move, compared with ruckig called from Python.

It prints `name value unit`. Every figure is the best of many interleaved rounds with the collector off.
"""

from __future__ import annotations

import gc
from random import Random
from time import process_time
from typing import TYPE_CHECKING, Any

from motionlang.planners import plan_jerk, plan_parabolic, plan_ratio, plan_sinusoidal, plan_trapezoid

if TYPE_CHECKING:
    from collections.abc import Callable

CALLS = 2000
ROUNDS = 60
# Random states for a speed of 100, a rate of 500 and a jerk of 5000.
STATES = 2000
SPEED, RATE, JERK = 100.0, 500.0, 5000.0


def ruckig_call() -> Callable[[float, float], object] | None:
    """Return ruckig's `calculate` for one axis, or None if ruckig is not installed.

    The target is set on each call.
    """
    try:
        import ruckig  # type: ignore[import-not-found, import-untyped, unused-ignore]
    except ImportError:
        return None
    generator, ask, answer = ruckig.Ruckig(1), ruckig.InputParameter(1), ruckig.Trajectory(1)
    ask.max_velocity, ask.max_acceleration, ask.max_jerk = [100.0], [500.0], [5000.0]
    calculate: Any = generator.calculate

    def call(_: float, target: float) -> object:
        ask.target_position = [target]
        return calculate(ask, answer)

    return call


def jobs() -> dict[str, Callable[[float, float], object]]:
    """Return each planner as a function of start and target."""
    made: dict[str, Callable[[float, float], object]] = {
        "trapezoid": lambda start, target: plan_trapezoid(start, target, 100.0, 500.0, 500.0),
        "scurve": lambda start, target: plan_jerk(start, target, 100.0, 500.0, 500.0, 5000.0, 5000.0),
        "sinusoidal": lambda start, target: plan_sinusoidal(start, target, 100.0, 500.0, 500.0),
        "ratio": lambda start, target: plan_ratio(start, target, 100.0, 500.0, 500.0, 0.1),
        "parabolic": lambda start, target: plan_parabolic(start, target, 100.0, 500.0, 500.0),
        "moving_trapezoid": lambda start, target: plan_trapezoid(start, target, 100.0, 500.0, 500.0, 20.0),
        "moving_scurve": lambda start, target: plan_jerk(
            start, target, 100.0, 500.0, 500.0, 5000.0, 5000.0, 20.0
        ),
        "bent_scurve": lambda start, target: plan_jerk(
            start, target, 100.0, 500.0, 500.0, 5000.0, 5000.0, 20.0, 200.0
        ),
    }
    made["short_scurve"] = lambda start, _: plan_jerk(start, 10.0, 100.0, 500.0, 500.0, 5000.0, 5000.0)
    made["trapezoid_expanded"] = lambda start, target: (
        plan_trapezoid(start, target, 100.0, 500.0, 500.0).pieces
    )
    reference = ruckig_call()
    return {"ruckig": reference, **made} if reference else made


def states(velocities: float, accelerations: float) -> list[tuple[float, float, float]]:
    """Return random states (velocity, acceleration, target) within the limits.

    Velocities and accelerations have either sign and are up to a fraction of the limits. While the acceleration
    is reduced to zero, the velocity does not exceed the speed.
    """
    choose, found = Random(1), list[tuple[float, float, float]]()
    while len(found) < STATES:
        v0 = choose.uniform(-SPEED, SPEED) * velocities
        a0 = choose.uniform(-RATE, RATE) * accelerations
        target = choose.uniform(-SPEED, SPEED)
        if abs(v0 + 0.5 * a0 * abs(a0) / JERK) <= SPEED:
            found.append((v0, a0, target))
    return found


def own_states(some: list[tuple[float, float, float]]) -> Callable[[], object]:
    """Return a job that plans an S-curve from each state."""

    def call() -> None:
        for v0, a0, target in some:
            plan_jerk(0.0, target, SPEED, RATE, RATE, JERK, JERK, v0, a0)

    return call


def ruckig_states(some: list[tuple[float, float, float]]) -> Callable[[], object] | None:
    """Return a job in which ruckig plans from each state; None if not installed."""
    try:
        import ruckig  # type: ignore[import-not-found, import-untyped, unused-ignore]
    except ImportError:
        return None
    generator, answer, questions = ruckig.Ruckig(1), ruckig.Trajectory(1), []
    for v0, a0, target in some:
        ask = ruckig.InputParameter(1)
        ask.max_velocity, ask.max_acceleration, ask.max_jerk = [SPEED], [RATE], [JERK]
        ask.current_velocity, ask.current_acceleration, ask.target_position = [v0], [a0], [target]
        questions.append(ask)
    calculate: Any = generator.calculate

    def call() -> None:
        for ask in questions:
            calculate(ask, answer)

    return call


def random_states() -> None:
    """Measure S-curves from rest, from velocity, and from velocity and acceleration.

    They are compared with each other and with ruckig.
    """
    kinds = {"rest": states(0.0, 0.0), "velocity": states(1.0, 0.0), "acceleration": states(1.0, 1.0)}
    work: dict[str, Callable[[], object]] = {name: own_states(some) for name, some in kinds.items()}
    for name, some in kinds.items():
        peer = ruckig_states(some)
        if peer is not None:
            work[f"{name} ruckig"] = peer
    times = dict.fromkeys(work, float("inf"))
    for _ in range(ROUNDS // 3):
        for name, job in work.items():
            begin = process_time()
            job()
            times[name] = min(times[name], (process_time() - begin) / STATES)
    for name in kinds:
        print(f"plan.from_{name} {times[name] * 1e9:.0f} ns")
        if name != "rest":
            print(f"plan.from_{name}_over_rest {times[name] / times['rest']:.2f} x")
        if f"{name} ruckig" in times:
            print(f"plan.from_{name}_over_ruckig {times[name] / times[f'{name} ruckig']:.2f} x")


def main() -> None:
    """Measure and print."""
    work = jobs()
    times = dict.fromkeys(work, float("inf"))
    gc.disable()
    for _ in range(ROUNDS):
        for name, job in work.items():
            begin = process_time()
            for _ in range(CALLS):
                job(0.0, 100.0)
            times[name] = min(times[name], (process_time() - begin) / CALLS)
    for name, seconds in times.items():
        print(f"plan.{name} {seconds * 1e9:.0f} ns")
        if "ruckig" in times and name != "ruckig":
            print(f"plan.{name}_over_ruckig {seconds / times['ruckig']:.2f} x")
    random_states()


if __name__ == "__main__":
    main()
