"""Answers of a board, as lines of the port.

A call, and its result with the values that it returns.

The machine is a MultiFlex of 8 axes. Constants are numbers, as on the port: see `motionlang/hosts/mcapi/table.py`.
"""

from __future__ import annotations

from collections.abc import Iterable

import pytest

import motionlang_mcapi as mc
from motionlang_mcapi import Mcapi
from test_mcapi.conftest import ask, converse, opened


def test_channels(host: Mcapi) -> None:
    """Channels are 1 to 255; 33 is an output, 1 an input, both high-true."""
    converse(
        host,
        """
        MCGetDigitalIOEx 1 0 + -> 18
        MCGetDigitalIOEx 1 1 + -> 0 0
        MCGetDigitalIOEx 1 255 + -> 0 0
        MCGetDigitalIOEx 1 256 + -> 18
        MCGetDigitalIO 1 256 -> 0
        MCGetError 1 -> 18
        MCGetDigitalIOConfig 1 1 + -> 0 5
        MCGetDigitalIOConfig 1 33 + -> 0 6
        MCGetDigitalIOConfig 1 0 + -> 18
        MCConfigureDigitalIO 1 33 8 -> 1
        MCGetDigitalIOConfig 1 33 + -> 0 10
        MCGetAnalog 1 255 -> 2048
        MCGetAnalogEx 1 256 + -> 18
        """,
    )


@pytest.mark.parametrize(
    ("volts", "wanted"),
    [(-12.0, 0), (-10.0, 0), (-5.0, 1024), (0.0, 2048), (2.0, 2457), (10.0, 4095), (12.0, 4095)],
)
def test_the_number_of_a_voltage(host: Mcapi, volts: float, wanted: int) -> None:
    """±10 V are 0 to 4095: (V/10 + 1)/2 · 4095; -5 V are 1023.75, 0 V are 2047.5."""
    host.board.console.board.controller.analogue_inputs[1] = 10.0 * volts
    assert host.GetAnalogEx(1) == wanted


def test_modules_of_the_sites(host: Mcapi) -> None:
    """252 is a servo module of a MultiFlex, 15 an empty site."""
    converse(
        host,
        """
        MCGetInstalledModules 1 + 0 -> 18
        MCGetInstalledModules 1 + 1 -> 0 252
        MCGetInstalledModules 1 + 10 -> 0 252 252 252 252 252 252 252 252 15 15
        """,
    )


def test_a_buffer_needs_room_for_the_terminating_zero(host: Mcapi) -> None:
    """The text of error 18 has 22 characters, so it fits in a buffer of 23."""
    converse(
        host,
        """
        MCTranslateErrorEx 18 + 0 -> 18
        MCTranslateErrorEx 18 + 22 -> 18 "parameter out of rang"
        MCTranslateErrorEx 18 + 23 -> 0 "parameter out of range"
        MCTranslateErrorEx 99 + 40 -> 0 "unknown error 99"
        MCTranslateErrorEx 0 + 1 -> 18 ""
        """,
    )
    assert host.TranslateErrorEx(18) == "parameter out of range"


@pytest.mark.parametrize(
    ("model", "module", "rates"),
    [
        ("multiflex", mc.MFXSERVO, "4000.0 2000.0 1000.0"),
        ("dcx-pci300", mc.MC300, "4000.0 2000.0 1000.0"),
        ("dcx-pc100", mc.MC110, "1000.0 1000.0 1000.0"),
    ],
)
def test_the_module_of_an_axis(model: str, module: int, rates: str) -> None:
    """The first are module, site, servo motor, and 16 + 32 + 64 + 128 for recordings.

    A recording has 10,000 points. A servo has no step rates. A DCX-PC100 has one loop rate, 1 kHz.
    """
    converse(
        opened({"controller.model": model}),
        f"MCGetAxisConfiguration 1 3 + -> 0 {module} 3 1 240 10000 0 {rates} 0.0 0.0 0.0 0.0 0.0 0.0 1",
    )


def test_modes_of_a_module_at_power_up(host: Mcapi) -> None:
    converse(
        host,
        """
        MCGetModuleInputMode 1 1 + -> 0 0
        MCGetModuleOutputMode 1 1 + -> 0 0
        """,
    )


