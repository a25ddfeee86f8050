"""Random jobs of several axes compared with the reference axis.

They have stops, limits, new zeros, suspends and overrides. `MOTIONLANG_LONG=100000` runs 100 000 of them.
"""

from __future__ import annotations

import os
from math import hypot
from random import Random

import pytest

from motionlang.kernel import Controller, Machine
from motionlang.kernel.controller.faults import SOFT_LIMIT_FORWARD, SOFT_LIMIT_REVERSE
from motionlang.kernel.controller.triggers.limit import Limit
from tests.reference_model.axis import Axis
from tests.reference_model.axis import Limit as Reference

COUNT = int(os.environ.get("MOTIONLANG_LONG", "400"))
AXES = (0, 1)
SLAVE = 2
ACTIONS = ("ignore", "abort", "error-stop", "event")


class Job:
    """The package and the reference, with the same commands at the same times."""

    def __init__(self, seed: int) -> None:
        self.choose = choose = Random(seed)
        self.c: Controller = Machine({}).controller
        self.axes: dict[int, Axis] = {}
        self.limits: dict[tuple[int, int], Limit] = {}
        self.log: list[str] = []
        for number in AXES:
            figures = [
                round(choose.uniform(low, high), 2)
                for low, high in ((5, 90), (20, 400), (20, 400), (50, 900))
            ]
            for name, value in zip(("speed", "accel", "decel", "error_decel"), figures, strict=True):
                self.c.configure(number, name, value)
            self.c.configure(number, "buffer_size", 50)
            self.c.configure(number, "feedrate_mode", 2)
            self.axes[number] = Axis(*figures)
            for which, (sign, bit) in enumerate(((1, SOFT_LIMIT_FORWARD), (-1, SOFT_LIMIT_REVERSE))):
                self.limits[number, which] = self.c.add_limit(number, sign, bit, "abort")
        self.ratio = round(choose.uniform(-2, 2), 2)
        self.c.gear(SLAVE, 0, self.ratio)
        self.geared = 0.0

    def run(self) -> None:
        time = 0.0
        for _ in range(self.choose.randrange(4, 25)):
            time += self.choose.uniform(0.0, 1.2)
            self.advance(time)
            self.command(self.choose.choice(AXES), time)
        for number in AXES:
            self.record(time, number, "stop")
            self.c.stop(number)
            self.axes[number].stop()
        self.advance(time + 60.0)
        for number, axis in self.axes.items():
            assert self.c.is_idle(number) is (axis.doing == "idle"), "\n".join(self.log)

    def advance(self, time: float) -> None:
        """Advance both to a time, and compare them in between and at the end."""
        now = self.c.clock.now
        for share in (0.31, 0.77, 1.0):
            then = now + share * (time - now)
            self.c.clock.advance(then)
            for number, axis in self.axes.items():
                before = axis.position
                axis.run(then)
                self.geared += self.ratio * (axis.position - before) if number == 0 else 0.0
                self.compare(number, axis, then)
            slave = self.c.axes[SLAVE].position(then)
            assert abs(slave - self.geared) <= 2e-4, (
                f"the slave: {slave} for {self.geared} at {then}\n" + "\n".join(self.log)
            )

    def compare(self, number: int, axis: Axis, time: float) -> None:
        a = self.c.axes[number]
        ours, theirs = (a.position(time), a.velocity(time)), (axis.position, axis.velocity)
        gaps = abs(ours[0] - theirs[0]), abs(ours[1] - theirs[1])
        log = "\n".join(self.log)
        near = gaps[0] <= 1e-4 and gaps[1] <= 1e-3  # 1e-14 before a target takes 3e-8 s, or none
        assert near, f"axis {number} at {time!r}: {ours} for {theirs}, {axis.doing}\n{log}"
        assert bool(self.c.faults(number)) is axis.fault, (
            f"axis {number} at {time!r}: {self.c.faults(number)}\n{log}"
        )

    def record(self, time: float, number: int, *what: object) -> None:
        self.log.append(f"{time!r} axis {number}: {' '.join(map(str, what))}")

    def command(self, number: int, time: float) -> None:
        """Give one random command to both."""
        choose, c, axis = self.choose, self.c, self.axes[number]
        kind = choose.randrange(15)
        value = round(choose.uniform(-120, 120), 2)
        if kind <= 2 and not axis.endless:
            self.record(time, number, "move by", value)
            c.load_by(number, value)
            axis.load("by", value)
            c.go([number])
            axis.go()
        elif kind <= 4:
            self.record(time, number, "move to", value)
            c.load_to(number, value)
            axis.load("to", value)
            c.go([number])
            axis.go()
        elif kind <= 6:
            value = round(choose.choice((-1, 1)) * choose.uniform(2, 90), 2)
            self.record(time, number, "jog", value)
            c.jog(number, value)
            axis.jog(value)
        elif kind == 7:
            self.record(time, number, "stop")
            c.stop(number)
            axis.stop()
        elif kind == 8:
            self.record(time, number, "cancel")
            c.abort(number)
            axis.cancel()
        elif kind <= 10:
            on = not axis.suspended
            self.record(time, number, "suspend", on)
            (c.suspend if on else c.resume)(number)
            axis.suspend(on)
        elif kind == 11:
            value = choose.choice((0.0, 0.3, 0.8, 1.0, 1.5))
            self.record(time, number, "override", value)
            c.configure(number, "override", value)
            axis.set_override(value)
        elif kind == 12:
            value = round(choose.uniform(5, 90), 2)
            self.record(time, number, "speed", value)
            c.configure(number, "speed", value)
            axis.set_speed(value)
        elif kind == 13:
            self.limit(number, axis, time)
        elif axis.doing == "move" and not axis.queue and choose.random() < 0.5:
            self.record(time, number, "retarget", value)
            c.retarget_to(number, value)
            axis.retarget(value)
        elif number != 0:  # a slave does not depend on its master's numbers
            self.record(time, number, "position", value)
            c.define_position(number, value)
            axis.rename(value)

    def limit(self, number: int, axis: Axis, time: float) -> None:
        which, action = self.choose.randrange(2), self.choose.choice(ACTIONS)
        limit = self.limits[number, which]
        near = axis.position + self.choose.uniform(-15, 40) * (1 if which == 0 else -1)
        position = None if self.choose.random() < 0.2 else round(near, 3)
        self.record(time, number, "limit", which, action, position)
        limit.set_position(None)
        limit.action = action
        limit.set_position(position)
        axis.set_limit(which, position, action)


