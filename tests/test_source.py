"""Any file content becomes text, in the encodings of editors or in no encoding."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.kernel import MAX_BYTES, Source, name_of

TEXT = 'Print "é"\nPrint 2\n'


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "latin-1"])
@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"])
def test_an_encoding_is_recognised(encoding: str, line_end: str) -> None:
    data = TEXT.replace("\n", line_end).encode(encoding)
    assert Source.from_bytes("x.mnt", data).text == TEXT


def test_a_mark_decides() -> None:
    assert Source.from_bytes("x.mnt", b"\xfe\xff" + TEXT.encode("utf-16-be")).text == TEXT
    assert Source.from_bytes("x.mnt", b"\xff\xfea\0b").text == "a\ufffd"


# Bytes with a quarter of NULs in one half, with fewer, and with NULs in both halves.
@pytest.mark.parametrize(
    ("data", "text"),
    [
        (b"a\0b\0cdef", "ab\u6463\u6665"),
        (b"\0a\0bcdef", "ab\u6364\u6566"),
        (b"a\0bcdefg", "a\0bcdefg"),
        (b"a\0b\0cdefgh", "a\0b\0cdefgh"),
        (b"a\0b\0\0def", "a\0b\0\0def"),
    ],
)
def test_a_quarter_of_nuls_makes_a_wide_text(data: bytes, text: str) -> None:
    assert Source.from_bytes("x.mnt", data).text == text


@pytest.mark.parametrize("data", [b"", b"\0\0\0\0", b"a\0", b"ab\0\0cd", b"x = 1\0\0"])
def test_bytes_that_are_no_wide_text_stay_bytes(data: bytes) -> None:
    wide = data == b"a\0"
    assert Source.from_bytes("x.mnt", data).text == ("a" if wide else data.decode())


def test_a_file_without_an_end_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Examples are /dev/zero, and a pipe whose writer never closes it."""
    monkeypatch.setattr("motionlang.kernel.source.MAX_BYTES", 100_000)
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
    with pytest.raises(OSError, match="not a text file: line"):
        Source.read(path)


@pytest.mark.parametrize("data", [b"", TEXT.encode("utf-16"), TEXT.encode("utf-16-be"), TEXT.encode()])
def test_a_file_is_read_in_its_encoding(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "program.mnt"
    path.write_bytes(data)
    source = Source.read(path)
    assert (source.name, source.text) == ("program.mnt", TEXT if data else "")


def test_padding_of_a_disk_block_is_no_text(tmp_path: Path) -> None:
    path = tmp_path / "old.prg"
    path.write_bytes(b"x = 1\r\n\x1a" + bytes(120))
    assert Source.read(path).text == "x = 1\n"


def test_blanks_replace_form_feeds_outside_strings_and_a_mark_ends_the_text() -> None:
    assert Source("x.mnt", 'x\f = "a\f\x1a"\r\n\f"\x1aold\r\n').text == 'x  = "a\f\x1a"\n "'
    assert Source("x.mnt", "\x1aold").text == ""


def test_every_offset_has_its_line_and_column() -> None:
    source = Source("x.mnt", "\nab\n\nx")
    assert [source.line(number) for number in range(-1, 6)] == ["", "", "", "ab", "", "x", ""]
    assert [source.location(offset) for offset in range(7)] == [
        (1, 1), (2, 1), (2, 2), (2, 3), (3, 1), (4, 1), (4, 2),
    ]  # fmt: skip
    assert Source("x.mnt", "").location(0) == (1, 1)


def test_the_name_of_a_program_has_no_folder() -> None:
    assert (name_of("a/b.mnt"), name_of("-")) == ("b.mnt", "<stdin>")


def test_the_largest_file_has_64_megabytes() -> None:
    assert MAX_BYTES == 64 * 1024**2
