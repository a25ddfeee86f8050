"""Random motion as figures, to compare a change of the kernel with an earlier commit.

    python -m tests.kernel.controller.motions 3000 --commit HEAD

`motions.txt` has the figures of the first draws, as commit 985e2d07 played them but for intended changes. A test
compares them within `TOLERANCE`: another order of the same sums changes last bits. A draw is one run of random
operations on four axes; every third has a generated program, too.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator
from itertools import zip_longest
from math import isclose
from pathlib import Path
from random import Random
from typing import Any

from motionlang.kernel import Controller, Rejected, Source, run
from motionlang.kernel.log.move import LoggedMove
from tests.commits import unpacked
from tests.generated.motion import generate
from tests.kernel.controller.machines import cam, machine, offset, until

ROOT = Path(__file__).parents[3]
RECORDED = Path(__file__).with_name("motions.txt")
AXES = 4
TABLE = ([0.0, 3.0, 7.0, 9.0], [0.0, 4.0, -2.0, 1.0])
SHAPES = ("trapezoid", "sinusoidal", "scurve", "parabolic")
# Relative and absolute difference of two figures that count as the same.
TOLERANCE = 1e-9
# One draw in this many has a program.
PROGRAM = 3
# Positions of an axis, at times that are no knots.
SAMPLES = 6

Step = tuple[Any, ...]


def steps_of(r: Random, most: int, axes: int = 3, least: int = 2) -> list[Step]:
    """Return random verbs with their arguments; the seed defines the complete case."""

    def axis() -> int:
        return r.randrange(axes)

    def distance() -> float:
        return r.choice([0.0, 1.0, -1.0, r.uniform(-20.0, 20.0), r.uniform(-20.0, 20.0)])

    makers: list[Callable[[], Step]] = [
        *[lambda: ("wait", r.randrange(97) / 64.0)] * 5,
        *[lambda: ("go", list(range(axes)))] * 3,
        *[
            lambda: (
                r.choice(["load_by", "load_to", "move_to", "move_by", "retarget_to", "offset"]),
                axis(),
                distance(),
            )
        ]
        * 2,
        lambda: ("jog", axis(), r.uniform(-15.0, 15.0)),
        lambda: (
            "load_line_by",
            r.choice([[0, 1], [1, 0], [1, 2], [0, 1, 2]]),
            [distance(), distance(), distance()],
        ),
        lambda: (
            "load_arc",
            [0, 1],
            (distance(), distance()),
            r.choice([90.0, 360.0, distance() * 25.0]),
            (),
            r.random() < 0.5,
        ),
        lambda: ("load_dwell", axis(), r.randrange(50) / 64.0),
        lambda: ("load_fly", axis(), axis(), distance(), r.uniform(1.0, 9.0)),
        lambda: (r.choice(["stop", "suspend", "resume", "abort", "disable", "enable"]), axis()),
        lambda: ("gear", axis(), axis(), r.uniform(-2.0, 2.0), r.random() < 0.5),
        lambda: ("cam", axis(), axis(), r.random() < 0.5),
        lambda: ("configure", axis(), r.choice(["speed", "accel", "decel"]), r.uniform(1.0, 200.0)),
        lambda: ("configure", axis(), "override", r.choice([0.0, 0.5, 1.0, 2.0])),
        lambda: ("configure", axis(), "feedrate_mode", r.randrange(4)),
        lambda: ("configure", axis(), "contour_mode", r.random() < 0.5),
    ]
    if axes > 3:  # also what the property of all verbs does not draw: a follower's own changes, and points
        makers += [
            lambda: ("load_points", axis(), [distance(), distance()], r.uniform(0.2, 1.0)),
            lambda: ("gear", axis(), axis(), r.uniform(-2.0, 2.0), True),
            lambda: ("offset", axis(), distance(), r.choice([0, 1]), r.uniform(1.0, 9.0)),
            lambda: ("set_ratio", axis(), r.uniform(-2.0, 2.0)),
            lambda: (r.choice(["leave_master", "come_to_rest", "suspend", "resume", "stop"]), axis()),
            lambda: ("drive_encoder", 0, r.uniform(-9.0, 9.0), r.choice([0.0, 20.0])),
            lambda: ("gear", axis(), 0, r.uniform(-2.0, 2.0), r.random() < 0.5, True),
            lambda: ("configure", axis(), "shape", r.choice(SHAPES)),
            lambda: ("configure", axis(), r.choice(["accel_jerk", "decel_jerk"]), r.uniform(50.0, 2000.0)),
            lambda: ("configure", axis(), "suspend_time", r.choice([0.0, 0.3])),
            lambda: ("read", axis(), distance(), r.uniform(-9.0, 9.0)),
        ]
    return [r.choice(makers)() for _ in range(r.randrange(least, most))]


def perform(c: Controller, step: tuple[Any, ...]) -> None:
    verb, *rest = step
    if verb == "wait":
        run_on(c, c.clock.now + rest[0])
    elif verb == "cam":
        slave, master, cyclic = rest
        cam(c, slave, master, *TABLE, cyclic=cyclic)
    elif verb == "offset":
        offset(c, *rest)
    elif verb == "load_line_by":
        c.load_line_by(rest[0], rest[1][: len(rest[0])])
    elif verb == "load_points":
        axis, (first, last), time = rest
        c.load_points(axis, lambda s: ([s, s + first, s + last], [0.0, 3.0, 0.0], [time, time]))
    else:
        getattr(c, verb)(*rest)


def run_on(c: Controller, time: float) -> None:
    """Advance the controller to `time`; a motion that an event rejects just ends."""
    while c.clock.now < time:
        try:
            until(c, time)
        except Rejected:
            pass


def operations(seed: int) -> Iterator[str]:
    """Yield the figures of random operations: what was rejected and read, moves with their ends, positions."""
    r = Random(seed)
    c = machine(AXES, buffer_size=6, shape=r.choice(SHAPES), contour_angle=60.0)
    told: list[object] = []
    for step in steps_of(r, 70, AXES, 30):
        try:
            told += [_read(c, *step[1:])] if step[0] == "read" else []
            if step[0] != "read":
                perform(c, step)
        except Rejected as rejected:
            told.append(rejected.code)
    run_on(c, c.clock.now + 3.0)
    yield _line(f"operations-{seed}", told)
    yield from _motion(c)


def _read(c: Controller, axis: int, position: float, velocity: float) -> str:
    """Return the times at which an axis is at a position, at a velocity and at rest, and its distance left."""
    times = c.crossing_time(axis, position), c.velocity_crossing_time(axis, velocity), c.idle_time(axis)
    return _figures((*times, c.remaining(axis), c.velocity(axis)))


def program(seed: int) -> Iterator[str]:
    """Yield the figures of a generated program, which prints its positions after each pause."""
    made = generate(seed)
    text = re.sub(r"^(Wait .*)$", r"\1\nPrint POS(0), VEL(1), POS(2)", made.text, flags=re.M)
    text = re.sub(r"^(WA.*)$", r"\1,1TP,2TP,3TP", text, flags=re.M)
    result = run(Source(made.name, text), machine=made.machine, until=3.0)
    yield _line(f"program-{seed}", [each.text.strip() for each in result.machine.log.prints])
    yield from _motion(result.controller)


def _motion(c: Controller) -> Iterator[str]:
    """Yield the positions of each axis that moved, and start, duration, end, peak speed and outcome of its moves."""
    for number, a in sorted(c.axes.items()):
        moves = [move for move in c.log.moves if move.axis == number and move.profile is not None]
        if moves:
            positions = [a.position(c.clock.now * (k - 0.4142) / SAMPLES) for k in range(1, SAMPLES + 1)]
            yield _line(f" {number}", [len(moves), _figures(positions), *map(_told, moves[-2:])])


def _told(move: LoggedMove) -> str:
    profile = move.profile
    assert profile is not None
    values = move.start_time, profile.duration, profile.end, profile.peak_speed
    return f"{move.ended or 'complete'} {_figures(values)}"


def _figures(values: Iterable[float]) -> str:
    return " ".join(f"{value:.12g}" for value in values)


def _line(name: str, words: Iterable[object]) -> str:
    return " ".join([name, *map(str, words)])


def differences(now: Iterable[str], before: Iterable[str]) -> Iterator[str]:
    """Yield each line that differs, and what it was."""
    draw = ""
    for here, there in zip_longest(now, before, fillvalue=""):
        draw = here.split()[0] if here[:1].isalpha() else draw
        words = zip_longest(here.split(), there.split(), fillvalue="")
        if not all(_same(*pair) for pair in words):
            yield f"{draw}:\n  {here}\n  {there}"


def _same(here: str, there: str) -> bool:
    try:
        return here == there or isclose(float(here), float(there), rel_tol=TOLERANCE, abs_tol=TOLERANCE)
    except ValueError:
        return False


def lines(seeds: Iterable[int]) -> Iterator[str]:
    """Yield the figures of draws."""
    for seed in seeds:
        yield from operations(seed)
        if seed % PROGRAM == 0:
            yield from program(seed)


def main(arguments: list[str]) -> int:
    """Compare the motion of this tree with that of a commit, or print it."""
    parser = argparse.ArgumentParser(prog="tests.kernel.controller.motions")
    parser.add_argument("count", type=int)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--commit", help="compare with the package of this commit")
    given = parser.parse_args(arguments)
    now = lines(range(given.first, given.first + given.count))
    if given.commit is None:
        print(*now, sep="\n")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        unpacked(given.commit, Path(folder), "motionlang", "grammars")
        again = [
            sys.executable,
            "-m",
            "tests.kernel.controller.motions",
            str(given.count),
            "--first",
            str(given.first),
        ]
        paths = {**os.environ, "PYTHONPATH": os.pathsep.join((folder, str(ROOT)))}
        before = subprocess.run(
            again, check=True, cwd=folder, env=paths, capture_output=True, text=True
        ).stdout
    found = list(differences(now, before.splitlines()))
    print(*found, f"{len(found)} lines differ", sep="\n")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
