"""Messages name only options that exist; everywhere else an option is a field of its class."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import motionlang
from tests.extras import ABSENT
from tests.trees import nodes_of
from tools.command_pages import parsers

PACKAGE = Path(motionlang.__file__).parent
# Of argparse, of a linker and of another library's script.
OTHERS = {"--version", "--no", "--kill-at", "--config"}
# Options of the commands of a distribution that messages of the package name.
OF_EXTRAS = {"explore": {"--new"}, "mcapi": {"--port"}}
_OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*[a-z]")


def texts(package: Path) -> Iterator[tuple[Path, int, str]]:
    """Yield the texts of a package, with file and line."""
    for path in sorted(package.rglob("*.py")):
        documented = {id(node.value) for node in nodes_of(path) if isinstance(node, ast.Expr)}
        for node in nodes_of(path):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in documented:
                yield path, node.lineno, node.value


def unknown_options(package: Path) -> set[str]:
    """Return the options in texts of a package that no command has, with file and line."""
    known = OTHERS.union(*(OF_EXTRAS.get(name, ()) for name in ABSENT))
    for each in parsers().values():
        known.update(word for action in each._actions for word in action.option_strings)
    return {
        f"{path.relative_to(package)}:{line}: {option}"
        for path, line, text in texts(package)
        for option in _OPTION.findall(text)
        if option not in known
    }


@pytest.mark.usefixtures("package_trees")
def test_messages_name_only_options_that_exist() -> None:
    assert unknown_options(PACKAGE) == set()