def test_a_buffer_for_text_keeps_its_length() -> None:
    """A text of 6 characters and its terminating zero take 7 of 12 characters.

    In one character there is room only for the zero.
    """
    host, buffer = opened(mode=mc.MC_OPEN_ASCII), bytearray(b"x" * 12)
    assert host.pmcgets(buffer, 1) == 0
    assert buffer == b"\0" + b"x" * 11
    host.pmcputs("1TP\r")
    assert host.pmcgets(buffer, 12) == 6
    assert buffer == b"01 0\n>\0xxxxx"
    with pytest.raises(mc.McapiException, match="parameter out of range"):
        host.pmcgets(buffer, 0)


def test_a_text_may_be_a_line_end_alone() -> None:
    """The rest of the text waits for the next call; a busy board is not waited for."""
    host = opened(mode=mc.MC_OPEN_ASCII)
    interface = host.board.desk.interface(is_ascii=True)
    host.pmcputs("WA1\r")
    interface._unread += b"\r1TP"
    assert (interface.has_text(9), interface.get(9), interface.has_text(9)) == (True, "\r", False)


def test_a_host_may_go_on_after_an_error(host: Mcapi) -> None:
    """A host that raises no exceptions reads 0, and the handle has the error."""

    class Tolerant(Mcapi):
        def ProcessException(self, error: int = -1) -> int:  # noqa: N802
            return error

    tolerant = Tolerant(host.board)
    tolerant.Open(0, mc.MC_OPEN_BINARY)
    assert (tolerant.GetPositionEx(99), tolerant.GetError()) == (0, mc.MCERR_AXIS_NUMBER)


def test_a_structure_begins_with_zeros_of_its_types() -> None:
    assert repr(mc.MCPARAM()) == (
        "MCPARAM(ID=0, ControllerType=0, NumberAxes=0, DigitalIO=0, AnalogInput=0, AnalogOutput=0, "
        "AxisType=[0, 0, 0, 0, 0, 0, 0, 0], PointStorage=0, CanDoScaling=0, CanDoContouring=0, "
        "CanChangeProfile=0, CanChangeRates=0, SoftLimits=0, MultiTasking=0, AmpFault=0)"
    )
    assert repr(mc.MCSCALE()) == "MCSCALE(Constant=0.0, Offset=0.0, Rate=0.0, Scale=0.0, Zero=0.0, Time=0.0)"


def test_handles() -> None:
    """The version is 4.4.1, 4·65536 + 4·256 + 1; ids are 0 to 15."""
    converse(
        Mcapi.virtual(),
        """
        MCOpen 16 2 - -> -1
        MCOpen -1 2 - -> -1
        MCOpen 15 2 - -> 1
        MCOpen 0 2 - -> 2
        MCOpen 0 3 - -> -5
        MCOpen 0 258 - -> 3
        MCOpen 0 6 - -> -5
        MCGetVersion 1 -> 263169
        MCSetTimeoutEx 1 -1.0 + -> 18
        MCSetTimeoutEx 1 2.0 + -> 0 0.0
        MCSetTimeoutEx 2 0.0 + -> 0 0.0
        MCSetTimeoutEx 1 0.0 + -> 0 2.0
        MCReopen 1 1 -> 0
        pmcputc 1 65 -> 1
        pmcgetc 1 -> 0
        pmcgetc 2 -> 0
        MCGetError 2 -> 5
        MCClose 2 -> 0
        MCGetError 2 -> 13
        """,
    )


def test_a_host_has_a_largest_number_of_handles(monkeypatch: pytest.MonkeyPatch) -> None:
    """The number of a closed handle is used again."""
    monkeypatch.setattr("motionlang_mcapi.session.MAX_HANDLES", 3)
    converse(
        Mcapi.virtual(),
        """
        MCOpen 0 2 - -> 1
        MCOpen 0 2 - -> 2
        MCOpen 0 2 - -> 3
        MCOpen 0 2 - -> -2
        MCClose 2 -> 0
        MCOpen 0 2 - -> 2
        MCOpen 0 2 - -> -2
        """,
    )


def test_registers(host: Mcapi) -> None:
    """Type 2 is an integer of 32 bits, 3 and 4 are floating point."""
    converse(
        host,
        """
        MCSetRegister 1 30 -7 2 -> 0
        MCGetRegister 1 30 + 2 -> 0 -7
        MCGetRegister 1 30 + 3 -> 0 -7.0
        MCGetRegister 1 30 + 4 -> 0 -7.0
        MCGetRegister 1 30 + 1 -> 19
        MCGetRegister 1 30 + 5 -> 19
        MCGetRegister 1 0 + 2 -> 0 -7
        MCGetRegister 1 -1 + 2 -> 18
        MCSetRegister 1 31 2.75 4 -> 0
        MCGetRegister 1 31 + 2 -> 0 2
        MCGetRegister 1 31 + 4 -> 0 2.75
        """,
    )


