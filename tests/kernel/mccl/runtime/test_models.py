"""The differences between the boards, each shown by its output."""

from __future__ import annotations

from itertools import product

import pytest

from motionlang import run
from motionlang.commands.check import check
from motionlang.kernel import Source
from motionlang.kernel.mccl import DIALECT, MODELS, table
from tests.cases import cases
from tests.hosts.mccl.test_port import ask, board
from tests.mccl_runs import Runner

DSP, BASIC = ("multiflex", "dcx-pci300", "dcx-at200"), ("dcx-pci100", "dcx-pc100")
ALL = (*DSP, *BASIC)

# The input, and each board's answer.
DIFFERENCES: dict[str, tuple[str, dict[str, str]]] = {
    "one status word, or four": ("1TS1", {"multiflex": "01 1", **dict.fromkeys(ALL[1:], "?-1")}),
    "bit 2 is at target, or velocity mode": (
        "1VM,1TS",
        {"multiflex": "01 12", "dcx-pci300": "01 12", **dict.fromkeys(("dcx-at200", *BASIC), "01 12")},
    ),
    "bit 2 after a move in position mode": (
        "1MN,1MR5,1WS,1TS",
        {**dict.fromkeys(DSP[:2], "01 4110"), **dict.fromkeys(("dcx-at200", *BASIC), "01 4106")},
    ),
    "background tasks": ("MD1,WA9\nGT1,TR0", {**dict.fromkeys(ALL[:4], "1"), "dcx-pc100": "?-2"}),
    "ET": ("ET7", {**dict.fromkeys(ALL[:4], "?-1"), "dcx-pc100": "?-2"}),
    "S-curves": ("1PS,1SV5,1TP", {**dict.fromkeys(DSP, "01 0"), **dict.fromkeys(BASIC, "?-2")}),
    "parabolic profile": ("1PP,1TP", {**dict.fromkeys(DSP, "01 0"), **dict.fromkeys(BASIC, "?-2")}),
    "a deceleration of its own": ("1DS50,1TP", {**dict.fromkeys(DSP, "01 0"), **dict.fromkeys(BASIC, "?-2")}),
    "SA sets the deceleration too where DS is none": (
        'LU"DECEL",AR10,1SA50,1RL@10,TR0',
        {**dict.fromkeys(DSP, "100000"), **dict.fromkeys(BASIC, "50")},
    ),
    "rates of the loop": ("1LS,1TP", {**dict.fromkeys(DSP, "01 0"), **dict.fromkeys(BASIC, "?-2")}),
    "feed-forward": ("1VG1,1TP", {**dict.fromkeys(DSP, "01 0"), **dict.fromkeys(BASIC, "?-2")}),
    "output deadband and offset": ("1OB1,1OO1,1TP", {"multiflex": "01 0", **dict.fromkeys(ALL[1:], "?-2")}),
    "gains are real, or whole": (
        "1SG2210.6,1TG",
        {**dict.fromkeys(DSP, "01 2210.600000"), **dict.fromkeys(BASIC, "01 2211")},
    ),
    "user units": ("1US10,1MN,1TP", {**dict.fromkeys(ALL[:4], "01 0.000000"), "dcx-pc100": "?-2"}),
    "parameters are whole before a scale is set": ("1MN,1MR10.4,1WS,1TP", dict.fromkeys(ALL, "01 10")),
    "real ones after": (
        '1US10,1MN,1SV0.55,LU"SPEED",1RV@0,TR0',
        {**dict.fromkeys(ALL[:4], "5.500000"), "dcx-pc100": "?-2"},
    ),
    "contours": (
        "1MN,2MN,1CM1,2CM1,1CP1,1MR50,2MR50,1WS,1TP",
        {**dict.fromkeys(ALL[:4], "01 50"), "dcx-pc100": "?-2"},
    ),
    "the highest macro": ("MD1000,1TP\nMC1000", {**dict.fromkeys(ALL[:4], "01 0"), "dcx-pc100": "?-5"}),
    "the highest macro of the oldest": ("MD255,1TP\nMC255", dict.fromkeys(ALL, "01 0")),
    "the number of registers": ("TR255", dict.fromkeys(ALL, "0")),
    "no register beyond": ("TR256", dict.fromkeys(ALL, "?-1")),
    "channels that are outputs at power-up": (
        "CN33,TC33",
        {"multiflex": "33 1", **dict.fromkeys(ALL[1:], "?-1")},
    ),
    "the others have theirs lower": ("CN9,TC9", {"multiflex": "?-1", **dict.fromkeys(ALL[1:], "09 1")}),
    "power-up velocity of a servo": ('LU"SPEED",1RL@0,TR0', dict.fromkeys(ALL, "40000")),
    "the name": ("VE", {name: f"{model.title}, motionlang" for name, model in MODELS.items()}),
}


