"""What planning one move costs, beside ruckig called from Python in the same rounds.

Prints `name value unit`. Every figure is the best of many interleaved rounds with the collector off.
"""

from __future__ import annotations

import gc
from time import perf_counter
from typing import TYPE_CHECKING, Any

from motionlang.profile import plan_jerk, plan_parabolic, plan_ratio, plan_sinusoidal, plan_trapezoid

if TYPE_CHECKING:
    from collections.abc import Callable

CALLS = 2000
ROUNDS = 60


def ruckig_call() -> Callable[[float, float], object] | None:
    """`calculate` for one axis with the target set on each call, or None without ruckig."""
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
    """Each planner as a function of start and target."""
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


def main() -> None:
    """Measure and print."""
    work = jobs()
    times = dict.fromkeys(work, float("inf"))
    gc.disable()
    for _ in range(ROUNDS):
        for name, job in work.items():
            begin = perf_counter()
            for _ in range(CALLS):
                job(0.0, 100.0)
            times[name] = min(times[name], (perf_counter() - begin) / CALLS)
    for name, seconds in times.items():
        print(f"plan.{name} {seconds * 1e9:.0f} ns")
        if "ruckig" in times and name != "ruckig":
            print(f"plan.{name}_over_ruckig {seconds / times['ruckig']:.2f} x")


if __name__ == "__main__":
    main()