def test_commands_by_their_codes() -> None:
    """The machine file gives the codes of AL, TR and TP.

    Type 0 is no argument, 1 the value of a register. A reply can be read once; 21 means that there is none.
    """
    host = opened({"mccl.codes.AL": 30, "mccl.codes.TR": 31, "mccl.codes.TP": 32})
    converse(
        host,
        """
        pmccmdex 1 0 30 7 2 -> 0
        pmccmdex 1 0 31 0 2 -> 0
        pmcrpyex 1 + 2 -> 0 7
        pmcrpyex 1 + 2 -> 21
        pmccmdex 1 0 31 5 0 -> 0
        pmcrpyex 1 + 4 -> 0 7.0
        MCSetRegister 1 20 44 2 -> 0
        MCSetRegister 1 21 55 2 -> 0
        pmccmdex 1 0 30 20 1 -> 0
        MCGetRegister 1 0 + 2 -> 0 44
        pmccmdex 1 0 30 2.5 4 -> 0
        MCGetRegister 1 0 + 4 -> 0 2.5
        pmccmdex 1 0 30 2.5 5 -> 19
        pmccmdrpyex 1 2 32 0 + 0 4 -> 0 0.0
        pmccmdrpyex 1 2 32 0 + 0 5 -> 19
        pmccmdrpyex 1 0 30 1 + 2 2 -> 21
        pmccmdex 1 99 30 0 0 -> 15
        pmccmdex 1 0 29 0 0 -> 11
        """,
    )


def test_counts(host: Mcapi) -> None:
    """Contour paths (4) and recorded points (32) are counted here.

    The others are counted only on a board.
    """
    converse(
        host,
        """
        MCGetCount 1 1 4 + -> 0 0
        MCGetCount 1 1 32 + -> 0 0
        MCGetCount 1 1 1 + -> 11
        MCGetCount 1 1 2 + -> 11
        MCGetCount 1 1 8 + -> 11
        MCGetCount 1 1 16 + -> 11
        MCGetCount 1 1 64 + -> 19
        MCGetContouringCount 1 1 -> 0
        """,
    )


def test_blocks(host: Mcapi) -> None:
    """5 to 8 begin a contour path, which needs an axis; 4 discards a block."""
    converse(
        host,
        """
        MCBlockBegin 1 9 0 -> 19
        MCBlockBegin 1 -1 0 -> 19
        MCBlockBegin 1 5 0 -> 17
        MCBlockBegin 1 5 99 -> 15
        MCBlockBegin 1 8 1 -> 0
        MCBlockBegin 1 0 0 -> 26
        MCBlockBegin 1 4 0 -> 0
        MCBlockEnd 1 + -> 26
        MCBlockBegin 1 2 5 -> 0
        MCSetRegister 1 0 6 2 -> 0
        MCGetRegister 1 0 + 2 -> 0 0
        MCBlockEnd 1 + -> 0 0
        MCMacroCall 1 5 -> 0
        MCGetRegister 1 0 + 2 -> 0 6
        MCBlockBegin 1 3 0 -> 0
        MCMacroCall 1 5 -> 18
        """,
    )


@pytest.mark.parametrize(("mode", "kind"), [(5, 0), (6, 1), (7, 2), (8, 3)])
def test_a_block_of_a_contour_path_begins_with_cp(host: Mcapi, mode: int, kind: int) -> None:
    host.BlockBegin(mode, 2)
    host.MoveAbsolute(2, 5.0)
    block = host.board.desk.handles[0].interface.block
    assert block is not None
    assert [each.text for each in (*block.first, *block.commands)] == [f"2CP{kind}", "2MA5"]


