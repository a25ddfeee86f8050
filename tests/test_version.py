"""The files that repeat the version agree with `motionlang.__version__`, from which the build takes it."""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path

import pytest

from motionlang import __version__
from motionlang.extras import COMMANDS as EXTRAS

ROOT = Path(__file__).parent.parent


# The version of a distribution in extras, and the one that it needs.
PINS = (r"^version = \"(\S+)\"$", r"\"motionlang == (\S+)\"")


def text_of(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def test_the_build_takes_the_version_of_the_package() -> None:
    project = tomllib.loads(text_of("pyproject.toml"))
    assert "version" not in project["project"]
    assert project["tool"]["setuptools"]["dynamic"] == {
        "version": {"attr": "motionlang.kernel.version.__version__"}
    }


def test_the_extension_has_the_version_of_the_package() -> None:
    assert json.loads(text_of("editors/vscode/package.json"))["version"] == __version__


@pytest.mark.parametrize(
    ("name", "pattern"),
    [
        ("CITATION.cff", r"^version: (\S+)$"),
        ("CHANGELOG.md", r"^## (\S+)$"),  # the first section is of the version to be released
        ("docs/contributing/commands.md", r"\"motionlang == (\S+)\""),
        *((f"extras/{name}/pyproject.toml", pattern) for name in EXTRAS for pattern in PINS),
        ("docs/sweep.md", r"motionlang:(\d[\d.]+)\""),
    ],
)
def test_a_file_that_names_the_version_names_the_present_one(name: str, pattern: str) -> None:
    found = re.search(pattern, text_of(name), re.MULTILINE)
    assert found is not None
    assert found[1] == __version__
