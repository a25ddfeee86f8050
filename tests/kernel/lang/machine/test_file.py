"""The settings of a machine file or a caller, and the page of its keys."""

from __future__ import annotations

import pytest

import motionlang
from motionlang.kernel import Source, read_machine


def read(text: str) -> dict[str, object]:
    return read_machine(Source("machine.toml", text))


def test_keys_and_tables() -> None:
    settings = read(
        """
[controller]
axes = 4
instruction_time = 5e-6
[axis.0]
travel = [-5, 250.0]
[[input]]
channel = 3
at = 1.5
[[input]]
channel = 4
axis = 0
above = 100.0
"""
    )
    assert settings["controller.axes"] == 4
    assert settings["axis.0.travel"] == [-5, 250.0]
    assert settings["input"] == [{"channel": 3, "at": 1.5}, {"channel": 4, "axis": 0, "above": 100.0}]


def test_tables_of_tables_are_read() -> None:
    text = (
        '[[modbus.server]]\nid = 4\nregisters = { "6" = 1234, "7" = -1 }\n[[modbus.register]]\nserver = 4\n'
    )
    settings = read(text + "register = 8\nvalue = 2.5\nat = 1.0\n")
    assert settings == {
        "modbus.server": [{"id": 4, "registers": {"6": 1234, "7": -1}}],
        "modbus.register": [{"server": 4, "register": 8, "value": 2.5, "at": 1.0}],
    }


def test_an_empty_file_is_all_defaults() -> None:
    assert read("") == {}


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"controller.axis": 4}, "did you mean controller.axes"),
        ({"controller.axes": "four"}, "must be a whole number"),
    ],
)
def test_settings_of_a_caller_are_held_to_the_same_vocabulary(
    settings: dict[str, object], words: str
) -> None:
    with pytest.raises(ValueError, match=words):
        motionlang.run(Source("hello.mnt", "PRINT 1\n"), machine=settings)