# What each function answers after the commands of a host on the other interface.
SETTINGS = [
    ("1PM", "MCGetOperatingMode 1 1 +", "0 2"),
    ("1VM", "MCGetOperatingMode 1 1 +", "0 4"),
    ("1QM", "MCGetOperatingMode 1 1 +", "0 3"),
    ("1GM", "MCGetOperatingMode 1 1 +", "0 1"),
    ("1CM1", "MCGetOperatingMode 1 1 +", "0 0"),
    ("1PT", "MCGetProfile 1 1 +", "0 1"),
    ("1PS", "MCGetProfile 1 1 +", "0 2"),
    ("1PP", "MCGetProfile 1 1 +", "0 4"),
    ("1PH0", "MCGetServoOutputPhase 1 1 +", "0 0"),
    ("1PH1", "MCGetServoOutputPhase 1 1 +", "0 1"),
    ("1IM1", "MCGetModuleInputMode 1 1 +", "0 1"),
    ("1OM1", "MCGetModuleOutputMode 1 1 +", "0 1"),
    ("1SQ3", "MCGetTorque 1 1 +", "0 3.0"),
    ("1SG0.5", "MCGetGain 1 1 +", "0 0.5"),
    ("1VV70", "MCGetVectorVelocity 1 1 +", "0 70.0"),
    ("1VO0.5", "MCGetVelocityOverride 1 1 +", "0 0.5"),
    ("1DH12", "MCGetPositionEx 1 1 +", "0 12.0"),
    ("1DH12", "MCGetOptimalEx 1 1 +", "0 12.0"),
    ("1DH12", "MCGetTargetEx 1 1 +", "0 12.0"),
    ("1MN,1IP50", "MCGetBreakpointEx 1 1 +", "0 50.0"),
    ("1NO", "MCGetBreakpointEx 1 1 +", "0 0.0"),
    ("1AH9", "MCGetAuxEncPosEx 1 1 +", "0 9.0"),
    ("1MN,1MR5000,WA0.1", "MCGetPositionEx 1 1 +", "0 500.0"),
    ("1MN,1MR-5000,1WS", "MCGetVelocityActual 1 1 +", "0 0.0"),
]


@pytest.mark.parametrize(("commands", "call", "wanted"), SETTINGS)
def test_a_value_that_another_host_has_set(host: Mcapi, commands: str, call: str, wanted: str) -> None:
    """After 0.1 s at 100,000 counts/s² an axis is at 500 counts."""
    port = host.board.console.open(echo=False)
    port.feed(commands.encode() + b"\r")
    host.board.console.run_until(lambda: not port.busy, 1.0)
    assert b"?" not in port.take()
    assert ask(host, call) == wanted


STRUCTURES = [
    (
        "FilterConfigEx",
        mc.MCFILTEREX,
        [1.5, 2.5, 3.5, 0, 4.5, 0.0005, 6.5, 7.5, 8.5, 9.5, 10.5, mc.MC_RATE_MEDIUM, 11.0, 0.25, 1.25, 2.25],
        [0.0, 0.0, 0.0, 0, 0.0, 0.00025, 1024.0, 0.0, 0.0, 0.0, 1.0, mc.MC_RATE_HIGH, 0.0, 0.0, 0.0, 0.0],
    ),
    (
        "FilterConfig",
        mc.MCFILTER,
        [1.5, 0.0005, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5],
        [0.0, 0.00025, 0.0, 0.0, 0.0, 0.0, 0.0, 1024.0],
    ),
    (
        "MotionConfig",
        mc.MCMOTION,
        [1000.0, 2000.0, 3000.0, 4.0, 2, 1.5, 5.0, 6.0, 0.7, 2, 2, 11, 7, -8.0, 9.0, 1, mc.MC_RATE_LOW],
        [1e5, 1e5, 4e4, 0.0, 1, 0.0, 10.0, 0.0, 0.0, 1, 1, 0, 0, 0.0, 0.0, 0, mc.MC_RATE_HIGH],
    ),
    ("JogConfig", mc.MCJOG, [1.0, 2.0, 0.3, 4.0, 0.5], [1e5, 0.0, 0.1, 1000.0, 0.0]),
    ("JogConfigEx", mc.MCJOGEX, [1.0, 2.0, 0.3, 4.0, 0.5, 1], [1e5, 0.0, 0.1, 1000.0, 0.0, 1]),
    ("ContourConfig", mc.MCCONTOUR, [1.0, 2.0, 3.0, 0.5], [1e5, 1e5, 4e4, 1.0]),
]


@pytest.mark.parametrize(
    ("name", "structure", "values", "defaults"), STRUCTURES, ids=lambda each: str(each)[:20]
)
def test_the_defaults_of_a_structure_and_its_values_when_set(
    host: Mcapi, name: str, structure: type, values: list[float], defaults: list[float]
) -> None:
    given, found = structure(), structure()
    getattr(host, f"Get{name}")(1, found)
    assert found.values() == defaults
    given.fill(values)
    getattr(host, f"Set{name}")(1, given)
    getattr(host, f"Get{name}")(1, found)
    assert found.values() == values