@cases("what, model", product(DIFFERENCES, ALL))
def test_models_differ(what: str, model: str, mccl: Runner) -> None:
    text, answers = DIFFERENCES[what]
    output = mccl(text, machine={"controller.model": model}, until=1.0).output
    shown = output[-1] if what != "the name" else output[-1].rpartition(" ")[0]
    assert shown == answers[model]


@pytest.mark.parametrize(
    ("model", "talk"),
    [
        ("multiflex", b"1TP\n01 0\n>"),
        ("dcx-pci300", b"1TP\n01 0\n>"),
        ("dcx-pci100", b"1TP\n01 0\n>"),
        ("dcx-at200", b"1TP\r01 0\r>"),
        ("dcx-pc100", b"01 0\r"),
    ],
)
def test_prompt_echo_and_line_end(model: str, talk: bytes) -> None:
    console, port = board(model, echo=None)
    assert ask(console, port, b"1TP\r") == talk


@pytest.mark.parametrize("model", ALL)
def test_what_a_board_lacks_is_known_before_the_run_and_not_in_its_help(model: str, mccl: Runner) -> None:
    lacks = {row.name for row in table() if row.family in MODELS[model].lacks}
    settings = {"controller.model": model}
    helped = {line.split()[0] for line in mccl("HE", machine=settings).output}
    assert helped == {row.name for row in table()} - lacks
    for name in sorted(lacks):
        (found, *_) = check(DIALECT.program(Source("a.mcl", f"1{name}1"), settings))
        assert found.code == "model"
        assert "multiflex" in found.hint


@pytest.mark.parametrize(
    ("text", "model", "hint"),
    [
        ("MD300,1TP", "dcx-pc100", "multiflex, dcx-pci300, dcx-pci100, dcx-at200 have it"),
        ("AL300,AR1,MC@1", "dcx-pc100", "multiflex, dcx-pci300, dcx-pci100, dcx-at200 have it"),
        ("1TS2", "dcx-pci300", "multiflex has it"),
        ("AL40,AR1,CN@1", "dcx-pc100", "CT40 makes it an output; it is one on multiflex"),
    ],
)
def test_what_another_board_would_do_names_the_key_of_the_board(
    text: str, model: str, hint: str, mccl: Runner
) -> None:
    (found,) = mccl(text, machine={"controller.model": model}).diagnostics
    assert found.hint == f"{hint}: controller.model in the machine file"


@pytest.mark.parametrize("text", ["CI9,CN9", "CN70", "MD2000,1TP"])
def test_what_no_other_board_would_do_does_not(text: str, mccl: Runner) -> None:
    (found,) = mccl(text, machine={"controller.model": "dcx-pc100"}).diagnostics
    assert "controller.model" not in found.hint


def test_a_stepper_of_a_multiflex_has_other_settings_at_power_up(mccl: Runner) -> None:
    text = 'LU"SPEED",1RL@0,TR0,LU"ACCEL",1RL@0,TR0,LU"MINSPEED",AR10,1RL@10,TR0,1RT,1RL@10,TR0,2RL@10,TR0'
    stepper = {"axis.1.motor": "stepper"}
    assert mccl(text, machine=stepper).output == ["10000", "10000", "1000", "1000", "0"]
    other = mccl(text, machine={"controller.model": "dcx-at200", **stepper})
    assert other.output == ["40000", "100000", "0", "0", "0"]


@pytest.mark.parametrize(
    ("name", "model"),
    [
        ("a.pc1", "dcx-pc100"),
        ("a.at2", "dcx-at200"),
        ("a.PCI1", "dcx-pci100"),
        ("a.pci3", "dcx-pci300"),
        ("a.mfx1", "multiflex"),
        ("a.mcl", "multiflex"),
        ("a.dc2", "multiflex"),
    ],
)
def test_a_suffix_of_pmcs_says_which_board_a_file_is_for(name: str, model: str) -> None:
    """The machine file takes precedence over the suffix."""
    text = "VE\n1OB1"
    result = run(Source(name, text), dialect="mccl")
    assert result.output[0].startswith(MODELS[model].title)
    assert bool(check(DIALECT.program(Source(name, text)))) is ("output control" in MODELS[model].lacks)
    other = run(Source(name, text), dialect="mccl", machine={"controller.model": "dcx-at200"})
    assert other.output[0].startswith(MODELS["dcx-at200"].title)


@pytest.mark.parametrize("model", ALL)
def test_without_ds_the_acceleration_is_the_deceleration_too(model: str, mccl: Runner) -> None:
    """5000 counts at 1000 counts/s take 5 s, and each ramp half of its own duration.

    That is 0.1 s at 5000 counts/s² and 0.005 s at the 100 000 of power-up.
    """
    text = 'LU"ACCEL",AR20,AL5000,1WL@20\n1MN,1SV1000,1MR5000,1WS'
    found = mccl(text, machine={"controller.model": model, "controller.instruction_time": 1e-9})
    assert found.time == pytest.approx(5.105 if model in DSP else 5.2, abs=1e-6)
