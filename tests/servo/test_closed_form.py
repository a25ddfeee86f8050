"""The closed form of a linear loop agrees with plain steps and hand arithmetic."""

from __future__ import annotations

from math import exp
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang import run
from motionlang.planners import hold, plan_ratio, plan_sinusoidal, plan_trapezoid
from motionlang.servo import Drive, Loop, Motor, Track, speculative
from motionlang.servo.closed_form import ClosedForm, ClosedFormServo, closed_form
from motionlang.servo.speculative import SEEN, SpeculativeServo
from motionlang.source import Source
from tests.cases import cases
from tests.servo.plain import run_plain
from tests.servo.test_oracle import LOOPS, PID, PLANTS, points_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

SECONDS = 1.6
# Loops with a closed form.
FORMS = {name: loop for name, loop in LOOPS.items() if closed_form(loop, Motor()) is not None} | {
    "feed-forward alike": Loop(0.02, 1e-5, 0.4, velocity_ff=2e-5, accel_ff=3e-7, decel_ff=3e-7),
    "feed-forward at Mint's rate": Loop(
        0.02, 1e-4, 0.1, velocity_ff=2e-4, accel_ff=3e-7, decel_ff=3e-7, servo_rate=1000.0
    ),
    "derivative every 8 samples": Loop(0.004, 0.0, 0.02, derivative_every=8),
}
LINEAR = {name: plant for name, plant in PLANTS.items() if plant.is_linear}


def track() -> Track:
    """Return a track of cubics, a half sine wave, a rest, and a profile cut short."""
    far = plan_trapezoid(0.0, 4000.0, 12_000.0, 90_000.0, 140_000.0)
    back = plan_ratio(far.position(0.2003), 4500.0, 14_000.0, 90_000.0, 120_000.0, 0.3, far.velocity(0.2003))
    wave = plan_sinusoidal(4500.0, 2500.0, 9_000.0, 80_000.0, 80_000.0)
    return Track(
        [0.0, 0.05, 0.2503, 0.2503 + back.duration, 1.1, 1.1 + wave.duration],
        [hold(0.0), far, back, hold(4500.0), wave, hold(2500.0)],
    )


def looked(servo: SpeculativeServo, blocks: list[int]) -> dict[str, Array]:
    """Run a servo in blocks of these lengths; return its samples by quantity."""
    rows = np.concatenate([servo.run_block(count) for count in blocks], axis=1)
    return dict(zip(SEEN, rows, strict=True))


def assert_plain(loop: Loop, plant: Motor | Drive, blocks: list[int]) -> None:
    motion = track()
    seen = looked(ClosedFormServo(loop, plant, motion), blocks)
    count = len(seen["error"])
    points = points_of(loop, motion, SECONDS)
    time = np.arange(count) / loop.servo_rate
    demand = np.interp(time, np.arange(len(points)) / loop.trajectory_rate, points)
    plain = run_plain(loop, plant, points, demand)
    plain["encoder"] = plain["position"]
    if isinstance(plant, Motor) and plant.encoder == "load":
        plain["encoder"] = plain["position"] - plain["twist"]
    plain["error"] = demand - plain["encoder"]
    for name, column in seen.items():
        worst = float(np.abs(column - plain[name]).max()) / max(1.0, float(np.abs(plain[name]).max()))
        assert worst < 1e-9, f"{name} differs by {worst:g}"
    limit = loop.output_limit
    assert np.array_equal(np.abs(seen["output"]) >= limit, np.abs(plain["output"]) >= limit)


def even(loop: Loop, size: int) -> list[int]:
    whole, rest = divmod(round((SECONDS - 0.01) * loop.servo_rate), size)
    return [size] * whole + [rest] * bool(rest)


@cases(("name", "plant"), [(name, plant) for name in FORMS for plant in ("motor", "gravity", "drive")])
@pytest.mark.slow
def test_every_linear_loop_is_the_plain_loop(name: str, plant: str) -> None:
    assert closed_form(FORMS[name], LINEAR[plant]) is not None
    assert_plain(FORMS[name], LINEAR[plant], even(FORMS[name], 500))


