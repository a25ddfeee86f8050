"""The memory shared with the host: bits, registers, texts.

The figures are those of ABB AN00198 and AN00200 (mint-2 section 6).
"""

from __future__ import annotations

import math
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.kernel import Controller, Rejected
from motionlang.kernel.controller import HostMemory, product
from tests.cases import cases

words = st.integers(-(2**31), 2**31 - 1)


def test_the_vendors_trick_a_float_from_its_bits() -> None:
    memory = HostMemory()
    memory.set_integer("netdata", 999, 0x40490FDB)
    assert memory.real("netdata", 999) == pytest.approx(3.1415927, abs=1e-7)


@given(words)
def test_both_views_share_every_bit(word: int) -> None:
    memory = HostMemory()
    memory.set_integer("comms", 7, word)
    (value,) = struct.unpack("<f", struct.pack("<i", word))
    assert memory.real("comms", 7) == value or math.isnan(value)


def test_a_number_too_large_for_a_float_is_infinite() -> None:
    memory = HostMemory()
    memory.set_real("comms", 1, -1e39)
    assert memory.integer("comms", 1) == 0xFF800000 - (1 << 32)


def test_element_n_is_registers_2n_and_2n_plus_1_low_word_first() -> None:
    memory = HostMemory()
    memory.set_integer("netdata", 3, 0x12345678)
    assert memory.registers("netdata", 6, 2) == [0x5678, 0x1234]
    memory.set_real("netdata", 2, 1.0)
    assert memory.registers("netdata", 4, 2) == [0x0000, 0x3F80]


def test_registers_written_one_half_at_a_time_keep_the_other_half() -> None:
    memory = HostMemory()
    memory.write_registers("netdata", 7, [0x89AB])
    memory.write_registers("netdata", 6, [0xCDEF])
    assert memory.integer("netdata", 3) == 0x89ABCDEF - (1 << 32)
    memory.write_registers("netdata", 7, [1, 2, 3, 4])
    assert [memory.integer("netdata", n) for n in (3, 4, 5)] == [0x0001CDEF, 0x00030002, 4]


@given(st.integers(2, 190), st.lists(st.integers(0, 0xFFFF), min_size=1, max_size=8))
def test_what_is_written_to_registers_is_read_from_them(first: int, values: list[int]) -> None:
    memory = HostMemory()
    memory.write_registers("comms", first, values)
    assert memory.registers("comms", first, len(values)) == values


def test_listeners_are_notified_of_host_writes_and_of_changes() -> None:
    memory = HostMemory()
    changes: list[tuple[str, int, bool]] = []
    memory.listeners.append(lambda *what: changes.append(what))
    memory.set_integer("comms", 1, 5)
    memory.write("comms", 1, [5, 6])
    assert changes == [("comms", 1, False), ("comms", 2, True)]


def test_the_machine_file_writes_at_its_time() -> None:
    controller, memory = Controller(1), HostMemory()
    clock = controller.clock
    memory.schedule(controller, "comms", {"element": 1, "value": 3, "at": 1.0})
    memory.schedule(controller, "netdata", {"element": 2, "value": 3, "at": 1.0})
    memory.schedule(controller, "netdata", {"element": 3, "value": 3, "as": "float"})
    memory.schedule(controller, "comms", {"element": 8, "text": "ABCDE"})
    clock.advance(0.5)
    assert (memory.real("comms", 1), memory.real("netdata", 3)) == (0.0, 3.0)
    assert [memory.integer("comms", n) for n in (8, 9)] == [0x41424344, 0x45000000]
    clock.advance(1.5)
    assert (memory.real("comms", 1), memory.integer("netdata", 2)) == (3.0, 3)


@cases("area, first, last", [("comms", 1, 99), ("netdata", 0, 999)])
def test_the_first_and_the_last_element_of_each_area(area: str, first: int, last: int) -> None:
    memory = HostMemory()
    for element in (first, last):
        memory.set_integer(area, element, element - 5)
        assert memory.integer(area, element) == element - 5
        assert memory.has_registers(area, 2 * element, 2)
    for element in (first - 1, last + 1):
        with pytest.raises(Rejected) as rejected:
            memory.integer(area, element)
        assert rejected.value.hint.endswith(f" are {first} to {last}")
        assert not memory.has_registers(area, 2 * element, 2)
    assert not memory.has_registers(area, 2 * last, 3)
    assert memory.has_registers(area, 2 * first, 2 * (last - first + 1))


@cases(
    "value, read",
    [
        (3.4028234663852886e38, 3.4028234663852886e38),
        (math.nextafter(3.4028235677973366e38, 0.0), 3.4028234663852886e38),
        (3.4028235677973366e38, math.inf), (-3.4028235677973366e38, -math.inf), (math.inf, math.inf),
        (-math.inf, -math.inf), (0.0, 0.0), (-1.5, -1.5),
    ],
)  # fmt: skip
def test_numbers_beyond_the_largest_float_of_32_bits_are_infinite(value: float, read: float) -> None:
    memory = HostMemory()
    memory.set_real("comms", 1, value)
    assert memory.real("comms", 1) == read


def test_no_number_stays_no_number() -> None:
    memory = HostMemory()
    memory.set_real("comms", 1, math.nan)
    assert math.isnan(memory.real("comms", 1))


@cases(
    "model, name",
    [
        ("", "e100"), ("NextMove e100", "e100"), ("NextMove ES", "es"), ("NextMove ESB-2", "es"),
        ("MicroFlex e150", "e150"),
        ("MotiFlex e180", "e180"), ("e190", "e190"), ("MicroFlex e190-3A", "e190"), ("other", "e100"),
    ],
)  # fmt: skip
def test_products_by_the_names_of_models(model: str, name: str) -> None:
    assert product(model) == name


def test_registers_from_an_odd_one_to_an_even_one_change_two_halves() -> None:
    memory = HostMemory()
    for element in (3, 4, 5):
        memory.set_integer("netdata", element, -1)
    memory.write_registers("netdata", 7, [0x8000, 0x7FFF])
    assert [memory.integer("netdata", n) for n in (2, 3, 4, 5)] == [
        0,
        0x8000FFFF - (1 << 32),
        0xFFFF7FFF - (1 << 32),
        -1,
    ]
    assert memory.registers("netdata", 7, 3) == [0x8000, 0x7FFF, 0xFFFF]
