"""The options for the format of findings, shared by `check` and `verify`."""

from __future__ import annotations

import argparse

from motionlang.cli.format_options import add_format
from motionlang.views.findings import FORMATS


def add_form(parser: argparse.ArgumentParser, quiet: str) -> None:
    """Add --format, -o and -q; `quiet` is the help text of -q."""
    add_format(parser, FORMATS)
    parser.add_argument("-q", "--quiet", action="store_true", help=quiet)
