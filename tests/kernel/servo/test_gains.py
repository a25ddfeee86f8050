"""Gains: equal gains of both languages make equal loops.

Loops and motors come from the machine file, too.
"""

from __future__ import annotations

from dataclasses import fields

import pytest

from motionlang import run
from motionlang.kernel import Source, dialect
from motionlang.kernel.planners import hold, plan_trapezoid
from motionlang.kernel.servo import (
    KEYS,
    PLANT,
    SERVO,
    Loop,
    Motor,
    Override,
    Servo,
    Track,
    VelocityDrive,
    gains,
    make_loop,
    make_plant,
    mccl_values,
    mint_values,
    section,
    simulate,
    suggest,
)
from motionlang.kernel.servo.gains import LM628_RATE, MCCL, MINT
from motionlang.kernel.servo.settings import problem
from motionlang.lab.servo.input import gains_of, spoken, written

TABLES = {"mint": MINT, "mccl": MCCL}
WORDS = {language: gains_of(language) for language in TABLES}


def mint_loop(values: dict[str, float]) -> Loop:
    """Return the loop with gains by Mint's keywords."""
    return gains.mint_loop(written(WORDS["mint"], values))


def mccl_loop(values: dict[str, float], model: str = "multiflex", scale: float = 1.0) -> Loop:
    """Return the loop with gains by MCCL's commands."""
    return gains.mccl_loop(written(WORDS["mccl"], values), model, scale)


def test_mints_worked_example() -> None:
    """MN1274: KPROP 2, 100 counts of error, and KVELFF for 7000 rpm on a resolver.

    The error causes an additional speed of 46.72 counts per tick.
    """
    counts_per_loop = 7000.0 / 60.0 * 4096.0 / 1000.0
    kvelff = 2048.0 / counts_per_loop
    loop = mint_loop({"KPROP": 2.0, "KVELFF": kvelff})
    speed = 100.0 * loop.proportional / loop.velocity_ff
    assert speed / 1000.0 == pytest.approx(46.72, abs=0.06)


def test_kvelff_alone_makes_a_velocity_drive_follow() -> None:
    """MN1957, 5.8.1: with the right KVELFF the motor runs at the commanded speed.

    The other gains do not affect this.
    """
    full = 120_000.0
    loop = mint_loop({"KVELFF": 2048.0 / (full / 1000.0)})
    drive = VelocityDrive(full / 10.0, 1e-4)
    profile = plan_trapezoid(0.0, 50_000.0, 60_000.0, 600_000.0, 600_000.0)
    trace = simulate(Track([0.0], [profile]), loop, drive, until=0.4)
    assert trace.velocity[-1] == pytest.approx(60_000.0)


def test_kintlimit_is_percent_of_full_scale() -> None:
    loop = mint_loop({"KINT": 1.0, "KINTLIMIT": 5.0, "KINTMODE": 1.0})
    servo = Servo(
        loop,
        VelocityDrive(1e-3, 1.0),
        Track([0.0, 0.01], [hold(0.0), plan_trapezoid(0.0, 1e4, 1e6, 1e9, 1e9)]),
    )
    servo.advance(1.0)
    assert servo.integral == pytest.approx(0.5)


@pytest.mark.parametrize(("mode", "name"), list(enumerate(["never", "always", "steady", "stopped"])))
def test_kintmode(mode: int, name: str) -> None:
    assert mint_loop({"KINT": 1.0, "KINTMODE": mode}).integral_mode == name


@pytest.mark.parametrize(
    ("commands", "gains_in_force"),
    [
        ("", (0.04, 0.001, 0.9, 0.003, 7.0)),
        ("1GM", (0.04, 0.0, 0.0, 0.0, 7.0)),
        ("1GM,1SG0.05,1SD0.7,1SQ6", (0.05, 0.0, 0.0, 0.0, 6.0)),
        ("1GM,1SD0.7,1PM", (0.04, 0.001, 0.7, 0.003, 7.0)),
        ("1GM,1VM", (0.04, 0.001, 0.9, 0.003, 7.0)),
    ],
)
def test_gain_mode_has_no_gain_but_the_proportional(commands: str, gains_in_force: tuple[float, ...]) -> None:
    text = f"1SG0.04,1SI0.001,1SD0.9,1VG0.003,1SQ7,1MN,1MR10,WA0.1\n{commands}"
    result = run(Source("a.mcl", text), machine={"axis.1.plant.load_inertia": 4e-5})
    feedback = result.controller.axes[1].feedback
    assert feedback is not None
    assert feedback.chosen is not None
    loop = feedback.chosen.loop
    found = loop.proportional, loop.integral, loop.derivative, loop.velocity_ff, loop.output_limit
    assert found == gains_in_force


