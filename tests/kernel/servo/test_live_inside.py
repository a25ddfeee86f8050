"""Seen from inside: runs with motors in the machine file, which readings, waits and faults follow."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import motionlang
from motionlang.kernel import Controller, Source
from motionlang.kernel.controller import feedback
from motionlang.kernel.controller.feedback import Feedback
from motionlang.kernel.servo import simulate
from motionlang.kernel.tracks import servo_trace
from tests.cases import examples
from tests.kernel.servo.test_live import GAINS, MOTOR, MOVE, RATE, ROUGH, printed, run


def fitted(plant: dict[str, object], section: dict[str, object]) -> tuple[Controller, Feedback]:
    controller = Controller(1)
    a = controller.axes[0]
    a.feedback = Feedback(a, plant, section)
    return controller, a.feedback


CHAPTER_12: dict[str, object] = {
    "arithmetic": "chapter12",
    "dac_bits": 12,
    "proportional": 300.0,
    "derivative": 900.0,
    "override_steps": 20,
    "override_hold": 2,
    "override_speed": 100_000.0,
}


DRIVE: dict[str, object] = {"kind": "drive", "quantised": True}


@pytest.mark.parametrize(
    ("plant", "section"),
    [(MOTOR, GAINS), (ROUGH, GAINS), (DRIVE, CHAPTER_12)],
    ids=["linear", "rough", "chapter 12"],
)
@given(cuts=st.lists(st.floats(0.0, 0.9), min_size=1, max_size=12), stops=st.booleans())
@settings(max_examples=examples(25))
def test_what_is_read_live_is_what_a_later_simulation_gives(
    plant: dict[str, object], section: dict[str, object], cuts: list[float], stops: bool
) -> None:
    controller, feedback = fitted(plant, section)
    seen = []
    controller.move_to(0, 4000.0)
    for cut in sorted(cuts):
        controller.clock.advance(cut)
        if stops and cut > 0.1:
            controller.stop(0)
            controller.move_to(0, 1000.0)
            stops = False
        seen.append((controller.clock.now, controller.position(0), controller.velocity(0), feedback.output))
    assert feedback.chosen is not None
    later = simulate(controller.axes[0], feedback.chosen.loop, feedback.plant, until=1.0)
    for time, *readings in seen:
        k = int(time * RATE + 1e-6)
        there = [float(column[k]) for column in (later.measured, later.velocity, later.output)]
        assert readings == pytest.approx(there, rel=1e-9, abs=1e-6)


def test_everything_done_to_a_loop_is_in_its_history() -> None:
    """Gains, new zero, off, on and torque: live readings equal those of a replay."""
    controller, feedback = fitted(ROUGH, GAINS)
    seen = []

    def pass_time(seconds: float) -> None:
        end = controller.clock.now + seconds
        while controller.clock.now < end:
            controller.clock.advance(controller.clock.now + 0.0037)
            seen.append((controller.clock.now, controller.position(0), feedback.error, feedback.current))

    controller.move_to(0, 4000.0)
    pass_time(0.05)
    controller.define_position(0, 100.0)
    pass_time(0.05)
    feedback.tune({"proportional": (2.0, "KPROP"), "derivative": (60.0, "KDERIV")})
    pass_time(0.1)
    controller.disable(0)
    pass_time(0.05)
    controller.enable(0)
    pass_time(0.02)
    controller.open_loop(0, 1.5)
    pass_time(0.1)
    controller.move_by(0, -500.0)
    pass_time(0.2)
    replayed = servo_trace(controller.axes[0], controller.clock.now)
    assert replayed is not None
    for time, position, error, current in seen:
        k = int(time * RATE + 1e-6)
        assert (position, error, current) == pytest.approx(
            (replayed.measured[k], replayed.error[k], replayed.current[k]), abs=1e-9
        )


def test_without_a_motor_feedback_equals_demand() -> None:
    result = motionlang.run(
        Source("x", MOVE + "WAIT = 50\nPRINT POS(0) - POSDEMAND(0), FOLERROR(0)"), dialect="mint"
    )
    assert result.output == ["0.00000.0000"]
    assert result.report["axes"][0]["feedback"] == "demand"


@pytest.mark.parametrize("plant", [MOTOR, ROUGH], ids=["linear", "rough"])
def test_the_rest_behind_a_move_is_what_was_seen_of_it(
    plant: dict[str, object], monkeypatch: pytest.MonkeyPatch
) -> None:
    """No sample is dropped at the end of a move, because none would change."""
    text = (
        "Dim n As Integer\nFor n = 1 To 3\n"
        + MOVE
        + 'PAUSE IDLE(0)\nPRINT TIME, " ", POS(0), " ", VEL(0)\nWAIT = 30 * n\nPRINT POS(0), " ", FOLERROR(0)\nNext\n'
    )
    thrown: list[Feedback] = []
    forget = Feedback._forget

    def counted(each: Feedback) -> None:
        thrown.append(each)
        forget(each)

    monkeypatch.setattr(Feedback, "_forget", counted)
    seen, few = printed(text, plant, servo=GAINS), len(thrown)
    monkeypatch.setattr(feedback, "rests_as_seen", lambda track: False)
    assert printed(text, plant, servo=GAINS) == seen
    assert len(thrown) - few > few


@pytest.mark.parametrize(
    ("text", "dialect", "servo", "gains", "proportional"),
    [
        ("KPROP(0) = 2.048 : {}", "mint", {}, "program", 0.01),
        ("KPROP(0) = 2.048 : {}", "mint", {"proportional": 0.5, "derivative": 0.1}, "program", 0.01),
        ("{}", "mint", {"proportional": 0.5, "derivative": 0.1}, "machine file", 0.5),
        ("1SG0.03,1MN,1MR100,1WS0", "mccl", {"derivative": 0.1}, "program", 0.03),
    ],
)
def test_the_program_s_gains_come_first_then_the_machine_file_s(
    text: str, dialect: str, servo: dict[str, object], gains: str, proportional: float
) -> None:
    result = run(text.format("MOVER(0) = 100 : GO(0)"), MOTOR, dialect, servo=servo)
    feedback = result.controller.axes[0 if dialect == "mint" else 1].feedback
    assert feedback is not None
    assert feedback.chosen is not None
    assert feedback.chosen.gains == gains
    assert feedback.chosen.loop.proportional == pytest.approx(proportional)
    assert feedback.chosen.loop.derivative == servo.get("derivative", 0.0)


@pytest.mark.parametrize("plant", [MOTOR, DRIVE], ids=["closed form", "steps"])
def test_a_long_rest_is_passed_over_and_what_follows_it_is_at_its_sample(plant: dict[str, object]) -> None:
    """Readings during a rest do not affect the next move."""

    def samples(*reads: float) -> list[tuple[float, float]]:
        controller, feedback = fitted(plant, {"proportional": 0.02, "derivative": 0.2})
        controller.move_to(0, 400.0)
        for time in reads:
            controller.clock.advance(time)
            assert controller.position(0) == pytest.approx(400.0)
        controller.clock.advance(60.0)
        controller.move_to(0, 800.0)
        seen = []
        for _ in range(60):
            controller.clock.advance(controller.clock.now + 1e-3)
            seen.append((controller.position(0), feedback.error))
        return seen

    assert samples() == samples(30.0) == samples(*range(10, 60)) == samples(59.9)


def test_a_motor_that_leaves_standstill_is_watched_again() -> None:
    """An unstable loop amplifies 1e-7 counts, which at first count as standstill."""
    controller, feedback = fitted(MOTOR, {"proportional": 0.0225})
    trips: list[float] = []

    def trip() -> None:
        trips.append(abs(feedback.error))
        feedback.set_error_limit(np.inf)

    feedback.tripped = trip
    feedback.set_error_limit(1.0)
    controller.move_to(0, 1e-7)
    at_standstill, error = [], []
    for k in range(1, 101):  # each reading computes half a second more
        controller.clock.advance(0.5 * k)
        error.append(abs(feedback.error))
        at_standstill.append(feedback.at_standstill)
    assert any(at_standstill)
    assert max(error) > 10.0
    (at,) = trips
    assert 1.0 < at < 2.0  # at the sample beyond the limit, not at the next reading


@pytest.mark.parametrize("zero", [0.0, 250.0])
def test_a_position_is_known_for_the_samples_that_are_stored(zero: float) -> None:
    """Nothing is simulated for it. A new zero shifts the positions by as much."""
    controller, feedback = fitted(MOTOR, GAINS)
    assert feedback.known_position(0.0) is None
    controller.move_to(0, 1000.0)
    controller.clock.advance(20.0)
    controller.define_position(0, controller.position(0) + zero)
    controller.move_by(0, 100.0)
    controller.clock.advance(20.5)
    here = feedback.position
    samples = feedback._samples
    assert samples is not None
    assert here == pytest.approx(controller.position(0), abs=20.0)
    assert feedback.known_position(20.5) == here
    numbers = samples.first - 1, samples.first, samples.end - 1, samples.end
    found = [feedback.known_position(number / RATE) for number in numbers]
    assert [each is None for each in found] == [True, False, False, True]
    controller.clock.advance(numbers[2] / RATE)
    assert found[2] == feedback.position
