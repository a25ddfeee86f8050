"""The form of findings: options that `check` and `verify` share."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.views.findings import FORMATS

if TYPE_CHECKING:
    import argparse


def add_form(parser: argparse.ArgumentParser) -> None:
    """Add --format and --json."""
    parser.add_argument(
        "--format",
        choices=FORMATS,
        default="text",
        help="what is printed: text; one document for another tool, as JSON, SARIF or JUnit's XML; or the commands by "
        "which GitHub marks the lines",
    )
    parser.add_argument(
        "--json", action="store_const", dest="format", const="json", help="the same as --format json"
    )
