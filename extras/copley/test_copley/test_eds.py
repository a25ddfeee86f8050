"""The EDS file, read as the INI file that CiA 306 describes."""

from __future__ import annotations

from configparser import RawConfigParser

import pytest

from motionlang import __version__
from motionlang_copley.eds import eds


@pytest.fixture
def file() -> RawConfigParser:
    """The file; this parser refuses a key that occurs twice, in whatever case."""
    parser = RawConfigParser()
    parser.read_string(eds())
    return parser


def test_the_file_states_one_version_of_its_format(file: RawConfigParser) -> None:
    information = file["FileInfo"]
    assert (information["EDSVersion"], information["FileVersion"], information["FileRevision"]) == (
        "4.0",
        "1",
        "1",
    )


def test_what_the_device_is_and_can(file: RawConfigParser) -> None:
    """It boots as a slave, has four PDOs in each direction, and maps whole bytes."""
    rates = {10: 0, 20: 0, 50: 0, 125: 1, 250: 1, 500: 1, 800: 0, 1000: 1}
    expected = {
        "VendorName": "motionlang",
        "VendorNumber": 0,
        "ProductName": "motionlang virtual drive",
        "ProductNumber": 0,
        "RevisionNumber": 0x10000,
        "OrderCode": "virtual",
        "SimpleBootUpMaster": 0,
        "SimpleBootUpSlave": 1,
        "Granularity": 8,
        "NrOfRXPDO": 4,
        "NrOfTXPDO": 4,
        "LSS_Supported": 0,
        **{f"BaudRate_{rate}": supported for rate, supported in rates.items()},
    }
    assert dict(file["DeviceInfo"]) == {name.lower(): str(value) for name, value in expected.items()}


# Speeds are in 0.1 counts/s and rates in 10 counts/s²: 10 000 counts/s and 100 000 counts/s², and for homing
# 5000 and 500 counts/s. The interpolation time is 1 × 10⁻³ s.
DEFAULTS = {
    "1000": 0x00020192, "1001": 0, "1005": 0x80, "1017": 0, "1016sub0": 1, "1016sub1": 0,
    "1018sub0": 4, "1018sub1": 0, "1018sub2": 0, "1018sub3": 0x10000, "1018sub4": 0,
    "6040": 0, "605A": 2, "6060": 0, "607A": 0, "607C": 0, "6081": 100_000, "6083": 10_000, "6084": 10_000,
    "6086": 0, "6098": 0, "6099sub0": 2, "6099sub1": 50_000, "6099sub2": 5000, "609A": 10_000,
    "60C0": 0, "60C1sub0": 3, "60C1sub1": 0, "60C1sub2": 0, "60C1sub3": 0,
    "60C2sub0": 2, "60C2sub1": 1, "60C2sub2": -3, "60FF": 0,
}  # fmt: skip


def test_values_at_power_up(file: RawConfigParser) -> None:
    assert {section: int(file[section]["DefaultValue"], 0) for section in DEFAULTS} == DEFAULTS


def test_values_are_hexadecimal_if_they_are_not_negative(file: RawConfigParser) -> None:
    assert [file[section]["DefaultValue"] for section in ("6040", "60C2sub1", "60C2sub2")] == [
        "0x00",
        "0x01",
        "-3",
    ]


def test_identifiers_count_from_the_node(file: RawConfigParser) -> None:
    """Bit 31 disables the PDOs 2 to 4 of each direction."""
    assert file["1014"]["DefaultValue"] == "$NODEID+0x80"
    shown = [
        file[f"{index:X}sub1"]["DefaultValue"]
        for first in (0x1400, 0x1800)
        for index in range(first, first + 4)
    ]
    assert shown == [
        "$NODEID+0x200", "$NODEID+0x80000300", "$NODEID+0x80000400", "$NODEID+0x80000500",
        "$NODEID+0x180", "$NODEID+0x80000280", "$NODEID+0x80000380", "$NODEID+0x80000480",
    ]  # fmt: skip


# The types of CiA 301: 2 to 4 are signed, 5 to 7 unsigned, 9 is text and 10 bytes. The last number is 1 if a PDO can
# carry the object.
TYPES = {
    "1001": (0x5, "ro", 1), "1000": (0x7, "ro", 0), "1008": (0x9, "const", 0), "1017": (0x6, "rw", 0),
    "2010": (0xA, "wo", 1), "2011": (0x6, "ro", 1), "2012": (0x7, "ro", 1), "6040": (0x6, "rw", 1),
    "6060": (0x2, "rw", 1), "6064": (0x4, "ro", 1), "6099sub1": (0x7, "rw", 1), "60C0": (0x3, "rw", 1),
    "60C1sub2": (0x5, "rw", 1),
}  # fmt: skip


# The objects of CiA 301 and the records of DS402, as the standards call them.
NAMES = {
    "1000": "Device type", "1001": "Error register", "1005": "COB-ID SYNC", "1008": "Manufacturer device name",
    "1009": "Manufacturer hardware version", "100A": "Manufacturer software version", "1014": "COB-ID EMCY",
    "1016": "Consumer heartbeat time", "1017": "Producer heartbeat time", "1018": "Identity object",
    "1018sub0": "Highest sub-index", "1018sub4": "Serial number", "1400": "Receive PDO 1 communication",
    "1603": "Receive PDO 4 mapping", "1802": "Transmit PDO 3 communication", "1A01": "Transmit PDO 2 mapping",
    "6099": "Homing speed search for", "6099sub1": "Homing speed search for switch",
    "60C1": "Interpolation", "60C1sub2": "Interpolation time", "60C2": "Interpolation time",
}  # fmt: skip


def test_names(file: RawConfigParser) -> None:
    assert {section: file[section]["ParameterName"] for section in NAMES} == NAMES
    assert (file["1008"]["DefaultValue"], file["1009"]["DefaultValue"], file["100A"]["DefaultValue"]) == (
        "motionlang virtual drive",
        "virtual",
        __version__,
    )


def test_data_types_and_access(file: RawConfigParser) -> None:
    entries = {section: file[section] for section in TYPES}
    shown = {
        section: (int(entry["DataType"], 0), entry["AccessType"], int(entry["PDOMapping"], 0))
        for section, entry in entries.items()
    }
    assert shown == TYPES
