"""docs/commands has a page for each command, with all options of its class."""

from __future__ import annotations

import re

from tests.extras import MISSING
from tools.command_pages import pages, parsers


def test_each_command_has_a_page_with_its_options() -> None:
    texts = {each.stem: each.read_text("utf-8") for each in pages()}
    with_options = [each for each in parsers() if each.split()[0] not in MISSING]
    commands = dict.fromkeys(each.split()[0] for each in with_options)
    assert texts.keys() - {"README"} == commands.keys()
    found = [
        name for command in commands for name in re.findall(r"<!-- options: ([\w ]+) -->", texts[command])
    ]
    assert found == with_options


def test_the_text_names_only_options_that_exist() -> None:
    options = {
        word for each in parsers().values() for action in each._actions for word in action.option_strings
    } | {"--version"}
    for page in pages():
        shown = re.sub(r"^```.*?^```$", "", page.read_text("utf-8"), flags=re.MULTILINE | re.DOTALL)
        assert set(re.findall(r"`(--[a-z-]+)", shown)) <= options, page
