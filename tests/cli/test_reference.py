"""docs/cli.md lists every command, and for each its exact options."""

from __future__ import annotations

import argparse
import re
from pathlib import Path

import pytest

from motionlang.cli.commands import build_parser

PAGE = (Path(__file__).parents[2] / "docs" / "cli.md").read_text(encoding="utf-8")
COMMANDS = {
    name: parser
    for action in build_parser("*")._actions
    if isinstance(action, argparse._SubParsersAction)
    for name, parser in action.choices.items()
}
# The others have pages of their own.
EXPLAINED_HERE = re.findall(r"^\| \[`(\w+)`\]\(#\w+\)", PAGE, re.MULTILINE)


def test_every_command_is_in_the_table() -> None:
    table = PAGE.split("\n\n")[2]
    named = re.findall(r"^\| \[?`(\w+)`", table, re.MULTILINE)
    assert named == list(COMMANDS)


@pytest.mark.parametrize("name", EXPLAINED_HERE)
def test_every_option_is_explained(name: str) -> None:
    section = re.split(r"^## ", PAGE, flags=re.MULTILINE)
    (own,) = [text for text in section if text.startswith(f"{name}\n")]
    prose = re.sub(r"^```.*?^```$", "", own, flags=re.MULTILINE | re.DOTALL)
    explained = set(re.findall(r"--[a-z][a-z-]+", prose))
    options = {
        word for action in COMMANDS[name]._actions for word in action.option_strings if word[:2] == "--"
    }
    assert explained == options - {"--help"}
