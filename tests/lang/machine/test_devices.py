"""The machine file for other devices: servers, nodes, buses, ports, terminals.

Every error has its line.
"""

from __future__ import annotations

import pytest

from motionlang.errors import ProgramError
from motionlang.lang.machine.file import read_machine
from motionlang.source import Source

MISTAKES = [
    ('[[modbus.server]]\nid = 4\nregisters = { "x" = 1 }', 3, 'registers of [[modbus.server]] must be registers with '
     "16-bit values, such as { \"6\" = 1234 }, not {'x': 1}"),
    ("[[modbus.server]]\nfirst = 3", 1, "[[modbus.server]] needs id"),
    ("[[modbus.server]]\nid = 4\nfirst = 70000", 3, "first of [[modbus.server]] must be 0 to 65535, whole, not 70000"),
    ("[[modbus.server]]\nid = 4\nfirst = 9\nlast = 3", 4, "[[modbus.server]] has its last register before the first"),
    ('[[modbus.register]]\nserver = 4\nregister = 6\nvalue = 1\nas = "double"', 5,
     "as of [[modbus.register]] must be one of word, integer, float, not 'double'"),
    ("[[remote]]\nnode = 2", 1,
     "[[remote]] needs a channel, an analogue, an encoder, an element, an object or an event"),
    ("[[remote]]\nnode = 2\nchannel = 1\nelement = 5", 1,
     "[[remote]] needs a channel, an analogue, an encoder, an element, an object or an event"),
    ("[[remote]]\nnode = 2\nelement = 100", 3, "element of [[remote]] must be 1 to 99, not 100"),
    ("[[remote]]\nnode = 300\nchannel = 0", 2, "node of [[remote]] must be a whole number from 0 to 255, not 300"),
    ("[[remote]]\nbus = 3\nnode = 2\nchannel = 0", 2, "bus of [[remote]] must be 1 or 2, not 3"),
    ('[[remote]]\nnode = 2\nevent = "died"', 3, "event of [[remote]] must be one of live, dead, emergency, not 'died'"),
    ('[[remote]]\nnode = 2\nevent = "dead"\nfor = 1.0', 4, "[[remote]] with event takes no for"),
    ('[[bus]]\nevent = "on"', 2, "event of [[bus]] must be one of operational, passive, off, receive-overrun, "
     "transmit-overrun, not 'on'"),
    ("[[pdo]]\ncobid = 0x182\nvalue = 1\nbank = 2", 4, "bank of [[pdo]] must be 0 or 1, not 2"),
    ('[[serial]]\ntext = "a"\nport = 9', 3, "port of [[serial]] must be a whole number from 1 to 8, not 9"),
    ('[[key]]\ntext = "a"\nterminal = 3', 3, "terminal of [[key]] must be 1, 2, 4, 8, 16, 32, 64 or 128, not 3"),
    ('[controller]\nmodel = "NextMove ESP"', 2, "'NextMove ESP' is not a known controller"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "line", "message"), MISTAKES, ids=[text.split("\n")[0] for text, _, _ in MISTAKES]
)
def test_mistake_is_reported_on_its_line(text: str, line: int, message: str) -> None:
    with pytest.raises(ProgramError) as error:
        read_machine(Source("machine.toml", text))
    assert [(each.line, each.message) for each in error.value.diagnostics] == [(line, message)]


def test_tables_of_tables_are_read() -> None:
    text = (
        '[[modbus.server]]\nid = 4\nregisters = { "6" = 1234, "7" = -1 }\n[[modbus.register]]\nserver = 4\n'
    )
    settings = read_machine(Source("machine.toml", text + "register = 8\nvalue = 2.5\nat = 1.0\n"))
    assert settings == {
        "modbus.server": [{"id": 4, "registers": {"6": 1234, "7": -1}}],
        "modbus.register": [{"server": 4, "register": 8, "value": 2.5, "at": 1.0}],
    }
