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
        help=(
            "the output format: text; one document of JSON, SARIF or JUnit XML; or GitHub workflow "
            "commands, which annotate the lines"
        ),
    )
    parser.add_argument(
        "--json", action="store_const", dest="format", const="json", help="same as --format json"
    )