class PathJob:
    """A straight path of two axes, and one reference axis along it with both limits."""

    def __init__(self, seed: int) -> None:
        self.choose = choose = Random(seed)
        self.c: Controller = Machine({}).controller
        figures = [choose.uniform(low, high) for low, high in ((5, 90), (20, 400), (20, 400), (50, 900))]
        for number in AXES:
            for name, value in zip(("speed", "accel", "decel", "error_decel"), figures, strict=True):
                # The path uses its first axis: the other one has figures of its own.
                self.c.configure(number, name, value if number == 0 else choose.uniform(10, 900))
            self.c.configure(number, "feedrate_mode", 2)
        self.ends = [choose.uniform(-80, 80) for _ in AXES]
        self.length = hypot(*self.ends)
        self.along = Axis(*figures)
        self.along.limits, self.along.end = [], self.length
        self.log: list[str] = [f"to {self.ends}"]

    def run(self) -> None:
        c, choose, along = self.c, self.choose, self.along
        c.load_line(AXES, self.ends)
        along.load("to", self.length)
        c.go([0])
        along.go()
        time = 0.0
        for _ in range(choose.randrange(1, 12)):
            time += choose.uniform(0.0, 0.6)
            self.advance(time)
            if along.doing == "idle":
                return
            self.command(choose.choice(AXES), time)
        if along.suspended:
            c.resume(0)
            along.suspend(False)
        self.log.append(f"{time!r} override 1")
        c.configure(0, "override", 1.0)
        along.set_override(1.0)
        self.advance(time + 60.0)
        assert c.is_idle(0), self.log
        assert c.is_idle(1), self.log

    def advance(self, time: float) -> None:
        now = self.c.clock.now
        for share in (0.41, 1.0):
            then = now + share * (time - now)
            self.c.clock.advance(then)
            self.along.run(then)
            for number in AXES:
                position = self.ends[number] / self.length * self.along.position
                done = self.c.axes[number].position(then)
                assert abs(done - position) <= 1e-4, (
                    f"axis {number} at {then!r}: {done} for {position}\n{self.log}"
                )
                fault = any(limit.hit for limit in self.along.limits if limit.number == number)
                assert bool(self.c.faults(number)) is fault, f"axis {number} at {then!r}\n{self.log}"

    def command(self, number: int, time: float) -> None:
        choose, c, along = self.choose, self.c, self.along
        kind = choose.randrange(7)
        self.log.append(f"{time!r} axis {number}: {kind}")
        if kind == 0:
            c.stop(number)
            along.stop()
        elif kind == 1:
            c.abort(number)
            along.cancel()
        elif kind == 2:
            on = not along.suspended
            (c.suspend if on else c.resume)(number)
            along.suspend(on)
        elif kind == 3:
            factor = choose.choice((0.0, 0.4, 1.0, 1.6))
            c.configure(0, "override", factor)
            along.set_override(factor)
        elif kind == 4:
            speed = choose.uniform(5, 90)
            c.configure(0, "speed", speed)
            along.set_speed(speed)
        else:
            self.limit(number, time)

    def limit(self, number: int, time: float) -> None:
        """Set a limit of one axis, ahead of its position or behind it."""
        slope = self.ends[number] / self.length
        sign, action = self.choose.choice((-1, 1)), self.choose.choice(ACTIONS)
        position = self.c.position(number) + sign * self.choose.uniform(-5, 30)
        self.log.append(f"limit {sign} {action} {position}")
        theirs = self.c.add_limit(
            number, sign, SOFT_LIMIT_FORWARD if sign > 0 else SOFT_LIMIT_REVERSE, action
        )
        theirs.set_position(position)
        if sign * slope <= 0.0:
            return  # the axis never reaches it
        ours = Reference(+1, action, number)
        # Of simultaneous limits those of the first axis are checked first.
        self.along.limits = sorted([*self.along.limits, ours], key=lambda each: each.number)
        self.along.set_limit(self.along.limits.index(ours), position / slope, action)


@pytest.mark.parametrize("kind", [Job, PathJob])
def test_random_jobs_do_what_the_reference_axis_does(kind: type[Job | PathJob]) -> None:
    for seed in range(COUNT):
        job = kind(seed)
        try:
            job.run()
        except AssertionError as error:
            raise AssertionError(f"seed {seed}: {error}") from None
