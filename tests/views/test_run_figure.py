"""Figures of runs: panels, curves, shades, labels and events."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import pytest

from motionlang.commands.plot.view import run_figure
from motionlang.kernel import Run, Source, run
from motionlang.kernel.servo import Loop, ServoTrace, make_plant, simulate
from motionlang.views.figure import Figure, Panel
from motionlang.views.window import Window
from tests.views.runs import ballscrew, ended, new_run, pick, shift, switched

RATES = "SPEED(0) = 10 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
NO_SERVOS: Mapping[int, ServoTrace] = MappingProxyType({})


def panels(made: Run, servos: Mapping[int, ServoTrace] = NO_SERVOS, **window: Any) -> list[Panel]:
    return [panel for (panel,) in run_figure(made, servos, Window(**window)).rows]


def names(figure: Figure) -> list[str]:
    return [name for _, name in figure.legend]


def test_the_ballscrew_exercise_says_what_it_shows() -> None:
    """The jerk is left out, because the acceleration changes only in jumps."""
    figure = run_figure(ballscrew())
    assert (figure.title, figure.subtitle) == ("ballscrew.mnt", "Mint · ended after 1.00005 s")
    assert (figure.x_label, names(figure)) == ("time (s)", ["accel", "slew", "decel"])
    made = [panel for (panel,) in figure.rows]
    assert [(panel.label, panel.unit, panel.remark) for panel in made] == [
        ("position", "uu", ""),
        ("velocity", "uu/s", "peak 250 uu/s"),
        ("acceleration", "uu/s²", "peak 1250 uu/s²"),
    ]
    assert [label.texts[0] for label in made[0].labels] == ["MOVER · line 5"]
    assert [panel.has_zero for panel in made] == [False, True, True]
    assert [len(panel.bands) for panel in made] == [3, 3, 3]
    assert made[0].x_limits == pytest.approx((0.0, 1.00005))


def test_every_axis_has_its_panels_and_every_move_its_line() -> None:
    figure = run_figure(pick())
    made = [panel for (panel,) in figure.rows]
    assert [panel.title for panel in made if panel.title] == ["axis 0", "axis 1", "axis 2"]
    assert [label.texts[0] for panel in made for label in panel.labels] == [
        "MOVER · line 5", "MOVEA · line 12", "MOVER · line 6", "JOG · line 14", "MOVER · line 8"]  # fmt: skip
    assert "stop" in names(figure)
    labels = [panel.label for panel in made]
    assert [labels.count(name) for name in ("acceleration", "jerk")] == [3, 2]


def test_channels_are_below_the_axes() -> None:
    """An analogue channel has a panel; the digital ones are lanes of one."""
    *_, analogue, digital = panels(switched())
    assert (analogue.title, analogue.label, analogue.unit) == ("channels", "ain0", "%")
    assert analogue.curves[0].is_stepped
    assert [lane.name for lane in digital.lanes] == ["in3", "in12", "out1"]


def test_what_is_not_drawn_is_reported() -> None:
    made, controller = new_run(axes=12)
    for axis in range(11):
        controller.move_by(axis, 100.0)
    controller.clock.advance(0.5)
    for channel in range(30):
        controller.outputs[channel] = 1
    controller.clock.advance(1.0)
    hidden = "3 more axes moved but are not drawn · 6 more channels changed but are not drawn"
    assert run_figure(ended(made)).subtitle.endswith(hidden)


def test_a_servo_adds_its_error_and_its_output() -> None:
    made = ballscrew()
    loop = Loop(proportional=0.05, derivative=0.5, dac_bits=12)
    servo = simulate(made.controller.axes[0], loop, make_plant({}), until=made.time)
    position, _, _, error, output = panels(made, {0: servo})
    assert [curve.name for curve in position.curves] == ["motor", "demand"]
    assert (error.label, output.unit) == ("following error", "DAC steps")
    assert error.remark == f"peak {abs(servo.error).max() / 1200.0:.6g} uu"


def test_many_moves_are_neither_named_nor_shaded() -> None:
    figure = run_figure(shift(900))
    assert (figure.x_label, names(figure)) == ("time (min)", [])
    for (panel,) in figure.rows:
        assert not panel.labels
        assert not panel.bands
        assert panel.curves[0].width == 0.6
    assert figure.rows[0][0].x_limits == pytest.approx((0.0, shift(900).time / 60.0))


@pytest.mark.parametrize(("count", "shaded"), [(20, 60), (21, 0)])
def test_sixty_phases_are_shaded_at_most(count: int, shaded: int) -> None:
    """Each move has three phases."""
    position, *_ = panels(run(Source("a.mnt", RATES + "MOVER(0) = 1 : GO(0) : PAUSE IDLE(0)\n" * count)))
    assert (len(position.bands), len(position.labels)) == (shaded, count)


def test_a_run_without_motion_or_time_has_its_panels() -> None:
    made, _ = new_run("$x^{$\x1b漢.mnt")
    figure = run_figure(ended(made))
    assert (figure.title, len(figure.rows)) == ("$x^{$␛漢.mnt", 3)


def test_a_window_of_a_run_has_the_peaks_of_that_window() -> None:
    """A ramp of 1250 mm/s² reaches 125 mm/s after a tenth of a second.

    The name of the move stays visible.
    """
    position, velocity, _ = panels(ballscrew(), begin=0.05, end=0.10005)
    assert velocity.remark == "peak 125 uu/s"
    assert len(position.labels) == 1
    assert position.x_limits == (0.05, 0.10005)


def test_a_velocity_jump_is_marked_in_all_panels_of_its_axis() -> None:
    jumping = Source("jump.mnt", "SPEED(0) = 50 : JOG(0) = 50\nWAIT(1000)\nCANCEL(0)\nWAIT(500)\n")
    made = panels(run(jumping))
    assert [[event.text for event in panel.events] for panel in made] == [["velocity jump"], [""], [""]]
    assert not any(panel.events for panel in panels(pick()))
