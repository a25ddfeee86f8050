"""docs/commands has a page for each command, with all options of its class."""

from __future__ import annotations

import re

import pytest

from motionlang.cli.commands import COMMANDS
from tests.command_pages import FOLDER, pages, parsers, written


@pytest.mark.parametrize("page", pages(), ids=lambda each: each.stem)
def test_the_tables_are_those_of_the_classes(page: object) -> None:
    """If this fails, run `python -m tests.command_pages`."""
    text = page.read_text(encoding="utf-8")  # type: ignore[attr-defined]
    assert written(text) == text


def test_each_command_has_a_page_with_its_options() -> None:
    assert {each.stem for each in pages()} - {"README"} == set(COMMANDS)
    found = [
        name
        for command in COMMANDS
        for name in re.findall(r"<!-- options: ([\w ]+) -->", (FOLDER / f"{command}.md").read_text("utf-8"))
    ]
    assert found == list(parsers())


def test_the_text_names_only_options_that_exist() -> None:
    options = {
        word for each in parsers().values() for action in each._actions for word in action.option_strings
    } | {"--version"}
    for page in pages():
        shown = re.sub(r"^```.*?^```$", "", page.read_text("utf-8"), flags=re.MULTILINE | re.DOTALL)
        assert set(re.findall(r"`(--[a-z-]+)", shown)) <= options, page
