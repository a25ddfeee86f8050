"""Solving only the watches next to the axis gives the calls of solving all.

The calls have the same times and order.
"""

from __future__ import annotations

import random

import pytest

from motionlang.kernel.controller import triggers
from motionlang.kernel.controller.controller import Controller
from motionlang.kernel.controller.faults import Rejected
from motionlang.kernel.controller.triggers.watch import arm
from tests.cases import examples

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis
    from motionlang.kernel.controller.clock import Clock
    from motionlang.kernel.controller.triggers.watch import Watch


def solve_all(axis: Axis, clock: Clock) -> None:
    """Solve every watch for every new profile, in order of creation."""
    for watch in tuple(axis.watches):
        if watch in axis.watches:
            arm(axis, watch, clock, clock.now)


class Story:
    """A random case of an axis whose watches end, set others, and move the axis."""

    def __init__(self, seed: int) -> None:
        self.draw = random.Random(seed)
        self.c = Controller(2)
        self.watches: list[tuple[int, Watch]] = []
        self.log: list[object] = []
        self.names = 0
        # The probability of an action in a call: low, so that cases end.
        self.meddling = self.draw.choice((0.0, 0.1, 0.3))
        size = self.draw.choice((1.0, 1.0, 1e3, 1e6))
        self.grid = [size * k * 0.5 for k in range(-30, 31)]
        for name, value in (("speed", 8.0), ("accel", 16.0), ("decel", 16.0)):
            self.c.configure(0, name, size * value)
        self.c.clock.advance(self.draw.choice((0.0, 0.0, 86400.123456789, 30 * 86400.123456789)))

    def random_position(self) -> float:
        near = self.draw.choice((0.0, 0.0, 0.0, 1e-12, -1e-12, 5e-7, -2e-6, 3e-5, 1e-3, 0.1, 0.25))
        return self.draw.choice(self.grid) + near

    def set(self) -> None:
        if len(self.watches) > 60:
            return
        name, self.names = self.names, self.names + 1
        made = self.c.watch(
            0, self.random_position(), lambda d: self.passed(name, d), self.draw.random() < 0.5
        )
        self.watches.append((name, made))

    def end(self) -> None:
        if self.watches:
            _, watch = self.watches.pop(self.draw.randrange(len(self.watches)))
            self.c.unwatch(0, watch)

    def passed(self, name: int, direction: int) -> None:
        self.note("watch", name, direction)
        if len(self.log) < 3000 and self.draw.random() < self.meddling:
            self.act()

    def note(self, *what: object) -> None:
        sides = [watch.side for _, watch in self.watches]
        self.log.append((*what, self.c.clock.now, self.c.position(0), sides))

    def act(self) -> None:
        c, draw = self.c, self.draw
        kind = draw.choice(
            ("move", "move", "jog", "stop", "zero", "set", "set", "end", "load", "shape", "other")
        )
        try:
            if kind == "move":
                c.move_to(
                    0,
                    draw.choice(
                        (draw.choice(self.grid), self.random_position(), draw.gauss(0.0, self.grid[-1]))
                    ),
                )
            elif kind == "jog":
                c.jog(0, draw.choice((-0.5, -0.1, 0.1, 0.5)) * self.grid[-1])
            elif kind == "stop":
                c.stop(0)
            elif kind == "zero":
                c.define_position(0, draw.choice((0.0, self.random_position())))
            elif kind == "set":
                self.set()
            elif kind == "end":
                self.end()
            elif kind == "load":
                c.load_to(0, draw.choice(self.grid))
                c.load_by(0, draw.choice(self.grid))
                c.go((0,))
            elif kind == "shape":
                c.configure(
                    0, "shape", draw.choice(("trapezoid", "trapezoid", "scurve", "sinusoidal", "parabolic"))
                )
            else:  # another event at the time of a watch, entered between others
                times = [
                    w.event.time for _, w in self.watches if w.event is not None and w.event.call is not None
                ]
                if times:
                    c.clock.at(min(times), lambda: self.note("other"))
        except Rejected as rejected:
            self.log.append(rejected.args)

    def play(self) -> list[object]:
        for _ in range(self.draw.choice((2, 10, 50))):
            self.set()
        for _ in range(40):
            made = self.c.clock.made
            self.act()
            self.note("time", self.c.clock.next_time(), made == self.c.clock.made)
            span = self.draw.choice((0.0, 0.01, 0.3, 1.0, 5.0))
            until = self.c.clock.now + span
            if self.draw.random() < 0.2:  # to the exact time of the next event
                until = min(until, self.c.clock.next_time())
            self.c.clock.advance(until)
            self.note("then")
        return self.log


def compare(seeds: range, monkeypatch: pytest.MonkeyPatch) -> int:
    """Run each case with both methods; return how often watches were passed."""
    passes = 0
    for seed in seeds:
        ours = Story(seed).play()
        with monkeypatch.context() as patch:
            patch.setattr(triggers.next_watches, "follow", solve_all)
            plain = Story(seed).play()
        for k, (one, other) in enumerate(zip(ours, plain, strict=False)):
            assert one == other, f"story {seed}, line {k}"
        assert len(ours) == len(plain), f"story {seed}"
        passes += sum(line[0] == "watch" for line in ours if isinstance(line, tuple))
    return passes


def test_notifications_are_those_of_solving_all(monkeypatch: pytest.MonkeyPatch) -> None:
    stories = examples(25)
    assert compare(range(stories), monkeypatch) > 20 * stories


@pytest.mark.long
def test_notifications_are_those_of_solving_all_in_many_stories(monkeypatch: pytest.MonkeyPatch) -> None:
    assert compare(range(1000, 3000), monkeypatch) > 50_000
