"""Writer of the syntax highlighting of the VS Code extension.

A TextMate grammar has one pattern for each kind of keyword in the tables. `views/highlight.py` names the
kinds.
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

from motionlang.kernel.lang.dialect import dialect
from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.syntax.tokens import SPELLINGS

FOLDER = Path(__file__).parent.parent / "editors" / "vscode" / "syntaxes"
# The scope of each kind of word.
SCOPES = {
    "control": "keyword.control",
    "move": "entity.name.function",
    "keyword": "support.function",
    "constant": "constant.language",
    "not-simulated": "invalid.deprecated",
}
# A number in decimal.
DECIMAL = r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"


def kind_of(row: Keyword) -> str:
    """Return the kind of a keyword: move, constant, keyword or not-simulated."""
    if not row.simulated:
        return "not-simulated"
    return row.kind if row.kind in ("move", "constant") else "keyword"


def words(language: str) -> dict[str, list[str]]:
    """Return the names and short forms of a language's keywords by kind, sorted."""
    found: dict[str, set[str]] = {}
    for row in dialect(language).table():
        found.setdefault(kind_of(row), set()).update(filter(None, (row.name, row.short)))
    return {kind: sorted(found[kind], key=str.lower) for kind in SCOPES if kind in found}


def control() -> list[str]:
    """Return the control-flow keywords of Mint."""
    return sorted({text for text in SPELLINGS.values() if re.fullmatch(r"[A-Za-z]+", text)})


def choice(names: list[str]) -> str:
    """Return a regular expression that matches any of the names."""
    return "|".join(map(re.escape, names))


def mint() -> dict[str, Any]:
    """Return the grammar of Mint."""
    patterns = [
        {"name": "comment.line.apostrophe.mint", "match": "'.*$"},
        {"name": "comment.line.rem.mint", "match": r"(?<![\w.])(?:[Rr][Ee][Mm]\b|REM(?=[A-Z][a-z])).*$"},
        {
            "name": "string.quoted.double.mint",
            "begin": '"',
            "end": '"|$',
            "patterns": [{"name": "constant.character.escape.mint", "match": r"\\."}],
        },
        {"name": "string.quoted.other.mint", "match": r"`(?:[^`\\]|\\.)`"},
        {"name": "entity.name.label.mint", "match": r"(?<=^|[\s:])#[A-Za-z_]\w*"},
        {
            "name": "constant.numeric.mint",
            "match": rf"(?<![\w.])(?:0[xX][0-9a-fA-F]+|0[bB][01]+|{DECIMAL})(?!\w)",
        },
        {"name": f"{SCOPES['control']}.mint", "match": rf"(?i)(?<![\w.])(?:{choice(control())})(?!\w)"},
        *(
            {"name": f"{SCOPES[kind]}.mint", "match": rf"(?i)(?<![\w.])(?:{choice(names)})(?!\w)"}
            for kind, names in words("mint").items()
        ),
        {"name": "keyword.operator.mint", "match": r"<>|<=|>=|<<|>>|[-+*/\\^=<>&|~]"},
    ]
    return {"name": "Mint", "scopeName": "source.mint", "fileTypes": suffixes("mint"), "patterns": patterns}


def mccl() -> dict[str, Any]:
    """Return the grammar of MCCL: a command is an axis, two letters and a parameter."""
    patterns = [
        {"name": "comment.line.semicolon.mccl", "match": ";.*$"},
        {"name": "comment.line.number-sign.mccl", "match": r"^[ \t]*#.*$"},
        {"name": "string.quoted.double.mccl", "begin": '"', "end": '"|$'},
        {"name": "variable.other.register.mccl", "match": r"@\d+"},
        *(
            {
                "match": rf"(?i)(?<=^|[,;\s])(\d*)({choice(names)})(?=[-+.@\"\d,;\s]|$)",
                "captures": {
                    "1": {"name": "constant.numeric.axis.mccl"},
                    "2": {"name": f"{SCOPES[kind]}.mccl"},
                },
            }
            for kind, names in words("mccl").items()
        ),
        {"name": "constant.numeric.mccl", "match": rf"[-+]?(?:{DECIMAL})"},
    ]
    return {"name": "MCCL", "scopeName": "source.mccl", "fileTypes": suffixes("mccl"), "patterns": patterns}


def suffixes(language: str) -> list[str]:
    """Return the file extensions of a language, without the dot."""
    return [suffix.removeprefix(".") for suffix in dialect(language).suffixes]


def files() -> dict[Path, str]:
    return {
        FOLDER / f"{name}.tmLanguage.json": json.dumps(grammar, indent=1, ensure_ascii=False) + "\n"
        for name, grammar in (("mint", mint()), ("mccl", mccl()))
    }
