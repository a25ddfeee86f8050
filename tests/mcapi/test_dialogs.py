"""MCDLG without its dialogs: save and restore an axis, download a file."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang import mcapi as mc
from motionlang.mcapi import Mcapi, McapiException
from tests.mcapi.conftest import opened

SET = "1US40,1UR60,1UO1.5,UT2,1MN,1MF,1SA123.25,1DS99.5,1SV17.125,1SG0.3,1SE77,1LM6,1LN3,1HL9.5,1LL-3.25,1PS,1PH1,1DI1"


def saved(host: Mcapi, path: Path, axis: int = 0, flags: int = 0) -> str:
    host.SaveAxis(axis, flags, str(path))
    return path.read_text(encoding="latin-1")


def test_a_restored_board_is_the_saved_one(tmp_path: Path) -> None:
    """After the restore all axes of a new board have exactly the saved settings."""
    host = opened()
    port = host.board.console.open(echo=False)
    port.feed(SET.encode() + b"\r")
    host.advance(0.1)
    host.SetPosition(1, 33.125)
    first = saved(host, tmp_path / "first.ini")
    assert "Velocity = 17.125\n" in first
    assert "Position = 33.125\n" in first
    assert "[Axis 8]\n" in first
    fresh = opened()
    assert saved(fresh, tmp_path / "fresh.ini") != first
    fresh.RestoreAxis(0, 0, str(tmp_path / "first.ini"))
    assert saved(fresh, tmp_path / "second.ini") == first
    assert fresh.GetPositionEx(1) == 33.125


def test_flags_leave_groups_out(tmp_path: Path) -> None:
    text = saved(opened(), tmp_path / "a.ini", 1, 2 | 4 | 8 | 16 | 32)
    assert text == "[Axis 1]\nProfile = 1\n"


def test_only_the_section_of_an_axis_is_read(tmp_path: Path) -> None:
    """A line without a number, and what comes before the section, is not of the axis."""
    host = opened()
    (tmp_path / "a.ini").write_text(
        "; saved\n[General]\nPhase = 0\n[Axis]\n[Axis 1\n[Axis 1]\nPhase = 1\n[Axis 2]\nPhase = 0\n"
    )
    host.RestoreAxis(1, 0, str(tmp_path / "a.ini"))
    assert [host.GetServoOutputPhase(axis) for axis in (1, 2)] == [1, 0]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", mc.MCERR_NOT_FOUND),
        ("[Axis 2]\nVelocity = 5\n", mc.MCERR_NOT_FOUND),
        ("[Axis 1]\nVelocity = fast\n", mc.MCERR_RANGE),
        ("[Axis 1]\nVelocity = nan\n", mc.MCERR_RANGE),
        ("[Axis 1]\nVelocity = -1\n", mc.MCERR_RANGE),
        (
            "[Axis 1]\nHardLimitMode = 12\nSoftLimitMode = 0\nSoftLimitLow = 0\nSoftLimitHigh = 0\n",
            mc.MCERR_CONSTANT,
        ),
    ],
)
def test_a_file_that_does_not_fit(tmp_path: Path, text: str, code: int) -> None:
    host = opened()
    (tmp_path / "a.ini").write_text(text, encoding="latin-1")
    with pytest.raises(McapiException) as caught:
        host.RestoreAxis(1, 0, str(tmp_path / "a.ini"))
    assert caught.value.code == code
    assert host.GetVelocityEx(1) == 40_000.0


def test_a_field_without_a_command_is_left_out_on_restore(tmp_path: Path) -> None:
    """The settings of a MultiFlex are restored on a DCX-PCI100 as far as it has them."""
    host = opened()
    host.SetVelocity(1, 555.0)
    saved(host, tmp_path / "a.ini", 1)
    other = opened({"controller.model": "dcx-pci100"})
    other.RestoreAxis(1, 0, str(tmp_path / "a.ini"))
    assert other.GetVelocityEx(1) == 555.0


def test_a_file_is_carried_out_line_by_line(tmp_path: Path) -> None:
    """A macro ends with its line, and a wait delays the next line.

    A rejected command ends the download.
    """
    host = opened()
    file = tmp_path / "a.mcl"
    file.write_text("MD1,AL5\n; a remark\nMC1,AR20\n1MN,1MR5000,1WS\n1MR1000,1WS\n", encoding="latin-1")
    host.DownloadFile(str(file))
    assert host.GetRegister(20, mc.MC_TYPE_LONG) == 5
    assert host.GetPositionEx(1) == 6000.0
    file.write_text("1SV7\nXX\n1SV8\n", encoding="latin-1")
    with pytest.raises(McapiException):
        host.DownloadFile(str(file))
    assert host.GetVelocityEx(1) == 7.0
    file.write_text("; nothing\n", encoding="latin-1")
    host.DownloadFile(str(file))


# The flag that leaves a group out, and the fields of the group.
GROUPS = {
    2: {"Velocity", "HardLimitMode", "SoftLimitHigh", "Direction"},
    4: {"Gain", "FollowingError"},
    8: {"Phase"},
    16: {"Position"},
    32: {"Scale", "Rate", "Time"},
    512: {"Profile"},
}


def fields(host: Mcapi, path: Path, flags: int = 0) -> dict[str, str]:
    """Return the saved fields of axis 1."""
    lines = saved(host, path, 1, flags).splitlines()[1:]
    return dict(line.split(" = ") for line in lines)


@pytest.mark.parametrize("flag", GROUPS)
def test_a_flag_leaves_its_group_out(tmp_path: Path, flag: int) -> None:
    """On saving, the fields are not written; on restoring, they are not changed."""
    host, fresh = opened(), opened()
    port = host.board.console.open(echo=False)
    port.feed((SET if flag == 32 else SET.partition("1MF,")[2]).encode() + b"\r")
    host.advance(0.1)
    host.SetPosition(1, 33.125)
    whole, before = fields(host, tmp_path / "a.ini"), fields(fresh, tmp_path / "b.ini")
    left_out = set(whole) - set(fields(host, tmp_path / "c.ini", flag))
    assert GROUPS[flag] <= left_out
    assert not any(group & left_out for other, group in GROUPS.items() if other != flag)
    fresh.RestoreAxis(1, flag, str(tmp_path / "a.ini"))
    after = fields(fresh, tmp_path / "d.ini")
    assert {name: after[name] for name in left_out} == {name: before[name] for name in left_out}
    if flag != 32:  # without the units, positions and speeds have other numbers
        assert after == whole | {name: before[name] for name in left_out}


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("Velocity", "5.0"),
        ("Gain", "0.5"),
        ("Phase", "1"),
        ("Profile", "4"),
        ("Position", "7.0"),
        ("Profile", "1"),
    ],
)
def test_a_file_with_one_field_changes_that_field(tmp_path: Path, name: str, value: str) -> None:
    host = opened()
    before = fields(host, tmp_path / "a.ini")
    (tmp_path / "b.ini").write_text(f"[Axis 1]\n{name} = {value}\n", encoding="latin-1")
    host.RestoreAxis(1, 0, str(tmp_path / "b.ini"))
    assert fields(host, tmp_path / "c.ini") == before | {name: value}


def test_units_are_restored_on_an_axis_that_stays_on(tmp_path: Path) -> None:
    """New units take effect when an axis is switched on, so it is switched off and on.

    An axis that was off is off afterwards. The same units change nothing.
    """
    host = opened()
    host.board.console.open(echo=False).feed(b"1US40,1MN,1MF\r")
    host.advance(0.1)
    saved(host, tmp_path / "a.ini", 1)
    for enabled in (False, True):
        other = opened()
        other.EnableAxis(1, enabled)
        for _ in range(2):
            other.RestoreAxis(1, 0, str(tmp_path / "a.ini"))
            assert fields(other, tmp_path / "b.ini")["Scale"] == "40.0"
            assert other.DecodeStatus(other.GetStatus(1), mc.MC_STAT_MTR_ENABLE) == enabled
