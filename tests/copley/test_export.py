"""Exported frames, sent to a drive."""

from __future__ import annotations

import pytest

from motionlang.copley.bus import LockstepBus
from motionlang.copley.drive import Drive
from motionlang.copley.export import FORMATS, LATER, Unwritable, export, sdo_download
from motionlang.copley.point import WirePoint, to_wire
from motionlang.planners.pvt.scurve import scurve

SCURVE = to_wire(scurve(1000.0, 0.1))


@pytest.mark.parametrize("form", list(FORMATS))
def test_what_is_written_reads_back_as_the_same_points(form: str) -> None:
    assert export(SCURVE, form).read_back == SCURVE


@pytest.mark.parametrize("form", ["pdo", "sdo", "record"])
@pytest.mark.parametrize("node", [1, 42])
def test_the_frames_move_a_drive(form: str, node: int) -> None:
    """Every exported frame is sent on the bus, and the drive executes the S-curve."""
    drive = Drive()
    with LockstepBus(drive, node) as bus:
        for line in export(SCURVE, form, node).lines:
            if not line.startswith("#"):
                can_id, data = line.split("#")
                bus.network.send_message(int(can_id, 16), bytes.fromhex(data))
    drive.run_until(500_000)
    assert drive.log == [(0.0, "move started at 0"), (0.4, "move ended at 1000")]
    assert [p.end for p in drive.profiles if p.shape == "pvt"] == [83, 500, 917, 1000]


def test_serial_words() -> None:
    assert export(SCURVE, "serial").lines == [
        "# parameter 0xC8 = 3: PVT interpolation",
        "# parameter 0x115, one point per line: time word, position, velocity",
        "0064 00000000 00000000",
        "0064 00000053 000061A8",
        "0064 000001F4 0000C350",
        "0064 00000395 000061A8",
        "0000 000003E8 00000000",
        "# op-code 17: start move",
    ]


def test_long_moves_start_when_the_buffer_is_full() -> None:
    points = [WirePoint(n, 0, 5) for n in range(99)] + [WirePoint(99, 0, 0)]
    lines = export(points, "pdo").lines
    start = lines.index("# start")
    data = [line for line in lines if line.startswith("201#")]
    assert len(data) == 100
    assert len([line for line in lines[:start] if line.startswith("201#")]) == 32
    assert LATER in lines[start:]
    serial = export(points, "serial").lines
    assert serial.index("# op-code 17: start move") == 2 + 32


def test_objects_of_every_size() -> None:
    assert sdo_download(1, 0x6060, 0, b"\x07") == ["601#2F60600007000000"]
    assert sdo_download(1, 0x60C0, 0, b"\xfd\xff") == ["601#2BC06000FDFF0000"]
    assert sdo_download(1, 0x60C1, 1, bytes(4)) == ["601#23C1600100000000"]
    assert sdo_download(1, 0x2010, 0, bytes(range(8))) == [
        "601#2110200008000000",
        "601#0000010203040506",
        "601#1D07000000000000",
    ]


@pytest.mark.parametrize(
    ("points", "form", "message"),
    [
        ([WirePoint(0, None, 10), WirePoint(5, 0, 0)], "record", "point 0: .* no linear points"),
        ([WirePoint(0, 0, 10), WirePoint(5, 0, 0, True)], "record", "point 1: .* no relative points"),
        ([WirePoint(0, 0, 10), WirePoint(2**30, 0, 0)], "pdo", "point 1: neither"),
    ],
)
def test_what_a_format_cannot_hold_is_refused(points: list[WirePoint], form: str, message: str) -> None:
    with pytest.raises(Unwritable, match=message):
        export(points, form)


def test_velocities_beyond_24_bits_are_read_back_rounded() -> None:
    points = [WirePoint(0, 0, 10), WirePoint(5000, 9_000_049, 10), WirePoint(9000, 0, 0)]
    assert export(points, "pdo").read_back[1] == WirePoint(5000, 9_000_000, 10)