@cases("plant", LINEAR)
def test_every_linear_plant_is_the_plain_plant(plant: str) -> None:
    assert closed_form(PID, LINEAR[plant]) is not None
    assert_plain(PID, LINEAR[plant], even(PID, 1999))


@given(
    name=st.sampled_from(sorted(FORMS)),
    plant=st.sampled_from(sorted(LINEAR)),
    blocks=st.lists(st.integers(1, 700), min_size=1, max_size=8),
)
def test_blocks_of_any_length_are_the_plain_loop(name: str, plant: str, blocks: list[int]) -> None:
    rate = FORMS[name].servo_rate
    while sum(blocks) > (SECONDS - 0.01) * rate:
        blocks = blocks[:-1]
    assert_plain(FORMS[name], LINEAR[plant], blocks or [10])


# ----------------------------------------------------------------------------------------------- pencil and paper


def test_a_drive_without_a_loop_comes_to_its_speed_as_an_exponential() -> None:
    """2 V at 5000 counts/s per volt, with a lag T of 20 ms: v = 10 000 (1 - e^(-t/T)).

    The position p is the integral of v.
    """
    servo = ClosedFormServo(Loop(servo_rate=1000.0), Drive(5000.0, 0.02), Track([0.0], [hold(0.0)]))
    servo.open(2.0)
    seen = looked(servo, [300])
    for k in (0, 1, 17, 100, 299):
        t = k / 1000.0
        lag = 0.02 * (1.0 - exp(-t / 0.02))
        assert seen["velocity"][k] == pytest.approx(10_000.0 * lag / 0.02, abs=1e-8)
        assert seen["encoder"][k] == pytest.approx(10_000.0 * (t - lag), abs=1e-8)
    assert set(seen["output"]) == {2.0}


def test_a_loop_of_gain_alone_follows_a_ramp_at_a_distance() -> None:
    """A drive of 5000 counts/s per volt needs 1 V for 5000 counts/s.

    The gain is 0.01 V per count, so the following error is 100 counts.
    """
    ramp = plan_trapezoid(0.0, 1e6, 5000.0, 1e6, 1e6)
    seen = looked(ClosedFormServo(Loop(0.01), Drive(5000.0, 2e-3), Track([0.0], [ramp])), [8000])
    assert seen["error"][-1] == pytest.approx(100.0, abs=1e-9)
    assert seen["velocity"][-1] == pytest.approx(5000.0, abs=1e-7)


def test_a_constant_torque_is_a_parabola() -> None:
    """0.1 A at 0.05 N m/A accelerate 2e-5 kg m² at 250 rad/s²: 125 rad in one second.

    A radian has 4000/2π counts.
    """
    motor = Motor(amplifier="current", amplifier_gain=0.1, viscous=0.0, load_inertia=0.0)
    servo = ClosedFormServo(Loop(servo_rate=1000.0), motor, Track([0.0], [hold(0.0)]))
    servo.open(1.0)
    seen = looked(servo, [700, 301])
    assert seen["encoder"][1000] == pytest.approx(125.0 * motor.counts_per_radian, rel=1e-12)
    assert seen["current"][1000] == pytest.approx(0.1)


# ------------------------------------------------------------------------------------------------ guarantees


@given(st.integers(1, 3000), st.sampled_from(sorted(FORMS)))
def test_a_sample_is_the_same_to_the_last_bit_wherever_a_block_ends(count: int, name: str) -> None:
    """Samples repeat exactly: a motor that is taken over is exactly where it was read."""
    servo, twin = (ClosedFormServo(FORMS[name], LINEAR["gravity"], track()) for _ in range(2))
    servo.run_block(150)
    twin.run_block(150)
    there = servo.run_block(3000)
    assert twin.run_block(count).tolist() == there[:, :count].tolist()
    servo.back(150 + count)
    assert (servo.state, servo.sample, servo.error) == (twin.state, twin.sample, twin.error)


