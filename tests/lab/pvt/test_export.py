"""Exported words and frames."""

from __future__ import annotations

import pytest

from motionlang.lab.pvt.drive.point import WirePoint, to_wire
from motionlang.lab.pvt.export import FORMATS, LATER, Unwritable, export, sdo_download
from motionlang.lab.pvt.scurve import scurve

SCURVE = to_wire(scurve(1000.0, 0.1))


@pytest.mark.parametrize("form", list(FORMATS))
def test_what_is_written_reads_back_as_the_same_points(form: str) -> None:
    assert export(SCURVE, form).read_back == SCURVE


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


# Node 42 operational, mode 7 in 6060, sub-mode -3 in 60C0, and 6, 7 and 15 in the control word 6040.
PROLOGUE = [
    "# node operational, interpolated position mode, sub-mode",
    "000#012A",
    "62A#2F60600007000000",
    "62A#2BC06000FDFF0000",
    "# shutdown, switch on, enable operation",
    "62A#2B40600006000000",
    "62A#2B40600007000000",
    "62A#2B4060000F000000",
]
# Each PDO is disabled (bit 31), gets the type 255, and is mapped to one object: 2010 of 64 bits, 2012 of 32.
PDOS = [
    "# PDO 1: object 0x2010 in, object 0x2012 out on every event",
    "62A#230014012A020080",
    "62A#2F001402FF000000",
    "62A#2F00160000000000",
    "62A#2300160140001020",
    "62A#2F00160001000000",
    "62A#230014012A020000",
    "62A#23001801AA010080",
    "62A#2F001802FF000000",
    "62A#2F001A0000000000",
    "62A#23001A0120001220",
    "62A#2F001A0001000000",
    "62A#23001801AA010000",
]
START = ["# start", "62A#2B4060001F000000"]
# 5 counts and 7 counts/s in 10 ms, then 0 and 0.
BY_PDO = ["22A#000A050000460000", "22A#0100000000000000"]
BY_SDO = [
    "62A#2110200008000000", "62A#00000A0500004600", "62A#1D00000000000000",
    "62A#2110200008000000", "62A#0001000000000000", "62A#1D00000000000000",
]  # fmt: skip
RECORDS = [
    "62A#23C1600105000000", "62A#2FC160020A000000", "62A#23C1600346000000",
    "62A#23C1600100000000", "62A#2FC1600200000000", "62A#23C1600300000000",
]  # fmt: skip


@pytest.mark.parametrize(
    ("form", "lines"),
    [
        ("pdo", [*PROLOGUE, *PDOS, "# the buffer filled", *BY_PDO, *START]),
        ("sdo", [*PROLOGUE, "# the buffer filled", *BY_SDO, *START]),
        ("record", [*PROLOGUE, "# the buffer filled", *RECORDS, *START]),
        ("csv", ["position,velocity,time", "5,7,10", "0,0,0"]),
    ],
)
def test_all_lines_of_a_move_of_two_points(form: str, lines: list[str]) -> None:
    assert export([WirePoint(5, 70, 10), WirePoint(0, 0, 0)], form, 42).lines == lines


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
    assert sdo_download(1, 0x2010, 0, bytes(range(5))) == ["601#2110200005000000", "601#0500010203040000"]
    assert sdo_download(1, 0x2010, 0, bytes(range(7))) == ["601#2110200007000000", "601#0100010203040506"]


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


def test_relative_points_and_far_positions_are_read_back() -> None:
    """The first position, beyond 24 bits, is an initial position and a distance of 0."""
    points = [
        WirePoint(9_000_000, 0, 10),
        WirePoint(5, 20, 10, relative=True),
        WirePoint(-5, 0, 0, relative=True),
    ]
    assert export(points, "pdo").read_back == points
