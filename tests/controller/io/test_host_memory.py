"""The memory shared with the host: bits, registers, texts.

The figures are those of ABB AN00198 and AN00200 (mint-2 section 6).
"""

from __future__ import annotations

import math
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.controller.clock import Clock
from motionlang.controller.faults import Rejected
from motionlang.controller.io.host_memory import HostMemory

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


@pytest.mark.parametrize(
    ("area", "element"), [("comms", 0), ("comms", 100), ("netdata", -1), ("netdata", 1000)]
)
def test_elements_that_do_not_exist(area: str, element: int) -> None:
    with pytest.raises(Rejected):
        HostMemory().integer(area, element)


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


def test_which_registers_exist() -> None:
    memory = HostMemory()
    assert not memory.has_registers("comms", 0, 2)
    assert memory.has_registers("comms", 2, 198)
    assert not memory.has_registers("comms", 199, 2)
    assert memory.has_registers("netdata", 0, 2000)
    assert not memory.has_registers("netdata", 1999, 2)


def test_texts_are_packed_first_character_highest() -> None:
    memory = HostMemory()
    memory.set_text("comms", 1, "ABCDEF")
    assert [memory.integer("comms", n) for n in (1, 2)] == [0x41424344, 0x45460000]


@pytest.mark.parametrize(
    ("words", "text"),
    [
        ((0x41424344, 0x45464748, 0x494A7691), "ABCDEFGHIJ"),
        ((0x41424344, 0, 0x494A7691), "ABCD"),
        ((0x41420044, 0x45464748, 0x494A7691), "AB"),
        ((0, 0x45464748, 0x494A7691), ""),
    ],
)
def test_texts_are_read_up_to_a_zero(words: tuple[int, ...], text: str) -> None:
    memory = HostMemory()
    for k, word in enumerate(words):
        memory.set_integer("comms", 1 + k, word)
    assert memory.text("comms", 1, 10) == text


def test_listeners_are_notified_of_host_writes_and_of_changes() -> None:
    memory = HostMemory()
    changes: list[tuple[str, int, bool]] = []
    memory.listeners.append(lambda *what: changes.append(what))
    memory.set_integer("comms", 1, 5)
    memory.write("comms", 1, [5, 6])
    assert changes == [("comms", 1, False), ("comms", 2, True)]


def test_the_machine_file_writes_at_its_time() -> None:
    clock, memory = Clock(), HostMemory()
    memory.schedule(clock, "comms", {"element": 1, "value": 3, "at": 1.0})
    memory.schedule(clock, "netdata", {"element": 2, "value": 3, "at": 1.0})
    memory.schedule(clock, "netdata", {"element": 3, "value": 3, "as": "float"})
    memory.schedule(clock, "comms", {"element": 8, "text": "ABCDE"})
    clock.advance(0.5)
    assert (memory.real("comms", 1), memory.real("netdata", 3), memory.text("comms", 8, 8)) == (
        0.0,
        3.0,
        "ABCDE",
    )
    clock.advance(1.5)
    assert (memory.real("comms", 1), memory.integer("netdata", 2)) == (3.0, 3)
