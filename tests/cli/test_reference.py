"""docs/cli.md lists all commands and all options of the parsers."""

from __future__ import annotations

import re

from motionlang.cli.commands import COMMANDS
from tests.cli_page import OF_RUN, PAGE, parsers, written

TEXT = PAGE.read_text(encoding="utf-8")


def test_the_tables_are_those_of_the_parsers() -> None:
    """If this fails, run `python -m tests.cli_page`."""
    assert written(TEXT) == TEXT


def test_each_command_has_a_section_with_its_options() -> None:
    commands = [name for name in COMMANDS if name not in OF_RUN]
    assert re.findall(r"^## (\w+)$", TEXT, re.MULTILINE)[-len(commands) :] == commands
    assert re.findall(r"^<!-- options: ([\w ]+) -->$", TEXT, re.MULTILINE) == list(parsers())


def test_the_text_names_only_options_that_exist() -> None:
    options = {
        word for each in parsers().values() for action in each._actions for word in action.option_strings
    } | {"--version"}
    shown = re.sub(r"^```.*?^```$|<!-- old options.*?<!-- end -->", "", TEXT, flags=re.MULTILINE | re.DOTALL)
    assert set(re.findall(r"`(--[a-z-]+)", shown)) <= options