def test_multiflex_gains_are_volts() -> None:
    loop = mccl_loop({"SG": 0.01, "SI": 1e-6, "SD": 0.25, "IL": 1000.0, "VG": 2e-5, "SQ": 3.5})
    assert (loop.proportional, loop.integral, loop.derivative) == (0.01, 1e-6, 0.25)
    assert loop.integral_limit == pytest.approx(1e-3)
    assert loop.output_limit == 3.5
    assert (loop.servo_rate, loop.trajectory_rate, loop.derivative_every) == (4000.0, 1000.0, 1)


def test_feed_forward_follows_the_user_scale() -> None:
    assert mccl_loop({"VG": 0.2}, scale=1000.0).velocity_ff == pytest.approx(2e-4)


@pytest.mark.parametrize(("seconds", "samples"), [(0.00025, 1), (0.001, 4), (0.0, 1)])
def test_the_derivative_period_is_seconds(seconds: float, samples: int) -> None:
    assert mccl_loop({"SD": 1.0, "FR": seconds}).derivative_every == samples


def test_a_dcx_module_computes_like_its_chip() -> None:
    """Working values of a real DCX-PCI100: gain 2211, derivative 6000, FR 3.

    FR 3 is a period of 4 x 341 us.
    """
    loop = mccl_loop({"SG": 2211, "SD": 6000, "FR": 3}, "dcx")
    assert loop.arithmetic == "lm628"
    assert pytest.approx(341.33e-6, rel=1e-4) == 1.0 / LM628_RATE
    assert loop.derivative_every * loop.period == pytest.approx(0.001364, abs=2e-6)
    assert loop.dac_bits == 12


def test_gains_come_back_as_the_words_they_were() -> None:
    loop = suggest(Motor(), 40.0).loop
    again = mccl_loop(spoken(WORDS["mccl"], mccl_values(loop, 100.0)), scale=100.0)
    slow = suggest(Motor(), 20.0, Loop(servo_rate=1000.0)).loop
    mint = mint_loop(spoken(WORDS["mint"], mint_values(slow)))
    for name in ("proportional", "integral", "derivative", "velocity_ff", "accel_ff", "decel_ff"):
        assert getattr(again, name) == pytest.approx(getattr(loop, name)), name
        assert getattr(mint, name) == pytest.approx(getattr(slow, name)), name


# A gain by its quantity, its model, and its lowest and highest value.
RANGES = [
    ("mint", "period", 50.0, 100_000.0),
    ("mint", "integral_limit", 0.0, 100.0),
    ("mint", "integral_mode", 0.0, 3.0),
    ("mint", "output_limit", 0.0, 100.0),
    ("multiflex", "rate", 1000.0, 4000.0),
    ("multiflex", "integral_limit", 0.0, None),
    ("multiflex", "integral_mode", 0.0, 2.0),
    ("multiflex", "derivative_every", 0.0, 10.0),
    ("multiflex", "output_deadband", 0.0, 10.0),
    ("multiflex", "output_limit", 0.0, 10.0),
    ("multiflex", "reversed", 0.0, 1.0),
    ("dcx", "proportional", 0.0, 32767.0),
    ("dcx", "integral", 0.0, 32767.0),
    ("dcx", "integral_limit", 0.0, 32767.0),
    ("dcx", "derivative", 0.0, 32767.0),
    ("dcx", "integral_mode", 0.0, 2.0),
    ("dcx", "derivative_every", 1.0, 255.0),
    ("dcx", "output_limit", 0.0, 10.0),
    ("dcx", "reversed", 0.0, 1.0),
]


@pytest.mark.parametrize(("model", "quantity", "low", "high"), RANGES)
def test_the_range_of_a_gain(model: str, quantity: str, low: float, high: float | None) -> None:
    """A step beyond each end is refused; a DCX module takes an FR below 1."""

    def made(value: float) -> Loop:
        given = {quantity: (value, "WORD")}
        return gains.mint_loop(given) if model == "mint" else gains.mccl_loop(given, model)

    step = 0.5 if high is not None and high < 1000.0 else 1.0
    beyond = [] if high is None else [high + step]
    if low != 1.0:
        beyond.append(low - step)
    for value in (low, high):
        if value is not None:
            made(value)
    for value in beyond:
        with pytest.raises(
            ValueError, match=f"WORD must be {low:g}" if low != 1.0 else "WORD must be 0 to 255"
        ):
            made(value)


