"""A sensor on an axis: which sample is read at, between and before its ticks."""

from __future__ import annotations

import pytest

from motionlang.kernel.controller.io.sensor import Sensor, next_tick
from tests.kernel.controller.machines import machine, until


@pytest.mark.parametrize(
    ("time", "tick"),
    [(0.25, 0.25), (0.2504, 0.25), (0.2509, 0.25), (0.251, 0.251), (0.375, 0.375), (0.5, 0.5)],
)
def test_a_reading_is_that_of_the_last_tick(time: float, tick: float) -> None:
    """Ticks are 1 ms apart, and a reading at a tick is that of this tick.

    The sensor reads 3 plus 2 per count beyond 1. The axis jogs at 10 counts/s, after a ramp of 0.1 s
    over 0.5 counts: at time t it is at 10 t - 0.5.
    """
    c = machine(1)
    c.analogue_inputs.compute()
    Sensor(c, 0, 1.0, 3.0, 2.0, 2).switch(True)
    c.jog(0, 10.0)
    until(c, time)
    assert c.analogue_inputs[2] == pytest.approx(3.0 + 2.0 * (10.0 * tick - 0.5 - 1.0), abs=1e-9)


def test_before_its_first_tick_the_sample_of_the_begin_is_read() -> None:
    """The jog begins between two ticks, at 0 counts: it reads 3 + 2 · (0 - 1) = 1.

    It begins at 0.2501 s, so at the first tick, at 0.251 s, the axis is at 50 · 0.0009² counts.
    """
    c = machine(1)
    c.analogue_inputs.compute()
    Sensor(c, 0, 1.0, 3.0, 2.0, 2).switch(True)
    until(c, 0.2501).jog(0, 10.0)
    assert until(c, 0.2509).analogue_inputs[2] == 1.0
    assert until(c, 0.2511).analogue_inputs[2] == pytest.approx(1.0 + 2.0 * 50.0 * 0.0009**2, abs=1e-12)


@pytest.mark.parametrize(("time", "tick"), [(0.0, 0.001), (0.25, 0.251), (0.2501, 0.251), (0.2509, 0.251)])
def test_the_next_tick_is_behind_the_time(time: float, tick: float) -> None:
    assert next_tick(time) == pytest.approx(tick)


def test_a_level_is_passed_at_the_first_tick_beyond_it() -> None:
    """At 0.25 s the axis is at 2 counts, so the sensor reads 3 + 2 · (2 - 1) = 5.

    It reads 5.03 at 2.015 counts, at 0.2515 s, so the next tick is at 0.252 s. Without a level it is at 0.251 s.
    """
    c = machine(1)
    c.analogue_inputs.compute()
    sensor = Sensor(c, 0, 1.0, 3.0, 2.0, 2)
    sensor.switch(True)
    c.jog(0, 10.0)
    until(c, 0.25)
    assert sensor.until(lambda value: value, 5.03) == pytest.approx(0.252)
    assert sensor.until(lambda value: value, None) == pytest.approx(0.251)
