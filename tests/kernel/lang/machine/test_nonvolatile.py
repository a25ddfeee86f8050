"""The file of nonvolatile data at the bounds of what it may hold."""

from __future__ import annotations

import json
from math import inf, nan
from pathlib import Path

import pytest

from motionlang.kernel.lang.machine.nonvolatile import SCHEMA, NonVolatile


def opened(folder: Path, **tree: object) -> NonVolatile:
    """Return the data of a file with this tree, unlocked."""
    path = folder / "nv.json"
    path.write_text(json.dumps({"schema": SCHEMA, **tree}), encoding="utf-8")
    made = NonVolatile(str(path))
    made.close()
    return made


def test_words_have_addresses_up_to_1023_and_32_bits(tmp_path: Path) -> None:
    words = {
        "0": 5, "1023": -2147483648, "7": 2147483647, "1024": 1, "-1": 1, "8": 2147483648, "9": -2147483649,
        "10": 1.5, "011": 3, "x": 4,
    }  # fmt: skip
    found = opened(tmp_path, words=words)
    shown = [found.word(address) for address in (0, 1023, 7, 1024, 8, 9, 10, 11)]
    assert shown == [5, -2147483648, 2147483647, 0, 0, 0, 0, 0]
    assert found.names == ["NVLONG"]
    assert opened(tmp_path, words={}).names == []


@pytest.mark.parametrize(
    ("value", "word", "read"),
    [
        (1.0, 0x3F800000, 1.0),
        (-2.0, -0x40000000, -2.0),
        (0.0, 0, 0.0),
        (3.4028234663852886e38, 0x7F7FFFFF, 3.4028234663852886e38),
        (3.4028235677973366e38, 0x7F800000, inf),
        (1e39, 0x7F800000, inf),
        (-1e39, -0x800000, -inf),
    ],
)
def test_a_float_is_a_word_of_its_bits(value: float, word: int, read: float) -> None:
    """The bits are those of IEEE 754; beyond the largest number is infinity."""
    nonvolatile = NonVolatile()
    nonvolatile.set_real(3, value)
    assert (nonvolatile.word(3), nonvolatile.real(3)) == (word, read)


def test_what_is_no_number_stays_none() -> None:
    nonvolatile = NonVolatile()
    nonvolatile.set_real(3, nan)
    assert nonvolatile.real(3) != nonvolatile.real(3)


@pytest.mark.parametrize(
    ("stored", "variable", "restored"),
    [
        ([5], [0], [5]),
        ([2147483647], [0], [2147483647]),
        ([2147483648], [0], [0]),
        ([-2147483648], [0], [-2147483648]),
        ([-2147483649], [0], [0]),
        ([1.5], [0], [0]),
        ([True], [0], [0]),
        (["a"], [0], [0]),
        ([5], [0.0], [5.0]),
        ([True], [0.0], [0.0]),
        ([5], [""], [""]),
        (["a"], [""], ["a"]),
        ([1, 2], [0], [0]),
        ([1, 2], [0, 0], [1, 2]),
        ([1, "a"], [0, 0], [0, 0]),
        ([None, 2], [None, 0], [None, 2]),
        ([[1, 2], 3], [[0, 0], 0], [[1, 2], 3]),
        ([[1], 3], [[0, 0], 0], [[0, 0], 0]),
        (5, [0], [0]),
    ],
)
def test_a_stored_value_is_restored_if_it_fits(
    stored: object, variable: list[object], restored: list[object], tmp_path: Path
) -> None:
    """Its kind, its size and its range must be those of the variable."""
    found = opened(tmp_path, values={"v": stored})
    present = list(variable)
    found.restore("v", present)
    assert (present, [type(each) for each in present]) == (restored, [type(each) for each in restored])
    assert found.names == ["v"]


def test_a_variable_goes_on_with_the_live_value_of_its_name(tmp_path: Path) -> None:
    found = opened(tmp_path, values={"v": [5]})
    first: list[object] = [0]
    found.restore("v", first)
    first[0] = 7
    second: list[object] = [0]
    found.restore("v", second)
    assert second == [7]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[]", "it is not an nv file"),
        ('{"schema": "other"}', "it is not an nv file"),
        (json.dumps({"schema": SCHEMA, "values": []}), "its values and its words must be objects"),
        (json.dumps({"schema": SCHEMA, "words": []}), "its values and its words must be objects"),
    ],
)
def test_a_file_that_is_none_is_refused(text: str, message: str, tmp_path: Path) -> None:
    path = tmp_path / "nv.json"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=message):
        NonVolatile(str(path))


def test_what_is_saved_is_read_again(tmp_path: Path) -> None:
    found = opened(tmp_path, values={"v": [5], "other": [1]}, words={"4": 9})
    variable: list[object] = [0]
    found.restore("v", variable)
    variable[0] = 6
    found.set_word(1, 8)
    found.save()
    tree = json.loads((tmp_path / "nv.json").read_text(encoding="utf-8"))
    assert tree == {"schema": SCHEMA, "values": {"other": [1], "v": [6]}, "words": {"1": 8, "4": 9}}