def test_a_dcx_module_counts_samples_between_derivatives() -> None:
    """FR 1 takes every second sample, FR 255 every 256th, and FR below 1 each."""
    every = [
        gains.mccl_loop({"derivative_every": (value, "FR")}, "dcx").derivative_every
        for value in (0.5, 1, 255)
    ]
    assert every == [1, 2, 256]


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: mint_loop({"KPROPP": 1.0}), "KPROPP is not a servo gain"),
        (lambda: mint_loop({"KINTMODE": 7.0}), "KINTMODE must be 0 to 3, not 7"),
        (lambda: mint_loop({"LOOPTIME": 0.0}), "LOOPTIME must be 50 to 100000, not 0"),
        (lambda: mccl_loop({"SQ": 11.0}), "SQ must be 0 to 10, not 11"),
        (lambda: mccl_loop({}, "acr"), "there is no servo model 'acr'"),
        (lambda: mccl_loop({}, scale=0.0), "the scale must not be 0.0"),
        (lambda: mccl_loop({"SG": 40_000}, "dcx"), "SG must be 0 to 32767, not 40000"),
        (lambda: make_plant({"inertia": 0.0}), "inertia must be greater than zero, not 0.0"),
        (lambda: make_plant({"inertia": "big"}), "inertia must be a number, not 'big'"),
        (lambda: make_plant({"quantised": 1}), "quantised must be true or false, not 1"),
        (lambda: make_plant({"amplifier": "power"}), 'amplifier must be "voltage" or "current", not .power.'),
        (lambda: make_plant({"inerta": 1.0}), "there is no key inerta in plant"),
        (
            lambda: make_plant({"kind": "drive", "inertia": 1e-5}),
            "inertia does not belong to a plant of kind drive",
        ),
        (lambda: make_plant({"backlash": 2.0}), "backlash needs a resonance"),
        (lambda: make_plant({"resonance": 50.0}), "a resonance needs a load inertia"),
        (lambda: make_plant({"coulomb": 0.1, "breakaway": 0.05}), "breakaway torque must not be below"),
        (
            lambda: make_loop({"servo_rate": 1500.0}),
            "the servo rate must be a multiple of the trajectory rate",
        ),
        (lambda: make_loop({"dac_bits": 5}), "a DAC has 8 to 16 bits, not 5"),
        (lambda: make_loop({"override_steps": 4}), "the DAC override counts DAC steps"),
        (lambda: make_loop({"proportional": float("nan")}), "proportional must be a finite number"),
        (
            lambda: make_loop({"arithmetic": "lm628", "dac_bits": 12, "proportional": 0.5}),
            "must be a whole number",
        ),
        (lambda: Override(0, 1, 1.0), "at least 1 step"),
        (lambda: Loop(integral_mode="sometimes"), "there is no integral mode"),
    ],
)
def test_mistakes_are_named(make: object, message: str) -> None:
    assert callable(make)
    with pytest.raises(ValueError, match=message):
        make()


def test_every_default_of_the_machine_file_is_one_it_accepts() -> None:
    for name, key in {**PLANT, **SERVO}.items():
        assert problem(key, key.default) is None, name
        assert key.help.endswith("."), name
    assert len(KEYS) == len(PLANT) + len(SERVO)


def test_defaults_of_the_machine_file_are_those_of_the_objects() -> None:
    motor = {
        name: key.default for name, key in PLANT.items() if name not in ("speed_per_volt", "time_constant")
    }
    assert make_plant(motor) == Motor()
    assert make_plant({"kind": "drive"}) == VelocityDrive()
    override = ("override_steps", "override_hold", "override_speed")
    loop = {name: key.default for name, key in SERVO.items() if name not in (*override, "integral_limit")}
    assert make_loop(loop) == Loop()


def test_a_section_with_an_override() -> None:
    loop = make_loop({"dac_bits": 12, "override_steps": 3, "override_hold": 4, "override_speed": 5e4})
    assert loop.override == Override(3, 4, 5e4)


@pytest.mark.parametrize("language", TABLES)
def test_every_gain_is_that_of_one_word(language: str) -> None:
    assert sorted(WORDS[language].values()) == sorted(TABLES[language])


@pytest.mark.parametrize("language", TABLES)
def test_gains_at_power_up_are_those_of_the_rows(language: str) -> None:
    """FR is the exception: its row has 0, which means one sample."""
    for row in dialect(language).table():
        if row.tunes and row.default is not None and row.name != "FR":
            assert row.default == TABLES[language][row.tunes], row.name


def test_what_a_gain_sets_is_a_field_of_the_loop() -> None:
    for language, table in TABLES.items():
        assert gains.fields(language, table) <= {each.name for each in fields(Loop)}


def test_dotted_settings_fall_into_sections() -> None:
    found = {
        "controller.axes": 2,
        "axis.1.plant.inertia": 3e-5,
        "axis.1.servo.derivative": 0.5,
        "axis.0.travel": 1,
    }
    assert make_plant(section(found, 1, "plant")) == Motor(inertia=3e-5)
    assert make_loop(section(found, 1, "servo")) == Loop(derivative=0.5)
    assert section(found, 0, "plant") == {}