@pytest.mark.parametrize("first", [1, 2, 3, 4])
@pytest.mark.parametrize("name", ["feed-forward alike", "feed-forward at Mint's rate"])
def test_a_loop_that_was_closed_remembers_where(name: str, first: int) -> None:
    """The loop closes on a moving motor, and its command stays at that position."""

    def taken_over(blocks: list[int]) -> Array:
        growing = Track([0.0], [hold(0.0)])
        servo = ClosedFormServo(FORMS[name], Motor(), growing)
        servo.open(2.0)
        servo.run_block(200)
        now = (servo.sample - 0.5) / FORMS[name].servo_rate
        growing.starts.append(now)
        growing.profiles.append(hold(servo.position))
        servo.close(1)
        return looked(servo, blocks)["encoder"]

    assert taken_over([first, 200]) == pytest.approx(taken_over([first + 200]), abs=1e-9)


def test_a_motor_comes_to_rest_to_the_last_bit() -> None:
    """The residual motion decays to exactly zero, so a long rest costs nothing."""
    loop = Loop(0.04, 4e-4, 0.9, integral_limit=5.0)
    free, loaded = (ClosedFormServo(loop, LINEAR[name], track()) for name in ("motor", "gravity"))
    for servo in free, loaded:
        looked(servo, [2000] * 12)
        state = servo.state
        assert set(looked(servo, [2000])["encoder"]) == {2500.0}
        assert servo.state == state
    assert not free.run_block(10)[1:].any()
    assert loaded.output * Motor().amplifier_gain * 0.05 == pytest.approx(0.01)  # gain u/R k = load torque


