"""The scripts in `tests/lab/notes/scripts/` print what the documents print."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.lab.notes.examples import PRINTING, ROOT, SCRIPTS, printed


@pytest.mark.parametrize("name", PRINTING)
def test_an_example_prints_its_golden_text(name: str, request: pytest.FixtureRequest) -> None:
    golden, text = Path(__file__).with_name("printed") / f"{name}.txt", printed(name)
    if request.config.getoption("--update"):
        golden.write_text(text, encoding="utf-8", newline="\n")
    assert text == golden.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "words", [("chapter12_drawn", "12.6"), ("chapter12_drawn", "12.11"), ("tn1069",), ("listing",), ("dac",)]
)
def test_an_example_draws_its_figure(words: tuple[str, ...], monkeypatch: pytest.MonkeyPatch) -> None:
    """The figure is complete when it is saved; rendering it would take longer than drawing it."""
    figure = pytest.importorskip("matplotlib.figure").Figure
    saved: list[object] = []
    monkeypatch.setattr(figure, "savefig", lambda figure, path: saved.append(path))
    printed(*words, "x.svg")
    assert saved == ["x.svg"]


@pytest.mark.parametrize("page", ["sources.md", "servo.md tn1069.md an00115.md"])
def test_each_example_is_linked(page: str) -> None:
    text = "".join((ROOT / "docs" / name).read_text(encoding="utf-8") for name in page.split())
    linked = set(re.findall(r"\(\.\./tests/lab/notes/scripts/(\w+\.py)\)", text))
    assert linked == {script.name for script in SCRIPTS}
