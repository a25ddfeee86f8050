"""The VS Code extension agrees with the languages and with the server."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from motionlang.kernel import dialect, dialects
from tools import vscode_grammars

FOLDER = Path(__file__).parent.parent / "editors" / "vscode"
PACKAGE: dict[str, Any] = json.loads((FOLDER / "package.json").read_text(encoding="utf-8"))


def test_each_language_has_its_files() -> None:
    known = {each["id"]: tuple(each["extensions"]) for each in PACKAGE["contributes"]["languages"]}
    assert known == {name: dialect(name).suffixes for name in dialects()}


def test_each_language_comments_with_its_sign() -> None:
    for name in dialects():
        settings = json.loads((FOLDER / "language" / f"{name}.json").read_text(encoding="utf-8"))
        assert settings["comments"]["lineComment"] == dialect(name).comment


def test_the_extension_has_the_commands_of_the_lenses() -> None:
    features = pytest.importorskip("motionlang_lsp.features", reason="motionlang-lsp is not installed")
    commands = {each["command"] for each in PACKAGE["contributes"]["commands"]}
    assert set(features.LENSES) <= commands
    code = (FOLDER / "src" / "extension.ts").read_text(encoding="utf-8")
    assert set(re.findall(r'\bon\("([\w.]+)"', code)) == commands


def test_a_keyword_of_v4_is_found_before_its_dot() -> None:
    patterns = {each["name"]: each.get("match", "") for each in vscode_grammars.mint()["patterns"]}
    settings = patterns["support.function.mint"]
    assert re.search(settings, "speed.0 = 3") is not None
    assert re.search(settings, "my.SPEED = 3") is None
    assert re.search(settings, "SPEEDY = 3") is None
    assert re.search(patterns["keyword.control.mint"], "EndIf") is not None
