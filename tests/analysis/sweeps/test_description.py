"""Numbers in the description of a sweep: the number of samples, and their seed."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.analysis.sweeps.description import read_description
from motionlang.errors import ProgramError


@pytest.mark.parametrize(
    ("line", "taken"),
    [
        ("random = 8", True), ("latin = 1", True), ("random = 0", False), ("latin = -1", False),
        ("seed = 0", True), ("seed = -3", True), ("seed = true", False), ("seed = 1.5", False),
    ],
)  # fmt: skip
def test_at_least_one_variant_is_drawn_and_any_whole_number_is_a_seed(
    line: str, taken: bool, tmp_path: Path
) -> None:
    file = tmp_path / "a.sweep.toml"
    file.write_text(line + "\n", encoding="utf-8")
    if taken:
        key, _, value = line.partition(" = ")
        assert getattr(read_description(str(file)), key) == int(value)
    else:
        with pytest.raises(ProgramError):
            read_description(str(file))
