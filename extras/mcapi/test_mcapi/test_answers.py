"""Answers of a board that a session of `sessions.txt` cannot show: buffers, voltages, bits, and inside."""

from __future__ import annotations

from collections.abc import Iterable

import pytest

import motionlang_mcapi as mc
from motionlang_mcapi import Mcapi
from test_mcapi.conftest import ask, converse, opened


@pytest.mark.parametrize(
    ("volts", "wanted"),
    [(-12.0, 0), (-10.0, 0), (-5.0, 1024), (0.0, 2048), (2.0, 2457), (10.0, 4095), (12.0, 4095)],
)
def test_the_number_of_a_voltage(host: Mcapi, volts: float, wanted: int) -> None:
    """±10 V are 0 to 4095: (V/10 + 1)/2 · 4095; -5 V are 1023.75, 0 V are 2047.5."""
    host.board.console.board.controller.analogue_inputs[1] = 10.0 * volts
    assert host.GetAnalogEx(1) == wanted


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


@pytest.mark.parametrize(("mode", "kind"), [(5, 0), (6, 1), (7, 2), (8, 3)])
def test_a_block_of_a_contour_path_begins_with_cp(host: Mcapi, mode: int, kind: int) -> None:
    host.BlockBegin(mode, 2)
    host.MoveAbsolute(2, 5.0)
    block = host.board.desk.handles[0].interface.block
    assert block is not None
    assert [each.text for each in (*block.first, *block.commands)] == [f"2CP{kind}", "2MA5"]


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


@pytest.mark.parametrize("structure", [mc.MCPARAMEX, mc.MCSCALE, mc.MCPARAM])
def test_a_new_structure_has_zeros(structure: type) -> None:
    assert set(structure().values()) == {0}


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
