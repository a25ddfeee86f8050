"""The file next to a program with the options of its sweep: each key is read as the option is."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.commands.sweep.space import Dimension, Drawn, Grid
from motionlang.commands.sweep.variants import Variants
from motionlang.kernel import ProgramError


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
        assert getattr(Variants.of_file(str(file)), key) == int(value)
    else:
        with pytest.raises(ProgramError):
            Variants.of_file(str(file))


@pytest.mark.parametrize(
    ("line", "name", "value"),
    [
        ("until = 0", "until", 0.0),
        ("until = 2.5", "until", 2.5),
        ("until = -1", None, "until: '-1' is not a time in seconds"),
        ("until = true", None, "until: 'true' is not a time"),
        ("until = 1e999", None, "until: 'inf' is not a time"),
        ('until = "1"', "until", 1.0),
        ("prove = true", "prove", True),
        ("prove = 1", None, "prove: true or false, not 1"),
        ('keep = ["time", "peak.0"]', "keep", ("time", "peak.0")),
        ('keep = "time"', "keep", ("time",)),
        ("keep = [1]", None, "keep: "),
        ("vary = 1", None, "vary: '1' is not NAME="),
        ("[vary]\nn = []", None, "vary: 'n=' is not NAME="),
        ("untill = 1", None, "there is no key untill; did you mean until?"),
    ],
)
def test_a_key_of_a_description(line: str, name: str | None, value: object, tmp_path: Path) -> None:
    file = tmp_path / "a.sweep.toml"
    file.write_text(f"\n{line}\n", encoding="utf-8")
    if name is not None:
        assert getattr(Variants.of_file(str(file)), name) == value
    else:
        with pytest.raises(ProgramError) as caught:
            Variants.of_file(str(file))
        (found,) = caught.value.diagnostics
        assert found.message.startswith(str(value))
        assert (found.line, found.column) == (2, 1)


def test_varied_names_may_be_tables(tmp_path: Path) -> None:
    """A text in a list is read as on the command line; a single number is one value."""
    file = tmp_path / "a.sweep.toml"
    file.write_text('[vary]\nSPEED = "1:3:3"\naxis.0.gain = [1, "2"]\nn = 7\nb = true\n', encoding="utf-8")
    found = [(each.name, [each[k] for k in range(len(each))]) for each in Variants.of_file(str(file)).vary]
    assert found == [("SPEED", [1, 2, 3]), ("axis.0.gain", [1, 2]), ("n", [7]), ("b", [True])]


def test_folders_are_next_to_the_description_and_a_condition_is_none(tmp_path: Path) -> None:
    file = tmp_path / "a.sweep.toml"
    file.write_text('machines = "m"\nscenarios = "s"\nwhere = "time < 5"\n', encoding="utf-8")
    found = Variants.of_file(str(file))
    assert found.machines == str(tmp_path / "m")
    assert found.scenarios == str(tmp_path / "s")
    assert found.where is not None
    assert found.where.text == "time < 5"


ONE, TWO = Dimension("n", [1, 2, 3]), Dimension("m", [4.0, 5.0])


@pytest.mark.parametrize(
    ("given", "kind", "count"),
    [
        ({}, Grid, 6),
        ({"random": 4}, Drawn, 4),
        ({"latin": 5}, Drawn, 5),
        ({"random": 4, "seed": 9}, Drawn, 4),
    ],
)
def test_the_variants_of_a_description(given: dict[str, int], kind: type, count: int) -> None:
    variants = Variants()
    variants.vary = [ONE, TWO]
    for name, value in given.items():
        setattr(variants, name, value)
    found = variants.space({})
    assert (type(found), len(found)) == (kind, count)
    assert len(variants.space({"machine": {"a": {}, "b": {}}})) == (2 * count if kind is Grid else count)


def test_a_description_needs_something_to_vary_and_one_kind_of_sample() -> None:
    variants = Variants()
    with pytest.raises(ValueError, match="nothing to vary: give --vary NAME=FIRST:LAST:COUNT"):
        variants.space({})
    assert len(variants.space({"scenario": {"a": {}, "b": {}, "c": {}}})) == 3
    variants.vary, variants.random, variants.latin = [ONE], 3, 3
    with pytest.raises(ValueError, match="use either a random or a Latin hypercube sample, not both"):
        variants.space({})


def test_an_option_of_the_command_line_replaces_what_the_file_says_about_the_same(tmp_path: Path) -> None:
    file = tmp_path / "a.sweep.toml"
    file.write_text('keep = "peak.0"\nlatin = 5\nminimise = "time"\n[vary]\nn = [1, 2]\n', encoding="utf-8")
    given = Variants(vary=[TWO], random=4)
    given.read_file(str(file))
    assert (given.vary, given.random, given.latin, given.keep) == ([TWO], 4, None, ("peak.0",))
