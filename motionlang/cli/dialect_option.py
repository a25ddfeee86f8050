"""The option for the language of a program; importing it loads no machine."""

from __future__ import annotations

import argparse

from motionlang.lang.dialect import dialects


def add_dialect(
    parser: argparse.ArgumentParser, what: str = "the language; default: by file extension"
) -> None:
    parser.add_argument("--dialect", "--lang", choices=dialects(), help=what)
