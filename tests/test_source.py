"""Any file content becomes text, in the encodings of editors or in no encoding."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.source import Source

TEXT = 'Print "é"\nPrint 2\n'


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "latin-1"])
@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"])
def test_an_encoding_is_recognised(encoding: str, line_end: str) -> None:
    data = TEXT.replace("\n", line_end).encode(encoding)
    assert Source.from_bytes("x.mnt", data).text == TEXT


def test_a_mark_decides() -> None:
    assert Source.from_bytes("x.mnt", b"\xfe\xff" + TEXT.encode("utf-16-be")).text == TEXT
    assert Source.from_bytes("x.mnt", b"\xff\xfea\0b").text == "a\ufffd"


@pytest.mark.parametrize("data", [b"", b"\0\0\0\0", b"a\0", b"ab\0\0cd", b"x = 1\0\0"])
def test_bytes_that_are_no_wide_text_stay_bytes(data: bytes) -> None:
    wide = data == b"a\0"
    assert Source.from_bytes("x.mnt", data).text == ("a" if wide else data.decode())


def test_a_file_without_an_end_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Examples are /dev/zero, and a pipe whose writer never closes it."""
    monkeypatch.setattr("motionlang.source.LARGEST", 100_000)
    path = tmp_path / "long.mnt"
    path.write_bytes(b"'" * 100_000)
    assert len(Source.read(path).text) == 100_000
    path.write_bytes(b"'" * 100_001)
    with pytest.raises(OSError, match="File too large"):
        Source.read(path)


@pytest.mark.parametrize("data", [b"\0\0\0\0", b"\x7fELF\2\1\0\0\3", b"x = 1\0\ny = 2\n"])
def test_a_file_that_is_no_text_is_refused(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "program.mnt"
    path.write_bytes(data)
    with pytest.raises(OSError, match="not a text file"):
        Source.read(path)


def test_padding_of_a_disk_block_is_no_text(tmp_path: Path) -> None:
    path = tmp_path / "old.prg"
    path.write_bytes(b"x = 1\r\n\x1a" + bytes(120))
    assert Source.read(path).text == "x = 1\n "
