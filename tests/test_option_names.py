"""Messages name only options that exist; everywhere else an option is a field of its class."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import motionlang
from tests.trees import nodes_of
from tools.command_pages import parsers

PACKAGE = Path(motionlang.__file__).parent
# Of argparse, of a linker and of another library's script.
OTHERS = {"--version", "--no", "--kill-at", "--config"}
_OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*[a-z]")


def texts() -> Iterator[tuple[Path, int, str]]:
    """Yield the texts of the package, with file and line."""
    for path in sorted(PACKAGE.rglob("*.py")):
        documented = {id(node.value) for node in nodes_of(path) if isinstance(node, ast.Expr)}
        for node in nodes_of(path):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in documented:
                yield path, node.lineno, node.value


@pytest.mark.usefixtures("package_trees")
def test_messages_name_only_options_that_exist() -> None:
    known = {
        word for each in parsers().values() for action in each._actions for word in action.option_strings
    }
    found = {
        f"{path.relative_to(PACKAGE)}:{line}: {option}"
        for path, line, text in texts()
        for option in _OPTION.findall(text)
        if option not in known and option not in OTHERS
    }
    assert found == set()
