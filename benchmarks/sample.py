"""The cost of sampling a long profile and 2000 short moves, in units of np.fill.

Prints `name value unit`. Every figure is the best of many interleaved rounds in one process.
"""

from __future__ import annotations

import gc
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np

from motionlang.planners import Profile, plan_jerk, plan_sinusoidal
from motionlang.planners.sample import PieceTable

if TYPE_CHECKING:
    from collections.abc import Callable

POINTS = 1_000_000


def history() -> tuple[list[float], list[Profile]]:
    """Return 2000 jerk-limited moves of about half a second, in sequence."""
    lengths = np.random.default_rng(3).uniform(5.0, 40.0, 2000)
    starts, profiles, time, position = [], [], 0.0, 0.0
    for length in lengths:
        move = plan_jerk(position, position + float(length), 100.0, 500.0, 500.0, 5000.0, 5000.0)
        starts.append(time)
        profiles.append(move)
        time, position = time + move.duration, move.end
    return starts, profiles


def best(rounds: int, jobs: dict[str, Callable[[], object]]) -> dict[str, float]:
    """Return the best time of each job in seconds; the jobs alternate for `rounds`."""
    times = dict.fromkeys(jobs, float("inf"))
    for _ in range(rounds):
        for name, job in jobs.items():
            begin = perf_counter()
            job()
            times[name] = min(times[name], perf_counter() - begin)
    return times


def main() -> None:
    """Measure and print."""
    scurve = plan_jerk(0.0, 1000.0, 100.0, 500.0, 500.0, 5000.0, 5000.0)
    sine = plan_sinusoidal(0.0, 1000.0, 100.0, 50.0, 50.0)
    starts, profiles = history()
    table = PieceTable(starts, profiles)
    out = np.zeros(POINTS)
    dt_long, dt = scurve.duration / POINTS, (starts[-1] + profiles[-1].duration) / POINTS
    gc.disable()
    times = best(
        40,
        {
            "fill": lambda: out.fill(1.0),
            "one profile": lambda: PieceTable((0.0,), (scurve,)).sample(0.0, dt_long, POINTS, 0, out),
            "one sine profile": lambda: PieceTable((0.0,), (sine,)).sample(
                0.0, sine.duration / POINTS, POINTS, 0, out
            ),
            "2000 moves": lambda: table.sample(0.0, dt, POINTS, 0, out),
            "table of 2000 moves": lambda: PieceTable(starts, profiles),
        },
    )
    print(f"sample.pieces {len(table.begins)} pieces")
    for name, seconds in times.items():
        print(f"sample.{name.replace(' ', '_')} {seconds / POINTS * 1e9:.3f} ns/point")
        print(f"sample.{name.replace(' ', '_')}_over_fill {seconds / times['fill']:.2f} x")


if __name__ == "__main__":
    main()