def in_words(values: Iterable[float]) -> str:
    return " ".join(map(str, values))


# The word and bit of each flag above 30 on a MultiFlex; flags of the primary word have the numbers of their bits.
FLAGS = {
    mc.MC_STAT_FULL_STEP: (1, 0),
    mc.MC_STAT_HALF_STEP: (1, 1),
    mc.MC_STAT_JOGGING: (1, 2),
    mc.MC_STAT_PROG_DIR: (1, 10),
    mc.MC_STAT_RECORD: (1, 12),
    mc.MC_STAT_SYNC: (1, 13),
    mc.MC_STAT_INDEX_FOUND: (1, 15),
    mc.MC_STAT_EDGE_FOUND: (1, 18),
    mc.MC_STAT_ACCEL: (2, 3),
    mc.MC_STAT_STOPPING: (2, 4),
    mc.MC_STAT_MODE_POS: (3, 0),
    mc.MC_STAT_MODE_TRQE: (3, 2),
    mc.MC_STAT_MODE_CNTR: (3, 4),
    mc.MC_STAT_MODE_ARC: (3, 5),
    mc.MC_STAT_MODE_LIN: (3, 6),
    mc.MC_STAT_MODE_SLAVE: (3, 7),
}
PRIMARY = {flag: (0, flag) for flag in range(31)}
AT_TARGET = {mc.MC_STAT_AT_TARGET: (0, 2)}
BITS_OF_MODELS = {
    "multiflex": PRIMARY | AT_TARGET | FLAGS | {mc.MC_STAT_MODE_VEL: (3, 1)},
    "dcx-pci300": PRIMARY | AT_TARGET | FLAGS | {mc.MC_STAT_MODE_VEL: (3, 1)},
    "dcx-at200": PRIMARY | FLAGS,
}


@pytest.mark.parametrize("model", BITS_OF_MODELS)
def test_the_bit_of_each_flag(model: str) -> None:
    """A flag is set by its bit, and by no other.

    Bit 2 of the primary word is velocity mode on the boards before the DCX-PCI300, "at target" on later ones.
    """
    host, bits = opened({"controller.model": model}), BITS_OF_MODELS[model]
    for flag in range(mc.MC_STAT_AUX_IDX_FND + 1):
        word, bit = bits.get(flag, (0, 31))
        only = [(1 << bit) * (word == k) * (flag in bits) for k in range(4)]
        others = [0x7FFFFFFF & ~each for each in only]
        answers = [ask(host, f"MCDecodeStatusEx 1 4 {in_words(words)} {flag}") for words in (only, others)]
        assert (flag, answers) == (flag, ["1" if flag in bits else "0", "0"])
        if not word:
            answers = [ask(host, f"MCDecodeStatus 1 {words[0]} {flag}") for words in (only, others)]
            assert (flag, answers) == (flag, ["1" if flag in bits else "0", "0"])


@pytest.mark.parametrize(("model", "wanted"), [("multiflex", "0 12 1 1 1"), ("dcx-pci100", "0 8 0 0 0")])
def test_the_status_words_of_a_model(model: str, wanted: str) -> None:
    """A motor that is off is at target (4) and its trajectory is complete (8).

    An older board has only the primary word, without "at target".
    """
    assert ask(opened({"controller.model": model}), "MCGetStatusEx 1 1 +") == wanted


@pytest.mark.parametrize("structure", [mc.MCPARAMEX, mc.MCSCALE, mc.MCPARAM])
def test_a_new_structure_has_zeros(structure: type) -> None:
    assert set(structure().values()) == {0}


def test_the_primary_word_has_no_bits_of_other_words(host: Mcapi) -> None:
    """All 31 bits of the primary word are set; flags are 0 to 62."""
    words = [0x7FFFFFFF]
    found = [flag for flag in range(63) if ask(host, f"MCDecodeStatus 1 {in_words(words)} {flag}") == "1"]
    assert found == [0, 1, *range(3, 31), mc.MC_STAT_AT_TARGET]
    converse(
        host,
        """
        MCDecodeStatus 1 1 -1 -> 0
        MCGetError 1 -> 19
        MCDecodeStatus 1 1 63 -> 0
        MCGetError 1 -> 19
        MCDecodeStatus 1 1 62 -> 0
        MCGetError 1 -> 0
        """,
    )


