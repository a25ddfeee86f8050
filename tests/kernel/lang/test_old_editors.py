"""Characters of old editors: form feeds, DOS file ends, typographic quotes."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang import run
from motionlang.client import Client
from motionlang.commands.check import check
from motionlang.kernel import Source, dialect_for

MINT = b"SPEED(0) = 50\x0c\r\n\x0cMOVER(0) = \x0c5 : GO(0)\r\nPAUSE\x0cIDLE(0)\r\n\x0c\r\nPRINT POS(0)\r\n\x1aOLD (\x1a"
MCCL = b"1MN\x0c\r\n\x0c1MR5,\x0c1WS0\r\n\x0c\r\n1TP\r\n\x1a1TP\r\n\x1a"


@pytest.mark.parametrize(("name", "data", "output"), [("a.mnt", MINT, ["5.0000"]), ("a.mcl", MCCL, ["01 5"])])
def test_form_feeds_are_blanks_and_the_text_ends_at_its_mark(
    name: str, data: bytes, output: list[str], tmp_path: Path
) -> None:
    """Form feeds may be between words, at line ends or on a line of their own; the old sector behind is not read."""
    (tmp_path / name).write_bytes(data)
    made = run(tmp_path / name)
    assert (made.status, made.output, made.diagnostics) == ("ended", output, [])
    plain = data.replace(b"\x0c", b" ").partition(b"\x1a")[0]
    assert run(Source.from_bytes(name, plain)).report == made.report


def test_a_form_feed_in_a_string_is_sent() -> None:
    assert run(Source("a.mnt", 'PRINT "page\x0c", "\x1a" \x0c\n')).output == ["page\x0c\x1a"]


def test_a_client_downloads_such_a_file() -> None:
    with Client.virtual() as board:
        assert board.download(MCCL.decode("latin-1")) == ["01 5"]


@pytest.mark.parametrize(
    ("name", "data", "message"),
    [
        ("a.mnt", b"PRINT \x93on\x94\n", '“ is a typographic quote, not a plain "'),
        ("a.mcl", b"1MR\x96200\n", "– is a typographic dash, not a plain - (?2: bad command format)"),
    ],
)
def test_typographic_characters_of_windows_are_named(name: str, data: bytes, message: str) -> None:
    """An editor that writes UTF-8 could not replace them."""
    source = Source.from_bytes(name, data)
    found = check(dialect_for(source, None).program(source))
    assert (1, message, "") in [(each.line, each.message, each.fix) for each in found]