def test_around_a_limit_there_are_plain_steps_and_elsewhere_there_are_none(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    stepped: list[int] = []
    step = SpeculativeServo._step

    def counted(servo: SpeculativeServo, until: int, out: Array) -> None:
        stepped.append(until - servo.sample)
        step(servo, until, out)

    monkeypatch.setattr(SpeculativeServo, "_step", counted)
    quick = plan_trapezoid(0.0, 4000.0, 12_000.0, 90_000.0, 140_000.0)
    ClosedFormServo(PID, Motor(), Track([0.0], [quick])).run_block(3000)
    assert stepped == []
    seen = looked(ClosedFormServo(LOOPS["tight output limit"], Motor(), Track([0.0], [quick])), [3000])
    assert sum(stepped) == 135
    assert np.abs(seen["output"]).max() == 0.4


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("derivative", [40.0, 400.0, 1e300])
def test_a_loop_that_runs_away_has_an_end(derivative: float) -> None:
    servo = ClosedFormServo(Loop(0.04, 2e-5, derivative), Motor(), track())
    seen = looked(servo, [2000, 2000])
    assert all(np.isfinite(column).all() for column in seen.values())
    assert np.abs(seen["output"]).max() == 10.0


@cases(
    ("loop", "plant"),
    [
        (PID, Motor(quantised=True)),
        (PID, Motor(coulomb=0.01)),
        (Loop(0.01, dac_bits=12), Motor()),
        (Loop(0.01, output_deadband=0.1), Motor()),
        (Loop(0.01, 1e-5, integral_mode="stopped"), Motor()),
        (Loop(0.01, accel_ff=1e-6), Motor()),
        (Loop(0.01, 0.0, 1.0, derivative_every=65), Motor()),
    ],
)
def test_what_has_no_closed_form_is_run_by_steps(loop: Loop, plant: Motor) -> None:
    assert closed_form(loop, plant) is None
    stepped = ClosedFormServo(loop, plant, track()).run(900)
    seen = looked(ClosedFormServo(loop, plant, track()), [900])
    assert all(seen[name].tolist() == stepped[name].tolist() for name in ("velocity", "error", "output"))
    assert speculative.seen_of(stepped)[0].tolist() == seen["encoder"].tolist()


@pytest.mark.parametrize(
    ("done", "begin"), [(0, 0), (1, 4), (3, 4), (4, 8), (5, 8), (7, 8), (8, 8), (11, 12), (12, 16), (16, 16)]
)
def test_the_closed_form_waits_for_a_sample_of_the_derivative(done: int, begin: int) -> None:
    """The derivative is sampled every 8 samples, and a cycle has 4 samples.

    Between two samples of the derivative, plain steps run to the end of a cycle.
    """
    loop, motor = Loop(0.004, 0.0, 0.02, derivative_every=8), Motor()
    form = closed_form(loop, motor)
    assert form is not None
    servo = ClosedFormServo(
        loop, motor, Track([0.0], [plan_trapezoid(0.0, 9e4, 12_000.0, 90_000.0, 90_000.0)])
    )
    if done:
        servo._loop = loop  # it has been in control for a long time
        servo.run_block(done)
    cubic, first, past = servo._next_cubic(form, 400)
    assert (first, (cubic is None), past > first) == (begin, done % 8 != 0, done % 8 == 0)


def test_a_program_that_is_stuck_ends_when_its_motor_has_come_to_rest() -> None:
    """Two blocks of 500 ms after the first 256 ms show that the motor stays.

    The second one is computed at the end of the first one, which begins 256 ms after the stop at 50 ms.
    """
    program = "ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 1000 : GO(0)\nWAIT(50)\nSTOP(0)\nPAUSE IN(3)\n"
    motor = {"kind": "brushless", "torque_constant": 0.06, "inertia": 3e-5, "amplifier_gain": 6.0}
    machine = {f"axis.0.plant.{name}": value for name, value in motor.items()}
    result = run(Source("stuck.mnt", program), machine=machine)
    assert [each.code for each in result.diagnostics] == ["never"]
    assert result.time == pytest.approx(0.806, abs=1e-3)


@pytest.mark.parametrize(("count", "blocks"), [(0, (64, 192)), (1, (256,)), (300, (256,))])
def test_new_gains_have_a_closed_form_from_the_257th_sample_on(count: int, blocks: tuple[int, ...]) -> None:
    """The next 256 samples are one block if the last of them has a closed form."""
    servo = ClosedFormServo(PID, Motor(), track())
    assert servo.first_blocks == (256,)
    servo.run_block(300)
    servo.retune(Loop(0.03, 1e-5, 0.5))
    if count:
        servo.run_block(count)
    assert servo.first_blocks == blocks


@pytest.mark.parametrize(
    ("values", "good"),
    [
        ([[0.5, -0.5, 0.9], [1.5, -1.5, 0.0]], 3),
        ([[1.0, -1.0, 1.5], [0.0, 0.0, 0.0]], 2),
        ([[1.0, -1.0, -1.5], [2.0, -2.0, 9.0]], 2),
        ([[0.0, 0.0, 0.0], [2.0, -2.0, 2.5]], 2),
        ([[0.0, 0.0, 9.0], [0.0, -2.5, 0.0]], 1),
        ([[1.5, 0.0, 0.0], [9.0, 0.0, 0.0]], 0),
        ([[0.0, float("nan"), 0.0], [0.0, 0.0, 0.0]], 1),
    ],
)
def test_the_samples_within_the_limits(values: list[list[float]], good: int) -> None:
    """The first quantity may have 1 and the second one 2; a limit itself is within."""
    form = ClosedForm.__new__(ClosedForm)
    form._bounds = [(0, 1.0), (1, 2.0)]
    assert form._inside(np.array(values)) == good


@cases(
    "cycles, every, sample, until, found",
    (
        # A rest of 10 cycles is too short; the ramp begins with the cycle after it.
        (10, 1, 0, 400, (True, 44, 572)),
        (11, 1, 0, 400, (True, 0, 48)),
        (10, 1, 0, 44, (False, 44, 44)),
        (10, 1, 0, 40, (False, 44, 44)),
        (11, 1, 2, 400, (True, 48, 576)),
        (14, 1, 2, 400, (True, 4, 60)),
        # The derivative is sampled every 3 samples from sample 4 on, or from 5 on: 43 and 44 are such samples.
        (10, 3, 4, 400, (False, 44, 572)),
        (10, 3, 5, 400, (True, 44, 572)),
    ),
)
def test_the_next_cubic_of_48_samples_or_more(
    cycles: int, every: int, sample: int, until: int, found: tuple[bool, int, int]
) -> None:
    """A cycle has 4 samples.

    After a rest of 10 cycles the axis accelerates for 133 cycles, up to sample 572.
    """
    loop, motor = Loop(0.004, 0.0, 0.02, derivative_every=every), Motor()
    ramp = plan_trapezoid(0.0, 9e4, 12_000.0, 90_000.0, 90_000.0)
    servo = ClosedFormServo(loop, motor, Track([0.0, cycles / loop.trajectory_rate], [hold(0.0), ramp]))
    form = closed_form(loop, motor)
    assert form is not None
    servo._sample = sample
    cubic, first, past = servo._next_cubic(form, until)
    assert (cubic is not None, first, past) == found


def test_a_glide_goes_on_behind_the_samples_beyond_a_limit() -> None:
    """The command is 10 counts at sample 8, and 2 more in each cycle of 4 samples.

    The closed form gives 16 samples, then 3, and none behind the plain steps. These take 32 samples and more up to a
    multiple of 8 samples, and 64 the second time. The points before sample 8 are a count off.
    """
    answers, calls, steps, notified = [16, 3, 0], list[object](), list[object](), list[float]()
    cubic, state = (10.0, 2.0, 0.0, 0.0), (1.0,)

    def run(given: object, here: object, off: object, out: Array) -> tuple[int, object]:
        calls.append((here, off, out.shape[1]))
        return answers.pop(0), state

    def step(until: int, out: Array) -> None:
        steps.append((servo._sample, until, out.shape[1], servo._points))
        servo._sample = until

    form: Any = SimpleNamespace(unit=4, longest=16, run=run)
    servo: Any = SimpleNamespace(
        loop=SimpleNamespace(ratio=4), _sample=8, _points=[7.0, 9.0, 99.0], _state=state, _step=step
    )
    servo._notify = lambda column: notified.append(float(column[0]))
    ClosedFormServo._glide(servo, form, cubic, 100, np.arange(92.0)[None, :])
    assert calls == [
        ((10.0, 2.0, 0.0, 0.0), (-1.0, -1.0), 16),
        ((18.0, 2.0, 0.0, 0.0), (0.0, 0.0), 16),
        ((38.0, 2.0, 0.0, 0.0), (0.0, 0.0), 16),
    ]
    behind = [16.0, 18.0, 20.0]
    assert steps == [(8 + 19, 8 + 56, 92 - 19, behind), (64, 100, 92 - 56, behind)]
    assert (notified, servo._sample) == ([15.0, 18.0], 100)


@pytest.mark.parametrize(
    ("good", "points"),
    [
        (2, [7.0, 9.0, 12.0]),
        (4, [9.0, 12.0, 12.0]),
        (5, [9.0, 12.0, 14.0]),
        (8, [12.0, 14.0, 14.0]),
        (9, [12.0, 14.0, 16.0]),
    ],
)
def test_the_points_of_the_command_behind_a_glide(good: int, points: list[float]) -> None:
    """The points before and at the beginning, 7 and 9, are those that were given."""
    form: Any = SimpleNamespace(unit=4, longest=16, run=lambda *given: (good, (1.0,)))
    servo: Any = SimpleNamespace(
        loop=SimpleNamespace(ratio=4), _sample=8, _points=[7.0, 9.0, 99.0], _state=(1.0,)
    )
    servo._notify = lambda column: None
    ClosedFormServo._glide(servo, form, (10.0, 2.0, 0.0, 0.0), 8 + good, np.zeros((1, good)))
    assert (servo._points, servo._sample) == (points, 8 + good)