def test_a_recording_is_read_in_any_part(host: Mcapi) -> None:
    """At rest at 7 all points are 7; a reading beyond the 20 points is refused.

    Types are 16 actual, 32 error, 64 optimal, 128 torque, and 0 to 3 for old hosts.
    """
    host.SetPosition(1, 7.0)
    host.CaptureData(1, 20, 0.001, 0.0)
    host.advance(0.1)
    converse(
        host,
        """
        MCGetCaptureData 1 1 16 18 2 + -> 0 7.0 7.0
        MCGetCaptureData 1 1 0 0 1 + -> 0 7.0
        MCGetCaptureData 1 1 64 19 1 + -> 0 7.0
        MCGetCaptureData 1 1 1 0 2 + -> 0 7.0 7.0
        MCGetCaptureData 1 1 32 0 2 + -> 0 0.0 0.0
        MCGetCaptureData 1 1 2 0 2 + -> 0 0.0 0.0
        MCGetCaptureData 1 1 128 0 2 + -> 0 0.0 0.0
        MCGetCaptureData 1 1 3 0 1 + -> 0 0.0
        MCGetCaptureData 1 1 4 0 1 + -> 19
        MCGetCaptureData 1 1 16 18 3 + -> 18
        MCGetCaptureData 1 1 16 -1 1 + -> 18
        MCGetCaptureData 1 1 16 0 0 + -> 18
        MCGetCaptureData 1 2 16 0 1 + -> 18
        MCGetCaptureSettings 1 1 + + + + -> 0 20 0.001 0.0 20
        MCGetCaptureSettings 1 2 + + + + -> 0 0 0.001 0.0 0
        """,
    )


@pytest.mark.parametrize(("stepper", "wanted"), [(False, (252, 1, 1)), (True, (253, 1, 2))])
def test_the_configuration_of_an_axis(stepper: bool, wanted: tuple[int, int, int]) -> None:
    """Records are 16 + 32 + 64 + 128 = 240 of at most 10,000 points.

    A servo has no step rates.
    """
    host = opened({"axis.1.motor": "stepper"} if stepper else {})
    top = 5e6 if stepper else 0.0
    assert ask(host, "MCGetAxisConfiguration 1 1 +") == in_words(
        (0, *wanted, 240, 10_000, 0, 4000.0, 2000.0, 1000.0, 0.0, top, 0.0, top / 8, 0.0, top / 64, 1)
    )


def test_the_loop_rate_of_a_board_without_rates() -> None:
    """A DCX-PC100 has one servo period of 1 ms, so all three rates are 1000 Hz."""
    host = opened({"controller.model": "dcx-pc100"})
    found = mc.MCAXISCONFIG()
    host.GetAxisConfiguration(1, found)
    assert (found.HighRate, found.MediumRate, found.LowRate) == (1000.0, 1000.0, 1000.0)


def test_the_configuration_of_a_multiflex(host: Mcapi) -> None:
    """The parameters of a board with 8 axes.

    Type 9, fractions of gains, 255 channels, 256 points, all abilities, 12 bits for ±10 V, no line mode.
    """
    converse(
        host,
        """
        MCGetConfigurationEx 1 + -> 0 0 9 8 8 8 1 255 255 255 256 1 1 1 1 1 1 1 -10.0 10.0 12 -10.0 10.0 12 1 1 1 0
        MCGetConfiguration 1 + -> 0 0 9 8 255 255 255 1 1 1 1 1 1 1 1 256 1 1 1 1 1 1 1
        """,
    )


def test_calls_of_the_owner_go_first(host: Mcapi) -> None:
    """While a handle has reserved the interface, calls of others wait."""
    session, console = host.board._session, host.board.console
    assert session.call("MCOpen", 0, (0, 2, None)).result == 2
    assert session.call("pmclock", 1, (0,)).result == 0
    other = session.call("MCSetVelocity", 2, (1, 7.0))
    read = session.call("MCGetVelocityEx", 2, (1, 1))
    own = session.call("MCSetVelocity", 1, (1, 5.0))
    console.run(0.1)
    assert (own.done, other.done, read.done) == (True, False, False)
    assert session.call("pmcunlock", 2, ()).done  # not the owner
    console.run(0.2)
    assert not other.done
    session.call("pmcunlock", 1, ())
    console.run(0.3)
    assert (other.done, read.outputs) == (True, (7.0,))
