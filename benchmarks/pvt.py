"""Speed of fitting, encoding and streaming PVT moves, relative to virtual time.

Prints `name value unit`. Every figure is the best of a few rounds in one process.
"""

from __future__ import annotations

import gc
import math
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np

from motionlang.copley import packet, serial
from motionlang.copley.bus import LockstepBus
from motionlang.copley.drive import Drive
from motionlang.copley.master import Master
from motionlang.copley.point import to_wire
from motionlang.planners import Profile, plan_sinusoidal
from motionlang.planners.pvt.fit import fit_track
from motionlang.planners.pvt.points import points_from
from motionlang.planners.pvt.velocities import smooth_velocities

if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.copley.point import WirePoint

POINTS = 10_000


def best(rounds: int, job: Callable[[], object]) -> float:
    """Return the best time of a job, s, of `rounds`."""
    times = []
    for _ in range(rounds):
        begin = perf_counter()
        job()
        times.append(perf_counter() - begin)
    return min(times)


def history(seconds: float) -> tuple[list[float], list[Profile], float]:
    """Return sinusoidal moves in sequence for about `seconds`, and their end time."""
    draw = np.random.default_rng(3)
    starts, profiles, time, position = list[float](), list[Profile](), 0.0, 0.0
    while time < seconds:
        move = plan_sinusoidal(position, float(draw.uniform(-20_000, 20_000)), 4e4, 1e5, 1e5)
        starts.append(time)
        profiles.append(move)
        time, position = time + move.duration, move.end
    return starts, profiles, time


def winding() -> tuple[list[float], list[WirePoint]]:
    """Return the positions and points of a move of `POINTS` points, 2 ms apart."""
    positions = [float(round(20_000 * math.sin(0.01 * i) * math.cos(0.0013 * i))) for i in range(POINTS)]
    return positions, to_wire(points_from(positions, smooth_velocities(positions, 0.002), 0.002))


def stream(points: list[WirePoint]) -> float:
    """Stream to a simulated drive over the virtual bus; return the virtual time."""
    drive = Drive()
    with LockstepBus(drive) as bus:
        Master(bus).stream(points)
    return drive.now


def main() -> None:
    """Measure and print."""
    starts, profiles, end = history(60.0)
    positions, points = winding()
    gc.disable()
    for tolerance in (0.6, 2.0, 20.0):
        count = len(fit_track(starts, profiles, tolerance, 0.0, end).points) - 1
        seconds = best(3, lambda t=tolerance: fit_track(starts, profiles, t, 0.0, end))  # type: ignore[misc]
        print(f"fit, tolerance {tolerance:g} {end / seconds:.0f} x real time ({count} segments)")
    print(f"exact velocities {POINTS / best(5, lambda: smooth_velocities(positions, 0.002)):.0f} points/s")
    print(f"0x2010 packets {POINTS / best(5, lambda: packet.encode_points(points)):.0f} points/s")
    print(f"0x115 words {POINTS / best(5, lambda: list(map(serial.encode_point, points))):.0f} points/s")
    seconds = best(3, lambda: stream(points))
    print(f"stream over CANopen {POINTS / seconds:.0f} points/s")
    print(f"stream over CANopen {stream(points) / seconds:.0f} x real time")


if __name__ == "__main__":
    main()
