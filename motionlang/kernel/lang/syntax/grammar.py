"""Lark's parser of a grammar, made once in a process.

Computing the table of a grammar takes half a second, so a table is stored. The wheel has those for the versions of
Lark and Python that built it. Without a fitting one, Lark keeps its table in the user's cache folder.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from functools import cache
from hashlib import sha256
from io import BytesIO
from pkgutil import get_data
from typing import Any

import lark
from lark import Lark, Transformer

from motionlang.kernel.cache import path_of
from motionlang.kernel.files import replacing

BAD = "BAD"  # the kind of a token that fits no terminal of the language
SUFFIX = ".table"
PYTHON = f"{sys.version_info[0]}.{sys.version_info[1]}"
END = "$END"  # Lark's name for the end of the text
# The grammars: inside an installed package, or next to it in a checkout.
_PACKAGE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
GRAMMARS = os.path.join(_PACKAGE, "grammars")
if not os.path.isdir(GRAMMARS):
    GRAMMARS = os.path.join(os.path.dirname(_PACKAGE), "grammars")


class Token(lark.Token):
    """A token of a text, which has its position; Lark's may have none."""

    start_pos: int
    end_pos: int


class Terminals:
    """Keep the terminals that no rule uses, so that every text has tokens."""

    always_accept = (BAD,)

    def process(self, stream: Iterator[Token]) -> Iterator[Token]:
        """Pass the tokens on as they are."""
        return stream


class Imports:
    """Finds the grammars that a grammar imports."""

    def __call__(self, _base: object, path: str) -> tuple[str, str]:
        """Return the path and the text of a grammar, as Lark asks for them."""
        return path, text_of(path.removesuffix(".lark"))

    def __repr__(self) -> str:
        return "grammars"  # Lark compares the options of a cached table as texts


def build(name: str, builder: Transformer[lark.Token, Any] | None, **options: object) -> Lark:
    """Build the parser of a grammar; its tokens are all passed to the builder."""
    settings: dict[str, object] = {
        "parser": "lalr",
        "lexer": "basic",
        "g_regex_flags": re.ASCII,
        "import_paths": [Imports()],
        "keep_all_tokens": True,
        "maybe_placeholders": True,
        "postlex": Terminals(),
        "transformer": builder,
    }
    return Lark(text_of(name), **{**settings, **options})


def load(name: str, builder: Transformer[lark.Token, Any], **options: object) -> Lark:
    """Return the parser of a grammar, from a stored table if one fits; the options are those of `build`."""
    table = table_name(name)
    try:
        return Lark.load(BytesIO(_read(table)))
    except OSError:
        return build(name, builder, cache=path_of(table) or False, **options)


def lex(parser: Lark, text: str) -> Iterator[Token]:
    """Yield the tokens of a text, by the lexer that the parser uses."""
    tokens: Iterator[Token] = parser.parse_interactive(text).lexer_thread.lex(None)  # type: ignore[no-untyped-call]
    return tokens


def store(
    name: str, builder: Transformer[lark.Token, Any], target: str, python: str = PYTHON, **options: object
) -> None:
    """Write the table of a grammar into a folder, for a version of Python, unless it is there."""
    table = table_name(name, python)
    if not os.path.exists(os.path.join(target, table)):
        with replacing(os.path.join(target, table)) as file:
            build(name, builder, **options).save(file, exclude_options=("import_paths",))


@cache
def text_of(name: str) -> str:
    """Return the text of a grammar."""
    return _read(f"{name}.lark").decode()


def _read(name: str) -> bytes:
    """Return the content of a file next to the grammars, in the folder or in an archive."""
    if os.path.isdir(GRAMMARS):
        with open(os.path.join(GRAMMARS, name), "rb") as file:
            return file.read()
    data = get_data("motionlang", f"grammars/{name}")
    assert data is not None
    return data


def table_name(name: str, python: str = PYTHON) -> str:
    """Return the name of the file of a table: it changes with all that the table depends on."""
    keeper = f"{Terminals.__module__}.{Terminals.__qualname__}"  # a table names its class
    parts = lark.__version__, python, keeper, text_of("common"), text_of(name)
    digest = sha256("\0".join(parts).encode()).hexdigest()
    return f"{name}-{digest[:16]}{SUFFIX}"
